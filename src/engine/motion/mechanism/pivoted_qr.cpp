#include "engine/motion/mechanism/pivoted_qr.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace poinsot::detail {
namespace {

// A sum waits for each of its additions. So columns are reflected in strips, eight side by side, each to the last bit
// as it is alone. The compiler's own vectors of two are fast where little is optimised, too.
constexpr int strip = 8;
using Two [[gnu::vector_size(2 * sizeof(double)), gnu::aligned(alignof(double)), gnu::may_alias]] = double;

int in_whole_strips(int columns) { return (columns + strip - 1) / strip * strip; }
Two& two(double* x) { return *reinterpret_cast<Two*>(x); }

// A strip less its part along a reflector: `lead` in row k, below it the rows of a.
void reflect(const double* a, double lead, double factor, int k, int rows, double* x, int stride) {
  double* y = x + k * stride;
  Two p = lead * two(y), q = lead * two(y + 2), r = lead * two(y + 4), s = lead * two(y + 6);
  for (int i = k + 1; i < rows; ++i) {
    y += stride;
    p += a[i] * two(y);
    q += a[i] * two(y + 2);
    r += a[i] * two(y + 4);
    s += a[i] * two(y + 6);
  }
  p *= factor;
  q *= factor;
  r *= factor;
  s *= factor;
  const auto take = [&](double part, double* from) {
    two(from) -= p * part;
    two(from + 2) -= q * part;
    two(from + 4) -= r * part;
    two(from + 6) -= s * part;
  };
  take(lead, x + k * stride);
  for (int i = k + 1; i < rows; ++i) take(a[i], x + i * stride);
}

}  // namespace

void PivotedQr::reserve(int most_rows, int most_columns) {
  const auto most = static_cast<std::size_t>(std::min(most_rows, most_columns));
  const auto rows = static_cast<std::size_t>(most_rows),
             columns = static_cast<std::size_t>(in_whole_strips(most_columns));
  matrix_.resize(rows * columns);
  reflectors_.resize(rows * most);
  leading_.resize(most);
  factor_.resize(most);
  left_.resize(columns);
  strip_.resize(rows * strip);
  order_.resize(columns);
}

void PivotedQr::resize(int rows, int columns) {
  rows_ = rows;
  columns_ = columns;
  stride_ = in_whole_strips(columns);
  for (int i = 0; i < rows; ++i) std::fill(row(i) + columns, row(i) + stride_, 0.0);
}

// Norms are taken anew: updated ones lose digits where little is left.
void PivotedQr::find_what_is_left(int k) {
  for (int j = k / 4 * 4; j < columns_; j += 4) {
    Two p{}, q{};
    for (int i = k; i < rows_; ++i) {
      double* const x = row(i) + j;
      p += two(x) * two(x);
      q += two(x + 2) * two(x + 2);
    }
    two(left_.data() + j) = p;
    two(left_.data() + j + 2) = q;
  }
}

// The column at place `pivot` comes to place k.
void PivotedQr::choose(int k, int pivot) {
  if (pivot == k) return;
  std::swap(order_[static_cast<std::size_t>(k)], order_[static_cast<std::size_t>(pivot)]);
  std::swap(left_[static_cast<std::size_t>(k)], left_[static_cast<std::size_t>(pivot)]);
  for (int i = 0; i < rows_; ++i) std::swap(row(i)[k], row(i)[pivot]);
}

void PivotedQr::factor(double tolerance, std::span<const char> classes, int most_rank) {
  const int most = std::min({rows_, columns_, most_rank});
  for (int k = 0; k < columns_; ++k) order_[static_cast<std::size_t>(k)] = k;
  for (rank_ = 0; rank_ < most; ++rank_) {
    const int k = rank_;
    find_what_is_left(k);
    int pivot = -1;
    for (int j = k; j < columns_; ++j) {
      double& left = left_[static_cast<std::size_t>(j)];
      left = std::sqrt(left);
      if (!(left > tolerance)) continue;
      const auto class_of = [&](int place) {
        return classes.empty() ? 0 : classes[static_cast<std::size_t>(chosen(place))];
      };
      if (pivot < 0 || class_of(j) > class_of(pivot) ||
          (class_of(j) == class_of(pivot) && left > left_[static_cast<std::size_t>(pivot)]))
        pivot = j;
    }
    if (pivot < 0) return;
    choose(k, pivot);

    // The reflector that leaves of this column only its norm. What stands behind is reflected in whole strips: columns
    // that are done have zeros there.
    double* const a = reflectors_.data() + k * rows_;
    for (int i = k + 1; i < rows_; ++i) a[i] = std::exchange(row(i)[k], 0.0);
    const double size = left_[static_cast<std::size_t>(k)];
    const double first = std::exchange(row(k)[k], 0.0);
    const double diagonal = first > 0 ? -size : size;
    const double lead = first - diagonal;
    leading_[static_cast<std::size_t>(k)] = lead;
    const double factor = -1 / (diagonal * lead);
    factor_[static_cast<std::size_t>(k)] = factor;
    for (int j = (k + 1) / strip * strip; k + 1 < columns_ && j < columns_; j += strip)
      reflect(a, lead, factor, k, rows_, matrix_.data() + j, stride_);
    row(k)[k] = diagonal;
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
  const double* const a = reflector(k);
  const double lead = leading_[static_cast<std::size_t>(k)];
  double sum = lead * x[k];
  for (int i = k + 1; i < rows_; ++i) sum += a[i] * x[i];
  sum *= factor_[static_cast<std::size_t>(k)];
  x[k] -= sum * lead;
  for (int i = k + 1; i < rows_; ++i) x[i] -= sum * a[i];
}

void PivotedQr::apply_transposed(double* x) const {
  for (int k = 0; k < rank_; ++k) reflect_at(k, x);
}

void PivotedQr::apply_transposed(double* X, int columns) {
  for (int j = 0; j < columns; j += strip) {
    const int taken = std::min(strip, columns - j);
    for (int i = 0; i < rows_; ++i) std::copy_n(X + i * columns + j, taken, strip_.data() + i * strip);
    for (int k = 0; k < rank_; ++k)
      reflect(reflector(k), leading_[static_cast<std::size_t>(k)], factor_[static_cast<std::size_t>(k)], k, rows_,
              strip_.data(), strip);
    for (int i = 0; i < rows_; ++i) std::copy_n(strip_.data() + i * strip, taken, X + i * columns + j);
  }
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
