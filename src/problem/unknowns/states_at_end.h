// What the conditions at an end leave open of the states of contacts.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::problem {

// Whether a limit of sticking leaves open what contacts with friction do at the values that are tried: those that it
// does not name, and those that slip.
bool leaves_states_open(const Situation& situation, const Extremum& extremum);
// The contacts that conditions want to stick, which fail in all other states of these. That holds for what is tried
// alone if no other state can take the place of one: none leaves smooth contacts and cords as they are where another
// does not, and none rests where another begins to slide.
std::vector<std::string> wanted_to_stick(const Situation& situation, const Extremum& extremum);

}  // namespace poinsot::problem
