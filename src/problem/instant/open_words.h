// What the equations of an instant leave open, in words: for answers that are not determined.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "problem/instant/instant.h"

namespace poinsot::problem {

// "a, b and c", with `last` between the last two.
std::string listed(const std::vector<std::string>& names, const char* last);

// "the rate of joint 'A'" for what is named so, or without its article.
std::string with_article(const std::string& name);

// That nothing fixes these velocities, of which `missing` would do.
std::string open_velocities(std::vector<std::string> names, std::size_t missing);

// What of accelerations and forces, or of impulses, one open direction of an instant moves, and that nothing fixes it.
std::string open_force(const SolvedInstant& instant, std::size_t direction);

}  // namespace poinsot::problem
