// With y the forces of the contacts and cords, y0 those of the solution and Z the open directions, all that the
// equations allow is y = y0 + Z t. With N Z = 0 that is N y = N y0, and y >= 0 makes it a linear program.
#include "problem/instant/one_sided_shares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/solve/linear/decompositions.h"
#include "engine/solve/linear/linear_program.h"

namespace poinsot::problem {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the largest force or the largest entry of a direction: what sums of a few dozen terms leave of zero. A hundred
// times more would take a light body on a heavy one for a force that vanishes.
constexpr double rounding = 1e-10;

// Rows that stand across all columns of Z.
MatrixXd across(const MatrixXd& Z) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr(Z);
  qr.setThreshold(rounding);
  const MatrixXd Q = qr.householderQ();
  return Q.rightCols(Z.rows() - qr.rank()).transpose();
}

// The columns that Z takes to zero.
MatrixXd kernel(const MatrixXd& Z) { return across(Z.transpose()).transpose(); }

// The shares in which no force is negative, as A x = b with x >= 0. The last unknown is what is left of `most` for the
// sum of all, whose equation is divided by that: what counts as fulfilled goes by the largest right side. The forces
// are in units of the largest.
struct Shares {
  MatrixXd A;
  VectorXd b;
  Shares(const VectorXd& y0, const MatrixXd& Z, double most) {
    const MatrixXd N = across(Z);
    const Index n = y0.size();
    A = MatrixXd::Zero(N.rows() + 1, n + 1);
    A.topLeftCorner(N.rows(), n) = N;
    A.row(N.rows()).setConstant(1 / most);
    b = VectorXd(N.rows() + 1);
    b.head(N.rows()) = N * y0;
    b[N.rows()] = 1;
  }
};

// The shares in which no force is negative: the middle of those in which one of them after another is as large as it
// can be, up to ten times the sizes of all, for where bodies can be pressed together nothing bounds them. A force that
// is zero there is zero in every share. Nothing if there are none. The forces are in units of the largest.
std::optional<VectorXd> middle_share(const VectorXd& y0, const MatrixXd& Z) {
  const Index n = y0.size();
  const auto [A, b] = Shares(y0, Z, 10 * static_cast<double>(n));
  VectorXd sum = VectorXd::Zero(n);
  for (Index k = 0; k < n; ++k) {
    const std::optional<solve::LinearOptimum> found = solve::maximise(A, b, VectorXd::Unit(n + 1, k));
    if (!found) return std::nullopt;
    sum += found->x.head(n);
  }
  return sum / static_cast<double>(n);
}

MatrixXd columns_of(const std::vector<std::vector<double>>& vectors, const std::vector<std::size_t>& rows) {
  MatrixXd Z(static_cast<Index>(rows.size()), static_cast<Index>(vectors.size()));
  for (Index d = 0; d < Z.cols(); ++d)
    for (Index i = 0; i < Z.rows(); ++i)
      Z(i, d) = vectors[static_cast<std::size_t>(d)][rows[static_cast<std::size_t>(i)]];
  return Z;
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

// Replaces the open directions by combinations of them, the columns of C.
void combine(solve::LinearSolution& solution, const MatrixXd& C) {
  std::vector<std::vector<double>> open;
  std::vector<std::vector<std::size_t>> share;
  for (Index j = 0; j < C.cols(); ++j) {
    std::vector<double> direction(solution.value.size(), 0);
    for (std::size_t d = 0; d < solution.open.size(); ++d)
      for (std::size_t k = 0; k < direction.size(); ++k)
        direction[k] += C(static_cast<Index>(d), j) * solution.open[d][k];
    const double largest = largest_of(direction);
    std::vector<std::size_t> moved;
    for (std::size_t k = 0; k < direction.size(); ++k)
      if (std::abs(direction[k]) > rounding * largest) moved.push_back(k);
    open.push_back(std::move(direction));
    share.push_back(std::move(moved));
  }
  solution.open = std::move(open);
  solution.share = std::move(share);
}

}  // namespace

namespace {

// Those of the unknowns named that open directions move, if only shares are open; else none.
std::vector<std::size_t> shared_among(const solve::LinearSolution& solution, const std::vector<std::size_t>& one_sided,
                                      std::size_t fixed) {
  std::vector<std::size_t> shared;
  if (!solution.conflict.empty()) return shared;
  for (const std::vector<double>& direction : solution.open) {
    const double largest = largest_of(direction);
    for (std::size_t k = 0; k < fixed; ++k)
      if (std::abs(direction[k]) > rounding * largest) return shared;
  }
  for (const std::size_t k : one_sided)
    if (std::any_of(solution.open.begin(), solution.open.end(),
                    [&](const auto& direction) { return std::abs(direction[k]) > rounding * largest_of(direction); }))
      shared.push_back(k);
  return shared;
}

}  // namespace

