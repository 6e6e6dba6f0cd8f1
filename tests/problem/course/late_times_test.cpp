// Closed forms are asked at late times: angles that have gone round often, events far from the start.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "poinsot/engine/motion/closed_form/symmetric_top.h"
#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace late_times_test {

const std::string top =
    "title: t\ngiven: {g: 9.81 m/s^2, m: 0.5 kg, I: 4e-4 kg*m^2, J: 5e-3 kg*m^2}\n"
    "points: {O: [0, 0, 0], G: [0, 0, 0.09 m]}\n"
    "bodies: {top: {mass: m, center: G, inertia: {about: O, axis: z, axial: I, transverse: J}}}\ngravity: -z\n";

TEST(LateTimes, EulerianAnglesOfATop) {
  const SolvedText solved(
      top +
      "joints: {tip: {ball: O, to: top, angles: [phi: z, theta: y, psi: z]}}\n"
      "instants: {start: {theta: 30 deg, phi: 0 deg, psi: 0 deg, theta': 0, phi': 0, psi': 80 rad/s}}\n"
      "ask: {theta: theta @ 1e6 s, phi: phi @ 1e6 s, psi: psi @ 1e6 s, early: theta @ 1 s}\n");
  const SymmetricTop exact({5e-3, 4e-4, 0.5 * 9.81 * 0.09}, {std::numbers::pi / 6, 0, 0, 0, 0, 80});
  EXPECT_NEAR(solved.number("theta"), exact.at(1e6).nutation, 1e-7);
  EXPECT_NEAR(solved.number("phi"), exact.at(1e6).precession, 1e-6);
  EXPECT_NEAR(solved.number("psi"), exact.at(1e6).spin, 1e-6);
  EXPECT_NEAR(solved.number("early"), exact.at(1).nutation, 1e-12);
  // The rounding of rates, over so long a time, is told.
  const auto error = solved.solved().solutions.at(0).checks.find("motion_error");
  ASSERT_NE(error, solved.solved().solutions.at(0).checks.end());
  EXPECT_GT(error->second, 1e-9);
  EXPECT_LT(error->second, 1e-7);
}

// A wheel goes on turning beside a mass on a spring that has long come to rest.
TEST(LateTimes, AnAngleThatGrowsBesideWhatHasDiedOut) {
  const SolvedText solved(
      "title: t\npoints: {B: [6 m, 0, 0], Q: [3 m, 0, 0]}\n"
      "bodies: {disk: {mass: 2 kg, center: B, radii_of_gyration: {axis: z, axial: 5 cm, transverse: 5 cm}}, block: "
      "{particle: Q, mass: 2 kg}}\n"
      "joints:\n  rail: {prismatic: x, at: Q, to: block, displacement: s, spring: {stiffness: 50 N/m}, damping: 3 "
      "N*s/m}\n  axle: {revolute: z, at: B, to: disk, angle: a}\n"
      "instants: {start: {s: 0.1 m, s': 0, a: 0, a': 2 rad/s}}\ngravity: -y\nask: {s: s @ 1e9 s, a: a @ 1e9 s}\n");
  EXPECT_NEAR(solved.number("s"), 0, 1e-12);
  EXPECT_NEAR(solved.number("a"), 2e9, 1e-2);
}

// Neither the first nor the last of the angles turns about a line about which the motion comes back.
TEST(LateTimes, AnglesThatMustBeCountedTurnByTurnSayso) {
  const SolvedText solved(top +
                          "joints: {tip: {ball: O, to: top, angles: [a: x, b: y, c: x]}}\n"
                          "instants: {start: {a: 10 deg, b: 50 deg, c: 0 deg, a': 1 rad/s, b': 2 rad/s, c': 3 rad/s}}\n"
                          "ask: {late: b @ 1e6 s, early: b @ 1 s}\n");
  EXPECT_EQ(solved.ask("early").state, AskState::found);
  const std::string reason = solved.reason("late");
  EXPECT_TRUE(
      reason.starts_with("how often the angles go round is counted turn by turn, in the motion no farther than"))
      << reason;
}

TEST(LateTimes, EveryEventInALateSpan) {
  const std::string pendulum =
      "title: t\ngiven: {g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], P: [0, -1 m, 0]}\nbodies: {bob: {particle: P, mass: 1 "
      "kg}}\njoints: {pin: {revolute: z, at: O, to: bob, angle: theta}}\ngravity: -y\n"
      "instants: {start: {theta: 60 deg, theta': 0}}\n";
  const SolvedText solved(
      pendulum +
      "ask: {T: period(theta), e: theta @ 2e6 s, late: {times: theta == 0, from: 1e6 s, to: 1000030 "
      "s}, early: {times: theta == 0, from: 0 s, to: 5 s}}\n");
  const double T = solved.number("T");
  std::vector<double> expected;
  for (double k = std::ceil(1e6 / T * 2 - 0.5); (k + 0.5) * T / 2 < 1000030; ++k) expected.push_back((k + 0.5) * T / 2);
  const auto& found = solved.found("late").value.items;
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k].number, expected[k], 1e-5);
  EXPECT_EQ(solved.found("early").value.items.size(), 5U);
}

// Asked first at a late time, which is reached in long steps, extremes are still those of every swing.
TEST(LateTimes, ExtremesOfAMotionThatLastsLong) {
  const std::string body =
      "title: t\npoints: {G: [0, 0, 0], A: [1 m, 0, 0]}\n"
      "bodies: {b: {mass: 1 kg, center: G, inertia: {x: 1 kg*m^2, y: 2 kg*m^2, z: 3 kg*m^2}}}\ngravity: none\n"
      "instants: {start: {angular_velocity(b): [0.1 rad/s, 0.2 rad/s, 1 rad/s], velocity(b): 0}}\n";
  const std::string ask = "ask: {e: angular_velocity(b).x @ 4e8 s, high: max(angular_velocity(b).z)}\n";
  const SolvedText lasting(body + "stages: {one: {lasts: 1e9 s}}\n" + ask), endless(body + ask);
  EXPECT_NEAR(lasting.number("high"), endless.number("high"), 1e-9);
}

}  // namespace late_times_test
}  // namespace poinsot::problem
