// Where impulses, impacts and particles strike and along what, by the way of the bodies from the figure: a second road
// to how a blow was read.
#pragma once

#include <optional>

#include "poinsot/engine/solve/instant/impulse.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

// By how much a blow is otherwise than it is stated, as a part of its size. unit: a length of the machine.
double misfit_of_blow(const solve::MechanismState& before, const Machine& machine, DataScope<double>& data,
                      const solve::Blow& blow, double unit);
// By how much the bodies leave smooth impacts otherwise than Newton's restitution says, u' = -e u along the push, as a
// part of their relative velocities. Nothing where no impact states a restitution.
std::optional<double> misfit_of_restitution(const solve::MechanismState& before, const solve::MechanismState& after,
                                            const Machine& machine, DataScope<double>& data);

}  // namespace poinsot::problem
