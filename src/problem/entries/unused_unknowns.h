// Finds unknowns that nothing can determine.
#pragma once

#include "problem/entries/statement.h"
#include "problem/language/tree.h"

namespace poinsot::problem {

// Throws StatementError for an unknown that occurs nowhere in the figure, the facts and the conditions, and is not
// like any word there: a misspelt word is reported at its own place when it is read. root: the entry of the whole
// file.
void check_unused_unknowns(const Entry& root, const Statement& statement);

}  // namespace poinsot::problem
