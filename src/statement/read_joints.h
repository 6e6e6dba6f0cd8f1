// Reads joints with their freedoms and supports.
#pragma once

#include "poinsot/statement/problem.h"

namespace poinsot::statement {

Joint read_joint(const std::string& name, Mark mark, const Entry& entry, const std::string& file);

}  // namespace poinsot::statement
