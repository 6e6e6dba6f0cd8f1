// A coordinate's name that is probably a misspelt datum.
#pragma once

#include "problem/entries/statement.h"
#include "problem/language/tree.h"

namespace poinsot::problem {

// A word under angle: or displacement: that names no datum is the name of a coordinate. Throws StatementError if it is
// nearly the name of a datum that nothing in the file uses. root: the whole file.
void check_misspelt_coordinates(const Entry& root, const Statement& statement);

}  // namespace poinsot::problem
