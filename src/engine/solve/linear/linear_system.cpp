#include "poinsot/engine/solve/linear/linear_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/solve/linear/assembled_system.h"
#include "engine/solve/linear/column_pivoted_qr.h"
#include "engine/solve/linear/decompositions.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {
namespace {

// The misfit of the least-squares solution, as a part of the terms, from which equations contradict one another. What
// is stated to nine digits fits; a well posed system leaves 1e-14, and one at the edge of what has a rank 1e-11. With
// a tenth of this, data that were rounded to nine digits would clash.
constexpr double conflict_tolerance = 1e-9;
// The equations that miss by less than this part of the largest misfit take no part in a contradiction.
constexpr double no_part = 1e-6;
// Of the largest entry of a direction along which a solution may move: an unknown that moves by less is determined.
// Directions are known to rounding over the least pivot, at worst 1e-16/1e-11 of themselves, but mostly to 1e-14.
constexpr double open_tolerance = 1e-9;
// Each sweep takes the square root of what scales are apart (Ruiz): after eight, 1e100 is down to a factor of 2.5.
constexpr int scaling_sweeps = 8;

}  // namespace

void equilibrate(Eigen::MatrixXd& A, Eigen::VectorXd& rows, Eigen::VectorXd& columns) {
  if (A.size() == 0) return;
  const auto scale = [](double largest) { return largest == 0 ? 1 : 1 / std::sqrt(largest); };
  // Plain loops in the order of storage: the systems are small, and there are many of them.
  const Eigen::Index m = A.rows(), n = A.cols();
  Eigen::VectorXd factors(m);
  double* const factor = factors.data();
  for (int sweep = 0; sweep < scaling_sweeps; ++sweep) {
    factors.setZero();
    for (Eigen::Index j = 0; j < n; ++j) {
      const double* const column = &A.coeffRef(0, j);
      for (Eigen::Index i = 0; i < m; ++i) factor[i] = std::max(factor[i], std::abs(column[i]));
    }
    for (Eigen::Index i = 0; i < m; ++i) {
      factor[i] = scale(factor[i]);
      rows[i] *= factor[i];
    }
    for (Eigen::Index j = 0; j < n; ++j) {
      double* const column = &A.coeffRef(0, j);
      double largest = 0;
      for (Eigen::Index i = 0; i < m; ++i) {
        column[i] *= factor[i];
        largest = std::max(largest, std::abs(column[i]));
      }
      const double by = scale(largest);
      for (Eigen::Index i = 0; i < m; ++i) column[i] *= by;
      columns[j] *= by;
    }
  }
}

bool LinearSolution::determined(std::size_t unknown) const {
  return std::none_of(share.begin(), share.end(),
                      [&](const auto& moved) { return std::find(moved.begin(), moved.end(), unknown) != moved.end(); });
}

template <class Scalar>
typename LinearSystemOf<Scalar>::Text LinearSystemOf<Scalar>::text_from(std::initializer_list<std::string_view> parts) {
  // The equations of a body or two fit without another allocation.
  if (text_.empty()) {
    text_.reserve(512);
    unknowns_.reserve(16);
    equations_.reserve(16);
    entries_.reserve(64);
  }
  const std::size_t begin = text_.size();
  for (const std::string_view part : parts) text_ += part;
  return {begin, text_.size() - begin};
}

template <class Scalar>
std::size_t LinearSystemOf<Scalar>::add_unknown(std::initializer_list<std::string_view> name, double scale) {
  unknowns_.push_back({text_from(name), scale});
  return unknowns_.size() - 1;
}

template <class Scalar>
std::size_t LinearSystemOf<Scalar>::add_equation(std::initializer_list<std::string_view> words, double scale,
                                                 EquationSource source) {
  equations_.push_back({text_from(words), scale, source, Scalar(0)});
  return equations_.size() - 1;
}

