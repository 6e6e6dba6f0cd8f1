// Motions in closed form that come near an unstable equilibrium, where rounding of their data grows: they are told as
// far as they are known, and no farther.
#include <gtest/gtest.h>

#include <cmath>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace sensitive_closed_forms_test {

// On the separatrix: with I = 4, J = 5, K = 9 and w = (3, 0, 1) Euler's equations have the solution
// (3/cosh t, 3 tanh t, 1/cosh t).
std::string tumbling(const std::string& ask) {
  return "title: t\npoints: {G: [0, 0, 0]}\n"
         "bodies: {b: {mass: 9 kg, center: G, inertia: {x: 4 kg*m^2, y: 5 kg*m^2, z: 9 kg*m^2}}}\ngravity: none\n"
         "instants: {start: {angular_velocity(b): [3 rad/s, 0, 1 rad/s], velocity(b): [0, 0, 0]}}\nask: {" +
         ask + "}\n";
}

TEST(SensitiveClosedForms, OnTheSeparatrixABodyComesToItsIntermediateAxisAndStays) {
  const SolvedText solved(tumbling("w: {of: angular_velocity(b) @ 4 s, axes: b}, p: polhode(b)"));
  const Vector3<double> w = solved.vector("w");
  EXPECT_NEAR(w.x, 3 / std::cosh(4.0), 1e-6);
  EXPECT_NEAR(w.y, 3 * std::tanh(4.0), 1e-6);
  EXPECT_NEAR(w.z, 1 / std::cosh(4.0), 1e-6);
  EXPECT_EQ(solved.found("p").value.text, "on the separatrix, towards the intermediate axis");
}

// It never comes back to where it began on the other side.
TEST(SensitiveClosedForms, OnTheSeparatrixNothingIsExceeded) {
  for (const std::string ask :
       {"min(angular_velocity(b).x)", "max(angular_velocity(b).x)", "min(angular_velocity(b).y)"}) {
    const SolvedText solved(tumbling("e: {of: " + ask + ", axes: b}, H: norm(angular_momentum(b about G))"));
    const SolvedAsk& extreme = solved.ask("e");
    if (extreme.state == AskState::found) {
      const double exact = ask.starts_with("max") ? 3 : 0;
      EXPECT_NEAR(extreme.value.number, exact, 1e-6) << ask;
    }
    EXPECT_NEAR(solved.number("H"), 15, 1e-12);
  }
}

// A pendulum with just the speed that leads to its highest place: whether it goes over it or falls back is rounding.
TEST(SensitiveClosedForms, APendulumThatJustReachesItsHighestPlaceHasNoSlowestRate) {
  const auto solved_at = [](double part) {
    return SolvedText(
        "title: t\ngiven: {v: " + std::to_string(part) +
        "*sqrt(6*9.80665 m/s^2/(1 m))}\npoints: {O: [0, 0, 0], A: [0, -1 m, 0]}\n"
        "bodies: {bar: {rod: [O, A], mass: 2 kg}}\njoints: {pin: {revolute: z, at: O, to: bar, angle: th}}\n"
        "gravity: -y\ninstants: {start: {th: 0, th': v}}\nask: {slowest: min(th'), fastest: max(th')}\n");
  };
  const SolvedText just = solved_at(1);
  EXPECT_NE(just.reason("slowest").find("so sensitive"), std::string::npos) << just.reason("slowest");
  EXPECT_NEAR(solved_at(0.999).number("slowest"), -0.999 * std::sqrt(6 * 9.80665), 1e-8);
  EXPECT_GT(solved_at(1.001).number("slowest"), 0);
}

// Data that are on the separatrix exactly stay there.
TEST(SensitiveClosedForms, OnTheSeparatrixABodyIsAtItsIntermediateAxisInTheEnd) {
  for (const double time : {50.0, 200.0}) {
    const SolvedText solved(tumbling("w: {of: angular_velocity(b) @ " + std::to_string(time) + " s, axes: b}"));
    const Vector3<double> w = solved.vector("w");
    EXPECT_NEAR(w.x, 3 / std::cosh(time), 1e-12);
    EXPECT_NEAR(w.y, 3, 1e-12);
    EXPECT_NEAR(w.z, 1 / std::cosh(time), 1e-12);
  }
}

// With roots in the data rounding leaves some of a zero.
TEST(SensitiveClosedForms, RootsInTheDataAreOnTheSeparatrixToo) {
  const SolvedText solved(
      "title: t\npoints: {G: [0, 0, 0]}\n"
      "bodies: {b: {mass: 9 kg, center: G, inertia: {x: 1 kg*m^2, y: 2 kg*m^2, z: 3 kg*m^2}}}\ngravity: none\n"
      "facts: {angular_velocity(b): ['sqrt(3) * 0.7 rad/s', 0, 0.7 rad/s]}\nask: {p: polhode(b)}\n");
  EXPECT_EQ(solved.found("p").value.text, "on the separatrix, towards the intermediate axis");
}

// q = 4 atan(exp(n t)) - pi with n^2 = g/L.
std::string just_reaching(const std::string& ask) {
  return "title: t\ngiven: {L: 0.5 m, g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
         "bodies: {b: {particle: P, mass: 1 kg}}\njoints: {pin: {revolute: z, at: O, to: b, angle: q}}\ngravity: -y\n"
         "instants: {start: {q: 0, q': 2*sqrt(g/L)}}\nask: {" +
         ask + "}\n";
}

