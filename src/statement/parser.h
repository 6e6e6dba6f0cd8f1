// One expression from one scalar, by the grammar in expression.h.
#pragma once

#include <string>

#include "poinsot/statement/expression.h"
#include "poinsot/statement/tree.h"

namespace poinsot::statement {

// `list_item`: the scalar is an item of a list, where a comma may have cut it short. Throws StatementError.
Expression parse_scalar(const Entry& entry, const std::string& file, bool list_item);

}  // namespace poinsot::statement
