// Constraints on top of the tree (loop closures, cords, points held in a plane), and forward and hybrid dynamics under
// them.
//
// Every constraint is one scalar equation c(q) = 0 with dc/dt = J v and d2c/dt2 = J dv/dt + b, b the bias. The
// accelerations obey d2c/dt2 = 0. With M the mass matrix of the free coordinates, the multipliers y solve
//
//   (J M^-1 J^T) y = -(J a_0 + b),     a_0 the accelerations without the constraints,
//
// the constraint forces on the coordinates are J^T y, and each M^-1 J^T is one pass over the factored tree
// (hybrid_response). Directions in which constraints repeat one another (redundant loops) get multiplier zero.
#pragma once

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "poinsot/engine/dynamics/hybrid_dynamics.h"
#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/math/algebra/plain.h"

namespace poinsot {

enum class ConstraintType {
  along,     // u . (B - A) = value, u riding on body a: point B keeps its place along u
  parallel,  // u . w = value, w riding on body b: two directions keep their angle
  distance   // |B - A| = value: two points keep their distance (not zero)
};

// One scalar constraint between two bodies (or ground, -1): A is a point of body a, B of body b, u a direction of a,
// w one of b, each on its body's axes.
template <class Scalar>
struct Constraint {
  ConstraintType type = ConstraintType::along;
  int a = ground;
  int b = ground;
  Vector3<Scalar> point_a{};
  Vector3<Scalar> point_b{};
  Vector3<Scalar> direction_a{};
  Vector3<Scalar> direction_b{};
  Scalar value{};

