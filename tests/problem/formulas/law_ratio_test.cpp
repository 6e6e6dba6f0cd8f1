// Laws that are quotients of polynomials in a ratio of letters, against closed forms at random letters.
#include "problem/formulas/law_ratio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "case_count.h"
#include "problem/answers/solve_statement.h"
#include "problem/formulas/formula_answers.h"

namespace poinsot::problem {
namespace law_ratio_test {

RatioSamples samples_of(const std::function<double(double)>& f) {
  RatioSamples samples;
  for (int n = 0; n < 14; ++n) {
    samples.x.push_back(0.4 * std::pow(3, n / 6.5 - 1));
    samples.numbers.push_back(f(samples.x.back()));
  }
  return samples;
}

TEST(LawRatio, quotients_of_random_polynomials_and_their_roots_are_found) {
  std::mt19937_64 random(8300);
  const auto whole = [&] { return static_cast<double>(std::uniform_int_distribution<int>(1, 9)(random)); };
  for (int n = 0; n < testing::case_count(40); ++n) {
    const double a = whole(), b = whole(), c = 1 + n % 5, d = whole(), e = whole() / 12;
    const bool root = n % 2 == 0;
    const auto f = [&](double x) {
      const double quotient = (a + b * x + e * x * x) / (c + d * x);
      return root ? -std::sqrt(quotient) : quotient;
    };
    const auto law = ratio_law(Formula::letter("x", poinsot::Sign::positive), samples_of(f), 1e-10);
    ASSERT_TRUE(law) << n;
    for (const double x : {1e-3, 0.7, 1e3}) EXPECT_NEAR(value_at(law->formula, {{"x", x}}) / f(x), 1, 1e-12) << n;
  }
}

// 81 and 32 are no fraction of small numbers, but 51, 81/2 and 27/2 over 16 are.
TEST(LawRatio, fractions_over_another_coefficient_than_the_first_are_found) {
  const auto f = [](double x) { return (16 * x * x + 51 * x + 13.5) / (16 * x * x + 51 * x + 40.5); };
  const auto law = ratio_law(Formula::letter("x", poinsot::Sign::positive), samples_of(f), 1e-10);
  ASSERT_TRUE(law);
  for (const double x : {1e-3, 0.7, 1e3}) EXPECT_NEAR(value_at(law->formula, {{"x", x}}) / f(x), 1, 1e-15) << x;
}

TEST(LawRatio, what_is_no_quotient_is_not_taken_for_one) {
  const std::vector<std::function<double(double)>> others{
      [](double x) { return std::exp(x); }, [](double x) { return std::comp_ellint_1(0.8 * x); },
      [](double x) { return std::sin(x); }, [](double x) { return std::sqrt(1 + x) + std::sqrt(2 + x); },
      [](double x) { return std::pow(x, 0.7); }};
  for (std::size_t n = 0; n < others.size(); ++n)
    EXPECT_FALSE(ratio_law(Formula::letter("x", poinsot::Sign::positive), samples_of(others[n]), 1e-10)) << n;
}

constexpr double g = 9.80665;

const char* const parallelogram = R"(letters: {m: kg, M: kg, l: m, b: rad}
points: {A: [0, 0, 0], B: [2*l, 0, 0], C: [l*sin(b), -l*cos(b), 0], D: [2*l + l*sin(b), -l*cos(b), 0]}
bodies: {l1: {rod: [A, C], mass: m}, l2: {rod: [B, D], mass: m}, bar: {rod: [C, D], mass: M}}
joints:
  a: {revolute: z, at: A, to: l1, angle: q}
  b2: {revolute: z, at: B, to: l2}
  c: {revolute: z, at: C, from: l1, to: bar}
  d: {revolute: z, at: D, from: l2, to: bar}
gravity: -y
instants: {start: rest}
ask: {f: q''}
)";
const char* const tube = R"(letters: {m: kg, M: kg, l: m, w: rad/s}
points: {O: [0, 0, 0], B: [l/2, 0, 0], E: [l, 0, 0]}
bodies: {tube: {rod: [O, E], mass: M}, ball: {particle: B, mass: m}}
joints:
  axle: {revolute: z, at: O, to: tube, angle: q}
  slide: {prismatic: x, at: B, from: tube, to: ball, displacement: s}
gravity: none
instants: {start: {"q'": w, "s'": 0, s: 0}, out: {first_time: s == l/2}}
ask: {f: "s' @ out"}
)";
const char* const carts = R"(letters: {m: kg, M: kg, k: N/m, l: m}
points: {A: [0, 0, 0], B: [l, 0, 0]}
bodies: {a: {particle: A, mass: m}, b: {particle: B, mass: M}}
joints: {ra: {prismatic: x, at: A, to: a, displacement: u}, rb: {prismatic: x, at: B, to: b, displacement: w}}
springs: {s: {from: a, at: A, to: b, end: B, stiffness: k, free_length: l}}
gravity: none
instants: {start: {u: 0, w: 0.1 m, "u'": 0, "w'": 0}}
ask: {f: period(w - u)}
)";
const char* const hoop = R"(letters: {m: kg, R: m, w: rad/s}
find: {b: rad}
where: [0.01 rad < b < 90 deg]
points: {O: [0, 0, 0], P: [R*sin(b), 0, -R*cos(b)]}
bodies: {hoop: massless, arm: massless, bead: {particle: P, mass: m}}
joints:
  v: {revolute: z, at: O, to: hoop, rate: w, accel: 0}
  c: {revolute: y, at: O, from: hoop, to: arm}
  g1: {weld: P, from: arm, to: bead}
