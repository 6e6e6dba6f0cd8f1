// Checks how far formulas hold, and answers that do not change with the letters.
//
// A formula may hold on one side of a branch only, and an answer may be constant only for ordinary values. So both
// are tried where letters are far larger or negative, and angles beyond a right angle.
#pragma once

#include "problem/formulas/formula_search.h"

namespace poinsot::problem {

// Solves the statement at letters far from their ordinary values: each alone up to 10^4 times larger and smaller,
// with reversed sign, with angles in every quadrant. A formula that does not agree there is withdrawn. An answer
// without formula that changes depends on the letters. If a cord would push or a contact pull, the solution assumes
// that it does not, and gives the formula of the force if it is among `forces`. This is done for statements without
// unknowns and motions.
void hold_far_off(const FormulaTask& task, const std::vector<OneSidedForce>& forces, Solution& solution);

}  // namespace poinsot::problem
