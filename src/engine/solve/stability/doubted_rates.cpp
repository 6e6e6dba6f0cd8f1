#include "engine/solve/stability/doubted_rates.h"

#include <cmath>
#include <limits>

namespace poinsot::solve {
namespace {

// Scales A by a diagonal matrix of powers of two, such that rows and columns have similar sizes (Parlett and Reinsch
// 1969).
Vector balanced(Matrix& A) {
  Vector scale = Vector::Ones(A.rows());
  for (bool changed = true; changed;) {
    changed = false;
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
      const Real own = std::abs(A(i, i));
      const Real column = A.col(i).cwiseAbs().sum() - own, row = A.row(i).cwiseAbs().sum() - own;
      if (!(column > 0) || !(row > 0)) continue;
      const int power = static_cast<int>(std::lround(std::log2(row / column) / 2));
      const Real factor = std::ldexp(Real(1), power);
      if (power == 0 || column * factor + row / factor >= 0.95L * (column + row)) continue;
      A.col(i) *= factor;
      A.row(i) /= factor;
      scale[i] *= factor;
      changed = true;
    }
  }
  return scale;
}

}  // namespace

Rates rates_of(const Doubted& A) {
  Matrix even = A.value;
  const Vector scale = balanced(even);
  Rates rates;
  const Eigen::Index n = even.rows();
  if (n == 0) return rates;
  Eigen::EigenSolver<Matrix> solver(even);
  rates.value = solver.eigenvalues();
  const ComplexMatrix right = solver.eigenvectors(), left = Eigen::PartialPivLU<ComplexMatrix>(right).inverse();
  const Matrix doubt = scale.cwiseInverse().asDiagonal() * A.doubt * scale.asDiagonal();
  const Real solving = 8 * static_cast<Real>(n) * std::numeric_limits<Real>::epsilon() * even.norm();
  rates.doubt.resize(n);
  for (Eigen::Index m = 0; m < n; ++m) {
    const Vector w = left.row(m).cwiseAbs().transpose(), x = right.col(m).cwiseAbs();
    const Real most = w.dot(doubt * x) + solving * w.norm() * x.norm();
    rates.doubt[m] = std::isfinite(most) ? static_cast<double>(most) : std::numeric_limits<double>::infinity();
  }
  rates.motion = scale.asDiagonal() * right;
  return rates;
}

}  // namespace poinsot::solve
