#include "poinsot/engine/math/formula/formula_exponential.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "poinsot/engine/math/formula/formula_sign.h"
#include "poinsot/engine/math/formula/formula_text.h"

namespace poinsot {
namespace formula_exponential_test {
namespace {

const Formula a = Formula::letter("a", Sign::positive), b = Formula::letter("b", Sign::positive),
              c = Formula::letter("c", Sign::real), pi = Formula::pi();

TEST(FormulaExponential, SumsOfExponentsAreProducts) {
  EXPECT_EQ(exp(Formula()), Formula(1));
  EXPECT_EQ(exp(a + b), exp(a) * exp(b));
  EXPECT_EQ(exp(2 * a - 3 * b * c), exp(a) * exp(a) / pow(exp(b * c), 3));
  EXPECT_EQ(exp(a) * exp(-a), Formula(1));
  EXPECT_EQ(exp(a / 2) * exp(a / 2), exp(a));
  EXPECT_EQ(exp(a / 2) * exp(a / 3), exp(5 * a / 6));
  EXPECT_EQ(exp(40 * a), pow(exp(a), 40));
  EXPECT_EQ(exp(Formula(1) / 2) * exp(Formula(1) / 2), exp(Formula(1)));
  EXPECT_FALSE(exp(a) == exp(b));
  EXPECT_FALSE(exp(a) == 1 + a);
  EXPECT_TRUE(((exp(2 * a) - 1) / (exp(a) + 1) - exp(a) + 1).is_zero());
}

TEST(FormulaExponential, HasTheValueOfTheLibrary) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> draw(0.1, 3);
  int tried = 0;
  for (int i = 0; i < 50; ++i) {
    const LetterValues at{{"a", draw(random)}, {"b", draw(random)}, {"c", draw(random) - 1.5}};
    const double x = at.at("a"), y = at.at("b"), z = at.at("c");
    const double value = std::exp(2 * x * z / y) * (1 - std::exp(-y * M_PI)) / (std::exp(x) + z * z);
    const Formula formula = exp(2 * a * c / b) * (1 - exp(-b * pi)) / (exp(a) + c * c);
    EXPECT_NEAR(value_at(formula, at), value, 1e-13 * std::abs(value));
    EXPECT_NEAR(static_cast<double>(long_value_at(formula, at)), value, 1e-13 * std::abs(value));
    ++tried;
  }
  EXPECT_EQ(tried, 50);
}

TEST(FormulaExponential, VariesAsItsDifferencesDo) {
  const Formula formula = exp(a * c) / (1 + exp(2 * a)), slope = derivative(formula, "a");
  constexpr double step = 1e-5;
  for (const double x : {0.3, 1.1, 2.4}) {
    const auto at = [&](double value) { return value_at(formula, {{"a", value}, {"c", -0.7}}); };
    EXPECT_NEAR(value_at(slope, {{"a", x}, {"c", -0.7}}), (at(x + step) - at(x - step)) / (2 * step), 1e-9);
  }
}

TEST(FormulaExponential, LogarithmsUndoPowersOfE) {
  EXPECT_EQ(ln(exp(2 * a - c)), 2 * a - c);
  EXPECT_EQ(exp(3 * ln(1 + a)), pow(1 + a, 3));
  // A high power is not multiplied out.
  const Formula high = exp(-100000000 * ln(1 + a));
  EXPECT_LE(high.terms(), 2U);
  EXPECT_NEAR(value_at(high, {{"a", 1e-8}}), std::exp(-1e8 * std::log1p(1e-8)), 1e-12);
  EXPECT_EQ(ln(Formula(1)), Formula());
  EXPECT_TRUE((ln(a * b) - ln(a) - ln(b)).is_zero());
  EXPECT_FALSE((ln(a + b) - ln(a)).is_zero());
  EXPECT_THROW(static_cast<void>(ln(-a)), std::domain_error);
  EXPECT_EQ(derivative(ln(1 + a * b), "a"), b / (1 + a * b));
  EXPECT_EQ(substituted(ln(1 + a), {{"a", exp(b) - 1}}), b);
  EXPECT_EQ(text(ln(1 + a) / 2), "ln(a + 1)/2");
  for (const double x : {1e-9, 0.5, 1e9}) {
    EXPECT_NEAR(value_at(ln(1 + a), {{"a", x}}) / std::log1p(x), 1, 1e-14);
    EXPECT_NEAR(static_cast<double>(long_value_at(ln(1 + a), {{"a", x}}) / std::log1p(x)), 1, 1e-14);
  }
}

TEST(FormulaExponential, TakesOtherValuesForItsLetters) {
  EXPECT_EQ(substituted(exp(a * b), {{"a", c / b}}), exp(c));
  EXPECT_EQ(substituted(exp(a * b), {{"a", Formula()}}), Formula(1));
  EXPECT_EQ(substituted(b * exp(a) - exp(2 * a), {{"b", exp(a)}}), Formula());
}

TEST(FormulaExponential, GivesItsExponentBack) {
  EXPECT_EQ(exponent_of(exp(3 * a - b / 2)).value(), 3 * a - b / 2);
  EXPECT_EQ(exponent_of(Formula(1)).value(), Formula());
  EXPECT_FALSE(exponent_of(2 * exp(a)).has_value());
  EXPECT_FALSE(exponent_of(a * exp(a)).has_value());
  EXPECT_FALSE(exponent_of(1 + exp(a)).has_value());
  EXPECT_FALSE(exponent_of(Formula()).has_value());
}

TEST(FormulaExponential, IsWrittenWithOneExponent) {
  EXPECT_EQ(text(exp(5 * pi * a / 6)), "exp(5*pi*a/6)");
  EXPECT_EQ(text(pow(exp(a / 2), 3)), "exp(3*a/2)");
  EXPECT_EQ(text(exp(2 * a)), "exp(2*a)");
  EXPECT_EQ(text(b * exp(pi * a)), "b*exp(pi*a)");
  EXPECT_EQ(text(exp(pi * a), Notation::tex), "\\mathrm{e}^{\\pi a}");
  EXPECT_EQ(text(exp(pi * a), Notation::c), "exp(M_PI*a)");
}

TEST(FormulaExponential, GrowsWithItsExponent) {
  EXPECT_EQ(seen_sign(exp(c)).sign, 1);
  EXPECT_EQ(seen_sign(exp(a) - 1).sign, 1);
  EXPECT_EQ(seen_sign(1 - exp(2 * a * b)).sign, -1);
  EXPECT_EQ(seen_sign(exp(a) - exp(-a)).sign, 1);
  EXPECT_EQ(seen_sign(exp(c) - 1).sign, 0);
  EXPECT_EQ(seen_sign(b * exp(a) - a).sign, 0);
}

}  // namespace
}  // namespace formula_exponential_test
}  // namespace poinsot
