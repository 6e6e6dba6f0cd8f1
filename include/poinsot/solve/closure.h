// The pose of a mechanism with loops, cords and contacts: the coordinates that are given, and the others such that
// every loop is closed, every cord as long as drawn, and every contact touches.
#pragma once

#include <string>
#include <vector>

#include "poinsot/solve/equations.h"

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

// Whether a constraint binds positions as well; those against slipping bind velocities only.
bool binds_positions(const VelocityConstraint<double>& constraint);

// Contact points of bodies of revolution move over them as they turn: puts them where they touch now.
void update_contacts(Mechanism<double>& mechanism, const Moment& moment);

}  // namespace poinsot::solve
