// How joint forces and accelerations change with the state, and joint forces with the masses of the bodies.
//
// Positions are displaced as velocities displace them: the derivative by coordinate k is that along the motion in which
// its velocity alone is 1 (joint.h), so that there are as many as velocities. All is said of a tree about the place
// that the origin of its first body has at the instant, on the axes of that body, and with gravity as an acceleration
// of the ground: a body's motion is v, its acceleration a, and displaced along coordinate k of body i it carries along
//
//   the field        S                                           its points move by S
//   its velocities   S' = v_p x S                                and as S is carried by the parent's motion v_p
//   accelerations    S" = a_p x S + v_p x S'
//
// What the particles of a body need for that, besides the inertia I, is the force 2 w x m r' in a field with the turn
// w: B X = (sum of r x (w x m r'), sum of w x m r') = (G w, w x L), with L the momentum, G = trace(D) - D, and D = sum
// of m r' r^T. Of all bodies outboard of i together, with their wrench f (Singh, Russo and Wensing 2022):
//
//   d tau_i / d q_j = S_i . (2 B S'_j + I S"_j)           d tau_j / d q_i = S_j . (2 B S'_i + I S"_i + S_i x* f)
//   d tau_i / d v_j = S_i . (2 B S_j + I (S'_j + v_j x S_j))                  j = i, or j inboard of i
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/joint_motion.h"
#include "poinsot/engine/dynamics/workspace.h"

namespace poinsot {

namespace detail {

// A body while slopes are found, with all that is outboard of it.
template <class Scalar>
struct SlopedBody {
  Matrix3<Scalar> R{};
  Vector3<Scalar> r{};  // from its parent's origin to its own, m
  Vector3<Scalar> from_root{};
  SpatialMotion<Scalar> v{}, a{};
  SpatialInertia<Scalar> inertia{};
  SpatialForce<Scalar> wrench{};
  Vector3<Scalar> momentum{};  // L, kg m/s
  Matrix3<Scalar> moments{};   // G, kg m^2/s
};

}  // namespace detail

// The memory for the derivatives of a model: made once, they allocate nothing.
template <class Scalar>
struct DerivativesWorkspace {
  explicit DerivativesWorkspace(const Model<Scalar>& model)
      : joints(model), bodies(model.body_count() + 1), motions(model.velocity_size()) {
    for (std::vector<Scalar>& component : fields) component.resize(model.velocity_size());
    acceleration.resize(model.velocity_size());
    factor.resize(static_cast<std::size_t>(model.velocity_size()) * static_cast<std::size_t>(model.velocity_size()));
    bodies[0].R = Matrix3<Scalar>::identity();
  }

  struct CoordinateMotion {
    SpatialMotion<Scalar> S{}, velocities{}, accelerations{};
  };
  Workspace<Scalar> joints;
  std::vector<detail::SlopedBody<Scalar>> bodies;  // slot 0 is the ground, slot i + 1 body i
  std::vector<CoordinateMotion> motions;           // of each velocity coordinate
  // The same, component by component: S, S' + v x S, S", and the turn of S'.
  std::array<std::vector<Scalar>, 21> fields;
  std::vector<Scalar> acceleration;  // found by forward_dynamics_derivatives
  std::vector<Scalar> factor;        // of the mass matrix
};

// Where derivatives are written: velocity_size() squared numbers each, row after row, a row for each force and a column
// for each coordinate.
template <class Scalar>
struct ForceDerivatives {
  std::span<Scalar> by_position, by_velocity, by_acceleration;  // the last is the mass matrix
};

namespace detail {

template <class Scalar>
struct FieldRows {
  Scalar *S[6], *rates[6], *accelerations[6], *turns[3];

