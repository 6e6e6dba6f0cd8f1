// The roots of the top's cubic against the same cubic in fifty digits.
#include "engine/motion/closed_form/top_cubic.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>
#include <numbers>

#include "engine/motion/closed_form/closed_form_support.h"

namespace poinsot {
namespace top_cubic_test {

using Digits50 = boost::multiprecision::cpp_bin_float_50;

// P(x) and its size, the sum of its terms without sign.
struct Value {
  Digits50 value, size;
};
struct Cubic {
  Digits50 epsilon, kappa, a, b;
  explicit Cubic(const TopCubicData& data) {
    const Digits50 x = cos(Digits50(data.nutation)), s2 = 1 - x * x, p = data.precession_rate;
    kappa = data.kappa;
    b = data.b;
    a = p * s2 + b * x;
    epsilon = Digits50(data.nutation_rate) * data.nutation_rate + p * p * s2 + kappa * x;
  }
  Value at(const Digits50& x) const {
    const Digits50 energy = (epsilon - kappa * x) * (1 - x * x), momentum = (a - b * x) * (a - b * x);
    return {energy - momentum, (fabs(epsilon) + fabs(kappa * x)) * fabs(Digits50(1 - x * x)) + momentum};
  }
  // The root between low and high, by halving.
  Digits50 root(Digits50 low, Digits50 high) const {
    const bool rising = at(low).value < at(high).value;
    for (int i = 0; i < 220; ++i) {
      const Digits50 middle = (low + high) / 2;
      ((at(middle).value < 0) == rising ? low : high) = middle;
    }
    return low;
  }
};

double relative(const Digits50& value, const Digits50& exact) {
  return static_cast<double>(fabs(Digits50((value - exact) / exact)));
}

TEST(TopCubic, roots_and_their_distances_are_right_to_long_double_digits) {
  RandomMotion random(1);
  int tested = 0;
  for (int i = 0; i < 1000 / closed_form_thinning; ++i) {
    const double small = i % 3 == 0 ? std::pow(10, -random.uniform(0, 8)) : 1;
    const TopCubicData data{random.uniform(0.01, 3.13), random.normal() * small, random.normal() * small,
                            3 * random.normal(), i % 5 == 0 ? 0 : random.uniform(0, 5)};
    const TopCubic found = solve_top_cubic(data);
    ASSERT_FALSE(found.steady);
    const Cubic cubic(data);
    const Digits50 x0 = cos(Digits50(data.nutation));
    const Digits50 x1 = cubic.root(-1, x0), x2 = cubic.root(x0, 1);
    // Roots are as well conditioned as P is steep there.
    const auto slope = [&](const Digits50& x) {
      const Digits50 h("1e-25");
      return fabs(Digits50((cubic.at(x + h).value - cubic.at(x - h).value) / (2 * h)));
    };
    const double rounding = static_cast<double>(std::numeric_limits<long double>::epsilon());
    const double bound1 = 10 * rounding * (1 + static_cast<double>(cubic.at(x1).size / slope(x1)));
    const double bound2 = 10 * rounding * (1 + static_cast<double>(cubic.at(x2).size / slope(x2)));
    EXPECT_LT(std::fabs(static_cast<double>(x1 + 1 - found.below1)), bound1);
    EXPECT_LT(std::fabs(static_cast<double>(1 - x2 - found.above2)), bound2);
    EXPECT_LT(std::fabs(static_cast<double>(x2 - x1 - found.spread)), bound1 + bound2);
    // Sums of distances are consistent.
    EXPECT_NEAR(static_cast<double>(found.above1 + found.below1), 2, 1e-15);
    EXPECT_NEAR(static_cast<double>(found.above2 + found.below2), 2, 1e-15);
    EXPECT_NEAR(static_cast<double>(found.to1 + found.to2 - found.spread), 0, 1e-18);
    // kappa (x1 + x2 + x3) = epsilon + b^2
    const Digits50 third = cubic.epsilon + cubic.b * cubic.b - cubic.kappa * (x1 + x2 + 1);
    EXPECT_LT(relative(found.third, third), 1e-12) << found.third;
    ++tested;
  }
  EXPECT_GT(tested, 40);
}

// Where an extreme is the start itself, or all but: the distance to it keeps relative digits.
TEST(TopCubic, small_distances_are_relative) {
  for (const double rate : {1e-3, 1e-6, 1e-9, 1e-12}) {
    // From a cusp, with a slight push in theta: P = p0 + p1 y + ..., p1 < 0.
    const TopCubicData data{1, rate, 0, 100, 4};
    const TopCubic found = solve_top_cubic(data);
    const Cubic cubic(data);
    const Digits50 x0 = cos(Digits50(1.0));
    const Digits50 to2 = cubic.root(x0, x0 + (1 - x0) / 100) - x0;
    EXPECT_LT(relative(found.to2, to2), 1e-15) << rate;
  }
  EXPECT_EQ(solve_top_cubic({1, 0, 0, 100, 4}).to2, 0);
}

TEST(TopCubic, has_exact_roots_on_the_vertical) {
  // Through the top with and without spin, from the bottom, and the pendulum at rest.
  const TopCubic top = solve_top_cubic({0, 3, 0.7L, 1, 4});
  EXPECT_EQ(top.above2, 0);
  EXPECT_EQ(top.difference, 0);
  EXPECT_EQ(top.to2, 0);
  const TopCubic bottom = solve_top_cubic({std::numbers::pi_v<long double>, 1, 0.7L, 1, 4});
  EXPECT_EQ(bottom.below1, 0);
  EXPECT_EQ(bottom.sum, 0);
  EXPECT_GT(bottom.above2, 0);
  const TopCubic pendulum = solve_top_cubic({1, 0, 0, 0, 4});
  EXPECT_EQ(pendulum.to2, 0);
  EXPECT_EQ(pendulum.below1, 0);
  EXPECT_EQ(pendulum.third, 0);
  // Up to the top and no further.
  const TopCubic limit = solve_top_cubic({std::numbers::pi_v<long double>, 2, 0, 0, 2});
  EXPECT_EQ(limit.above2, 0);
  EXPECT_EQ(limit.third, 0);
}

TEST(TopCubic, tells_steady_motion) {
  EXPECT_TRUE(solve_top_cubic({0, 0, 5, 1, 4}).steady);
  EXPECT_TRUE(solve_top_cubic({std::numbers::pi_v<long double>, 0, 5, 1, 4}).steady);
  EXPECT_TRUE(solve_top_cubic({0.8L, 0, 0, 3, 0}).steady);  // spin without weight
  EXPECT_FALSE(solve_top_cubic({0.8L, 0, 0, 3, 1}).steady);
  EXPECT_EQ(solve_top_cubic({0, 0, 5, 3, 4}).stiffness, 1);  // b^2 - 2 kappa
}

}  // namespace top_cubic_test
}  // namespace poinsot
