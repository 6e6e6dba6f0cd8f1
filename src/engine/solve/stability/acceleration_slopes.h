// How the accelerations of a mechanism vary near a motion, each number with a bound on its rounding.
#pragma once

#include <vector>

#include "engine/solve/stability/doubted_rates.h"
#include "poinsot/engine/math/algebra/rounded.h"
#include "poinsot/engine/solve/stability/linearisation.h"

namespace poinsot::solve {

// What a constraint or a component has for a coordinate that it cannot move is rounding of directions and points, which
// were themselves computed: up to so many times the bound, which counts every number as rounded once.
constexpr Real computed = 100;

// By deviations of coordinates and velocities, all measured like velocities.
struct AccelerationSlopes {
  Vector a, components;              // along the motion itself
  Doubted by_position, by_velocity;  // a column for each coordinate, zero for those that are held
  // The constraints: J, how J v varies with each coordinate, and which of them bind positions too.
  Doubted constraints, rates_by_position;
  std::vector<bool> binds_positions;
};

// The natural size of a change of a coordinate: 1 rad or the length of the motion.
double natural_size_of(const SteadyMotion& motion, Eigen::Index coordinate);

// Throws std::runtime_error if the accelerations are not determined.
AccelerationSlopes acceleration_slopes(const SteadyMotion& motion);

}  // namespace poinsot::solve
