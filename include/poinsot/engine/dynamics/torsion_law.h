// A torsional spring with a damper between two bodies, joined or not, about an axis u that rides with `from`.
//
// R is the attitude of `on` relative to `from`, on the axes of `from`. It is a turning about u by the twist angle phi,
// after a swing about an axis across u (the swing-twist decomposition of its quaternion (w, x): tan(phi/2) = u . x/w).
// Without the quaternion, of whose signs two mean the same attitude,
//
//   tan phi = u . a / (tr R - u . R u),      a = (R_zy - R_yz, R_xz - R_zx, R_yx - R_xy),
//
// since 2 (u . x) w = u . a/2 and w^2 - (u . x)^2 = (tr R - u . R u)/2. atan2 gives phi in (-pi, pi]: half a turn from
// where the axes of both bodies coincide the angle jumps, and whoever follows a motion must end it there. With u' = R
// u, the axis as `on` carries it, and W the angular velocity of `on` relative to `from`,
//
//   dphi/dt = g . W,      g = (u + u')/(1 + u . u')      (both on the same axes),
//
// so that the couple on `on` is along g, halfway between the two axes, and u itself where nothing swings:
//
//   -(k (phi - phi_0) + c dphi/dt) g,      V = k (phi - phi_0)^2 / 2,      unstored power = -c (dphi/dt)^2.
//
// A swing by half a turn (u' = -u) leaves phi and g without meaning.
#pragma once

#include <cmath>

#include "poinsot/engine/dynamics/force_law.h"
#include "poinsot/engine/dynamics/place.h"
#include "poinsot/engine/math/algebra/plain.h"

namespace poinsot {

template <class Scalar>
struct TorsionLaw {
  int action = 0;
  int on = ground;
  Direction<Scalar> along;  // u, riding with `from`
  Scalar stiffness{}, free_angle{}, damping{};

  PlacedForce<Scalar> exerted(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    const Vector3<Scalar> none = Vector3<Scalar>::zero();
    const Vector3<Scalar> g = angle_gradient(tree, w);
    Scalar couple = damping * rate_along(w, g);
    if (resists_turning()) couple += stiffness * (angle(tree, w) - free_angle);
    return {none, none, -couple * g};
  }
  Scalar stored_energy(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    if (!resists_turning()) return Scalar(0);
    const Scalar turned = angle(tree, w) - free_angle;
    return Scalar(0.5) * stiffness * turned * turned;
  }
  Scalar unstored_power(const Model<Scalar>& tree, const Workspace<Scalar>& w, int, int) const {
    const Scalar rate = rate_along(w, angle_gradient(tree, w));
    return -damping * rate * rate;
  }
  bool feeds() const { return false; }
  bool drains() const { return !vanishes(damping); }
  bool stores() const { return true; }

  // phi, rad. After update_poses.
  Scalar angle(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    using std::atan2;
    const Vector3<Scalar>& u = along.vector;
    const Matrix3<Scalar> R = transpose(body_rotation(tree, w, along.body)) * body_rotation(tree, w, on);
    const Vector3<Scalar> a{R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)};
    return atan2(dot(u, a), R(0, 0) + R(1, 1) + R(2, 2) - dot(u, R * u));
  }

  template <class Target, class Convert>
  TorsionLaw<Target> converted(const Convert& to) const {
    return {action, on, to(along), to(stiffness), to(free_angle), to(damping)};
  }

 private:
  // g, on ground axes.
  Vector3<Scalar> angle_gradient(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    const Vector3<Scalar> u_from = direction_on_ground(tree, w, along.body, along.vector);
    const Vector3<Scalar> u_on = direction_on_ground(tree, w, on, along.vector);
    return (u_from + u_on) / (Scalar(1) + dot(u_from, u_on));
  }
  // dphi/dt, rad/s.
  Scalar rate_along(const Workspace<Scalar>& w, const Vector3<Scalar>& g) const {
    return dot(g, angular_velocity(w, on) - angular_velocity(w, along.body));
  }
  // A damper alone needs no angle.
  bool resists_turning() const {
    if constexpr (requires(const Scalar& x) { plain(x); }) return !vanishes(stiffness);
    return true;
  }
};

}  // namespace poinsot
