// Contacts that roll and give way in a blow: what has parted may slip either way, and what has not does not slip.
#include <gtest/gtest.h>

#include <string>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace parting_blows_test {

constexpr double m = 0.17, r = 0.028, J = 0.5;

std::string struck(const std::string& given, const std::string& impulse, const std::string& rest) {
  return "title: t\ngiven: {m: 0.17 kg, r: 28 mm, J: 0.5 N*s" + given +
         "}\npoints: {C: [0, 0, 0], G: [0, r, 0], P: [0, r + h, 0]}\n"
         "bodies: {ball: {sphere: {center: G, radius: r}, mass: m}}\n"
         "contacts: {table: {of: ball, at: C, normal: y, no_slip: true}}\n"
         "impulses: {cue: {body: ball, at: P, value: " +
         impulse + "}}\ngravity: -y\n" + rest;
}

TEST(PartingBlows, ABallThatLeavesItsTableMovesEitherWay) {
  for (const double side : {1.0, -1.0}) {
    const SolvedText solved(
        struck(", h: 5 mm", side > 0 ? "[J, 2*J, 0]" : "[-J, 2*J, 0]",
               "instants: {before: rest}\nask: {v: velocity(ball), w: angular_velocity(ball).z}\n"));
    EXPECT_NEAR(solved.vector("v").x, side * J / m, 1e-12);
    EXPECT_NEAR(solved.vector("v").y, 2 * J / m, 1e-12);
    EXPECT_NEAR(solved.number("w"), -side * J * 0.005 / (0.4 * m * r * r), 1e-9);
  }
}

// Coriolis: struck at 2 r/5 above its center a ball rolls at once.
TEST(PartingBlows, ABallRollsAtOnceWhereTheTableNeedNotHelp) {
  for (const char* impulse : {"[J, 0, 0]", "[-J, 0, 0]", "[0, 0, J]", "[J, -2*J, 0]"}) {
    const std::string along = std::string(impulse) == "[0, 0, J]" ? "z" : "x";
    const SolvedText solved(struck(
        "", impulse,
        "find: {h: mm}\ninstants: {before: rest, after: {impulse(table on ball)." + along + ": 0}}\nask: {h: h}\n"));
    EXPECT_NEAR(solved.number("h"), 0.4 * r, 1e-9) << impulse;
  }
}

// A bar on two supports, or on two cords, of which one is lifted: just after the blow that one carries nothing, and the
// bar swings about the other, 3 g/(2 L). At the instant itself, where both are still in the equations, nothing is told.
TEST(PartingBlows, WhatGaveWayCarriesNothingAfterIt) {
  for (const char* held : {"contacts: {a: {of: bar, corner: A, normal: y}, b: {of: bar, corner: B, normal: y}}\n",
                           "cords: {a: {holds: bar, at: A, pulls: y}, b: {holds: bar, at: B, pulls: y}}\n"}) {
    const bool cords = std::string(held).starts_with("cords");
    const std::string force = cords ? "tension" : "normal_force";
    const SolvedText solved(
        "title: t\ngiven: {L: 1 m}\npoints: {A: [0, 0, 0], B: [L, 0, 0]}\nbodies: {bar: {rod: [A, B], mass: 2 kg}}\n" +
        std::string(held) +
        "impulses: {blow: {body: bar, at: B, value: [0, 3 N*s, 0]}}\ninstants: {before: rest}\ngravity: -y\n"
        "ask: {v: velocity(B of bar).y, a: angular_acceleration(bar).z, at_once: angular_acceleration(bar).z @ 0 s, "
        "N: " +
        force + "(a) @ 0 s, M: " + force + "(b) @ 0 s, B: " + force + "(b) @ before}\n");
    EXPECT_NEAR(solved.number("v"), 4.5, 1e-12);
    EXPECT_NEAR(solved.number("at_once"), -1.5 * 9.80665, 1e-9);
    EXPECT_NEAR(solved.number("N"), 9.80665 / 2, 1e-9);
    EXPECT_NEAR(solved.number("M"), 0, 1e-9);
    EXPECT_NEAR(solved.number("B"), 9.80665, 1e-9);
    const SolvedAsk& after = solved.ask("a");
    EXPECT_EQ(after.state, AskState::undetermined);
    EXPECT_NE(after.reason.find("@ 0 s"), std::string::npos) << after.reason;
    EXPECT_NE(after.reason.find("'b' gives way in the blow"), std::string::npos) << after.reason;
  }
}

}  // namespace parting_blows_test
}  // namespace poinsot::problem
