// Quantities in words.
#pragma once

#include <string>

#include "poinsot/statement/expression.h"
#include "poinsot/statement/problem.h"

namespace poinsot::statement {

// "angular momentum of disk about G, on the axes x y z of the ground".
std::string describe(const Ask& ask, const Problem& problem, bool is_vector);

}  // namespace poinsot::statement
