// Exact scalars: the laws of a field and the identities of functions, decided by the zero test; numbers of fifty digits
// as the road that shares nothing with it.
#include "poinsot/engine/math/formula/formula.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "engine/math/formula/random_formulas.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula_text.h"
#include "poinsot/engine/work/work.h"

namespace poinsot {
namespace formula_test {

using testing::Digits50;
using testing::RandomFormula;
using testing::read_digits;

Formula read(const std::string& text) { return testing::read_expression(text, testing::letters_of_any_sign); }

void expect_equal(const std::string& left, const std::string& right) {
  EXPECT_TRUE((read(left) - read(right)).is_zero())
      << left << " against " << right << ": " << text(read(left) - read(right));
  EXPECT_EQ(text(read(left)), text(read(right)));
}

TEST(Formula, NumbersAreExact) {
  EXPECT_EQ(Formula(1.0 / 12), Formula(1) / 12);
  EXPECT_EQ(Formula(-2.0 / 5), Formula(-2) / 5);
  EXPECT_EQ(Formula(0.1), Formula::number("0.1"));
  EXPECT_EQ(Formula(83.0 / 320), Formula::number("83/320"));
  EXPECT_EQ(Formula(1e6), Formula(1000000));
  EXPECT_EQ(Formula::number("-1.50e-3"), Formula(-3) / 2000);
  EXPECT_EQ(Formula::number("0.3048") * Formula::number("1e4"), Formula(3048));
  EXPECT_TRUE(Formula(0.0).is_zero());
  // No small fraction: the double as it stands.
  const double root = std::sqrt(2.0);
  EXPECT_EQ(Formula(root) * pow(Formula(2), 52), Formula(static_cast<long long>(std::ldexp(root, 52))));
  EXPECT_EQ(value_at(Formula(root), {}), root);
}

TEST(Formula, RefusesWhatIsNoNumber) {
  for (const char* digits : {"", "-", "1,5", "1e", "0x10", "3/0", "1/2/3", "1e5000", "two", " 1"}) {
    EXPECT_THROW(Formula::number(digits), std::invalid_argument) << digits;
  }
  EXPECT_THROW(Formula(std::numeric_limits<double>::infinity()), std::domain_error);
  EXPECT_THROW(Formula(std::numeric_limits<double>::quiet_NaN()), std::domain_error);
}

TEST(Formula, DoublesWithinTheBoundOfFractionsComeBack) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 2000; ++trial) {
    const double numerator = static_cast<double>(random() % 20000) - 10000;
    const double denominator = static_cast<double>(random() % 9999 + 1);
    EXPECT_EQ(Formula(numerator / denominator), Formula(static_cast<int>(numerator)) / static_cast<int>(denominator));
  }
}

TEST(Formula, DoublesAreTheirMantissasTimesPowersOfTwo) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  for (int trial = 0; trial < 500; ++trial) {
    // Of ordinary size some are the quotients of small numbers, too.
    const int exponent = (random() % 2 == 0 ? 1 : -1) * static_cast<int>(100 + random() % 200);
    const double number = std::ldexp(mantissa(random), exponent);
    // In halves, each of which a formula takes as a whole number.
    int power = 0;
    const double whole = std::ldexp(std::frexp(number, &power), 53), above = std::floor(whole / 0x1p27);
    const Formula two27(1 << 27);
    const Formula expected =
        (Formula(static_cast<int>(above)) * two27 + Formula(whole - above * 0x1p27)) * pow(Formula(2), power - 53);
    EXPECT_EQ(Formula(number), expected) << number;
    EXPECT_EQ(plain(Formula(number)), number);
  }
}

TEST(Formula, LawsOfAFieldHoldExactly) {
  RandomFormula random(11);
  for (int trial = 0; trial < 60; ++trial) {
    const Formula a = read(random.any(2));
    const Formula b = read(random.any(2));
    const Formula c = read(random.any(1));
    EXPECT_TRUE((a + b - b - a).is_zero());
    EXPECT_EQ((a + b) + c, a + (b + c));
    EXPECT_EQ(a * b, b * a);
    EXPECT_EQ((a * b) * c, a * (b * c));
    EXPECT_EQ(a * (b + c), a * b + a * c);
    EXPECT_EQ((a - b) * (a + b), a * a - b * b);
    if (!b.is_zero()) {
      EXPECT_EQ(a / b * b, a);
      EXPECT_EQ(b / b, Formula(1));
    }
    Formula sum = a;
    sum += b;
    sum -= c;
    sum *= b;
    EXPECT_EQ(sum, (a + b - c) * b);
  }
}

