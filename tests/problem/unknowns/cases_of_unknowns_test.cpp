// Unknowns whose equations differ from case to case: on the sides of a corner, as of abs and max, and with the cords
// and contacts that act in a blow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace cases_of_unknowns_test {

struct Solved {
  std::vector<double> roots;  // of the first question
  std::string warnings;
};

Solved solved(const std::string& text) {
  Solved found;
  const SolvedStatement solution = solve_statement(read_statement(text, "test.yaml"), {});
  for (const auto& one : solution.solutions) found.roots.push_back(one.asks.front().value.number);
  std::sort(found.roots.begin(), found.roots.end());
  for (const std::string& warning : solution.warnings) found.warnings += warning + "\n";
  return found;
}

void expect_roots(const std::string& text, std::vector<double> roots) {
  const Solved found = solved(text);
  std::sort(roots.begin(), roots.end());
  ASSERT_EQ(found.roots.size(), roots.size()) << text << found.warnings;
  for (std::size_t i = 0; i < roots.size(); ++i) EXPECT_NEAR(found.roots[i], roots[i], 1e-9 * (1 + std::abs(roots[i])));
}

std::string slider(const std::string& fact, const std::string& range) {
  return "find: {v: m/s}\nwhere: [" + range +
         "]\npoints: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: 2 kg}}\n"
         "joints: {r: {prismatic: x, at: O, to: b, rate: v}}\ngravity: none\ninstants: {now: {" +
         fact + "}}\nask: {v: v}\n";
}

// Wherever the range lies about the corner.
TEST(CasesOfUnknowns, RootsOnBothSidesOfACorner) {
  for (const char* range : {"-10 m/s < v < 100 m/s", "-100 m/s < v < 10 m/s", "-4 m/s < v < 4 m/s", "v > -1000 m/s"}) {
    expect_roots(slider("abs(velocity(b).x): 3 m/s", range), {-3, 3});
    expect_roots(slider("norm(velocity(b)): 3 m/s", range), {-3, 3});
    expect_roots(slider("'max(velocity(b).x with 0 m/s - 2*velocity(b).x)': 3 m/s", range), {-1.5, 3});
    // The corner lies beyond where facts are tried for being linear.
    expect_roots(slider("'max(velocity(b).x + 1 m/s with 5 m/s - 2*velocity(b).x)': 4 m/s", range), {0.5, 3});
  }
  expect_roots(slider("'min(velocity(b).x with 2 m/s)': 2 m/s", "-10 m/s < v < 2 m/s"), {});
}

// max(v - a, c - k v) = s at random a, c, k, s: each branch is solved and kept where it is the larger one.
TEST(CasesOfUnknowns, RandomCornersAsTheirBranches) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-5, 5);
  int two = 0;
  for (int n = 0; n < 60; ++n) {
    const double a = uniform(random), c = uniform(random), k = 1 + std::abs(uniform(random)), s = uniform(random);
    std::vector<double> roots;
    const double first = s + a, second = (c - s) / k;
    if (c - k * first <= s) roots.push_back(first);
    if (second - a <= s) roots.push_back(second);
    two += roots.size() == 2;
    const auto text = [](double x) { return "(" + std::to_string(x) + ")"; };
    // What std::to_string rounds is as small as the tolerance allows.
    const std::string fact = "'max(velocity(b).x - " + text(a) + "*1 m/s with " + text(c) + "*1 m/s - " + text(k) +
                             "*velocity(b).x)': " + text(s) + "*1 m/s";
    const Solved found = solved(slider(fact, "-40 m/s < v < 75 m/s"));
    ASSERT_EQ(found.roots.size(), roots.size()) << fact << "\n" << found.warnings;
    std::sort(roots.begin(), roots.end());
    for (std::size_t i = 0; i < roots.size(); ++i) EXPECT_NEAR(found.roots[i], roots[i], 1e-5);
  }
  EXPECT_GT(two, 10);
}

std::string struck_bob(const std::string& fact) {
  return "given: {m: 2 kg, L: 1 m}\nfind: {J: N*s}\nwhere: [-20 N*s < J < 20 N*s]\n"
         "points: {O: [0, 0, 0], B: [L, 0, 0]}\nbodies: {bob: {particle: B, mass: m}}\n"
         "cords: {c: {from: ground, at: O, to: bob, end: B}}\nimpulses: {k: {body: bob, value: [J, 3 N*s, 0]}}\n"
         "gravity: none\ninstants: {before: rest, after: {" +
         fact + "}}\nask: {J: J}\n";
}

// Outwards the cord takes the blow, inwards it goes slack: then (J^2 + 9) / 4 = 6.25 for J < 0.
TEST(CasesOfUnknowns, ABlowThatLeavesTheCordSlack) {
  expect_roots(struck_bob("norm(velocity(bob)): 2.5 m/s"), {-4});
  expect_roots(struck_bob("velocity(bob).x: -1.5 m/s"), {-3});
}

// What is no solution in one case, as the other sign is while the cord is slack, is not told.
TEST(CasesOfUnknowns, WhatIsNoSolutionInOneCaseIsNoWarning) {
  const Solved found = solved(
      "find: {J: N*s}\nwhere: [-50 N*s < J < 50 N*s]\npoints: {O: [0, 0, 0], B: [0, -1 m, 0]}\n"
      "bodies: {b: {particle: B, mass: 2 kg}}\ncords: {c: {from: ground, at: O, to: b, end: B}}\n"
      "impulses: {k: {body: b, value: [3 N*s, J, 0]}}\ngravity: none\n"
      "instants: {before: rest, after: {kinetic_energy(b): 4 J}}\nask: {J: J}\n");
  ASSERT_EQ(found.roots.size(), 1U);
  EXPECT_NEAR(found.roots[0], std::sqrt(7.0), 1e-9);
  EXPECT_EQ(found.warnings, "");
}

// Both cases have a root: against the taut cord the impulse of the cord is asked, which for J < 0 is zero.
TEST(CasesOfUnknowns, ABlowWithRootsInBothCases) {
  expect_roots(struck_bob("'abs(velocity(bob).x - 1 m/s) + norm(impulse(c on bob))/1 kg': 3 m/s"), {-4, 2});
}

TEST(CasesOfUnknowns, ARootThatAContactForbidsIsLeftOut) {
  const Solved found = solved(
      "find: {F: N}\npoints: {C: [0, 0, 0], G: [0, 0.1 m, 0]}\n"
      "bodies: {b: {sphere: {center: G, radius: 0.1 m}, mass: 2 kg}}\ncontacts: {k: {of: b, at: C, normal: y}}\n"
      "loads: {p: {force: [F, 2*F, 0], body: b}}\ngravity: -y\n"
      "instants: {now: {velocity(b): [0, 0, 0], angular_velocity(b): [0, 0, 0], norm(acceleration(b)): 7 m/s^2}}\n"
      "ask: {F: F}\n");
  ASSERT_EQ(found.roots.size(), 1U) << found.warnings;
  EXPECT_NEAR(found.roots[0], -14, 1e-9);
  EXPECT_NE(found.warnings.find("the contact 'k' would have to pull"), std::string::npos) << found.warnings;
}

}  // namespace cases_of_unknowns_test
}  // namespace poinsot::problem
