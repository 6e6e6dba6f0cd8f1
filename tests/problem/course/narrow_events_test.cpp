// Events that last a small part of a swing, of x = A cos(w t).
#include <fmt/format.h>

#include <numbers>
#include <random>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace narrow_events_test {

class Oscillator {
 public:
  explicit Oscillator(std::mt19937_64& random) {
    std::uniform_real_distribution<double> part(0, 1);
    stiffness = 1 + 50 * part(random);
    amplitude = 0.1 + part(random);
    damping = part(random) < 0.5 ? 0 : 1e-12;  // so that it is integrated
  }
  SolvedText solved(const std::string& asks) const {
    return SolvedText(
        fmt::format("title: t\npoints: {{O: [0, 0, 0]}}\nbodies: {{p: {{particle: O, mass: 2 kg}}}}\n"
                    "joints: {{s: {{prismatic: x, at: O, to: p, displacement: u, spring: {{stiffness: {:.17g} N/m}}, "
                    "damping: {:.17g} "
                    "N*s/m}}}}\ngravity: none\ninstants: {{start: {{u: {:.17g} m, u': 0}}}}\nask: {{{}}}\n",
                    stiffness, damping, amplitude, asks));
  }
  double w() const { return std::sqrt(stiffness / 2); }
  double period() const { return 2 * std::numbers::pi / w(); }

  double stiffness, amplitude, damping;
};

TEST(NarrowEvents, ASwingThatJustComesBackOverItsMark) {
  std::mt19937_64 random(71);
  std::uniform_real_distribution<double> power(1, 7);
  for (int trial = 0; trial < 40; ++trial) {
    const Oscillator o(random);
    const double short_of = std::pow(10, -power(random)), half = std::acos(1 - short_of) / o.w();
    const SolvedText solved = o.solved(
        fmt::format("a: {{first_time: 'u > {0:.17g} m', from: {1:.17g} s}}, b: {{times: 'u == {0:.17g} m', from: "
                    "{1:.17g} s, to: {2:.17g} s}}",
                    o.amplitude * (1 - short_of), o.period() / 5, 2.5 * o.period()));
    // The angle at the mark is as uncertain as the mark over its sine.
    const double error = 1e-10 / std::sqrt(short_of) * o.period();
    EXPECT_NEAR(solved.number("a"), o.period() - half, error) << short_of;
    const auto& times = solved.found("b").value.items;
    ASSERT_EQ(times.size(), 4U) << short_of;
    const double expected[] = {o.period() - half, o.period() + half, 2 * o.period() - half, 2 * o.period() + half};
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(times[k].number, expected[k], error) << short_of;
  }
}

TEST(NarrowEvents, AQuantityWithACornerComesNearZero) {
  std::mt19937_64 random(72);
  std::uniform_real_distribution<double> power(1, 7);
  for (int trial = 0; trial < 40; ++trial) {
    const Oscillator o(random);
    const double part = std::pow(10, -power(random));
    const SolvedText solved = o.solved(fmt::format("a: {{first_time: 'abs(u) < {:.17g} m'}}", part * o.amplitude));
    EXPECT_NEAR(solved.number("a"), std::acos(part) / o.w(), 1e-9 * o.period()) << part;
  }
}

// A notch in a number that is flat beside it: the smaller of what changes fast for a moment and what hardly does. The
// particle goes past x = X at a constant speed, and rises slowly from its own height.
TEST(NarrowEvents, TheSmallerOfTwoNumbersDipsForAMoment) {
  std::mt19937_64 random(73);
  std::uniform_real_distribution<double> part(0, 1), power(2, 7);
  for (int trial = 0; trial < 12; ++trial) {
    const double X = 0.3 + 2 * part(random), v = 0.4 + 3 * part(random), near = std::pow(10, -power(random));
    const std::string condition = fmt::format("min([abs(center(p).x - {:.17g} m), center(p).y]) < {:.17g} m", X, near);
    const auto solved = [&](const std::string& stages, const std::string& asks) {
      return SolvedText(
          fmt::format("title: t\npoints: {{A: [0, 0.02 m, 0]}}\nbodies: {{p: {{particle: A, mass: 2 "
                      "kg}}}}\ngravity: none\ninstants: {{start: {{velocity(p): [{:.17g} m/s, 0.001 "
                      "m/s, 0]}}}}\nstages: {{{}}}\nask: {{{}}}\n",
                      v, stages, asks));
    };
    const double there = (X - near) / v;
    EXPECT_NEAR(solved("run: {lasts: 8 s}", "a: {first_time: '" + condition + "'}").number("a"), there, 1e-9) << near;
    EXPECT_NEAR(
        solved("run: {until: '" + condition + "'}, after: {lasts: 1 s}", "a: center(p).x @ run.end").number("a"),
        X - near, 1e-9)
        << near;
  }
}

