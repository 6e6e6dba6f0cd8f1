// Poses, velocities and accelerations of the bodies and of their points, and the Jacobians of points and directions.
//
// update_poses, update_velocities or update_accelerations fill the workspace; the questions below read it. Points are
// given on the body's axes from the body's origin, answers stand on ground axes from the ground's origin. The body
// `ground` (-1) may be asked too: it rests at the origin.
#pragma once

#include <algorithm>
#include <span>

#include "poinsot/engine/dynamics/joint_motion.h"
#include "poinsot/engine/dynamics/workspace.h"

namespace poinsot {

namespace detail {

enum class MotionLevel { pose, velocity, acceleration };

template <MotionLevel Level, class Scalar>
[[gnu::noinline]] void update_motion(const Model<Scalar>& model, Workspace<Scalar>& workspace, const Scalar* q,
                                     const Scalar* v, const Scalar* acceleration) {
  BodyMotion<Scalar>* const slots = workspace.motion.data();
  turn_joints(model, workspace, q);
  std::copy_n(q, workspace.q.size(), workspace.q.begin());
  if constexpr (Level != MotionLevel::pose) std::copy_n(v, workspace.v.size(), workspace.v.begin());
  for (int i = 0; i < model.body_count(); ++i) {
    const Body<Scalar>& body = model.body(i);
    const BodyMotion<Scalar>& parent = slots[body.parent + 1];
    BodyMotion<Scalar>& slot = slots[i + 1];
    Vector3<Scalar> r;
    if (body.parent == ground) {
      place_in_parent(workspace, body, q, slot.R, r);
    } else {
      place_on_axes(workspace, body, q, parent.R, slot.R, r);
    }
    slot.p = parent.p + r;
    if constexpr (Level != MotionLevel::pose) {
      // Velocity of the parent's point at this origin, and of this body relative to it.
      const SpatialMotion<Scalar> own = joint_motion(body, v + body.v, slot.R);
      const Vector3<Scalar> swept = cross(parent.w, r);
      slot.w = parent.w + own.angular;
      slot.v = parent.v + swept + own.linear;
      if constexpr (Level == MotionLevel::acceleration) {
        // a = a_p + alpha_p x r + w_p x (w_p x r) + (2 w_p + w_J) x v_J + dv_J.
        const SpatialMotion<Scalar> gained = joint_motion(body, acceleration + body.v, slot.R);
        slot.alpha = parent.alpha + cross(parent.w, own.angular) + gained.angular;
        slot.a = parent.a + cross(parent.alpha, r) + cross(parent.w, swept) + cross(parent.w + slot.w, own.linear) +
                 gained.linear;
      }
    }
  }
}

}  // namespace detail

// Poses only. q: position_size() numbers. Errors: std::invalid_argument if a size is wrong, as for those below.
template <class Scalar>
void update_poses(const Model<Scalar>& model, Workspace<Scalar>& workspace, std::span<const Scalar> q) {
  detail::require_size("update_poses", "q", q.size(), model.position_size());
  detail::update_motion<detail::MotionLevel::pose, Scalar>(model, workspace, q.data(), nullptr, nullptr);
}
// Poses and velocities.
template <class Scalar>
void update_velocities(const Model<Scalar>& model, Workspace<Scalar>& workspace, const State<Scalar>& state) {
  detail::require_size("update_velocities", "q", state.q.size(), model.position_size());
  detail::require_size("update_velocities", "v", state.v.size(), model.velocity_size());
  detail::update_motion<detail::MotionLevel::velocity, Scalar>(model, workspace, state.q.data(), state.v.data(),
                                                               nullptr);
}
// Poses, velocities and accelerations. acceleration: of the velocity coordinates.
template <class Scalar>
void update_accelerations(const Model<Scalar>& model, Workspace<Scalar>& workspace, const State<Scalar>& state,
                          std::span<const Scalar> acceleration) {
  detail::require_size("update_accelerations", "q", state.q.size(), model.position_size());
  detail::require_size("update_accelerations", "v", state.v.size(), model.velocity_size());
  detail::require_size("update_accelerations", "acceleration", acceleration.size(), model.velocity_size());
  detail::update_motion<detail::MotionLevel::acceleration, Scalar>(model, workspace, state.q.data(), state.v.data(),
                                                                   acceleration.data());
}

// R_GB, components on the body's axes to ground axes.
template <class Scalar>
Matrix3<Scalar> body_rotation(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body) {
  const Matrix3<Scalar>& R = workspace.motion[body + 1].R;
  return body == ground ? R : R * model.body(body).R_WB;
}
// The body frame's pose in the ground frame.
template <class Scalar>
SpatialTransform<Scalar> body_pose(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body) {
  return {body_rotation(model, workspace, body), workspace.motion[body + 1].p};
}
// A vector's ground components from those on the body's axes.
template <class Scalar>
Vector3<Scalar> direction_on_ground(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body,
                                    const Vector3<Scalar>& direction_B) {
  const Matrix3<Scalar>& R = workspace.motion[body + 1].R;
  return body == ground ? R * direction_B : R * (model.body(body).R_WB * direction_B);
}
// A vector's components on the body's axes from those on ground axes.
template <class Scalar>
Vector3<Scalar> direction_on_body(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body,
                                  const Vector3<Scalar>& direction_G) {
  const Vector3<Scalar> working = transpose_times(workspace.motion[body + 1].R, direction_G);
  return body == ground ? working : transpose_times(model.body(body).R_WB, working);
}
// Where a point of the body is, m.
template <class Scalar>
Vector3<Scalar> point_position(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body,
                               const Vector3<Scalar>& point_B) {
  return workspace.motion[body + 1].p + direction_on_ground(model, workspace, body, point_B);
}
// Its velocity, m/s.
template <class Scalar>
Vector3<Scalar> point_velocity(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body,
                               const Vector3<Scalar>& point_B) {
  const BodyMotion<Scalar>& motion = workspace.motion[body + 1];
  return motion.v + cross(motion.w, direction_on_ground(model, workspace, body, point_B));
}
// Its acceleration, m/s^2.
template <class Scalar>
Vector3<Scalar> point_acceleration(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body,
                                   const Vector3<Scalar>& point_B) {
  const BodyMotion<Scalar>& motion = workspace.motion[body + 1];
  const Vector3<Scalar> r = direction_on_ground(model, workspace, body, point_B);
  return motion.a + cross(motion.alpha, r) + cross(motion.w, cross(motion.w, r));
}
// Angular velocity, rad/s, and acceleration, rad/s^2, on ground axes.
template <class Scalar>
const Vector3<Scalar>& angular_velocity(const Workspace<Scalar>& workspace, int body) {
  return workspace.motion[body + 1].w;
}
template <class Scalar>
const Vector3<Scalar>& angular_acceleration(const Workspace<Scalar>& workspace, int body) {
  return workspace.motion[body + 1].alpha;
}

// A force (N, ground axes) at a point of the body (body axes) as the external wrench that the dynamics take: on the
// body's axes about the body's origin.
template <class Scalar>
SpatialForce<Scalar> wrench_of_force(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body,
                                     const Vector3<Scalar>& point_B, const Vector3<Scalar>& force_G) {
  const Vector3<Scalar> force_B = direction_on_body(model, workspace, body, force_G);
  return {cross(point_B, force_B), force_B};
}

// Calls visit(k, motion) for each velocity coordinate k that moves the body, in descending order: motion is that of the
// body per unit of the coordinate, on ground axes about the ground point p (m). After update_poses.
template <class Scalar, class Visit>
void for_each_coordinate_motion(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body,
                                const Vector3<Scalar>& p, Visit visit) {
  for (int i = body; i != ground; i = model.body(i).parent) {
    const Body<Scalar>& moved = model.body(i);
    const BodyMotion<Scalar>& motion = workspace.motion[i + 1];
    for (int k = velocity_size(moved.joint) - 1; k >= 0; --k) {
      SpatialMotion<Scalar> S = detail::coordinate_motion(moved, k, motion.R);
      S.linear += cross(S.angular, p - motion.p);
      visit(moved.v + k, S);
    }
  }
}

// J with velocity of the point = J v: 3 rows of velocity_size() numbers, row after row.
template <class Scalar>
void point_jacobian(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body,
                    const Vector3<Scalar>& point_B, std::span<Scalar> jacobian) {
  const int n = model.velocity_size();
  detail::require_size("point_jacobian", "jacobian", jacobian.size(), 3 * n);
  for (Scalar& entry : jacobian) entry = Scalar(0);
  for_each_coordinate_motion(model, workspace, body, point_position(model, workspace, body, point_B),
                             [&](int k, const SpatialMotion<Scalar>& S) {
                               jacobian[k] = S.linear.x;
                               jacobian[n + k] = S.linear.y;
                               jacobian[2 * n + k] = S.linear.z;
                             });
}
// J with angular velocity of the body = J v: the same layout.
template <class Scalar>
void angular_jacobian(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body,
                      std::span<Scalar> jacobian) {
  const int n = model.velocity_size();
  detail::require_size("angular_jacobian", "jacobian", jacobian.size(), 3 * n);
  for (Scalar& entry : jacobian) entry = Scalar(0);
  for_each_coordinate_motion(model, workspace, body, workspace.motion[body + 1].p,
                             [&](int k, const SpatialMotion<Scalar>& S) {
                               jacobian[k] = S.angular.x;
                               jacobian[n + k] = S.angular.y;
                               jacobian[2 * n + k] = S.angular.z;
                             });
}

}  // namespace poinsot
