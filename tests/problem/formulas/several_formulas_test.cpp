// Answers that have other formulas at other letters, and laws that are sums.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/answers/solve_statement.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_conditions.h"
#include "problem/formulas/formula_words.h"

namespace poinsot::problem {
namespace several_formulas_test {

const char* const beam_text = R"(letters: {a: m, L: m, F: N}
points: {O: [0, 0, 0], P: [a, 0, 0], Q: [L, 0, 0]}
bodies: {beam: {rod: [O, Q], mass: 1 kg}}
joints: {s: {weld: O, to: beam, supports: {A: {at: O, force: [x, y]}, B: {at: Q, force: [y]}}}}
loads: {f: {force: [0, -F, 0], at: P, body: beam}}
gravity: none
ask: {big: max(reaction(A).y with reaction(B).y), both: reaction(A).y}
)";
const char* const cord_text = R"(letters: {m: kg, L: m, v: {signed: m/s}}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bob: {particle: A, mass: m}}
cords: {c: {at: O, to: bob, end: A}}
impulses: {k: {body: bob, value: [0, -m*v, 0]}}
instants: {before: {velocity(bob): [0, 0, 0]}}
gravity: none
ask: {J: impulse(c).y, after: velocity(bob).y}
)";
const char* const cart_text = R"(letters: {m: kg, k: N/m, d: m, s: m}
points: {O: [0, 0, 0]}
bodies: {cart: {particle: O, mass: m}}
joints: {rail: {prismatic: x, at: O, to: cart, displacement: u, spring: {stiffness: k, free_displacement: s}}}
gravity: none
instants: {start: {u: d, "u'": 0}}
ask: {top: max(u), low: min(u)}
)";

std::vector<std::string> formulas_of(const SolvedAsk& ask) {
  std::vector<std::string> all;
  for (const RegimeFormula& one : ask.regimes) {
    std::string where;
    for (const std::string& words : one.where) where += (where.empty() ? " where " : ", ") + words;
    all.push_back(text(one.formula.number) + where);
  }
  std::ranges::sort(all);
  return all;
}
using Texts = std::vector<std::string>;

// On either side of the border there is the formula of that side.
TEST(SeveralFormulas, each_side_of_a_border_has_its_formula) {
  const Solution beam = solve_statement(read_statement(beam_text, "beam.yaml"), {}).solutions.at(0);
  EXPECT_EQ(formulas_of(beam.asks[0]), (Texts{"F*(L - a)/L where L - 2*a > 0", "F*a/L where 2*a - L > 0"}));
  EXPECT_TRUE(beam.asks[1].regimes.empty());
  const Solution cord = solve_statement(read_statement(cord_text, "cord.yaml"), {}).solutions.at(0);
  EXPECT_EQ(formulas_of(cord.asks[0]), (Texts{"0 where v < 0", "m*v where v > 0"}));
  // What comes to rest by the blow is none the less an answer, not rounding.
  EXPECT_EQ(formulas_of(cord.asks[1]), (Texts{"-v where v < 0", "0 where v > 0"}));
  // The formula that stands alone is the first, with its condition among the assumptions.
  ASSERT_EQ(cord.asks[0].regimes.size(), 2U);
  EXPECT_EQ(text(cord.asks[0].formula->number), text(cord.asks[0].regimes.front().formula.number));
  EXPECT_NE(std::ranges::find(cord.assumptions, cord.asks[0].regimes.front().where.front() + " for 'J'"),
            cord.assumptions.end());
  EXPECT_EQ(cord.asks[0].state, AskState::needs_letters);
  EXPECT_EQ(cord.asks[0].letters, (Texts{"m", "v"}));
}