// A stone that is thrown up slowly and then falls for long, and one that falls for a moment only after its top. By
// hand: the top is v^2/(2 g) high, and after 2 v/g it is below where it was thrown.
TEST(NarrowEvents, AStoneThatTurnsJustAfterItsStartOrJustBeforeItsEnd) {
  std::mt19937_64 random(74);
  std::uniform_real_distribution<double> power(0, 5), part(0, 1);
  constexpr double g = 9.80665;
  const auto thrown = [](double v, double lasts, const std::string& asks) {
    return SolvedText(
        fmt::format("title: t\npoints: {{O: [0, 0, 0]}}\nbodies: {{p: {{particle: O, mass: 2 kg}}}}\ngravity: -y\n"
                    "instants: {{run.start: {{velocity(p): [0.1 m/s, {:.17g} m/s, 0]}}}}\nstages: {{run: {{lasts: "
                    "{:.17g} s}}}}\nask: {{{}}}\n",
                    v, lasts, asks));
  };
  for (int trial = 0; trial < 12; ++trial) {
    const double v = std::pow(10, -power(random)), lasts = 1 + part(random), height = v * v / (2 * g);
    const SolvedText early = thrown(v, lasts, "h: max(center(p).y), t: {first_time: center(p).y < 0 m}");
    EXPECT_NEAR(early.number("h"), height, 1e-9 * height) << v;
    EXPECT_NEAR(early.number("t"), 2 * v / g, 1e-9 * v / g) << v;
    const double fast = g * lasts - v, top = fast * fast / (2 * g);
    EXPECT_NEAR(thrown(fast, lasts, "h: max(center(p).y)").number("h"), top, 1e-12 * top) << v;
  }
}

// What is only approached is never reached: the terminal speed of a fall in drag, the place of rest of a mass that is
// overdamped, the way of a boat that coasts. What rounding makes of them has signs of its own.
TEST(NarrowEvents, WhatIsOnlyApproachedIsNotReached) {
  const SolvedText falls(
      "title: t\ngiven: {m: 2 kg, c: 3 N*s/m}\npoints: {O: [0, 0, 0]}\nbodies: {p: {particle: O, mass: m}}\n"
      "joints: {s: {prismatic: -y, at: O, to: p, displacement: u, damping: c}}\ngravity: -y\n"
      "instants: {start: {u: 0, u': 0}}\nask: {end: {first_time: \"u' > m*g/c\"}, half: {first_time: \"u' > "
      "m*g/c/2\"}}\n");
  EXPECT_NEAR(falls.number("half"), 2.0 / 3 * std::numbers::ln2, 1e-9);
  EXPECT_NE(falls.reason("end").find("does not happen"), std::string::npos) << falls.reason("end");

  const SolvedText returns(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {p: {particle: O, mass: 1 kg}}\n"
      "joints: {s: {prismatic: x, at: O, to: p, displacement: u, spring: {stiffness: 1000 N/m}, damping: 80 N*s/m}}\n"
      "gravity: none\ninstants: {start: {u: 0.1 m, u': 0}}\nask: {zero: {first_time: u == 0 m}, back: {first_time: "
      "\"u' > 0 "
      "m/s\"}, least: min(u), most: max(u)}\n");
  for (const char* name : {"zero", "back"})
    EXPECT_NE(returns.reason(name).find("does not happen"), std::string::npos) << returns.reason(name);
  EXPECT_EQ(returns.number("least"), 0);
  EXPECT_EQ(returns.number("most"), 0.1);

  // With less damping it does go through, and the first trough is lower than all that follow.
  const SolvedText swings(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {p: {particle: O, mass: 1 kg}}\n"
      "joints: {s: {prismatic: x, at: O, to: p, displacement: u, spring: {stiffness: 1000 N/m}, damping: 5 N*s/m}}\n"
      "gravity: none\ninstants: {start: {u: 0.1 m, u': 0}}\nask: {zero: {first_time: u == 0 m}, least: min(u)}\n");
  const double decay = 2.5, w = std::sqrt(1000 - decay * decay);
  EXPECT_NEAR(swings.number("zero"), (std::numbers::pi - std::atan(w / decay)) / w, 1e-9);
  EXPECT_NEAR(swings.number("least"), -0.1 * std::exp(-decay * std::numbers::pi / w), 1e-9);
}

// A particle that slides out on a rough floor: how it may turn is open, and nothing depends on that.
TEST(NarrowEvents, AParticleThatStopsHasGoneFarthest) {
  const SolvedText slides(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: 1 kg}}\n"
      "contacts: {floor: {of: b, at: O, normal: y, friction: 0.5}}\ngravity: -y\n"
      "instants: {start: {velocity(b): [6 m/s, 0, 0]}}\nask: {far: max(center(b).x), low: min(velocity(b).x)}\n");
  EXPECT_NEAR(slides.number("far"), 36 / 9.80665, 1e-9);
  EXPECT_NEAR(slides.number("low"), 0, 1e-9);
}

