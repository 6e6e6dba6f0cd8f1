// Numbers with a bound on their rounding, against numbers that were disturbed.
#include "poinsot/engine/math/algebra/rounded.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "case_count.h"
#include "poinsot/engine/math/algebra/dual.h"

namespace poinsot {
namespace rounded_test {

// Every operation there is, with differences of neighbours that cancel.
template <class Scalar>
Scalar expression(const Scalar& a, const Scalar& b, const Scalar& c) {
  using std::atan2;
  using std::sqrt;
  const auto [s, k] = sine_cosine(Scalar(a * b));
  const Scalar root = sqrt(Scalar(a * a + c * c)), left = a * c - b;
  return (s * root - k / c) * (left - Scalar(2) * b) + (root - a) / (Scalar(3) + left * left) + atan2(b, left);
}

// Whatever the numbers truly are within their bounds, the result is within its own; and it is not much too wide.
TEST(Rounded, BoundsWhatDisturbancesDo) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(0.3, 2), part(-1, 1);
  for (int trial = 0; trial < poinsot::testing::case_count(2000); ++trial) {
    std::array<Rounded, 3> x;
    for (Rounded& each : x) each = Rounded(number(random), 1e-10L);
    const Rounded result = expression(x[0], x[1], x[2]);
    long double largest = 0;
    for (int attempt = 0; attempt < 20; ++attempt) {
      std::array<long double, 3> there;
      for (std::size_t i = 0; i < 3; ++i) {
        const double sign = part(random);
        there[i] = x[i].value + x[i].error * (attempt % 2 == 0 ? sign : std::copysign(1.0, sign));
      }
      const long double moved = expression(there[0], there[1], there[2]);
      largest = std::max(largest, std::fabs(moved - result.value));
    }
    EXPECT_LE(largest, result.error);
    EXPECT_LE(result.error, 3e-8L);
    EXPECT_GT(result.error, 1e-11L);
  }
}

// A long double holds what a double has lost: the bound of the derivative of a double's function holds as well.
TEST(Rounded, BoundsDerivatives) {
  using Varied = Dual<1, Rounded>;
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> number(0.3, 2);
  for (int trial = 0; trial < poinsot::testing::case_count(2000); ++trial) {
    const double a = number(random), b = number(random), c = number(random);
    const Varied slope =
        expression(Varied::variable(Rounded::stated(a), 0), Varied(Rounded::stated(b)), Varied(Rounded::stated(c)));
    const long double e = std::numeric_limits<double>::epsilon();
    const Dual<1, long double> moved = expression(Dual<1, long double>::variable(a * (1 + e), 0),
                                                  Dual<1, long double>(b * (1 - e)), Dual<1, long double>(c * (1 + e)));
    EXPECT_LE(std::fabs(moved.partial[0] - slope.partial[0].value), slope.partial[0].error);
    EXPECT_LE(slope.partial[0].error, 1e-13L);
  }
}

TEST(Rounded, WhatIsNotThereHasNoRounding) {
  const Rounded zero, x = Rounded::stated(0.1);
  for (const Rounded& nothing :
       {zero * x, x * zero, zero + zero, -zero, zero / x, sqrt(zero), sine_cosine(zero).sine}) {
    EXPECT_EQ(nothing.value, 0);
    EXPECT_EQ(nothing.error, 0);
  }
  EXPECT_TRUE((x - x).may_vanish());
  EXPECT_FALSE(x.may_vanish());
  EXPECT_TRUE(std::isinf((x / (x - x)).error));
}

}  // namespace rounded_test
}  // namespace poinsot
