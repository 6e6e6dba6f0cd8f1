// Describes what the equations of an instant leave open, for answers that are not determined.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "problem/instant/instant.h"

namespace poinsot::problem {

// The name with its article if it needs one: "the rate of joint 'A'".
std::string with_article(const std::string& name);

// Says that nothing determines these velocities; `missing` of them would suffice.
std::string open_velocities(std::vector<std::string> names, std::size_t missing);

// Names the accelerations and forces, or impulses, that change in one open direction of an instant, and says that
// nothing determines them; those of the asked names first.
std::string open_force(const SolvedInstant& instant, std::size_t direction, const std::set<std::string>& asked = {});

// What can be done where forces share a load.
inline constexpr std::string_view remedy_of_shares =
    " (carries: of a contact and supports: of a joint say what each can bear)";

}  // namespace poinsot::problem
