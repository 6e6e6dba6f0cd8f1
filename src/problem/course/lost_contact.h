// Contacts that are no longer pressed.
#pragma once

#include <cstddef>
#include <span>

#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"

namespace poinsot::problem {

// The acceleration with which the gap of a constraint that does not act opens, m/s^2.
double opening_acceleration(MechanismDynamics& dynamics, std::size_t constraint, std::span<const double> q,
                            std::span<const double> v, double pace_time);

// Whether the bodies would penetrate each other if a contact ceased to act. The friction ends with the pressure, and
// the remaining forces may press the bodies together. The action belongs to the mechanism of the dynamics, in the
// state (q, v) in which the bodies touch. length: natural to the motion, m; pace_time: in which it changes noticeably,
// s. After the call the action does not act in the dynamics.
bool would_press_in(MechanismDynamics& dynamics, std::size_t action, std::span<const double> q,
                    std::span<const double> v, double length, double pace_time);

}  // namespace poinsot::problem
