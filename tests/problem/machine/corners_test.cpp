// Corners of bodies given by numbers, against the same bodies with a shape.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace corners_test {

// A block of sides a, b, c that stands on a corner, as a shape or by its numbers.
struct Block {
  double a, b, c, w;

  std::string text(bool by_numbers, const std::string& contact, const std::string& asks) const {
    const std::string given = fmt::format("given: {{m: 3 kg, a: {} m, b: {} m, c: {} m, w: {} rad/s}}\n", a, b, c, w);
    const std::string shape = by_numbers ? "center: G, inertia: {x: m*(b^2 + c^2)/12, y: m*(a^2 + c^2)/12, z: m*(a^2 + "
                                           "b^2)/12, xy: 0, yz: 0, zx: 0}"
                                         : "box: {center: G, sides: [a*x, b*y, c*z]}";
    return "title: t\n" + given + "points: {A: [0, 0, 0], G: [a/2, b/2, c/2]}\nbodies: {block: {" + shape +
           ", mass: m}}\ncontacts: {c: {of: block, " + (by_numbers ? "corner" : "at") + ": A, normal: y" + contact +
           "}}\ngravity: -y\ninstants: {start: {velocity(A of block): [0, 0, 0], angular_velocity(block): [w/2, w, "
           "-w]}}\nask: {" +
           asks + "}\n";
  }
};

TEST(Corners, ABodyGivenByNumbersTouchesWithOneAsABlockDoes) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> length(0.2, 0.9), rate(0.1, 0.8);
  int tried = 0;
  for (const char* contact : {"", ", no_slip: true", ", friction: {static: 0.4, kinetic: 0.3}"}) {
    const Block block{length(random), length(random), length(random), rate(random)};
    const std::string asks = "N: normal_force(c), a: acceleration(block), w: angular_velocity(block) @ 20 ms";
    const SolvedText shaped(block.text(false, contact, asks)), numbers(block.text(true, contact, asks));
    const double N = shaped.found("N").value.number;
    EXPECT_GT(N, 0);
    EXPECT_NEAR(numbers.found("N").value.number, N, 1e-12 * N) << contact;
    for (const char* ask : {"a", "w"})
      EXPECT_LE(norm(numbers.found(ask).value.vector - shaped.found(ask).value.vector),
                1e-10 * norm(shaped.found(ask).value.vector))
          << contact << ask;
    ++tried;
  }
  EXPECT_EQ(tried, 3);
}

TEST(Corners, WhatIsNotKnownToTouchIsTold) {
  const Block block{0.4, 0.5, 0.6, 0.1};
  std::string at = block.text(true, "", "N: normal_force(c)");
  at.replace(at.find("corner: A"), 9, "at: A");
  EXPECT_NE(failure_of_text(at).find("write corner: in place of at:"), std::string::npos) << failure_of_text(at);
  const std::string twice = failure_of_text(block.text(true, ", at: A", "N: normal_force(c)"));
  EXPECT_NE(twice.find("states its place twice, under corner: and at:"), std::string::npos) << twice;
}

// The push of a smooth contact is the part of its force along its normal, also where that turns in the motion.
TEST(Corners, TheNormalForceOfASmoothContactIsThatAlongItsNormal) {
  const SolvedText solved(
      "title: t\ngiven: {R: 0.5 m, r: 0.1 m}\npoints: {O: [0, 0, 0], L: [R*sin(1 rad), -R*cos(1 rad), 0], G: (1 - "
      "r/R)*L}\n"
      "bodies: {bowl: {sphere_shell: {center: O, radius: R}, mass: 0 kg}, ball: {sphere: {center: G, radius: r}, "
      "mass: 2 kg}}\njoints: {stand: {weld: O, to: bowl}}\ncontacts: {c: {of: ball, against: bowl, at: L, normal: "
      "'L->O', inside: bowl}}\ngravity: -y\ninstants: {start: rest}\ndefine: {n: direction(center(ball))}\n"
      "ask: {N: normal_force(c) @ 0.3 s, F: dot(force(c on ball) with n) @ 0.3 s, S: normal_force(c)}\n");
  EXPECT_NEAR(solved.found("N").value.number, -solved.found("F").value.number, 1e-9 * solved.found("N").value.number);
  EXPECT_NEAR(solved.found("S").value.number, 2 * 9.80665 * std::cos(1.0), 1e-9);
  EXPECT_GT(std::abs(solved.found("N").value.number - solved.found("S").value.number), 1);
}

}  // namespace corners_test
}  // namespace poinsot::problem
