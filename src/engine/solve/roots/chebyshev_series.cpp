#include "engine/solve/roots/chebyshev_series.h"

#include <cmath>
#include <map>
#include <numbers>

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The polynomials T_0 to T_{count-1} at s, and their derivatives k U_{k-1}.
void chebyshev(double s, Index count, VectorXd& T, VectorXd* slope) {
  T.resize(count);
  T[0] = 1;
  if (count > 1) T[1] = s;
  for (Index k = 2; k < count; ++k) T[k] = 2 * s * T[k - 1] - T[k - 2];
  if (!slope) return;
  slope->resize(count);
  double U_before = 0, U = 1;
  (*slope)[0] = 0;
  for (Index k = 1; k < count; ++k) {
    (*slope)[k] = static_cast<double>(k) * U;
    const double next = 2 * s * U - U_before;
    U_before = U;
    U = next;
  }
}

// Column k holds T_k(middle + half s) as a series in s.
MatrixXd shift_matrix(Index count, double middle, double half) {
  MatrixXd S = MatrixXd::Zero(count, count);
  S(0, 0) = 1;
  if (count > 1) {
    S(0, 1) = middle;
    S(1, 1) = half;
  }
  for (Index k = 2; k < count; ++k) {
    S.col(k) = 2 * middle * S.col(k - 1) - S.col(k - 2);
    // s T_j = (T_{j+1} + T_{|j-1|}) / 2.
    for (Index j = 0; j < k; ++j) {
      const double c = half * S(j, k - 1);
      S(j + 1, k) += c;
      S(j == 0 ? 1 : j - 1, k) += c;
    }
  }
  return S;
}

// Row i: the coefficient of T_i from the values at the inner points.
MatrixXd interpolation_matrix(Index count) {
  const double step = std::numbers::pi / static_cast<double>(count + 1);
  MatrixXd second(count, count);  // of U_j
  for (Index j = 0; j < count; ++j)
    for (Index k = 0; k < count; ++k) {
      const double angle = step * static_cast<double>(k + 1);
      second(j, k) =
          2 / static_cast<double>(count + 1) * std::sin(static_cast<double>(j + 1) * angle) * std::sin(angle);
    }
  // U_j = 2 (T_j + T_{j-2} + ...), ending in T_1 or in half of T_0.
  MatrixXd M = 2 * second;
  for (Index i = count - 3; i >= 0; --i) M.row(i) += M.row(i + 2);
  M.row(0) /= 2;
  return M;
}

const MatrixXd& known_interpolation_matrix(Index count) {
  thread_local std::map<Index, MatrixXd> known;
  auto [entry, fresh] = known.try_emplace(count);
  if (fresh) entry->second = interpolation_matrix(count);
  return entry->second;
}

}  // namespace

ChebyshevSeries::ChebyshevSeries(Index components, Index size0, Index size1)
    : size_{size0, size1}, c_(MatrixXd::Zero(components, size0 * size1)) {}

VectorXd ChebyshevSeries::operator()(const Pair& s) const {
  VectorXd T0, T1;
  chebyshev(s[0], size_[0], T0, nullptr);
  chebyshev(s[1], size_[1], T1, nullptr);
  VectorXd value = VectorXd::Zero(components());
  for (Index j = 0; j < size_[1]; ++j) value += T1[j] * (c_.middleCols(j * size_[0], size_[0]) * T0);
  return value;
}

VectorXd ChebyshevSeries::with_slopes(const Pair& s, MatrixXd& slopes) const {
  VectorXd T0, T1, D0, D1;
  chebyshev(s[0], size_[0], T0, &D0);
  chebyshev(s[1], size_[1], T1, &D1);
  VectorXd value = VectorXd::Zero(components());
  slopes.setZero(components(), 2);
  for (Index j = 0; j < size_[1]; ++j) {
    const auto row = c_.middleCols(j * size_[0], size_[0]);
    const VectorXd inner = row * T0;
    value += T1[j] * inner;
    slopes.col(0) += T1[j] * (row * D0);
    slopes.col(1) += D1[j] * inner;
  }
  return value;
}

