// Whether loads that depend on the motion stay the same along a steady motion and have slopes there, so that deviations
// obey linear equations with constant coefficients.
#pragma once

#include <cstddef>
#include <optional>

#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/solve/stability/linearisation.h"

namespace poinsot::solve {

// One of the mechanism's forces.
struct UnsteadyLoad {
  std::size_t force = 0;
  // Whether it has a corner at this motion, as |s| at s = 0. Else it does not go round with the frame: it keeps to
  // directions or places on the ground, or rides with a body that spins.
  bool corner = false;
};

// The first of the forces by motion that cannot be linearised. pace: 1/s, that of the fastest motion.
std::optional<UnsteadyLoad> unsteady_load(const SteadyMotion& motion, double pace);

}  // namespace poinsot::solve
