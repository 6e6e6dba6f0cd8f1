// The equations of motion of a Mechanism as matrices, over any scalar: run on a Traced (math/trace/traced.h) they
// become formulas and code.
//
// M is the mass matrix of all velocity coordinates v, h the part of velocities and weights, Q the generalised forces
// of loads, springs, dampers and known efforts, J the rows of the constraints beyond the tree and b their biases:
//
//   M dv/dt = Q - h + J^T y + (efforts of held coordinates),      J dv/dt + b = 0       (principle of virtual work).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "poinsot/engine/dynamics/action_forces.h"
#include "poinsot/engine/dynamics/hybrid_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/mass_matrix.h"
#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/dynamics/velocity_constraint.h"

namespace poinsot {

template <class Scalar>
struct EquationsOfMotion {
  int size = 0;                               // velocity coordinates
  std::vector<Scalar> mass;                   // M, size x size, row after row
  std::vector<Scalar> right_side;             // Q - h
  std::vector<std::vector<Scalar>> jacobian;  // J, a row per constraint
  std::vector<Scalar> bias;                   // b
  // The sizes of the terms whose sum is each entry of J. An entry far below this is what rounding left of zero.
  std::vector<std::vector<double>> jacobian_terms;
};

// Adds the generalised forces of a force on body `on`, and of its reaction on body `from`. After update_poses.
template <class Scalar>
void add_generalised_force(const Model<Scalar>& tree, const Workspace<Scalar>& workspace, int on, int from,
                           const PlacedForce<Scalar>& force, std::vector<Scalar>& forces) {
  for (const auto& [body, sign] : {std::pair{on, 1}, std::pair{from, -1}})
    for_each_coordinate_motion(tree, workspace, body, force.point,
                               [&, sign = sign](int k, const SpatialMotion<Scalar>& S) {
                                 forces[static_cast<std::size_t>(k)] +=
                                     Scalar(sign) * (dot(force.force, S.linear) + dot(force.couple, S.angular));
                               });
}

// Q: the generalised forces of the laws of force, and the known efforts of drives. After update_velocities.
template <class Scalar>
std::vector<Scalar> known_generalised_forces(const Mechanism<Scalar>& mechanism, const Workspace<Scalar>& workspace,
                                             const State<Scalar>& state) {
  std::vector<Scalar> forces(static_cast<std::size_t>(mechanism.tree.velocity_size()), Scalar(0));
  for (const Drive<Scalar>& drive : mechanism.drives)
    forces[static_cast<std::size_t>(drive.coordinate)] += drive.known_effort(state);
  for_each_law(mechanism, [&](const auto& law) {
    const Action& action = mechanism.actions[static_cast<std::size_t>(law.action)];
    add_generalised_force(mechanism.tree, workspace, action.on, action.from, law.exerted(mechanism.tree, workspace),
                          forces);
  });
  return forces;
}

// The size of what a constraint's entry is computed from, where a coordinate moves a point p as S does: of places on
// the ground axes, not of the arms between them, which may cancel.
template <class Scalar>
double size_of_terms(const PlacedForce<Scalar>& unit, const SpatialMotion<Scalar>& S, const Vector3<double>& p,
                     const Vector3<double>& origin) {
  const double turning = norm(plain(S.angular));
  const double arm = turning > 0 ? turning * (norm(p) + norm(origin)) : norm(plain(S.linear));
  return norm(plain(unit.force)) * arm + norm(plain(unit.couple)) * turning;
}

// The rows J and b at a state. After update_accelerations with accelerations of zero.
template <class Scalar>
void add_constraint_rows(const Mechanism<Scalar>& mechanism, const Workspace<Scalar>& workspace,
                         EquationsOfMotion<Scalar>& equations) {
  for (const VelocityConstraint<Scalar>& c : mechanism.constraints) {
    const ConstraintLine<Scalar> line = constraint_line(mechanism.tree, workspace, c);
    std::vector<Scalar> row(static_cast<std::size_t>(mechanism.tree.velocity_size()), Scalar(0));
    std::vector<double> terms(row.size(), 0.0);
    const auto add = [&](int body, const Vector3<Scalar>& p, int sign, const PlacedForce<Scalar>& unit) {
      for_each_coordinate_motion(mechanism.tree, workspace, body, p, [&](int k, const SpatialMotion<Scalar>& S) {
        row[static_cast<std::size_t>(k)] += Scalar(sign) * (dot(unit.force, S.linear) + dot(unit.couple, S.angular));
        terms[static_cast<std::size_t>(k)] +=
            size_of_terms(unit, S, plain(p), plain(workspace.motion[static_cast<std::size_t>(body + 1)].p));
      });
    };
    // The two bodies meet at one point, but a cord pulls each of them at its own end.
    const bool cord = c.kind == VelocityConstraintKind::cord_length;
    for_each_unit_force(
        mechanism.tree, workspace, c, line.unit, [&](int on, int from, const PlacedForce<Scalar>& unit) {
          add(on, unit.point, 1, unit);
          add(from, cord ? point_position(mechanism.tree, workspace, c.toward.body, c.toward.point) : unit.point, -1,
              unit);
        });
    equations.jacobian.push_back(std::move(row));
    equations.bias.push_back(line.bias);
    equations.jacobian_terms.push_back(std::move(terms));
  }
}

template <class Scalar>
EquationsOfMotion<Scalar> equations_of_motion(const Mechanism<Scalar>& mechanism, const State<Scalar>& state) {
  const Model<Scalar>& tree = mechanism.tree;
  const auto n = static_cast<std::size_t>(tree.velocity_size());
  Workspace<Scalar> workspace(tree);
  EquationsOfMotion<Scalar> equations;
  equations.size = tree.velocity_size();
  equations.mass.assign(n * n, Scalar(0));
  mass_matrix<Scalar>(tree, workspace, state.q, equations.mass);
  mirror_lower_triangle<Scalar>(equations.mass, equations.size);

  const std::vector<Scalar> none(n, Scalar(0));
  std::vector<Scalar> h(n, Scalar(0));
  inverse_dynamics<Scalar>(tree, workspace, state, none, h);
  update_accelerations<Scalar>(tree, workspace, state, none);
  equations.right_side = known_generalised_forces(mechanism, workspace, state);
  for (std::size_t k = 0; k < n; ++k) equations.right_side[k] -= h[k];
  add_constraint_rows(mechanism, workspace, equations);
  return equations;
}

// The generalised forces that must act, beside the known ones, for the coordinates to have these accelerations:
// M a + h - Q.
template <class Scalar>
std::vector<Scalar> needed_generalised_forces(const Mechanism<Scalar>& mechanism, const State<Scalar>& state,
                                              const std::vector<Scalar>& acceleration) {
  const Model<Scalar>& tree = mechanism.tree;
  Workspace<Scalar> workspace(tree);
  std::vector<Scalar> forces(acceleration.size(), Scalar(0));
  inverse_dynamics<Scalar>(tree, workspace, state, acceleration, forces);
  update_velocities(tree, workspace, state);
  const std::vector<Scalar> known = known_generalised_forces(mechanism, workspace, state);
  for (std::size_t k = 0; k < forces.size(); ++k) forces[k] -= known[k];
  return forces;
}

// The equations after elimination of the constraint forces. Some of the free coordinates depend on the others: dv/dt
// = N du/dt + g, where du/dt are the accelerations of the independent ones, and
//
//   (N^T M N) du/dt = N^T (Q - h - M g).
template <class Scalar>
struct ReducedEquations {
  std::vector<int> independent;            // velocity coordinates
  std::vector<std::vector<Scalar>> basis;  // N, a row per velocity coordinate
  std::vector<Scalar> offset;              // g: held coordinates have their accelerations in it
  std::vector<Scalar> mass;                // N^T M N, row after row
  std::vector<Scalar> right_side;          // N^T (Q - h - M g)
};

// held, acceleration: for each velocity coordinate whether its motion is given, and its acceleration then. Dependent
// coordinates are chosen by Gauss's elimination with the pivots that are best at plain numbers; rows that are nothing
// but rounding are left out. preferred: the larger it is for a coordinate, the rather this stays independent.
template <class Scalar>
ReducedEquations<Scalar> reduced_equations(const EquationsOfMotion<Scalar>& equations, const std::vector<bool>& held,
                                           const std::vector<Scalar>& acceleration,
                                           const std::vector<double>& preferred = {}) {
  using std::abs;
  const auto n = static_cast<std::size_t>(equations.size);
  // sum over k of row[k] a_k = right, held coordinates on the right.
  std::vector<std::vector<Scalar>> rows = equations.jacobian;
  std::vector<Scalar> right;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Scalar value = -equations.bias[i];
    for (std::size_t k = 0; k < n; ++k)
      if (held[k]) value -= rows[i][k] * acceleration[k];
    right.push_back(value);
  }
  // The terms that each entry comes from are followed through the elimination, since the rounding of an entry is a
  // part of them.
  std::vector<std::vector<double>> terms = equations.jacobian_terms;
  std::vector<double> row_size(rows.size(), 0);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < n; ++k)
      if (!held[k]) row_size[i] = std::max(row_size[i], std::fabs(plain(rows[i][k])));
  std::vector<int> pivot_of(n, -1);  // the row that gives a dependent coordinate
  const double largest_row = rows.empty() ? 0 : *std::max_element(row_size.begin(), row_size.end());
  std::vector<char> used(rows.size(), 0);
  for (std::size_t step = 0; step < rows.size(); ++step) {
    double best = 0;
    std::size_t r = 0, c = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (used[i]) continue;
      for (std::size_t k = 0; k < n; ++k) {
        if (held[k] || pivot_of[k] >= 0 || vanishes(rows[i][k])) continue;
        const double size = std::fabs(plain(rows[i][k]));
        // An entry that is nothing but rounding is no pivot. Numbers are preferred to formulas, and short rows to
        // long ones.
        if (size <= 1e-11 * terms[i][k] || size <= 1e-9 * row_size[i]) continue;
        std::size_t entries = 0;
        for (std::size_t j = 0; j < n; ++j) entries += !held[j] && !vanishes(rows[i][j]);
        // An entry that is small here may vanish nearby.
        double quality = size / largest_row / static_cast<double>(entries * entries);
        if (is_constant(rows[i][k])) quality *= 10;
        if (!preferred.empty()) quality *= std::exp(-preferred[k]);
        if (quality > best) {
          best = quality;
          r = i;
          c = k;
        }
      }
    }
    if (best == 0) break;
    used[r] = 1;
    pivot_of[c] = static_cast<int>(r);
    const Scalar pivot = rows[r][c];
    for (std::size_t k = 0; k < n; ++k)
      if (!held[k] && !vanishes(rows[r][k])) rows[r][k] = k == c ? Scalar(1) : rows[r][k] / pivot;
    right[r] = right[r] / pivot;
    for (double& term : terms[r]) term /= std::fabs(plain(pivot));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == r || vanishes(rows[i][c])) continue;
      const Scalar factor = rows[i][c];
      for (std::size_t k = 0; k < n; ++k)
        if (!held[k] && !vanishes(rows[r][k])) rows[i][k] = k == c ? Scalar(0) : rows[i][k] - factor * rows[r][k];
      right[i] = right[i] - factor * right[r];
      for (std::size_t k = 0; k < n; ++k) terms[i][k] += std::fabs(plain(factor)) * terms[r][k];
    }
  }

  ReducedEquations<Scalar> reduced;
  for (std::size_t k = 0; k < n; ++k)
    if (!held[k] && pivot_of[k] < 0) reduced.independent.push_back(static_cast<int>(k));
  const std::size_t m = reduced.independent.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<Scalar> row(m, Scalar(0));
    Scalar offset(0);
    if (held[k]) {
      offset = acceleration[k];
    } else if (pivot_of[k] < 0) {
      for (std::size_t j = 0; j < m; ++j)
        if (reduced.independent[j] == static_cast<int>(k)) row[j] = Scalar(1);
    } else {
      const auto& from = rows[static_cast<std::size_t>(pivot_of[k])];
      for (std::size_t j = 0; j < m; ++j) row[j] = -from[static_cast<std::size_t>(reduced.independent[j])];
      offset = right[static_cast<std::size_t>(pivot_of[k])];
    }
    reduced.basis.push_back(std::move(row));
    reduced.offset.push_back(offset);
  }

  // M N and Q - h - M g, then N^T of them.
  std::vector<std::vector<Scalar>> carried(n, std::vector<Scalar>(m, Scalar(0)));
  std::vector<Scalar> rest = equations.right_side;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const Scalar& entry = equations.mass[i * n + k];
      if (vanishes(entry)) continue;
      for (std::size_t j = 0; j < m; ++j)
        if (!vanishes(reduced.basis[k][j])) carried[i][j] += entry * reduced.basis[k][j];
      if (!vanishes(reduced.offset[k])) rest[i] -= entry * reduced.offset[k];
    }
  reduced.mass.assign(m * m, Scalar(0));
  reduced.right_side.assign(m, Scalar(0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      if (vanishes(reduced.basis[i][j])) continue;
      reduced.right_side[j] += reduced.basis[i][j] * rest[i];
      for (std::size_t l = 0; l <= j; ++l) reduced.mass[j * m + l] += reduced.basis[i][j] * carried[i][l];
    }
  mirror_lower_triangle<Scalar>(reduced.mass, static_cast<int>(m));
  return reduced;
}

