// What springs store, by the places of their ends and the turns of their bodies on their way from the figure.
#pragma once

#include <optional>

#include "problem/machine/machine.h"
#include "problem/witness/free_motion_witness.h"

namespace poinsot::problem {

// The energy that was told of springs, or its rate. Nothing where a body swings while a torsional spring twists, or a
// freedom has no coordinate of its own: there is no second road then.
std::optional<Witness> spring_energy(const ToldQuantity& told, const solve::ParticlePaths& paths,
                                     const Machine& machine, DataScope<double>& data, const std::vector<double>& v);

}  // namespace poinsot::problem
