// The account of a motion's energy where loads that depend on the motion bring it and take it away.
#pragma once

#include <functional>
#include <optional>

#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/motion/integrator/trajectory.h"

namespace poinsot::problem {

// By how much the change of kinetic and potential energy along a way differs from the work of loads, drives and
// dampers, as a part of the largest of these energies or of `size`, J. Nothing for a way of no length. The mechanism
// must have no given motions and no data that follow time. more: the power of what it does not know, such as friction.
std::optional<double> energy_misfit(const Mechanism<double>& mechanism, const Trajectory& way, double size,
                                    const std::function<double(const State<double>&)>& more = {});

}  // namespace poinsot::problem
