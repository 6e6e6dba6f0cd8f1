// Reads bodies and their parts.
#pragma once

#include "problem/entries/statement.h"

namespace poinsot::problem {

struct ReadContext {
  std::string file;
  std::array<std::string, 3> axes;  // the names of the axes
  std::optional<MotionPlane> plane{};
};

Body read_body(const std::string& name, Mark mark, const Entry& entry, const ReadContext& context);

}  // namespace poinsot::problem
