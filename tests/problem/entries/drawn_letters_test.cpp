#include "problem/entries/drawn_letters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace poinsot::problem {
namespace drawn_letters_test {

Letter letter_in(const char* name, const char* unit, bool either_sign = false) {
  Letter letter;
  letter.name = name;
  letter.unit = parse_unit(unit);
  letter.either_sign = either_sign;
  return letter;
}

TEST(DrawnLetters, AreTheSameForTheSameAttemptAndOthersForAnother) {
  const std::vector<Letter> letters{letter_in("m", "kg"), letter_in("a", "ft"), letter_in("w", "rad/s", true)};
  int changed = 0;
  for (int attempt = 0; attempt < 200; ++attempt) {
    EXPECT_EQ(draw_point(letters, attempt), draw_point(letters, attempt));
    changed += draw_point(letters, attempt) != draw_point(letters, attempt + 1);
    for (const auto& [name, value] : draw_point(letters, attempt)) {
      if (name == "w") continue;
      EXPECT_GT(value, 0) << name << " at attempt " << attempt;
    }
  }
  EXPECT_GT(changed, 180);
}

TEST(DrawnLetters, HaveTheSizeOfTheirUnitAndLeaveItWithTheSpread) {
  std::mt19937_64 random(1);
  const Letter length = letter_in("a", "ft"), angle = letter_in("theta", "deg");
  double least = 1, most = 1;
  for (int i = 0; i < 1000; ++i) {
    const double near = drawn_letter(length, random) / length.unit.factor;
    EXPECT_GE(near, 0.5);
    EXPECT_LE(near, 2);
    for (const int spread : {0, 1, 1000}) {
      const double turned = drawn_letter(angle, random, spread);
      EXPECT_GE(turned, 0.2);
      EXPECT_LE(turned, 1.2);
    }
    const double far = drawn_letter(length, random, 1000) / length.unit.factor;
    least = std::min(least, far);
    most = std::max(most, far);
  }
  EXPECT_GT(least, std::exp(-9.2) * (1 - 1e-12));
  EXPECT_LT(most, std::exp(9.2) * (1 + 1e-12));
  EXPECT_LT(least, 1e-3);
  EXPECT_GT(most, 1e3);
}

// Whatever the data, in units of the sizes found they are about one; and the sizes stay those of units where they can.
TEST(DrawnLetters, AreDrawnAtTheSizeOfTheData) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> decades(-9, 9), part(0.5, 2);
  for (int i = 0; i < 200; ++i) {
    const double length = std::pow(10, decades(random)), mass = std::pow(10, decades(random)),
                 time = std::pow(10, decades(random));
    std::vector<std::pair<double, Dimension>> data{{part(random) * length / (time * time), dimensions::acceleration},
                                                   {part(random) * mass, dimensions::mass},
                                                   {part(random), dimensions::angle}};
    if (i % 2 == 0) data.emplace_back(part(random) * length, dimensions::length);
    const DrawnSizes sizes = drawn_sizes(data);
    const bool far = std::ranges::any_of(data, [](const auto& datum) { return std::abs(std::log10(datum.first)) > 4; });
    for (const auto& [value, dimension] : data) {
      const double beside = std::abs(std::log10(value / sizes.of(dimension)));
      EXPECT_LT(far ? beside : std::abs(sizes.of(dimension) - 1), 1.9) << value;
      EXPECT_TRUE(far || sizes.of(dimension) == 1);
    }
    if (far && i % 2 == 0) {
      EXPECT_NEAR(std::log10(time / sizes.time), 0, 1.5);
    }
    const std::vector<Letter> letters{letter_in("k", "N/m"), letter_in("w", "rad/s", true)};
    for (int attempt = 0; attempt < 20; ++attempt) {
      const Point plain = draw_point(letters, attempt), drawn = draw_point(letters, attempt, sizes);
      for (const Letter& letter : letters)
        EXPECT_DOUBLE_EQ(drawn.at(letter.name), plain.at(letter.name) * sizes.of(letter.unit.dimension));
    }
  }
}

TEST(DrawnLetters, StayNearAValueThatMadeSense) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 100; ++i) {
    const double value = drawn_near(-3, random);
    EXPECT_LE(value, -3 * 0.8);
    EXPECT_GE(value, -3 * 1.25);
  }
}

}  // namespace drawn_letters_test
}  // namespace poinsot::problem
