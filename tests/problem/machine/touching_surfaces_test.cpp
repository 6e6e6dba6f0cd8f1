// Contacts of curved surfaces: what they do, and what is told of those that do not fit.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace touching_surfaces_test {

constexpr double g = 9.80665;

// A ball of radius 0.1 m at the lowest point of a bowl of 0.5 m; each part may be written otherwise.
struct BowlText {
  std::string ball = "sphere: {center: G, radius: r}", bowl = "sphere_shell: {center: O, radius: R}";
  std::string contact = "of: ball, against: bowl, at: L, normal: y, inside: bowl, no_slip: true";
  std::string given = "R: 0.5 m, r: 0.1 m", more = "instants: {now: rest}\n", asks = "f: frequencies(ball)";
  std::string text() const {
    return "title: t\ngiven: {" + given +
           "}\npoints: {O: [0, 0, 0], L: [0, -R, 0], G: [0, r - R, 0]}\nbodies: {bowl: {" + bowl +
           ", mass: 0 kg}, ball: {" + ball + ", mass: 2 kg}}\njoints: {stand: {weld: O, to: bowl}}\ncontacts: {c: {" +
           contact + "}}\ngravity: -y\n" + more + "ask: {" + asks + "}\n";
  }
};

void expect_frequencies(const std::string& text, const std::vector<double>& expected) {
  const SolvedText solved(text);
  const auto& found = solved.found("f").value.items;
  ASSERT_EQ(found.size(), expected.size()) << text << solved.reason("f");
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(found[i].number, expected[i], 1e-8 * expected[i]) << text;
}

TEST(TouchingSurfaces, ABallInABowlSwingsByItsShapes) {
  const double w = std::sqrt(5 * g / (7 * 0.4));
  expect_frequencies(BowlText{}.text(), {w, w});
  BowlText half;
  half.bowl = "hemisphere_shell: {center: O, toward: -y, radius: R}";
  expect_frequencies(half.text(), {w, w});
  BowlText smooth;
  smooth.contact = "of: ball, against: bowl, at: L, normal: y, inside: bowl";
  const double s = std::sqrt(g / 0.4);
  expect_frequencies(smooth.text(), {s, s});
  // The other way round: the bowl that holds is the one that is named, with the normal into it.
  BowlText turned;
  turned.contact = "of: bowl, against: ball, at: L, normal: -y, inside: bowl, no_slip: true";
  expect_frequencies(turned.text(), {w, w});
}

std::string refused(const BowlText& text) { return failure_of_text(text.text()); }

TEST(TouchingSurfaces, WhatDoesNotFitIsTold) {
  BowlText solid;
  solid.contact = "of: ball, against: bowl, at: L, normal: y, no_slip: true";
  EXPECT_NE(refused(solid).find("contact 'c' is on the inside of 'bowl'"), std::string::npos) << refused(solid);
  BowlText large;
  large.given = "R: 0.5 m, r: 0.6 m";
  EXPECT_NE(refused(large).find("cut into each other beside contact 'c'"), std::string::npos) << refused(large);
  BowlText apart;
  apart.ball = "sphere: {center: G, radius: 0.9999999*r}";
  EXPECT_NE(refused(apart).find("are apart by 1e-08 m"), std::string::npos) << refused(apart);
  BowlText beside;
  beside.contact = "of: ball, against: bowl, at: '[0, -1.1*R, 0]', normal: y, inside: bowl, no_slip: true";
  EXPECT_NE(refused(beside).find("'c'"), std::string::npos) << refused(beside);
  BowlText other;
  other.contact = "of: ball, against: bowl, at: L, normal: y, inside: ground, no_slip: true";
  EXPECT_NE(refused(other).find("is inside 'ground', which does not take part in it"), std::string::npos)
      << refused(other);
  BowlText askew;
  askew.contact = "of: ball, against: bowl, at: L, normal: '[0.6, 0.8, 0]', inside: bowl, no_slip: true";
  EXPECT_NE(refused(askew).find("does not stand on the surface"), std::string::npos) << refused(askew);
}

// Let go beside the lowest point of a half bowl, fast enough to come to its rim.
TEST(TouchingSurfaces, AMotionEndsAtTheRim) {
  BowlText text;
  text.bowl = "hemisphere_shell: {center: O, toward: -y, radius: R}";
  text.contact = "of: ball, against: bowl, at: L, normal: y, inside: bowl";
  text.more = "instants: {now: {velocity(ball): [4 m/s, 0, 0], angular_velocity(ball): [0, 0, 0]}}\n";
  text.asks = "f: position(ball).x @ 2 s, e: position(ball).x @ 0.05 s";
  const SolvedText solved(text.text());
  EXPECT_NE(solved.reason("f").find("beyond the end of the surface of 'bowl'"), std::string::npos)
      << solved.reason("f");
  EXPECT_GT(solved.number("e"), 0.15);
}

// A ball that rolls in a bowl keeps its energy, and its height and speed go together, in space.
TEST(TouchingSurfaces, ABallThatRollsInABowlKeepsItsEnergy) {
  BowlText text;
  text.more =
      "instants: {now: {velocity(ball): [1.2 m/s, 0, 0.5 m/s], 'component(angular_velocity(ball) along y)': 20 "
      "rad/s}}\n";
  text.asks = "T: kinetic_energy(ball) @ 1.5 s, y: position(ball).y @ 1.5 s, d: norm(position(ball)) @ 1.5 s";
  const SolvedText solved(text.text());
  // At the start it goes at 1.3 m/s, so that it turns with 13 rad/s about an axis across, and with 20 rad/s about y.
  const double I = 0.4 * 2 * 0.1 * 0.1, start = 1.3 * 1.3 + I / 2 * (13 * 13 + 20 * 20);
  EXPECT_NEAR(solved.number("T") + 2 * g * (solved.number("y") + 0.4), start, 1e-8);
  EXPECT_NEAR(solved.number("d"), 0.4, 1e-9);
}

}  // namespace touching_surfaces_test
}  // namespace poinsot::problem