steady: {frame: hoop}
gravity: -z
ask: {f: frequencies(bead)}
)";

struct Known {
  const char* file;
  std::function<double(const LetterValues&)> exact;
};

// Momenta and energies in closed form.
TEST(LawRatio, laws_of_ratios_of_masses_and_of_speeds_are_those_of_conservation) {
  const std::vector<Known> all{{parallelogram,
                                [](const LetterValues& at) {
                                  const double m = at.at("m"), M = at.at("M");
                                  return -(m + M) * g * std::sin(at.at("b")) / ((2 * m / 3 + M) * at.at("l"));
                                }},
                               {tube,
                                [](const LetterValues& at) {
                                  const double m = at.at("m"), l = at.at("l"), bar = at.at("M") * l * l / 3;
                                  const double before = bar + m * l * l / 4, after = bar + m * l * l, w = at.at("w");
                                  return std::sqrt(before * w * w * (1 - before / after) / m);
                                }},
                               {carts,
                                [](const LetterValues& at) {
                                  const double m = at.at("m"), M = at.at("M");
                                  return 2 * std::acos(-1.0) * std::sqrt(m * M / (at.at("k") * (m + M)));
                                }},
                               {hoop, [](const LetterValues& at) {
                                  const double w = at.at("w"), part = g / (at.at("R") * w * w);
                                  return w * std::sqrt(1 - part * part);
                                }}};
  std::mt19937_64 random(8310);
  for (const Known& known : all) {
    const SolvedStatement solved = solve_statement(read_statement(known.file, "ratio.yaml"), {});
    const SolvedAsk& ask = solved.solutions.at(0).asks.at(0);
    ASSERT_TRUE(ask.formula) << known.file << ask.no_formula;
    const Formula formula = ask.formula->is_list() ? ask.formula->items.at(0).number : ask.formula->number;
    for (int n = 0; n < 30; ++n) {
      LetterValues at;
      // The hoop turns fast enough and the spring is longer than its swing.
      for (const Letter& letter : solved.open_letters)
        at[letter.name] = std::uniform_real_distribution<double>(4, 5)(random) *
                          (letter.name == "m" || letter.name == "M" ? std::pow(10, n % 5 - 2) : 1);
      EXPECT_NEAR(value_at(formula, at) / known.exact(at), 1, 1e-9) << known.file;
    }
  }
}

