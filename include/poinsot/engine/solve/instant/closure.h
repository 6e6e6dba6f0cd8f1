// The pose of a mechanism with loops, cords and contacts: the coordinates that are given, and the others such that
// every loop is closed, every cord as long as drawn, and every contact touches.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/solve/instant/equations.h"

namespace poinsot::solve {

struct Closure {
  std::vector<double> q;
  double gap = 0;     // largest distance (m) or angle (rad) left open
  std::string where;  // the words of the constraint that it belongs to
};

// From the drawn pose, in which all is closed, the given coordinates move to their values in small steps and the others
// follow by Newton's method, the least that closes. given: for each entry of q. The solution is the one reached without
// a jump.
Closure close_pose(const Mechanism<double>& mechanism, const std::vector<double>& target,
                   const std::vector<bool>& given);

// How a closed pose varies. closed: the q that close_pose found for the plain numbers of mechanism and target. The
// given coordinates vary as their targets do, the others by the implicit function theorem: one step of Newton's method.
std::vector<Dual<1>> varied_pose(const Mechanism<Dual<1>>& mechanism, const std::vector<double>& closed,
                                 const std::vector<Dual<1>>& target, const std::vector<bool>& given);

using poinsot::binds_positions;

// Contact points of bodies of revolution move over them as they turn: puts them where they touch now. Scalar: double or
// Dual<1>.
template <class Scalar>
void update_contacts(Mechanism<Scalar>& mechanism, const MechanismStateOf<Scalar>& moment);

}  // namespace poinsot::solve
