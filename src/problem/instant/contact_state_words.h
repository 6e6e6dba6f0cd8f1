// States of contacts with friction as a user reads them, and the names of the directions in which they slide.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/machine/data.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// "contact 'floor' slides along x". along: the components of the direction, if it slides in one without a name.
std::string words_of(const ContactState& state, const std::vector<double>& along = {});
// The same with numbers wherever the direction has no name.
std::string words_of(const ContactState& state, const Situation& situation, const Settings& settings);

// Gives a direction its name where it has one, for which formulas are exact; false if it has none.
bool name_direction(ContactState& state, const Situation& situation, const Settings& settings);

// Whether two combinations are the same, with directions by name.
bool are_same(const std::vector<ContactState>& a, const std::vector<ContactState>& b);

}  // namespace poinsot::problem
