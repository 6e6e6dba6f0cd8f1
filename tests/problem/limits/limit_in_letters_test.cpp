// Ends of what contacts do, in letters, beside formulas of statics that are derived here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "problem/answers/solve_statement.h"
#include "problem/formulas/formula_conditions.h"
#include "problem/plane/planar_statement.h"

namespace poinsot::problem {
namespace limit_in_letters_test {

constexpr double g = 9.80665;

SolvedStatement solved(const std::string& text) {
  Statement statement = read_statement(text, "test.yaml");
  restrict_to_plane(statement);
  return solve_statement(statement, {});
}

// The value of an answer at some letters by whichever of its formulas has its conditions there; nothing where none has.
std::optional<double> told_at(const SolvedStatement& found, std::size_t i, const LetterValues& letters) {
  const Solution& solution = found.solutions.at(0);
  const SolvedAsk& ask = solution.asks.at(i);
  EXPECT_TRUE(ask.formula) << ask.no_formula;
  if (!ask.formula) return std::nullopt;
  const auto holds = [&](const std::string& words) {
    return holds_as_told(words, found.open_letters, letters).value_or(false);
  };
  if (ask.regimes.empty()) {
    for (const FormulaCondition& ground : solution.grounds)
      if (std::ranges::count(ground.asks, i) > 0 && !holds(ground.inequality)) return std::nullopt;
    return value_at(ask.formula->number, letters);
  }
  std::optional<double> value;
  for (const RegimeFormula& regime : ask.regimes)
    if (std::ranges::all_of(regime.where, holds)) value = value_at(regime.formula.number, letters);
  return value;
}

std::string crate(const std::string& letters, const std::string& asked) {
  return "plane: [x, y]\nletters: {" + letters +
         "}\nassume: [H > h]\npoints: {A: [-b/2, 0], B: [b/2, 0], G: [0, h], Q: [-b/2, H]}\n"
         "bodies: {crate: {mass: m, center: G, inertia: {z: m*b^2}}}\n"
         "contacts:\n  rear: {of: crate, corner: A, normal: y, friction: mu}\n"
         "  front: {of: crate, corner: B, normal: y, friction: mu}\n"
         "loads: {push: {force: [P, 0], at: Q, body: crate}}\ngravity: -y\ninstants: {now: rest}\n"
         "ask: {most: {largest: P, while: " +
         asked + "}}\n";
}

// Pushed above its center a crate that slides tips where P (H - h) = m g (b/2 - mu h), and one that rests where
// P H = m g b/2.
TEST(LimitInLetters, of_a_crate_that_slides_or_rests_before_it_tips) {
  const SolvedStatement found = solved(crate("m: kg, b: m, h: m, H: m, mu: 1, P: N", "touching(rear)"));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> size(0.2, 2), coefficient(0.05, 0.9);
  int slides = 0, rests = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const double m = size(random), b = size(random), h = size(random), H = h + size(random), mu = coefficient(random);
    const std::optional<double> told = told_at(found, 0, {{"m", m}, {"b", b}, {"h", h}, {"H", H}, {"mu", mu}});
    if (!told) continue;
    const bool slides_first = mu * H < b / 2;
    const double end = slides_first ? m * g * (b / 2 - mu * h) / (H - h) : m * g * b / (2 * H);
    EXPECT_NEAR(*told, end, 1e-9 * std::abs(end)) << m << " " << b << " " << h << " " << H << " " << mu;
    ++(slides_first ? slides : rests);
  }
  EXPECT_GT(slides + rests, 40);
}

// How its two feet share the friction is open, and the load at which both give way is not.
TEST(LimitInLetters, of_feet_that_share_their_friction) {
  const SolvedStatement found =
      solved(crate("m: kg, b: m, h: m, H: m, mu: 1, P: N", "[sticking(front), sticking(rear)]"));
  std::mt19937 random(4);
  std::uniform_real_distribution<double> size(0.2, 2), coefficient(0.05, 0.9);
  int told_at_all = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const double m = size(random), b = size(random), h = size(random), H = size(random), mu = coefficient(random);
    const std::optional<double> told = told_at(found, 0, {{"m", m}, {"b", b}, {"h", h}, {"H", H}, {"mu", mu}});
    if (!told) continue;
    ++told_at_all;
    EXPECT_NEAR(*told, m * g * std::min(mu, b / (2 * H)), 1e-9 * m * g) << b << " " << H << " " << mu;
  }
  EXPECT_GT(told_at_all, 60);
}

