// How far a contact is good: a round surface ends somewhere, and a straight side touches a plane only along it.
#pragma once

#include <optional>
#include <string>

#include "problem/machine/machine.h"

namespace poinsot::problem {

// The cosine of the angle between where the contact is on its round surface and the middle of that surface, less that
// where the surface ends: negative beyond its end. Nothing where the surface is whole, or the contact does not hold.
// The moment has its positions.
std::optional<double> left_of_surface(const ContactLimit& limit, const solve::MechanismState& moment);
// Whether the contact stands at the end of its surface and goes on beyond it. The moment has its velocities.
bool goes_beyond(const ContactLimit& limit, const solve::MechanismState& moment);
// Whether a straight side turns out of the plane that it touches. The moment has its velocities.
bool leaves_plane(const ContactLimit& limit, const solve::MechanismState& moment);

// "contact 'floor' is beyond the end of the round surface of 'half'".
std::string words_of_end(const ContactLimit& limit);
// What is wrong where a side leaves its plane, and what to write.
std::string words_of_side(const ContactLimit& limit);
std::string hint_of_side(const ContactLimit& limit);

}  // namespace poinsot::problem
