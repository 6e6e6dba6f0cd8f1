// Reads joints with their freedoms and supports.
#pragma once

#include "problem/entries/statement.h"

namespace poinsot::problem {

Joint read_joint(const std::string& name, Mark mark, const Entry& entry, const std::string& file);

}  // namespace poinsot::problem
