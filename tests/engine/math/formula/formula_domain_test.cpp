// Bounds on angles that are inverse functions, without these: held against numbers.
#include "poinsot/engine/math/formula/formula_domain.h"

#include <gtest/gtest.h>

#include "engine/math/formula/random_formulas.h"

namespace poinsot {
namespace formula_domain_test {

Formula read(const std::string& text) { return testing::read_expression(text, testing::letters_of_any_sign); }

TEST(FormulaDomain, IsThatOfTheArguments) {
  const auto all = [](const std::string& formula) {
    std::string words;
    for (const Formula& one : not_negative_in_domain(read(formula))) words += text(one) + "; ";
    return words;
  };
  EXPECT_EQ(all("acos(x)"), "1 - x; x + 1; ");
  EXPECT_EQ(all("m*asin(r/L) + acos(r/L)^2"), "(L - r)/L; ");
  EXPECT_EQ(all("sqrt(asin(x) + 2)"), "1 - x; x + 1; ");
  EXPECT_EQ(all("atan(x) + m"), "");
  EXPECT_EQ(all("acos(r/(r + L))"), "");
}

TEST(FormulaDomain, BoundsOfAnglesAreBoundsOfTheirFunctions) {
  EXPECT_EQ(bound_without_inverse(read("pi/2 - acos(x/r)")), read("x/r"));
  EXPECT_EQ(bound_without_inverse(read("2*acos(x) - pi/3")), read("sqrt(3)/2 - x"));
  EXPECT_EQ(bound_without_inverse(read("acos(x)")), read("1 - x"));
  EXPECT_EQ(bound_without_inverse(read("4 - acos(x)")), Formula(1));
  EXPECT_EQ(bound_without_inverse(read("pi/2 - 2*atan(x)")), read("1 - x"));
  EXPECT_EQ(bound_without_inverse(read("pi - 2*atan(x)")), Formula(1));
  EXPECT_EQ(bound_without_inverse(read("asin(x) - pi/6")), read("x - 1/2"));
  for (const char* other : {"m - acos(x)", "acos(x)^2 - 1", "acos(x) - asin(r)", "x", "acos(x) - 4", "acos(x) - 1"})
    EXPECT_EQ(bound_without_inverse(read(other)), read(other)) << other;
}

// Wherever the angle has a value, both conditions are true or both are false.
TEST(FormulaDomain, BoundsHoldAtTheSameNumbers) {
  testing::RandomFormula random(31);
  const std::vector<std::string> functions{"asin", "acos", "atan"};
  int held = 0, broken = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const double slope = (random.choice(9) - 4) / 2.0;
    const Formula rest = Formula(random.choice(29) - 14) * Formula::pi() / 12;
    if (slope == 0) continue;
    const Formula x = Formula(slope) * read(functions[static_cast<std::size_t>(random.choice(3))] + "(x*r/L)") + rest;
    const Formula bound = bound_without_inverse(x);
    LetterValues values = random.values();
    const double value = value_at(x, values);
    if (std::isnan(value)) continue;
    EXPECT_EQ(value > 0, value_at(bound, values) > 0) << text(x) << ", " << text(bound);
    ++(value > 0 ? held : broken);
  }
  EXPECT_GT(held, 100);
  EXPECT_GT(broken, 100);
}

}  // namespace formula_domain_test
}  // namespace poinsot
