// What a motion does not tell, and in which words.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace motion_messages_test {

const std::string pendulum =
    "title: t\ngiven: {L: 0.9 m, g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
    "bodies: {bob: {particle: P, mass: 2 kg}}\njoints: {pin: {revolute: z, at: O, to: bob, angle: th}}\n"
    "gravity: -y\ninstants: {start: {th: 40 deg, th': 0}}\n";

TEST(MotionMessages, AnEventThatHoldsFromTheStartOn) {
  const SolvedText solved(pendulum + "stages: {run: {until: th < 60 deg}}\nask: {t: th @ run.end, now: th''}\n");
  EXPECT_EQ(solved.reason("t"),
            "what ends stage 'run' holds from its start on: turn the comparison round, or leave the stage out");
  EXPECT_NEAR(solved.number("now"), -9.81 / 0.9 * std::sin(40 * std::numbers::pi / 180), 1e-12);
  // An event that is met at the start, but has to be met again, is another matter.
  const SolvedText swing(pendulum + "stages: {run: {until: th' == 0}}\nask: {th: th @ run.end}\n");
  EXPECT_NEAR(swing.number("th"), -40 * std::numbers::pi / 180, 1e-9);
  const SolvedText down(pendulum + "stages: {run: {until: th < 30 deg}}\nask: {th: th @ run.end}\n");
  EXPECT_NEAR(down.number("th"), std::numbers::pi / 6, 1e-10);
}

// Two sides that stay equal tell no time, whatever rounding makes of them: of a bar that turns about a slanting axis
// nothing is exact.
TEST(MotionMessages, SidesThatStayEqual) {
  const std::string slanting =
      "title: t\npoints: {O: [0, 0, 0]}\ndirections: {n: [1, 2, 2], k: [0, 1, -1]}\n"
      "bodies: {bar: {rod: [O, O - 1 m * k], mass: 2 kg}}\n"
      "joints: {pin: {revolute: n, at: O, to: bar, angle: th}}\ngravity: -y\n"
      "instants: {start: {th: 10 deg, th': 0}}\n";
  const SolvedText solved(slanting +
                          "ask:\n"
                          "  first: {first_time: component(center(bar) along n) == 0 m}\n"
                          "  at_most: {first_time: distance(center(bar) to O) <= 0.5 m}\n"
                          "  less: {first_time: distance(center(bar) to O) < 0.5 m}\n"
                          "  more: {first_time: distance(center(bar) to O) > 0.5 m}\n"
                          "  times: {times: component(center(bar) along n) == 0 m, from: 0 s, to: 1 s}\n"
                          "  period: period(component(center(bar) along n))\n");
  EXPECT_EQ(solved.number("first"), 0);
  EXPECT_EQ(solved.number("at_most"), 0);
  for (const std::string name : {"less", "more"})
    EXPECT_NE(solved.reason(name).find("its two sides stay equal"), std::string::npos) << solved.reason(name);
  EXPECT_EQ(solved.reason("times"),
            "'component(center(bar) along n) == 0 m' holds all the time from 0 s to 1 s, and so at no single times");
  EXPECT_NE(solved.reason("period").find("does not change: it has no period"), std::string::npos);
}

// Nor do they end a stage, at which rounding alone would decide.
TEST(MotionMessages, SidesThatStayEqualEndNoStage) {
  for (const char* until : {"center(bob).z == 0 m", "th == th", "distance(center(bob) to O) == L"}) {
    const SolvedText solved(pendulum + "stages: {run: {until: " + until +
                            "}, then: {lasts: 1 s}}\nask: {th: th @ run.end}\n");
    EXPECT_NE(solved.reason("th").find("stay equal"), std::string::npos) << solved.reason("th");
  }
}

// A cart that rests until a load acts ceases to rest then.
TEST(MotionMessages, SidesThatPartLater) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {cart: {particle: O, mass: 2 kg}}\n"
      "joints: {rail: {prismatic: x, at: O, to: cart, displacement: u}}\nloads: {push: {force: [4 N, 0, 0], body: "
      "cart}}\n"
      "gravity: none\ninstants: {start: rest}\nstages: {still: {lasts: 30 s, loads: []}, moved: {loads: [push]}}\n"
      "ask: {t: {first_time: u > 0 m}, s: {first_time: u > 1 m}}\n");
  EXPECT_NEAR(solved.number("t"), 30, 1e-10);
  EXPECT_NEAR(solved.number("s"), 31, 1e-9);
}

