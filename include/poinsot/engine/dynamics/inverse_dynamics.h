// Inverse dynamics: the joint forces that give the coordinates stated accelerations, by the recursive Newton-Euler
// algorithm (Luh, Walker, Paul, 1980) on the bodies' own axes.
//
//   outwards   w = R^T w_p + w_J,  alpha = R^T alpha_p + dw_J + (R^T w_p) x w_J
//              a = R^T (a_p + A_p p) + (joint's own),   A = [alpha]x + [w]x [w]x,  a of the ground = -g
//   body       F = m a + A h                            h = m (mass center)           Eq. 18.1
//              M_O = I_O alpha + w x I_O w + h x a                                    Eqs. 18.2, 18.27
//   inwards    wrench of a joint = that of its body and of the joints outboard, less the external forces
#pragma once

#include <span>

#include "poinsot/engine/dynamics/joint_motion.h"
#include "poinsot/engine/dynamics/workspace.h"

namespace poinsot {

// acceleration, force: one number per velocity coordinate; power of the joints = sum of force times velocity.
// external: one wrench per body, on the body's axes about the body's origin (N m, N), or empty for none.
// Errors: std::invalid_argument if a size is wrong.
template <class Scalar>
[[gnu::noinline]] void inverse_dynamics(const Model<Scalar>& model, Workspace<Scalar>& workspace,
                                        const State<Scalar>& state, std::span<const Scalar> acceleration,
                                        std::span<Scalar> force, std::span<const SpatialForce<Scalar>> external = {}) {
  detail::require_size("inverse_dynamics", "q", state.q.size(), model.position_size());
  detail::require_size("inverse_dynamics", "v", state.v.size(), model.velocity_size());
  detail::require_size("inverse_dynamics", "acceleration", acceleration.size(), model.velocity_size());
  detail::require_size("inverse_dynamics", "force", force.size(), model.velocity_size());
  if (!external.empty()) {
    detail::require_size("inverse_dynamics", "external", external.size(), model.body_count());
  }
  const int count = model.body_count();
  NewtonEulerBody<Scalar>* const slots = workspace.newton_euler.data();
  detail::turn_joints(model, workspace, state.q.data());
  slots[0].a = -model.gravity();
  slots[0].wrench = SpatialForce<Scalar>::zero();

  for (int i = 0; i < count; ++i) {
    const Body<Scalar>& body = model.body(i);
    const NewtonEulerBody<Scalar>& parent = slots[body.parent + 1];
    NewtonEulerBody<Scalar>& slot = slots[i + 1];
    const Scalar* const qd = state.v.data() + body.v;
    const Scalar* const qdd = acceleration.data() + body.v;
    detail::place_in_parent(workspace, body, state.q.data(), slot.R, slot.p);

    // The parent's motion carried to this body.
    Vector3<Scalar> w = transpose_times(slot.R, parent.w);
    Vector3<Scalar> alpha = transpose_times(slot.R, parent.alpha);
    Vector3<Scalar> a = transpose_times(slot.R, parent.a + parent.A * slot.p);
    const Scalar two(2);
    switch (body.joint) {
      case JointType::screw:
        a.x += two * body.pitch * qd[0] * w.y;
        a.y -= two * body.pitch * qd[0] * w.x;
        a.z += body.pitch * qdd[0];
        [[fallthrough]];
      case JointType::revolute:
        alpha.x += w.y * qd[0];
        alpha.y -= w.x * qd[0];
        alpha.z += qdd[0];
        w.z += qd[0];
        break;
      case JointType::prismatic:
        a.x += two * qd[0] * w.y;
        a.y -= two * qd[0] * w.x;
        a.z += qdd[0];
        break;
      case JointType::free: {
        const Vector3<Scalar> v_J = detail::three(qd + 3);
        a += detail::three(qdd + 3) + cross(two * w + detail::three(qd), v_J);
        [[fallthrough]];
      }
      case JointType::ball: {
        const Vector3<Scalar> w_J = detail::three(qd);
        alpha += detail::three(qdd) + cross(w, w_J);
        w += w_J;
        break;
      }
      case JointType::weld:
        break;
    }
    slot.w = w;
    slot.alpha = alpha;
    slot.a = a;
    slot.A = detail::acceleration_matrix(alpha, w);

    // Force and moment that the motion takes.
    const Vector3<Scalar>& h = body.inertia.first_moment;
    slot.wrench.force = body.inertia.mass * a + slot.A * h;
    slot.wrench.moment = detail::euler_moment(slot.A, body.second_moment) + cross(h, a);
  }
  if (!external.empty()) {
    for (int i = 0; i < count; ++i) {
      const Matrix3<Scalar>& R = model.body(i).R_WB;
      slots[i + 1].wrench.moment -= R * external[i].moment;
      slots[i + 1].wrench.force -= R * external[i].force;
    }
  }

  for (int i = count - 1; i >= 0; --i) {
    const Body<Scalar>& body = model.body(i);
    const NewtonEulerBody<Scalar>& slot = slots[i + 1];
    NewtonEulerBody<Scalar>& parent = slots[body.parent + 1];
    const Vector3<Scalar>& n = slot.wrench.moment;
    const Vector3<Scalar>& f = slot.wrench.force;
    Scalar* const tau = force.data() + body.v;
    switch (body.joint) {
      case JointType::revolute:
        tau[0] = n.z;
        break;
      case JointType::prismatic:
        tau[0] = f.z;
        break;
      case JointType::screw:
        tau[0] = n.z + body.pitch * f.z;
        break;
      case JointType::free:
        tau[3] = f.x;
        tau[4] = f.y;
        tau[5] = f.z;
        [[fallthrough]];
      case JointType::ball:
        tau[0] = n.x;
        tau[1] = n.y;
        tau[2] = n.z;
        break;
      case JointType::weld:
        break;
    }
    const Vector3<Scalar> carried = slot.R * f;
    parent.wrench.force += carried;
    parent.wrench.moment += slot.R * n + cross(slot.p, carried);
  }
}

// After inverse_dynamics: the wrench that the parent exerts on the body through its joint, about the body's origin on
// the body's axes (N m, N).
template <class Scalar>
SpatialForce<Scalar> joint_wrench(const Model<Scalar>& model, const Workspace<Scalar>& workspace, int body) {
  const SpatialForce<Scalar>& wrench = workspace.newton_euler[body + 1].wrench;
  const Matrix3<Scalar>& R = model.body(body).R_WB;
  return {transpose_times(R, wrench.moment), transpose_times(R, wrench.force)};
}

// After inverse_dynamics: the wrench that the ground exerts on all trees together, about the ground's origin on ground
// axes (N m, N).
template <class Scalar>
SpatialForce<Scalar> ground_wrench(const Workspace<Scalar>& workspace) {
  return workspace.newton_euler[0].wrench;
}

}  // namespace poinsot