bool share_without_pull(solve::LinearSolution& solution, const std::vector<std::size_t>& one_sided, std::size_t fixed) {
  const std::vector<std::size_t> shared = shared_among(solution, one_sided, fixed);
  if (shared.empty()) return false;
  VectorXd y0(static_cast<Index>(shared.size()));
  for (Index i = 0; i < y0.size(); ++i) y0[i] = solution.value[shared[static_cast<std::size_t>(i)]];
  const double size = y0.cwiseAbs().maxCoeff();
  if (!(size > 0)) return false;
  const MatrixXd Z = columns_of(solution.open, shared);
  const std::optional<VectorXd> middle = middle_share(y0 / size, Z);
  if (!middle) return false;
  const VectorXd t = Eigen::CompleteOrthogonalDecomposition<MatrixXd>(Z).solve(VectorXd(size * *middle - y0));
  for (std::size_t d = 0; d < solution.open.size(); ++d)
    for (std::size_t k = 0; k < solution.value.size(); ++k)
      solution.value[k] += t[static_cast<Index>(d)] * solution.open[d][k];
  std::vector<std::size_t> none;
  for (Index i = 0; i < y0.size(); ++i) {
    const std::size_t k = shared[static_cast<std::size_t>(i)];
    if ((*middle)[i] > rounding) continue;
    solution.value[k] = 0;
    none.push_back(k);
  }
  if (!none.empty()) combine(solution, kernel(columns_of(solution.open, none)));
  return true;
}

void slacken_chain(solve::LinearSolution& solution, const std::vector<std::size_t>& sides) {
  if (solution.open.empty() || !solution.conflict.empty()) return;
  constexpr double alike = 1e-8;  // of the change in one side: what elimination leaves
  std::size_t ring = solution.open.size();
  double largest = 0;
  for (std::size_t d = 0; d < solution.open.size(); ++d) {
    const std::vector<double>& direction = solution.open[d];
    double mean = 0, off = 0;
    for (const std::size_t k : sides) mean += direction[k] / static_cast<double>(sides.size());
    for (const std::size_t k : sides) off = std::max(off, std::abs(direction[k] - mean));
    const double part = std::abs(mean) / largest_of(direction);
    if (off <= alike * std::abs(mean) && part > largest) {
      largest = part;
      ring = d;
    }
  }
  if (ring == solution.open.size() || !(largest > rounding)) return;
  const std::vector<double> whole = solution.open[ring];
  double least = solution.value[sides.front()];
  for (const std::size_t k : sides) least = std::min(least, solution.value[k]);
  const double change = -least / whole[sides.front()];
  for (std::size_t k = 0; k < solution.value.size(); ++k) solution.value[k] += change * whole[k];
  // What else is open leaves the chain as it is.
  const auto count = static_cast<Index>(solution.open.size());
  MatrixXd C = MatrixXd::Zero(count, count - 1);
  for (Index d = 0, column = 0; d < count; ++d) {
    if (d == static_cast<Index>(ring)) continue;
    C(d, column) = 1;
    C(static_cast<Index>(ring), column) =
        -solution.open[static_cast<std::size_t>(d)][sides.front()] / whole[sides.front()];
    ++column;
  }
  combine(solution, C);
}

// A direction that no one-sided force shares goes on without end. Along the others t follows from the forces.
std::optional<double> largest_over_shares(const solve::LinearSolution& solution,
                                          const std::vector<std::size_t>& one_sided, std::size_t fixed,
                                          const std::vector<double>& slopes) {
  const std::vector<std::size_t> shared = shared_among(solution, one_sided, fixed);
  if (shared.empty()) return std::nullopt;
  VectorXd y0(static_cast<Index>(shared.size()));
  for (Index i = 0; i < y0.size(); ++i) y0[i] = solution.value[shared[static_cast<std::size_t>(i)]];
  const double size = y0.cwiseAbs().maxCoeff();
  if (!(size > 0)) return std::nullopt;
  const MatrixXd Z = columns_of(solution.open, shared);
  const Eigen::Map<const VectorXd> g(slopes.data(), static_cast<Index>(slopes.size()));
  const MatrixXd free = kernel(Z);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (free.cols() > 0 && (free.transpose() * g).cwiseAbs().maxCoeff() > rounding * g.cwiseAbs().maxCoeff())
    return infinite;
  const Index n = y0.size();
  VectorXd c = VectorXd::Zero(n + 1);
  c.head(n) = VectorXd(Eigen::CompleteOrthogonalDecomposition<MatrixXd>(Z.transpose()).solve(VectorXd(g)));
  const double scale = c.cwiseAbs().maxCoeff();
  if (!(scale > 0)) return 0;
  // Where nothing bounds the value it grows with the bound on the sum of all.
  const auto largest_up_to = [&](double most) -> std::optional<double> {
    const auto [A, b] = Shares(y0 / size, Z, most * static_cast<double>(n));
    const std::optional<solve::LinearOptimum> found = solve::maximise(A, b, c / scale);
    if (!found) return std::nullopt;
    return found->value;
  };
  const std::optional<double> near = largest_up_to(10), far = largest_up_to(20);
  if (!near || !far) return std::nullopt;
  constexpr double grows = 1e-6;
  if (*far > *near + grows) return infinite;
  return size * (scale * *near - c.head(n).dot(y0 / size));
}

void keep_pushing(const std::vector<double>& from, const std::vector<std::size_t>& one_sided, std::vector<double>& to) {
  double part = 1;
  for (const std::size_t k : one_sided)
    if (from[k] > 0 && to[k] < 0) part = std::min(part, 0.5 * from[k] / (from[k] - to[k]));
  for (std::size_t k = 0; k < to.size(); ++k) to[k] = from[k] + part * (to[k] - from[k]);
}

}  // namespace poinsot::problem
