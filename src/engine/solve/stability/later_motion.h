// A steady motion after a while, and what in it may make the equations of deviations change with time.
#pragma once

#include <vector>

#include "engine/solve/stability/doubted_rates.h"
#include "poinsot/engine/solve/stability/linearisation.h"

namespace poinsot::solve {

// The motion after a while, and what takes deviations on axes that follow no spin to the axes of then: exp(-S t), S the
// adjoint of the spins.
struct LaterMotion {
  SteadyMotion motion;
  Matrix turned;
};
LaterMotion later_motion(const SteadyMotion& motion, double delay);

// The spins of bodies that are not alike all round, or to which something is fastened, rad/s, and the turning of the
// frame where something stands on the ground: near such a motion the equations may change with time.
std::vector<double> uneven_spins(const SteadyMotion& motion);

}  // namespace poinsot::solve
