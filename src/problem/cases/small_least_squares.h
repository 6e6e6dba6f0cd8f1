// Few linear equations in fewer unknowns, met as well as can be.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace poinsot::problem {

// By rotations (Givens) that take in an equation at a time, in memory that is kept from one system to the next: one is
// solved for each step of each case.
class SmallLeastSquares {
 public:
  explicit SmallLeastSquares(std::size_t unknowns)
      : n_(unknowns), triangle_(unknowns * (unknowns + 1), 0.0), value_(unknowns) {}

  // Begins another system of as many unknowns.
  void clear() { std::ranges::fill(triangle_, 0.0); }
  void add(std::span<const double> coefficients, double right_side) {
    row_.assign(coefficients.begin(), coefficients.end());
    row_.push_back(right_side);
    for (std::size_t k = 0; k < n_; ++k) {
      if (row_[k] == 0) continue;
      double* const pivot = triangle_.data() + k * (n_ + 1);
      const double length = std::hypot(pivot[k], row_[k]);
      const double c = pivot[k] / length, s = row_[k] / length;
      for (std::size_t j = k; j <= n_; ++j)
        std::tie(pivot[j], row_[j]) = std::pair(c * pivot[j] + s * row_[j], c * row_[j] - s * pivot[j]);
    }
  }

  // Not finite if the equations do not determine the unknowns.
  const std::vector<double>& solve() {
    // Of coefficients near one: less is rounding.
    constexpr double least = 1e-9;
    for (std::size_t k = n_; k-- > 0;) {
      const double* const row = triangle_.data() + k * (n_ + 1);
      double rest = row[n_];
      for (std::size_t j = k + 1; j < n_; ++j) rest -= row[j] * value_[j];
      value_[k] = std::fabs(row[k]) > least ? rest / row[k] : std::numeric_limits<double>::quiet_NaN();
    }
    return value_;
  }

 private:
  std::size_t n_;
  std::vector<double> triangle_, value_, row_;
};

}  // namespace poinsot::problem
