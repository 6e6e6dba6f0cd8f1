// Values of formulas by long doubles, against those by balls of many digits.
#include "poinsot/engine/math/formula/certain_value.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

namespace poinsot::certain_value_test {
namespace {

Formula letter(const char* name) { return Formula::letter(name, Sign::real); }

// Formulas with every kind of generator.
Formula random_formula(std::mt19937_64& random, int depth) {
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
  if (depth == 0) {
    if (pick(4) == 0) return Formula(pick(7) - 3);
    return letter(std::array{"a", "b", "c"}[static_cast<std::size_t>(pick(3))]);
  }
  const Formula x = random_formula(random, depth - 1), y = random_formula(random, depth - 1);
  switch (pick(9)) {
    case 0:
      return x + y;
    case 1:
      return x - y;
    case 2:
      return x * y;
    case 3:
      return x / (y * y + Formula(1));
    case 4:
      return sqrt(x * x + y * y + Formula(2));
    case 5:
      return sin(letter("a"));
    case 6:
      return atan2(x, y * y + Formula(1));
    case 7:
      return acos(x / sqrt(x * x + y * y + Formula(3)));
    default:
      return tan(letter("b")) * x;
  }
}

TEST(CertainValue, IsTheDoubleNearestToManyDigits) {
  std::mt19937_64 random(20);
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const Formula x = random_formula(random, 1 + i % 3);
    const auto draw = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(random); };
    LetterValues at{{"a", draw(3)}, {"b", draw(1)}, {"c", draw(i % 2 == 0 ? 3 : 1e6)}};
    if (i % 7 == 0) at["c"] = at["a"];
    const double digits = std::strtod(digits_at(x, at, 80).c_str(), nullptr);
    EXPECT_EQ(value_at(x, at), digits) << i;
    EXPECT_NEAR(near_value_at(x, at), digits, 2e-13 * std::abs(digits)) << i;
    const std::optional<double> certain = certain_value_at(x, at);
    ASSERT_TRUE(certain) << i;
    EXPECT_EQ(*certain, digits) << i;
    ++compared;
  }
  EXPECT_EQ(compared, 400);
}

// 1e-30 beside one is lost by long doubles, and told by digits.
TEST(CertainValue, SeesWhatRoundingHides) {
  const Formula a = letter("a"), b = letter("b");
  const LetterValues at{{"a", 1}, {"b", 1e-30}};
  EXPECT_EQ(certain_value_at((a + b) * (a + b) - a * a - Formula(2) * a * b, at), 1e-30 * 1e-30);
  EXPECT_EQ(certain_value_at(sqrt(a * a + b) - a, at), 0.5 * 1e-30);
}

TEST(CertainValue, IsZeroOnlyIfItIs) {
  const Formula a = letter("a"), b = letter("b");
  EXPECT_EQ(certain_value_at(a * a - b, {{"a", 0.5}, {"b", 0.25}}), 0.0);
  EXPECT_EQ(certain_value_at(a * a - b, {{"a", 0.1}, {"b", 0.1 * 0.1}}), std::fma(0.1, 0.1, -(0.1 * 0.1)));
  // Balls of any number of digits hold zero here.
  EXPECT_EQ(certain_value_at(sqrt(a) - b, {{"a", 4}, {"b", 2}}), 0.0);
  EXPECT_FALSE(certain_value_at(sin(a) * sin(a) + cos(b) * cos(b) - Formula(1), {{"a", 1}, {"b", 1}}));
}

TEST(CertainValue, IsNothingWhereThereIsNone) {
  const Formula a = letter("a"), b = letter("b");
  EXPECT_FALSE(certain_value_at(b / a, {{"a", 0}, {"b", 1}}));
  EXPECT_FALSE(certain_value_at(sqrt(a), {{"a", -1}}));
  EXPECT_TRUE(std::isnan(near_value_at(b / a, {{"a", 0}, {"b", 1}})));
  EXPECT_THROW(certain_value_at(b, {{"a", 0}}), std::invalid_argument);
  EXPECT_THROW(near_value_at(b, {{"a", 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace poinsot::certain_value_test