// Three pucks of which any may be the fastest.
TEST(SeveralFormulas, there_may_be_more_than_two) {
  const Solution pucks =
      solve_statement(read_statement(R"(letters: {u: {signed: m/s}, v: {signed: m/s}, w: {signed: m/s}}
points: {A: [0, 0, 0], B: [1 m, 0, 0], C: [2 m, 0, 0]}
bodies: {a: {particle: A, mass: 1 kg}, b: {particle: B, mass: 1 kg}, c: {particle: C, mass: 1 kg}}
facts: {velocity(a): [u, 0, 0], velocity(b): [v, 0, 0], velocity(c): [w, 0, 0]}
gravity: none
ask: {fast: max(velocity(a).x with max(velocity(b).x with velocity(c).x))}
)",
                                     "pucks.yaml"),
                      {})
          .solutions.at(0);
  std::vector<std::string> formulas;
  for (const RegimeFormula& one : pucks.asks[0].regimes) {
    formulas.push_back(text(one.formula.number));
    EXPECT_EQ(one.where.size(), 2U);
  }
  std::ranges::sort(formulas);
  EXPECT_EQ(formulas, (Texts{"u", "v", "w"}));
}

const Solution& only_solution(const SolvedStatement& solved) { return solved.solutions.at(0); }

TEST(SeveralFormulas, laws_of_motions_have_them_too) {
  const SolvedStatement solved = solve_statement(read_statement(cart_text, "cart.yaml"), {});
  const Solution& cart = only_solution(solved);
  EXPECT_EQ(formulas_of(cart.asks[0]), (Texts{"2*s - d where s - d > 0", "d where d - s > 0"}));
  EXPECT_EQ(formulas_of(cart.asks[1]), (Texts{"2*s - d where d - s > 0", "d where s - d > 0"}));
}

const char* const thrown_text = R"(letters: {v: m/s, h: m, g: m/s^2}
points: {O: [0, 0, 0], P: [0, h, 0]}
bodies: {ball: {particle: P, mass: 1 kg}}
joints: {rail: {prismatic: y, at: P, to: ball, displacement: u}}
gravity: -y
instants: {start: {"u'": v}}
stages: {fall: {until: center(ball).y == 0}}
ask: {top: max(center(ball).y), fast: 'velocity(ball).y @ fall.end', last: {first_time: center(ball).y == 0}}
)";

// Conservation of energy: the height reached, the speed and the time of a ball that is thrown up.
TEST(SeveralFormulas, laws_may_be_sums_roots_of_sums_and_roots_of_quadratic_equations) {
  const SolvedStatement solved = solve_statement(read_statement(thrown_text, "thrown.yaml"), {});
  const Solution& thrown = only_solution(solved);
  const LetterValues at{{"v", 3.7}, {"h", 2.9}, {"g", 1.6}};
  const double fall = std::sqrt(3.7 * 3.7 + 2 * 1.6 * 2.9);
  const double expected[] = {2.9 + 3.7 * 3.7 / (2 * 1.6), -fall, (3.7 + fall) / 1.6};
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(thrown.asks[i].formula) << i << ": " << thrown.asks[i].no_formula;
    EXPECT_NEAR(value_at(thrown.asks[i].formula->number, at), expected[i], 1e-8 * std::abs(expected[i])) << i;
  }
}

// The largest moment of a brick is that across its shortest side, in whatever order the sides are. A formula found
// where one side is next to nothing once left out the condition on the others.
TEST(SeveralFormulas, of_a_brick_hold_in_every_order_of_its_sides) {
  const Statement statement = read_statement(
      "letters: {m: kg, a: m, b: m, c: m}\npoints: {G: [0, 0, 0]}\n"
      "bodies: {brick: {box: {center: G, sides: [a*x, b*y, c*z]}, mass: m}}\n"
      "ask: {big: max(principal_moments(brick about G))}\n",
      "brick.yaml");
  const Solution solution = solve_statement(statement, {}).solutions.at(0);
  const SolvedAsk& big = solution.asks.at(0);
  ASSERT_EQ(big.regimes.size(), 3U);
  std::vector<double> sides{1, 2, 3};
  do {
    const LetterValues at{{"m", 12}, {"a", sides[0]}, {"b", sides[1]}, {"c", sides[2]}};
    int told = 0;
    for (const RegimeFormula& one : big.regimes) {
      if (!std::ranges::all_of(one.where, [&](const std::string& words) {
            return holds_as_told(words, statement.situations.front().letters, at) != false;
          }))
        continue;
      ++told;
      EXPECT_NEAR(value_at(one.formula.number, at), 13, 1e-12) << sides[0] << sides[1] << sides[2];
    }
    EXPECT_EQ(told, 1) << sides[0] << sides[1] << sides[2];
  } while (std::ranges::next_permutation(sides).found);
}

