// Tracing against computing with numbers: the same templates on doubles, and identities that must be found.
#include "poinsot/engine/math/trace/traced.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "poinsot/engine/math/algebra/vector3.h"
#include "poinsot/engine/math/trace/straight_line.h"
#include "poinsot/engine/math/trace/straight_line_text.h"
#include "poinsot/engine/math/trace/traced_formula.h"

namespace poinsot {
namespace traced_test {

double value(const Trace& trace, const Traced& x, const std::vector<double>& inputs) {
  const StraightLine program(trace, {x});
  double result = 0;
  program.evaluate(inputs, std::span<double>(&result, 1));
  return result;
}

TEST(Traced, FindsWhatIsEqual) {
  Trace trace;
  const TraceScope scope(trace);
  const Traced a = trace.input(0.3), b = trace.input(1.7);
  const auto [s, c] = sine_cosine(a);
  EXPECT_EQ(a + b, b + a);
  EXPECT_EQ((a + b) * (a - b), a * a - b * b);
  EXPECT_EQ(-(a - b), b - a);
  EXPECT_EQ(s * s + c * c, Traced(1));
  EXPECT_TRUE(vanishes(s * s + c * c - Traced(1)));
  EXPECT_TRUE(vanishes((a + b) / (a - b) - (b + a) / (a - b)));
  EXPECT_EQ(a / b * b, a);
  EXPECT_EQ(sqrt(a * a + b) * sqrt(a * a + b), a * a + b);
  EXPECT_EQ(sin(-a), -s);
  EXPECT_EQ(Traced(0.1) + Traced(0.2), Traced(0.3));  // the fractions that these numbers stand for
  EXPECT_EQ(Traced(1.0 / 12) * Traced(12), Traced(1));
}

TEST(Traced, KeepsApartWhatIsNot) {
  Trace trace;
  const TraceScope scope(trace);
  const Traced a = trace.input(0.3), b = trace.input(0.3);
  EXPECT_FALSE(a == b);
  EXPECT_FALSE(a * a == a * b);
  EXPECT_FALSE(sin(a) == cos(a));
  EXPECT_FALSE(vanishes(a - b));
  EXPECT_FALSE(sqrt(a) == a);
  EXPECT_FALSE(sqrt(a) * sqrt(b) == sqrt(Traced(2) * a * b));
  EXPECT_FALSE(is_constant(a));
  EXPECT_TRUE(is_constant(a / a));
}

TEST(Traced, TakesTheRootOfASquareAsItIsAtTheSampleAndSaysSo) {
  Trace trace;
  const TraceScope scope(trace);
  const Traced a = trace.input(-0.5), b = trace.input(2);
  EXPECT_TRUE(trace.assumed_positive().empty());
  EXPECT_EQ(sqrt(a * a), -a);
  ASSERT_EQ(trace.assumed_positive().size(), 1U);
  EXPECT_EQ(trace.assumed_positive()[0], -a);
  const Traced product = a * b;
  EXPECT_EQ(sqrt(product * product), -product);
  EXPECT_FALSE(sqrt(a * a + b) == a);
}

// Which sign a root has at the sample does not depend on the unit that the sample is measured in, nor on what it is
// added to.
TEST(Traced, TellsRootsOfEitherSignAtEverySize) {
  for (const double size : {1e-30, 1e-12, 1e-6, 1.0, 1e6, 1e30}) {
    Trace trace;
    const TraceScope scope(trace);
    const Traced a = trace.input(-0.5 * size), b = trace.input(2 * size);
    EXPECT_EQ(sqrt(a * a), -a) << size;
    EXPECT_EQ(sqrt((a - b) * (a - b)), b - a) << size;
    EXPECT_EQ(sqrt(a * a * b * b), -(a * b)) << size;
    EXPECT_FALSE(sqrt(a * a) == a) << size;
  }
  for (const double size : {1e-9, 1e-6, 1e-3}) {
    // The root is a small part of the sum that it stands in.
    Trace trace;
    const TraceScope scope(trace);
    const Traced a = trace.input(-size), b = trace.input(1.25);
    const Traced above = b + a, below = b - a;
    EXPECT_EQ(b + sqrt(a * a), below) << size;
    EXPECT_FALSE(b + sqrt(a * a) == above) << size;
    EXPECT_EQ(sqrt(below * below), below) << size;
  }
}

// What cancels to nothing but rounding is one number however it is computed.
TEST(Traced, FindsWhatIsEqualThoughItCancels) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> part(0.3, 2);
  for (int run = 0; run < 100; ++run) {
    Trace trace;
    const TraceScope scope(trace);
    const double x = part(random), y = part(random), near = x * (1 + 1e-13 * part(random));
    const Traced a = trace.input(x), b = trace.input(near), c = trace.input(y);
    EXPECT_EQ((a - b) * c, a * c - b * c);
    EXPECT_EQ((a - b) * (a + b), a * a - b * b);
    EXPECT_EQ((a - b) / c + sin(c), sin(c) + a / c - b / c);
    EXPECT_FALSE(a * c == b * c);
  }
}

TEST(Traced, RefusesWhatHasNoValue) {
  Trace trace;
  const TraceScope scope(trace);
  const Traced a = trace.input(0.3);
  EXPECT_THROW(a / (sin(a) * sin(a) + cos(a) * cos(a) - Traced(1)), std::domain_error);
  EXPECT_THROW(sqrt(Traced(-2)), std::domain_error);
  EXPECT_THROW(Traced(NAN), std::domain_error);
}

TEST(Traced, NeedsATraceToComputeIn) {
  EXPECT_THROW(Traced(2), std::logic_error);
  EXPECT_EQ(Traced(0), Traced());
}

// Random formulas over few operations and numbers, on doubles and traced.
TEST(Traced, RandomProgramsGiveTheSameNumbers) {
  std::mt19937_64 random(11);
  for (int run = 0; run < 200; ++run) {
    Trace trace;
    const TraceScope scope(trace);
    std::vector<double> inputs, numbers;
    std::vector<Traced> traced_numbers;
    for (int i = 0; i < 4; ++i) {
      inputs.push_back(std::uniform_real_distribution<double>(0.3, 2)(random));
      numbers.push_back(inputs.back());
      traced_numbers.push_back(trace.input(std::uniform_real_distribution<double>(0.3, 2)(random)));
    }
    numbers.push_back(0.75);
    traced_numbers.push_back(Traced(0.75));
    for (int i = 0; i < 40; ++i) {
      const std::size_t a = random() % numbers.size(), b = random() % numbers.size();
      switch (random() % 7) {
        case 0:
          numbers.push_back(numbers[a] + numbers[b]);
          traced_numbers.push_back(traced_numbers[a] + traced_numbers[b]);
          break;
        case 1:
          numbers.push_back(numbers[a] - numbers[b]);
          traced_numbers.push_back(traced_numbers[a] - traced_numbers[b]);
          break;
        case 2:
        case 3:
          numbers.push_back(numbers[a] * numbers[b]);
          traced_numbers.push_back(traced_numbers[a] * traced_numbers[b]);
          break;
        case 4:
          numbers.push_back(std::sin(numbers[a]));
          traced_numbers.push_back(sin(traced_numbers[a]));
          break;
        case 5:
          numbers.push_back(std::cos(numbers[a]));
          traced_numbers.push_back(cos(traced_numbers[a]));
          break;
        default:
          numbers.push_back(numbers[a] / (2 + numbers[b] * numbers[b]));
          traced_numbers.push_back(traced_numbers[a] / (Traced(2) + traced_numbers[b] * traced_numbers[b]));
      }
    }
    const StraightLine program(trace, traced_numbers);
    std::vector<double> results(traced_numbers.size());
    program.evaluate(inputs, results);
    double size = 1;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      size = std::max(size, std::fabs(numbers[i]));
      EXPECT_NEAR(results[i], numbers[i], 1e-11 * size) << "run " << run << ", number " << i;
    }
  }
}

