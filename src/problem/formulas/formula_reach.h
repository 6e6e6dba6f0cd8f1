// Checks how far formulas hold, and answers that do not change with the letters.
//
// A formula may hold on one side of a branch only, and an answer may be constant only for ordinary values. So both
// are tried where letters are far larger or negative, and angles beyond a right angle.
#pragma once

#include <vector>

#include "problem/formulas/formula_conditions.h"
#include "problem/formulas/formula_search.h"

namespace poinsot::problem {

// Solves the statement at letters far from their ordinary values: all of them over six decades, each alone, with
// reversed sign, with angles in every quadrant. What the formulas rest on and what fails there, with the formula or
// because a cord would push or a contact pull, is a condition: that of a cord or contact becomes an assumption of the
// solution, with its formula, and the others are returned, none of which follows from another. A formula that does not
// agree for no such reason is withdrawn. An answer without formula that changes depends on the letters. The largest
// difference that was left is the check "formulas". Laws of motions and searches are not concerned.
std::vector<HeldCondition> hold_far_off(const FormulaTask& task, const FormulaGrounds& grounds, Solution& solution);

}  // namespace poinsot::problem
