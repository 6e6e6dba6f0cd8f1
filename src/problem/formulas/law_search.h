// The laws that answers found by numbers follow: motions followed and unknowns searched at other letters.
#pragma once

#include "problem/formulas/formula_search.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// Gives every ask of the solution that has no formula yet, but needs letters, its law if it has one (scaling_law.h),
// else the reason why it has none; lists unknowns with laws if none are listed. The trials are checked on particles.
// Never throws for a law that cannot be had.
void find_laws(const FormulaTask& task, Solution& solution);

// Notes how the formulas that stand were found, where they are laws.
void tell_laws(const Statement& statement, Solution& solution);

}  // namespace poinsot::problem
