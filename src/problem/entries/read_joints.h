// Reads joints with their freedoms and supports.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::problem {

Joint read_joint(const std::string& name, Mark mark, const Entry& entry, const std::string& file);

// The friction in joints, whose states are found with those of contacts.
std::vector<Contact> frictions_in(const std::vector<Joint>& joints);

}  // namespace poinsot::problem
