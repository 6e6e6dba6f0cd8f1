// What was solved, as the answer document shows it.
#pragma once

#include "poinsot/document.h"
#include "problem/entries/statement.h"
#include "problem/language/value.h"
#include "problem/results/solution.h"

namespace poinsot::document {

// A value with its numbers in a unit of so much in SI.
Datum datum(const problem::Value<double>& value, double factor);

// Without worked solutions.
Document document_of(const problem::Statement& stated, const problem::SolvedStatement& solved);

}  // namespace poinsot::document
