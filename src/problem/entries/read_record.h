// Reads what is to be recorded of a motion.
#pragma once

#include <string>

#include "problem/entries/statement.h"

namespace poinsot::problem {

// Reads {every: 1 ms, for: 100 s, columns: {t: time, theta: theta}, unit: {theta: deg}}.
Record read_record(const Entry& entry, const std::string& file);

}  // namespace poinsot::problem