  explicit FieldRows(DerivativesWorkspace<Scalar>& workspace) {
    for (std::size_t c = 0; c < 6; ++c) {
      S[c] = workspace.fields[c].data();
      rates[c] = workspace.fields[6 + c].data();
      accelerations[c] = workspace.fields[12 + c].data();
      if (c < 3) turns[c] = workspace.fields[18 + c].data();
    }
  }
};

template <class Scalar>
void put_components(Scalar* const (&rows)[6], int k, const SpatialMotion<Scalar>& m) {
  rows[0][k] = m.angular.x;
  rows[1][k] = m.angular.y;
  rows[2][k] = m.angular.z;
  rows[3][k] = m.linear.x;
  rows[4][k] = m.linear.y;
  rows[5][k] = m.linear.z;
}

// m . f of coordinate j.
template <class Scalar>
[[gnu::always_inline]] inline Scalar component_dot(Scalar* const (&rows)[6], int j, const SpatialForce<Scalar>& f) {
  return rows[0][j] * f.moment.x + rows[1][j] * f.moment.y + rows[2][j] * f.moment.z + rows[3][j] * f.force.x +
         rows[4][j] * f.force.y + rows[5][j] * f.force.z;
}
template <class Scalar>
[[gnu::always_inline]] inline Scalar component_dot(Scalar* const (&rows)[3], int j, const Vector3<Scalar>& y) {
  return rows[0][j] * y.x + rows[1][j] * y.y + rows[2][j] * y.z;
}

// Motions of all bodies, and what each has by itself.
template <class Scalar>
[[gnu::noinline]] void sloped_outwards(const Model<Scalar>& model, DerivativesWorkspace<Scalar>& workspace,
                                       const State<Scalar>& state, std::span<const Scalar> acceleration) {
  SlopedBody<Scalar>* const slots = workspace.bodies.data();
  FieldRows<Scalar> rows(workspace);
  turn_joints(model, workspace.joints, state.q.data());
  for (int i = 0; i < model.body_count(); ++i) {
    const Body<Scalar>& body = model.body(i);
    const SlopedBody<Scalar>& parent = slots[body.parent + 1];
    SlopedBody<Scalar>& slot = slots[i + 1];
    place_in_tree(workspace.joints, model, body, state.q.data(), parent.R, slot.R, slot.r);
    const bool first = body.parent == ground;
    SpatialMotion<Scalar> v = parent.v, a = parent.a;
    if (first) {
      Matrix3<Scalar> R;
      Vector3<Scalar> p;
      place_in_parent(workspace.joints, body, state.q.data(), R, p);
      v = SpatialMotion<Scalar>::zero();
      a = {Vector3<Scalar>::zero(), transpose_times(R, -model.gravity())};
      slot.from_root = Vector3<Scalar>::zero();
    } else {
      slot.from_root = parent.from_root + slot.r;
    }
    slot.v = v;
    slot.a = a;
    for (int c = 0; c < velocity_size(body.joint); ++c) {
      const int k = body.v + c;
      auto& [S, velocities, accelerations] = workspace.motions[k];
      S = coordinate_motion(body, c, slot.R);
      S.linear += cross(slot.from_root, S.angular);
      velocities = cross_motion(v, S);
      accelerations = cross_motion(a, S) + cross_motion(v, velocities);
      slot.v += state.v[k] * S;
      slot.a += acceleration[k] * S + state.v[k] * velocities;
      put_components(rows.S, k, S);
      put_components(rows.accelerations, k, accelerations);
      rows.turns[0][k] = velocities.angular.x;
      rows.turns[1][k] = velocities.angular.y;
      rows.turns[2][k] = velocities.angular.z;
    }
    for (int c = 0; c < velocity_size(body.joint); ++c) {
      const auto& motion = workspace.motions[body.v + c];
      put_components(rows.rates, body.v + c, motion.velocities + cross_motion(slot.v, motion.S));
    }

    slot.inertia = shifted(first ? body.inertia : turned(slot.R, body.inertia), slot.from_root);
    const SpatialForce<Scalar> momentum = slot.inertia * slot.v;
    slot.wrench = slot.inertia * slot.a + cross_force(slot.v, momentum);
    slot.momentum = momentum.force;
    // D = v_O h^T + [w]x J, with h and J = trace(I)/2 - I the first and second moments of mass.
    const SymmetricMatrix3<Scalar>& I = slot.inertia.inertia;
    const Scalar half_trace = Scalar(0.5) * (I.xx + I.yy + I.zz);
    const Matrix3<Scalar> J{
        {half_trace - I.xx, -I.xy, -I.zx}, {-I.xy, half_trace - I.yy, -I.yz}, {-I.zx, -I.yz, half_trace - I.zz}};
    const Vector3<Scalar>& h = slot.inertia.first_moment;
    const Vector3<Scalar>& u = slot.v.linear;
    const Matrix3<Scalar> D = Matrix3<Scalar>{u.x * h, u.y * h, u.z * h} + cross_matrix(slot.v.angular) * J;
    const Scalar trace = D.row0.x + D.row1.y + D.row2.z;
    slot.moments = {{trace - D.row0.x, -D.row0.y, -D.row0.z},
                    {-D.row1.x, trace - D.row1.y, -D.row1.z},
                    {-D.row2.x, -D.row2.y, trace - D.row2.z}};
  }
}

// 2 B X.
template <class Scalar>
SpatialForce<Scalar> doubled_bias(const SlopedBody<Scalar>& outboard, const SpatialMotion<Scalar>& X) {
  const Scalar two(2);
  return {two * (outboard.moments * X.angular), two * cross(X.angular, outboard.momentum)};
}

}  // namespace detail

// acceleration: one number for each velocity coordinate. Not differentiated by: external wrenches, of which there are
// none. Errors: std::invalid_argument if a size is wrong.
template <class Scalar>
[[gnu::noinline]] void inverse_dynamics_derivatives(const Model<Scalar>& model, DerivativesWorkspace<Scalar>& workspace,
                                                    const State<Scalar>& state, std::span<const Scalar> acceleration,
                                                    const ForceDerivatives<Scalar>& derivatives) {
  const int n = model.velocity_size();
  const char* const name = "inverse_dynamics_derivatives";
  detail::require_size(name, "q", state.q.size(), model.position_size());
  detail::require_size(name, "v", state.v.size(), n);
  detail::require_size(name, "acceleration", acceleration.size(), n);
  detail::require_size(name, "by_position", derivatives.by_position.size(), n * n);
  detail::require_size(name, "by_velocity", derivatives.by_velocity.size(), n * n);
  detail::require_size(name, "by_acceleration", derivatives.by_acceleration.size(), n * n);
  detail::sloped_outwards(model, workspace, state, acceleration);

  Scalar* const by_q = derivatives.by_position.data();
  Scalar* const by_v = derivatives.by_velocity.data();
  Scalar* const by_a = derivatives.by_acceleration.data();
  for (std::size_t i = 0; i < derivatives.by_position.size(); ++i) by_q[i] = by_v[i] = by_a[i] = Scalar(0);
  const detail::FieldRows<Scalar> rows(workspace);
  for (int i = model.body_count() - 1; i >= 0; --i) {
    const Body<Scalar>& body = model.body(i);
    const detail::SlopedBody<Scalar>& slot = workspace.bodies[i + 1];
    for (int k = body.v; k < body.v + velocity_size(body.joint); ++k) {
      const auto& [S, velocities, accelerations] = workspace.motions[k];
      const SpatialMotion<Scalar> rates{{rows.rates[0][k], rows.rates[1][k], rows.rates[2][k]},
                                        {rows.rates[3][k], rows.rates[4][k], rows.rates[5][k]}};
      const SpatialForce<Scalar> IS = slot.inertia * S;
      const SpatialForce<Scalar> moved = detail::doubled_bias(slot, S) + slot.inertia * rates;
      const SpatialForce<Scalar> displaced =
          detail::doubled_bias(slot, velocities) + slot.inertia * accelerations + cross_force(S, slot.wrench);
      // S . 2 B X = y . (the turn of X).
      const Vector3<Scalar> y = Scalar(2) * (transpose_times(slot.moments, S.angular) + cross(slot.momentum, S.linear));
      Scalar* const row_q = by_q + k * n;
      Scalar* const row_v = by_v + k * n;
      Scalar* const row_a = by_a + k * n;
      for (const typename Model<Scalar>::Run& run : model.moving_coordinates(i)) {
        for (int j = run.first; j < run.last; ++j) {
          row_q[j] = detail::component_dot(rows.turns, j, y) + detail::component_dot(rows.accelerations, j, IS);
          row_v[j] =
              detail::component_dot({rows.S[0], rows.S[1], rows.S[2]}, j, y) + detail::component_dot(rows.rates, j, IS);
          row_a[j] = detail::component_dot(rows.S, j, IS);
        }
        for (int j = run.first; j < run.last && j < body.v; ++j) {
          by_q[j * n + k] = detail::component_dot(rows.S, j, displaced);
          by_v[j * n + k] = detail::component_dot(rows.S, j, moved);
          by_a[j * n + k] = row_a[j];
        }
      }
    }
    if (body.parent == ground) continue;
    detail::SlopedBody<Scalar>& parent = workspace.bodies[body.parent + 1];
    parent.inertia += slot.inertia;
    parent.wrench += slot.wrench;
    parent.momentum += slot.momentum;
    parent.moments = parent.moments + slot.moments;
  }
}

// Where derivatives of accelerations are written: a row for each acceleration and a column for each coordinate.
template <class Scalar>
struct AccelerationDerivatives {
  std::span<Scalar> by_position, by_velocity, by_force;  // the last is the inverse of the mass matrix
};

namespace detail {

// Calls visit(j) for each velocity coordinate j before k that moves the body.
template <class Scalar, class Visit>
void for_each_inboard(const Model<Scalar>& model, int body, int k, Visit visit) {
  for (const typename Model<Scalar>::Run& run : model.moving_coordinates(body))
    for (int j = run.first; j < std::min(run.last, k); ++j) visit(j);
}

// M = L^T D L with the zeros of the tree kept (Featherstone 2008, chapter 6.5): L below the diagonal, D on it.
template <class Scalar>
void factor_by_tree(const Model<Scalar>& model, std::span<Scalar> M) {
  const int n = model.velocity_size();
  for (int body = model.body_count() - 1; body >= 0; --body)
    for (int c = velocity_size(model.body(body).joint) - 1; c >= 0; --c) {
      const int k = model.body(body).v + c;
      Scalar* const row = M.data() + k * n;
      const Scalar inverse = Scalar(1) / row[k];
      for_each_inboard(model, body, k, [&](int i) {
        const Scalar part = row[i] * inverse;
        for_each_inboard(model, body, i + 1, [&](int j) { M[i * n + j] -= part * row[j]; });
      });
      for_each_inboard(model, body, k, [&](int i) { row[i] *= inverse; });
    }
}

// X becomes M^-1 X; row after row, of `columns` numbers each.
template <class Scalar>
void solve_by_tree(const Model<Scalar>& model, std::span<const Scalar> factor, std::span<Scalar> X, int columns) {
  const int n = model.velocity_size();
  const auto subtract = [&](int from, const Scalar& part, int row) {
    Scalar* __restrict const to = X.data() + from * columns;
    const Scalar* __restrict const own = X.data() + row * columns;
    for (int c = 0; c < columns; ++c) to[c] -= part * own[c];
  };
  for (int body = model.body_count() - 1; body >= 0; --body)
    for (int c = velocity_size(model.body(body).joint) - 1; c >= 0; --c) {
      const int k = model.body(body).v + c;
      for_each_inboard(model, body, k, [&](int j) { subtract(j, factor[k * n + j], k); });
    }
  for (int body = 0; body < model.body_count(); ++body)
    for (int c = 0; c < velocity_size(model.body(body).joint); ++c) {
      const int k = model.body(body).v + c;
      const Scalar inverse = Scalar(1) / factor[k * n + k];
      for (int column = 0; column < columns; ++column) X[k * columns + column] *= inverse;
      for_each_inboard(model, body, k, [&](int j) { subtract(k, factor[k * n + j], j); });
    }
}

}  // namespace detail

// force: one number for each velocity coordinate; all modes are taken as free. The accelerations are left in the
// workspace. From M a + h = tau, where inverse dynamics at a fixed a gives what h and M a change by: da = M^-1 (d tau -
// d_fixed tau). Not finite where forward_dynamics is not, and where a coordinate moves massless bodies only. Errors:
// std::invalid_argument if a size is wrong.
template <class Scalar>
void forward_dynamics_derivatives(const Model<Scalar>& model, DerivativesWorkspace<Scalar>& workspace,
                                  const State<Scalar>& state, std::span<const Scalar> force,
                                  const AccelerationDerivatives<Scalar>& derivatives) {
  const int n = model.velocity_size();
  forward_dynamics<Scalar>(model, workspace.joints, state, force, workspace.acceleration);
  inverse_dynamics_derivatives<Scalar>(
      model, workspace, state, workspace.acceleration,
      {derivatives.by_position, derivatives.by_velocity, std::span<Scalar>(workspace.factor)});
  detail::require_size("forward_dynamics_derivatives", "by_force", derivatives.by_force.size(), n * n);
  detail::factor_by_tree<Scalar>(model, workspace.factor);
  const Scalar one(1);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      derivatives.by_force[i * n + j] = i == j ? one : Scalar(0);
      derivatives.by_position[i * n + j] = -derivatives.by_position[i * n + j];
      derivatives.by_velocity[i * n + j] = -derivatives.by_velocity[i * n + j];
    }
  for (const std::span<Scalar>& each : {derivatives.by_position, derivatives.by_velocity, derivatives.by_force})
    detail::solve_by_tree<Scalar>(model, workspace.factor, each, n);
}

}  // namespace poinsot
