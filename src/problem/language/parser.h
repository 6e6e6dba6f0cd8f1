// Parses the expression of one scalar by the grammar in expression.h.
#pragma once

#include <string>

#include "problem/language/expression.h"
#include "problem/language/tree.h"

namespace poinsot::problem {

// list_item: whether the scalar is an item of a list, where a comma may have cut it short. Throws StatementError.
Expression parse_scalar(const Entry& entry, const std::string& file, bool list_item);

}  // namespace poinsot::problem