  static Constraint along(int a, const Vector3<Scalar>& point_a, const Vector3<Scalar>& direction_a, int b,
                          const Vector3<Scalar>& point_b, const Scalar& value = Scalar(0)) {
    Constraint c;
    c.type = ConstraintType::along;
    c.a = a;
    c.b = b;
    c.point_a = point_a;
    c.point_b = point_b;
    c.direction_a = direction_a;
    c.value = value;
    return c;
  }
  static Constraint parallel(int a, const Vector3<Scalar>& direction_a, int b, const Vector3<Scalar>& direction_b,
                             const Scalar& value = Scalar(0)) {
    Constraint c;
    c.type = ConstraintType::parallel;
    c.a = a;
    c.b = b;
    c.direction_a = direction_a;
    c.direction_b = direction_b;
    c.value = value;
    return c;
  }
  static Constraint distance(int a, const Vector3<Scalar>& point_a, int b, const Vector3<Scalar>& point_b,
                             const Scalar& value) {
    Constraint c;
    c.type = ConstraintType::distance;
    c.a = a;
    c.b = b;
    c.point_a = point_a;
    c.point_b = point_b;
    c.value = value;
    return c;
  }
};

// Two points that coincide: three constraints along the axes of body a. Their multipliers are the components, on these
// axes, of the force on body b at the point; body a gets the opposite one.
template <class Scalar>
std::vector<Constraint<Scalar>> coincident_points(int a, const Vector3<Scalar>& point_a, int b,
                                                  const Vector3<Scalar>& point_b) {
  std::vector<Constraint<Scalar>> constraints;
  for (std::size_t i = 0; i < 3; ++i) {
    constraints.push_back(Constraint<Scalar>::along(a, point_a, Vector3<Scalar>::unit(i), b, point_b));
  }
  return constraints;
}

// A hinge that closes a loop: the points coincide and the axis of b is at right angles to two directions of a that span
// the plane normal to the axis there.
template <class Scalar>
std::vector<Constraint<Scalar>> coincident_axes(int a, const Vector3<Scalar>& point_a, const Vector3<Scalar>& axis_a,
                                                int b, const Vector3<Scalar>& point_b, const Vector3<Scalar>& axis_b) {
  std::vector<Constraint<Scalar>> constraints = coincident_points(a, point_a, b, point_b);
  const Matrix3<Scalar> axes = axes_with_z_along(normalized(axis_a));
  constraints.push_back(Constraint<Scalar>::parallel(a, axes.column(0), b, axis_b));
  constraints.push_back(Constraint<Scalar>::parallel(a, axes.column(1), b, axis_b));
  return constraints;
}

namespace detail {

// The constraint's rate as a sum of powers: on body a a motion is paired with force_a, on b with force_b, on ground
// axes about the two bodies' points A and B. error = c(q), bias as above with the present velocities.
template <class Scalar>
struct ConstraintRow {
  Vector3<Scalar> at_a{};
  Vector3<Scalar> at_b{};
  SpatialForce<Scalar> on_a{};
  SpatialForce<Scalar> on_b{};
  Scalar error{};
};

template <class Scalar>
ConstraintRow<Scalar> constraint_row(const Model<Scalar>& model, const Workspace<Scalar>& workspace,
                                     const Constraint<Scalar>& c) {
  using std::sqrt;
  const Vector3<Scalar> zero = Vector3<Scalar>::zero();
  ConstraintRow<Scalar> row;
  row.at_a = point_position(model, workspace, c.a, c.point_a);
  row.at_b = point_position(model, workspace, c.b, c.point_b);
  const Vector3<Scalar> d = row.at_b - row.at_a;
  switch (c.type) {
    case ConstraintType::along: {
      // d/dt (u . d) = u . (v_B - v_A) + (w_a x u) . d = u . (v_B - v_A) - w_a . (d x u).
      const Vector3<Scalar> u = direction_on_ground(model, workspace, c.a, c.direction_a);
      row.on_a = {-cross(d, u), -u};
      row.on_b = {zero, u};
      row.error = dot(u, d) - c.value;
      break;
    }
    case ConstraintType::parallel: {
      // d/dt (u . w) = (w_b - w_a) . (w x u).
      const Vector3<Scalar> u = direction_on_ground(model, workspace, c.a, c.direction_a);
      const Vector3<Scalar> w = direction_on_ground(model, workspace, c.b, c.direction_b);
      const Vector3<Scalar> n = cross(w, u);
      row.on_a = {-n, zero};
      row.on_b = {n, zero};
      row.error = dot(u, w) - c.value;
      break;
    }
    case ConstraintType::distance: {
      const Scalar length = sqrt(norm_squared(d));
      const Vector3<Scalar> n = d / length;
      row.on_a = {zero, -n};
      row.on_b = {zero, n};
      row.error = length - c.value;
      break;
    }
  }
  return row;
}

}  // namespace detail

// c(q), m, or a cosine. After update_poses.
template <class Scalar>
Scalar constraint_error(const Model<Scalar>& model, const Workspace<Scalar>& workspace, const Constraint<Scalar>& c) {
  return detail::constraint_row(model, workspace, c).error;
}

// The row J of dc/dt = J v: velocity_size() numbers. After update_poses.
template <class Scalar>
void constraint_jacobian(const Model<Scalar>& model, const Workspace<Scalar>& workspace, const Constraint<Scalar>& c,
                         std::span<Scalar> jacobian) {
  detail::require_size("constraint_jacobian", "jacobian", jacobian.size(), model.velocity_size());
  const detail::ConstraintRow<Scalar> row = detail::constraint_row(model, workspace, c);
  for (Scalar& entry : jacobian) entry = Scalar(0);
  for_each_coordinate_motion(model, workspace, c.a, row.at_a,
                             [&](int k, const SpatialMotion<Scalar>& S) { jacobian[k] += dot(S, row.on_a); });
  for_each_coordinate_motion(model, workspace, c.b, row.at_b,
                             [&](int k, const SpatialMotion<Scalar>& S) { jacobian[k] += dot(S, row.on_b); });
}

// dc/dt. After update_velocities.
template <class Scalar>
Scalar constraint_rate(const Model<Scalar>& model, const Workspace<Scalar>& workspace, const Constraint<Scalar>& c) {
  const detail::ConstraintRow<Scalar> row = detail::constraint_row(model, workspace, c);
  const SpatialMotion<Scalar> motion_a{workspace.motion[c.a + 1].w, point_velocity(model, workspace, c.a, c.point_a)};
  const SpatialMotion<Scalar> motion_b{workspace.motion[c.b + 1].w, point_velocity(model, workspace, c.b, c.point_b)};
  return dot(motion_a, row.on_a) + dot(motion_b, row.on_b);
}

namespace detail {

// Whether a constraint moves no free coordinate: what its row J holds there is far below the terms it was computed
// from, and so only their rounding. Places on the ground axes count, not the arms between them, which may cancel.
template <class Scalar>
bool moves_nothing_free(const Model<Scalar>& model, const Workspace<Scalar>& workspace, const Constraint<Scalar>& c,
                        std::span<const Scalar> jacobian) {
  constexpr double rounding = 1e-12;  // of the terms
  const ConstraintRow<Scalar> row = constraint_row(model, workspace, c);
  // Of directions side by side the vector product is nothing but rounding.
  const double couple =
      c.type == ConstraintType::parallel ? norm(plain(c.direction_a)) * norm(plain(c.direction_b)) : 0.0;
  bool moves = false;
  const auto look_at = [&](int body, const Vector3<Scalar>& at, const SpatialForce<Scalar>& on) {
    const double place = norm(plain(row.at_a)) + norm(plain(row.at_b)) + norm(plain(workspace.motion[body + 1].p));
    for_each_coordinate_motion(model, workspace, body, at, [&](int k, const SpatialMotion<Scalar>& S) {
      if (model.mode(k) != CoordinateMode::free) return;
      const double turning = norm(plain(S.angular));
      const double terms = turning * (couple + place * norm(plain(on.force))) +
                           (turning > 0 ? 0.0 : norm(plain(S.linear)) * norm(plain(on.force)));
      moves = moves || std::fabs(plain(jacobian[k])) > rounding * terms;
    });
  };
  look_at(c.a, row.at_a, row.on_a);
  look_at(c.b, row.at_b, row.on_b);
  return !moves;
}

}  // namespace detail

// d2c/dt2 at the present accelerations. After update_accelerations; with accelerations of zero it is the bias.
template <class Scalar>
Scalar constraint_acceleration(const Model<Scalar>& model, const Workspace<Scalar>& workspace,
                               const Constraint<Scalar>& c) {
  using std::sqrt;
  const BodyMotion<Scalar>& a = workspace.motion[c.a + 1];
  const BodyMotion<Scalar>& b = workspace.motion[c.b + 1];
  const Vector3<Scalar> d =
      point_position(model, workspace, c.b, c.point_b) - point_position(model, workspace, c.a, c.point_a);
  const Vector3<Scalar> dd =
      point_velocity(model, workspace, c.b, c.point_b) - point_velocity(model, workspace, c.a, c.point_a);
  const Vector3<Scalar> ddd =
      point_acceleration(model, workspace, c.b, c.point_b) - point_acceleration(model, workspace, c.a, c.point_a);
  // First and second rates of a direction that rides on a body.
  const auto rate = [](const BodyMotion<Scalar>& body, const Vector3<Scalar>& u) { return cross(body.w, u); };
  const auto second_rate = [](const BodyMotion<Scalar>& body, const Vector3<Scalar>& u) {
    return cross(body.alpha, u) + cross(body.w, cross(body.w, u));
  };
  const Scalar two(2);
  switch (c.type) {
    case ConstraintType::along: {
      const Vector3<Scalar> u = direction_on_ground(model, workspace, c.a, c.direction_a);
      return dot(second_rate(a, u), d) + two * dot(rate(a, u), dd) + dot(u, ddd);
    }
    case ConstraintType::parallel: {
      const Vector3<Scalar> u = direction_on_ground(model, workspace, c.a, c.direction_a);
      const Vector3<Scalar> w = direction_on_ground(model, workspace, c.b, c.direction_b);
      return dot(second_rate(a, u), w) + two * dot(rate(a, u), rate(b, w)) + dot(u, second_rate(b, w));
    }
    default: {
      const Scalar length = sqrt(norm_squared(d));
      const Scalar lengthening = dot(d, dd) / length;
      return (norm_squared(dd) + dot(d, ddd) - lengthening * lengthening) / length;
    }
  }
}

// The memory of constrained_dynamics, made once for a model and a number of constraints.
template <class Scalar>
struct ConstraintWorkspace {
  ConstraintWorkspace(const Model<Scalar>& model, int constraint_count)
      : jacobian(constraint_count * model.velocity_size()),
        response(constraint_count * model.velocity_size()),
        system(constraint_count * constraint_count),
        diagonal(constraint_count),
        order(constraint_count),
        force(model.velocity_size()),
        right(constraint_count) {}

