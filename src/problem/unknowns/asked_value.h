// The value of an ask at one choice of what a statement leaves open: of expressions, times and tables.
#pragma once

#include "problem/entries/statement.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// Stands above both the sample and the search for unknowns: the rows of a table over a datum have unknowns of their
// own. Throws StatementError where there is no value.
Value<double> asked_value(Sample& sample, const Ask& ask);

}  // namespace poinsot::problem
