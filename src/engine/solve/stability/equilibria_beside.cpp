#include "engine/solve/stability/equilibria_beside.h"

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;
// Of the length of rows and columns: what depends on others but for rounding. Points of loops are drawn to 1e-12, so
// that a hundredth of this would take their rounding for a row of its own.
constexpr Real depends = 1e-9L;

Index rank_of(const Matrix& A) {
  if (A.size() == 0 || A.cwiseAbs().maxCoeff() <= depends) return 0;
  Eigen::ColPivHouseholderQR<Matrix> qr(A);
  qr.setThreshold(depends);
  return qr.rank();
}

// What the columns of A are combinations to zero of: vectors x of length one with A x = 0 but for rounding.
Matrix kernel_of(const Matrix& A) {
  return A.isZero(0) ? Matrix(Matrix::Identity(A.cols(), A.cols())) : complement(A.transpose(), depends);
}

}  // namespace

Matrix equilibria_beside(const Doubted& A, const DeviationRows& rows, const Matrix& elsewhere) {
  const Index n = A.value.rows() / 2;
  Matrix none(2 * n, 0);
  // At rest each condition is one on positions or one on velocities.
  Matrix of_positions(0, n), of_velocities(0, n);
  for (Index i = 0; i < rows.value.rows(); ++i) {
    const bool moves = rows.value.row(i).tail(n).norm() > rows.value.row(i).head(n).norm();
    Matrix& list = moves ? of_velocities : of_positions;
    list.conservativeResize(list.rows() + 1, n);
    list.bottomRows(1) = moves ? rows.value.row(i).tail(n) : rows.value.row(i).head(n);
  }
  // Equations of equilibrium are empty along displacements that change nothing and that may be made.
  const Matrix same = elsewhere.topRows(n);
  const Index empty = same.cols() - rank_of(of_velocities * same);
  const Index family = rank_of(of_velocities) - rank_of(of_positions) + empty - same.cols();
  if (family <= 0) return none;

  Matrix free = of_positions.rows() > 0 ? complement(of_positions.transpose()) : Matrix::Identity(n, n);
  if (same.cols() > 0) {
    const Matrix turned = free.transpose();
    free = free * complement(turned * same);
  }
  const Matrix stiffness = A.value.bottomLeftCorner(n, n), still = free * kernel_of(stiffness * free);
  // If more vanish, an equilibrium is on the point of losing its stability.
  if (still.cols() != family) return none;
  Matrix found = Matrix::Zero(2 * n, family);
  found.topRows(n) = still;
  return found;
}

}  // namespace poinsot::solve