TEST(Formula, AgreesWithFiftyDigits) {
  RandomFormula random(12);
  int compared = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::string formula = random.any(3);
    const Formula x = read(formula);
    const LetterValues values = random.values();
    const Digits50 expected = read_digits(formula, values);
    const Digits50 found(digits_at(x, values, 48));
    EXPECT_LE(abs(found - expected), Digits50("1e-43") * (1 + abs(expected))) << formula << " as " << text(x);
    EXPECT_EQ(value_at(x, values), found.convert_to<double>()) << formula;
    ++compared;
  }
  EXPECT_EQ(compared, 200);
}

// Neither a zero that is missed nor one that is none.
TEST(Formula, IsZeroExactlyWhereFiftyDigitsAre) {
  RandomFormula random(13);
  int zeros = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const std::string a = "(" + random.any(2) + ")";
    const std::string b = "(" + random.any(2) + ")";
    const std::string c = "(" + random.positive(1) + ")";
    const std::vector<std::string> candidates{
        a + "*" + c + " + " + b + "*" + c + " - (" + a + " + " + b + ")*" + c,
        "(" + a + " + " + b + ")^2 - " + a + "^2 - 2*" + a + "*" + b + " - " + b + "^2",
        "sqrt(" + c + ")^2 - " + c,
        "sqrt(" + c + "*" + a + "^2)^2 - " + c + "*" + a + "^2",
        a + " - " + b,
        a + "/" + c + " - " + b + "/" + c,
        a + "*" + b + " - " + c,
        "1/(sqrt(" + c + ") + 2) - (sqrt(" + c + ") - 2)/(" + c + " - 4)"};
    const std::string formula =
        candidates[static_cast<std::size_t>(random.choice(static_cast<int>(candidates.size())))];
    const bool zero = read(formula).is_zero();
    zeros += zero ? 1 : 0;
    Digits50 largest(0);
    for (int point = 0; point < 3; ++point) {
      const Digits50 value = abs(read_digits(formula, random.values()));
      if (value > largest) largest = value;
    }
    EXPECT_EQ(zero, largest < Digits50("1e-40")) << formula << " is " << largest;
  }
  EXPECT_GT(zeros, 100);
  EXPECT_LT(zeros, 250);
}

TEST(Formula, KnowsTheIdentitiesOfSinesAndCosines) {
  expect_equal("sin(a)^2 + cos(a)^2", "1");
  expect_equal("sin(2*a)", "2*sin(a)*cos(a)");
  expect_equal("cos(2*a)", "1 - 2*sin(a)^2");
  expect_equal("sin(a + b)", "sin(a)*cos(b) + cos(a)*sin(b)");
  expect_equal("tan(a + b)", "(tan(a) + tan(b))/(1 - tan(a)*tan(b))");
  expect_equal("tan(a/2)", "sin(a)/(1 + cos(a))");
  expect_equal("sin(a/2)^2", "(1 - cos(a))/2");
  expect_equal("sin(3*a)", "3*sin(a) - 4*sin(a)^3");
  expect_equal("sin(a/2 + b/3)*cos(a/2 - b/3)", "(sin(a) + sin(2*b/3))/2");
  expect_equal("sin(m*r)^2 - 1", "-cos(r*m)^2");
  expect_equal("cos(a + pi/2)", "-sin(a)");
  expect_equal("sin(a + 7*pi)", "-sin(a)");
  expect_equal("sin(x*sqrt(m/r))", "sin(x*sqrt(m)/sqrt(r))");
  expect_equal("cos(-a)", "cos(a)");
}

