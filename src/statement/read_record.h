// Reads what is recorded of a motion.
#pragma once

#include <string>

#include "poinsot/statement/problem.h"

namespace poinsot::statement {

// {every: 1 ms, for: 100 s, columns: {t: time, theta: theta}, unit: {theta: deg}}
Record read_record(const Entry& entry, const std::string& file);

}  // namespace poinsot::statement
