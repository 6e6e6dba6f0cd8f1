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

}  // namespace narrow_events_test
}  // namespace poinsot::problem