ChebyshevSeries ChebyshevSeries::restricted(int variable, double middle, double half) const {
  ChebyshevSeries result(components(), size_[0], size_[1]);
  const MatrixXd S = shift_matrix(size(variable), middle, half);
  if (variable == 0) {
    for (Index j = 0; j < size_[1]; ++j)
      result.c_.middleCols(j * size_[0], size_[0]).noalias() =
          c_.middleCols(j * size_[0], size_[0]).lazyProduct(S.transpose());
  } else {
    for (Index to = 0; to < size_[1]; ++to)
      for (Index from = to; from < size_[1]; ++from)
        result.c_.middleCols(to * size_[0], size_[0]) += S(to, from) * c_.middleCols(from * size_[0], size_[0]);
  }
  return result;
}

ChebyshevSeries ChebyshevSeries::derivative(int variable) const {
  ChebyshevSeries result(components(), size_[0], size_[1]);
  const Index count = size(variable), stride = variable == 0 ? 1 : size_[0];
  const Index lines = size(1 - variable), line_stride = variable == 0 ? size_[0] : 1;
  for (Index line = 0; line < lines; ++line) {
    const auto column = [&](auto& c, Index k) { return c.col(line * line_stride + k * stride); };
    // The derivative has the coefficients d_{k-1} = d_{k+1} + 2 k c_k, where d_0 is halved at the end.
    for (Index k = count - 1; k >= 1; --k) {
      column(result.c_, k - 1) = 2 * static_cast<double>(k) * column(c_, k);
      if (k + 1 < count) column(result.c_, k - 1) += column(result.c_, k + 1);
    }
    column(result.c_, 0) /= 2;
  }
  return result;
}

double ChebyshevSeries::trim(double tolerance) {
  double dropped = 0;
  for (int variable = 0; variable < 2; ++variable) {
    const auto v = static_cast<std::size_t>(variable);
    Index keep = size_[v];
    while (keep > 1) {
      double sum = 0;
      for (Index other = 0; other < size(1 - variable); ++other)
        sum += (variable == 0 ? coefficient(keep - 1, other) : coefficient(other, keep - 1)).norm();
      if (dropped + sum > tolerance) break;
      dropped += sum;
      --keep;
    }
    if (keep == size_[v]) continue;
    std::array<Index, 2> size = size_;
    size[v] = keep;
    ChebyshevSeries shorter(components(), size[0], size[1]);
    for (Index j = 0; j < size[1]; ++j)
      for (Index i = 0; i < size[0]; ++i) shorter.coefficient(i, j) = coefficient(i, j);
    *this = std::move(shorter);
  }
  return dropped;
}

double inner_point(Index count, Index k) {
  // The sine gives an exact zero for the middle point, which a cosine would miss by rounding.
  return std::sin(std::numbers::pi * (0.5 - static_cast<double>(k + 1) / static_cast<double>(count + 1)));
}

ChebyshevSeries interpolated(const MatrixXd& values, Index count0, Index count1) {
  ChebyshevSeries series(values.rows(), count0, count1), half(values.rows(), count0, count1);
  const MatrixXd &M0 = known_interpolation_matrix(count0), &M1 = known_interpolation_matrix(count1);
  for (Index j = 0; j < count1; ++j)
    half.coefficients().middleCols(j * count0, count0) = values.middleCols(j * count0, count0) * M0.transpose();
  for (Index to = 0; to < count1; ++to)
    for (Index from = 0; from < count1; ++from)
      series.coefficients().middleCols(to * count0, count0) +=
          M1(to, from) * half.coefficients().middleCols(from * count0, count0);
  return series;
}

}  // namespace poinsot::solve
