// Laws with logarithms, inverse tangents and powers of e, against closed forms at random letters.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "problem/answers/solve_statement.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/law_ratio.h"

namespace poinsot::problem {
namespace law_curve_test {

RatioSamples samples_of(const std::function<double(double)>& f) {
  RatioSamples samples;
  for (int n = 0; n < 14; ++n) {
    samples.x.push_back(0.4 * std::pow(3, n / 6.5 - 1));
    samples.numbers.push_back(f(samples.x.back()));
  }
  return samples;
}

TEST(LawCurve, curves_of_drag_are_found_with_both_coefficients) {
  const std::vector<std::function<double(double)>> curves{[](double x) { return 0.5 * std::log1p(3 * x) / x; },
                                                          [](double x) { return -std::atan(2 * std::sqrt(x)); },
                                                          [](double x) { return 3 * std::tanh(std::sqrt(x / 2)); },
                                                          [](double x) { return std::log(std::cosh(2 * x)) / 3; },
                                                          [](double x) { return std::sqrt(1 - std::exp(-2 * x)); },
                                                          [](double x) { return std::acosh(std::exp(x)); },
                                                          [](double x) { return (x - 1 + std::exp(-x)) / (x * x); },
                                                          [](double x) { return 2 * std::exp(-x / 3); },
                                                          [](double x) { return x - std::log1p(x); },
                                                          [](double x) { return -std::log1p(-x / 2); }};
  for (std::size_t n = 0; n < curves.size(); ++n) {
    const auto law = curve_law(Formula::letter("x", poinsot::Sign::positive), samples_of(curves[n]), 1e-10);
    ASSERT_TRUE(law) << n;
    for (const double x : {1e-2, 0.7, 1.9})
      EXPECT_NEAR(value_at(law->formula, {{"x", x}}) / curves[n](x), 1, 1e-11) << n;
  }
}

TEST(LawCurve, what_is_no_such_curve_is_not_taken_for_one) {
  const std::vector<std::function<double(double)>> others{[](double x) { return std::comp_ellint_1(0.8 * x); },
                                                          [](double x) { return std::erf(x); },
                                                          [](double x) { return std::log1p(x) + 1e-7 * x; },
                                                          [](double x) { return std::atan(0.123456789 * x); },
                                                          [](double x) { return std::sin(x); },
                                                          [](double x) { return std::log1p(x) * std::exp(-x); },
                                                          [](double x) { return std::pow(x, 0.7); }};
  for (std::size_t n = 0; n < others.size(); ++n)
    EXPECT_FALSE(curve_law(Formula::letter("x", poinsot::Sign::positive), samples_of(others[n]), 1e-10)) << n;
}

struct Known {
  std::string file, ask;
  std::function<double(const LetterValues&)> right;
};

TEST(LawCurve, drag_by_the_square_of_the_speed_and_by_the_speed_is_that_of_textbooks) {
  const std::string slide = R"(points: {O: [0, 0, 0]}
bodies: {ball: {particle: O, mass: m}}
joints: {guide: {prismatic: y, at: O, to: ball, displacement: s}}
gravity: -y
)";
  const std::string square = "loads: {drag: {force: -k*norm(velocity(ball))*velocity(ball), body: ball}}\n";
  const std::string straight = "loads: {drag: {force: -k*velocity(ball), body: ball}}\n";
  const auto drop = [](const LetterValues& at) { return at.at("k") * at.at("h") / at.at("m"); };
  const std::vector<Known> all{
      {"letters: {m: kg, k: kg/m, v: m/s, g: m/s^2}\n" + slide + square +
           "instants: {start: {s: 0, s': v}, top: {first_time: s' == 0}}\nask: {h: s @ top}\n",
       "h",
       [](const LetterValues& at) {
         return at.at("m") / (2 * at.at("k")) *
                std::log(1 + at.at("k") * at.at("v") * at.at("v") / (at.at("m") * at.at("g")));
       }},
      {"letters: {m: kg, k: kg/m, v: m/s, g: m/s^2}\n" + slide + square +
           "instants: {start: {s: 0, s': v}, top: {first_time: s' == 0}}\nask: {t: time @ top}\n",
       "t",
       [](const LetterValues& at) {
         return std::sqrt(at.at("m") / (at.at("k") * at.at("g"))) *
                std::atan(at.at("v") * std::sqrt(at.at("k") / (at.at("m") * at.at("g"))));
       }},
      {"letters: {m: kg, k: kg/m, h: m, g: m/s^2}\n" + slide + square +
           "instants: {start: {s: 0, s': 0}, lands: {first_time: s == -h}}\nask: {u: \"-s' @ lands\"}\n",
       "u",
       [&](const LetterValues& at) {
         return std::sqrt(at.at("m") * at.at("g") / at.at("k") * (1 - std::exp(-2 * drop(at))));
       }},
      {"letters: {m: kg, k: kg/m, h: m}\n" + slide + square +
           "instants: {start: {s: 0, s': 0}, lands: {first_time: s == -h}}\nask: {t: time @ lands}\n",
       "t",
       [&](const LetterValues& at) {
         return std::sqrt(at.at("m") / (at.at("k") * 9.80665)) * std::acosh(std::exp(drop(at)));
       }},
      {"letters: {m: kg, k: kg/s, v: m/s}\n" + slide + straight +
           "instants: {start: {s: 0, s': v}, top: {first_time: s' == 0}}\nask: {h: s @ top}\n",
       "h", [](const LetterValues& at) {
         const double pace = at.at("m") / at.at("k"), end = pace * 9.80665;
         return pace * at.at("v") - pace * end * std::log(1 + at.at("v") / end);
       }}};
  for (const Known& known : all) {
    const SolvedStatement solved = solve_statement(read_statement(known.file, "drag.yaml"), {});
    const auto& asks = solved.solutions.at(0).asks;
    ASSERT_TRUE(asks.at(0).formula) << known.file << asks[0].no_formula << asks[0].reason;
    for (const double x : {0.3, 1.0, 2.7}) {
      const LetterValues at{{"m", 1 + x}, {"k", 0.4 * x}, {"v", 3 + x}, {"g", 7 / x}, {"h", 2 + x}};
      EXPECT_NEAR(value_at(asks[0].formula->number, at) / known.right(at), 1, 1e-11) << known.file;
    }
  }
}

}  // namespace law_curve_test
}  // namespace poinsot::problem
