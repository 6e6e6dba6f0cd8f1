// Where contacts end: a round surface may end, and a straight side touches a plane only as long as it lies on it.
#pragma once

#include <optional>
#include <string>

#include "problem/machine/machine.h"

namespace poinsot::problem {

// The cosine of the angle, seen from the center of the round surface, between the contact and the middle of the
// surface, less the cosine for its end: negative beyond the end. Nothing if the surface has no end or the contact
// does not hold. The state must have its positions.
std::optional<double> left_of_surface(const ContactLimit& limit, const solve::MechanismState& state);
// Whether the contact is at the end of its surface and moves on beyond it. The state must have its velocities.
bool goes_beyond(const ContactLimit& limit, const solve::MechanismState& state);
// Whether a straight side turns out of the plane that it touches. The state must have its velocities. pace: of what
// moves, 1/s; a turning that is rounding beside it is none.
bool leaves_plane(const ContactLimit& limit, const solve::MechanismState& state, double pace);

// Whether it begins to, by the accelerations of the state: a body that is pressed at one point of a flat side alone.
bool begins_to_leave_plane(const ContactLimit& limit, const solve::MechanismState& state, double pace);

// Whether it is one of a rod, which may touch a peg as well as a floor: while it is at rest both bear it alike.
bool is_of_rod(const ContactLimit& limit, const Situation& situation);

// The message "contact 'floor' is beyond the end of the round surface of 'half'".
std::string words_of_end(const ContactLimit& limit);
// The message about a side that leaves its plane, and the hint what to write instead.
std::string words_of_side(const ContactLimit& limit);
std::string hint_of_flat_side(const ContactLimit& limit);
std::string hint_of_side(const ContactLimit& limit);

}  // namespace poinsot::problem
