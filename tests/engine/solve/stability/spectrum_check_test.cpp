// The second road to the rates near a steady motion: it confirms right ones and finds planted faults.
#include "poinsot/engine/solve/stability/spectrum_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "poinsot/engine/model/builder.h"

namespace poinsot::solve {
namespace {

// A top that sleeps: its tip on a ball joint, its mass center above it.
struct SleepingTop {
  Mechanism<double> mechanism;
  SteadyMotion motion;

  explicit SleepingTop(double spin) {
    ModelBuilder<double> builder;
    builder.set_gravity({0, 0, -9.81});
    builder.add_body("top", ground, Joint<double>::ball(), SpatialTransform<double>::identity(),
                     MassProperties<double>{0.5, {0, 0, 0.04}, SymmetricMatrix3<double>::diagonal(2e-3, 2e-3, 4e-4)});
    mechanism.tree = builder.build();
    mechanism.takes_part = {true};
    motion.mechanism = &mechanism;
    motion.q = {1, 0, 0, 0};
    motion.v = {0, 0, spin};
    motion.held = {false, false, false};
    motion.given.resize(3);
    motion.spins = {{0, {{0, 0, spin}, {0, 0, 0}}}};
    motion.symmetries = {{0, 0, 1, 0, 0, 0}};
    motion.length = 0.04;
    motion.time = std::sqrt(0.04 / 9.81);
  }
  SleepingTop(const SleepingTop&) = delete;
};

TEST(SpectrumCheck, ConfirmsASleepingTopAndOneThatFalls) {
  for (const double spin : {20.0, 60.0, 150.0, 300.0}) {
    const SleepingTop top(spin);
    const Linearisation near = linearise(top.motion);
    EXPECT_EQ(near.deviations, 6);
    const std::optional<double> misfit = spectrum_misfit(top.motion, near);
    ASSERT_TRUE(misfit);
    EXPECT_LT(*misfit, 1e-8) << spin;
  }
}

TEST(SpectrumCheck, FindsWhatIsMissingOrWrong) {
  const SleepingTop top(150), other(151);
  const Linearisation near = linearise(top.motion);
  ASSERT_EQ(near.modes.size(), 2U);
  for (std::size_t mode = 0; mode < 2; ++mode) {
    Linearisation without = near;
    without.modes.erase(without.modes.begin() + static_cast<std::ptrdiff_t>(mode));
    EXPECT_EQ(spectrum_misfit(top.motion, without), 1) << mode;
    Linearisation off = near;
    off.modes[mode].frequency += 1e-4 * near.pace;
    EXPECT_GT(*spectrum_misfit(top.motion, off), 2e-6) << mode;
    off = near;
    off.modes[mode].growth_rate = 1e-4 * near.pace;
    EXPECT_GT(*spectrum_misfit(top.motion, off), 2e-6) << mode;
  }
  Linearisation wider = near;
  wider.deviations += 2;
  EXPECT_EQ(spectrum_misfit(top.motion, wider), 1);
  // The rates of a top that spins a little faster.
  EXPECT_GT(*spectrum_misfit(top.motion, linearise(other.motion)), 1e-4);
}

}  // namespace
}  // namespace poinsot::solve