// The accelerations dv/dt of all coordinates, by Cholesky's elimination without roots, where the coordinates with the
// fewest neighbours come first. Throws std::domain_error if a coordinate that nothing holds moves no mass.
template <class Scalar>
std::vector<Scalar> solved_accelerations(const ReducedEquations<Scalar>& reduced) {
  const std::size_t m = reduced.independent.size();
  std::vector<Scalar> A = reduced.mass, x = reduced.right_side;
  std::vector<double> size(m);
  for (std::size_t k = 0; k < m; ++k) size[k] = std::fabs(plain(A[k * m + k]));
  std::vector<std::size_t> order;
  for (std::size_t step = 0; step < m; ++step) {
    std::size_t p = m;
    for (std::size_t k = 0; k < m; ++k) {
      if (std::find(order.begin(), order.end(), k) != order.end()) continue;
      // The coordinate with the fewest neighbours causes the least fill-in.
      const auto better = [&](std::size_t a, std::size_t b) {
        const auto entries = [&](std::size_t i) {
          std::size_t count = 0;
          for (std::size_t j = 0; j < m; ++j) count += !vanishes(A[i * m + j]);
          return count;
        };
        return entries(a) < entries(b);
      };
      if (!(std::fabs(plain(A[k * m + k])) > 1e-12 * size[k]) || vanishes(A[k * m + k])) continue;
      if (p == m || better(k, p)) p = k;
    }
    if (p == m) throw std::domain_error("a coordinate that nothing holds moves no mass");
    order.push_back(p);
    for (std::size_t i = 0; i < m; ++i) {
      if (std::find(order.begin(), order.end(), i) != order.end() || vanishes(A[i * m + p])) continue;
      const Scalar factor = A[i * m + p] / A[p * m + p];
      for (std::size_t j = 0; j < m; ++j)
        if (std::find(order.begin(), order.end(), j) == order.end() && !vanishes(A[j * m + p]))
          A[i * m + j] -= factor * A[j * m + p];
      x[i] -= factor * x[p];
    }
  }
  for (std::size_t step = m; step-- > 0;) {
    const std::size_t p = order[step];
    for (std::size_t later = step + 1; later < m; ++later)
      if (const std::size_t j = order[later]; !vanishes(A[j * m + p])) x[p] -= A[j * m + p] * x[j];
    x[p] = x[p] / A[p * m + p];
  }
  std::vector<Scalar> all = reduced.offset;
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t j = 0; j < m; ++j)
      if (!vanishes(reduced.basis[k][j])) all[k] += reduced.basis[k][j] * x[j];
  return all;
}

}  // namespace poinsot
