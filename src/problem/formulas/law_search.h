// Finds the laws of answers that are found by numbers: the motion is followed, or unknowns are searched, at several
// values of the letters.
#pragma once

#include "problem/formulas/formula_search.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// Gives every ask of the solution that depends on letters and has no formula its law (scaling_law.h), or the reason
// why it has none, and lists the unknowns that have laws if none are listed. The trials are checked with particles.
// The absence of a law is never thrown. forces: of cords and contacts at instants; where one of them would act the
// wrong way a law need not hold, and the solution then assumes that it does not.
void find_laws(const FormulaTask& task, const std::vector<OneSidedForce>& forces, Solution& solution);

// Notes of each formula that is a law how it was found.
void tell_laws(const Statement& statement, Solution& solution);

}  // namespace poinsot::problem
