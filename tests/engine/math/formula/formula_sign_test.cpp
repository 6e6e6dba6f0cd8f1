// Signs of formulas: what is seen is held against values at random points.
#include "poinsot/engine/math/formula/formula_sign.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "poinsot/engine/math/formula/formula_decision.h"

namespace poinsot {
namespace formula_sign_test {

const Formula a = Formula::letter("a", Sign::positive), b = Formula::letter("b", Sign::positive);
const Formula c = Formula::letter("c", Sign::positive);
const Formula u = Formula::letter("u", Sign::real), v = Formula::letter("v", Sign::real);
const Formula w = Formula::letter("w", Sign::real);

TEST(SeenSign, OfDefiniteForms) {
  const auto is = [](const Formula& x, int sign, bool strict) {
    const SeenSign seen = seen_sign(x);
    return seen.sign == sign && seen.strict == strict;
  };
  EXPECT_TRUE(is(a + b, 1, true));
  EXPECT_TRUE(is(-a * b, -1, true));
  EXPECT_TRUE(is(u * u, 1, false));
  EXPECT_TRUE(is(u * u + a, 1, true));
  EXPECT_TRUE(is(u * u + u * v + v * v, 1, false));
  EXPECT_TRUE(is(u * u + u * v + v * v + a, 1, true));
  EXPECT_TRUE(is((u - v) * (u - v), 1, false));
  EXPECT_TRUE(is(a * a - a * b + b * b, 1, true));
  EXPECT_TRUE(is(-(u * u + v * v + w * w - u * v - v * w - w * u), -1, false));
  EXPECT_TRUE(is(sqrt(a + b) - sqrt(a), 1, true));
  EXPECT_TRUE(is(a - b, 0, false));
  EXPECT_TRUE(is(u, 0, false));
  EXPECT_TRUE(is(u * u - 3 * u * v + v * v, 0, false));
  EXPECT_TRUE(is(u * u * u * u - u * u + 1, 1, true));
  EXPECT_TRUE(is(u * u * v * v - pow(u, 4) - pow(v, 4), -1, false));
  EXPECT_TRUE(is(pow(u, 4) - 3 * u * u + 1, 0, false));
  EXPECT_TRUE(is(3 * cos(u) * cos(u) + 1, 1, true));
  EXPECT_TRUE(is(3 * cos(u) * cos(u) - 1, 0, false));
  // Where a leading coefficient vanishes nothing follows from the discriminant.
  EXPECT_EQ(seen_sign(u * u * v * v - a).sign, 0);
}

// The tensor of inertia of any body, by a triangular root of its second moments.
TEST(SeenSign, OfTheKineticEnergyOfAnyBody) {
  const Formula l[3][3] = {{a, 0, 0}, {u, b, 0}, {v, w, c}};
  Formula second[3][3];
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) second[i][k] += l[i][j] * l[k][j];
  const Formula trace = second[0][0] + second[1][1] + second[2][2];
  const Formula x = Formula::letter("x", Sign::real), y = Formula::letter("y", Sign::real);
  const Formula z = Formula::letter("z", Sign::real), rate[3] = {x, y, z};
  Formula energy = trace * (x * x + y * y + z * z);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) energy -= rate[i] * second[i][k] * rate[k];
  EXPECT_GE(seen_sign(energy).sign, 0);
}

Formula random_factor(std::mt19937_64& random) {
  const Formula letters[] = {a, b, c, u, v, w};
  const auto among = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  Formula sum;
  const int terms = among(1, 3);
  for (int i = 0; i < terms; ++i) {
    Formula term(among(-3, 3));
    for (int k = among(0, 2); k > 0; --k) {
      const Formula& letter = letters[among(0, 5)];
      term *= among(0, 2) == 0 ? letter : letter * letter;
    }
    sum += term;
  }
  return among(0, 6) == 0 ? sqrt(sum * sum + a) : sum;
}

TEST(SeenSign, IsThatOfTheValues) {
  std::mt19937_64 random(11);
  int seen_often = 0, strict_often = 0;
  for (int run = 0; run < 250; ++run) {
    Formula x = random_factor(random) * random_factor(random) + random_factor(random) * random_factor(random);
    if (run % 3 == 0) x += random_factor(random) * random_factor(random) * 2;
    if (x.is_zero()) continue;
    const SeenSign seen = seen_sign(x);
    const Formula part = sign_part(x, false), kept = sign_part(x, true);
    seen_often += seen.sign != 0;
    strict_often += seen.strict;
    for (int k = 0; k < 60; ++k) {
      LetterValues at;
      std::uniform_int_distribution<int> small(k % 4 == 0 ? 0 : -6, 6);
      for (const char* letter : {"u", "v", "w"}) at[letter] = small(random) / 2.0;
      for (const char* letter : {"a", "b", "c"}) at[letter] = (1 + std::abs(small(random))) / 3.0;
      const double value = value_at(x, at), of_part = value_at(part, at), of_kept = value_at(kept, at);
      EXPECT_GE(value * seen.sign, 0) << run;
      if (seen.strict) {
        EXPECT_NE(value, 0) << run;
      }
      if (value != 0) {
        EXPECT_GT(value * of_part, 0) << run;
        EXPECT_GT(value * of_kept, 0) << run;
      } else {
        EXPECT_EQ(of_kept, 0) << run;
      }
    }
  }
  EXPECT_GT(seen_often, 25);
  EXPECT_GT(strict_often, 8);
}

// Tangents of half angles, in which formulas are factored, are written as sines and cosines.
TEST(SignPart, IsWrittenInSinesAndCosines) {
  const Formula q = Formula::letter("q", Sign::real);
  const Formula cosine = cos(q) * a, mixed = (a * sin(q) - b) * sin(q) / (1 + cos(q));
  EXPECT_EQ(sign_part_in_sines(cosine, true), cos(q));
  const Formula part = sign_part_in_sines(mixed, true);
  EXPECT_TRUE((part / (sin(q) * (a * sin(q) - b))).is_number());
  for (double angle = -3; angle < 3.1; angle += 0.37) {
    const LetterValues at{{"q", angle}, {"a", 2}, {"b", 1.3}};
    EXPECT_GT(value_at(part, at) * value_at(mixed, at), 0) << angle;
  }
}

TEST(SignPart, OfAnAbsoluteValueOverItsArgumentIsThatOfTheArgument) {
  EXPECT_EQ(sign_part(abs(u * v) / v, false), Formula(1) * v);
  EXPECT_EQ(sign_part(abs(u) * abs(v) / (u * v), true), u * v);
}

TEST(AngleOfTwoSides, OfWhichOneIsZeroIsDecidedByTheOther) {
  for (const Formula& side : {u, -u}) {
    const DecisionScope decisions;
    EXPECT_EQ(atan2(Formula(), side), plain(side) > 0 ? Formula() : Formula::pi());
    ASSERT_EQ(decisions.signs().size(), 1u);
    EXPECT_EQ(decisions.signs()[0], side);
  }
}

TEST(VanishingFactors, AreWhereTheFormulaVanishes) {
  const std::vector<Formula> factors = vanishing_factors(3 * a * u * u * (v - w) * (b + c) / (a + u * u));
  ASSERT_EQ(factors.size(), 2U);
  EXPECT_TRUE(std::find(factors.begin(), factors.end(), u) != factors.end());
  EXPECT_TRUE(std::find_if(factors.begin(), factors.end(), [](const Formula& f) { return f == v - w || f == w - v; }) !=
              factors.end());
  EXPECT_TRUE(vanishing_factors(a * b / (u * u + c)).empty());
}

}  // namespace formula_sign_test
}  // namespace poinsot
