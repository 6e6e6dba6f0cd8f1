// Conditions of formulas as they are told: read back, and held against what was found; events that need not happen.
#include <gtest/gtest.h>

#include <algorithm>

#include "problem/answers/solve_statement.h"
#include "problem/course/motion_support.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_conditions.h"

namespace poinsot::problem {
namespace told_conditions_test {

const std::vector<Letter> letters{{"M", {1, dimensions::mass, "kg"}, {}, false},
                                  {"Q", {1, dimensions::mass, "kg"}, {}, false},
                                  {"b", {1, dimensions::angle, "rad"}, {}, false}};
const LetterValues found_at{{"M", 3}, {"Q", 2}, {"b", 0.5}}, beyond{{"M", 1}, {"Q", 2}, {"b", 2.5}};

TEST(ToldConditions, are_read_as_they_stand) {
  EXPECT_EQ(holds_as_told("M - Q > 0", letters, found_at), true);
  EXPECT_EQ(holds_as_told("M - Q < 0", letters, found_at), false);
  EXPECT_EQ(holds_as_told("M - Q > 0", letters, beyond), false);
  EXPECT_EQ(holds_as_told("g*M - 29*cos(b)*Q/2 > 0", letters, found_at), true);
  EXPECT_EQ(holds_as_told("cos(b) > 0", letters, beyond), false);
  EXPECT_EQ(holds_as_told("the contact presses", letters, found_at), std::nullopt);
  EXPECT_EQ(holds_as_told("x > 0", letters, found_at), std::nullopt);
}

Solution solution_with(const std::string& inequality) {
  const Formula M = formula_of(letters[0]).number, Q = formula_of(letters[1]).number;
  Solution solution;
  solution.asks.resize(2);
  for (SolvedAsk& ask : solution.asks) {
    ask.state = AskState::needs_letters;
    ask.formula = Value<Formula>::of_number(M - Q, dimensions::mass);
    ask.value = Value<double>::of_number(1, dimensions::mass);
  }
  solution.grounds.push_back({inequality + " for 't'", M - Q, inequality, {0}});
  return solution;
}

TEST(ToldConditions, that_are_right_are_kept) {
  Solution solution = solution_with("M - Q > 0");
  hold_conditions_as_told(letters, found_at, {found_at, beyond}, solution);
  EXPECT_TRUE(solution.asks[0].formula);
  EXPECT_TRUE(solution.asks[1].formula);
}

// Reversed, of another sign, and one that holds where the formula was found and is wrong elsewhere.
TEST(ToldConditions, that_are_wrong_take_the_formula_back) {
  for (const char* wrong : {"M - Q < 0", "Q - M > 0", "M + Q > 0", "M - Q/4 > 0"}) {
    Solution solution = solution_with(wrong);
    hold_conditions_as_told(letters, found_at, {beyond}, solution);
    EXPECT_FALSE(solution.asks[0].formula) << wrong;
    EXPECT_TRUE(solution.asks[1].formula) << "its condition is not of this one";
    EXPECT_EQ(solution.asks[0].no_formula,
              "the condition of the formula found, as it is told, does not agree with numbers");
  }
}

TEST(ToldConditions, beside_each_of_several_formulas_are_held_too) {
  const Formula M = formula_of(letters[0]).number, Q = formula_of(letters[1]).number;
  const auto kept = [&](const std::string& of_first, const std::string& of_second) {
    Solution solution;
    SolvedAsk& ask = solution.asks.emplace_back();
    ask.value = Value<double>::of_number(3, dimensions::mass);
    ask.formula = Value<Formula>::of_number(M, dimensions::mass);
    ask.regimes = {{*ask.formula, {of_first}}, {Value<Formula>::of_number(Q, dimensions::mass), {of_second}}};
    hold_conditions_as_told(letters, found_at, {}, solution);
    return ask.formula.has_value();
  };
  EXPECT_TRUE(kept("M - Q > 0", "Q - M > 0"));
  EXPECT_FALSE(kept("M - Q < 0", "Q - M > 0"));
  EXPECT_FALSE(kept("M - Q > 0", "Q - M < 0"));
}

bool assumed(const SolvedText& solved, const std::string& words) {
  return std::ranges::count(solved.solved().solutions.at(0).assumptions, words) > 0;
}

// Newton's second law: the slip n vanishes after J n/(M - Q), if the clutch is stronger than the load.
TEST(ToldConditions, a_clutch_that_may_never_lock) {
  const SolvedText solved(R"(title: t
letters: {J: kg*m^2, n: rad/s, M: N*m, Q: N*m}
points: {A: [0, 0, 0], B: [0.2 m, 0, 0]}
bodies:
  motor: {mass: 10 kg, center: A, inertia: {axis: x, axial: 1 kg*m^2, transverse: 1 kg*m^2}}
  drum: {mass: 12 kg, center: B, inertia: {axis: x, axial: J, transverse: J}}
joints:
  shaft: {revolute: x, at: A, to: motor, rate: n, accel: 0}
  clutch: {revolute: x, at: A, from: motor, to: drum, rate: -n, friction: M}
loads: {load: {couple: -Q, about: x, body: drum}}
gravity: none
ask: {t: {first_time: sticking(clutch)}}
)");
  ASSERT_TRUE(solved.ask("t").formula);
  EXPECT_NEAR(value_at(solved.ask("t").formula->number, {{"J", 2}, {"n", 3}, {"M", 5}, {"Q", 1.5}}), 6 / 3.5, 1e-9);
  EXPECT_TRUE(assumed(solved, "M - Q > 0 for 't'"));
}

// A crate that slides while it is pushed on comes to rest if its friction is larger; so is it with its way.
TEST(ToldConditions, what_is_asked_where_it_happens_needs_it_too) {
  const SolvedText solved(R"(title: t
letters: {v: m/s, mu: 1, F: N, m: kg}
points: {C: [0, 0, 0]}
bodies: {block: {particle: C, mass: m}}
contacts: {floor: {of: block, at: C, normal: y, friction: mu}}
loads: {push: {force: [F, 0, 0], at: C, body: block}}
gravity: -y
instants: {start: {velocity(block): [v, 0, 0]}, rests: {first_time: sticking(floor)}}
ask: {s: position(block).x @ rests}
)");
  ASSERT_TRUE(solved.ask("s").formula);
  const std::vector<FormulaCondition>& grounds = solved.solved().solutions.at(0).grounds;
  const auto condition = std::ranges::find_if(
      grounds, [](const FormulaCondition& one) { return one.asks == std::vector<std::size_t>{0}; });
  ASSERT_NE(condition, grounds.end());
  EXPECT_TRUE(assumed(solved, condition->words));
  // The friction is 0.3*2*9.80665 N = 5.88399 N.
  for (const double F : {1.0, 5.8839, 5.8841, 40.0}) {
    const LetterValues at{{"v", 3}, {"mu", 0.3}, {"F", F}, {"m", 2}};
    EXPECT_EQ(value_at(condition->positive, at) > 0, F < 5.88399) << F;
    EXPECT_EQ(holds_as_told(condition->inequality, solved.solved().open_letters, at), F < 5.88399) << F;
  }
}

// What is let go with the speed of a fall from h passes the top of its circle if h is more than twice the radius; to
// look for that in vain takes longer than to find it.
TEST(ToldConditions, what_is_asked_at_the_top_that_a_pendulum_may_not_reach) {
  const SolvedText solved(R"(title: t
letters: {m: kg, R: m, h: m}
points: {O: [0, 0, 0]}
bodies: {car: {particle: '[0, -R, 0]', mass: m}}
joints: {arm: {revolute: z, at: O, to: car, angle: q}}
gravity: -y
instants: {start: {q: 0, q': sqrt(2*g*h)/R}, top: {first_time: q == 180 deg}}
ask: {N: force(arm on car).y @ top}
)");
  ASSERT_TRUE(solved.ask("N").formula) << solved.ask("N").no_formula;
  const std::vector<FormulaCondition>& grounds = solved.solved().solutions.at(0).grounds;
  const auto condition = std::ranges::find_if(
      grounds, [](const FormulaCondition& one) { return one.asks == std::vector<std::size_t>{0}; });
  ASSERT_NE(condition, grounds.end());
  for (const double h : {1.0, 3.99, 4.01, 9.0})
    EXPECT_EQ(value_at(condition->positive, {{"m", 2}, {"R", 2}, {"h", h}}) > 0, h > 4) << h;
}

// A pendulum is let go at b below the level, so that its largest rate is w: 2 g (1 - cos(b)) = L w^2. What is found by
// trials has no angle in its range beyond a right one.
TEST(ToldConditions, the_stated_range_of_an_unknown_is_one_of_laws_too) {
  const Solution solution = solve_statement(read_statement(R"(letters: {L: m, w: rad/s}
find: {b: rad}
where: [0 < b < 90 deg]
points: {O: [0, 0, 0], P: [0, -L, 0]}
bodies: {bob: {particle: P, mass: 1 kg}}
joints: {pin: {revolute: z, at: O, to: bob, angle: q}}
gravity: -y
instants: {start: {q: b, q': 0, max(q'): w}}
ask: {b: b}
)",
                                                           "test.yaml"),
                                            {})
                                .solutions.at(0);
  ASSERT_TRUE(solution.asks[0].formula);
  EXPECT_EQ(solution.asks[0].formula_road.substr(0, 23), "by dimensional analysis");
  std::size_t wrong = 0, told = 0;
  for (const std::string& condition : solution.assumptions)
    for (const double w : {4.3, 4.6}) {
      const auto holds = holds_as_told(condition,
                                       {{"L", {1, dimensions::length, "m"}, {}, false},
                                        {"w", {1, dimensions::angle / dimensions::time, "rad/s"}, {}, false}},
                                       {{"L", 1}, {"w", w}});
      if (!holds) continue;
      ++told;
      wrong += *holds != (w * w < 2 * 9.80665);
    }
  EXPECT_EQ(told, 2u);
  EXPECT_EQ(wrong, 0u);
}

// The root in an angle of a throw, which hits what is not too far: v^2 > g d.
TEST(ToldConditions, tell_roots_within_angles) {
  const Solution solution = solve_statement(read_statement(R"(
letters: {v: m/s, d: m}
find: {b: rad, t: s}
where: [0 < b < 90 deg]
points: {O: [0, 0, 0]}
bodies: {ball: {particle: O, mass: 1 kg}}
gravity: -y
instants: {start: {velocity(ball): '[v*cos(b), v*sin(b), 0]'}, t: {'position(ball).x': d, 'position(ball).y': 0 m}}
ask: {b: b}
)",
                                                           "test.yaml"),
                                            {})
                                .solutions.at(0);
  ASSERT_TRUE(solution.asks[0].formula);
  std::string told;
  for (const std::string& words : solution.assumptions) told += words + "\n";
  EXPECT_NE(told.find("v^2 - 9.80665*d >= 0 for 'b'"), std::string::npos) << told;
}

}  // namespace told_conditions_test
}  // namespace poinsot::problem
