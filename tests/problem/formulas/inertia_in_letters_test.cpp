// Principal axes and Poinsot's construction in letters, in whatever order the moments are.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "problem/answers/solve_statement.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_conditions.h"

namespace poinsot::problem {
namespace inertia_in_letters_test {

// A brick whose sides are letters: its axes come in the order of its moments, and which of them are stable hangs on
// none but on that the moments differ.
TEST(InertiaInLetters, poinsots_construction_of_a_brick) {
  const Statement statement = read_statement(
      "letters: {m: kg, a: m, b: m, c: m, w: {signed: rad/s}, u: rad/s}\npoints: {G: [0, 0, 0]}\n"
      "bodies: {brick: {box: {center: G, sides: [a*x, b*y, c*z]}, mass: m}}\n"
      "instants: {now: {angular_velocity(brick): [0, w, u]}}\ngravity: none\n"
      "ask: {st: axis_stability(brick), el: poinsot_ellipsoid(brick), ax: principal_axes(brick about G)}\n",
      "brick.yaml");
  const Solution letters = solve_statement(statement, {}).solutions.at(0);
  ASSERT_EQ(letters.asks[0].state, AskState::found) << letters.asks[0].no_formula;
  EXPECT_EQ(letters.asks[0].value.items.at(1).text, "unstable");
  for (const char* words : {"a - b != 0 for 'st'", "a - c != 0 for 'st'", "b - c != 0 for 'st'"})
    EXPECT_EQ(std::ranges::count(letters.assumptions, words), 1) << words;
  std::vector<double> sides{0.5, 1, 2};
  do {
    const LetterValues at{{"m", 12}, {"a", sides[0]}, {"b", sides[1]}, {"c", sides[2]}, {"w", -3}, {"u", 2}};
    std::vector<std::pair<std::string, std::string>> sets{{"m", "12 kg"}, {"w", "-3 rad/s"}, {"u", "2 rad/s"}};
    for (const std::size_t k : {0U, 1U, 2U})
      sets.emplace_back(std::string(1, "abc"[k]), std::to_string(sides[k]) + " m");
    const Solution numbers = solve_statement(statement, sets).solutions.at(0);
    for (const std::size_t i : {1U, 2U}) {
      int told = 0;
      for (const RegimeFormula& one : letters.asks[i].regimes) {
        if (!std::ranges::all_of(one.where, [&](const std::string& words) {
              return holds_as_told(words, statement.situations.front().letters, at) != false;
            }))
          continue;
        ++told;
        EXPECT_TRUE(agrees(one.formula, numbers.asks[i].value, at, 1e-12, 0)) << i << " " << sides[0] << sides[1];
      }
      EXPECT_EQ(told, 1) << i << " " << sides[0] << sides[1];
    }
  } while (std::ranges::next_permutation(sides).found);
}

// Of two equal sides the third decides; of a disk nothing is left to decide.
TEST(InertiaInLetters, stability_of_axes_with_equal_moments) {
  const auto asked = [](const std::string& assumed) {
    return solve_statement(
               read_statement(assumed + "letters: {m: kg, a: m, c: m}\npoints: {G: [0, 0, 0], H: [9 m, 0, 0]}\n"
                                        "bodies: {brick: {box: {center: G, sides: [a*x, a*y, c*z]}, mass: m},\n"
                                        "  disk: {disk: {center: H, normal: z, radius: a}, mass: m}}\n"
                                        "instants: {now: {angular_velocity(brick): [0, 0, 1 rad/s], "
                                        "angular_velocity(disk): [0, 0, 1 rad/s]}}\n"
                                        "gravity: none\nask: {b: axis_stability(brick), d: axis_stability(disk)}\n",
                              "axes.yaml"),
               {})
        .solutions.at(0);
  };
  const auto words = [](const SolvedAsk& ask) {
    std::string all;
    for (const Value<double>& word : ask.value.items) all += word.text + " ";
    return ask.state == AskState::found ? all : "not told";
  };
  EXPECT_EQ(words(asked("").asks[0]), "not told");
  EXPECT_EQ(words(asked("").asks[1]), "neutral neutral stable ");
  EXPECT_EQ(words(asked("assume: [a > c]\n").asks[0]), "neutral neutral stable ");
  EXPECT_EQ(words(asked("assume: [a < c]\n").asks[0]), "stable neutral neutral ");
}

}  // namespace inertia_in_letters_test
}  // namespace poinsot::problem
