// Extremes of motions that have an end, come to rest, fly away or never repeat.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace endless_extremes_test {

constexpr double degree = std::numbers::pi / 180;
constexpr double g_ = 9.80665;

bool notes(const SolvedText& solved, const std::string& begin) {
  return std::ranges::any_of(solved.notes(), [&](const std::string& note) { return note.starts_with(begin); });
}

TEST(EndlessExtremes, ADampedSwingIsLargestAtItsStart) {
  const SolvedText solved(
      "title: t\ngiven: {L: 0.9 m, g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
      "bodies: {bob: {particle: P, mass: 2 kg}}\n"
      "joints: {pin: {revolute: z, at: O, to: bob, angle: th, damping: 0.1 N*m*s}}\ngravity: -y\n"
      "instants: {start: {th: 40 deg, th': 0}}\nask: {most: max(th), least: min(th), T: period(th)}\n");
  EXPECT_NEAR(solved.number("most"), 40 * degree, 1e-12);
  // The end of the first swing, where the rate vanishes, by an integrator of its own.
  const auto slopes = [](const Numbers<2>& y) {
    return Numbers<2>{y[1], -9.81 / 0.9 * std::sin(y[0]) - 0.1 / (2 * 0.9 * 0.9) * y[1]};
  };
  double before = 0.5, after = 1.5;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (before + after);
    (integrated<2>({40 * degree, 0}, middle, 4000, slopes)[1] < 0 ? before : after) = middle;
  }
  EXPECT_NEAR(solved.number("least"), integrated<2>({40 * degree, 0}, before, 4000, slopes)[0], 1e-9);
  EXPECT_EQ(solved.reason("T"), "'th' does not repeat: it has no period");
  EXPECT_TRUE(notes(solved, "max(th) was told from "));
}

// Friction brings a block on a spring to rest after turning points that come nearer by 2 mu m g/k each, and a block
// that slides without a spring where it has lost its energy: there, at the end that it reaches, it is farthest.
TEST(EndlessExtremes, FrictionBringsToRest) {
  const auto block = [](const std::string& start, const std::string& springs) {
    return SolvedText(
        "title: t\ngiven: {m: 2 kg, mu: 0.2}\npoints: {G: [0.19 m, 0, 0], O: [-1 m, 0, 0]}\n"
        "bodies: {block: {particle: G, mass: m}}\ncontacts: {table: {of: block, at: G, normal: y, friction: mu}}\n" +
        springs + "gravity: -y\ninstants: {start: {velocity(block): [" + start +
        ", 0, 0], angular_velocity(block): [0, 0, 0]}}\nask: {left: min(center(block).x), right: max(center(block).x), "
        "v: max(norm(velocity(block))), "
        "T: period(center(block).x)}\n");
  };
  const SolvedText swings =
      block("0 m/s", "springs: {coil: {at: O, to: block, end: G, stiffness: 200 N/m, free_length: 1 m}}\n");
  const double by = 0.2 * 2 * g_ / 200;
  EXPECT_NEAR(swings.number("left"), -(0.19 - 2 * by), 1e-9);
  EXPECT_NEAR(swings.number("right"), 0.19, 1e-12);
  EXPECT_NEAR(swings.number("v"), (0.19 - by) * 10, 1e-8);
  EXPECT_EQ(swings.reason("T"), "'center(block).x' does not repeat: it has no period");
  const SolvedText slides = block("3 m/s", "");
  EXPECT_NEAR(slides.number("right"), 0.19 + 9 / (2 * 0.2 * g_), 1e-9);
  EXPECT_NEAR(slides.number("left"), 0.19, 1e-12);
}

// A pendulum beside it goes on, so that nothing rests; and what is turned off later does not rest now.
TEST(EndlessExtremes, WhatMovesOnIsNotAtRest) {
  const SolvedText solved(
      "title: t\npoints: {G: [0, 0, 0], P: [1 m, 0, 0], B: [1 m, -0.7 m, 0]}\n"
      "bodies: {block: {particle: G, mass: 2 kg}, bob: {particle: B, mass: 1 kg}}\n"
      "joints: {pin: {revolute: z, at: P, to: bob, angle: a}}\n"
      "contacts: {table: {of: block, at: G, normal: y, friction: 0.2}}\ngravity: -y\n"
      "instants: {start: {velocity(block): [3 m/s, 0, 0], a: 0.5 rad, a': 0}}\n"
      "ask: {swing: max(a), T: period(a), right: max(center(block).x)}\n");
  EXPECT_NEAR(solved.number("swing"), 0.5, 1e-9);
  EXPECT_GT(solved.number("T"), 2 * std::numbers::pi * std::sqrt(0.7 / g_));
  EXPECT_NE(solved.ask("right").state, AskState::found);
}

