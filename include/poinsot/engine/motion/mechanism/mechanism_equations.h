// The equations of motion of a mechanism for the integrators.
#pragma once

#include <functional>

#include "poinsot/engine/motion/integrator/motion_equations.h"
#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"

namespace poinsot {

// What is given at the time t: called before the equations are used there. It sets forces, efforts and the
// accelerations of held coordinates of `dynamics`, and writes the positions and velocities of held coordinates into
// q and v.
using GivenInTime =
    std::function<void(double t, MechanismDynamics& dynamics, std::span<double> q, std::span<double> v)>;

// dynamics must outlive the equations; what it says after accelerations() belongs to the state last evaluated. Each
// projection puts a state back on the constraints. The energy is among the conserved quantities if nothing changes it:
// no loads, efforts, dampers or held coordinates.
MotionEquations mechanism_equations(MechanismDynamics& dynamics, GivenInTime given = {});

}  // namespace poinsot
