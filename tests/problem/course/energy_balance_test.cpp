// The account of a motion's energy against a motion known by hand, and against one whose load is told wrongly.
#include "problem/course/energy_balance.h"

#include <gtest/gtest.h>

#include <array>

#include "poinsot/engine/model/builder.h"

namespace poinsot::problem {
namespace energy_balance_test {

// 2 kg on a rail, from 3 m/s braked by a force F: s = 3 t - F/4 t^2, for a second.
Mechanism<double> braked(double force) {
  ModelBuilder<double> builder;
  builder.add_body("sled", ground, poinsot::Joint<double>::prismatic({1, 0, 0}),
                   {Matrix3<double>::identity(), Vector3<double>::zero()},
                   {2, Vector3<double>::zero(), SymmetricMatrix3<double>::diagonal(1, 1, 1)});
  Mechanism<double> mechanism;
  mechanism.tree = builder.build();
  mechanism.actions.push_back({ActionKind::load, "brake", "", 0, ground});
  mechanism.forces.push_back({0, false, {0, {}}, {-force, 0, 0}, ground});
  return mechanism;
}
Trajectory way_under(double force) {
  const std::array<double, 6> coefficients{0, 3, 3, -force / 2, -force / 4, 0};
  Trajectory way(1, 1, {});
  way.append({0, 1, 1, StepForm::power, coefficients, nullptr});
  return way;
}

TEST(EnergyBalance, TellsWhetherTheWorkOfLoadsIsTheChangeOfEnergy) {
  EXPECT_LT(*energy_misfit(braked(1.6), way_under(1.6), 0), 1e-14);
  // A force that is told too large by a hundredth does a hundredth of 1.6*2.6 J too much, beside 9 J.
  EXPECT_NEAR(*energy_misfit(braked(1.616), way_under(1.6), 0), 0.016 * 2.6 / 9, 1e-12);
  EXPECT_NEAR(*energy_misfit(braked(1.616), way_under(1.6), 90), 0.016 * 2.6 / 90, 1e-12);
  EXPECT_EQ(energy_misfit(braked(1.6), Trajectory(1, 1, {}), 0), std::nullopt);
}

}  // namespace energy_balance_test
}  // namespace poinsot::problem