TEST(StraightLine, LeavesOutWhatIsNotNeededAndBringsCommonFactorsTogether) {
  Trace trace;
  const TraceScope scope(trace);
  const Traced a = trace.input(0.3), b = trace.input(1.7), c = trace.input(0.9);
  static_cast<void>(sin(a) * sin(b));
  EXPECT_EQ(StraightLine(trace, {a * b + a * c}).operations(), 2U);
  EXPECT_EQ(StraightLine(trace, {a * b + a * c, a * b}).operations(), 3U);
  EXPECT_EQ(StraightLine(trace, {a}).operations(), 0U);
  EXPECT_DOUBLE_EQ(value(trace, a * b + a * c, {2, 3, 4}), 14);
}

TEST(StraightLine, RefusesWrongSizes) {
  Trace trace;
  const TraceScope scope(trace);
  const Traced a = trace.input(0.3);
  const StraightLine program(trace, {a});
  std::vector<double> one(1), two(2);
  EXPECT_THROW(program.evaluate(two, one), std::invalid_argument);
  EXPECT_THROW(program.evaluate(one, two), std::invalid_argument);
}

TEST(StraightLineText, WritesEveryForm) {
  Trace trace;
  const TraceScope scope(trace);
  const Traced theta = trace.input(0.3), rate = trace.input(1.7), m = trace.input(0.9);
  const StraightLine program(trace, {rate * rate * m / Traced(12), sin(theta) - m});
  ProgramText text;
  text.function = "f";
  text.arrays = {"q", "v", "parameters"};
  text.inputs = {
      {"q", 0, "theta", "rad", false}, {"v", 0, "theta'", "rad/s", false}, {"parameters", 0, "m_2", "kg", true}};
  text.blocks = {{"x", "two numbers", 2, 1, false}};
  const auto has = [&](TextForm form, const std::string& part) {
    const std::string written = write_program(program, text, form);
    EXPECT_NE(written.find(part), std::string::npos) << part << " in\n" << written;
  };
  has(TextForm::plain, "theta'^2");
  has(TextForm::plain, "x[2] = sin(theta) - m_2");
  has(TextForm::tex, "\\sin\\left(\\theta\\right) - m_{2}");
  has(TextForm::tex, "\\dot{\\theta}^{2}");
  has(TextForm::c, "void f(const double *q, const double *v, const double *parameters, double *out);");
  has(TextForm::c, "out[1] = sin(q[0]) - parameters[0];");
  has(TextForm::cpp, "std::sin(q[0])");
  has(TextForm::python, "def f(q, v, parameters):");
  has(TextForm::sympy, "m_2 = Symbol('m_2', positive=True)");
  has(TextForm::sympy, "Rational(1, 12)");
  has(TextForm::sympy, "theta_dot**2");
}