TEST(MotionMessages, ATableOverWhatIsNeverReached) {
  const SolvedText solved(pendulum + "ask: {t: {table: {w: th'}, over: {th: '[20 deg, 60 deg]'}}}\n");
  EXPECT_EQ(solved.column("t", 0).size(), 1U);
  const std::string told = "t: the row th = 60 deg has no answer and is left out: 'th' does not come to 60 deg up to ";
  EXPECT_EQ(std::ranges::count_if(solved.notes(), [&](const std::string& note) { return note.starts_with(told); }), 1);
  EXPECT_NE(SolvedText(pendulum + "ask: {t: {table: {w: th'}, over: {th: '[60 deg, 70 deg]'}}}\n")
                .reason("t")
                .find("it runs from -40 to 40 deg: let the table run over what is reached"),
            std::string::npos);
}

TEST(MotionMessages, ThereIsNoTimeBeforeTheStart) {
  EXPECT_EQ(failure_of_text(pendulum + "ask: {t: th @ -1 s}\n"),
            "test.yaml:8:15: error: the motion begins at 0 s: there is no time before it (write x @ start, x @ 2 s)");
}

// What happens in time is compared as anything else: thirty is no angle, and no angle is a length.
TEST(MotionMessages, WhatIsComparedInTimeHasItsUnit) {
  EXPECT_EQ(failure_of_text(pendulum + "ask: {t: {first_time: th == 30}}\n"),
            "test.yaml:8:29: error: a number without unit meets an angle (write 30 deg or 30 rad)");
  EXPECT_NE(failure_of_text(pendulum + "ask: {t: {first_time: th < 1 m}}\n").find("length"), std::string::npos);
  EXPECT_NE(failure_of_text(pendulum + "ask: {t: {first_time: th < 0 m}}\n").find("length"), std::string::npos);
  EXPECT_NE(failure_of_text(pendulum + "stages: {run: {until: th == 30}}\nask: {t: th @ run.end}\n")
                .find("a number without unit meets an angle"),
            std::string::npos);
  EXPECT_NEAR(SolvedText(pendulum + "ask: {t: {first_time: th == 0}}\n").number("t"),
              SolvedText(pendulum + "ask: {t: {first_time: th == 0 deg}}\n").number("t"), 0);
}

TEST(MotionMessages, AUnitStandsBehindANumber) {
  const std::string message = failure_of_text(pendulum + "ask: {t: \"2*pi rad\"}\n");
  EXPECT_EQ(message, "test.yaml:8:16: error: 'rad' is a unit, which stands behind a number (write 'pi * 1 rad')");
}

TEST(MotionMessages, PeriodsOfManyRises) {
  // Two masses on springs: 0.05 m (cos 7t + cos 8t).
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0], Q: [1 m, 0, 0]}\n"
      "bodies: {a: {particle: O, mass: 1 kg}, b: {particle: Q, mass: 1 kg}}\n"
      "joints:\n"
      "  ra: {prismatic: x, at: O, to: a, displacement: x1, spring: {stiffness: 49 N/m, free_displacement: 0}}\n"
      "  rb: {prismatic: x, at: Q, to: b, displacement: x2, spring: {stiffness: 49 N/m, free_displacement: 0}}\n"
      "springs: {c: {from: a, at: O, to: b, end: Q, stiffness: 7.5 N/m, free_length: 1 m}}\ngravity: none\n"
      "instants: {start: {x1: 0.1 m, x2: 0, x1': 0, x2': 0}}\nask: {T: period(x1), M: max(x1)}\n");
  EXPECT_NEAR(solved.number("T"), 2 * std::numbers::pi, 1e-6);
  EXPECT_NEAR(solved.number("M"), 0.1, 1e-9);
}