TEST(Formula, KnowsSinesOfParts) {
  for (int k = -30; k <= 30; ++k) {
    const Formula angle = k * Formula::pi() / 12;
    EXPECT_TRUE(sin(angle).is_number());
    EXPECT_NEAR(value_at(sin(angle), {}), std::sin(k * std::acos(-1.0) / 12), 1e-14) << k;
    EXPECT_NEAR(value_at(cos(angle), {}), std::cos(k * std::acos(-1.0) / 12), 1e-14) << k;
    EXPECT_EQ(sin(angle) * sin(angle) + cos(angle) * cos(angle), Formula(1));
  }
  expect_equal("sin(pi/6)", "1/2");
  expect_equal("cos(pi/4)", "sqrt(2)/2");
  expect_equal("sin(pi/12)", "(sqrt(6) - sqrt(2))/4");
  // Angles without roots of their own are known by their digits.
  EXPECT_EQ(read("sin(50*pi/180)"), read("2*sin(25*pi/180)*cos(25*pi/180)"));
  EXPECT_EQ(read("8*sin(pi/18)^3 + 1"), read("6*sin(pi/18)"));
  EXPECT_EQ(read("cos(65*pi/180)"), read("sin(25*pi/180)"));
  EXPECT_EQ(abs(read("sin(4)")), read("-sin(4)"));
  EXPECT_EQ(read("sqrt(tan(2)^2)"), read("-tan(2)"));
  EXPECT_TRUE(read("sin(sqrt(2))").is_number());
  EXPECT_EQ(read("sin(2*sqrt(2))"), read("2*sin(sqrt(2))*cos(sqrt(2))"));
  EXPECT_FALSE(read("sin(25*pi/180) - 0.42261826174069943618697848964773").is_zero());
}

TEST(Formula, TakesRootsByFactors) {
  expect_equal("sqrt(12)", "2*sqrt(3)");
  expect_equal("sqrt(2)*sqrt(3)", "sqrt(6)");
  expect_equal("sqrt(1/2)", "sqrt(2)/2");
  expect_equal("sqrt(m^2*r)", "m*sqrt(r)");
  expect_equal("sqrt(m^2 + 2*m*r + r^2)", "m + r");
  expect_equal("sqrt(m/r)*sqrt(r/L)", "sqrt(m/L)");
  expect_equal("1/(1 + sqrt(2))", "sqrt(2) - 1");
  expect_equal("(m - r)/(sqrt(m) + sqrt(r))", "sqrt(m) - sqrt(r)");
  expect_equal("sqrt(5 + 2*sqrt(6))", "sqrt(2) + sqrt(3)");
  expect_equal("sqrt(3 - 2*sqrt(2))", "sqrt(2) - 1");
  expect_equal("sqrt(m + r + 2*sqrt(m*r))", "sqrt(m) + sqrt(r)");
  expect_equal("sqrt(r^2*sin(a)^2 + r^2*cos(a)^2)", "r");
  expect_equal("sqrt(1 - sin(a)^2)^2", "cos(a)^2");
  expect_equal("sqrt(x^2)^3", "x^2*sqrt(x^2)");
  expect_equal("sqrt(4*pi^2*r)", "2*pi*sqrt(r)");
  EXPECT_EQ(sqrt(read("x^2")), abs(read("x")));
  EXPECT_EQ(abs(read("x - 2*m")) * abs(read("2*m - x")), read("(x - 2*m)^2"));
  EXPECT_EQ(abs(read("-3*m/r")), read("3*m/r"));
  EXPECT_EQ(abs(read("sqrt(2) - 2")), read("2 - sqrt(2)"));
}

// Roots that depend on each other although none is a product of the others' factors with signs that are known.
TEST(Formula, SeesThatRootsDependOnEachOther) {
  EXPECT_EQ(read("sqrt(x*a)*sqrt(x*b)*sqrt(a*b)"), read("sqrt(x^2)*sqrt(a^2)*sqrt(b^2)"));
  EXPECT_EQ(read("sqrt(x)*sqrt(a)"), read("sqrt(x*a)"));
  EXPECT_FALSE(read("sqrt(x*a) - sqrt(x*b)").is_zero());
  EXPECT_EQ(read("sqrt(2 + sqrt(2))*sqrt(2 - sqrt(2))"), read("sqrt(2)"));
}

