// How a joint places and moves its body: shared by the algorithms of this room.
#pragma once

#include <type_traits>

#include "poinsot/engine/dynamics/workspace.h"
#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/engine/math/algebra/rotation.h"
#include "poinsot/engine/math/algebra/spatial.h"
#include "poinsot/engine/model/model.h"

namespace poinsot::detail {

template <class Scalar>
constexpr Vector3<Scalar> three(const Scalar* x) {
  return {x[0], x[1], x[2]};
}
template <class Scalar>
constexpr Quaternion<Scalar> four(const Scalar* x) {
  return {x[0], x[1], x[2], x[3]};
}
template <class Scalar>
constexpr Vector3<Scalar> z_axis(const Matrix3<Scalar>& R) {
  return {R.row0.z, R.row1.z, R.row2.z};
}

// Sines and cosines of all joint angles, before the bodies are placed.
template <class Scalar>
inline void turn_joints(const Model<Scalar>& model, Workspace<Scalar>& workspace, const Scalar* q) {
  if constexpr (std::is_same_v<Scalar, double>) {
    const auto [first, last] = model.angles();
    sine_cosine_list(q + first, last - first, workspace.sines.data() + first, workspace.cosines.data() + first);
  } else {
    for (const Body<Scalar>& body : model.bodies()) {
      if (body.joint != JointType::revolute && body.joint != JointType::screw) continue;
      const auto [s, c] = sine_cosine(q[body.q]);
      workspace.sines[body.q] = s;
      workspace.cosines[body.q] = c;
    }
  }
}

// The pose of the body's working frame in its parent's: R takes its components to the parent's, p is its origin there.
// After turn_joints.
template <class Scalar>
inline void place_in_parent(const Workspace<Scalar>& workspace, const Body<Scalar>& body, const Scalar* q,
                            Matrix3<Scalar>& R, Vector3<Scalar>& p) {
  const SpatialTransform<Scalar>& X = body.placement;
  switch (body.joint) {
    case JointType::revolute:
      R = turned_about_z(X.R, {workspace.sines[body.q], workspace.cosines[body.q]});
      p = X.p;
      break;
    case JointType::prismatic:
      R = X.R;
      p = X.p + q[body.q] * z_axis(X.R);
      break;
    case JointType::screw:
      R = turned_about_z(X.R, {workspace.sines[body.q], workspace.cosines[body.q]});
      p = X.p + (body.pitch * q[body.q]) * z_axis(X.R);
      break;
    case JointType::ball:
      R = X.R * rotation_matrix(four(q + body.q));
      p = X.p;
      break;
    case JointType::free:
      R = X.R * rotation_matrix(four(q + body.q));
      p = X.p + X.R * three(q + body.q + 4);
      break;
    case JointType::weld:
      R = X.R;
      p = X.p;
      break;
  }
}

// The same on other axes, to which R_parent takes the parent's components: R takes the body's components there, r leads
// from the parent's origin to the body's.
template <class Scalar>
inline void place_on_axes(const Workspace<Scalar>& workspace, const Body<Scalar>& body, const Scalar* q,
                          const Matrix3<Scalar>& R_parent, Matrix3<Scalar>& R, Vector3<Scalar>& r) {
  const SpatialTransform<Scalar>& X = body.placement;
  const Matrix3<Scalar> R_F = R_parent * X.R;
  r = R_parent * X.p;
  switch (body.joint) {
    case JointType::revolute:
      R = turned_about_z(R_F, {workspace.sines[body.q], workspace.cosines[body.q]});
      break;
    case JointType::prismatic:
      R = R_F;
      r += q[body.q] * z_axis(R_F);
      break;
    case JointType::screw:
      R = turned_about_z(R_F, {workspace.sines[body.q], workspace.cosines[body.q]});
      r += (body.pitch * q[body.q]) * z_axis(R_F);
      break;
    case JointType::ball:
      R = R_F * rotation_matrix(four(q + body.q));
      break;
    case JointType::free:
      R = R_F * rotation_matrix(four(q + body.q));
      r += R_F * three(q + body.q + 4);
      break;
    case JointType::weld:
      R = R_F;
      break;
  }
}

// The same on the working axes of the tree's first body, for algorithms whose results do not depend on the axes: the
// first body needs no turning, and the bodies joined to it none but their own.
template <class Scalar>
inline void place_in_tree(const Workspace<Scalar>& workspace, const Model<Scalar>& model, const Body<Scalar>& body,
                          const Scalar* q, const Matrix3<Scalar>& R_parent, Matrix3<Scalar>& R, Vector3<Scalar>& r) {
  if (body.parent == ground) {
    R = Matrix3<Scalar>::identity();
    r = Vector3<Scalar>::zero();
  } else if (model.body(body.parent).parent == ground) {
    place_in_parent(workspace, body, q, R, r);
  } else {
    place_on_axes(workspace, body, q, R_parent, R, r);
  }
}

// The motion of the body per unit of its joint's velocity coordinate k, about its origin on the axes to which R
// takes its components.
template <class Scalar>
inline SpatialMotion<Scalar> coordinate_motion(const Body<Scalar>& body, int k, const Matrix3<Scalar>& R) {
  const Vector3<Scalar> zero = Vector3<Scalar>::zero();
  switch (body.joint) {
    case JointType::revolute:
      return {z_axis(R), zero};
    case JointType::prismatic:
      return {zero, z_axis(R)};
    case JointType::screw:
      return {z_axis(R), body.pitch * z_axis(R)};
    default:
      return k < 3 ? SpatialMotion<Scalar>{R.column(static_cast<std::size_t>(k)), zero}
                   : SpatialMotion<Scalar>{zero, R.column(static_cast<std::size_t>(k - 3))};
  }
}

// The motion of the body relative to its parent for joint velocities v (or accelerations, which are linear alike),
// about its origin on the axes to which R takes its components.
template <class Scalar>
inline SpatialMotion<Scalar> joint_motion(const Body<Scalar>& body, const Scalar* v, const Matrix3<Scalar>& R) {
  const Vector3<Scalar> zero = Vector3<Scalar>::zero();
  switch (body.joint) {
    case JointType::revolute:
      return {v[0] * z_axis(R), zero};
    case JointType::prismatic:
      return {zero, v[0] * z_axis(R)};
    case JointType::screw:
      return {v[0] * z_axis(R), (body.pitch * v[0]) * z_axis(R)};
    case JointType::ball:
      return {R * three(v), zero};
    case JointType::free:
      return {R * three(v), R * three(v + 3)};
    default:
      return {zero, zero};
  }
}

// [alpha]x + [w]x [w]x: times r it is the acceleration of a point at r relative to the origin (a = alpha x r +
// w x (w x r)).
template <class Scalar>
constexpr Matrix3<Scalar> acceleration_matrix(const Vector3<Scalar>& alpha, const Vector3<Scalar>& w) {
  const Scalar xx = w.x * w.x;
  const Scalar yy = w.y * w.y;
  const Scalar zz = w.z * w.z;
  const Scalar xy = w.x * w.y;
  const Scalar yz = w.y * w.z;
  const Scalar zx = w.z * w.x;
  return {{-(yy + zz), xy - alpha.z, zx + alpha.y},
          {xy + alpha.z, -(zz + xx), yz - alpha.x},
          {zx - alpha.y, yz + alpha.x, -(xx + yy)}};
}
// I alpha + w x I w from that matrix and the second moment E = integral of r r^T dm: the axial vector of A E.
template <class Scalar>
constexpr Vector3<Scalar> euler_moment(const Matrix3<Scalar>& A, const SymmetricMatrix3<Scalar>& E) {
  return {
      (A.row2.x * E.xy + A.row2.y * E.yy + A.row2.z * E.yz) - (A.row1.x * E.zx + A.row1.y * E.yz + A.row1.z * E.zz),
      (A.row0.x * E.zx + A.row0.y * E.yz + A.row0.z * E.zz) - (A.row2.x * E.xx + A.row2.y * E.xy + A.row2.z * E.zx),
      (A.row1.x * E.xx + A.row1.y * E.xy + A.row1.z * E.zx) - (A.row0.x * E.xy + A.row0.y * E.yy + A.row0.z * E.yz)};
}

}  // namespace poinsot::detail