template <class Scalar>
void LinearSystemOf<Scalar>::add(std::size_t equation, std::size_t unknown, const Scalar& coefficient,
                                 std::optional<double> rounding) {
  entries_.push_back({equation, unknown, coefficient, rounding});
}

template <class Scalar>
void LinearSystemOf<Scalar>::add_right_side(std::size_t equation, const Scalar& value, double size) {
  equations_[equation].right_side += value;
  equations_[equation].right_size += std::max(std::abs(plain(value)), size);
}

template <class Scalar>
std::vector<std::vector<Scalar>> LinearSystemOf<Scalar>::coefficients() const {
  std::vector<std::vector<Scalar>> rows(equations(), std::vector<Scalar>(unknowns(), Scalar(0)));
  for (const Entry& entry : entries_) rows[entry.equation][entry.unknown] += entry.coefficient;
  return rows;
}

template <class Scalar>
std::vector<Scalar> LinearSystemOf<Scalar>::right_sides() const {
  std::vector<Scalar> list;
  for (const Equation& equation : equations_) list.push_back(equation.right_side);
  return list;
}

template <class Scalar>
LinearSolution LinearSystemOf<Scalar>::solve() const {
  return LinearFactors(*this).solution();
}

// Sizes: m equations (at least one), n unknowns. A y = b are the scaled equations: A_ij = row_i a_ij column_j.
struct LinearFactors::Parts {
  Eigen::MatrixXd A;
  Eigen::VectorXd row, column;              // factors from the units of the caller to the scaled ones
  Eigen::VectorXd row_scale, column_scale;  // the part of these factors that goes beyond natural units
  Eigen::VectorXd x, misfit;                // scaled
  std::optional<ColumnPivotedQr> qr;
  Eigen::Index rank = 0;
  bool finite = true;
  LinearSolution solution;

  auto triangle() const { return qr->matrixR().topLeftCorner(rank, rank).template triangularView<Eigen::Upper>(); }
  // Solves for a right side with the unknowns outside the pivots at zero.
  Eigen::VectorXd basic(const Eigen::VectorXd& right) const {
    Eigen::VectorXd c = right;
    c.applyOnTheLeft(qr->householderQ().setLength(qr->nonzeroPivots()).adjoint());
    Eigen::VectorXd y = Eigen::VectorXd::Zero(A.cols());
    y.head(rank) = triangle().solve(c.head(rank));
    return qr->colsPermutation() * y;
  }
  void find_open_directions();
};

void LinearFactors::Parts::find_open_directions() {
  const Eigen::Index n = A.cols();
  for (Eigen::Index k = rank; k < n; ++k) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(n);
    if (rank > 0) y.head(rank) = -triangle().solve(qr->matrixR().col(k).head(rank));
    y[k] = 1;
    const Eigen::VectorXd direction = qr->colsPermutation() * y;
    const double size = direction.cwiseAbs().maxCoeff();
    std::vector<double> open(static_cast<std::size_t>(n));
    std::vector<std::size_t> moved;
    for (Eigen::Index j = 0; j < n; ++j) {
      if (std::abs(direction[j]) <= open_tolerance * size) continue;
      open[j] = direction[j] * column[j];
      moved.push_back(static_cast<std::size_t>(j));
    }
    solution.open.push_back(std::move(open));
    solution.share.push_back(std::move(moved));
  }
}

