// When smooth contacts touch and part and cords are taut, motions of bodies whose flight is open, and the energy of
// what comes to rest, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace motion_holds_test {

constexpr double g = 9.80665;

std::string dropped(double restitution, double floor, const std::string& asks) {
  const std::string y = std::to_string(floor), e = std::to_string(restitution);
  return "title: t\npoints: {C: [0, '" + y + " m + 0.5 m', 0], O: [0, " + y +
         " m, 0]}\nbodies: {ball: {particle: C, mass: 2 kg}}\n"
         "contacts: {floor: {of: ball, at: C, normal: y, open: true, surface: O, restitution: " +
         e + "}}\ngravity: -y\ninstants: {start: rest, lands: {first_time: touching(floor)}}\nask: {" + asks + "}\n";
}

// The energy of the last bounces is nothing beside that of the first, also where the floor is the level of no energy.
TEST(MotionHolds, BounceAfterBounceIsTouchingAndParting) {
  const double fall = std::sqrt(2 * 0.5 / g);
  for (const double e : {0.1, 0.5, 0.8})
    for (const double floor : {0.0, 3.0}) {
      const SolvedText solved(dropped(e, floor,
                                      "ends: end_of_bouncing(floor), first: {first_time: touching(floor)}, "
                                      "apart: {times: parting(floor), from: 0.1 s, to: 0.5 s}, t: time @ lands"));
      EXPECT_NEAR(solved.number("ends"), (1 + e) / (1 - e) * fall, 1e-8);
      EXPECT_NEAR(solved.number("first"), fall, 1e-9);
      EXPECT_NEAR(solved.number("t"), fall, 1e-9);
      // It is apart from the start of the span, and parts again in each blow.
      EXPECT_GE(solved.found("apart").value.items.size(), 2U);
      EXPECT_NEAR(solved.found("apart").value.items.at(0).number, 0.1, 1e-9);
      EXPECT_NEAR(solved.found("apart").value.items.at(1).number, fall, 1e-9);
    }
}

TEST(MotionHolds, ABallRestsWithoutRebound) {
  const SolvedText solved(dropped(
      0, 0, "t: {times: touching(floor), from: 0 s, to: 2 s}, apart: {times: parting(floor), from: 0.1 s, to: 2 s}"));
  EXPECT_EQ(solved.found("apart").value.items.size(), 1U);  // the start of the span
  ASSERT_EQ(solved.found("t").value.items.size(), 1U);
  EXPECT_NEAR(solved.found("t").value.items.at(0).number, std::sqrt(1 / g), 1e-9);
}

// A ladder leaves its wall at two thirds of the height from which it slides.
TEST(MotionHolds, ALadderLeavesItsWall) {
  const SolvedText solved(
      "title: t\nplane: [x, y]\ngiven: {b: 25 deg}\npoints: {A: '[0, 2 m * cos(b)]', B: '[2 m * sin(b), 0]'}\n"
      "bodies: {rod: {rod: [A, B], mass: 3 kg}}\n"
      "contacts: {wall: {of: rod, at: A, normal: x}, floor: {of: rod, at: B, normal: y}}\ngravity: -y\n"
      "instants: {start: rest, leaves: {first_time: parting(wall)}}\n"
      "ask: {h: position(A of rod).y @ leaves, N: force(floor on rod).y @ leaves, at_once: {first_time: "
      "touching(wall)}}\n");
  EXPECT_NEAR(solved.number("h"), 4 * std::cos(25 * M_PI / 180) / 3, 1e-8);
  EXPECT_EQ(solved.number("at_once"), 0);
}

// A ball in free fall is caught by its cord where it comes to the length that it has had from the start.
TEST(MotionHolds, ACordCatches) {
  const SolvedText solved(
      "title: t\npoints: {A: [0, 0, 0], B: [0, 1 m, 0]}\nbodies: {ball: {particle: B, mass: 1 kg}}\n"
      "cords: {cord: {at: A, to: ball, end: B}}\ngravity: -y\n"
      "instants: {start: {velocity(ball): [0.5 m/s, 0, 0]}}\n"
      "ask: {t: {first_time: taut(cord), from: 0.05 s}, y: center(ball).y @ 0.3 s}\n");
  // x^2 + (1 - g t^2/2)^2 = 1 with x = t/2: t^2/4 - g t^2 + g^2 t^4/4 = 0.
  const double t = std::sqrt(g - 0.25) * 2 / g;
  EXPECT_NEAR(solved.number("t"), t, 1e-8);
  EXPECT_NEAR(solved.number("y"), 1 - g * 0.045, 1e-9);
}

TEST(MotionHolds, WhatIsNotThereIsNamed) {
  EXPECT_NE(failure_of_text(dropped(0.5, 0, "t: {first_time: touching(flor)}")).find("did you mean 'floor'"),
            std::string::npos);
  EXPECT_NE(failure_of_text(dropped(0.5, 0, "t: {first_time: sticking(floor)}")).find("with friction"),
            std::string::npos);
}

// The turning of a plate with moments J, J, 2 J goes round about its angular momentum, wherever it flies.
TEST(MotionHolds, TheTurningOfWhatFliesFreeNeedsNoFlight) {
  const SolvedText solved(
      "title: t\npoints: {G: [0, 0, 0], A: [0.1 m, 0, 0]}\n"
      "bodies: {plate: {rectangle: {center: G, sides: [0.3 m * x, 0.3 m * y]}, mass: 2 kg}}\n"
      "facts: {angular_velocity(plate): [5 rad/s, 0, 5 rad/s]}\ngravity: -z\n"
      "ask: {w: angular_velocity(plate) @ 0.7 s, v: velocity(plate) @ 0.7 s, p: position(A of plate) @ 0.001 s,\n"
      "  r: position(A of plate) @ 0.7 s - center(plate) @ 0.7 s, T: kinetic_energy(plate) @ 0.7 s}\n");
  const double turned = std::sqrt(5) * 5 * 0.7;
  const Vector3<double> w = solved.vector("w");
  EXPECT_NEAR(w.x, 3 + 2 * std::cos(turned), 1e-9);
  EXPECT_NEAR(w.y, std::sqrt(5) * std::sin(turned), 1e-9);
  EXPECT_NEAR(w.z, 6 - std::cos(turned), 1e-9);
  EXPECT_NEAR(norm(solved.vector("r")), 0.1, 1e-9);
  for (const char* open : {"v", "p", "T"})
    EXPECT_NE(solved.reason(open).find("velocity of plate along"), std::string::npos) << solved.reason(open);
}

}  // namespace motion_holds_test
}  // namespace poinsot::problem