// A ladder on a rough floor and a smooth wall, with a load Q that climbs: moments about its foot.
TEST(LimitInLetters, of_a_ladder_that_is_climbed) {
  const SolvedStatement found = solved(
      "letters: {W: N, L: m, b: deg, mu: 1, Q: N, s: m}\nassume: [0 < b < 90 deg, mu < 1, s < L]\n"
      "points: {A: [0, 0, 0], B: '[-L*cos(b), L*sin(b), 0]', M: '[-s*cos(b), s*sin(b), 0]'}\n"
      "bodies: {ladder: {rod: [A, B], weight: W}}\n"
      "contacts:\n  foot: {of: ladder, at: A, normal: y, friction: mu}\n  wall: {of: ladder, at: B, normal: x}\n"
      "loads: {man: {force: '[0, -Q, 0]', at: M, body: ladder}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {far: {largest: s, while: sticking(foot)}, least: {smallest: mu, while: sticking(foot)}, "
      "heavy: {largest: Q, while: sticking(foot)}}\n");
  int far = 0, least = 0;
  for (const double b : {0.6, 0.8, 1.0, 1.2})
    for (const double mu : {0.3, 0.45, 0.6}) {
      const double W = 200, L = 4, Q = 700, s = 2.5;
      const LetterValues letters{{"W", W}, {"L", L}, {"b", b}, {"mu", mu}, {"Q", Q}, {"s", s}};
      if (const auto told = told_at(found, 0, letters)) {
        EXPECT_NEAR(*told, L / Q * (mu * (W + Q) * std::tan(b) - W / 2), 1e-9 * L);
        ++far;
      }
      if (const auto told = told_at(found, 1, letters)) {
        EXPECT_NEAR(*told, (W / 2 + Q * s / L) / ((W + Q) * std::tan(b)), 1e-9);
        ++least;
      }
    }
  EXPECT_GT(far, 6);
  EXPECT_EQ(least, 12);
  const auto heavy = told_at(found, 2, {{"W", 200}, {"L", 4}, {"b", 0.9}, {"mu", 0.45}, {"Q", 100}, {"s", 3}});
  EXPECT_NEAR(heavy.value_or(0), 200 * (0.45 * std::tan(0.9) - 0.5) / (0.75 - 0.45 * std::tan(0.9)), 1e-9);
}

// The steepest slope on which a block rests is no power of the coefficient, and neither is the pull at an angle.
TEST(LimitInLetters, of_an_angle_and_of_a_pull_at_an_angle) {
  const SolvedStatement slope = solved(
      "letters: {m: kg, mu: 1, b: deg}\nassume: [0 < b < 90 deg]\npoints: {C: [0, 0, 0]}\n"
      "directions: {out: '[sin(b), cos(b), 0]'}\nbodies: {block: {particle: C, mass: m}}\n"
      "contacts: {slope: {of: block, at: C, normal: out, friction: mu}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {steepest: {largest: b, while: sticking(slope)}}\n");
  EXPECT_NEAR(told_at(slope, 0, {{"m", 2}, {"mu", 0.7}}).value_or(0), std::atan(0.7), 1e-9);
  const SolvedStatement pull = solved(
      "letters: {m: kg, mu: 1, b: deg, P: N}\nassume: [0 < b < 90 deg]\npoints: {C: [0, 0, 0]}\n"
      "bodies: {block: {particle: C, mass: m}}\ncontacts: {floor: {of: block, at: C, normal: y, friction: mu}}\n"
      "loads: {pull: {force: '[P*cos(b), P*sin(b), 0]', at: C, body: block}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {begins: {largest: P, while: sticking(floor)}, a: acceleration(block).y}\n");
  EXPECT_NEAR(told_at(pull, 0, {{"m", 2}, {"mu", 0.7}, {"b", 0.5}}).value_or(0),
              0.7 * 2 * g / (std::cos(0.5) + 0.7 * std::sin(0.5)), 1e-9);
}

