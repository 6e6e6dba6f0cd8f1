// The rotation of one rigid body, free or with a fixed point, under slow torques: many times faster than integrate.h.
//
// What the body would do without torque if it were symmetric is taken exactly, however fast it spins: with L the
// angular momentum, n the principal axis across which the moments differ least (I' their mean, in reciprocals) and I
// the moment about it,
//
//   attitude(t) = exp(L t/I') attitude(0) exp(n (L.n) (1/I - 1/I') t)                       (Eqs. 18.46 to 18.48)
//
// Only the departure from this motion, by torques and by unequal moments, is integrated: adaptively by Gauss-Legendre
// collocation of order 16, all eight stages at once in packs; a body without further torques gets its energy back after
// each step. The structure-preserving choice, in equal steps, is for a symmetric body a symplectic splitting of order 8
// around that motion, whose energy error stays bounded; for others the collocation, solved to rounding.
#pragma once

#include <functional>
#include <span>

#include "poinsot/engine/math/algebra/matrix3.h"
#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/engine/motion/integrator/integrate.h"

namespace poinsot {

struct RotatingBody {
  // About the fixed point or, for a free body, the mass center; on body axes, kg m^2. Positive definite.
  SymmetricMatrix3<double> inertia;
  // Mass times the mass center's position from the fixed point, on body axes, kg m. Zero for a free body.
  Vector3<double> first_moment{};
  Vector3<double> gravity{};  // acceleration of free fall, ground axes, m/s^2
  // A further torque about that point, ground axes, N m, or none; angular_velocity on body axes. Slow: it must vary
  // little while the body turns. For the structure-preserving choice it must not depend on the angular velocity.
  std::function<Vector3<double>(double t, const Quaternion<double>& attitude, const Vector3<double>& angular_velocity)>
      torque;
};

// Its equations of motion for integrate(): q the attitude quaternion, v the angular velocity on body axes. Without a
// further torque the energy and the angular momentum about the vertical are conserved (all its components if the weight
// has no moment). Errors: std::invalid_argument if the inertia is not positive definite or a number not finite.
MotionEquations rotation_equations(const RotatingBody& body);

// The motion from attitude and angular velocity (body axes, rad/s) at start to end. Methods: automatic and
// collocation integrate as said above, explicit_runge_kutta by Dormand and Prince's method; structure_preserving in
// equal steps; stiff as for integrate(). The result has q = attitude, v = angular velocity on body axes.
// Errors: as rotation_equations() and integrate().
IntegrationResult integrate_rotation(const RotatingBody& body, double start, const Quaternion<double>& attitude,
                                     const Vector3<double>& angular_velocity, double end,
                                     const IntegrationOptions& options = {}, std::span<const Event> events = {});

}  // namespace poinsot