// The same root over an angle and over its half.
TEST(Formula, TakesRootsOfFunctionsOfAngles) {
  expect_equal("sqrt(L^2 + r^2*sin(2*a)^2) + sin(a)", "sin(a) + sqrt(4*r^2*sin(a)^2*cos(a)^2 + L^2)");
  expect_equal("sqrt(L^2 + r^2*sin(a)^2)*sin(a/2)/sin(a/2)", "sqrt(L^2 + r^2*(1 - cos(a)^2))");
  expect_equal("sqrt(1 + sin(a))", "sqrt((sin(a/2) + cos(a/2))^2)");
  expect_equal("sqrt(1 - cos(2*a))", "sqrt(2)*sqrt(sin(a)^2)");
  expect_equal("sqrt(1 + tan(a)^2)*sqrt(cos(a)^2)", "1");
  expect_equal("sqrt(sin(2*a)^2) - 2*sqrt(sin(a)^2)*sqrt(cos(a)^2)", "0");
}

TEST(Formula, TellsWhatItAssumes) {
  using List = std::vector<std::string>;
  EXPECT_EQ(read("sqrt(m^2*r^4)").assumptions(), List{"m > 0"});
  EXPECT_EQ((read("sqrt(m^2)") + read("sqrt(r^2)") * read("x")).assumptions(), (List{"m > 0", "r > 0"}));
  EXPECT_EQ(read("sqrt(x - m)/2").assumptions(), List{"x - m >= 0"});
  EXPECT_EQ((read("sqrt(x - m)") + read("sqrt(m^2)")).root_assumptions(), List{"x - m >= 0"});
  EXPECT_EQ(read("sqrt(x^2*m)").assumptions(), List{});
  EXPECT_EQ(read("sqrt(x^2 + x*m + m^2)").assumptions(), List{});
  EXPECT_EQ(read("m*x").assumptions(), List{});
}

TEST(Formula, KnowsInverseFunctions) {
  for (int k = -6; k <= 6; ++k) {
    const Formula angle = k * Formula::pi() / 12;
    EXPECT_EQ(asin(sin(angle)), angle) << k;
    if (std::abs(k) < 6) {
      EXPECT_EQ(atan(sin(angle) / cos(angle)), angle) << k;
    }
    const Formula turned = angle + Formula::pi() / 2;
    EXPECT_EQ(acos(cos(turned)), turned) << k;
  }
  for (int k = -11; k <= 12; ++k) {
    const Formula angle = k * Formula::pi() / 12;
    EXPECT_EQ(atan2(3 * sin(angle), 3 * cos(angle)), angle) << k;
  }
  expect_equal("sin(atan2(3*r, 4*r))", "3/5");
  expect_equal("cos(asin(m/(m + r)))", "sqrt(1 - (m/(m + r))^2)");
  expect_equal("tan(atan(x))", "x");
  expect_equal("sin(acos(x))^2", "1 - x^2");
  expect_equal("atan2(m*x, m)", "atan(x)");
  EXPECT_EQ(read("atan(1/2) + atan(1/3)"), read("pi/4"));
  EXPECT_EQ(read("cos(atan(x)/2)^2"), read("(1 + 1/sqrt(1 + x^2))/2"));
}

TEST(Formula, RefusesWhatHasNoValue) {
  EXPECT_THROW(read("1/(m - m)"), std::domain_error);
  EXPECT_THROW(read("1/(sin(a)^2 + cos(a)^2 - 1)"), std::domain_error);
  EXPECT_THROW(read("1/(sqrt(6) - sqrt(2)*sqrt(3))"), std::domain_error);
  EXPECT_THROW(read("tan(pi/2)"), std::domain_error);
  EXPECT_THROW(read("sqrt(-2*m - r)"), std::domain_error);
  EXPECT_THROW(read("sqrt(sqrt(2) - 2)"), std::domain_error);
  EXPECT_THROW(read("asin(2)"), std::domain_error);
  EXPECT_THROW(read("acos(-pi)"), std::domain_error);
  EXPECT_THROW(pow(Formula(0), -1), std::domain_error);
  const Formula positive = Formula::letter("k", Sign::positive);
  const Formula real = Formula::letter("k", Sign::real);
  EXPECT_THROW(positive + real, std::invalid_argument);
  EXPECT_THROW(value_at(positive, {{"m", 1}}), std::invalid_argument);
}

