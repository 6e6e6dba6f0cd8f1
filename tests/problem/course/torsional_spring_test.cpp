// A torsional spring between bodies that are not joined: against the same spring at a joint, closed forms, its energy.
#include <fmt/format.h>

#include <numbers>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace torsional_spring_test {

const std::string two_wheels =
    "title: t\npoints: {A: [0, 0, 0], B: [0.5 m, 0, 0]}\n"
    "bodies:\n"
    "  pump: {mass: 4 kg, center: A, inertia: {axis: x, axial: 0.02 kg*m^2, transverse: 0.03 kg*m^2}}\n"
    "  wheel: {mass: 6 kg, center: B, inertia: {axis: x, axial: 0.05 kg*m^2, transverse: 0.06 kg*m^2}}\n"
    "gravity: none\n";
const std::string asks =
    "ask: {pump: angular_velocity(pump).x @ 0.3 s, wheel: angular_velocity(wheel).x @ 0.3 s, "
    "alpha: angular_acceleration(wheel).x @ 0.2 s, most: max(angular_velocity(wheel).x)}\n";

// The equivalent model: the wheel hangs on the pump by a joint with the same spring, and turns as fast relative to it.
TEST(TorsionalSpring, MovesAsTheSameSpringAtAJointDoes) {
  const SolvedText joined(two_wheels +
                          "joints:\n"
                          "  left: {revolute: x, at: A, to: pump, rate: 5 rad/s}\n"
                          "  shaft: {revolute: x, at: B, from: pump, to: wheel, angle: 0.2 rad, rate: -8 rad/s, "
                          "spring: {stiffness: 40 N*m/rad, free_angle: 2 deg}, damping: 0.3 N*m*s/rad}\n" +
                          asks);
  const SolvedText apart(two_wheels +
                         "joints:\n"
                         "  left: {revolute: x, at: A, to: pump, rate: 5 rad/s}\n"
                         "  right: {revolute: x, at: B, to: wheel, angle: 0.2 rad, rate: -3 rad/s}\n"
                         "springs:\n"
                         "  bar: {from: pump, to: wheel, about: x, stiffness: 40 N*m/rad, damping: 0.3 N*m*s/rad, "
                         "free_angle: 2 deg}\n" +
                         asks);
  for (const char* ask : {"pump", "wheel", "alpha", "most"})
    EXPECT_NEAR(apart.number(ask), joined.number(ask), 1e-8 * std::abs(joined.number(ask))) << ask;
}

// Without damping the relative angle swings harmonically with k/I + k/J.
TEST(TorsionalSpring, SwingsHarmonically) {
  const SolvedText solved(two_wheels +
                          "joints:\n"
                          "  left: {revolute: x, at: A, to: pump, angle: a, rate: 1 rad/s}\n"
                          "  right: {revolute: x, at: B, to: wheel, angle: b, rate: -0.4 rad/s}\n"
                          "springs: {bar: {from: pump, to: wheel, about: x, stiffness: 40 N*m/rad}}\n"
                          "ask: {twist: b @ 0.1 s - a @ 0.1 s, V: potential_energy(bar) @ 0.1 s, "
                          "M: couple(bar on pump about A).x @ 0.1 s}\n");
  const double frequency = std::sqrt(40 / 0.02 + 40 / 0.05);
  const double twist = -1.4 / frequency * std::sin(0.1 * frequency);
  EXPECT_NEAR(solved.number("twist"), twist, 1e-9);
  EXPECT_NEAR(solved.number("V"), 20 * twist * twist, 1e-8);
  EXPECT_NEAR(solved.number("M"), 40 * twist, 1e-8);
}

