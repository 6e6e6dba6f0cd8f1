// Finds the pose of a mechanism with loops, cords and contacts: some coordinates are given, and the others follow
// such that every loop is closed, every cord has the length as drawn, and every contact touches.
#pragma once

#include <cstddef>
#include <vector>

#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/solve/instant/equations.h"

namespace poinsot::solve {

struct Closure {
  std::vector<double> q;
  double gap = 0;              // the largest distance (m) or angle (rad) that is left
  double relative = 0;         // the same as a part of the mechanism's length, or of a radian
  std::size_t constraint = 0;  // the place in the mechanism of the constraint that it belongs to, if anything is open
};

// Starts from the drawn pose, in which everything is closed. The given coordinates (marked for each entry of q) move
// to their targets in small steps, and the others follow by Newton's method with the least displacements that close
// the gaps. So the pose is the one that is reached without a jump.
Closure close_pose(const Mechanism<double>& mechanism, const std::vector<double>& target,
                   const std::vector<bool>& given);

// The derivatives of a closed pose. closed: the q that close_pose found for the plain numbers of mechanism and
// target. The given coordinates vary as their targets do, the others by the implicit function theorem, which is one
// step of Newton's method.
std::vector<Dual<1>> varied_pose(const Mechanism<Dual<1>>& mechanism, const std::vector<double>& closed,
                                 const std::vector<Dual<1>>& target, const std::vector<bool>& given);

using poinsot::binds_positions;

// Moves the contact points of rolling bodies of revolution to where the bodies touch in this pose. The state must
// have its positions. The scalar is double, Dual<1> or Formula.
template <class Scalar>
void update_contacts(Mechanism<Scalar>& mechanism, const MechanismStateOf<Scalar>& state);

}  // namespace poinsot::solve
