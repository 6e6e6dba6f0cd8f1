#include "poinsot/engine/motion/mechanism/mechanism_equations.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/motion/mechanism/sample_mechanisms.h"
#include "poinsot/engine/motion/integrator/integrate.h"

namespace poinsot {
namespace mechanism_equations_test {

using testing::about;
using testing::MechanismMaker;
using testing::rod;
using Vector = Vector3<double>;

constexpr double g = 9.81;

TEST(MechanismEquations, LoopsRollingAndTopsKeepTheirEnergyAndConstraints) {
  for (const testing::SampleMechanism& sample : testing::sample_mechanisms()) {
    SCOPED_TRACE(sample.name);
    MechanismDynamics dynamics(sample.mechanism);
    const MotionEquations equations = mechanism_equations(dynamics);
    const bool conserved = dynamics.held_coordinates().empty() && dynamics.mechanism().forces.empty();
    ASSERT_EQ(equations.conserved.size(), conserved ? 1U : 0U);
    IntegrationOptions options;
    options.tolerance = 1e-11;
    const IntegrationResult result = integrate(equations, 0, sample.state.q, sample.state.v, 1, options);
    ASSERT_TRUE(result.complete()) << describe(result);
    EXPECT_LT(dynamics.largest_gap(result.q), 1e-14);
    EXPECT_LT(dynamics.largest_rate(result.q, result.v), 1e-12);
    if (!conserved) continue;
    EXPECT_LT(std::abs(result.drift[0].largest), 1e-8 * (1 + std::abs(result.drift[0].start)));
  }
}

TEST(MechanismEquations, AHeldCoordinateFollowsItsFunctionOfTime) {
  // A rod on a carriage that is moved along x as A sin(W t); by hand: l q''/1.5 = A W^2 sin(W t) (-sin q) - g cos q,
  // from the moments about the pin with the carriage's acceleration -A W^2 sin(W t).
  const double l = 0.6, A = 0.05, W = 7;
  MechanismMaker maker;
  const int carriage = maker.add_body(ground, Joint<double>::prismatic({1, 0, 0}), Vector::zero(), rod(1, 0.1));
  maker.add_body(carriage, about({0, 0, 1}), Vector::zero(), rod(2, l));
  maker.finish_tree({0, -g, 0});
  maker.mechanism.drives[0].held = true;
  MechanismDynamics dynamics(maker.mechanism);
  const auto given = [&](double t, MechanismDynamics& driven, std::span<double> q, std::span<double> v) {
    q[0] = A * std::sin(W * t);
    v[0] = A * W * std::cos(W * t);
    driven.set_held_acceleration(0, -A * W * W * std::sin(W * t));
  };
  const std::vector<double> q{0, -1.0}, v{0, 0.3};
  const IntegrationResult result = integrate(mechanism_equations(dynamics, given), 0, q, v, 2);
  ASSERT_TRUE(result.complete()) << describe(result);
  EXPECT_EQ(result.q[0], A * std::sin(W * 2.0));
  EXPECT_EQ(result.v[0], A * W * std::cos(W * 2.0));

  MotionEquations by_hand;
  by_hand.position_size = by_hand.velocity_size = 1;
  by_hand.accelerations = [&](double t, std::span<const double> angle, std::span<const double>, std::span<double> a) {
    const double shift = -A * W * W * std::sin(W * t);
    a[0] = 1.5 / l * (shift * std::sin(angle[0]) - g * std::cos(angle[0]));
  };
  const IntegrationResult expected = integrate(by_hand, 0, std::vector<double>{-1.0}, std::vector<double>{0.3}, 2);
  EXPECT_NEAR(result.q[1], expected.q[0], 1e-8);
  EXPECT_NEAR(result.v[1], expected.v[0], 1e-8);
}

TEST(MechanismEquations, SizesAreThoseOfTheMechanism) {
  MechanismMaker maker;
  const int body = maker.add_body(ground, Joint<double>::free(), {0, 0, 200}, rod(1, 40));
  maker.add_body(body, Joint<double>::prismatic({1, 0, 0}), {30, 0, 0}, rod(1, 1));
  maker.finish_tree(Vector::zero());
  MechanismDynamics dynamics(maker.mechanism);
  const MotionEquations equations = mechanism_equations(dynamics);
  EXPECT_EQ(equations.quaternions, std::vector<int>{0});
  const double length = dynamics.natural_length();
  EXPECT_GT(length, 20);
  EXPECT_EQ(equations.position_sizes, (std::vector<double>{1, 1, 1, 1, length, length, length, length}));
}

}  // namespace mechanism_equations_test
}  // namespace poinsot
