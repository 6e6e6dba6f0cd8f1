// What an equation without unknown forces says of the data that are to be found: a polynomial with its roots, or the
// sine or cosine of an angle.
#pragma once

#include <string>
#include <vector>

#include "problem/explanation/explanation_tex.h"

namespace poinsot::problem {

// A datum that is to be found, with the value of this solution (SI).
struct FoundDatum {
  std::string name;
  Dimension dimension;
  double value = 0;
};

// A number behind which no letter stands.
inline Shown known_number(double value) { return {value, Formula(1)}; }

struct UnknownConditions {
  std::vector<Formula> conditions;         // each vanishes for this solution
  std::vector<FoundDatum> unknown;         // in the order of the statement
  std::vector<Formula> factors;            // that may be shared by all terms (shared_factors.h)
  std::vector<std::string> first_order;    // unknowns whose squares are neglected
  std::string from = "This is";            // the sentence that an equation follows from
  std::string from_several = "These are";  // the same of several equations
};

// The conditions, each without what its terms share and collected in the powers of the unknown that it leaves, and
// what follows for it. letters: the values of all letters, SI. What does not hold in numbers, or is too long to be
// read, is left out.
std::vector<ExplainedStep> condition_steps(const UnknownConditions& stated, const LetterValues& letters,
                                           const ExplanationTex& tex);

}  // namespace poinsot::problem
