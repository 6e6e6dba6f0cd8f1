// A constant as a factor by itself: the same value, in the words that people recognise.
#include "poinsot/engine/math/formula/formula_constant.h"

#include <gtest/gtest.h>

#include "engine/math/formula/random_formulas.h"

namespace poinsot {
namespace formula_constant_test {

// With gravity by its number.
Formula read(const std::string& text) {
  return testing::FormulaReader<Formula>(
             text,
             [](const std::string& name) {
               if (name == "g") return Formula::number("9.80665");
               return testing::read_expression(name, testing::letters_of_any_sign);
             },
             [](const std::string& digits) { return Formula::number(digits); })
      .read();
}
std::string written(const std::string& formula) { return text_with_constant(read(formula), "9.80665"); }

TEST(FormulaConstant, StandsAsAFactorByItself) {
  EXPECT_EQ(written("5/2*m*g"), "5*m*9.80665/2");
  EXPECT_EQ(written("-3*g/(2*L)"), "-3*9.80665/(2*L)");
  EXPECT_EQ(written("sqrt(2*g*r)"), "sqrt(2*9.80665*r)");
  EXPECT_EQ(written("L/g"), "L/9.80665");
  EXPECT_EQ(written("x*sqrt(L/g)"), "x*sqrt(L/9.80665)");
  EXPECT_EQ(written("m*g^2/3"), "m*9.80665^2/3");
  EXPECT_EQ(written("m*(g*r + x^2/2)"), "m*(9.80665*r + x^2/2)");
  EXPECT_EQ(written("sqrt(x^2 - 2*g*r)"), "sqrt(x^2 - 2*9.80665*r)");
  EXPECT_EQ(written("acos(g/(r*x^2))"), "acos(9.80665/(r*x^2))");
  EXPECT_EQ(written("0.35*m*g"), "7*m*9.80665/20");
}

TEST(FormulaConstant, LeavesOtherNumbersAsTheyAre) {
  EXPECT_EQ(written("28019*m"), "28019*m");
  EXPECT_EQ(written("(g + 3)*m"), "12.80665*m");
  EXPECT_EQ(written("7*m/5"), "7*m/5");
  EXPECT_EQ(text_with_constant(read("49*m/10"), "9.8"), "49*m/10");
}

// The letter m stands for gravity in formulas at random; what is written reads back as the very same formula.
TEST(FormulaConstant, KeepsTheValueExactly) {
  testing::RandomFormula random(29);
  int with_constant = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::string formula = random.any(3);
    for (std::size_t at = formula.find('m'); at != std::string::npos; at = formula.find('m', at + 1)) formula[at] = 'g';
    const Formula x = read(formula);
    const std::string words = text_with_constant(x, "9.80665");
    EXPECT_EQ(read(words), x) << formula << ": " << words;
    with_constant += words.find("9.80665") != std::string::npos ? 1 : 0;
  }
  EXPECT_GE(with_constant, 25);
}

}  // namespace formula_constant_test
}  // namespace poinsot
