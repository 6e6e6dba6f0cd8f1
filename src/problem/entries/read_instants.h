// Reads what is stated of instants, of stages and of a steady motion.
#pragma once

#include <string>

#include "problem/entries/statement.h"
#include "problem/language/tree.h"

namespace poinsot::problem {

Instant read_instant(const Key& name, const Entry& entry, const std::string& file);
Stage read_stage(const Key& name, const Entry& entry, const std::string& file);
Steady read_steady(const Entry& entry, const std::string& file);

}  // namespace poinsot::problem
