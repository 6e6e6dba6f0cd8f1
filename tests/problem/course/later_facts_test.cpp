// Unknowns that are found from what is stated of a later instant.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace later_facts_test {

// A particle has no length by which a place that it misses could be measured.
std::string thrown(const std::string& data, const std::string& gravity, const std::string& facts,
                   const std::string& asks) {
  return "title: t\n" + data + "points: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: 1 kg}}\ngravity: " + gravity +
         "\ninstants: {" + facts + "}\nask: {" + asks + "}\n";
}

TEST(LaterFacts, TheGravityInWhichAThrownParticleComesToAPlace) {
  for (const double size : {1e-6, 1.0, 1e3}) {
    const std::string Y = std::to_string(3 * size), v = std::to_string(5 * size);
    const SolvedText solved(thrown("given: {Y: " + Y + " m, v: " + v + " m/s}\nfind: {a: m/s^2}\n", "[0, -a, 0]",
                                   "start: {velocity(b): [0, v, 0]}, 2 s: {center(b).y: Y}",
                                   "a: a, h: center(b).y @ 2 s"));
    EXPECT_NEAR(solved.number("a"), 3.5 * size, 1e-9 * size);
    EXPECT_NEAR(solved.number("h"), 3 * size, 1e-9 * size);
  }
}

// A place that is next to nothing beside the way there is met to rounding. So it is where it is found out that it
// holds.
TEST(LaterFacts, PlacesThatAreSmallBesideTheWay) {
  for (const char* Y : {"1e-6 m", "1e-8 m", "1e-12 m", "-1e-7 m"}) {
    const std::string facts = std::string("start: {velocity(b): [0, 5 m/s, 0]}, 2 s: {center(b).y: ") + Y + "}";
    const SolvedText solved(thrown("find: {a: m/s^2}\n", "[0, -a, 0]", facts, "a: a"));
    EXPECT_NEAR(solved.number("a"), 5, 1e-6) << Y;
  }
  const SolvedText known(thrown("", "[0, -4.99999995 m/s^2, 0]",
                                "start: {velocity(b): [0, 5 m/s, 0]}, 2 s: {center(b).y: 1e-7 m}",
                                "h: center(b).y @ 1 s"));
  EXPECT_NEAR(known.number("h"), 2.500000025, 1e-12);
}

TEST(LaterFacts, TheVelocityWithWhichAParticleWasThrown) {
  const SolvedText solved(thrown("find: {u: m/s, v: m/s}\n", "[0, -10 m/s^2, 0]",
                                 "start: {velocity(b): [u, v, 0]}, 2 s: {center(b).x: 8 m, center(b).y: -1 m}",
                                 "u: u, v: v"));
  EXPECT_NEAR(solved.number("u"), 4, 1e-8);
  EXPECT_NEAR(solved.number("v"), 9.5, 1e-8);
}

TEST(LaterFacts, TheForceThatBringsAParticleToAPlace) {
  const SolvedText solved(
      "title: t\nfind: {F: N}\npoints: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: 2 kg}}\n"
      "loads: {push: {force: [F, 0, 0], at: O, body: b}}\ngravity: none\n"
      "instants: {start: {velocity(b): [5 m/s, 0, 0]}, 2 s: {center(b).x: 3 m}}\nask: {F: F}\n");
  EXPECT_NEAR(solved.number("F"), -7, 1e-8);
}

// Of two times at which it may pass there, x = v t cos b and y = v t sin b - g t^2/2 allow one.
TEST(LaterFacts, TheSpeedAndTheTimeOfAThrowThatHitsAPlace) {
  const SolvedText solved(thrown("find: {v: m/s, t: s}\n", "[0, -10 m/s^2, 0]",
                                 "start: {velocity(b): [v*cos(45 deg), v*sin(45 deg), 0]},"
                                 " t: {center(b).x: 30 m, center(b).y: 2 m}",
                                 "v: v, t: t"));
  EXPECT_NEAR(solved.number("t"), std::sqrt(5.6), 1e-7);
  EXPECT_NEAR(solved.number("v"), 30 / std::sqrt(2.8), 1e-7);
}

// What no force along x changes is missed by as much however far that drives it.
TEST(LaterFacts, APlaceThatIsMissedIsNotNearBecauseTheWayIsLong) {
  for (const char* stated : {"-20.001 m", "0 m"}) {
    const std::string text = std::string(
                                 "title: t\nfind: {F: N}\nwhere: [0 N < F < 1e8 N]\npoints: {O: [0, 0, 0]}\n"
                                 "bodies: {b: {particle: O, mass: 2 kg}}\n"
                                 "loads: {push: {force: [F, 0, 0], at: O, body: b}}\ngravity: [0, -10 m/s^2, 0]\n"
                                 "instants: {start: {velocity(b): [5 m/s, 0, 0]}, 2 s: {center(b).y: ") +
                             stated + "}}\nask: {F: F}\n";
    EXPECT_EQ(solve_statement(read_statement(text, "test.yaml"), {}).solutions.size(), 0U) << stated;
  }
}

}  // namespace later_facts_test
}  // namespace poinsot::problem
