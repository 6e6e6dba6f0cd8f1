// The sine and cosine kernel in units of the last place, against long double.
#include "poinsot/engine/math/algebra/sine_cosine.h"

#include <gtest/gtest.h>

#include <random>

#include "poinsot/engine/math/algebra/pack.h"

namespace poinsot {
namespace sine_cosine_test {

// Error of x in units of the last place of the exact value.
double ulps(double x, long double exact) {
  const double rounded = static_cast<double>(exact);
  const double unit = std::nextafter(std::fabs(rounded), INFINITY) - std::fabs(rounded);
  return static_cast<double>(std::fabs(static_cast<long double>(x) - exact)) / unit;
}

TEST(SineCosine, is_within_one_unit_of_the_last_place) {
  std::mt19937_64 engine(3);
  double worst = 0.0;
  const auto check = [&worst](double x) {
    const auto [s, c] = sine_cosine(x);
    worst = std::max(
        {worst, ulps(s, std::sin(static_cast<long double>(x))), ulps(c, std::cos(static_cast<long double>(x)))});
  };
  for (const double range : {1e-6, 1.0, 10.0, 1e3, 1e6, 1e15}) {
    std::uniform_real_distribution<double> uniform(-range, range);
    for (int i = 0; i < 20000; ++i) check(uniform(engine));
  }
  for (int k = 1; k < 2000; ++k) check(1.5707963267948966 * k);  // next to the zeros
  EXPECT_LT(worst, 1.0);
  EXPECT_GT(worst, 0.5);  // some rounding there must be
}

TEST(SineCosine, keeps_special_values) {
  EXPECT_EQ(sine_cosine(0.0).sine, 0.0);
  EXPECT_EQ(sine_cosine(0.0).cosine, 1.0);
  EXPECT_EQ(sine_cosine(1e-310).sine, 1e-310);
  EXPECT_TRUE(std::isnan(sine_cosine(INFINITY).sine));
  EXPECT_TRUE(std::isnan(sine_cosine(NAN).cosine));
}

TEST(SineCosine, lanes_of_packs_agree_with_double) {
  std::mt19937_64 engine(4);
  for (const double range : {1.0, 100.0, 1e7}) {
    std::uniform_real_distribution<double> uniform(-range, range);
    for (int trial = 0; trial < 1000; ++trial) {
      const Pack<8> x = Pack<8>::from_lanes([&](int) { return uniform(engine); });
      const auto [s, c] = sine_cosine(x);
      for (int i = 0; i < 8; ++i) {
        // The contraction of products and sums may move the last place.
        EXPECT_NEAR(s.lane(i), sine_cosine(x.lane(i)).sine, 2.3e-16);
        EXPECT_NEAR(c.lane(i), sine_cosine(x.lane(i)).cosine, 2.3e-16);
      }
    }
  }
}

}  // namespace sine_cosine_test
}  // namespace poinsot