TEST(MotionMessages, ARollingContactThatWouldSlip) {
  // A light hoop with a heavy bead rolls; where nothing presses it any more, the bead still needs the friction.
  const std::string hoop =
      "title: t\ngiven: {r: 0.5 m, g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], C: [0, r, 0], B: [0, 2*r, 0]}\n"
      "bodies: {hoop: {parts: {rim: {ring: {center: C, normal: z, radius: r}, mass: 0.2 kg}, "
      "bead: {particle: B, mass: 3 kg}}}}\n"
      "contacts: {floor: {of: hoop, at: O, normal: y, no_slip: true, carries: [push, x]}}\n"
      "joints: {plane: {planar: z, at: C, to: hoop, freedoms: {turn: {angle: q}}}}\ngravity: -y\n"
      "instants: {start: {q': -4 rad/s}}\n"
      "ask: {q: q' @ 0.15 s, N: force(floor on hoop).y @ 0.15 s, late: q @ 0.2 s, again: q @ 0.3 s, "
      "loose: {first_time: force(floor on hoop).y == 0}, "
      "turned: {first_time: q == -3 rad}}\n";
  const SolvedText solved(hoop);
  // Rolling: with I about the point that touches, q'' follows from energy.
  const auto y = integrated(Numbers<2>{0, -4}, 0.15, 4000, [](const Numbers<2>& s) {
    const double r = 0.5, m = 0.2, M = 3, c = std::cos(s[0]), n = std::sin(s[0]);
    const double inertia = 2 * m * r * r + 2 * M * r * r * (1 + c);
    return Numbers<2>{s[1], (M * r * r * n * s[1] * s[1] + M * 9.81 * r * n) / inertia};
  });
  EXPECT_NEAR(solved.number("q"), y[1], 1e-9);
  EXPECT_GT(solved.number("N"), 0);
  const std::string reason = solved.reason("late");
  EXPECT_TRUE(
      reason.starts_with("the contact 'floor' presses no more at 0.179521 s, where the motion still needs its "
                         "friction: it slips before, and how is not stated"))
      << reason;
  EXPECT_EQ(solved.reason("again"), reason);
  EXPECT_EQ(solved.reason("turned"), reason);
  EXPECT_NEAR(solved.number("loose"), 0.179521, 1e-6);
}

TEST(MotionMessages, AnErrorThatIsSeenInTheDigitsIsTold) {
  const std::string stated =
      "title: t\ngiven: {t: 9 s}\npoints: {O: [0, 0, 0], A: [0, -1 m, 0], B: [0, -2 m, 0]}\n"
      "bodies: {a: {rod: [O, A], mass: 1 kg}, b: {rod: [A, B], mass: 1 kg}}\n"
      "joints: {p: {revolute: z, at: O, to: a, angle: u}, q: {revolute: z, at: A, from: a, to: b, angle: w}}\n"
      "gravity: -y\ninstants: {start: {u: 120 deg, u': 0, w: 40 deg, w': 0}}\nask: {e: u @ t}\n";
  const auto told = [](const SolvedText& solved) {
    std::string words;
    for (const std::string& note : solved.notes())
      if (note.starts_with("the motion is sensitive: its coordinates may be off by ")) words = note;
    return words;
  };
  EXPECT_EQ(told(SolvedText(stated, {{"t", "2 s"}})), "");
  // Between what is seen and what is refused: in the unit of the file.
  const SolvedText sensitive(stated);
  EXPECT_GT(sensitive.number("e"), -2);
  EXPECT_TRUE(told(sensitive).ends_with(" deg")) << told(sensitive);
}

TEST(MotionMessages, SpringsInSeriesAreOne) {
  const std::string failure = failure_of_text(
      "plane: [x, y]\npoints: {O: [0, 0], N: [0, -1 m], B: [0, -2 m]}\n"
      "bodies: {node: {particle: N, mass: 0 kg}, bob: {particle: B, mass: 2 kg}}\n"
      "springs: {one: {from: ground, at: O, to: node, end: N, stiffness: 100 N/m, free_length: 1 m}, "
      "two: {from: node, at: N, to: bob, end: B, stiffness: 300 N/m, free_length: 1 m}}\n"
      "gravity: -y\ninstants: {now: rest}\nask: {y: position(bob).y @ 0.3 s}\n");
  EXPECT_NE(failure.find("springs in series through a massless point are one"), std::string::npos) << failure;
}

}  // namespace motion_messages_test
}  // namespace poinsot::problem