TEST(StraightLineText, RemarksStayInTheirComments) {
  Trace trace;
  const TraceScope scope(trace);
  const StraightLine program(trace, {trace.input(1)});
  ProgramText text;
  text.function = "f";
  text.arrays = {"q"};
  text.inputs = {{"q", 0, "x", "m", false}};
  text.blocks = {{"y", "one number", 1, 1, false}};
  text.remarks = {"two\nlines */ int x; /*/ \\"};
  EXPECT_NE(write_program(program, text, TextForm::c).find("/* two lines * / int x; / * / */\n"), std::string::npos)
      << write_program(program, text, TextForm::c);
  EXPECT_NE(write_program(program, text, TextForm::cpp).find("// two lines * / int x; / * /\n"), std::string::npos);
  EXPECT_NE(write_program(program, text, TextForm::python).find("# two lines * / int x; / * /\n"), std::string::npos);
}

TEST(StraightLineText, RefusesNamesThatAreNone) {
  EXPECT_TRUE(is_code_name("inverse_dynamics"));
  for (const char* word : {"", "2f", "double", "lambda", "a-b", "f g", "\xc3\xa9"})
    EXPECT_FALSE(is_code_name(word)) << word;
}

TEST(TracedExpression, HasTheValueOfTheExpression) {
  const Formula a = Formula::letter("a", Sign::positive), b = Formula::letter("b", Sign::real);
  const Formula x = sqrt(a * a + b * b) * sin(b) / (Formula(3) + cos(a) * a) + Formula::pi() / Formula(7) * pow(a, 3);
  Trace trace;
  const TraceScope scope(trace);
  const Traced ta = trace.input(0.4), tb = trace.input(0.8);
  const Traced result = traced(x, [&](const std::string& letter) { return letter == "a" ? ta : tb; });
  for (const double at : {0.3, 1.1, 2.9})
    EXPECT_NEAR(value(trace, result, {at, 0.7 - at}), value_at(x, {{"a", at}, {"b", 0.7 - at}}), 1e-13);
}

}  // namespace traced_test
}  // namespace poinsot
