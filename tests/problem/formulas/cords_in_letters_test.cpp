// Cords over wheels in letters: what they carry and how what hangs on them starts.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/answers/solve_statement.h"
#include "problem/formulas/formula_answers.h"

namespace poinsot::problem {
namespace cords_in_letters_test {

// A load on a movable pulley between a post and a fixed pulley, which a cord joins to a sled. As far as h and r go the
// strands hang straight down; where h is less than 3/2 r the cord would pass the fixed pulley on its other side.
std::string sled(const std::string& table, const std::string& assumed) {
  return "title: movable pulley\nplane: [x, y]\nletters: {m: kg, M: kg, mu: 1, r: m, h: m}\n" + assumed +
         "points: {A: [0, 0], O: [2*h, -r], P: '[2*h + 3*r/2, -h]', E: '[2*h + 2*r, 0]'}\n"
         "bodies: {sled: {particle: A, mass: m}, load: {particle: P, mass: M}}\n"
         "joints: {lift: {prismatic: y, at: P, to: load}}\n"
         "contacts: {table: {of: sled, at: A, normal: y" +
         table +
         "}}\n"
         "cords:\n  rope: {from: ground, at: E, over: [{load: {at: P, radius: r/2, smooth: true}}, {ground: {at: O, "
         "radius: r}}], to: sled, end: A}\n"
         "gravity: -y\ninstants: {now: rest}\nask: {a: acceleration(sled).x, T: tension(rope)}\n";
}

constexpr double g = 9.80665, m = 2, M = 3, mu = 0.1;

// Of a formula that people read, at some letters.
double short_value(const Value<Formula>& formula) {
  EXPECT_LT(text(formula.number).size(), 50U);
  return value_at(formula.number, {{"m", m}, {"M", M}, {"mu", mu}, {"r", 0.2}, {"h", 1}});
}

bool is_told(const Solution& solution, const std::string& condition) {
  return std::ranges::find(solution.assumptions, condition) != solution.assumptions.end();
}

TEST(CordsInLetters, hang_straight_down_between_wheels) {
  const SolvedStatement solved = solve_statement(read_statement(sled("", "assume: [h > 2*r]\n"), "movable.yaml"), {});
  ASSERT_EQ(solved.solutions.size(), 1U);
  const auto& asks = solved.solutions[0].asks;
  ASSERT_TRUE(asks[0].formula && asks[1].formula) << asks[0].no_formula;
  EXPECT_NEAR(short_value(*asks[0].formula), 2 * M * g / (M + 4 * m), 1e-12);
  EXPECT_NEAR(short_value(*asks[1].formula), 2 * M * m * g / (M + 4 * m), 1e-12);
}

TEST(CordsInLetters, hang_straight_down_where_the_sled_is_rough) {
  const SolvedStatement solved =
      solve_statement(read_statement(sled(", friction: mu", "assume: [h > 2*r]\n"), "movable.yaml"), {});
  ASSERT_EQ(solved.solutions.size(), 2U);
  for (const Solution& solution : solved.solutions)
    for (const SolvedAsk& ask : solution.asks) ASSERT_TRUE(ask.formula) << ask.no_formula;
  EXPECT_NEAR(short_value(*solved.solutions[0].asks[1].formula), M * g / 2, 1e-12);
  EXPECT_TRUE(is_told(solved.solutions[0], "m*mu - M/2 > 0"));
  EXPECT_NEAR(short_value(*solved.solutions[1].asks[0].formula), 2 * g * (M - 2 * m * mu) / (M + 4 * m), 1e-12);
  EXPECT_NEAR(short_value(*solved.solutions[1].asks[1].formula), g * M * m * (mu + 2) / (M + 4 * m), 1e-12);
}

// Without the assumption both ways of the cord are told, each where it runs so.
TEST(CordsInLetters, run_on_the_side_that_is_told) {
  const SolvedStatement solved = solve_statement(read_statement(sled("", ""), "movable.yaml"), {});
  ASSERT_EQ(solved.solutions.size(), 1U);
  const SolvedAsk& T = solved.solutions[0].asks[1];
  ASSERT_EQ(T.regimes.size(), 2U) << T.no_formula;
  const auto straight = std::ranges::find_if(T.regimes, [](const RegimeFormula& one) {
    return std::ranges::any_of(one.where, [](const std::string& words) { return words == "2*h - 3*r > 0"; });
  });
  ASSERT_NE(straight, T.regimes.end()) << ::testing::PrintToString(T.regimes.front().where);
  EXPECT_NEAR(short_value(straight->formula), 2 * M * m * g / (M + 4 * m), 1e-12);
}

}  // namespace cords_in_letters_test
}  // namespace poinsot::problem
