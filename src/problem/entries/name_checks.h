// Whether names in a file name anything, or are misspelt. root: the entry of the whole file.
#pragma once

#include "problem/entries/statement.h"
#include "problem/language/tree.h"

namespace poinsot::problem {

// Whether the names of bodies, frames and loads in a situation are names of such. Throws StatementError at the first
// name that names nothing, and suggests near ones.
void check_stated_names(const Situation& situation);

// A word under angle: or displacement: that is not the name of a datum names a coordinate. Throws StatementError if
// it is almost the name of a datum that nothing in the file uses.
void check_misspelt_coordinates(const Entry& root, const Statement& statement);

// Whether what the file states calls functions that have corners.
bool has_corners(const Entry& root);

// Throws StatementError for an unknown that occurs nowhere in the figure, the facts and the conditions, and is not
// like any word there: a misspelt word is reported at its own place when it is read.
void check_unused_unknowns(const Entry& root, const Statement& statement);

}  // namespace poinsot::problem
