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

TEST(TimesInSituations, OfStatesOfContacts) {
  const SolvedText solved(
      "given: {h: 0.5 m}\npoints: {O: [0, 0, 0], C: [0, h, 0]}\nbodies: {ball: {particle: C, mass: 1 kg}}\n"
      "contacts: {floor: {of: ball, at: C, normal: y, open: true, surface: O, friction: 0.2}}\n"
      "instants: {start: {velocity(ball): [3 m/s, 0, 0]}}\n"
      "situations: {near: {gravity: [0, -10 m/s^2, 0]}, far: {gravity: [0, -1.6 m/s^2, 0]}}\n"
      "ask:\n  a: {first_time: touching(floor) @ near}\n  b: {first_time: touching(floor) @ far}\n"
      "  c: {times: sticking(floor) @ near, from: 0 s, to: 5 s}\n");
  EXPECT_NEAR(solved.number("a"), std::sqrt(1.0 / 10), 1e-9);
  EXPECT_NEAR(solved.number("b"), std::sqrt(1.0 / 1.6), 1e-9);
  const double lands = std::sqrt(1.0 / 10), slides = 3 - 0.2 * 10 * lands;
  ASSERT_EQ(solved.found("c").value.items.size(), 1U);
  EXPECT_NEAR(solved.found("c").value.items[0].number, lands + slides / 2, 1e-8);
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
