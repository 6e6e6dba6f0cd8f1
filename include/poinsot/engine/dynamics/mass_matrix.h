// The mass matrix M of the coordinates, T = v . M v / 2, by the composite-rigid-body algorithm (Featherstone, 2008,
// chapter 6.2): M_jk = S_j . (I_c S_k), I_c the inertia of all bodies outboard of coordinate k as one rigid body.
//
// The composite inertias stand on the axes of the tree's first body about their bodies' own origins. The products are
// then taken about the origin of the tree's first body, so that one row of M is six vector operations over the
// coordinates inboard, whose motions are kept component by component.
#pragma once

#include <span>

#include "poinsot/engine/dynamics/joint_motion.h"
#include "poinsot/engine/dynamics/workspace.h"

namespace poinsot {

namespace detail {

// The rows of a tree's first body on a ball or free joint: the composite inertia itself, which stands on its axes.
template <class Scalar>
inline void write_inertia(const SpatialInertia<Scalar>& inertia, const Body<Scalar>& body, int n, Scalar* matrix) {
  const Matrix3<Scalar> I = as_matrix(inertia.inertia);
  const Matrix3<Scalar> H = cross_matrix(inertia.first_moment);
  for (int k = 0; k < velocity_size(body.joint); ++k) {
    Scalar* const row = matrix + static_cast<std::size_t>(body.v + k) * static_cast<std::size_t>(n);
    for (int j = 0; j < body.v; ++j) row[j] = Scalar(0);
    Scalar* const own = row + body.v;
    const std::size_t line = static_cast<std::size_t>(k % 3);
    if (k < 3) {
      for (std::size_t j = 0; j <= line; ++j) own[j] = I(line, j);
    } else {
      for (std::size_t j = 0; j < 3; ++j) own[j] = H(j, line);
      for (std::size_t j = 0; j <= line; ++j) own[3 + j] = j == line ? inertia.mass : Scalar(0);
    }
  }
}

}  // namespace detail

// matrix: velocity_size() squared numbers, row after row; the lower triangle with the diagonal is written (zeros where
// two coordinates do not meet), the entries above it are left as they are. Errors: std::invalid_argument if a size is
// wrong.
template <class Scalar>
[[gnu::noinline]] void mass_matrix(const Model<Scalar>& model, Workspace<Scalar>& workspace, std::span<const Scalar> q,
                                   std::span<Scalar> matrix) {
  const int n = model.velocity_size();
  detail::require_size("mass_matrix", "q", q.size(), model.position_size());
  detail::require_size("mass_matrix", "matrix", matrix.size(), n * n);
  CompositeBody<Scalar>* const slots = workspace.composite.data();
  detail::turn_joints(model, workspace, q.data());
  Scalar* __restrict const s0 = workspace.coordinate_motion[0].data();
  Scalar* __restrict const s1 = workspace.coordinate_motion[1].data();
  Scalar* __restrict const s2 = workspace.coordinate_motion[2].data();
  Scalar* __restrict const s3 = workspace.coordinate_motion[3].data();
  Scalar* __restrict const s4 = workspace.coordinate_motion[4].data();
  Scalar* __restrict const s5 = workspace.coordinate_motion[5].data();

  for (int i = 0; i < model.body_count(); ++i) {
    const Body<Scalar>& body = model.body(i);
    const CompositeBody<Scalar>& parent = slots[body.parent + 1];
    CompositeBody<Scalar>& slot = slots[i + 1];
    detail::place_in_tree(workspace, model, body, q.data(), parent.R, slot.R, slot.r);
    slot.from_root = body.parent == ground ? Vector3<Scalar>::zero() : parent.from_root + slot.r;
    slot.inertia = body.parent == ground ? body.inertia : turned(slot.R, body.inertia);
    for (int k = 0; k < velocity_size(body.joint); ++k) {
      const SpatialMotion<Scalar> S = detail::coordinate_motion(body, k, slot.R);
      const Vector3<Scalar> linear = S.linear + cross(slot.from_root, S.angular);
      s0[body.v + k] = S.angular.x;
      s1[body.v + k] = S.angular.y;
      s2[body.v + k] = S.angular.z;
      s3[body.v + k] = linear.x;
      s4[body.v + k] = linear.y;
      s5[body.v + k] = linear.z;
    }
  }

  for (int i = model.body_count() - 1; i >= 0; --i) {
    const Body<Scalar>& body = model.body(i);
    const CompositeBody<Scalar>& slot = slots[i + 1];
    if (body.parent != ground) {
      slots[body.parent + 1].inertia += shifted(slot.inertia, slot.r);
    } else if (body.joint == JointType::ball || body.joint == JointType::free) {
      detail::write_inertia(slot.inertia, body, n, matrix.data());
      continue;
    }
    for (int k = velocity_size(body.joint) - 1; k >= 0; --k) {
      SpatialForce<Scalar> own;
      if (body.joint == JointType::revolute) {
        const Vector3<Scalar> e = detail::z_axis(slot.R);
        own = {slot.inertia.inertia * e, cross(e, slot.inertia.first_moment)};
      } else {
        own = slot.inertia * detail::coordinate_motion(body, k, slot.R);
      }
      const Vector3<Scalar>& f = own.force;
      const Vector3<Scalar> m = own.moment + cross(slot.from_root, f);
      const int row_number = body.v + k;
      Scalar* __restrict const row = matrix.data() + static_cast<std::size_t>(row_number) * static_cast<std::size_t>(n);
      int written = 0;
      for (const typename Model<Scalar>::Run& run : model.moving_coordinates(i)) {
        for (; written < run.first; ++written) row[written] = Scalar(0);
        const int last = run.last <= row_number ? run.last : row_number + 1;
        for (int j = run.first; j < last; ++j) {
          row[j] = s0[j] * m.x + s1[j] * m.y + s2[j] * m.z + s3[j] * f.x + s4[j] * f.y + s5[j] * f.z;
        }
        written = last;
      }
    }
  }
}

// Copies the lower triangle of an n by n matrix to the upper one.
template <class Scalar>
void mirror_lower_triangle(std::span<Scalar> matrix, int n) {
  detail::require_size("mirror_lower_triangle", "matrix", matrix.size(), n * n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) matrix[j * n + i] = matrix[i * n + j];
  }
}

}  // namespace poinsot