template <class Scalar>
LinearFactors::LinearFactors(const LinearSystemOf<Scalar>& system) : parts_(std::make_unique<Parts>()) {
  Parts& parts = *parts_;
  AssembledSystem<Scalar> assembled(system);
  Eigen::MatrixXd& A = parts.A;
  A = std::move(assembled.A);
  Eigen::VectorXd& b = assembled.b;
  const Eigen::VectorXd &rows = assembled.row, &columns = assembled.column;
  const Eigen::Index m = A.rows(), n = A.cols();
  count_work(work_of_factors(static_cast<Work>(m), static_cast<Work>(n)));
  LinearSolution& solution = parts.solution;
  solution.value.assign(system.unknowns(), 0.0);
  // An equation whose numbers have overflowed is reported as one that does not hold.
  solution.conflict = assembled.bad;
  if (!solution.conflict.empty()) {
    solution.residual = std::numeric_limits<double>::infinity();
    parts.finite = false;
    return;
  }
  parts.row_scale = Eigen::VectorXd::Ones(m);
  parts.column_scale = Eigen::VectorXd::Ones(n);
  if (m && n) equilibrate(A, parts.row_scale, parts.column_scale);
  parts.row = rows.cwiseProduct(parts.row_scale);
  parts.column = columns.cwiseProduct(parts.column_scale);
  b.array() *= parts.row_scale.array();

  Eigen::VectorXd& x = parts.x;
  x = Eigen::VectorXd::Zero(n);
  if (m && n) {
    parts.qr.emplace(A);
    parts.qr->setThreshold(rank_tolerance);
    parts.rank = parts.qr->rank();
    if (parts.rank > 0) {
      const auto R = parts.qr->matrixR();
      solution.condition = std::abs(R(0, 0) / R(parts.rank - 1, parts.rank - 1));
      // One step of refinement takes out what rounding has left in x.
      x = parts.basic(b);
      x += parts.basic(b - A * x);
    }
    parts.find_open_directions();
  }

  // The misfit is measured by the largest term that occurs in any equation.
  parts.misfit = b - A * x;
  const Eigen::VectorXd& misfit = parts.misfit;
  for (Eigen::Index i = 0; i < m; ++i) solution.misfit.push_back(misfit[i] / parts.row_scale[i]);
  double term = 0;
  for (std::size_t i = 0; i < system.equations(); ++i)
    term = std::max(term, system.equations_[i].right_size * parts.row[static_cast<Eigen::Index>(i)]);
  if (m && n) {
    const Eigen::VectorXd terms = A.cwiseAbs() * x.cwiseAbs();
    term = std::max(term, terms.maxCoeff());
    solution.size = terms.cwiseQuotient(parts.row_scale).maxCoeff();
  }
  for (std::size_t i = 0; i < system.equations(); ++i)
    solution.size = std::max(solution.size, system.equations_[i].right_size * rows[static_cast<Eigen::Index>(i)]);
  if (term > 0) {
    solution.residual = misfit.cwiseAbs().maxCoeff() / term;
    if (!(solution.residual <= conflict_tolerance)) {
      const double worst = misfit.cwiseAbs().maxCoeff();
      for (Eigen::Index i = 0; i < m; ++i)
        if (!(std::abs(misfit[i]) <= no_part * worst)) solution.conflict.push_back(static_cast<std::size_t>(i));
    }
  }
  for (Eigen::Index j = 0; j < n; ++j) solution.value[static_cast<std::size_t>(j)] = x[j] * parts.column[j];
}

LinearFactors::LinearFactors(LinearFactors&&) noexcept = default;
LinearFactors& LinearFactors::operator=(LinearFactors&&) noexcept = default;
LinearFactors::~LinearFactors() = default;

const LinearSolution& LinearFactors::solution() const { return parts_->solution; }

namespace {

// The rates of the logarithms of the factors that equilibrate() finds. Each factor follows the largest entry of its
// row or column, and so does its rate.
struct ScalingRates {
  Eigen::VectorXd rows, columns;
};
ScalingRates scaling_rates(Eigen::MatrixXd A, Eigen::MatrixXd A_rate) {
  ScalingRates rates{Eigen::VectorXd::Zero(A.rows()), Eigen::VectorXd::Zero(A.cols())};
  const auto scale = [](auto&& line, auto&& line_rate, double& rate) {
    Eigen::Index largest = 0;
    const double size = line.cwiseAbs().maxCoeff(&largest);
    if (size == 0) return;
    const double factor = 1 / std::sqrt(size), change = -0.5 * line_rate[largest] / line[largest];
    line *= factor;
    line_rate = factor * line_rate + change * line;
    rate += change;
  };
  for (int sweep = 0; sweep < scaling_sweeps && A.size() > 0; ++sweep) {
    for (Eigen::Index i = 0; i < A.rows(); ++i) scale(A.row(i), A_rate.row(i), rates.rows[i]);
    for (Eigen::Index j = 0; j < A.cols(); ++j) scale(A.col(j), A_rate.col(j), rates.columns[j]);
  }
  return rates;
}

}  // namespace