// Two bodies tumble freely: the spring's energy goes into their motion and comes back, momentum stays.
TEST(TorsionalSpring, KeepsEnergyAndMomentumOfTumblingBodies) {
  const SolvedText solved(
      "title: t\npoints: {A: [0, 0, 0], B: [0.5 m, 0, 0]}\n"
      "bodies:\n"
      "  one: {mass: 4 kg, center: A, inertia: {x: 0.02 kg*m^2, y: 0.03 kg*m^2, z: 0.025 kg*m^2}}\n"
      "  two: {mass: 6 kg, center: B, inertia: {x: 0.06 kg*m^2, y: 0.04 kg*m^2, z: 0.05 kg*m^2}}\n"
      "directions: {u: [1, 2, 2]}\n"
      "springs: {bar: {from: one, to: two, about: u, stiffness: 3 N*m/rad, free_angle: 40 deg}}\n"
      "gravity: none\n"
      "facts: {angular_velocity(one): [0.2 rad/s, 0.1 rad/s, -0.3 rad/s], velocity(one): [0 m/s, 0 m/s, 0 m/s], "
      "angular_velocity(two): [-0.1 rad/s, 0.4 rad/s, 0.2 rad/s], velocity(two): [0 m/s, 0 m/s, 0 m/s]}\n"
      "define: {E: kinetic_energy(system) + potential_energy(bar)}\n"
      "ask: {before: E, after: E @ 0.4 s, rate: E', H: angular_momentum(system about A), "
      "later: angular_momentum(system about A) @ 0.4 s, V: potential_energy(bar), W: potential_energy(bar) @ 0.4 s}\n");
  EXPECT_NEAR(solved.number("after"), solved.number("before"), 1e-9 * solved.number("before"));
  EXPECT_NEAR(solved.number("rate"), 0, 1e-9);
  EXPECT_NEAR(norm(solved.vector("later") - solved.vector("H")), 0, 1e-10);
  EXPECT_GT(std::abs(solved.number("V") - solved.number("W")), 0.1);
}

TEST(TorsionalSpring, FindsItsStiffness) {
  const SolvedText solved(two_wheels +
                          "find: {k: N*m/rad}\n"
                          "joints:\n"
                          "  left: {revolute: x, at: A, to: pump, rate: 0}\n"
                          "  right: {revolute: x, at: B, to: wheel, angle: 0.2 rad, rate: 0}\n"
                          "springs: {bar: {from: pump, to: wheel, about: x, stiffness: k}}\n"
                          "facts: {angular_acceleration(pump).x: 300 rad/s^2}\n"
                          "ask: {k: k}\n");
  EXPECT_NEAR(solved.number("k"), 300 * 0.02 / 0.2, 1e-9);
}

// Near rest the wheel swings with sqrt(k/J) where the other body is held.
TEST(TorsionalSpring, GivesTheFrequencyOfSmallOscillations) {
  const SolvedText solved(two_wheels +
                          "joints:\n"
                          "  left: {weld: A, to: pump}\n"
                          "  right: {revolute: x, at: B, to: wheel}\n"
                          "springs: {bar: {from: pump, to: wheel, about: x, stiffness: 40 N*m/rad}}\n"
                          "steady: {frame: ground}\n"
                          "ask: {f: frequencies(wheel), s: stable(wheel)}\n");
  ASSERT_EQ(solved.found("f").value.items.size(), 1U);
  EXPECT_NEAR(solved.found("f").value.items[0].number, std::sqrt(40 / 0.05), 1e-9);
}

TEST(TorsionalSpring, IsNotFollowedBeyondHalfATurn) {
  const std::string text = two_wheels +
                           "joints:\n"
                           "  left: {weld: A, to: pump}\n"
                           "  right: {revolute: x, at: B, to: wheel, angle: b, rate: 100 rad/s}\n"
                           "springs: {bar: {from: pump, to: wheel, about: x, stiffness: 1 N*m/rad}}\n";
  const SolvedText before(text + "ask: {b: b @ 30 ms}\n");
  const double frequency = std::sqrt(1 / 0.05);
  EXPECT_NEAR(before.number("b"), 100 / frequency * std::sin(0.03 * frequency), 1e-9);
  EXPECT_NE(SolvedText(text + "ask: {b: b @ 40 ms}\n").reason("b").find("wound by half a turn at 0.03"),
            std::string::npos);
}

TEST(TorsionalSpring, RefusesWhatBelongsToTheOtherKind) {
  const auto failure = [](const std::string& spring) {
    return failure_of_text(two_wheels + "springs: {bar: {" + spring + "}}\nask: {a: angular_velocity(pump)}\n");
  };
  EXPECT_NE(failure("from: pump, to: wheel, about: x, stiffness: 1 N*m/rad, free_length: 1 m")
                .find("a torsional spring has no 'free_length'"),
            std::string::npos);
  EXPECT_NE(failure("from: pump, to: wheel, at: A, end: B, stiffness: 1 N/m, free_angle: 1 deg")
                .find("a spring between two points has no 'free_angle'"),
            std::string::npos);
  EXPECT_NE(failure("from: wheel, to: wheel, about: x, stiffness: 1 N*m/rad").find("joins 'wheel' to itself"),
            std::string::npos);
  EXPECT_NE(failure("from: pump, to: wheel, about: x, stiffness: 1 N/m").find("torsional stiffness"),
            std::string::npos);
}

}  // namespace torsional_spring_test
}  // namespace poinsot::problem
