// What is not solved where contacts have friction.
#pragma once

#include "problem/entries/statement.h"

namespace poinsot::problem {

// Throws StatementError, which says which and why: for facts of later instants, blows, steady motions and stability,
// claims, records, tables over data, and extrema but for the limit of sticking.
void refuse_beside_friction(const Statement& statement);

// Whether the extremum is the limit up to which contacts stick: {smallest: mu, while: sticking(floor)}.
bool is_limit_of_sticking(const Ask& ask);

}  // namespace poinsot::problem
