// Finds the formulas of a solved statement and holds each against numbers.
#pragma once

#include <vector>

#include "problem/formulas/formula_answers.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

struct FormulaTask {
  const Statement& statement;
  const std::vector<Letter>& open;  // letters without value
  const FormulaValues& given;       // what has a value from outside, exactly
  const Settings& known;            // the same in numbers
  const std::vector<Unknown>& unknowns;
  const AllSettings& settings;         // of each situation, with values for the open letters and the unknowns of a root
  Sample& sample;                      // solved at these
  const std::vector<double>& natural;  // the size that each ask naturally has
};

// Adds to every ask of the solution that has numbers its formula, or the reason why it has none; lists the unknowns
// that have formulas. Every formula is compared with the numbers at `settings` and at letters drawn at random twice,
// where the statement is solved anew and checked on particles. What has no exact formula may have a law
// (law_search.h). Never throws for a formula that cannot be had.
// Returns the formulas of what can only pull or push in the instants solved on the way, where there are no unknowns.
std::vector<OneSidedForce> find_formulas(const FormulaTask& task, Solution& solution);

// Whether the check on particles confirms every instant of a sample that was solved.
bool confirmed_by_particles(Sample& sample);

}  // namespace poinsot::problem