// The only unknown of each solution, with what is told of all formulas.
Texts solutions_of(const std::string& statement) {
  Texts all;
  for (const Solution& solution : solve_statement(read_statement(statement, "roots.yaml"), {}).solutions) {
    std::string where;
    for (const FormulaCondition& condition : solution.grounds)
      if (condition.asks.empty() || condition.inequality == condition.words)
        where += (where.empty() ? " where " : ", ") + condition.words;
    const SolvedUnknown& unknown = solution.unknowns.at(0);
    all.push_back((unknown.formula ? formula_words(unknown.formula->number) : "no formula") + where);
  }
  std::ranges::sort(all);
  return all;
}

// A ball on a spring in a turning tube goes out without end where the spring is too soft. At x < 0 it is on the other
// side, at as large a distance.
TEST(SeveralFormulas, the_sign_of_a_length_is_a_condition_of_its_formula) {
  EXPECT_EQ(solutions_of(R"(letters: {m: kg, k: N/m, l: m}
given: {w: 5 rad/s}
find: {X: m}
points: {O: [0, 0, 0], P: [X, 0, 0]}
bodies: {tube: massless, b: {particle: P, mass: m}}
joints: {s: {revolute: z, at: O, to: tube, rate: w, accel: 0}, t: {prismatic: x, at: P, from: tube, to: b}}
springs: {sp: {from: tube, at: O, to: b, end: P, stiffness: k, free_length: l}}
steady: {frame: tube}
gravity: none
ask: {x: X, T: norm(force(sp on b))}
)"),
            (Texts{"k*l/(25*m - k) where k - 25*m > 0", "k*l/(k - 25*m) where k - 25*m > 0"}));
}

// A mass stands on its spring where this can carry it, and hangs from it in any case: at the first letters that are
// drawn it may do one of the two only.
TEST(SeveralFormulas, a_solution_that_is_there_at_some_letters_only_is_told_too) {
  EXPECT_EQ(solutions_of(R"(letters: {m: kg, k: N/m, l: m}
find: {u: m}
points: {O: [0, 0, 0], P: [0, -u, 0]}
bodies: {b: {particle: P, mass: m}}
joints: {t: {prismatic: y, at: P, to: b, displacement: s}}
springs: {sp: {from: ground, at: O, to: b, end: P, stiffness: k, free_length: l}}
gravity: -y
instants: {now: {"s'": 0, "s''": 0}}
ask: {u: u}
)"),
            (Texts{"9.80665*m/k - l where l - 9.80665*m/k > 0", "l + 9.80665*m/k"}));
}

// Of two equal moments a top has one precession only; who assumes that they differ knows it.
TEST(SeveralFormulas, what_is_assumed_is_not_told_again) {
  const auto told = [](const std::string& assumed) {
    const SolvedStatement solved = solve_statement(read_statement("letters: {I: kg*m^2, J: kg*m^2, S: rad/s, M: N*m}\n"
                                                                  "given: {b: 60 deg}\nfind: {P: rad/s}\n" +
                                                                      assumed +
                                                                      R"(points: {G: [0, 0, 0]}
directions: {u: [sin(b), 0, cos(b)]}
frames: {figure: {turns: z, rate: P}}
bodies: {top: {mass: 1 kg, center: G, inertia: {axis: u, axial: I, transverse: J}}}
joints: {tip: {ball: G, to: top}}
loads: {weight: {couple: [0, M, 0], body: top}}
steady: {frame: figure, spins: {top: {about: u, rate: S}}}
gravity: none
ask: {P: P}
)",
                                                                  "top.yaml"),
                                                   {});
    return std::ranges::count(solved.solutions.at(0).assumptions, "I - J != 0");
  };
  EXPECT_EQ(told(""), 1);
  EXPECT_EQ(told("assume: [J > I]\n"), 0);
  EXPECT_EQ(told("assume: [I > 2*J]\n"), 0);
  EXPECT_EQ(told("assume: [I > J/2]\n"), 1);
}

}  // namespace several_formulas_test
}  // namespace poinsot::problem
