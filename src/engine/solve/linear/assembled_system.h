// A system of named equations as matrices in natural units.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/solve/linear/linear_system.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {

// Entries are near one after scaling, so that a pivot below this part of the largest one is taken for rounding. Points
// of loops are closed and drawn to about 1e-12, and constraints that repeat one another differ by that: a tenth of this
// would tell them apart. Where rows depend on one another as nearly as this, a solution has five digits left.
inline constexpr double rank_tolerance = 1e-11;

// The number of equations m is at least one: a system without equations gets a row of zeros, which leaves all of its
// n unknowns open.
template <class Scalar>
struct AssembledSystem {
  Eigen::MatrixXd A;            // coefficients, with those that are nothing but rounding set to zero
  Eigen::VectorXd b, b_size;    // b_size: the sizes of the terms that b is the sum of
  Eigen::VectorXd row, column;  // from the units of the caller to natural ones: A_ij = row_i a_ij column_j
  Eigen::MatrixXd A_rate;       // over dual numbers the rates of A and of b; else empty
  Eigen::VectorXd b_rate;
  std::vector<std::size_t> bad;  // equations with numbers that are not finite; if there are any, rounding stays in A

  explicit AssembledSystem(const LinearSystemOf<Scalar>& system);
};

template <class Scalar>
AssembledSystem<Scalar>::AssembledSystem(const LinearSystemOf<Scalar>& system) {
  const auto m = static_cast<Eigen::Index>(std::max<std::size_t>(system.equations(), 1));
  const auto n = static_cast<Eigen::Index>(system.unknowns());
  A = Eigen::MatrixXd::Zero(m, n);
  b = b_size = Eigen::VectorXd::Zero(m);
  row = Eigen::VectorXd::Ones(m);
  column.resize(n);
  for (std::size_t i = 0; i < system.equations(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    row[k] = 1 / system.equations_[i].scale;
    b[k] = plain(system.equations_[i].right_side) * row[k];
    b_size[k] = system.equations_[i].right_size * row[k];
  }
  for (Eigen::Index j = 0; j < n; ++j) column[j] = system.unknowns_[static_cast<std::size_t>(j)].scale;
  Eigen::MatrixXd rounding = Eigen::MatrixXd::Zero(m, n);
  std::vector<bool> known_rounding(static_cast<std::size_t>(m), true);
  for (const auto& entry : system.entries_) {
    const auto i = static_cast<Eigen::Index>(entry.equation);
    const auto j = static_cast<Eigen::Index>(entry.unknown);
    A(i, j) += plain(entry.coefficient) * row[i] * column[j];
    rounding(i, j) += entry.rounding.value_or(0) * row[i] * column[j];
    if (!entry.rounding) known_rounding[entry.equation] = false;
  }
  if constexpr (std::is_same_v<Scalar, Dual<1>>) {
    A_rate = Eigen::MatrixXd::Zero(m, n);
    b_rate = Eigen::VectorXd::Zero(m);
    for (std::size_t i = 0; i < system.equations(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      b_rate[k] = system.equations_[i].right_side.partial[0] * row[k];
    }
    for (const auto& entry : system.entries_) {
      const auto i = static_cast<Eigen::Index>(entry.equation);
      const auto j = static_cast<Eigen::Index>(entry.unknown);
      A_rate(i, j) += entry.coefficient.partial[0] * row[i] * column[j];
    }
  }
  if (!A.allFinite() || !b.allFinite()) {
    for (Eigen::Index i = 0; i < m; ++i)
      if (!A.row(i).allFinite() || !std::isfinite(b[i])) bad.push_back(static_cast<std::size_t>(i));
    return;
  }
  for (Eigen::Index i = 0; i < m && n; ++i)
    if (!known_rounding[static_cast<std::size_t>(i)])
      // Some fifty units in the last place of the largest coefficient: sums of several products of directions leave so
      // much. Where every coefficient of a row is rounding, the row has no size of its own; in natural units, which the
      // entries are in, twenty units in the last place of one are nothing: so near to it is a root of the coefficient
      // found, at which such a row ceases to contradict others.
      rounding.row(i).setConstant(std::max(1e-14 * A.row(i).cwiseAbs().maxCoeff(), 4e-15));
  A = (A.array().abs() <= rounding.array()).select(0, A);
}

// What the factors of a matrix with m rows and n columns take, with its scaling.
inline Work work_of_factors(Work m, Work n) { return m * n * (50 + 2 * std::min(m, n)); }

// Scales rows and columns until the largest entry of each is near one (Ruiz 2001). Zero rows and columns are left
// alone.
void equilibrate(Eigen::MatrixXd& A, Eigen::VectorXd& rows, Eigen::VectorXd& columns);

}  // namespace poinsot::solve
