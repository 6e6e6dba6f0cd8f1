// Motions known in closed form, as the flows and methods of integration.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/motion/closed_form/body_coordinates.h"
#include "engine/motion/integrator/step_method.h"
#include "poinsot/engine/motion/closed_form/symmetric_top.h"
#include "poinsot/engine/motion/closed_form/torque_free.h"

namespace poinsot {

// The rotation of a body through time, from what it is at one instant or, in closed form, without minding that.
class RotationFlow {
 public:
  virtual ~RotationFlow() = default;
  // Attitude and angular velocity of `from` at the time t0, taken to the time t.
  virtual void advance(double t0, const BodyPose& from, double t, BodyPose& pose) const = 0;
  // In which the body turns by about a radian, s.
  virtual double natural_time() const = 0;
  // Times after which the motion may come back but for constant turns about the first and the last of three axes, s:
  // which of them do so depends on the axes.
  virtual std::vector<double> periods() const { return {}; }
};

// Constant angular velocity; attitude and angular velocity are those of the pose at t0.
std::shared_ptr<const RotationFlow> uniform_rotation(double t0, const BodyPose& pose);
std::shared_ptr<const RotationFlow> torque_free_rotation(double t0, const BodyPose& pose,
                                                         const SymmetricMatrix3<double>& inertia);
// axis: of symmetry, a unit vector on body axes; up: a unit vector on ground axes. gravity_moment as in TopParameters.
std::shared_ptr<const RotationFlow> top_rotation(double t0, const BodyPose& pose, const TopParameters& parameters,
                                                 const Vector3<double>& axis, const Vector3<double>& up);

// A motion that is known at any time, but for how often its angles have gone round.
class WindingFlow : public StateFlow {
 public:
  // The state at t, its angles those nearest to the ones in `before`.
  virtual void nearest(double t, std::span<const double> before, std::span<double> state) const = 0;
};

// The same flow over any time: whole periods in which the angles advance by known amounts, the rest in parts no longer
// than natural_time. The first of the periods with which the motion comes back so; none if none does, or only after
// very many parts. sizes: of each coordinate, 1 for angles (rad) and a length for displacements (m).
std::shared_ptr<const StateFlow> recurrent_flow(const std::shared_ptr<const WindingFlow>& flow,
                                                std::span<const double> periods, double natural_time, double start,
                                                std::span<const double> q, std::span<const double> v,
                                                std::span<const double> sizes);

// A body's rotation in the coordinates of its joints, with its mass center on the parabola of free fall.
class BodyFlow final : public WindingFlow {
 public:
  BodyFlow(std::shared_ptr<const BodyCoordinates> coordinates, std::shared_ptr<const RotationFlow> rotation, double t0,
           const BodyPose& pose, const Vector3<double>& gravity);
  void advance(double from, std::span<const double> start, double to, std::span<double> state) const override;
  // Of closed forms, which do not mind where they come from.
  void nearest(double t, std::span<const double> before, std::span<double> state) const override;
  double natural_time() const override { return rotation_->natural_time(); }

 private:
  void place(const BodyPose& pose, double t, std::span<const double> before, std::span<double> state) const;
  void reach(double from, std::span<const double> start, double to, std::span<double> state, int depth) const;

  std::shared_ptr<const BodyCoordinates> coordinates_;
  std::shared_ptr<const RotationFlow> rotation_;
  double t0_;
  Vector3<double> center_, velocity_, gravity_;
};

// The angle of a body about a fixed axis, as a state of one coordinate.
struct AxisMotion {
  double t0 = 0;             // s
  double angle = 0;          // at t0, from upright to the arm of the weight, rad
  double coordinate = 0;     // the joint's angle at t0, rad
  double rate = 0;           // at t0, rad/s
  double moment = 0;         // of inertia about the axis, kg m^2
  double weight_moment = 0;  // of the weight when the arm is level, N m; zero: uniform rotation
};
struct AxisFlows {
  std::shared_ptr<const WindingFlow> flow;
  std::vector<double> periods;  // s; none where it turns uniformly, and any time is as near as another
};
AxisFlows axis_flow(const AxisMotion& motion);

// A method of steps of one length along a flow that needs none.
std::unique_ptr<StepMethod> make_known_method(std::shared_ptr<const StateFlow> flow, double step);

}  // namespace poinsot
