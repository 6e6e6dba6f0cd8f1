#include "engine/solve/roots/chebyshev_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poinsot::solve {
namespace chebyshev_series_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ChebyshevSeries random_series(std::mt19937_64& random, Index components, Index size0, Index size1) {
  std::normal_distribution<double> normal;
  ChebyshevSeries series(components, size0, size1);
  for (Index k = 0; k < size0 * size1; ++k)
    for (Index i = 0; i < components; ++i) series.coefficients()(i, k) = normal(random);
  return series;
}

Pair random_place(std::mt19937_64& random) {
  std::uniform_real_distribution<double> part(-1, 1);
  return {part(random), part(random)};
}

TEST(ChebyshevSeries, ItsValueIsTheSumOfCosinesOfMultipleAngles) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const ChebyshevSeries series = random_series(random, 2, 1 + trial % 7, 1 + trial % 4);
    const Pair s = random_place(random);
    VectorXd expected = VectorXd::Zero(2);
    for (Index j = 0; j < series.size(1); ++j)
      for (Index i = 0; i < series.size(0); ++i)
        expected += std::cos(static_cast<double>(i) * std::acos(s[0])) *
                    std::cos(static_cast<double>(j) * std::acos(s[1])) * series.coefficient(i, j);
    EXPECT_LT((series(s) - expected).norm(), 1e-12);
  }
}

TEST(ChebyshevSeries, InterpolationReproducesAPolynomialFromItsValues) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Index size0 = 1 + trial % 9, size1 = 1 + trial % 5;
    const ChebyshevSeries series = random_series(random, 3, size0, size1);
    MatrixXd values(3, size0 * size1);
    for (Index j = 0; j < size1; ++j)
      for (Index i = 0; i < size0; ++i)
        values.col(i + size0 * j) = series({inner_point(size0, i), inner_point(size1, j)});
    EXPECT_LT((interpolated(values, size0, size1).coefficients() - series.coefficients()).cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST(ChebyshevSeries, InnerPointsAreAmongThoseForTwiceAsManyAndOne) {
  for (Index count : {1, 3, 7, 15})
    for (Index k = 0; k < count; ++k) EXPECT_NEAR(inner_point(count, k), inner_point(2 * count + 1, 2 * k + 1), 1e-16);
  EXPECT_EQ(inner_point(7, 3), 0);
}

TEST(ChebyshevSeries, ARestrictionHasTheSameValues) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const ChebyshevSeries series = random_series(random, 2, 1 + trial % 8, 1 + trial % 6);
    const ChebyshevSeries part = series.restricted(0, 0.3, 0.2).restricted(1, -0.5, 0.4);
    const Pair s = random_place(random);
    EXPECT_LT((part(s) - series({0.3 + 0.2 * s[0], -0.5 + 0.4 * s[1]})).norm(), 1e-12);
  }
}

TEST(ChebyshevSeries, SlopesAreThoseOfDifferencesAndOfTheDerivative) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const ChebyshevSeries series = random_series(random, 2, 1 + trial % 7, 1 + trial % 5);
    const Pair s = random_place(random);
    MatrixXd slopes;
    EXPECT_LT((series.with_slopes(s, slopes) - series(s)).norm(), 1e-12);
    for (int k = 0; k < 2; ++k) {
      Pair ahead = s, behind = s;
      ahead[static_cast<std::size_t>(k)] += 1e-5;
      behind[static_cast<std::size_t>(k)] -= 1e-5;
      EXPECT_LT((slopes.col(k) - (series(ahead) - series(behind)) / 2e-5).norm(), 1e-6);
      EXPECT_LT((slopes.col(k) - series.derivative(k)(s)).norm(), 1e-11);
    }
  }
}

TEST(ChebyshevSeries, TrimmingDropsNoMoreThanAllowed) {
  ChebyshevSeries series(1, 4, 3);
  series.coefficient(0, 0)[0] = 1;
  series.coefficient(1, 1)[0] = 0.5;
  series.coefficient(2, 0)[0] = 1e-8;
  series.coefficient(0, 2)[0] = -2e-8;
  ChebyshevSeries same = series;
  EXPECT_EQ(same.trim(1e-9), 0);
  EXPECT_EQ(same.size(0), 3);  // the last one was zero
  EXPECT_EQ(same.size(1), 3);
  EXPECT_NEAR(series.trim(1e-7), 3e-8, 1e-20);
  EXPECT_EQ(series.size(0), 2);
  EXPECT_EQ(series.size(1), 2);
  EXPECT_EQ(series.coefficient(1, 1)[0], 0.5);
}

}  // namespace chebyshev_series_test
}  // namespace poinsot::solve
