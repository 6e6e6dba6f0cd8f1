// Contacts and joints with friction that take no part in a blow, which does not press them
// (course/flying_contacts.cpp).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/machine/data.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// Whether nothing moves before the blow of a situation.
bool rests_before_blow(const Situation& situation, const Settings& settings);

// Friction in joints is limited and has no impulse: in a blow these move as if they had none. number: the place of the
// situation in its statement.
void add_joints_in_blow(const Situation& situation, std::size_t number, std::vector<ContactState>& states);

// The states of all contacts and joints with friction if none takes part. Nothing where a contact is pressed and the
// blow can be solved from rest, where all states are looked for so that none is missed. Throws StatementError where it
// is pressed and cannot.
std::optional<std::vector<ContactState>> idle_in_blow(const Situation& situation, std::size_t number,
                                                      const Settings& settings);

// The same of a blow in letters that neither presses nor lifts what has friction, at none of several values of the
// letters: then friction has no impulse, whatever its coefficient. Throws StatementError elsewhere, which names one of
// the letters.
std::vector<ContactState> untouched_in_blow(const Situation& situation, std::size_t number,
                                            const std::vector<Settings>& at, const std::string& letter);

}  // namespace poinsot::problem
