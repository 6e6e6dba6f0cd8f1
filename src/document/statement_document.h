// Makes the answer document of a solved statement.
#pragma once

#include "poinsot/document.h"
#include "problem/entries/statement.h"
#include "problem/language/value.h"
#include "problem/results/solution.h"

namespace poinsot::document {

// A value as a datum, in a unit of which one is `factor` in SI units.
Datum datum(const problem::Value<double>& value, double factor);

// The document without worked solutions.
Document document_of(const problem::Statement& stated, const problem::SolvedStatement& solved);

}  // namespace poinsot::document