// Beyond a quarter turn the hoop does not stay on the slope, which is told.
TEST(LawRatio, a_law_need_not_hold_where_a_contact_would_pull) {
  const Solution hoop_down = solve_statement(read_statement(R"(letters: {m: kg, r: m, b: rad}
points: {C: [0, 0, 0], G: [r*sin(b), r*cos(b), 0]}
directions: {out: [sin(b), cos(b), 0]}
bodies: {hoop: {ring: {center: G, normal: z, radius: r}, mass: m}}
contacts: {slope: {of: hoop, at: C, normal: out, no_slip: true}}
instants: {start: rest}
gravity: -y
ask: {v: norm(velocity(hoop)) @ 2 s}
)",
                                                            "slope.yaml"),
                                             {})
                                 .solutions.at(0);
  ASSERT_TRUE(hoop_down.asks[0].formula) << hoop_down.asks[0].no_formula;
  EXPECT_NEAR(value_at(hoop_down.asks[0].formula->number, {{"b", 0.4}}), g * std::sin(0.4), 1e-8);
  const auto told = std::ranges::find(hoop_down.conditions, "the contact 'slope' presses", &FormulaCondition::words);
  ASSERT_NE(told, hoop_down.conditions.end());
  EXPECT_LT(value_at(told->positive, {{"m", 2}, {"r", 1}, {"b", 2}}), 0);
}

// A thin disk precesses against its spin about the normal whatever its letters are; of a cylinder it depends on these.
TEST(LawRatio, a_word_that_no_letter_changes_is_an_answer) {
  const auto sense_of = [](const std::string& shape) {
    return solve_statement(read_statement("letters: {m: kg, r: m, h: m, s: rad/s, e: rad/s}\npoints: {G: [0, 0, 0]}\n"
                                          "bodies: {plate: {" +
                                              shape +
                                              ", mass: m}}\ninstants: {now: {angular_velocity(plate): [e, 0, s]}}\n"
                                              "gravity: none\nask: {sense: precession_sense(plate)}\n",
                                          "plate.yaml"),
                           {})
        .solutions.at(0)
        .asks.at(0);
  };
  const SolvedAsk disk = sense_of("disk: {center: G, normal: z, radius: r}");
  EXPECT_EQ(disk.state, AskState::found);
  EXPECT_EQ(disk.value.text, "retrograde");
  EXPECT_TRUE(disk.letters.empty());
  const SolvedAsk cylinder = sense_of("cylinder: {center: G, axis: z, radius: r, length: h}");
  EXPECT_EQ(cylinder.state, AskState::needs_letters);
}

// Which way a body of revolution precesses depends on its moments alone, and not on which way it turns; what is assumed
// of these decides it.
TEST(LawRatio, a_word_that_no_letter_that_is_assumed_changes_is_an_answer) {
  const auto sense_of = [](const std::string& assumed) {
    return solve_statement(
               read_statement(
                   "letters: {I: kg*m^2, J: kg*m^2, w: rad/s, b: rad, L: m}\npoints: {G: [0, 0, 0]}\n" + assumed +
                       "bodies: {craft: {mass: 3 kg, center: G, inertia: {axis: z, axial: I, transverse: J}}}\n"
                       "instants: {now: {angular_velocity(craft): [w*sin(b), 0, w*cos(b)]}}\n"
                       "gravity: none\nask: {sense: precession_sense(craft)}\n",
                   "craft.yaml"),
               {})
        .solutions.at(0)
        .asks.at(0);
  };
  const SolvedAsk slender = sense_of("assume: [I < J, 0 < b < 80 deg, L < 3 m]\n");
  EXPECT_EQ(slender.state, AskState::found) << slender.no_formula;
  EXPECT_EQ(slender.value.text, "direct");
  const SolvedAsk flat = sense_of("assume: [I > J]\n");
  EXPECT_EQ(flat.state, AskState::found) << flat.no_formula;
  EXPECT_EQ(flat.value.text, "retrograde");
  const SolvedAsk any = sense_of("assume: [0 < b < 80 deg]\n");
  EXPECT_EQ(any.state, AskState::needs_letters);
  EXPECT_EQ(any.no_formula, "it is not the same for all letters that are assumed");
}

}  // namespace law_ratio_test
}  // namespace poinsot::problem