TEST(Formula, DerivativesAgreeWithDifferences) {
  RandomFormula random(14);
  for (int trial = 0; trial < 80; ++trial) {
    const std::string formula = random.any(3);
    const Formula x = read(formula);
    LetterValues values = random.values();
    for (const std::string letter : {"m", "a", "x"}) {
      const Digits50 slope(digits_at(derivative(x, letter), values, 30));
      const double step = 0x1p-30;
      LetterValues before = values;
      LetterValues after = values;
      before[letter] -= step;
      after[letter] += step;
      const Digits50 difference = (read_digits(formula, after) - read_digits(formula, before)) / Digits50(2 * step);
      // The error of a central difference is of the order of step^2 = 1e-18.
      EXPECT_LE(abs(slope - difference), Digits50("1e-12") * (1 + abs(slope))) << formula << " by " << letter;
    }
  }
  EXPECT_EQ(derivative(read("asin(x)"), "x"), read("1/sqrt(1 - x^2)"));
  EXPECT_EQ(derivative(read("acos(x)"), "x"), read("-1/sqrt(1 - x^2)"));
  EXPECT_EQ(derivative(read("atan2(x, b)"), "b"), read("-x/(x^2 + b^2)"));
  EXPECT_EQ(derivative(read("sqrt(x^2)"), "x"), read("sqrt(x^2)/x"));
}

TEST(Formula, SubstitutesNumbersAndFormulas) {
  RandomFormula random(15);
  for (int trial = 0; trial < 60; ++trial) {
    const std::string formula = random.any(3);
    const std::string inner = random.any(1);
    const LetterValues values = random.values();
    LetterValues composed = values;
    composed["x"] = read_digits(inner, values).convert_to<double>();
    const Formula x = substituted(read(formula), {{"x", read(inner)}});
    const double expected = read_digits(formula, composed).convert_to<double>();
    EXPECT_NEAR(value_at(x, values), expected, 1e-9 * (1 + std::abs(expected))) << formula << " with x = " << inner;
  }
  const auto with = [](const std::string& formula, const std::map<std::string, std::string>& values) {
    std::map<std::string, Formula> expressions;
    for (const auto& [name, value] : values) expressions[name] = read(value);
    return substituted(read(formula), expressions);
  };
  EXPECT_EQ(with("cos(a)/(2 + sin(a))", {{"a", "pi"}}), read("-1/2"));
  EXPECT_EQ(with("tan(a/2)*(1 + cos(a))", {{"a", "pi"}}), Formula(0));
  EXPECT_EQ(with("sin(a + b)", {{"a", "b"}, {"b", "a"}}), read("sin(a + b)"));
  EXPECT_EQ(with("m/r", {{"m", "r"}, {"r", "m"}}), read("r/m"));
  EXPECT_EQ(with("sqrt(m^2 + r^2)", {{"m", "3*L"}, {"r", "4*L"}}), read("5*L"));
  EXPECT_EQ(with("sqrt((x - m)^2)", {{"x", "m/2"}}), read("m/2"));
  EXPECT_EQ(with("atan2(x, b)", {{"x", "-m"}, {"b", "-m"}}), read("-3*pi/4"));
  EXPECT_THROW(with("1/(m - r)", {{"m", "r"}}), std::domain_error);
}

TEST(Formula, DecisionsLookAtAPlaceWhereNothingVanishesByChance) {
  EXPECT_EQ(plain(Formula(0)), 0);
  EXPECT_EQ(plain(read("1/4")), 0.25);
  EXPECT_NE(plain(read("m - r")), 0);
  EXPECT_NE(plain(read("sin(a)*cos(b) - x")), 0);
  EXPECT_EQ(plain(read("sin(2*a) - 2*sin(a)*cos(a)")), 0);
  EXPECT_GT(plain(read("sqrt(x - 3*m)")), 0);  // where the root exists
  EXPECT_TRUE(vanishes(read("m - m")));
  EXPECT_FALSE(vanishes(read("m - r")));
  EXPECT_TRUE(is_constant(read("pi*sqrt(2)")));
  EXPECT_FALSE(is_constant(read("m")));
  EXPECT_EQ(positive_sign(read("-m")), Formula(-1));
  EXPECT_TRUE(every_value(read("m"), [](double value) { return value > 0; }));
}