TEST(EndlessExtremes, AFlightIsHighestOnce) {
  const SolvedText solved(
      "title: t\ngiven: {g: 9.81 m/s^2}\npoints: {O: [0, 0, 0]}\nbodies: {b: {sphere: {center: O, radius: 1 mm}, mass: "
      "any}}\ngravity: -y\n"
      "instants: {start: {angular_velocity(b): [0, 0, 0], velocity(b): [3 m/s, 4 m/s, 0]}}\n"
      "ask: {h: max(center(b).y), low: min(center(b).x)}\n");
  EXPECT_NEAR(solved.number("h"), 16 / (2 * 9.81), 1e-9);
  EXPECT_NEAR(solved.number("low"), 0, 1e-12);
  EXPECT_TRUE(notes(solved, "max(center(b).y) was told from "));
  EXPECT_TRUE(notes(solved, "min(center(b).x) was told from "));
}

TEST(EndlessExtremes, TheLowestOfAFlightWithoutEndIsNotTold) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: 1 kg}}\ngravity: -y\n"
      "instants: {start: {velocity(b): [0, 4 m/s, 0]}}\nask: {low: min(center(b).y)}\n");
  EXPECT_EQ(
      solved.reason("low"),
      "'center(b).y' goes on falling in an endless motion: it has no smallest value: say how long the motion lasts: "
      "stages: {run: {lasts: 10 s}}");
}

TEST(EndlessExtremes, TheEndOfAMotionBelongsToIt) {
  const SolvedText solved(
      "title: t\ngiven: {g: 9.81 m/s^2}\npoints: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: 1 kg}}\ngravity: -y\n"
      "stages: {flight: {lasts: 2 s}}\ninstants: {start: {velocity(b): [0, 4 m/s, 0]}}\n"
      "ask: {low: min(center(b).y), high: max(center(b).y)}\n");
  EXPECT_NEAR(solved.number("low"), 8 - 2 * 9.81, 1e-9);
  EXPECT_NEAR(solved.number("high"), 16 / (2 * 9.81), 1e-9);
  EXPECT_TRUE(notes(solved, "min(center(b).y) is at the end of the motion, at 2 s"));
  EXPECT_FALSE(notes(solved, "max(center(b).y)"));
}

TEST(EndlessExtremes, FrequenciesWithoutCommonMeasure) {
  // x1 = 0.05 m (cos 7t + cos w2 t), w2^2 = 49 + 2 (9.1): never the same again.
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0], Q: [1 m, 0, 0]}\n"
      "bodies: {a: {particle: O, mass: 1 kg}, b: {particle: Q, mass: 1 kg}}\n"
      "joints:\n"
      "  ra: {prismatic: x, at: O, to: a, displacement: x1, spring: {stiffness: 49 N/m, free_displacement: 0}}\n"
      "  rb: {prismatic: x, at: Q, to: b, displacement: x2, spring: {stiffness: 49 N/m, free_displacement: 0}}\n"
      "springs: {c: {from: a, at: O, to: b, end: Q, stiffness: 9.1 N/m, free_length: 1 m}}\ngravity: none\n"
      "instants: {start: {x1: 0.1 m, x2: 0, x1': 0, x2': 0}}\nstages: {run: {lasts: 40 s}}\nask: {M: min(x1)}\n");
  double least = 0;
  for (double t = 0; t < 40; t += 1e-5)
    least = std::min(least, 0.05 * (std::cos(7 * t) + std::cos(std::sqrt(49 + 18.2) * t)));
  EXPECT_NEAR(solved.number("M"), least, 1e-8);
}

