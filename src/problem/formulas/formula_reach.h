// How far formulas and answers that no letter changed reach.
//
// A formula found on one side of a branch, or an answer that was the same at letters of ordinary sizes, may be another
// one where letters are far larger, negative or angles beyond a right angle.
#pragma once

#include "problem/formulas/formula_search.h"

namespace poinsot::problem {

// Solves the statement at letters far off: each alone up to 10^4 times larger and smaller, signs turned, angles in
// every quadrant. A formula that does not agree there is taken back; an answer without formula that is another one
// there depends on the letters; where a cord would push or a contact pull there, the solution assumes that it does not,
// with the formula of the force if it is among `forces`. For statements without unknowns and motions.
void hold_far_off(const FormulaTask& task, const std::vector<OneSidedForce>& forces, Solution& solution);

}  // namespace poinsot::problem
