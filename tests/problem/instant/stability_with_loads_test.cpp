// Stability under loads that depend on the motion, against closed forms and the same forces stated as dampers and
// springs.
#include <gtest/gtest.h>

#include <complex>

#include "problem/instant/near_steady.h"
#include "problem/language/failure.h"

namespace poinsot::problem {
namespace stability_with_loads_test {

using namespace testing;

constexpr double g = 9.81;
const std::string asks = "ask: {s: stable(system), g: growth_rate(system), f: frequencies(system)}\n";

std::string pendulum(const std::string& at_joint, const std::string& loads = "") {
  return "title: t\npoints: {O: [0, 0, 0], P: [0, -0.7 m, 0]}\nbodies: {bob: {particle: P, mass: 2 kg}}\n"
         "gravity: [0, -9.81 m/s^2, 0]\njoints: {pin: {revolute: z, at: O, to: bob, angle: theta" +
         at_joint + "}}\ninstants: {now: rest}\n" + loads + asks;
}

// theta'' + c theta'/(m L^2) + g/L theta = 0, also where c is negative. A square law has no slope at rest.
TEST(StabilityWithLoads, LinearPartOfALoadDampsOrDrives) {
  const double own = g / 0.7, half = 0.5 / (2 * 2 * 0.49);
  for (const std::string& text :
       {pendulum(", couple: -0.5 N*m*s * theta' - 0.4 N*m*s^2 * abs(theta') * theta'"),
        pendulum("", "loads: {air: {force: '-(0.5 N*m*s/(0.7 m)^2) * velocity(bob)', body: bob}}\n")}) {
    const Near damped = solved_near(text).front();
    EXPECT_TRUE(damped.stable);
    EXPECT_EQ(damped.growth, 0);
    EXPECT_TRUE(damped.swings_at(std::sqrt(own - half * half))) << damped.list();
  }
  const Near driven = solved_near(pendulum(", couple: 0.5 N*m*s * theta' - 0.4 N*m*s^2 * theta'^3*(1 s)")).front();
  EXPECT_FALSE(driven.stable);
  EXPECT_NEAR(driven.growth, half, 1e-9);
  const Near square = solved_near(pendulum(", couple: -0.4 N*m*s^2 * abs(theta') * theta'")).front();
  EXPECT_TRUE(square.swings_at(std::sqrt(own))) << square.list();
}

// A couple that follows the place: m L^2 theta'' + (m g L + k) theta = 0 for the couple -k sin(theta).
TEST(StabilityWithLoads, SlopesByPlaceCount) {
  const Near hanging = solved_near(pendulum(", couple: -5 N*m * sin(theta)")).front();
  EXPECT_TRUE(hanging.swings_at(std::sqrt(g / 0.7 + 5 / (2 * 0.49)))) << hanging.list();
  const Near pushed =
      solved_near(pendulum("", "loads: {push: {force: '50 N/m * (P of bob).x', along: x, body: bob}}\n")).front();
  EXPECT_FALSE(pushed.stable);
  EXPECT_NEAR(pushed.growth, std::sqrt(50 / 2.0 - g / 0.7), 1e-8);
}

// Random carts in a row, joined by springs and dampers: stated as such, and as loads.
TEST(StabilityWithLoads, AsSpringsAndDampersDo) {
  Random random(611);
  for (int trial = 0; trial < 40; ++trial) {
    const double k = random.uniform(50, 400), c = random.uniform(0.1, 8), k2 = random.uniform(50, 400),
                 c2 = random.uniform(0.1, 8);
    const auto text = [&](bool as_loads) {
      const std::string one = as_loads ? fmt::format("force: -{:.17g} N/m * s - {:.17g} N*s/m * s'", k, c)
                                       : fmt::format(
                                             "spring: {{stiffness: {:.17g} N/m, free_displacement: 0 m}}, "
                                             "damping: {:.17g} N*s/m",
                                             k, c);
      const std::string two = as_loads ? fmt::format("force: -{:.17g} N/m * u - {:.17g} N*s/m * u'", k2, c2)
                                       : fmt::format(
                                             "spring: {{stiffness: {:.17g} N/m, free_displacement: 0 m}}, "
                                             "damping: {:.17g} N*s/m",
                                             k2, c2);
      return "title: t\npoints: {O: [0, 0, 0]}\nbodies: {a: {particle: O, mass: 2 kg}, b: {particle: O, mass: 3 kg}}\n"
             "gravity: none\njoints:\n  left: {prismatic: x, at: O, to: a, displacement: s, " +
             one + "}\n  right: {prismatic: x, at: O, from: a, to: b, displacement: u, " + two +
             "}\ninstants: {now: {s: 0, u: 0, s': 0, u': 0}}\n" + asks;
    };
    const Near stated = solved_near(text(false)).front(), loads = solved_near(text(true)).front();
    ASSERT_EQ(loads.frequencies.size(), stated.frequencies.size());
    for (std::size_t i = 0; i < loads.frequencies.size(); ++i)
      EXPECT_NEAR(loads.frequencies[i], stated.frequencies[i], 1e-7 * stated.frequencies[i]);
    EXPECT_EQ(loads.stable, stated.stable);
  }
}

// A disk on a soft shaft with damping outside (c) and inside it (d), which turns with n:
// m z'' + (c + d) z' + (k - i d n) z = 0, stable below n = (1 + c/d) sqrt(k/m).
TEST(StabilityWithLoads, AShaftWithInternalDampingWhirls) {
  const double m = 3, k = 1200, c = 5, d = 8, limit = (1 + c / d) * std::sqrt(k / m);
  for (const double n : {0.5 * limit, 0.97 * limit, 1.03 * limit, 2 * limit}) {
    const std::string text = fmt::format(
        "title: t\ngiven: {{n: {:.17g} rad/s}}\npoints: {{O: [0, 0, 0]}}\nbodies: {{disk: {{particle: O, mass: 3 "
        "kg}}}}\n"
        "gravity: none\n"
        "loads:\n  outside: {{force: '-5 kg/s * velocity(disk)', body: disk}}\n"
        "  inside: {{force: '-8 kg/s*(velocity(disk) - cross(n*z with center(disk)))', body: disk}}\n"
        "  shaft: {{force: '-1200 N/m * center(disk)', body: disk}}\ninstants: {{now: rest}}\n",
        n);
    const Near near = solved_near(text + asks).front();
    EXPECT_EQ(near.stable, n < limit) << n;
    const std::complex<double> root = std::sqrt(std::complex<double>((c + d) * (c + d) - 4 * m * k, 4 * m * d * n));
    const double growth = std::max(((-(c + d) + root) / (2 * m)).real(), ((-(c + d) - root) / (2 * m)).real());
    EXPECT_NEAR(near.growth, std::max(growth, 0.0), 1e-7) << n;
  }
}

// |s| pushes to one side: it has no slope where s vanishes.
TEST(StabilityWithLoads, ACornerHasNoSlope) {
  const Statement statement =
      read_statement(pendulum(", couple: -5 N*m * abs(theta) - 9 N*m * theta - 0.1 N*m*s * theta'"), "test.yaml");
  for (const Solution& solution : solve_statement(statement, {}).solutions)
    for (const SolvedAsk& ask : solution.asks) {
      EXPECT_NE(ask.state, AskState::found);
      EXPECT_NE(ask.reason.find("has a corner at this motion"), std::string::npos) << ask.reason;
    }
}

// A load that keeps to the ground has no constant coefficients beside a frame that turns; one that goes round has.
TEST(StabilityWithLoads, MustGoRoundWithTheFrame) {
  const auto text = [](const std::string& force) {
    return "title: t\npoints: {O: [0, 0, 0], P: [0.5 m, 0, 0]}\nbodies:\n  arm: massless\n"
           "  bead: {particle: P, mass: 2 kg}\ngravity: none\njoints:\n"
           "  shaft: {revolute: z, at: O, to: arm, rate: 3 rad/s, accel: 0}\n"
           "  rail: {prismatic: x, at: O, from: arm, to: bead, displacement: s, spring: {stiffness: 50 N/m, "
           "free_displacement: -0.18 m}}\nsteady: {frame: arm}\nloads: {drag: {force: '" +
           force + "', body: bead}}\ninstants: {now: {s: 0}}\n" + asks;
  };
  // 2*9*0.5 = 9 N is what the spring holds: 50*0.18. Along the rail: m s'' + c s' + (k - m n^2) s = 0.
  const Near along = solved_near(text("-6 kg/s * velocity(bead)")).front();
  EXPECT_TRUE(along.stable);
  EXPECT_TRUE(along.swings_at(std::sqrt((50 - 18) / 2.0 - 1.5 * 1.5))) << along.list();
  const Statement statement = read_statement(text("[-6 kg/s * velocity(bead).x, 0, 0]"), "test.yaml");
  for (const Solution& solution : solve_statement(statement, {}).solutions)
    for (const SolvedAsk& ask : solution.asks) {
      EXPECT_NE(ask.state, AskState::found);
      EXPECT_NE(ask.reason.find("does not go round with the frame"), std::string::npos) << ask.reason;
    }
}

}  // namespace stability_with_loads_test
}  // namespace poinsot::problem
