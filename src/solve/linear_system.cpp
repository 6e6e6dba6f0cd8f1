#include "poinsot/solve/linear_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot::solve {
namespace {

// A pivot below this part of the largest is rounding: entries are near one after scaling.
constexpr double rank_tolerance = 1e-11;
constexpr double conflict_tolerance = 1e-9;
constexpr double open_tolerance = 1e-9;

// Ruiz's scaling: rows and columns are brought to a largest entry near one. A row or column without entries stays.
void equilibrate(Eigen::MatrixXd& A, Eigen::VectorXd& rows, Eigen::VectorXd& columns) {
  if (A.size() == 0) return;
  for (int sweep = 0; sweep < 8; ++sweep) {
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
      const double largest = A.row(i).cwiseAbs().maxCoeff();
      if (largest == 0) continue;
      const double scale = 1 / std::sqrt(largest);
      A.row(i) *= scale;
      rows[i] *= scale;
    }
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
      const double largest = A.col(j).cwiseAbs().maxCoeff();
      if (largest == 0) continue;
      const double scale = 1 / std::sqrt(largest);
      A.col(j) *= scale;
      columns[j] *= scale;
    }
  }
}

}  // namespace

bool LinearSolution::determined(std::size_t unknown) const {
  return std::none_of(share.begin(), share.end(),
                      [&](const auto& moved) { return std::find(moved.begin(), moved.end(), unknown) != moved.end(); });
}

std::size_t LinearSystem::add_unknown(std::string name, double scale) {
  names_.push_back(std::move(name));
  unknown_scale_.push_back(scale);
  return names_.size() - 1;
}

std::size_t LinearSystem::add_equation(std::string words, double scale) {
  words_.push_back(std::move(words));
  equation_scale_.push_back(scale);
  right_side_.push_back(0);
  right_size_.push_back(0);
  return words_.size() - 1;
}

void LinearSystem::add(std::size_t equation, std::size_t unknown, double coefficient, std::optional<double> rounding) {
  entries_.push_back({equation, unknown, coefficient, rounding});
}

void LinearSystem::add_right_side(std::size_t equation, double value, double size) {
  right_side_[equation] += value;
  right_size_[equation] += std::max(std::abs(value), size);
}

LinearSolution LinearSystem::solve() const {
  // Without equations one that says nothing leaves every unknown open.
  const auto m = static_cast<Eigen::Index>(std::max<std::size_t>(equations(), 1));
  const auto n = static_cast<Eigen::Index>(unknowns());
  LinearSolution solution;
  solution.value.assign(unknowns(), 0.0);

  // In natural units.
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(m, n);
  Eigen::VectorXd b(m), rows(m), columns(n);
  rows.setOnes();
  b.setZero();
  for (std::size_t i = 0; i < equations(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    rows[row] = 1 / equation_scale_[i];
    b[row] = right_side_[i] * rows[row];
  }
  for (Eigen::Index j = 0; j < n; ++j) columns[j] = unknown_scale_[j];
  Eigen::MatrixXd rounding = Eigen::MatrixXd::Zero(m, n);
  std::vector<bool> known_rounding(static_cast<std::size_t>(m), true);
  for (const Entry& entry : entries_) {
    const auto i = static_cast<Eigen::Index>(entry.equation);
    const auto j = static_cast<Eigen::Index>(entry.unknown);
    A(i, j) += entry.coefficient * rows[i] * columns[j];
    rounding(i, j) += entry.rounding.value_or(0) * rows[i] * columns[j];
    if (!entry.rounding) known_rounding[entry.equation] = false;
  }
  // Numbers that overflowed on the way hold nowhere.
  for (Eigen::Index i = 0; i < m; ++i)
    if (!A.row(i).allFinite() || !std::isfinite(b[i])) solution.conflict.push_back(static_cast<std::size_t>(i));
  if (!solution.conflict.empty()) {
    solution.residual = std::numeric_limits<double>::infinity();
    return solution;
  }
  for (Eigen::Index i = 0; i < m && n; ++i)
    if (!known_rounding[static_cast<std::size_t>(i)])
      rounding.row(i).setConstant(1e-14 * A.row(i).cwiseAbs().maxCoeff());
  A = (A.array().abs() <= rounding.array()).select(0, A);
  Eigen::VectorXd row_scale = Eigen::VectorXd::Ones(m), column_scale = Eigen::VectorXd::Ones(n);
  if (m && n) equilibrate(A, row_scale, column_scale);
  b.array() *= row_scale.array();

  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  if (m && n) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
    qr.setThreshold(rank_tolerance);
    const Eigen::Index rank = qr.rank();
    const auto R = qr.matrixR();
    if (rank > 0) {
      solution.condition = std::abs(R(0, 0) / R(rank - 1, rank - 1));
      // The basic solution, with one step of refinement.
      const auto basic = [&](const Eigen::VectorXd& right) {
        Eigen::VectorXd c = right;
        c.applyOnTheLeft(qr.householderQ().setLength(qr.nonzeroPivots()).adjoint());
        Eigen::VectorXd y = Eigen::VectorXd::Zero(n);
        y.head(rank) = R.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(c.head(rank));
        return Eigen::VectorXd(qr.colsPermutation() * y);
      };
      x = basic(b);
      x += basic(b - A * x);
    }
    for (Eigen::Index k = rank; k < n; ++k) {
      Eigen::VectorXd y = Eigen::VectorXd::Zero(n);
      if (rank > 0)
        y.head(rank) = -R.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(R.col(k).head(rank));
      y[k] = 1;
      const Eigen::VectorXd direction = qr.colsPermutation() * y;
      const double size = direction.cwiseAbs().maxCoeff();
      std::vector<double> open(unknowns());
      std::vector<std::size_t> moved;
      for (Eigen::Index j = 0; j < n; ++j) {
        if (std::abs(direction[j]) <= open_tolerance * size) continue;
        open[j] = direction[j] * column_scale[j] * columns[j];
        moved.push_back(static_cast<std::size_t>(j));
      }
      solution.open.push_back(std::move(open));
      solution.share.push_back(std::move(moved));
    }
  }

  // Misfit, relative to the largest term met anywhere.
  const Eigen::VectorXd misfit = m ? Eigen::VectorXd(b - A * x) : Eigen::VectorXd();
  for (Eigen::Index i = 0; i < m; ++i) solution.misfit.push_back(misfit[i] / row_scale[i]);
  double term = 0;
  for (std::size_t i = 0; i < equations(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    term = std::max(term, right_size_[i] * rows[row] * row_scale[row]);
  }
  if (m && n) {
    const Eigen::VectorXd terms = A.cwiseAbs() * x.cwiseAbs();
    term = std::max(term, terms.maxCoeff());
    solution.size = terms.cwiseQuotient(row_scale).maxCoeff();
  }
  for (std::size_t i = 0; i < equations(); ++i)
    solution.size = std::max(solution.size, right_size_[i] * rows[static_cast<Eigen::Index>(i)]);
  if (m && term > 0) {
    solution.residual = misfit.cwiseAbs().maxCoeff() / term;
    if (!(solution.residual <= conflict_tolerance)) {
      const double worst = misfit.cwiseAbs().maxCoeff();
      for (Eigen::Index i = 0; i < m; ++i)
        if (!(std::abs(misfit[i]) <= 1e-6 * worst)) solution.conflict.push_back(static_cast<std::size_t>(i));
    }
  }
  for (Eigen::Index j = 0; j < n; ++j) solution.value[j] = x[j] * column_scale[j] * columns[j];
  return solution;
}

}  // namespace poinsot::solve
