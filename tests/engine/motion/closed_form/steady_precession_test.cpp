// Steady precession: the rates put into the moment equation, and into the general motion of the top.
#include "poinsot/engine/motion/closed_form/steady_precession.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/motion/closed_form/closed_form_support.h"

namespace poinsot {
namespace steady_precession_test {

TEST(SteadyPrecession, rates_balance_the_moment_of_the_weight) {
  RandomMotion random(1);
  int pairs = 0;
  for (int i = 0; i < 1000; ++i) {
    const TopParameters top{random.uniform(0.3, 2), random.uniform(0.1, 1), 4 * random.normal()};
    const double theta = random.uniform(0.05, 3.1), given = 12 * random.normal();
    for (const bool of_spin : {false, true}) {
      const auto rates =
          of_spin ? steady_precession_rates_of_spin(top, theta, given) : steady_precession_rates(top, theta, given);
      pairs += rates.size() == 2;
      for (const double p : rates) {
        const double w_z = of_spin ? given + p * std::cos(theta) : given;
        const double left = top.axial_moment * w_z * p, right = top.transverse_moment * p * p * std::cos(theta);
        EXPECT_NEAR(left - right, top.gravity_moment,
                    1e-13 * (std::fabs(left) + std::fabs(right) + std::fabs(top.gravity_moment)));  // Eq. 18.44
        // Started so, the top does not nutate.
        const SymmetricTop motion(top, {theta, 0, 0, p, 0, w_z});
        EXPECT_NEAR(motion.at(1.7).nutation, theta, 1e-12);
        EXPECT_NEAR(motion.mean_precession_rate(), p, 1e-10 * (1 + std::fabs(p)));
      }
      if (rates.size() == 2) {
        EXPECT_LT(rates[0], rates[1]);
      }
    }
  }
  EXPECT_GT(pairs, 800);
}

TEST(SteadyPrecession, slow_rate_of_a_fast_spin_keeps_its_digits) {
  const TopParameters top{2, 1, 3};
  const auto rates = steady_precession_rates(top, 1, 1e9);
  ASSERT_EQ(rates.size(), 2U);
  EXPECT_NEAR(rates[0], 3e-9 * (1 + 2 * std::cos(1.0) * 3e-18), 1e-24);
}

TEST(SteadyPrecession, has_one_rate_across_and_none_for_slow_spins) {
  const TopParameters top{2, 1, 3};
  EXPECT_EQ(steady_precession_rates(top, std::numbers::pi / 2, 6), std::vector<double>{0.5});
  EXPECT_TRUE(steady_precession_rates(top, std::numbers::pi / 2, 0).empty());
  EXPECT_TRUE(steady_precession_rates(top, 0.3, 1).empty());
  // At theta = 60 deg, I^2 w^2 = 4 I' cos(theta) m g c = 12.
  const auto critical = steady_precession_rates(top, std::numbers::pi / 3, std::sqrt(12.0));
  ASSERT_EQ(critical.size(), 1U);
  EXPECT_NEAR(critical[0], std::sqrt(3.0), 1e-15);
  // Conical pendulum: p^2 cos(theta) = g/l downward, either way round.
  const auto conical = steady_precession_rates({4, 0, 2 * 9.81 * 2}, 2 * std::numbers::pi / 3, 0);
  EXPECT_TRUE(conical.empty() || conical.size() == 2U);
  ASSERT_EQ(conical.size(), 2U);
  EXPECT_NEAR(conical[1], std::sqrt(9.81 * 2), 1e-14);
  EXPECT_EQ(conical[0], -conical[1]);
}

TEST(SteadyPrecession, sleeping_rate_divides_stable_from_unstable) {
  const TopParameters top{2, 0.5, 3};
  const double least = least_sleeping_rate(top);
  EXPECT_NEAR(least, 2 * std::sqrt(6.0) / 0.5, 1e-14);
  for (const double factor : {0.99, 1.01}) {
    const SymmetricTop motion(top, {1e-6, 0, 0, 0, 0, factor * least});
    const double largest = motion.nutation_range().maximum;
    if (factor < 1) {
      EXPECT_GT(largest, 0.1);
    } else {
      EXPECT_LT(largest, 1e-4);
    }
  }
  EXPECT_EQ(least_sleeping_rate({2, 0.5, -3}), 0);
  EXPECT_EQ(least_sleeping_rate({2, 0, 3}), std::numeric_limits<double>::infinity());
}

}  // namespace steady_precession_test
}  // namespace poinsot