// An instant so near the top that the pendulum creeps may come at quite another time, and so may the end of a stage.
TEST(SensitiveClosedForms, WhatFollowsAnUncertainInstantIsRefused) {
  std::string text = just_reaching(
      "a: q @ later, e: q @ up.end, early: q @ 1 s, tab: {table: {q: q}, over: {time: '0 s .. 12 s by 2 s'}}, "
      "lengths: {table: {w: q' @ top}, over: {L: [0.5 m]}}, own: q' @ top");
  text.replace(text.find("instants: {"), 11,
               "stages: {up: {until: q == 179.9999999 deg}, later: {lasts: 10 s}}\n"
               "instants: {top: {first_time: q == 179.9999999 deg}, ");
  const SolvedText solved(text);
  for (const char* refused : {"a", "e", "own", "lengths"})
    EXPECT_NE(solved.reason(refused).find("so sensitive"), std::string::npos) << refused << solved.reason(refused);
  EXPECT_EQ(solved.found("early").state, AskState::found);
  EXPECT_EQ(solved.column("tab", 0).size(), 3U);
}

// An instant of the same name in another situation has no part in it.
TEST(SensitiveClosedForms, AnUncertainInstantOfAnotherSituationIsNone) {
  const auto situation = [](const std::string& name, const std::string& rate) {
    return "  " + name + ":\n    points: {O: [0, 0, 0], P: [0, -L, 0]}\n    bodies: {b: {particle: P, mass: 1 kg}}\n" +
           "    joints: {pin: {revolute: z, at: O, to: b, angle: q}}\n    gravity: -y\n" +
           "    instants: {start: {q: 0, q': " + rate + "}, top: {first_time: q == 179.9999999 deg}}\n";
  };
  const SolvedText solved("title: t\ngiven: {L: 0.5 m, g: 9.81 m/s^2}\nsituations:\n" +
                          situation("just", "2*sqrt(g/L)") + situation("fast", "3*sqrt(g/L)") +
                          "ask: {slow: q' @ just.top, quick: q' @ fast.top}\n");
  EXPECT_NE(solved.reason("slow").find("so sensitive"), std::string::npos) << solved.reason("slow");
  EXPECT_NEAR(solved.number("quick"), std::sqrt(5 * 9.81 / 0.5), 1e-6);
}

TEST(SensitiveClosedForms, APendulumJustReachesItsHighestPlace) {
  const double n = std::sqrt(9.81 / 0.5);
  const SolvedText solved(just_reaching("q: q @ 2 s, t: {first_time: q == 170 deg}, top: max(q)"));
  // It comes ever nearer to its top.
  EXPECT_NE(solved.reason("top").find("no largest value"), std::string::npos) << solved.reason("top");
  EXPECT_NEAR(solved.number("q"), 4 * std::atan(std::exp(2 * n)) - M_PI, 1e-6);
  EXPECT_NEAR(solved.number("t"), std::log(std::tan(350 * M_PI / 720)) / n, 1e-9);
  for (const char* time : {"8 s", "10 s", "50 s", "500 s"}) {
    const SolvedText late(just_reaching(std::string("q: q @ ") + time + ", w: q'"));
    EXPECT_NE(late.reason("q").find("so sensitive"), std::string::npos) << time << late.reason("q");
    // What was stated of the start is as good as it was.
    EXPECT_NEAR(late.number("w"), 2 * n, 1e-12);
  }
}

// That it stands upside down at some time is rounding, too; a degree below it is not.
TEST(SensitiveClosedForms, APendulumThatJustReachesItsHighestPlaceIsNeverSeenThere) {
  const SolvedText solved(
      "title: t\ngiven: {L: 0.8 m, w: sqrt(4*9.80665 m/s^2/L)}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
      "bodies: {bob: {particle: P, mass: 1 kg}}\njoints: {pin: {revolute: z, at: O, to: bob, angle: theta}}\n"
      "gravity: -y\ninstants: {start: {theta: 0, theta': w}, above: {first_time: theta == 180 deg}}\n"
      "ask: {up: {first_time: theta == 180 deg}, rate: theta' @ above, near: "
      "{first_time: theta == 179 deg}}\n");
  // theta = 2 atan(sinh(t sqrt(g/L)))
  EXPECT_NEAR(solved.number("near"), std::sqrt(0.8 / 9.80665) * std::asinh(std::tan(89.5 * std::acos(-1) / 180)), 1e-6);
  for (const char* name : {"up", "rate"})
    EXPECT_NE(solved.reason(name).find("sensitive"), std::string::npos) << solved.reason(name);
}

// Nor that it stops.
TEST(SensitiveClosedForms, APendulumThatJustReachesItsHighestPlaceIsNeverSeenToStop) {
  for (const char* length : {"0.5 m", "0.8 m", "1 m", "1.3 m", "2 m"}) {
    const SolvedText solved(
        std::string("title: t\ngiven: {L: ") + length +
        "}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\nbodies: {bob: {particle: P, mass: 1 kg}}\n"
        "joints: {pin: {revolute: z, at: O, to: bob, angle: q}}\ngravity: -y\n"
        "instants: {start: {q: 0, q': 2*sqrt(9.80665 m/s^2/L)}}\nask: {stops: {first_time: q' == 0 rad/s}, w: q'}\n");
    EXPECT_NE(solved.ask("stops").state, AskState::found) << length;
  }
}

}  // namespace sensitive_closed_forms_test
}  // namespace poinsot::problem
