// A time or a named instant of one of several situations.
#include <gtest/gtest.h>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace {
namespace times_in_situations_test {

const std::string thrown =
    "title: t\ngiven: {v: 12 m/s, s: 0.5 s, g: 10 m/s^2}\npoints: {O: [0, 0, 0]}\nbodies: {ball: {particle: O, mass: 1 "
    "kg}}\ngravity: -y\ndefine: {up: center(ball).y}\nsituations:\n  slow: {instants: {start: {velocity(ball): [0, v, "
    "0]}, highest: {first_time: velocity(ball).y == 0}}}\n  fast: {instants: {start: {velocity(ball): [0, 2*v, 0]}, "
    "highest: {first_time: velocity(ball).y == 0}}}\n";

TEST(TimesInSituations, AreAskedInEitherOrderAndOfSums) {
  const SolvedText solved(thrown +
                          "ask:\n  a: center(ball).y @ 2 s @ slow\n  b: center(ball).y @ fast @ 2 s\n  c: "
                          "center(ball).y @ s @ fast\n  d: center(ball).y @ highest @ slow\n  e: center(ball).y @ "
                          "fast.highest\n  f: (center(ball).y + 2*up) @ 1 s @ fast\n  h: up @ 1 s @ fast - up @ 1 s @ "
                          "slow\n");
  EXPECT_NEAR(solved.number("a"), 12 * 2 - 20, 1e-9);
  EXPECT_NEAR(solved.number("b"), 24 * 2 - 20, 1e-9);
  EXPECT_NEAR(solved.number("c"), 24 * 0.5 - 1.25, 1e-9);
  EXPECT_NEAR(solved.number("d"), 144 / 20.0, 1e-9);
  EXPECT_NEAR(solved.number("e"), 576 / 20.0, 1e-9);
  EXPECT_NEAR(solved.number("f"), 3 * 19, 1e-9);
  EXPECT_NEAR(solved.number("h"), 12, 1e-9);
}

TEST(TimesInSituations, SayWhatIsMissing) {
  EXPECT_EQ(failure_of_text(thrown + "ask: {a: center(ball).y @ 2 s}\n"),
            "test.yaml:10:27: error: in which situation is it 2 s? (write @ 2 s @ one of slow, fast)");
  EXPECT_EQ(failure_of_text(thrown + "ask: {a: center(ball).y @ 2 s @ slwo}\n").substr(0, 78),
            "test.yaml:10:33: error: there is no instant, stage or situation '2 s @ slwo' (");
  EXPECT_EQ(failure_of_text(thrown + "ask: {a: center(ball).y @ 2 s @ 3 s}\n"),
            "test.yaml:10:31: error: two times stand after each other (one instant is meant: x @ 2 s, x @ 2 s @ "
            "situation)");
}

}  // namespace times_in_situations_test
}  // namespace
}  // namespace poinsot::problem
