// Finds names of coordinates that are probably misspelt names of data.
#pragma once

#include "problem/entries/statement.h"
#include "problem/language/tree.h"

namespace poinsot::problem {

// A word under angle: or displacement: that is not the name of a datum names a coordinate. Throws StatementError if
// it is almost the name of a datum that nothing in the file uses. root: the entry of the whole file.
void check_misspelt_coordinates(const Entry& root, const Statement& statement);

}  // namespace poinsot::problem