// A push that lasts a millionth of the motion: no step is so short, and its impulse is told all the same.
TEST(NarrowEvents, APushThatLastsForAMoment) {
  for (const double rate : {1e5, 1e7, 1e8}) {
    const SolvedText solved(fmt::format(
        "title: t\npoints: {{O: [0, 0, 0]}}\nbodies: {{p: {{particle: O, mass: 1 kg}}}}\njoints: {{r: {{prismatic: x, "
        "at: O, to: p, displacement: s}}}}\nloads: {{push: {{force: ['max([0 N, 100 N - abs(time - 2.3 s)*({:.17g} "
        "N/s)])', 0 N, 0 N], body: p}}}}\ngravity: none\ninstants: {{start: rest}}\nask: {{v: \"s' @ 4 s\"}}\n",
        rate));
    EXPECT_NEAR(solved.number("v"), 1e4 / rate, 1e-6 * 1e4 / rate) << rate;
  }
}

// In flight, past two places on its way: the first of them that it comes near to.
TEST(NarrowEvents, TheNearerOfTwoPlacesOnTheWay) {
  std::mt19937_64 random(74);
  std::uniform_real_distribution<double> part(0, 1), power(2, 6);
  for (int trial = 0; trial < 8; ++trial) {
    const double u = 1 + 3 * part(random), v = 2 + 3 * part(random), near = std::pow(10, -power(random));
    const auto at = [&](double t) { return std::pair(u * t, v * t - 5 * t * t); };
    const double first = 0.2 + 0.5 * part(random), last = first + 0.3;
    const auto [x, y] = at(first);
    const auto [p, q] = at(last);
    const std::string text = fmt::format(
        "title: t\npoints: {{A: [0, 0, 0]}}\nbodies: {{p: {{particle: A, mass: 2 kg}}}}\ngravity: [0, -10 m/s^2, "
        "0]\ninstants: {{start: {{velocity(p): [{:.17g} m/s, {:.17g} m/s, 0]}}}}\nstages: {{run: {{lasts: 2 s}}}}\n"
        "ask: {{a: {{first_time: 'min([norm(center(p) - [{:.17g} m, {:.17g} m, 0]), norm(center(p) - [{:.17g} m, "
        "{:.17g} m, 0])]) < {:.17g} m'}}}}\n",
        u, v, x, y, p, q, near);
    // It comes near as it goes with its speed there, but for a part of that way that is as small.
    const double speed = std::hypot(u, v - 10 * first);
    EXPECT_NEAR(SolvedText(text).number("a"), first - near / speed, 10 * near * near + 1e-9) << text;
  }
}

// What is zero but for rounding has no first time, and no failure of the program either.
TEST(NarrowEvents, ANumberThatIsRoundingIsNoBracket) {
  const SolvedText solved(
      "title: t\ngiven: {W: 3.542 lb, s: 6.563 in}\npoints: {A: ['-2*s', 0, 0], B: [2*s, 0, 0]}\n"
      "bodies: {sheet: {weight: W, parts: {triangle: {polygon: [[s, 0, 0], B, [s, 0, '-s']]}}}}\n"
      "joints: {bearings: {revolute: x, at: A, to: sheet, angle: turn, supports: {A: [y, z], B: [y, z]}},"
      " like_it: {revolute: x, at: A, to: sheet}}\ninstants: {start: rest}\n"
      "ask: {b: {first_time: reaction(A).z == 0, axes: sheet, unit: s}}\n");
  EXPECT_FALSE(solved.reason("b").empty());
}

// A speck that falls from a nanometer, in a file without another length: sqrt(2 h/g), and three times that until it
// rests.
TEST(NarrowEvents, ASpeckLandsToAllItsDigits) {
  for (const double h : {1e-9, 1e-7, 1e-3}) {
    const SolvedText solved(
        fmt::format("title: t\ngiven: {{h: {} m}}\npoints: {{O: [0, 0, 0], H: [0, h, 0]}}\n"
                    "bodies: {{b: {{particle: H, mass: 1e-12 kg}}}}\n"
                    "contacts: {{floor: {{of: b, at: H, surface: O, normal: y, open: true, restitution: 0.5}}}}\n"
                    "gravity: -y\ninstants: {{start: rest, lands: {{first_time: touching(floor)}}}}\n"
                    "ask: {{t: time @ lands, ends: end_of_bouncing(floor), E: kinetic_energy(b) @ lands}}\n",
                    h));
    const double falls = std::sqrt(2 * h / 9.80665);
    // The last digits of the natural length, a meter, are no gap.
    const double known = std::max(1e-8, 3e-16 / h);
    EXPECT_NEAR(solved.number("t") / falls, 1, known) << h;
    EXPECT_NEAR(solved.number("ends") / (3 * falls), 1, 1e-6) << h;
    EXPECT_NEAR(solved.number("E") / (1e-12 * 9.80665 * h), 1, known) << h;
  }
}

}  // namespace narrow_events_test
}  // namespace poinsot::problem