// A speed has a corner where it comes to zero: deeper than the samples beside it tell.
TEST(EndlessExtremes, CornersCountAsDeepAsTheyAre) {
  const std::string cart =
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: 1 kg}}\n"
      "joints: {r: {prismatic: x, at: O, to: b, displacement: x1, spring: {stiffness: 49 N/m, free_displacement: 0}}}\n"
      "gravity: none\ninstants: {start: {x1: 0.1 m, x1': 0.2 m/s}}\n";
  const double speed = std::hypot(0.2, 0.7);
  const SolvedText endless(cart + "ask: {most: max(norm(velocity(b))), least: min(norm(velocity(b)))}\n");
  EXPECT_NEAR(endless.number("most"), speed, 1e-9);
  EXPECT_NEAR(endless.number("least"), 0, 1e-9);
  // |x - 0.01 sin(3t)| and its like: every corner differs, as does how near the samples come to it.
  const SolvedText ended(cart +
                         "stages: {run: {lasts: 30 s}}\nask: {least: min(abs(x1) + 0.01 m * abs(cos(time * 1 rad/s))), "
                         "most: max(-abs(x1) - 0.01 m * abs(cos(time * 1 rad/s)))}\n");
  double least = 1;
  for (double t = 0; t < 30; t += 1e-5) {
    const double x = 0.1 * std::cos(7 * t) + 0.2 / 7 * std::sin(7 * t);
    least = std::min(least, std::abs(x) + 0.01 * std::abs(std::cos(t)));
  }
  EXPECT_NEAR(ended.number("least"), least, 2e-6);
  EXPECT_NEAR(ended.number("most"), -least, 2e-6);
}

// A gyrocompass: slow beside its spin, so that few of its periods can be followed.
TEST(EndlessExtremes, ASlowPeriodOfAFastRotor) {
  const SolvedText solved(
      "title: t\ngiven: {n: 15000 rpm, lat: 40 deg, W: 7.292115e-5 rad/s}\npoints: {O: [0, 0, 0]}\n"
      "directions: {pole: [cos(lat), 0, sin(lat)]}\nframes: {earth: {turns: pole, rate: W}}\n"
      "bodies:\n  gimbal: massless\n  rotor: {mass: 1 kg, center: O, inertia: {axis: x, axial: 0.01 kg*m^2, "
      "transverse: 0.006 kg*m^2}}\n"
      "joints:\n  vert: {revolute: z, at: O, from: earth, to: gimbal, angle: a}\n"
      "  axle: {revolute: x, at: O, from: gimbal, to: rotor, rate: n, accel: 0}\n"
      "instants: {start: {a: 10 deg, a': 0}}\ngravity: none\nask: {T: period(a), f: max(a')}\n");
  // J a'' = -I n W cos(lat) sin(a), but for (W/n)^2: a pendulum's.
  const double w = std::sqrt(0.01 / 0.006 * 15000 * std::numbers::pi / 30 * 7.292115e-5 * std::cos(40 * degree));
  EXPECT_NEAR(solved.number("T"), 4 * std::comp_ellint_1(std::sin(5 * degree)) / w, 2e-6);
  EXPECT_NEAR(solved.number("f"), 2 * w * std::sin(5 * degree), 1e-7);
}

TEST(EndlessExtremes, EulerianAnglesThatStartAtTheirPole) {
  const std::string body =
      "title: t\npoints: {O: [0, 0, 0], P: [0, 0, 1 m]}\nbodies: {b: {mass: 2 kg, center: O, inertia: {x: 1 kg*m^2, y: "
      "2 "
      "kg*m^2, z: 2.5 kg*m^2}}}\ngravity: none\nstages: {run: {lasts: 2 s}}\n";
  const SolvedText angles(body +
                          "joints: {j: {ball: O, to: b, angles: [phi: z, theta: x, psi: z]}}\n"
                          "instants: {start: {phi: 0, theta: 0, psi: 0, phi': 0, theta': 1 rad/s, psi': 3 rad/s}}\n"
                          "ask: {rate: theta' @ start, later: theta @ 0.4 s, most: max(theta)}\n");
  const SolvedText free(body +
                        "joints: {j: {ball: O, to: b}}\n"
                        "instants: {start: {angular_velocity(b): [1 rad/s, 0, 3 rad/s]}}\n"
                        "ask: {height: position(P of b).z @ 0.4 s, least: min(position(P of b).z)}\n");
  EXPECT_NEAR(angles.number("rate"), 1, 1e-12);
  EXPECT_NEAR(std::cos(angles.number("later")), free.number("height"), 1e-10);
  EXPECT_NEAR(std::cos(angles.number("most")), free.number("least"), 1e-9);
}