// Of stacked blocks the lower one is pulled: the upper stays on it up to (u + w)(m + M) g, while the lower slides.
TEST(LimitInLetters, of_one_contact_while_another_slides) {
  const SolvedStatement found = solved(
      "plane: [x, y]\nletters: {m: kg, M: kg, u: 1, w: 1, P: N, h: m}\n"
      "points: {C: [0, h], D: [0, 0], T: [0, h/2]}\n"
      "bodies:\n  top: {particle: C, mass: m}\n  low: {rectangle: {center: T, sides: [[2*h, 0], [0, h]]}, mass: M}\n"
      "joints: {guide: {planar: z, at: T, to: low, freedoms: {turn: {rate: 0, accel: 0}}}}\n"
      "contacts:\n  mid: {of: top, against: low, at: C, normal: y, friction: u}\n"
      "  floor: {of: low, at: D, normal: y, friction: w}\n"
      "loads: {pull: {force: [P, 0], body: low}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {most: {largest: P, while: sticking(mid)}, quick: {smallest: P, while: acceleration(low).x > g/10}}\n");
  EXPECT_NEAR(told_at(found, 0, {{"m", 2}, {"M", 5}, {"u", 0.3}, {"w", 0.2}, {"h", 0.4}}).value_or(0), 0.5 * 7 * g,
              1e-9);
  EXPECT_NEAR(told_at(found, 1, {{"m", 2}, {"M", 5}, {"u", 0.3}, {"w", 0.2}, {"h", 0.4}}).value_or(0), 0.3 * 7 * g,
              1e-9);
}

TEST(LimitInLetters, says_why_it_has_none) {
  const SolvedStatement found = solved(
      "letters: {m: kg, P: N}\nfind: {Q: N}\npoints: {C: [0, 0, 0]}\nbodies: {block: {particle: C, mass: m}}\n"
      "contacts: {floor: {of: block, at: C, normal: y, friction: 0.3}}\n"
      "loads: {pull: {force: [P, 0, 0], at: C, body: block}, lift: {force: [0, Q, 0], at: C, body: block}}\n"
      "gravity: -y\ninstants: {now: {velocity(block): [0, 0, 0], acceleration(block).y: 0}}\n"
      "ask: {most: {largest: P, while: sticking(floor)}}\n");
  EXPECT_FALSE(found.solutions.at(0).asks.at(0).formula);
  EXPECT_EQ(found.solutions.at(0).asks.at(0).no_formula, "beside unknowns it is found by numbers");
}

// The push holds the block between two values that are nearer to each other than those that are tried.
TEST(LimitInLetters, by_numbers_is_looked_for_where_the_datum_is) {
  Statement statement = read_statement(R"(plane: [x, y]
given: {W: 500 N, b: 30 deg, mu: 0.02, P: 288 N}
points: {O: [0, 0]}
directions: {out: [-sin(b), cos(b)]}
bodies: {block: {particle: O, weight: W}}
contacts: {slope: {of: block, at: O, normal: out, friction: mu}}
loads: {push: {force: [P, 0], body: block}}
gravity: -y
instants: {now: rest}
ask: {least: {smallest: P, while: sticking(slope)}, most: {largest: P, while: sticking(slope)}}
)",
                                       "narrow.yaml");
  restrict_to_plane(statement);
  const Solution stated = solve_statement(statement, {}).solutions.at(0);
  const double slope = std::tan(std::acos(-1.0) / 6);
  ASSERT_EQ(stated.asks.at(1).state, AskState::found) << stated.asks[1].reason;
  EXPECT_NEAR(stated.asks[0].value.number, 500 * (slope - 0.02) / (1 + 0.02 * slope), 1e-6);
  EXPECT_NEAR(stated.asks[1].value.number, 500 * (slope + 0.02) / (1 - 0.02 * slope), 1e-6);
}

}  // namespace limit_in_letters_test
}  // namespace poinsot::problem
