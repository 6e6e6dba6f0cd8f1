// A blow on bodies that rest on rough contacts, as an instant: what sticks, slides and parts in it.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/vector3.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {

// In a blow that starts where no contact with friction slips, velocities grow in proportion to the impulses applied, so
// that each contact does one thing throughout: the laws of friction for impulses and velocities after the blow are
// those for forces and accelerations of the same bodies at rest, under loads as large as the impulses in a second,
// without gravity, springs and other forces. Throws StatementError for what is no such blow.
Situation blow_as_loads(const Situation& situation);

// The momentum of a body, its angular part about the mass center, on ground axes.
struct StatedMomentum {
  std::string body;
  Vector3<double> linear, angular;
};
// A blow without rebound on bodies that move is one on the same bodies at rest under impulses as large as their
// momenta, as both have the same velocities after it: as loads, which have them as accelerations in a second.
Situation momenta_as_loads(const Situation& situation, const std::vector<StatedMomentum>& momenta);

}  // namespace poinsot::problem
