// Motions of problems that are known in closed form, those that are not, and what the answers say of how they were
// found and how far they may be off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "poinsot/engine/motion/closed_form/symmetric_top.h"
#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace closed_form_motion_test {

bool says(const SolvedText& solved, const std::string& words) {
  return std::count(solved.notes().begin(), solved.notes().end(), words) == 1;
}
const std::map<std::string, double>& checks(const SolvedText& solved) { return solved.solved().solutions.at(0).checks; }

// 25 digits, by Taylor series.
TEST(ClosedFormMotion, TumblesAsTheReferenceDoesUpToLateTimes) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0]}\n"
      "bodies: {b: {mass: 1 kg, center: O, inertia: {x: 1 kg*m^2, y: 2 kg*m^2, z: 3 kg*m^2}}}\ngravity: none\n"
      "instants: {start: {angular_velocity(b): [0.1 rad/s, 5 rad/s, 0.1 rad/s], velocity(b): [0, 0, 0]}}\n"
      "ask: {w: {of: angular_velocity(b) @ 100 s, axes: b}, far: {of: angular_velocity(b) @ 1e7 s, axes: b}, "
      "T: {of: period(angular_velocity(b).y), axes: b}, E: kinetic_energy(b) @ 1e7 s}\n");
  const Vector3<double> w = solved.vector("w");
  EXPECT_NEAR(w.x, 0.146653502117685105, 1e-12);
  EXPECT_NEAR(w.y, -4.99884914258438271, 1e-12);
  EXPECT_NEAR(w.z, 0.117625464481380999, 1e-12);
  EXPECT_NEAR(solved.number("E"), 0.5 * (0.01 + 2 * 25 + 0.03), 1e-11);
  EXPECT_TRUE(says(solved, "the motion: closed form: torque-free motion"));
  // What rounding of the rates makes of so long a time.
  EXPECT_LT(checks(solved).at("motion_error"), 2e-8);
  EXPECT_LT(checks(solved).at("energy_drift"), 1e-13);
}

// One top by a ball joint, by Eulerian angles and in gimbals of no mass.
TEST(ClosedFormMotion, OfATopIsTheSameInEveryDescription) {
  const std::string head =
      "title: t\ngiven: {g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], G: [0, 1 m, 0]}\n"
      "bodies: {%b: {mass: 15 kg, center: G, inertia: {x: 0.234375 kg*m^2, y: 0.46875 kg*m^2, z: 0.234375 kg*m^2}}}\n"
      "gravity: -z\ninstants: {start: {angular_velocity(b): [0, 150 rad/s, -4.61538 rad/s]%s}}\n"
      "ask: {w: {of: angular_velocity(b) @ 2 s, axes: b}, P: position(G of b) @ 10 s}\n";
  const auto problem = [&](const std::string& bodies, const std::string& start, const std::string& joints) {
    std::string text = head;
    text.replace(text.find("%b"), 2, bodies + "b");
    text.replace(text.find("%s"), 2, start);
    return text + "joints: {" + joints + "}\n";
  };
  for (const std::string& text :
       {problem("", "", "tip: {ball: O, to: b}"),
        problem("", ", p: 0, n: 0, s: 0", "tip: {ball: O, to: b, angles: [p: z, n: x, s: y]}"),
        problem(
            "outer: massless, inner: massless, ", ", p: 0, n: 0, s: 0",
            "A: {revolute: z, at: O, to: outer, angle: p}, B: {revolute: x, at: O, from: outer, to: inner, angle: n}, "
            "C: {revolute: y, at: O, from: inner, to: b, angle: s}")}) {
    const SolvedText solved(text);
    EXPECT_TRUE(says(solved, "the motion: closed form: symmetric top")) << text;
    const Vector3<double> w = solved.vector("w"), P = solved.vector("P");
    EXPECT_NEAR(w.x, 0.122233219497394236787282, 1e-11);
    EXPECT_NEAR(w.y, 150, 1e-11);
    EXPECT_NEAR(w.z, -5.85562458920545772829141, 1e-11);
    EXPECT_NEAR(P.x, -0.37014419157311057, 1e-11);
    EXPECT_NEAR(P.y, 0.033503155579024835, 1e-11);
    EXPECT_NEAR(P.z, -0.9283699779780344, 1e-11);
  }
}

TEST(ClosedFormMotion, HasTheExtremesOfTheCubicAndThePeriodOfTheIntegral) {
  for (const double spin : {60.0, 120.0, 300.0}) {
    const SolvedText solved(
        "title: t\ngiven: {m: 0.5 kg, h: 60 mm, A: 2.4e-3 kg*m^2, C: 5e-4 kg*m^2, S: " + std::to_string(spin) +
        " rad/s, b: 30 deg, g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], G: [0, 0, h]}\n"
        "bodies: {top: {mass: m, center: G, inertia: {about: O, axis: z, axial: C, transverse: A}}}\n"
        "joints: {tip: {ball: O, to: top, angles: [phi: z, theta: y, psi: z]}}\ngravity: -z\n"
        "instants: {start: {phi: 0, theta: b, psi: 0, phi': 2 rad/s, theta': 0, psi': S}}\n"
        "ask: {lo: min(theta), hi: max(theta), T: period(theta)}\n");
    const double b = std::numbers::pi / 6;
    const SymmetricTop top({2.4e-3, 5e-4, 0.5 * 9.81 * 0.06}, {b, 0, 0, 2, 0, spin + 2 * std::cos(b)});
    EXPECT_NEAR(solved.number("lo"), top.nutation_range().minimum, 1e-11);
    EXPECT_NEAR(solved.number("hi"), top.nutation_range().maximum, 1e-11);
    EXPECT_NEAR(solved.number("T"), top.nutation_period(), 1e-10 * top.nutation_period());
  }
}

