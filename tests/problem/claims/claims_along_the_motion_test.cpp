// Claims of rates, which are meant in every pose that a motion may come to, whatever holds the bodies.
#include <gtest/gtest.h>

#include <string>

#include "poinsot/engine/work/work.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace claims_along_the_motion_test {

std::vector<SolvedClaim> claims_of(const std::string& bodies, const std::string& claims) {
  return solve_statement(read_statement("title: t\n" + bodies + "claim:\n" + claims, "claims.yaml"), {})
      .solutions.at(0)
      .claims;
}

// At its lowest place, and on top of a ball, energy of motion is neither won nor lost; anywhere else it is.
TEST(ClaimsAlongTheMotion, ABodyOnACordOrABallIsElsewhereThanDrawn) {
  const std::string claims =
      "  conserved: rate(kinetic_energy(p) + potential_energy(p)) == 0\n  not: rate(kinetic_energy(p)) == 0\n";
  const std::string on_a_cord =
      "letters: {m: kg, r: m}\npoints: {O: [0, 0, 0], C: [0, -r, 0]}\nbodies: {p: {particle: C, mass: m}}\n"
      "cords: {c: {from: ground, at: O, to: p, end: C}}\ngravity: -y\n";
  const std::string ball =
      "letters: {m: kg, R: m}\npoints: {O: [0, 0, 0], C: [0, R, 0]}\n"
      "bodies: {fixed: {sphere: {center: O, radius: R}, mass: 0 kg}, p: {particle: C, mass: m}}\n"
      "joints: {stand: {weld: O, to: fixed}}\ncontacts: {c: {of: p, against: fixed, at: C, normal: y}}\ngravity: -y\n";
  for (const std::string& bodies : {on_a_cord, ball}) {
    const std::vector<SolvedClaim> told = claims_of(bodies, claims);
    for (const SolvedClaim& claim : told) EXPECT_EQ(claim.state, AskState::found) << bodies << claim.reason;
    EXPECT_TRUE(told.at(0).holds) << bodies;
    EXPECT_FALSE(told.at(1).holds) << bodies;
  }
}

// A ball that rolls on a ball keeps its spin about what joins their centers, until it flies off.
TEST(ClaimsAlongTheMotion, WhatIsClaimedOfAContactEndsWithIt) {
  const std::vector<SolvedClaim> told = claims_of(
      "letters: {m: kg, r: m, R: m}\npoints: {O: [0, 0, 0], C: [0, R, 0], G: [0, R + r, 0]}\n"
      "bodies: {fixed: {sphere: {center: O, radius: R}, mass: 0 kg}, ball: {sphere: {center: G, radius: r}, mass: m}}\n"
      "joints: {stand: {weld: O, to: fixed}}\n"
      "contacts: {c: {of: ball, against: fixed, at: C, normal: y, no_slip: true}}\ngravity: -y\n",
      "  spin: rate(dot(angular_velocity(ball) with center(ball))) == 0\n  not: rate(norm(velocity(ball))) == 0\n");
  EXPECT_TRUE(told.at(0).state == AskState::found && told.at(0).holds) << told.at(0).reason;
  EXPECT_TRUE(told.at(1).state == AskState::found && !told.at(1).holds) << told.at(1).reason;
}

// On an incline that lies along no axis the place along it is open, and what holds everywhere is proved: here a spring
// from a peg on the incline pulls.
TEST(ClaimsAlongTheMotion, AnInclineIsKnownAlongItself) {
  const std::vector<SolvedClaim> told = claims_of(
      "letters: {m: kg, k: N/m, l: m, b: rad}\nassume: [10 deg < b < 80 deg]\n"
      "points: {O: [0, 0, 0], A: '-l*[cos(b), -sin(b), 0]'}\nbodies: {p: {particle: O, mass: m}}\n"
      "contacts: {c: {of: p, at: O, normal: [sin(b), cos(b), 0]}}\n"
      "springs: {s: {from: ground, at: A, to: p, end: O, stiffness: k, free_length: l}}\ngravity: none\n",
      "  conserved: rate(kinetic_energy(p) + potential_energy(s)) == 0\n"
      "  not: {claim: rate(kinetic_energy(p)) == 0, assume: [velocity(p).z == 0]}\n");
  EXPECT_TRUE(told.at(0).holds && told.at(0).proved) << told.at(0).reason;
  EXPECT_EQ(told.at(1).state, AskState::found) << told.at(1).reason;
  EXPECT_FALSE(told.at(1).holds);
}

// The slider of a crank a and a rod 2 a is pulled back all the time but near the other dead center, where its
// acceleration is a n^2/2 outwards.
TEST(ClaimsAlongTheMotion, AMachineIsFollowedUntilItHasGoneRound) {
  const std::vector<SolvedClaim> told = claims_of(
      "letters: {m: kg, a: m, n: rad/s}\npoints: {O: [0, 0, 0], A: [a, 0, 0], B: [3*a, 0, 0]}\n"
      "bodies: {crank: massless, rod: massless, slider: {particle: B, mass: m}}\n"
      "joints:\n  shaft: {revolute: z, at: O, to: crank, angle: theta, rate: n, accel: 0}\n"
      "  pin: {revolute: z, at: A, from: crank, to: rod}\n  wrist: {revolute: z, at: B, from: rod, to: slider}\n"
      "  guide: {prismatic: x, at: B, to: slider}\ngravity: none\n",
      "  back: rate(velocity(slider)).x <= 0\n"
      "  near: {claim: rate(velocity(slider)).x <= 0, assume: [center(slider).x > 2.9*a]}\n"
      "  angle: {claim: rate(velocity(slider)).x <= 0, assume: [-10 deg < theta, theta < 10 deg]}\n");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(told.at(i).state, AskState::found) << told.at(i).reason;
  EXPECT_FALSE(told.at(0).holds);
  // Only the near dead center is assumed.
  EXPECT_TRUE(told.at(1).holds && told.at(2).holds);
}

// A load that is drawn up into the hole in which its cord turns trembles there, in steps that lead nowhere.
TEST(ClaimsAlongTheMotion, WhatTremblesAboutAPlaceIsGivenUp) {
  const Work begin = work_done();
  const std::vector<SolvedClaim> told = claims_of(
      "letters: {m: kg, M: kg, r: m, h: m}\npoints: {O: [0, 0, 0], A: [r, 0, 0], B: [0, 0, -h]}\n"
      "bodies: {a: {particle: A, mass: m}, b: {particle: B, mass: M}}\ncontacts: {c: {of: a, at: A, normal: z}}\n"
      "joints: {g: {prismatic: z, at: B, to: b}}\ncords: {s: {from: a, at: A, over: [O], to: b, end: B}}\n"
      "gravity: -z\n",
      "  conserved: rate(kinetic_energy(system) + potential_energy(system)) == 0\n");
  EXPECT_TRUE(told.at(0).state == AskState::found && told.at(0).holds) << told.at(0).reason;
  EXPECT_LT(work_done() - begin, 2'500'000'000);
}

}  // namespace claims_along_the_motion_test
}  // namespace poinsot::problem
