// The value of an ask at one choice of what a statement leaves open: of expressions, times and tables.
#pragma once

#include "problem/entries/statement.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// Stands above both the sample and the search for unknowns: the rows of a table over a datum have unknowns of their
// own. Throws StatementError where there is no value. A table is the list of its numbers row by row, with the names of
// its columns, one a line, as its text: a list in a column has one for each of its items, name_1, name_2.
// What the table runs over is its first column, where none of those that are asked for shows it or has its name.
Value<double> asked_value(Sample& sample, const Ask& ask);
bool shows_over(const Table& table);

}  // namespace poinsot::problem
