// The rotation of a rigid body by splitting its energy: the free motion of the symmetric body nearest to it, solved
// exactly; the departure from symmetry, two turns about principal axes; and the torque, a change of momentum alone.
// Strang's symmetric composition of these flows, composed 17 times to order 8 (Kahan and Li, Mathematics of Computation
// 66, 1997, s17odr8a): symplectic, reversible, and each flow keeps the momentum about the vertical.
#pragma once

#include <cmath>

#include "engine/motion/rotation/rotation_collocation.h"

namespace poinsot {

class RotationSplitting {
 public:
  explicit RotationSplitting(const PrincipalBody& body);

  // Whether the body has an axis of symmetry, up to rounding of its moments.
  bool is_symmetric() const { return std::fabs(difference_) <= 1e-15 * mean_; }
  // state at t to t + h, a step of order 8 whatever h.
  void step(RotationState& state, double t, double h) const;

  static constexpr int torques_per_step = 17;

 private:
  void drift(RotationState& state, double h) const;
  void kick(RotationState& state, double t, double h) const;

  const PrincipalBody& body_;
  std::size_t axis_ = 2;     // across which the moments differ least
  double mean_ = 0.0;        // of the reciprocal moments across it
  double own_ = 0.0;         // reciprocal moment about it, less the mean
  double difference_ = 0.0;  // half the difference of those across it
};

}  // namespace poinsot
