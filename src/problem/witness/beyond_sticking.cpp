// With weights w of forces that lie in their cones, w . x >= 0 wherever all stick. If some combination l of the
// equations A x = b has these weights, A' l = w, then w . x = l . b for every x that fulfils them: where that is below
// zero, no such x sticks (the lemma of Farkas). l is a virtual motion, l . b the power of the loads in it.
#include "problem/witness/beyond_sticking.h"

#include <algorithm>
#include <cmath>

#include "engine/solve/linear/decompositions.h"
#include "problem/instant/sticking_margin.h"

namespace poinsot::problem {
namespace {

// The weights of all unknowns; nothing if they lie outside of their cones.
std::optional<Eigen::VectorXd> weights_of(const StickingBound& bound, std::size_t unknowns) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns));
  const auto of = [&](std::size_t k) -> double& { return weights[static_cast<Eigen::Index>(k)]; };
  for (const auto& [push, weight] : bound.pushes) {
    if (!(weight >= 0)) return std::nullopt;
    of(push) += weight;
  }
  for (const StickingBound::OfCone& one : bound.cones) {
    if (!(one.limit >= std::hypot(one.first, one.second) * (1 - 1e-15))) return std::nullopt;
    of(one.cone.push) += one.limit * one.cone.coefficient;
    of(one.cone.first) += one.first;
    if (one.cone.second) of(*one.cone.second) += one.second;
  }
  return weights;
}

}  // namespace

std::optional<bool> sticks_in_no_share(const SolvedInstant& instant) {
  if (!instant.forces_solved() || instant.motion().open.empty()) return std::nullopt;
  const std::optional<StickingForces> forces = sticking_forces(instant);
  if (!forces) return std::nullopt;
  const std::optional<StickingBound> bound =
      bound_on_sticking(instant.motion(), forces->one_sided, forces->cones,
                        solve::force_unknowns(instant.machine().mechanism).accelerations);
  if (!bound) return std::nullopt;
  const std::vector<std::vector<double>> rows = instant.motion_equations().coefficients();
  const std::vector<double> right_sides = instant.motion_equations().right_sides();
  const std::size_t unknowns = instant.motion().value.size();
  std::optional<Eigen::VectorXd> weights = weights_of(*bound, unknowns);
  if (!weights) return false;
  const auto m = static_cast<Eigen::Index>(rows.size()), n = static_cast<Eigen::Index>(unknowns);
  Eigen::MatrixXd A(m, n);
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = 0; j < n; ++j) A(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  // In units in which the largest coefficient of each equation and each unknown is near one.
  Eigen::VectorXd of_row = Eigen::VectorXd::Ones(m), of_column = Eigen::VectorXd::Ones(n);
  for (int pass = 0; pass < 3; ++pass) {
    for (Eigen::Index i = 0; i < m; ++i)
      if (const double largest = A.row(i).cwiseAbs().maxCoeff(); largest > 0) {
        A.row(i) /= largest;
        of_row[i] /= largest;
      }
    for (Eigen::Index j = 0; j < n; ++j)
      if (const double largest = A.col(j).cwiseAbs().maxCoeff(); largest > 0) {
        A.col(j) /= largest;
        of_column[j] /= largest;
      }
  }
  Eigen::VectorXd b(m), x(n);
  for (Eigen::Index i = 0; i < m; ++i) b[i] = right_sides[static_cast<std::size_t>(i)] * of_row[i];
  for (Eigen::Index j = 0; j < n; ++j) x[j] = instant.motion().value[static_cast<std::size_t>(j)] / of_column[j];
  const Eigen::VectorXd w = weights->cwiseProduct(of_column);
  const Eigen::MatrixXd transposed = A.transpose();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(transposed.rows(), transposed.cols());
  constexpr double dependent = 1e-11;
  solver.setThreshold(dependent);
  solver.compute(transposed);
  const Eigen::VectorXd motion = solver.solve(w);
  const double left = (transposed * motion - w).norm();
  // Forces a thousand times those that were found are within what rounding leaves of the weights.
  constexpr double far = 1e3, rounding = 1e-14;
  const double power = motion.dot(b), terms = motion.cwiseProduct(b).cwiseAbs().sum();
  return power < -(far * left * x.norm() + rounding * terms);
}

}  // namespace poinsot::problem
