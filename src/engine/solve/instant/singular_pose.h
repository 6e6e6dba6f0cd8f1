// Poses in which a loop could part: a crank in line with its coupler, a parallelogram that lies flat.
#pragma once

#include <cstddef>
#include <vector>

#include "poinsot/engine/model/mechanism.h"

namespace poinsot::solve {

// Near a singular pose gaps grow as the square of what the pose is off: one closed to rounding is off by the root of
// that, and velocities that are open there seem to be fixed. Puts a closed pose q that cannot be told from a singular
// one onto it, to rounding; leaves every other one as it is. constraints: those that bind positions, by their indices;
// movable: for each velocity coordinate, whether it may be moved; length: a natural unit of the mechanism, m.
void settle_on_singular_pose(const Mechanism<double>& mechanism, const std::vector<std::size_t>& constraints,
                             const std::vector<bool>& movable, double length, std::vector<double>& q);

}  // namespace poinsot::solve
