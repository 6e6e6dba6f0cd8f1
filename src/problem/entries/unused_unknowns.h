// Unknowns that nothing can fix.
#pragma once

#include "problem/entries/statement.h"
#include "problem/language/tree.h"

namespace poinsot::problem {

// Throws StatementError for an unknown that stands nowhere in the figure, the facts and the conditions, nor anything
// like it: what is misspelt there is told at its place when it is read. root: the whole file.
void check_unused_unknowns(const Entry& root, const Statement& statement);

}  // namespace poinsot::problem
