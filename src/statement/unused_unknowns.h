// Unknowns that nothing can fix.
#pragma once

#include "poinsot/statement/problem.h"
#include "poinsot/statement/tree.h"

namespace poinsot::statement {

// Throws StatementError for an unknown that stands nowhere in the figure, the facts and the conditions, nor anything
// like it: what is misspelt there is told at its place when it is read. root: the whole file.
void check_unused_unknowns(const Entry& root, const Statement& statement);

}  // namespace poinsot::statement
