// How far off the rates of a linearisation may be, against rates that are known.
#include "poinsot/engine/solve/stability/linearisation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "case_count.h"
#include "poinsot/engine/model/builder.h"

namespace poinsot::solve {
namespace linearisation_test {

// A wheel on a torsion spring with a damper: I l^2 + c l + k = 0.
struct Wheel {
  Mechanism<double> mechanism;

  Wheel(double inertia, double damping, double stiffness) {
    ModelBuilder<double> builder;
    builder.add_body("wheel", ground, Joint<double>::revolute({0, 0, 1}), SpatialTransform<double>::identity(),
                     MassProperties<double>{1, {0, 0, 0}, SymmetricMatrix3<double>::diagonal(1, 1, inertia)});
    mechanism.tree = builder.build();
    mechanism.takes_part = {true};
    mechanism.actions.push_back({ActionKind::drive, "pin", "pin", 0, ground});
    Drive<double> drive;
    drive.stiffness = stiffness;
    drive.damping = damping;
    mechanism.drives.push_back(drive);
  }
  Linearisation near() const {
    SteadyMotion motion;
    motion.mechanism = &mechanism;
    motion.q = {0};
    motion.v = {0};
    motion.held = {false};
    motion.given = {std::nullopt};
    return linearise(motion);
  }
};

// The doubt holds what the rate is off by, however close two rates are, and is no more than rounding brings.
TEST(Linearisation, RatesAreOffByNoMoreThanTheirDoubt) {
  using Complex = std::complex<long double>;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> part(-1, 1);
  const auto any = [&] { return std::pow(10, 2 * part(random)); };
  int growing = 0;
  for (int trial = 0; trial < poinsot::testing::case_count(2000); ++trial) {
    const double I = any(), c = any() * (trial % 2 == 0 ? 1 : 0), k = any() * (trial % 3 == 0 ? -1 : 1);
    const Linearisation near = Wheel(I, c, k).near();
    ASSERT_TRUE(near.steady);
    const Complex root = std::sqrt(Complex(1.0L * c * c - 4.0L * I * k, 0)), b = c / (2.0L * I);
    const Complex one = -b + root / (2.0L * I), other = -b - root / (2.0L * I);
    for (const Mode& mode : near.modes) {
      const Complex rate(mode.growth_rate, mode.frequency);
      const long double off = std::min(std::abs(rate - one), std::abs(rate - other));
      EXPECT_LE(static_cast<double>(off), mode.doubt + 1e-16 * static_cast<double>(std::abs(rate)));
      EXPECT_LE(mode.doubt * static_cast<double>(std::abs(root)) / I,
                1e-13 * near.pace * near.pace + 1e-13 * (c * c / I + std::abs(k)) / I);
    }
    EXPECT_EQ(stability(near), k < 0 ? Stability::unstable : Stability::stable) << I << ' ' << c << ' ' << k;
    growing += k < 0;
  }
  EXPECT_GT(growing, poinsot::testing::case_count(2000) / 4);
}

// Nothing that drives a wheel back: beyond its symmetry, whose rates are left out, a rate is zero but for rounding.
TEST(Linearisation, NothingIsSaidWhereARateVanishes) {
  EXPECT_EQ(stability(Wheel(2, 0, 0).near()), Stability::undecided);
  EXPECT_EQ(stability(Wheel(2, 0.5, 0).near()), Stability::undecided);
}

}  // namespace linearisation_test
}  // namespace poinsot::solve
