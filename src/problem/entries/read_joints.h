// Reads joints with their freedoms and supports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::problem {

Joint read_joint(const std::string& name, Mark mark, const Entry& entry, const std::string& file);

// The friction in joints, whose states are found with those of contacts.
std::vector<Contact> frictions_in(const std::vector<Joint>& joints);

// The joint in which a friction acts, and its freedom: `pin`, or `slide of post` where one of several freedoms has
// friction of its own; nothing where the friction is against all its ways together.
struct RubbingJoint {
  const Joint& joint;
  std::optional<std::size_t> freedom;

  const Friction& stated() const { return freedom ? *joint.freedoms[*freedom].friction : *joint.friction; }
};
RubbingJoint rubbing_joint(const std::vector<Joint>& joints, const std::string& friction);

}  // namespace poinsot::problem
