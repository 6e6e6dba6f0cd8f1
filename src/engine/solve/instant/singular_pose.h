// Poses in which a loop could part: a crank in line with its coupler, a parallelogram that lies flat.
#pragma once

#include <cstddef>
#include <vector>

#include "poinsot/engine/dynamics/mechanism.h"

namespace poinsot::solve {

// Near a singular pose the gaps grow as the square of the distance from it. A pose that is closed to rounding is
// therefore off by the square root of rounding, and velocities that are free in the singular pose seem to be fixed.
// This function moves a closed pose q that cannot be told from a singular one onto it, to rounding, and leaves every
// other pose as it is. constraints: the indices of those that bind positions; movable: for each velocity coordinate
// whether it may be moved; length: a natural unit of the mechanism, m.
void settle_on_singular_pose(const Mechanism<double>& mechanism, const std::vector<std::size_t>& constraints,
                             const std::vector<bool>& movable, double length, std::vector<double>& q);

}  // namespace poinsot::solve