TEST(Formula, KnowsItsLetters) {
  EXPECT_EQ(read("r*sin(b*x)/sqrt(1 + m)").letters(), (std::vector<std::string>{"b", "m", "r", "x"}));
  EXPECT_TRUE(read("atan(m) - atan(m)").letters().empty());
  EXPECT_TRUE(read("(m + r)/(2*m + 2*r)").is_rational());
  EXPECT_TRUE(read("sqrt(2)*pi").is_number());
  EXPECT_FALSE(read("sqrt(2)*pi").is_rational());
}

TEST(Formula, StopsAtItsBounds) {
  const auto explode = [] {
    Formula product(1);
    for (int k = 0; k < 12; ++k) {
      Formula sum;
      for (int i = 0; i < 8; ++i) {
        sum += Formula::letter("u" + std::to_string(k) + std::to_string(i), Sign::real);
      }
      product *= sum;
    }
  };
  EXPECT_THROW(explode(), FormulaTooLarge);
  {
    const FormulaLimitScope scope({.terms = 3});
    EXPECT_THROW(read("(m + r + L + x)*(a + b)"), FormulaTooLarge);
    EXPECT_EQ(read("(m + r)*1").terms(), 3u);
  }
  {
    const FormulaLimitScope scope({.terms = 100, .work = 0});
    EXPECT_THROW(read("m*(m + r)"), FormulaTooLarge);
  }
  // In whatever step the work is done, also with the factors at hand, one of them a prime of more than a word.
  const Formula number = read("36*618970019642690137449562111"), m = read("m");
  for (int steps = 1; steps < 16; ++steps) {
    const FormulaLimitScope scope({.terms = 100, .work = 1'000'000});
    const auto late = [&] {
      for (int i = 0; i < steps; ++i) static_cast<void>(m * m);
      count_work(1'000'000);
      static_cast<void>(sqrt(number) * m);
    };
    EXPECT_THROW(late(), FormulaTooLarge);
  }
  // The limits around a scope hold again after it.
  {
    const FormulaLimitScope outer({.terms = 100, .work = 1'000'000});
    { const FormulaLimitScope inner({.terms = 100, .work = unlimited_work}); }
    count_work(1'000'000);
    EXPECT_THROW(read("m*(m + r)"), FormulaTooLarge);
  }
  EXPECT_EQ(read("(m + r)*(m - r)"), read("m^2 - r^2"));
  EXPECT_THROW(read("sin(1000*a)*cos(a)"), FormulaTooLarge);
}

TEST(Formula, GoesFromThreadToThread) {
  const Formula shared = read("sqrt(m)*sin(a)/(r + 123456789012345678901234567890)");
  std::vector<Formula> results(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < results.size(); ++i) {
    threads.emplace_back([&, i] { results[i] = shared * shared * Formula(static_cast<int>(i)); });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i], read("m*sin(a)^2/(r + 123456789012345678901234567890)^2") * static_cast<int>(i));
  }
}

// FLINT's sieve keeps its relations in a file in the current folder, under a name that threads share.
TEST(Formula, RootsOfLargeNumbersNeedNoFilesAndNoOtherThread) {
  EXPECT_EQ(read("sqrt(196133^2*1000000007*1000000009)"), read("196133*sqrt(1000000007*1000000009)"));
  EXPECT_EQ(read("sqrt(1000000007^2*1000000009^4)"), read("1000000007*1000000009^2"));
  EXPECT_EQ(read("sqrt(100000007*100000037*100000039)*sqrt(100000007*100000037*3)"),
            read("100000007*100000037*sqrt(100000039*3)"));
  std::vector<int> wrong(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < wrong.size(); ++i)
    threads.emplace_back([&, i] {
      for (int k = 0; k < 12; ++k) {
        const int own = static_cast<int>(i);
        const Formula number = (Formula(2147483647 - k) * Formula(2147483629 - own) + Formula(k)) * Formula(2147483587);
        const Formula root = sqrt(number);
        if (root * root != number) ++wrong[i];
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4));
  for (const auto& entry : std::filesystem::directory_iterator("."))
    EXPECT_EQ(entry.path().string().find("siqs"), std::string::npos) << entry.path();
}

}  // namespace formula_test
}  // namespace poinsot
