// The second independent check: what joints, contacts and cords hold together stays together.
//
// As for the check on particles, nothing is shared with the solver but the figure and the numbers to be checked. The
// bodies are carried along from the figure, a little before and after the instant, and it is measured how far apart
// points have come that a loop, a contact or a cord joins, and how fast. The rows and gaps of the solver's equations
// (engine/dynamics/velocity_constraint.h) are not used.
#pragma once

#include <vector>

#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/solve/instant/particle_check.h"

namespace poinsot::solve {

// What is claimed of constraints at an instant.
struct ConstraintClaim {
  double length = 1;           // the size of the mechanism, m: gaps are told as parts of it
  double pace = 0;             // 1/s: at least as fast is the motion whose parts the rates of gaps are told as
  bool accelerations = false;  // whether the accelerations are known
  std::vector<bool> lets_go =
      {};  // of each action: whether its constraint may open, as after a blow; none may if empty
};

// The largest relative misfit of a constraint: its gap over the length (or the angle by which axes have come apart),
// the rate of the gap over length and pace, and with accelerations the rate of that rate over length and the square of
// the pace. q, v, a: as of check_with_particles.
double check_constraints(const std::vector<CheckLink>& links,
                         const std::vector<VelocityConstraint<double>>& constraints, const ConstraintClaim& claim,
                         const std::vector<double>& q, const std::vector<double>& v, const std::vector<double>& a);

// How fast what a constraint of a contact binds comes apart or slips, and the rate of that; by the same road.
struct ContactRate {
  double rate = 0, change = 0;
  Vector3<double> normal{};  // of a constraint that is a contact's normal: that of the surfaces, on ground axes
};
std::vector<ContactRate> contact_rates(const std::vector<CheckLink>& links,
                                       const std::vector<VelocityConstraint<double>>& contacts,
                                       const ConstraintClaim& claim, const std::vector<double>& q,
                                       const std::vector<double>& v, const std::vector<double>& a);

// The largest depth to which bodies overlap whose contact does not act, or by which a cord that does not is longer than
// it can be, over the length. acting: of each action.
double largest_overlap(const std::vector<CheckLink>& links, const std::vector<VelocityConstraint<double>>& constraints,
                       double length, const std::vector<bool>& acting, const std::vector<double>& q);

// How far apart the bodies of a contact are, or by how much a cord is longer than the way that it spans, m; negative
// where they overlap or it is stretched. By the same road; zero of what has neither gap nor length.
double gap_of(const std::vector<CheckLink>& links, const std::vector<VelocityConstraint<double>>& constraints,
              int action, const std::vector<double>& q);

}  // namespace poinsot::solve
