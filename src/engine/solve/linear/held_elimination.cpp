#include "engine/solve/linear/held_elimination.h"

#include <algorithm>
#include <cmath>

#include "engine/solve/linear/decompositions.h"

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The part of cancelling terms that may be left as rounding: times the tolerance for zero it makes some tens of units
// in the last place.
constexpr double rounding_share = 1e-5;

struct Determinant {
  double log = 0;
  bool negative = false;
};

Determinant determinant_of(const Eigen::PartialPivLU<MatrixXd>& lu) {
  Determinant result;
  result.negative = lu.permutationP().determinant() < 0;
  for (Index i = 0; i < lu.rows(); ++i) {
    const double pivot = lu.matrixLU()(i, i);
    result.log += std::log(std::abs(pivot));
    result.negative ^= pivot < 0;
  }
  return result;
}

}  // namespace

HeldPivots pivots_of(const MatrixXd& A, double rank_tolerance, const std::vector<bool>& late) {
  // A pivot of this size is good, since entries are near one after scaling: it costs six digits of sixteen at most, and
  // is taken in the order in which rows come rather than for a larger one elsewhere.
  constexpr double good_size = 1e-6;
  HeldPivots pivots;
  pivots.rows = Eigen::PermutationMatrix<Eigen::Dynamic>(A.rows());
  pivots.columns = Eigen::PermutationMatrix<Eigen::Dynamic>(A.cols());
  pivots.rows.setIdentity();
  pivots.columns.setIdentity();
  if (A.size() == 0 || A.isZero(0)) return pivots;
  // Below, row and column hold the order of B = rows A columns. The rows that come late stand last, and give pivots
  // only when the others have no good one left.
  std::vector<Index> row, column;
  for (const bool last : {false, true})
    for (Index i = 0; i < A.rows(); ++i)
      if ((!late.empty() && late[static_cast<std::size_t>(i)]) == last) row.push_back(i);
  for (Index j = 0; j < A.cols(); ++j) column.push_back(j);
  const auto early = late.empty() ? A.rows() : static_cast<Index>(std::count(late.begin(), late.end(), false));
  MatrixXd B(A.rows(), A.cols());
  for (Index i = 0; i < A.rows(); ++i) B.row(i) = A.row(row[static_cast<std::size_t>(i)]);
  Index& k = pivots.rank;
  double largest = 0;
  bool all = early == A.rows();
  while (k < std::min(A.rows(), A.cols())) {
    const Index rows = (all ? A.rows() : early) - k, columns = A.cols() - k;
    Index i = 0, j = 0;
    const double size = rows > 0 ? B.block(k, k, rows, columns).cwiseAbs().maxCoeff(&i, &j) : 0;
    if (!all && !(size > good_size)) {
      all = true;
      continue;
    }
    largest = std::max(largest, size);
    if (!(size > rank_tolerance * largest)) break;
    B.row(k).swap(B.row(k + i));
    B.col(k).swap(B.col(k + j));
    std::swap(row[static_cast<std::size_t>(k)], row[static_cast<std::size_t>(k + i)]);
    std::swap(column[static_cast<std::size_t>(k)], column[static_cast<std::size_t>(k + j)]);
    const Index below = A.rows() - k - 1, right = columns - 1;
    const VectorXd factors = B.col(k).tail(below) / B(k, k);
    B.bottomRightCorner(below, right) -= factors * B.row(k).tail(right);
    ++k;
  }
  for (Index i = 0; i < A.rows(); ++i) pivots.rows.indices()[row[static_cast<std::size_t>(i)]] = static_cast<int>(i);
  for (Index j = 0; j < A.cols(); ++j)
    pivots.columns.indices()[j] = static_cast<int>(column[static_cast<std::size_t>(j)]);
  const MatrixXd scaled = pivots.rows * A * pivots.columns;
  const Determinant det = determinant_of(Eigen::PartialPivLU<MatrixXd>(scaled.topLeftCorner(k, k)));
  pivots.log_determinant = det.log;
  pivots.negative = det.negative;
  return pivots;
}

