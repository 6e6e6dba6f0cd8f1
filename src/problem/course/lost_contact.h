// Contacts that press no more.
#pragma once

#include <cstddef>
#include <span>

#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"

namespace poinsot::problem {

// Whether a contact would be pressed in if it did not act: where friction went with its pressure, what is left may
// drive the bodies into each other. The contact of an action of the dynamics' mechanism; in the state (q, v), where it
// touches; pace_time: in which the motion changes noticeably, s. The action no longer acts afterwards.
bool would_press_in(MechanismDynamics& dynamics, std::size_t action, std::span<const double> q,
                    std::span<const double> v, double pace_time);

}  // namespace poinsot::problem