TEST(EndlessExtremes, MotionsOfSituations) {
  const SolvedText solved(
      "title: t\ngiven: {L: 0.9 m, g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
      "bodies: {bob: {particle: P, mass: 2 kg}}\njoints: {pin: {revolute: z, at: O, to: bob, angle: th}}\ngravity: -y\n"
      "situations:\n"
      "  small: {instants: {start: {th: 40 deg, th': 0}, soon: {first_time: th == 10 deg}}}\n"
      "  large: {instants: {start: {th: 80 deg, th': 0}}}\n"
      "ask:\n  r: (period(th) @ large)/(period(th) @ small)\n  w: th' @ small.soon\n  M: max(th') @ large\n");
  const auto full = [](double amplitude) { return std::comp_ellint_1(std::sin(amplitude * degree / 2)); };
  EXPECT_NEAR(solved.number("r"), full(80) / full(40), 1e-10);
  EXPECT_NEAR(solved.number("w"), -std::sqrt(2 * 9.81 / 0.9 * (std::cos(10 * degree) - std::cos(40 * degree))), 1e-9);
  EXPECT_NEAR(solved.number("M"), std::sqrt(2 * 9.81 / 0.9 * (1 - std::cos(80 * degree))), 1e-10);
}

// A block that holds a weight over the edge of a table by friction holds it for ever: what balanced forces leave of an
// acceleration, 1e-16 m/s^2, once took 400,000 steps to be followed for some hours and carried the weight along.
TEST(EndlessExtremes, WhatFrictionHoldsStaysWhereItIs) {
  const SolvedText solved(
      "title: t\npoints: {P: [0, 0, 0], Q: [3 m, 0, 0], W: [3 m, -1 m, 0], F: [3 m, -1.8 m, 0]}\n"
      "bodies: {block: {particle: P, mass: 2 kg}, weight: {particle: W, mass: 0.4 kg}}\n"
      "contacts: {table: {of: block, at: P, normal: y, friction: 0.25},\n"
      "  floor: {of: weight, at: W, normal: y, open: true, surface: F}}\n"
      "cords: {rope: {from: block, at: P, over: [Q], to: weight, end: W}}\ngravity: -y\n"
      "instants: {start: rest, lands: {first_time: touching(floor)}}\n"
      "ask: {x: center(block).x @ 8 s, y: center(weight).y @ 100000 s, t: time @ lands}\n");
  EXPECT_EQ(solved.number("x"), 0);
  EXPECT_EQ(solved.number("y"), -1);
  EXPECT_TRUE(solved.reason("t").starts_with("touching(floor) does not happen up to ")) << solved.reason("t");
}

// A pendulum that is let go on a cart brings the cart back to where it stood: that is its least place to all digits,
// and so zero for all letters, where the way back was told to 1e-12 m.
TEST(EndlessExtremes, WhatComesBackToItsStart) {
  const std::string cart =
      "assume: [0 < b < 90 deg]\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
      "bodies: {cart: {particle: O, mass: M}, bob: {particle: P, mass: m}}\n"
      "joints: {rail: {prismatic: x, at: O, to: cart, displacement: s}, pin: {revolute: z, at: O, from: cart, to: bob, "
      "angle: theta}}\ngravity: -y\ninstants: {start: {theta: b, theta': 0, s: 0, s': 0}}\n"
      "ask: {least: min(s), most: max(s)}\n";
  const SolvedText numbers("title: t\ngiven: {m: 14.3 kg, M: 1.97 kg, L: 1.74 m, b: 0.639 rad}\n" + cart);
  EXPECT_EQ(numbers.number("least"), 0);
  EXPECT_NEAR(numbers.number("most"), 2 * 14.3 * 1.74 * std::sin(0.639) / (14.3 + 1.97), 1e-9);
  const SolvedText letters("title: t\nletters: {m: kg, M: kg, L: m, b: rad}\n" + cart);
  EXPECT_EQ(letters.ask("least").state, AskState::found) << letters.ask("least").no_formula;
  EXPECT_EQ(letters.number("least"), 0);
}

}  // namespace endless_extremes_test
}  // namespace poinsot::problem
