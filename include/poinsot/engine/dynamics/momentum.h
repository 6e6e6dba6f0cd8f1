// Momenta, their rates and the energies of the bodies, after update_velocities or, for rates, update_accelerations
// (kinematics.h). All on ground axes.
//
//   L = m v_G,  H_P = r_G/P x m v_G + I_G w (Eq. 18.11),  T = (m v_G^2 + w . I_G w)/2 (Eq. 18.17),  V = -m g . r_G
//   dL/dt = m a_G (Eq. 18.1),  dH_G/dt = I_G alpha + w x I_G w (Eqs. 18.2, 18.22 with W = w)
#pragma once

#include "poinsot/engine/dynamics/kinematics.h"

namespace poinsot {

// A momentum or its rate: linear (kg m/s or N) and angular about a stated point (kg m^2/s or N m).
template <class Scalar>
struct Momentum {
  Vector3<Scalar> linear{};
  Vector3<Scalar> angular{};

  Momentum& operator+=(const Momentum& b) {
    linear += b.linear;
    angular += b.angular;
    return *this;
  }
};

// The same momentum about a point from which its old point is at r (m): H' = H + r x L.
template <class Scalar>
Momentum<Scalar> moved(const Momentum<Scalar>& momentum, const Vector3<Scalar>& r) {
  return {momentum.linear, momentum.angular + cross(r, momentum.linear)};
}

namespace detail {

// About the body's own origin, so that no large position enters.
template <class Scalar>
Momentum<Scalar> momentum_about_origin(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body) {
  const BodyMotion<Scalar>& motion = workspace.motion[body + 1];
  const SpatialInertia<Scalar>& I = model.body(body).inertia;
  const Vector3<Scalar> h = motion.R * I.first_moment;
  const Vector3<Scalar> spin = motion.R * (I.inertia * transpose_times(motion.R, motion.w));
  return {I.mass * motion.v + cross(motion.w, h), spin + cross(h, motion.v)};
}

}  // namespace detail

// Momentum of one body about the ground point p.
template <class Scalar>
Momentum<Scalar> body_momentum(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body,
                               const Vector3<Scalar>& p) {
  return moved(detail::momentum_about_origin(model, workspace, body), workspace.motion[body + 1].p - p);
}
// Momentum of all bodies about the ground point p.
template <class Scalar>
Momentum<Scalar> momentum(const Model<Scalar>& model, const Workspace<Scalar>& workspace, const Vector3<Scalar>& p) {
  Momentum<Scalar> sum{Vector3<Scalar>::zero(), Vector3<Scalar>::zero()};
  for (int i = 0; i < model.body_count(); ++i) sum += body_momentum(model, workspace, i, p);
  return sum;
}

// Rate of one body's momentum about the ground point p: the forces on it add up to its linear part, their moments about
// p to its angular part. With p where G is now, m a_G and dH_G/dt: the vectors of the kinetic diagram.
template <class Scalar>
Momentum<Scalar> body_momentum_rate(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body,
                                    const Vector3<Scalar>& p) {
  const BodyMotion<Scalar>& motion = workspace.motion[body + 1];
  const SpatialInertia<Scalar>& I = model.body(body).inertia;
  const Vector3<Scalar> h = motion.R * I.first_moment;
  const Vector3<Scalar> w_B = transpose_times(motion.R, motion.w);
  const Vector3<Scalar> alpha_B = transpose_times(motion.R, motion.alpha);
  const Vector3<Scalar> euler = motion.R * (I.inertia * alpha_B + cross(w_B, I.inertia * w_B));
  const Vector3<Scalar> force = I.mass * motion.a + cross(motion.alpha, h) + cross(motion.w, cross(motion.w, h));
  return moved(Momentum<Scalar>{force, euler + cross(h, motion.a)}, motion.p - p);
}
// Rate of the momentum of all bodies about the ground point p.
template <class Scalar>
Momentum<Scalar> momentum_rate(const Model<Scalar>& model, const Workspace<Scalar>& workspace,
                               const Vector3<Scalar>& p) {
  Momentum<Scalar> sum{Vector3<Scalar>::zero(), Vector3<Scalar>::zero()};
  for (int i = 0; i < model.body_count(); ++i) sum += body_momentum_rate(model, workspace, i, p);
  return sum;
}

// Kinetic energy of one body, J.
template <class Scalar>
Scalar body_kinetic_energy(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body) {
  const BodyMotion<Scalar>& motion = workspace.motion[body + 1];
  const Momentum<Scalar> own = detail::momentum_about_origin(model, workspace, body);
  return Scalar(0.5) * (dot(motion.w, own.angular) + dot(motion.v, own.linear));
}
// Kinetic energy of all bodies, J.
template <class Scalar>
Scalar kinetic_energy(const Model<Scalar>& model, const Workspace<Scalar>& workspace) {
  Scalar sum(0);
  for (int i = 0; i < model.body_count(); ++i) sum += body_kinetic_energy(model, workspace, i);
  return sum;
}
// Potential energy of the weights, zero with all mass at the ground's origin, J. After update_poses.
template <class Scalar>
Scalar potential_energy(const Model<Scalar>& model, const Workspace<Scalar>& workspace) {
  Vector3<Scalar> moment = Vector3<Scalar>::zero();
  for (int i = 0; i < model.body_count(); ++i) {
    const BodyMotion<Scalar>& motion = workspace.motion[i + 1];
    const SpatialInertia<Scalar>& I = model.body(i).inertia;
    moment += I.mass * motion.p + motion.R * I.first_moment;
  }
  return -dot(model.gravity(), moment);
}
// Mass of all bodies, kg.
template <class Scalar>
Scalar total_mass(const Model<Scalar>& model) {
  Scalar sum(0);
  for (const Body<Scalar>& body : model.bodies()) sum += body.inertia.mass;
  return sum;
}
// Mass center of one body or of all, m; not finite without mass. After update_poses.
template <class Scalar>
Vector3<Scalar> body_mass_center(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body) {
  const BodyMotion<Scalar>& motion = workspace.motion[body + 1];
  const SpatialInertia<Scalar>& I = model.body(body).inertia;
  return motion.p + (motion.R * I.first_moment) / I.mass;
}
template <class Scalar>
Vector3<Scalar> mass_center(const Model<Scalar>& model, const Workspace<Scalar>& workspace) {
  Vector3<Scalar> moment = Vector3<Scalar>::zero();
  for (int i = 0; i < model.body_count(); ++i) {
    const BodyMotion<Scalar>& motion = workspace.motion[i + 1];
    const SpatialInertia<Scalar>& I = model.body(i).inertia;
    moment += I.mass * motion.p + motion.R * I.first_moment;
  }
  return moment / total_mass(model);
}

}  // namespace poinsot
