// Even phases against exact products.
#include "poinsot/engine/motion/integrator/phase.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>

#include "engine/motion/closed_form/closed_form_support.h"

namespace poinsot {
namespace phase_test {

using Digits50 = boost::multiprecision::cpp_bin_float_50;

TEST(Phase, keeps_its_fraction_at_any_time) {
  RandomMotion random(1);
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    const long double rate = static_cast<long double>(random.normal()) / 3, offset = random.normal() / 7.0L;
    const double t = std::copysign(std::pow(10, random.uniform(-3, 15)), random.normal());
    const Phase phase(rate, offset);
    const auto [count, fraction] = phase.at(t);
    const Digits50 exact = Digits50(rate) * Digits50(t) + Digits50(offset);
    EXPECT_EQ(count, std::nearbyint(count));
    EXPECT_LE(std::fabs(fraction), 0.5 + 1e-15 + 1e-16 * std::fabs(t));
    // The rate is held to twice a double's digits; the fraction to a double's.
    const Digits50 error = Digits50(count) + Digits50(fraction) - exact;
    raise(worst, static_cast<double>(fabs(error)) / (1.2e-16 + 1e-31 * std::fabs(t)));
    const double relative = static_cast<double>((phase.total(t) - exact) / exact);
    EXPECT_LT(std::fabs(relative), 1.2e-16);
  }
  EXPECT_LT(worst, 1);
  EXPECT_GT(worst, 0.01);
}

TEST(Phase, stays_within_a_cycle_beyond_all_digits) {
  for (const double t : {1e17, -3.7e19, 1e30, 1e100}) {
    EXPECT_LE(std::fabs(Phase(1 / 3.0L, 0.25L).at(t).fraction), 0.75);
  }
}

TEST(CellPhase, splits_off_periods_and_their_parity) {
  const long double K = 1.7L;
  const CellPhase cells(2, 0.3L, K);
  for (const double t : {-100.0, -3.0, 0.0, 0.8, 1.0, 2.5, 1e6}) {
    const CellPhase::Place place = cells.at(t);
    EXPECT_LE(std::fabs(place.argument), static_cast<double>(K) * (1 + 1e-15));
    EXPECT_NEAR(static_cast<double>(2 * K) * place.count + place.argument, 2 * t + 0.3, 1e-15 * (1 + std::fabs(t)));
    EXPECT_EQ(place.odd(), std::fmod(place.count, 2) != 0);
  }
  EXPECT_FALSE((CellPhase::Place{1e300, 0}).odd());
  EXPECT_FALSE((CellPhase::Place{std::numeric_limits<double>::quiet_NaN(), 0}).odd());
  EXPECT_TRUE((CellPhase::Place{-3, 0}).odd());
}

TEST(CellPhase, without_period_is_the_argument_itself) {
  const CellPhase::Place place = CellPhase(2, 0.25L, std::numeric_limits<long double>::infinity()).at(1000);
  EXPECT_EQ(place.count, 0);
  EXPECT_EQ(place.argument, 2000.25);
}

}  // namespace phase_test
}  // namespace poinsot
