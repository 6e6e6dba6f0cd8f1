// Claims: statements that are to hold for all values of the letters, and of the motion as far as the file leaves it
// open.
//
// A claim is proved by reduction: the difference of the sides of an equation vanishes identically, that of an
// inequality has one sign under the assumptions. A claim without proof is tried at random exact numbers. It is
// refuted if it fails at one of these points and the situation, solved by numbers there, confirms it.
#pragma once

#include "problem/formulas/formula_instant.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// For each situation, settings: the values of letters, data and unknowns; unknowns: formulas of the unknowns in
// letters without value. exact: those settings that have a formula. tell: whether to collect what a worked solution
// shows. Throws StatementError for claims that can never be right: unknown names, wrong dimensions, a comparison of
// data alone, assumptions that contradict each other.
std::vector<SolvedClaim> solve_claims(const Statement& statement, const std::vector<Settings>& settings,
                                      const FormulaValues& exact, const std::vector<FormulaValues>& unknowns,
                                      bool tell);

}  // namespace poinsot::problem