  std::vector<Scalar> jacobian;  // J, a row per constraint
  std::vector<Scalar> response;  // M^-1 J^T, a row per constraint
  std::vector<Scalar> system;    // J M^-1 J^T, then its factors
  std::vector<Scalar> diagonal;  // its diagonal
  std::vector<int> order;        // its pivots
  std::vector<Scalar> force;
  std::vector<Scalar> right;
  int rank = 0;  // independent constraints at the last solution
};

namespace detail {

// Solves the positive semidefinite system A y = b by L D L^T with diagonal pivoting, and returns its rank: unknowns
// whose pivots fall below tolerance times their own diagonal entries are 0. A scalar without order is not pivoted and
// must have full rank. A: n by n, its lower triangle is overwritten with the factors; y takes the place of b.
// diagonal: n entries of scratch.
template <class Scalar>
int solve_semidefinite(std::span<Scalar> A, std::span<Scalar> b, std::span<int> order, std::span<Scalar> diagonal,
                       double tolerance) {
  const int n = static_cast<int>(b.size());
  const auto at = [&](int i, int j) -> Scalar& {
    return order[i] >= order[j] ? A[order[i] * n + order[j]] : A[order[j] * n + order[i]];
  };
  for (int k = 0; k < n; ++k) {
    order[k] = k;
    diagonal[k] = A[k * n + k];
  }
  int rank = n;
  for (int k = 0; k < n; ++k) {
    if constexpr (Ordered<Scalar>) {
      // The pivot that has kept the largest part of its diagonal entry; one that has none comes last.
      int pivot = k;
      for (int i = k + 1; i < n; ++i) {
        const Scalar kept = at(pivot, pivot) * diagonal[order[i]], other = at(i, i) * diagonal[order[pivot]];
        if (kept < other || (!(diagonal[order[pivot]] > Scalar(0)) && diagonal[order[i]] > Scalar(0))) pivot = i;
      }
      std::swap(order[k], order[pivot]);
      if (!(at(k, k) > Scalar(tolerance) * diagonal[order[k]])) {
        rank = k;
        break;
      }
    }
    for (int i = k + 1; i < n; ++i) {
      const Scalar factor = at(i, k) / at(k, k);
      b[order[i]] -= factor * b[order[k]];
      for (int j = k + 1; j <= i; ++j) at(i, j) -= factor * at(j, k);
    }
  }
  for (int k = rank; k < n; ++k) b[order[k]] = Scalar(0);
  for (int k = rank - 1; k >= 0; --k) {
    Scalar sum = b[order[k]];
    for (int i = k + 1; i < rank; ++i) sum -= at(i, k) * b[order[i]];
    b[order[k]] = sum / at(k, k);
  }
  return rank;
}

}  // namespace detail

// Hybrid dynamics (hybrid_dynamics.h) under constraints. multiplier: one number per constraint, written: the constraint
// acts on the coordinates with the forces J^T multiplier. target: the wanted d2c/dt2 of each constraint (for
// stabilisation), or empty for 0. The state must satisfy c = 0 and J v = 0 as closely as the caller wants. A given
// coordinate's force found includes what the constraints demand. Constraints between given coordinates only, and
// repeated ones, get multiplier 0; workspace.rank tells how many are independent.
// Errors: std::invalid_argument if a size is wrong.
template <class Scalar>
void constrained_dynamics(const Model<Scalar>& model, Workspace<Scalar>& workspace,
                          ConstraintWorkspace<Scalar>& constraint_workspace, const State<Scalar>& state,
                          std::span<const Constraint<Scalar>> constraints, std::span<Scalar> acceleration,
                          std::span<Scalar> force, std::span<Scalar> multiplier,
                          std::span<const SpatialForce<Scalar>> external = {}, std::span<const Scalar> target = {}) {
  const int n = model.velocity_size();
  const int count = static_cast<int>(constraints.size());
  detail::require_size("constrained_dynamics", "multiplier", multiplier.size(), count);
  detail::require_size("constrained_dynamics", "constraint workspace", constraint_workspace.right.size(), count);
  if (!target.empty()) detail::require_size("constrained_dynamics", "target", target.size(), count);

  // Without the constraints; the inertias are factored on the way.
  hybrid_dynamics(model, workspace, state, acceleration, force, external);
  update_accelerations(model, workspace, state, std::span<const Scalar>(acceleration));
  for (int i = 0; i < count; ++i) {
    const Scalar wanted = target.empty() ? Scalar(0) : target[i];
    constraint_workspace.right[i] = wanted - constraint_acceleration(model, workspace, constraints[i]);
  }

  // J, M^-1 J^T and their product.
  for (int i = 0; i < count; ++i) {
    const std::span<Scalar> row = std::span<Scalar>(constraint_workspace.jacobian).subspan(i * n, n);
    const std::span<Scalar> response = std::span<Scalar>(constraint_workspace.response).subspan(i * n, n);
    constraint_jacobian(model, workspace, constraints[i], row);
    if constexpr (Ordered<Scalar>) {
      if (detail::moves_nothing_free(model, workspace, constraints[i], std::span<const Scalar>(row)))
        for (Scalar& entry : row) entry = Scalar(0);
    }
    for (int k = 0; k < n; ++k) constraint_workspace.force[k] = row[k];
    hybrid_response(model, workspace, response, std::span<Scalar>(constraint_workspace.force));
    for (int j = 0; j <= i; ++j) {
      Scalar sum(0);
      for (int k = 0; k < n; ++k) sum += constraint_workspace.jacobian[j * n + k] * response[k];
      constraint_workspace.system[i * count + j] = sum;
    }
  }
  constexpr double rank_tolerance = 1e-11;
  constraint_workspace.rank = detail::solve_semidefinite(
      std::span<Scalar>(constraint_workspace.system), std::span<Scalar>(constraint_workspace.right),
      std::span<int>(constraint_workspace.order), std::span<Scalar>(constraint_workspace.diagonal), rank_tolerance);

  // The constraint forces change the accelerations, and the forces found for given coordinates.
  for (int k = 0; k < n; ++k) constraint_workspace.force[k] = Scalar(0);
  for (int i = 0; i < count; ++i) {
    multiplier[i] = constraint_workspace.right[i];
    for (int k = 0; k < n; ++k) {
      constraint_workspace.force[k] += constraint_workspace.jacobian[i * n + k] * multiplier[i];
    }
  }
  if (count == 0) return;
  const std::span<Scalar> reaction(constraint_workspace.force);
  const std::span<Scalar> change = std::span<Scalar>(constraint_workspace.response).first(n);
  for (int k = 0; k < n; ++k) {
    // A given coordinate's motor carries the constraint's force on that coordinate itself as well.
    if (model.mode(k) != CoordinateMode::free) force[k] -= reaction[k];
  }
  hybrid_response(model, workspace, change, reaction);
  for (int k = 0; k < n; ++k) {
    if (model.mode(k) == CoordinateMode::free) {
      acceleration[k] += change[k];
    } else {
      force[k] += reaction[k];
    }
  }
}

}  // namespace poinsot
