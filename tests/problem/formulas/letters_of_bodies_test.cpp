// Formulas in letters that are the moments of inertia of bodies, which far from each other are none of any body; what
// is assumed of letters; what does not happen at some of their values; ends of a letter beside unknowns.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace letters_of_bodies_test {

Solution solved(const std::string& text) {
  return solve_statement(read_statement(text, "test.yaml"), {}).solutions.at(0);
}

constexpr const char* moments = R"(
letters: {I: kg*m^2, J: kg*m^2, K: kg*m^2}
points: {G: [0, 0, 0]}
bodies: {b: {mass: 1 kg, center: G, inertia: {x: I, y: J, z: K}}}
ask: {p: principal_moments(b about G)}
)";

// The order of the moments is one of six, and each is told with its conditions.
TEST(LettersOfBodies, principal_moments_say_for_which_order_they_are_told) {
  const Solution solution = solved(moments);
  ASSERT_TRUE(solution.asks[0].formula.has_value());
  EXPECT_GE(solution.asks[0].regimes.size(), 5U);
  for (const RegimeFormula& one : solution.asks[0].regimes) EXPECT_GE(one.where.size(), 2U);
}

TEST(LettersOfBodies, principal_moments_are_told_as_is_assumed) {
  const Solution solution = solved(std::string(moments) + "assume: [I < J, J < K]\n");
  ASSERT_TRUE(solution.asks[0].formula.has_value());
  const std::vector<Value<poinsot::Formula>>& items = solution.asks[0].formula->items;
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[0].number, poinsot::Formula::letter("I", poinsot::Sign::positive));
  EXPECT_EQ(items[2].number, poinsot::Formula::letter("K", poinsot::Sign::positive));
}

TEST(LettersOfBodies, times_at_which_nothing_happens_hang_on_the_letters) {
  const Solution solution = solved(R"(
letters: {v: m/s, h: m}
points: {O: [0, 0, 0]}
bodies: {b: {particle: O, mass: 1 kg}}
gravity: -y
instants: {start: {velocity(b): [0, v, 0]}}
ask: {t: {times: center(b).y == 1000*h, from: 0 s, to: 9 s}, u: {first_time: center(b).y == 1000*h}}
)");
  EXPECT_EQ(solution.asks[0].state, AskState::needs_letters);
  EXPECT_EQ(solution.asks[0].letters.size(), 2U);
  EXPECT_EQ(solution.asks[1].state, AskState::undetermined);
  EXPECT_TRUE(solution.asks[1].reason.starts_with("at the values that were tried for the letters "));
}

// w^2 (a + L sin 45 deg) = g
TEST(LettersOfBodies, an_end_of_the_only_letter_is_found_beside_unknowns) {
  const Solution solution = solved(R"(
given: {L: 0.5 m, a: 0.2 m, g: 9.81 m/s^2}
letters: {w: rad/s}
find: {b: deg}
where: [0 deg < b < 90 deg]
points: {O: [0, 0, 0], A: [a, 0, 0], P: [a, 0, -L]}
bodies: {arm: massless, bob: {particle: P, mass: 1 kg}}
joints: {s: {revolute: z, at: O, to: arm, rate: w, accel: 0}, p: {revolute: -y, at: A, from: arm, to: bob, angle: b}}
steady: {frame: arm}
gravity: -z
ask: {end: {smallest: w, while: b >= 45 deg}}
)");
  ASSERT_EQ(solution.asks[0].state, AskState::found) << solution.asks[0].reason << solution.asks[0].no_formula;
  EXPECT_NEAR(solution.asks[0].value.number, std::sqrt(9.81 / (0.2 + 0.5 * std::sqrt(0.5))), 1e-6);
}

}  // namespace letters_of_bodies_test
}  // namespace poinsot::problem
