// Mechanisms in which one rigid body moves by itself: free, about a fixed point or about a fixed axis, under no load
// but its weight, whatever joints, gimbals and angles describe it. Their motion is found far more closely, and sooner,
// than by integrating the equations of a mechanism:
//
// * in closed form, good at any time: torque-free motion (torque_free.h) of a free body, whose mass center moves on a
//   parabola, and of a body held at its mass center or without weight; the symmetric top about a point of its axis
//   (symmetric_top.h), with the spherical pendulum; the pendulum about a fixed axis; uniform rotation;
// * by the integrator of rotations (rotation.h): any other body with a fixed point.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/motion/integrator/integrate.h"

namespace poinsot {

class BodyCoordinates;

class LoneBody {
 public:
  // The body of a mechanism that is such a one. Massless bodies may carry it (gimbals), as long as their axes meet in a
  // point, each perpendicular to the one before; others may be welded to it or to the ground. held: velocity
  // coordinates with accelerations of zero; those that turn no inertia are welcome.
  static std::optional<LoneBody> find(const Mechanism<double>& mechanism, std::span<const int> held = {});

  // The motion from the state (q, v) of the mechanism at start to end, as integrate() gives it; result.method says how
  // it was found. In closed form tolerance and limits have no meaning, and a step is a part of a turn; without events
  // steps to late times are longer, but where angles have to be followed turn by turn. None where the motion is no such
  // one after all: two axes in a fork that hold more than a rod.
  std::optional<IntegrationResult> follow(const MotionEquations& equations, double start, std::span<const double> q,
                                          std::span<const double> v, double end, const IntegrationOptions& options = {},
                                          std::span<const Event> events = {}) const;

 private:
  enum class Freedom { free, point, axis };
  LoneBody() = default;
  std::optional<IntegrationResult> follow_axis(const MotionEquations& equations, double start,
                                               std::span<const double> q, std::span<const double> v, double end,
                                               const IntegrationOptions& options, std::span<const Event> events) const;

  Freedom freedom_ = Freedom::free;
  std::shared_ptr<const BodyCoordinates> coordinates_;  // not for an axis
  bool spins_ = true;                                   // the turning about the arm is among the coordinates
  double mass_ = 0;
  // About the fixed point, or the mass center of a free body; on the working axes of the last joint.
  SymmetricMatrix3<double> inertia_{};
  Vector3<double> arm_{};      // from the fixed point or axis to the mass center, on the same axes
  Vector3<double> gravity_{};  // ground axes, m/s^2
  // A fixed axis: on ground axes; the body's attitude with the angle zero; the moment about it.
  Vector3<double> axis_{};
  Matrix3<double> attitude_{};
  double axial_moment_ = 0;
};

}  // namespace poinsot
