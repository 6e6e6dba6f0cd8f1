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
