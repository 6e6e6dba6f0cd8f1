// Claims: what is said to hold for all values of the letters, and of the motion as far as the statement leaves it open.
//
// A claim is proved by reduction: the sides of an equation differ by what vanishes identically, those of an inequality
// by what has one sign under the assumptions. What is not proved so is tried at random exact numbers; a claim that
// fails at one of them, in the solved statement too, is refuted.
#pragma once

#include "problem/formulas/formula_instant.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// settings: values of letters and data from outside and of unknowns, of each situation; exact: those that have one as
// formulas; unknowns: those that follow letters without value, of each situation; tell: also what a worked solution
// shows of a claim. Throws StatementError for claims that can never be right: unknown names, wrong dimensions, formulas
// of the data alone, assumptions that contradict each other.
std::vector<SolvedClaim> solve_claims(const Statement& statement, const std::vector<Settings>& settings,
                                      const FormulaValues& exact, const std::vector<FormulaValues>& unknowns,
                                      bool tell);

}  // namespace poinsot::problem