std::optional<Remainder> remainder_of(const HeldPivots& pivots, const MatrixXd& A, const VectorXd& b,
                                      const VectorXd& right_size) {
  if (A.rows() != pivots.rows.size() || A.cols() != pivots.columns.size()) return std::nullopt;
  if (!A.allFinite() || !b.allFinite()) return std::nullopt;
  const Index rank = pivots.rank, rest = A.rows() - rank, open = A.cols() - rank;
  const MatrixXd B = pivots.rows * A * pivots.columns;
  const VectorXd c = pivots.rows * b, c_size = pivots.rows * right_size;
  Remainder result;
  result.solution = VectorXd::Zero(A.cols());
  double& ratio = result.ratio;
  VectorXd left = VectorXd::Zero(rest), terms = c_size.tail(rest).cwiseMax(c.tail(rest).cwiseAbs());
  if (rank > 0) {
    const Eigen::PartialPivLU<MatrixXd> lu(B.topLeftCorner(rank, rank));
    const Determinant det = determinant_of(lu);
    if (!std::isfinite(det.log)) return std::nullopt;
    ratio = std::exp(det.log - pivots.log_determinant) * (det.negative == pivots.negative ? 1 : -1);
    const auto A21 = B.bottomLeftCorner(rest, rank);
    // One step of refinement takes out what rounding has left in y.
    VectorXd y = lu.solve(c.head(rank));
    y += lu.solve(c.head(rank) - B.topLeftCorner(rank, rank) * y);
    left = A21 * y;
    terms = terms.cwiseMax((A21.cwiseAbs() * y.cwiseAbs()));
    // Where y itself is the small difference of larger terms, their rounding reaches the remainder through A21 A11^-1
    // and has to be allowed for in its size.
    const VectorXd cancelling = B.topLeftCorner(rank, rank).cwiseAbs() * y.cwiseAbs() + c.head(rank).cwiseAbs();
    // That matters only where they are larger by more than a remainder's tolerance for zero can bear.
    constexpr double beside = 1e-9;
    if (rest > 0 && terms.maxCoeff() < beside * cancelling.maxCoeff()) {
      MatrixXd shares = A21.transpose();  // becomes (A21 A11^-1)^T with the rows in the order of the factors
      lu.matrixLU().triangularView<Eigen::Upper>().transpose().solveInPlace(shares);
      lu.matrixLU().triangularView<Eigen::UnitLower>().transpose().solveInPlace(shares);
      terms = terms.cwiseMax(rounding_share * (shares.transpose().cwiseAbs() * (lu.permutationP() * cancelling)));
    }
    if (open > 0 && rest > 0) {
      // The Schur complement S of the columns without pivots must vanish; else A has a higher rank than the pivots.
      const auto A12 = B.topRightCorner(rank, open);
      const MatrixXd X = lu.solve(A12), S = B.bottomRightCorner(rest, open) - A21 * X;
      const double size = std::max(1.0, (A21.cwiseAbs() * X.cwiseAbs()).maxCoeff());
      const double smallest = lu.matrixLU().diagonal().cwiseAbs().minCoeff();
      // Of pivots near one, and of the terms of S: with pivots that have half of the digits, S has the other half, of
      // which a hundredth is left to what it was multiplied by.
      constexpr double sound_pivot = 1e-8, vanishing = 1e-6;
      if (smallest > sound_pivot && S.cwiseAbs().maxCoeff() > vanishing * size) return std::nullopt;
    }
    VectorXd placed = VectorXd::Zero(A.cols());
    placed.head(rank) = y;
    result.solution = pivots.columns * placed;
  }
  result.values = ratio * (c.tail(rest) - left);
  result.size = rest > 0 ? std::abs(ratio) * terms.maxCoeff() : 0;
  if (!result.values.allFinite() || !std::isfinite(result.size)) return std::nullopt;
  return result;
}

// With y = A11^-1 b1: dy = A11^-1 (db1 - dA11 y), d(det A11) = det A11 tr(A11^-1 dA11).
RemainderRates remainder_rates(const HeldPivots& pivots, const MatrixXd& A, const Remainder& remainder,
                               const MatrixXd& A_rate, const VectorXd& b_rate) {
  const Index rank = pivots.rank, rest = A.rows() - rank;
  const MatrixXd B = pivots.rows * A * pivots.columns, B_rate = pivots.rows * A_rate * pivots.columns;
  const VectorXd c_rate = pivots.rows * b_rate;
  RemainderRates rates{remainder.ratio * c_rate.tail(rest), VectorXd::Zero(A.cols())};
  if (rank == 0) return rates;
  const Eigen::PartialPivLU<MatrixXd> lu(B.topLeftCorner(rank, rank));
  const VectorXd y = (pivots.columns.transpose() * remainder.solution).head(rank);
  const VectorXd y_rate = lu.solve(c_rate.head(rank) - B_rate.topLeftCorner(rank, rank) * y);
  const VectorXd left_rate = B_rate.bottomLeftCorner(rest, rank) * y + B.bottomLeftCorner(rest, rank) * y_rate;
  const double log_ratio_rate = lu.solve(B_rate.topLeftCorner(rank, rank)).trace();
  rates.values = log_ratio_rate * remainder.values - remainder.ratio * left_rate + rates.values;
  VectorXd placed = VectorXd::Zero(A.cols());
  placed.head(rank) = y_rate;
  rates.solution = pivots.columns * placed;
  return rates;
}

}  // namespace poinsot::solve
