// Reads joints with their freedoms and supports.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::problem {

Joint read_joint(const std::string& name, Mark mark, const Entry& entry, const std::string& file);

// The friction in joints, whose states are found with those of contacts.
std::vector<Contact> frictions_in(const std::vector<Joint>& joints);

// The joint, and its freedom, in which a friction acts: `pin`, or `slide of post` where the joint has several freedoms.
struct RubbingFreedom {
  const Joint& joint;
  std::size_t freedom = 0;

  const Freedom& stated() const { return joint.freedoms[freedom]; }
};
RubbingFreedom rubbing_freedom(const std::vector<Joint>& joints, const std::string& friction);

}  // namespace poinsot::problem