LinearDerivative LinearFactors::derivative(const LinearSystemOf<Dual<1>>& varied) const {
  const Parts& parts = *parts_;
  const Eigen::Index m = parts.A.rows(), n = parts.A.cols(), rank = parts.rank;
  LinearDerivative derivative;
  if (!parts.finite) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    derivative.value.assign(static_cast<std::size_t>(n), none);
    derivative.misfit.assign(static_cast<std::size_t>(m), none);
    return derivative;
  }
  // The solution minimises |A x - b|. Its rate follows from h = db - dA x and g = dA^T r, r the misfit, all scaled.
  const AssembledSystem<Dual<1>> assembled(varied);
  const ScalingRates scaling = scaling_rates(assembled.A, assembled.A_rate);
  const Eigen::MatrixXd A_rate =
      Eigen::MatrixXd(parts.row_scale.asDiagonal() * assembled.A_rate * parts.column_scale.asDiagonal()) +
      scaling.rows.asDiagonal() * parts.A + parts.A * scaling.columns.asDiagonal();
  const Eigen::VectorXd b = parts.A * parts.x + parts.misfit;
  const Eigen::VectorXd h =
      parts.row_scale.cwiseProduct(assembled.b_rate) + scaling.rows.cwiseProduct(b) - A_rate * parts.x;
  const Eigen::VectorXd g = A_rate.transpose() * parts.misfit;
  // With A P = Q [R S; 0 0]: c = Q^T h, u = R^-T of the basic part of P^T g; dy = R^-1 (c_1 + u), dr = Q [-u; c_2].
  Eigen::VectorXd dx = Eigen::VectorXd::Zero(n), dr = h;
  if (rank > 0) {
    const auto Q = parts.qr->householderQ().setLength(parts.qr->nonzeroPivots());
    dr.applyOnTheLeft(Q.adjoint());
    const Eigen::VectorXd basic_g = parts.qr->colsPermutation().transpose() * g;
    const Eigen::VectorXd u = parts.qr->matrixR()
                                  .topLeftCorner(rank, rank)
                                  .transpose()
                                  .triangularView<Eigen::Lower>()
                                  .solve(basic_g.head(rank));
    Eigen::VectorXd y = Eigen::VectorXd::Zero(n);
    y.head(rank) = parts.triangle().solve(dr.head(rank) + u);
    dx = parts.qr->colsPermutation() * y;
    dr.head(rank) = -u;
    dr.applyOnTheLeft(Q);
  }
  for (Eigen::Index j = 0; j < n; ++j)
    derivative.value.push_back((dx[j] + scaling.columns[j] * parts.x[j]) * parts.column[j]);
  for (Eigen::Index i = 0; i < m; ++i)
    derivative.misfit.push_back((dr[i] - scaling.rows[i] * parts.misfit[i]) / parts.row_scale[i]);
  return derivative;
}

template class LinearSystemOf<double>;
template class LinearSystemOf<Dual<1>>;
template class LinearSystemOf<Formula>;
template LinearFactors::LinearFactors(const LinearSystemOf<double>&);
template LinearFactors::LinearFactors(const LinearSystemOf<Formula>&);
template LinearFactors::LinearFactors(const LinearSystemOf<Dual<1>>&);

}  // namespace poinsot::solve
