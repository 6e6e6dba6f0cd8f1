#include "engine/solve/linear/column_pivoted_qr.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "poinsot/engine/work/budget.h"

namespace poinsot::solve {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double square(double x) { return x * x; }

}  // namespace

ColumnPivotedQr::ColumnPivotedQr(const Eigen::MatrixXd& A) : ColPivHouseholderQR(A.rows(), A.cols()) {
  m_qr = A;
  const Eigen::Index size = m_qr.diagonalSize();
  for (Eigen::Index j = 0; j < A.cols(); ++j) m_colNormsUpdated[j] = m_colNormsDirect[j] = m_qr.col(j).norm();
  const double negligible = square(m_colNormsUpdated.maxCoeff() * epsilon) / static_cast<double>(A.rows());
  m_nonzero_pivots = size;
  m_maxpivot = 0;
  m_det_pq = 1;
  for (Eigen::Index k = 0; k < size; ++k) {
    check_budget();
    choose(k, negligible);
    eliminate(k);
    take_from_norms(k);
  }
  m_colsPermutation.setIdentity(A.cols());
  for (Eigen::Index k = 0; k < size; ++k) m_colsPermutation.applyTranspositionOnTheRight(k, m_colsTranspositions[k]);
  m_isInitialized = true;
}

// The column of which most is left comes to place k.
void ColumnPivotedQr::choose(Eigen::Index k, double negligible) {
  Eigen::Index chosen = 0;
  const double left = square(m_colNormsUpdated.tail(m_qr.cols() - k).maxCoeff(&chosen));
  chosen += k;
  if (m_nonzero_pivots == m_qr.diagonalSize() && left < negligible * static_cast<double>(m_qr.rows() - k))
    m_nonzero_pivots = k;
  m_colsTranspositions[k] = chosen;
  if (chosen == k) return;
  m_qr.col(k).swap(m_qr.col(chosen));
  std::swap(m_colNormsUpdated[k], m_colNormsUpdated[chosen]);
  std::swap(m_colNormsDirect[k], m_colNormsDirect[chosen]);
  m_det_pq = -m_det_pq;
}

// A reflection takes the rest of column k to its diagonal.
void ColumnPivotedQr::eliminate(Eigen::Index k) {
  const Eigen::Index rows = m_qr.rows() - k, columns = m_qr.cols() - k - 1;
  double diagonal = 0;
  m_qr.col(k).tail(rows).makeHouseholderInPlace(m_hCoeffs[k], diagonal);
  m_qr(k, k) = diagonal;
  m_maxpivot = std::max(m_maxpivot, std::abs(diagonal));
  m_qr.bottomRightCorner(rows, columns)
      .applyHouseholderOnTheLeft(m_qr.col(k).tail(rows - 1), m_hCoeffs[k], m_temp.data() + k + 1);
}

// What row k takes from the norms of the columns behind it; where too few digits of a norm are left it is computed anew
// (Drmac and Bujanovic, LAPACK Working Note 176).
void ColumnPivotedQr::take_from_norms(Eigen::Index k) {
  for (Eigen::Index j = k + 1; j < m_qr.cols(); ++j) {
    double& norm = m_colNormsUpdated[j];
    if (norm == 0) continue;
    const double taken = std::abs(m_qr(k, j)) / norm;
    const double rest = (1 + taken) * (1 - taken), kept = rest < 0 ? 0 : rest;
    if (kept * square(norm / m_colNormsDirect[j]) <= std::sqrt(epsilon))
      norm = m_colNormsDirect[j] = m_qr.col(j).tail(m_qr.rows() - k - 1).norm();
    else
      norm *= std::sqrt(kept);
  }
}

}  // namespace poinsot::solve
