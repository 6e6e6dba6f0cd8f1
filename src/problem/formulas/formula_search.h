// Finds the formulas of a solved statement and compares each with numbers.
#pragma once

#include <vector>

#include "problem/formulas/formula_answers.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

struct FormulaTask {
  const Statement& statement;
  const std::vector<Letter>& open;  // letters without value
  const FormulaValues& given;       // values from outside the file, exactly
  const Settings& known;            // the same values as numbers
  const std::vector<Unknown>& unknowns;
  const AllSettings& settings;  // of each situation, with values for the open letters and for the unknowns of one root
  Sample& sample;               // the statement solved with these settings
  const std::vector<double>& natural;  // the natural size of each ask
};

// Adds to every ask of the solution that has numbers its formula, or the reason why it has none, and lists the
// unknowns that have formulas. Every formula is compared with the numbers at `settings` and at two random points of
// the letters, where the statement is solved again and checked with particles. An answer without exact formula may
// follow a law (law_search.h). The absence of a formula is never thrown. Returns the formulas of forces that can only
// pull or push in the instants solved on the way, if there are no unknowns.
std::vector<OneSidedForce> find_formulas(const FormulaTask& task, Solution& solution);

// Whether the check with particles confirms every instant of a sample that was solved.
bool confirmed_by_particles(Sample& sample);

}  // namespace poinsot::problem
