// Arms of bodies without shape that are bent, as shafts and forks are.
#pragma once

#include <vector>

#include "pictures/solids/projection.h"

namespace poinsot::pictures {

// A place at which an arm ends, and the axis that is held there, or zero.
struct ArmEnd {
  Vector at, axis;
};

// What a body goes through when it turns about its axis.
struct Sweep {
  Vector at, axis;
  double radius = 0, low = 0, high = 0;

  bool takes(const Vector& place) const;
};

Sweep sweep_of(const Vector& at, const Vector& axis, const std::vector<Vector>& vertices);

// From one end to the other along the axes and across them, if the axes are at right angles; else straight. It leaves
// the first axis where it is clear of what turns.
std::vector<Vector> bent_way(const ArmEnd& from, const ArmEnd& to, const std::vector<Sweep>& sweeps, double near);

// The arms of a fork that holds a body between two places of its axis, around what the body goes through and open on
// the side away from a third place; empty if the body leaves no room.
std::vector<Vector> fork_way(const Vector& from, const Vector& to, const Vector& stem, const Sweep& sweep, double near);

}  // namespace poinsot::pictures
