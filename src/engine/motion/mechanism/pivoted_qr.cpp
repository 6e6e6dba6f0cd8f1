#include "engine/motion/mechanism/pivoted_qr.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace poinsot::detail {

void PivotedQr::reserve(int most_rows, int most_columns) {
  const auto most = static_cast<std::size_t>(std::min(most_rows, most_columns));
  matrix_.resize(static_cast<std::size_t>(most_rows) * static_cast<std::size_t>(most_columns));
  leading_.resize(most);
  factor_.resize(most);
  left_.resize(static_cast<std::size_t>(most_columns));
  order_.resize(static_cast<std::size_t>(most_columns));
}

namespace {

// x less its part along a reflector: `lead` in row k, below it the rows of a. What does not change over many x is
// handed in, so that it stays in registers.
inline void reflect(const double* a, double lead, double factor, int k, int rows, double* x) {
  double sum = lead * x[k];
  for (int i = k + 1; i < rows; ++i) sum += a[i] * x[i];
  sum *= factor;
  x[k] -= sum * lead;
  for (int i = k + 1; i < rows; ++i) x[i] -= sum * a[i];
}

}  // namespace

void PivotedQr::factor(double tolerance, std::span<const char> classes, int most_rank) {
  const int most = std::min({rows_, columns_, most_rank});
  for (int k = 0; k < columns_; ++k) order_[static_cast<std::size_t>(k)] = k;
  for (rank_ = 0; rank_ < most; ++rank_) {
    const int k = rank_;
    // Norms are taken anew: updated ones lose digits where little is left.
    int pivot = -1;
    for (int j = k; j < columns_; ++j) {
      const int own = chosen(j);
      const double* const a = column(own);
      double sum = 0;
      for (int i = k; i < rows_; ++i) sum += a[i] * a[i];
      left_[static_cast<std::size_t>(own)] = std::sqrt(sum);
      if (!(left_[static_cast<std::size_t>(own)] > tolerance)) continue;
      const auto stands_before = [&](int other) {
        const auto own_class = classes.empty() ? 0 : classes[static_cast<std::size_t>(own)];
        const auto other_class = classes.empty() ? 0 : classes[static_cast<std::size_t>(other)];
        if (own_class != other_class) return own_class > other_class;
        return left_[static_cast<std::size_t>(own)] > left_[static_cast<std::size_t>(other)];
      };
      if (pivot < 0 || stands_before(chosen(pivot))) pivot = j;
    }
    if (pivot < 0) return;
    std::swap(order_[static_cast<std::size_t>(k)], order_[static_cast<std::size_t>(pivot)]);

    // The reflector that leaves of this column only its norm.
    double* const a = column(chosen(k));
    const double size = left_[static_cast<std::size_t>(chosen(k))];
    const double diagonal = a[k] > 0 ? -size : size;
    const double lead = a[k] - diagonal;
    leading_[static_cast<std::size_t>(k)] = lead;
    const double factor = -1 / (diagonal * lead);
    factor_[static_cast<std::size_t>(k)] = factor;
    a[k] = diagonal;
    const int rows = rows_;
    for (int j = k + 1; j < columns_; ++j) reflect(a, lead, factor, k, rows, column(chosen(j)));
  }
}

double PivotedQr::least_pivot() const {
  double least = 1, largest = 0;
  for (int k = 0; k < rank_; ++k) {
    largest = std::max(largest, std::abs(R(k, k)));
    least = k == 0 ? std::abs(R(k, k)) : std::min(least, std::abs(R(k, k)));
  }
  return largest > 0 ? least / largest : 1;
}

void PivotedQr::reflect_at(int k, double* x) const {
  const auto step = static_cast<std::size_t>(k);
  reflect(matrix_.data() + chosen(k) * rows_, leading_[step], factor_[step], k, rows_, x);
}

void PivotedQr::apply_transposed(double* x) const {
  for (int k = 0; k < rank_; ++k) reflect_at(k, x);
}

void PivotedQr::apply(double* x) const {
  for (int k = rank_ - 1; k >= 0; --k) reflect_at(k, x);
}

void PivotedQr::solve_upper(double* x) const {
  for (int i = rank_ - 1; i >= 0; --i) {
    double sum = x[i];
    for (int k = i + 1; k < rank_; ++k) sum -= R(i, k) * x[k];
    x[i] = sum / R(i, i);
  }
}

void PivotedQr::solve_transposed(double* x) const {
  for (int k = 0; k < rank_; ++k) {
    double sum = x[k];
    for (int i = 0; i < k; ++i) sum -= R(i, k) * x[i];
    x[k] = sum / R(k, k);
  }
}

}  // namespace poinsot::detail
