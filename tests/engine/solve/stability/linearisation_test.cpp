// How far off the rates of a linearisation may be, against slopes that are known.
#include "poinsot/engine/solve/stability/linearisation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "case_count.h"
#include "poinsot/engine/model/builder.h"

namespace poinsot::solve {
namespace {

// One coordinate whose acceleration is a quadratic in its velocity, with rounding: differences with steps that are
// multiples of each other round alike, so that they may agree closely and be off together.
TEST(Linearisation, RatesAreHardlyEverOffByMoreThanTheirDoubt) {
  ModelBuilder<double> builder;
  builder.add_body("wheel", ground, Joint<double>::revolute({0, 0, 1}), SpatialTransform<double>::identity(),
                   MassProperties<double>{1, {0, 0, 0}, SymmetricMatrix3<double>::diagonal(1, 1, 1)});
  const Model<double> tree = builder.build();
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> part(-1, 1);
  const auto any = [&] { return part(random) * std::pow(10, 2 * part(random)); };
  const int trials = poinsot::testing::case_count(2000);
  int seen = 0, beyond = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const double v = any(), quadratic = any(), rate = any();
    // The acceleration vanishes at v, where its slope is the rate.
    const double linear = rate - 2 * quadratic * v, constant = -(linear * v + quadratic * v * v);
    const double slope = static_cast<double>(linear + 2.0L * quadratic * v);
    SteadyMotion motion;
    motion.tree = &tree;
    motion.q = {0};
    motion.v = {v};
    motion.held = {false};
    motion.symmetries = {{1, 0}};
    motion.accelerations = [&](const std::vector<double>&, const std::vector<double>& moving) {
      const double u = moving[0];
      return std::vector<double>{constant + linear * u + quadratic * u * u};
    };
    motion.constraints = [](const std::vector<double>&) { return std::vector<std::vector<double>>{}; };
    const Linearisation near = linearise(motion);
    if (!near.steady) continue;
    ASSERT_EQ(near.modes.size(), 1U);
    const Mode& mode = near.modes.front();
    EXPECT_EQ(mode.frequency, 0);
    // What a few differences show of rounding may be too little by chance, seldom and not by much.
    const double error = std::abs(mode.growth_rate - slope);
    EXPECT_LE(error, 2 * mode.doubt) << v << ' ' << linear << ' ' << quadratic;
    beyond += error > mode.doubt;
    EXPECT_LE(mode.doubt, 1e-9 * (std::abs(linear) + std::abs(quadratic * v) + near.pace));
    ++seen;
  }
  EXPECT_GT(seen, trials * 9 / 10);
  EXPECT_LE(beyond, trials / 100);
}

}  // namespace
}  // namespace poinsot::solve
