// Accuracies of eigenvalues against eigenvalues of disturbed matrices.
#include "engine/solve/stability/doubted_rates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace poinsot::solve {
namespace doubted_rates_test {

// A slow oscillation beside a fast one keeps the accuracy of its own entries.
TEST(DoubtedRates, ASlowRateBesideAFastOne) {
  for (const Real slow : {1e-3L, 1e-6L, 1e-9L}) {
    Matrix A = Matrix::Zero(4, 4);
    A(0, 1) = 1;
    A(1, 0) = -slow * slow;
    A(2, 3) = 1;
    A(3, 2) = -1;
    const Rates rates = rates_of({A, 1e-16L * A.cwiseAbs()});
    Real least = 1;
    for (Eigen::Index m = 0; m < 4; ++m) {
      const Real size = std::abs(rates.value[m]);
      least = std::min(least, size);
      EXPECT_LT(rates.doubt[m], 1e-8 * static_cast<double>(size));
    }
    EXPECT_NEAR(static_cast<double>(least / slow), 1, 1e-8);
  }
}

// As small disturbances within the doubts do move them.
TEST(DoubtedRates, DisturbancesMoveThemByNoMore) {
  std::mt19937_64 random(81);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    constexpr Eigen::Index n = 5;
    const Matrix A = Matrix::NullaryExpr(n, n, [&] { return Real(number(random)); });
    const Matrix doubt = Matrix::NullaryExpr(n, n, [&] { return Real(1e-10 * std::abs(number(random))); });
    const Matrix other = A + Matrix::NullaryExpr(n, n, [&] { return Real(number(random)); }).cwiseProduct(doubt);
    const Rates rates = rates_of({A, doubt}), moved = rates_of({other, doubt});
    for (Eigen::Index m = 0; m < n; ++m) {
      Real nearest = 1;
      for (Eigen::Index k = 0; k < n; ++k) nearest = std::min(nearest, std::abs(moved.value[k] - rates.value[m]));
      EXPECT_LE(static_cast<double>(nearest), rates.doubt[m] * (1 + 1e-3)) << trial;
    }
  }
}

// Two that meet can be told only to the root of the entries' doubts.
TEST(DoubtedRates, RatesThatMeetAreDoubtful) {
  Matrix A = Matrix::Zero(2, 2);
  A(0, 1) = 1;
  A(1, 0) = -1e-14L;
  Matrix doubt = Matrix::Zero(2, 2);
  doubt(1, 0) = 1e-14L;
  const Rates rates = rates_of({A, doubt});
  for (Eigen::Index m = 0; m < 2; ++m) EXPECT_GT(4 * rates.doubt[m], static_cast<double>(std::abs(rates.value[m])));
}

}  // namespace doubted_rates_test
}  // namespace poinsot::solve
