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

}  // namespace parting_blows_test
}  // namespace poinsot::problem
