// A rotating body on its principal axes, its state in the variables that the methods of rotation.h use, and the two
// ways between that state and the numbers an integration shows.
#pragma once

#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/engine/math/algebra/vector3.h"
#include "poinsot/engine/motion/rotation/rotation.h"

namespace poinsot {

struct RotationState;

// The body on its principal axes.
struct PrincipalBody {
  explicit PrincipalBody(const RotatingBody& body);

  Vector3<double> moments;
  Quaternion<double> axes;       // principal axes to body axes
  Vector3<double> weight_arm{};  // first moment times the gravity's magnitude, principal axes, N m
  Vector3<double> down{};        // unit vector of gravity, ground axes; zero where there is no weight
  bool has_weight = false;
  const RotatingBody* body = nullptr;  // where there is a further torque, its owner

  bool has_torque() const { return has_weight || body; }
  // Torque about the point on ground axes; attitude of the principal axes, momentum on ground axes.
  Vector3<double> torque(double t, const Quaternion<double>& attitude, const Vector3<double>& momentum) const;
  Vector3<double> angular_velocity(const Quaternion<double>& attitude, const Vector3<double>& momentum) const;

  // Whether weight is all that turns it, so that its energy lasts.
  bool keeps_energy() const { return !body; }
  double energy(const RotationState& state) const;  // J; kinetic and of its weight
  // Turns the attitude by the least angle that gives the state this energy, by a step of Newton's method: where more
  // than rounding is missing, and the angle is less than `most` (rad, at most 1e-3).
  void restore_energy(RotationState& state, double energy, double most) const;
};

struct RotationState {
  Quaternion<double> attitude;  // principal axes to ground axes
  Vector3<double> momentum;     // ground axes, kg m^2/s
  Vector3<double> carry{};      // what rounding took off the momentum

  void gain(const Vector3<double>& impulse) {
    const Vector3<double> sum = impulse + carry;
    const Vector3<double> old = momentum;
    momentum += sum;
    carry = sum - (momentum - old);
  }
};

// Attitude of the body axes and angular velocity on them (7 numbers) from the state, and back.
void write_rotation(const PrincipalBody& body, const RotationState& state, double* y);
RotationState read_rotation(const PrincipalBody& body, const double* y);

}  // namespace poinsot
