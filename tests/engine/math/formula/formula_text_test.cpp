// Formulas as people write them: short, with the same value, the same however they were reached.
#include "poinsot/engine/math/formula/formula_text.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/math/formula/random_formulas.h"

namespace poinsot {
namespace formula_text_test {

using testing::RandomFormula;

Formula read(const std::string& text) { return testing::read_expression(text, testing::letters_of_any_sign); }

TEST(FormulaText, PrintsWhatPeopleRecognise) {
  const std::vector<std::pair<std::string, std::string>> formulas{
      {"0", "0"},
      {"-m", "-m"},
      {"1/12", "1/12"},
      {"0.15*m", "3*m/20"},
      {"m*r^2*w^2/4 + (4*m*L^2*r^2*w^2 + m*r^4*w^2)/(8*L^2)", "m*r^2*w^2*(6 + r^2/L^2)/8"},
      {"-m*w*r*(4*L^2 + r^2)/(4*L)", "-m*r*w*(L + r^2/(4*L))"},
      {"m*(3*r^2 + L^2)/12", "m*(L^2 + 3*r^2)/12"},
      {"-(x - m)*r", "r*(m - x)"},
      {"(-x - m)*r", "-r*(m + x)"},
      {"1/m + 1/M", "(M + m)/(M*m)"},
      {"pi*m*w*r^2/(2 + 2*pi)", "pi*m*r^2*w/(2*(pi + 1))"},
      {"m*r*w*sqrt(pi^2 + 16)/(2 + 2*pi)", "m*r*w*sqrt(pi^2 + 16)/(2*(pi + 1))"},
      {"pi - x", "pi - x"},
      {"sqrt(11)*m*L^2*w/12", "sqrt(11)*m*L^2*w/12"},
      {"7*L*m*w/(48*sqrt(2))", "7*sqrt(2)*m*L*w/96"},
      {"sqrt(g)/sqrt(r)", "sqrt(g/r)"},
      {"3/2*sqrt(3*g/r)", "3*sqrt(3*g/r)/2"},
      {"m/sqrt(m)", "sqrt(m)"},
      {"1/sqrt(m)", "1/sqrt(m)"},
      {"sqrt(x^2*m^2)", "m*sqrt(x^2)"},
      {"r/sqrt(r^2 + L^2)", "r/sqrt(L^2 + r^2)"},
      {"(sqrt(x^2 - 4*g*r) - x)/(2*r)", "(sqrt(x^2 - 4*g*r) - x)/(2*r)"},
      {"sqrt(6)*m + sqrt(m)*sqrt(r)", "sqrt(6)*m + sqrt(m*r)"},
      {"sin(b)*cos(b)*m*w^2", "m*w^2*sin(2*b)/2"},
      {"r*(m + x)*(m - x)", "r*(m^2 - x^2)"},
      {"m*w^2*(1 + x)*(1 - x)/8", "m*w^2*(1 - x^2)/8"},
      {"r*sqrt(L^2 + r^2)/(L^2 + r^2)^2", "r/((L^2 + r^2)*sqrt(L^2 + r^2))"},
      {"0.4*m*r*w^2 + 14.709975*m", "m*(2*r*w^2/5 + 14.709975)"},
      {"(sqrt(39.2266*m*L + x^2) - x)/(2*L)", "(sqrt(39.2266*m*L + x^2) - x)/(2*L)"},
      {"(L*(w*cos(b) + x)^2 + r*w^2*(1 - cos(b)^2) + 2*g*m*cos(b))/2",
       "(L*(w*cos(b) + x)^2 + r*w^2*sin(b)^2 + 2*m*g*cos(b))/2"},
      {"sin(b)*F - g*m*cos(b)", "F*sin(b) - m*g*cos(b)"},
      {"k^2*m", "m*k^2"},
      {"g*m*k", "k*m*g"},
      {"sin(a)^2*w", "w*sin(a)^2"},
      {"(1 - cos(2*a))*w", "2*w*sin(a)^2"},
      {"1 + cos(a)", "1 + cos(a)"},
      {"sin(a)/cos(a)", "tan(a)"},
      {"cos(b)/(2*m*sin(b))", "1/(2*m*tan(b))"},
      {"3*x/(m*L^2*sin(b)^2)", "3*x/(m*L^2*sin(b)^2)"},
      {"sin(a)*cos(b) + sin(b)*cos(a)", "sin(a + b)"},
      {"sin(a)*sin(b) + cos(b)*cos(a)", "cos(a - b)"},
      {"cos(a)*sin(b)", "cos(a)*sin(b)"},
      {"cos(a)^2 - sin(a)^2", "cos(2*a)"},
      {"3*sin(a) - 4*sin(a)^3", "sin(3*a)"},
      {"2*sin(a/4)*cos(a/4)", "sin(a/2)"},
      {"m*sin(a - b)^2 + M", "M + m*sin(a - b)^2"},
      {"g*cos(a) + r*w^2*sin(a)", "g*cos(a) + r*w^2*sin(a)"},
      {"r^2*sin(a)^2 + L^2*cos(a)^2", "(r^2 - L^2)*sin(a)^2 + L^2"},
      {"sqrt(1 + sin(a))", "sqrt(1 + sin(a))"},
      {"sqrt(L^2 + r^2*sin(a)^2)", "sqrt(L^2 + r^2*sin(a)^2)"},
      {"m*sin(25*pi/180)", "m*sin(5*pi/36)"},
      {"asin(w/2) + atan2(x, b)", "asin(w/2) + atan2(x, b)"}};
  for (const auto& [formula, expected] : formulas) EXPECT_EQ(text(read(formula)), expected) << formula;
}

// (5*W*s*v^2*(...)/g - 108*M*sin(a)/s - 90*M*cos(a)/s)/720 is as long, and is worse to read.
TEST(FormulaText, HasNoFractionsAboveANumber) {
  const std::string printed = text(read("W*s*v^2*(5*sin(a) - 6*cos(a))/(144*g) - 3*M*sin(a)/(20*s) - M*cos(a)/(8*s)"));
  EXPECT_EQ(printed.find("720"), std::string::npos) << printed;
  EXPECT_NE(printed.find("W*s*v^2*"), std::string::npos) << printed;
  EXPECT_NE(printed.find("/(144*g)"), std::string::npos) << printed;
}

// The count by which formulas of books are compared with these: half as long again and two is the limit.
TEST(FormulaText, IsNoLongerThanTheFormulasOfBooks) {
  const std::vector<std::string> formulas{"v*sin(a)*cos(a)",
                                          "v*sin(a)^2",
                                          "2*pi/(v*sin(a))",
                                          "6*J/(b*m)",
                                          "-w*r/L",
                                          "-m*w*r*(4*L^2 + r^2)/(4*L)",
                                          "m*w^2*r^2*(6*L^2 + r^2)/(8*L^2)",
                                          "m*r^2*(2*w1^2 + w2^2)/8",
                                          "pi*m*w^2*r^2/(4*(1 + pi))",
                                          "m*w*r^2*sqrt(pi^2 + 16)/(2*(1 + pi))",
                                          "m*g + m*r*(r/L)^2*w1^2/2",
                                          "-m*r^3*w1^2/(2*L^2)",
                                          "m*w^2*r^2*sin(2*b)/8",
                                          "3*M0/(L^2*m*sin(b)^2)",
                                          "M0/(2*L*tan(b))",
                                          "2*m*L^2*w1*w2*cos(a)^2/3",
                                          "-m*L^2*w2^2*sin(a)*cos(a)/3",
                                          "sqrt(3*g*sin(a)/L)",
                                          "m*L^2*(sin(a)^2 + 1/3)",
                                          "(C - A)*w1*cos(a)/A",
                                          "g*L*m/(C*w)",
                                          "(C*w - sqrt(C^2*w^2 - 4*A*m*g*L*cos(a)))/(2*A*cos(a))",
                                          "sqrt(3/2)*sqrt(g/(L*cos(a)))",
                                          "acos(3*g/(2*L*w^2))",
                                          "m*L^2*w^2*sin(a)*cos(a)/12 + m*g*L*cos(a)/2",
                                          "(m*g + 2*M*g)*sin(a)/(m + 2*M*sin(a)^2)",
                                          "m*w^2*(r*sin(a) + L*cos(a))*(r*cos(a) - L*sin(a))",
                                          "2*w*sqrt(r^2 + L^2)/3",
                                          "atan(r/L)",
                                          "L*(1 - cos(a)) + r*sin(a)",
                                          "M*m*g/(M + m)",
                                          "m1*m2*(v1 - v2)*(1 + k)/(m1 + m2)"};
  RandomFormula random(21);
  for (const std::string& formula : formulas) {
    const Formula x = testing::read_expression(formula);
    const std::string printed = text(x);
    EXPECT_LE(testing::count_operators(printed), 1.5 * testing::count_operators(formula) + 2)
        << formula << ": " << printed;
    for (int point = 0; point < 3; ++point) {
      LetterValues values;
      for (const std::string& letter : x.letters()) values[letter] = 0.2 + 0.001 * random.choice(1000);
      if (formula.find("acos") != std::string::npos) values["g"] = 0.01;
      if (formula.find("- 4*A") != std::string::npos) values["w"] = 30;
      const double expected = testing::read_value(formula, values);
      EXPECT_NEAR(testing::read_value(printed, values), expected, 1e-12 * (1 + std::abs(expected)))
          << formula << ": " << printed;
    }
  }
}

TEST(FormulaText, ComesBackAsTheSameExpression) {
  RandomFormula random(22);
  for (int trial = 0; trial < 150; ++trial) {
    const std::string formula = random.any(3);
    const Formula x = read(formula);
    const std::string printed = text(x);
    EXPECT_EQ(read(printed), x) << formula << ": " << printed;
    const LetterValues values = random.values();
    const double expected = value_at(x, values);
    EXPECT_NEAR(testing::read_value(printed, values), expected, 1e-9 * (1 + std::abs(expected))) << printed;
  }
}

// The number before a sum of sines and cosines may be negative; it stays under the root with its sign.
TEST(FormulaText, WritesRootsOfSumsWithANegativeNumber) {
  testing::RandomFormula random(24);
  int compared = 0;
  for (const char* formula : {"sqrt(196133*cos(a)/(x*sin(a) - 6*x - 3*x*cos(a)))", "sqrt(7*sin(a)/(2*x*cos(a) - 3*r))",
                              "sqrt(-588399*sin(a)/(2*r - 3*L*cos(a)))", "sqrt((3*x*cos(a) - 6*r)/(5*sin(a)))"}) {
    const std::string printed = text(read(formula));
    for (int point = 0; point < 40; ++point) {
      const LetterValues values = random.values();
      const double expected = testing::read_value(formula, values);
      if (std::isnan(expected)) continue;
      ++compared;
      EXPECT_NEAR(testing::read_value(printed, values), expected, 1e-9 * (1 + expected)) << formula << ": " << printed;
    }
  }
  EXPECT_GT(compared, 40);
}

TEST(FormulaText, DependsOnTheValueAlone) {
  RandomFormula random(23);
  for (int trial = 0; trial < 60; ++trial) {
    const std::string a = random.any(2);
    const std::string b = random.any(2);
    const std::string c = random.positive(1);
    EXPECT_EQ(text(read("(" + a + " + " + b + ")*(" + c + ")")),
              text(read("(" + c + ")*(" + b + ") + (" + a + ")*(" + c + ")")));
    EXPECT_EQ(text(read("(" + a + ") - (" + b + ")")), text(-read("(" + b + ") - (" + a + ")")));
    // By way of other angles.
    EXPECT_EQ(text(read(a) + read("sin(a/3)*cos(b/5)") - read("cos(b/5)*sin(a/3)")), text(read(a)));
    EXPECT_EQ(text((read(a) * read("sin(a/6)")) / read("2*sin(a/12)*cos(a/12)")), text(read(a)));
  }
}

// Short fractions are fractions; numbers of many digits are decimals with the digits that they carry.
TEST(FormulaText, PrintsTheDigitsThatNumbersCarry) {
  EXPECT_EQ(text(read("0.15*m")), "3*m/20");
  EXPECT_EQ(text(read("0.1234567*m")), "0.1234567*m");
  EXPECT_EQ(text(read("1.581333088067359*sqrt(g/r)")), "1.581333088067359*sqrt(g/r)");
  EXPECT_EQ(text(read("-1.581333088067359")), "-1.581333088067359");
  EXPECT_EQ(text(read("m/1.581333088067359")), "1000000000000000*m/1581333088067359");
  EXPECT_EQ(text(Formula(0.7312724241271303) * read("x")), "0.7312724241271303*x");
  EXPECT_EQ(text(Formula(0.7312724241271303) * read("x") + Formula(1.2345678901234567) * read("m")),
            "1.2345678901234567*m + 0.7312724241271303*x");
  EXPECT_EQ(text(Formula(1.2345678901234567e-30)), "1.2345678901234567e-30");
  EXPECT_EQ(text(read("123456789012345678901234567890*m")), "123456789012345678901234567890*m");
  EXPECT_EQ(text(read("m/123456789")), "m/123456789");
}

TEST(FormulaText, SpeaksOtherLanguages) {
  struct Spoken {
    std::string formula, c, python, sympy, tex;
  };
  const std::vector<Spoken> all{
      {"1/12", "1.0/12", "1/12", "Rational(1, 12)", "\\frac{1}{12}"},
      {"m*r^2/2", "m*r*r/2", "m*r**2/2", "m*r**2/2", "\\frac{m r^{2}}{2}"},
      {"1/(2*r^3)", "1/(2*r*r*r)", "1/(2*r**3)", "1/(2*r**3)", "\\frac{1}{2 r^{3}}"},
      {"1/r^2", "1/(r*r)", "1/r**2", "1/r**2", "\\frac{1}{r^{2}}"},
      {"m^7*(m + r)^2", "pow(m, 7)*pow(m + r, 2)", "m**7*(m + r)**2", "m**7*(m + r)**2",
       "m^{7} \\left(m + r\\right)^{2}"},
      {"pi*omega1*sin(a)^2", "M_PI*omega1*pow(sin(a), 2)", "pi*omega1*sin(a)**2", "pi*omega1*sin(a)**2",
       "\\pi \\omega_{1} \\sin^{2} a"},
      {"sqrt(m_2/Fdt)*acos(x/L)", "acos(x/L)*sqrt(m_2/Fdt)", "acos(x/L)*sqrt(m_2/Fdt)", "acos(x/L)*sqrt(m_2/Fdt)",
       "\\arccos\\left(\\frac{x}{L}\\right) \\sqrt{\\frac{m_{2}}{\\mathit{Fdt}}}"},
      {"m - cos(2*a)/3000000000", "m - cos(2*a)/3000000000.0", "m - cos(2*a)/3000000000", "m - cos(2*a)/3000000000",
       "m - \\frac{\\cos\\left(2 a\\right)}{3000000000}"},
  };
  for (const Spoken& spoken : all) {
    const Formula x = read(spoken.formula);
    EXPECT_EQ(text(x, Notation::c), spoken.c);
    EXPECT_EQ(text(x, Notation::python), spoken.python);
    EXPECT_EQ(text(x, Notation::sympy), spoken.sympy);
    EXPECT_EQ(text(x, Notation::tex), spoken.tex);
  }
}

// 9.81 of the data is typeset as it was written; what shapes leave stays a fraction.
TEST(FormulaText, DecimalsOfDataAreDecimalsInTex) {
  const std::vector<std::pair<std::string, std::string>> formulas{
      {"981*m/100", "9.81 m"},
      {"-2943*sin(a)/(200*m)", "-\\frac{14.715 \\sin a}{m}"},
      {"3*m*a^2/50", "0.06 m a^{2}"},
      {"(a + m)/400", "0.0025 \\left(a + m\\right)"},
      {"3*m*a^2/80", "\\frac{3 m a^{2}}{80}"},
      {"83*m*a^2/320", "\\frac{83 m a^{2}}{320}"},
      {"2*m/5", "\\frac{2 m}{5}"},
      {"38*a^2/(25*m)", "\\frac{38 a^{2}}{25 m}"},
      {"m/75", "\\frac{m}{75}"}};
  for (const auto& [formula, tex] : formulas) EXPECT_EQ(text(read(formula), Notation::tex), tex) << formula;
}

// Of a letter that may have either sign.
TEST(FormulaText, ASizeIsARootOfASquareExceptInTex) {
  const Formula x = Formula::letter("x", poinsot::Sign::real);
  EXPECT_EQ(text(sqrt(x * x)), "sqrt(x^2)");
  EXPECT_EQ(text(sqrt(x * x), Notation::tex), "\\left|x\\right|");
}

TEST(FormulaText, ForPeopleASizeIsNamed) {
  const std::vector<std::pair<std::string, std::string>> formulas{
      {"w*sqrt((L - m)^2)/L", "w*abs(L - m)/L"},  {"r*sqrt(x^2)", "r*abs(x)"},
      {"sqrt(sin(2*b)^2)", "abs(sin(2*b))"},      {"sqrt((m - r)^2) + r", "abs(m - r) + r"},
      {"x/sqrt((m - r)^2)", "x/abs(m - r)"},      {"sqrt(x^2 + r^2)", "sqrt(r^2 + x^2)"},
      {"m*sqrt((m - r)^3)", "m*sqrt((m - r)^3)"},
  };
  for (const auto& [formula, expected] : formulas)
    EXPECT_EQ(text(read(formula), Notation::with_sizes), expected) << formula;
}

// A factor and its sign, into which a size is taken apart, are written as the size again; whatever stands beside it.
TEST(FormulaText, SizesInSumsReadBack) {
  RandomFormula random(31);
  int named = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const std::string a = random.any(2), b = random.any(2), c = random.positive(1);
    const Formula x = read("sqrt((x - " + c + ")^2)*(" + a + ") + (" + b + ")");
    const std::string words = text(x, Notation::with_sizes);
    EXPECT_EQ(read(words), x) << words;
    named += words.find("abs(") != std::string::npos ? 1 : 0;
  }
  EXPECT_GE(named, 40);
}

}  // namespace formula_text_test
}  // namespace poinsot
