// Several formulas of one answer, each with the conditions under which it holds.
//
// A formula takes one branch of what has several: the larger of two forces, a cord that catches in a blow or not.
// Beyond the border of its branch the formulas are derived anew, from letters at which the conditions of those known
// fail.
#pragma once

#include <vector>

#include "problem/formulas/formula_conditions.h"
#include "problem/formulas/formula_search.h"

namespace poinsot::problem {

// Looks for the formulas of answers where the conditions held fail. Each is compared with numbers like the first, where
// it is said to hold. An answer whose formula there holds everywhere gets that one; for letters where none was found a
// note says so. Not for statements with unknowns, whose roots are told apart by their first formulas.
void find_regimes(const FormulaTask& task, const FormulaGrounds& grounds, std::vector<HeldCondition>& held,
                  Solution& solution);

// Adds the conditions to the assumptions of the solution: "4*g - L*w^2 > 0 for 'slow'".
void tell_conditions(const FormulaTask& task, const FormulaGrounds& grounds, const std::vector<HeldCondition>& held,
                     Solution& solution);

}  // namespace poinsot::problem