// A sleeping top too slow to stay up: Eulerian angles begin at their pole, where phi is open, and nothing stops.
TEST(ClosedFormMotion, LeavesThePoleOfEulerianAngles) {
  const SolvedText solved(
      "title: t\ngiven: {m: 0.5 kg, h: 60 mm, A: 2.4e-3 kg*m^2, C: 5e-4 kg*m^2, S: 60 rad/s, g: 9.81 m/s^2}\n"
      "points: {O: [0, 0, 0], G: [0, 0, h]}\n"
      "bodies: {top: {mass: m, center: G, inertia: {about: O, axis: z, axial: C, transverse: A}}}\n"
      "joints: {j: {ball: O, to: top, angles: [phi: z, theta: y, psi: z]}}\ngravity: -z\n"
      "instants: {start: {phi: 0, theta: 0, psi: 0, phi': 0, theta': 0, psi': S, nudged: theta}}\n"
      "ask: {hi: max(theta)}\n");
  EXPECT_TRUE(says(solved, "the motion: closed form: symmetric top"));
  // Where theta' vanishes again: m g h (1 - x) = (C S)^2 (1 - x)^2/(2 A (1 - x^2)).
  const double x = 5e-4 * 60 * 5e-4 * 60 / (2 * 2.4e-3 * 0.5 * 9.81 * 0.06) - 1;
  EXPECT_NEAR(solved.number("hi"), std::acos(x), 1e-8);
}

// A pendulum, and the same under a load of zero, which takes it the long way round.
TEST(ClosedFormMotion, AndIntegrationAgreeWithinTheErrorStated) {
  const auto pendulum = [](const std::string& load, double degrees) {
    return SolvedText(
        "title: t\ngiven: {L: 1 m, b: " + std::to_string(degrees) +
        " deg, g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
        "bodies: {bob: {particle: P, mass: 2 kg}}\njoints: {pin: {revolute: z, at: O, to: bob, angle: th}}\n"
        "gravity: -y\n" +
        load + "instants: {start: {th: b, th': 0}}\nask: {T: period(th), th: th @ 30 s}\n");
  };
  for (const double degrees : {5.0, 90.0, 179.0}) {
    const SolvedText known = pendulum("", degrees),
                     integrated = pendulum("loads: {F: {at: P, body: bob, force: [0, 0, 0 N]}}\n", degrees);
    EXPECT_TRUE(says(known, "the motion: closed form: pendulum"));
    EXPECT_TRUE(says(integrated, "the motion: integrated by Dormand and Prince's method of order 8"));
    const double error = checks(integrated).at("motion_error");
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 1e-5);
    EXPECT_NEAR(known.number("th"), integrated.number("th"), error);
    const double k = std::sin(degrees * std::numbers::pi / 360);
    EXPECT_NEAR(known.number("T"), 4 / std::sqrt(9.81) * std::comp_ellint_1(k), 1e-11);
    EXPECT_NEAR(integrated.number("T"), known.number("T"), 1e-8);
  }
}

// A double pendulum from above: its motion doubles an error every few tenths of a second.
TEST(ClosedFormMotion, AnswersNothingThatTheErrorOfTheMotionHides) {
  const auto pendulum = [](const std::string& time) {
    return SolvedText(
        "title: t\ngiven: {g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], P: [0, -1 m, 0], Q: [0, -2 m, 0]}\n"
        "bodies: {a: {particle: P, mass: 1 kg}, b: {particle: Q, mass: 1 kg}}\n"
        "joints: {A: {revolute: z, at: O, to: a, angle: p}, B: {revolute: z, at: P, from: a, to: b, angle: q}}\n"
        "gravity: -y\ninstants: {start: {p: 150 deg, q: 20 deg, p': 0, q': 0}}\nask: {p: p @ " +
        time + "}\n");
  };
  const SolvedText soon = pendulum("2 s"), late = pendulum("60 s");
  EXPECT_LT(checks(soon).at("motion_error"), 1e-8);
  EXPECT_EQ(soon.ask("p").state, AskState::found);
  EXPECT_EQ(late.ask("p").state, AskState::refused);
  EXPECT_NE(late.reason("p").find("so sensitive"), std::string::npos) << late.reason("p");
}

// How far such a motion goes is as uncertain as where it is, unless another one of it goes as far.
TEST(ClosedFormMotion, AnswersNoExtremeThatTheErrorOfTheMotionHides) {
  const auto pendulum = [](const std::string& lasts) {
    return SolvedText(
        "title: t\ngiven: {g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], P: [0, -1 m, 0], Q: [0, -2 m, 0]}\n"
        "bodies: {a: {particle: P, mass: 1 kg}, b: {particle: Q, mass: 1 kg}}\n"
        "joints: {A: {revolute: z, at: O, to: a, angle: p}, B: {revolute: z, at: P, from: a, to: b, angle: q}}\n"
        "gravity: -y\ninstants: {start: {p: 150 deg, q: 20 deg, p': 0, q': 0}}\nstages: {all: {lasts: " +
        lasts + "}}\nask: {m: max(q')}\n");
  };
  const SolvedText soon = pendulum("2 s"), late = pendulum("60 s");
  EXPECT_EQ(soon.ask("m").state, AskState::found);
  EXPECT_EQ(late.ask("m").state, AskState::refused);
  EXPECT_NE(late.reason("m").find("so sensitive"), std::string::npos) << late.reason("m");
}

}  // namespace closed_form_motion_test
}  // namespace poinsot::problem
