// Finds the formulas of a solved statement and compares each with numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_task.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// The formula of an unknown.
struct UnknownFormula {
  std::string name;
  std::optional<std::size_t> situation;  // whose own it is; none if it is common to all
  Value<Formula> value;
};

// What is not negative where the formulas of the unknowns have a value, if a sign is that of it.
std::optional<Formula> inside_behind(const Formula& sign, const std::vector<UnknownFormula>& unknowns);

// What the formulas of a solution rest on, beside the signs of letters. The signs and bounds are positive at the values
// of the letters where the formulas were found.
struct FormulaGrounds {
  std::vector<OneSidedForce> forces;        // of what can only pull or push
  std::vector<std::vector<Formula>> signs;  // of each ask: what was decided on the way to its formula
  std::vector<Formula> bounds;              // of the ranges of unknowns
  std::vector<UnknownFormula> unknowns;
  Work work = 0;  // that it took to find them
};

// Adds to every ask of the solution that has numbers its formula, or the reason why it has none, and lists the
// unknowns that have formulas. Every formula is compared with the numbers at `settings` and at two random points of
// the letters, where the statement is solved again and checked with particles. An answer without exact formula may
// follow a law (law_search.h). The absence of a formula is never thrown.
FormulaGrounds find_formulas(const FormulaTask& task, Solution& solution);

}  // namespace poinsot::problem
