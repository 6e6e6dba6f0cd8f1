// The motion near a steady one: the linearised equations, their characteristic polynomial, its roots.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/explanation/explanation_tex.h"
#include "problem/explanation/explanation_unknowns.h"
#include "problem/formulas/formula_instant.h"

namespace poinsot::problem {

struct NearSteady {
  const Situation& situation;
  SolvedInstant& numbers;
  FormulaInstant* formulas = nullptr;  // the same in formulas, if there are any
  const LetterValues& letters;         // of these, SI
  std::vector<Formula> factors;        // that may be shared by all terms (shared_factors.h)
  std::vector<Call> responses{};       // that are asked for
  std::optional<FoundDatum> limit{};   // the datum whose value here is the limit of stability
};

// The equation of the deviation for one freedom, the matrices and the characteristic polynomial for more; frequencies
// and rates of growth; at a limit what vanishes there. Formulas whose roots are not the rates found in numbers are not
// shown. Throws StatementError where the motion near this one is not known.
std::vector<ExplainedStep> near_steady_steps(const NearSteady& near, const ExplanationTex& tex);

}  // namespace poinsot::problem
