// Reads bodies and their parts.
#pragma once

#include "poinsot/statement/problem.h"

namespace poinsot::statement {

struct ReadContext {
  std::string file;
  std::array<std::string, 3> axes;  // the names of the axes
};

Body read_body(const std::string& name, Mark mark, const Entry& entry, const ReadContext& context);

}  // namespace poinsot::statement
