// Common divisors and moved variables of polynomials, against FLINT's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/math/formula/formula_polynomial.h"

namespace poinsot::symbolic {
namespace formula_divisor_test {

constexpr std::size_t variables = 4;

Polynomial drawn(std::mt19937_64& random, int most_terms, std::size_t first, std::size_t end) {
  std::uniform_int_distribution<int> coefficient(-6, 6), power(0, 2), terms(1, most_terms);
  Polynomial p(variables);
  for (int i = terms(random); i > 0; --i) {
    std::vector<int> exponents(variables, 0);
    for (std::size_t v = first; v < end; ++v) exponents[v] = power(random);
    p.push(Integer(coefficient(random)), exponents);
  }
  p.tidy();
  return p;
}

Polynomial by_flint(const Polynomial& a, const Polynomial& b) {
  Polynomial c(variables);
  EXPECT_NE(fmpz_mpoly_gcd(c.get(), a.get(), b.get(), a.ring()), 0);
  return c;
}

TEST(CommonDivisor, OfProductsIsThatOfFlint) {
  std::mt19937_64 random(7);
  int numbers = 0, parts = 0, wholes = 0;
  for (int round = 0; round < 2000; ++round) {
    // Shared factors, powers of them, and factors in other variables.
    const Polynomial shared = drawn(random, round % 3 == 0 ? 1 : 4, 0, variables);
    const Polynomial a = drawn(random, 4, 0, round % 5 == 0 ? 2 : variables) * shared;
    const Polynomial b = round % 4 == 0 ? scaled(shared, Integer(6)) * shared
                                        : drawn(random, 3, round % 5 == 0 ? 2 : 0, variables) * shared;
    const Polynomial found = common_divisor(a, b);
    EXPECT_EQ(found, by_flint(a, b));
    EXPECT_EQ(found, common_divisor(b, a));
    numbers += found.is_constant();
    parts += !found.is_constant() && found.length() < std::min(a.length(), b.length());
    wholes += !found.is_constant() && found.length() == std::min(a.length(), b.length());
  }
  EXPECT_GT(numbers, 50);
  EXPECT_GT(parts, 100);
  EXPECT_GT(wholes, 100);
}

TEST(CommonDivisor, WhereOneHasMoreVariables) {
  std::mt19937_64 random(8);
  int powers = 0, contents = 0;
  for (int round = 0; round < 1000; ++round) {
    const Polynomial shared = drawn(random, 4, 0, 2);
    const Polynomial a = drawn(random, 5, 0, variables) * shared;
    const Polynomial b = round % 2 == 0 ? shared * shared : drawn(random, 3, 0, round % 3 == 0 ? 2 : 3) * shared;
    const Polynomial found = common_divisor(a, b);
    EXPECT_EQ(found, by_flint(a, b));
    EXPECT_EQ(found, common_divisor(b, a));
    powers += round % 2 == 0 && !found.is_constant();
    contents += found.is_constant() && !found.is_one() && !found.is_zero();
  }
  EXPECT_GT(powers, 100);
  EXPECT_GT(contents, 10);
}

TEST(CommonDivisor, OfNumbersAndZero) {
  const Polynomial zero(variables), x = Polynomial::variable(variables, 0);
  const auto number = [](slong value) { return Polynomial(variables, Integer(value)); };
  EXPECT_EQ(common_divisor(number(-12), number(18)), number(6));
  EXPECT_EQ(common_divisor(number(-12), scaled(x, Integer(8)) + number(20)), number(4));
  EXPECT_EQ(common_divisor(zero, scaled(x, Integer(-3))), scaled(x, Integer(3)));
  EXPECT_EQ(common_divisor(number(4), zero), number(4));
  EXPECT_TRUE(common_divisor(zero, zero).is_zero());
}

TEST(CommonDivisor, WhereTheLeadingCoefficientVanishesModuloThePrime) {
  // 2^61 - 1 times x y^2 + y + 1, and its square.
  const Polynomial x = Polynomial::variable(variables, 0), y = Polynomial::variable(variables, 1);
  const Polynomial p = scaled(x, Integer(2305843009213693951)) * y * y + y + Polynomial(variables, Integer(1));
  EXPECT_EQ(common_divisor(p * p, p * (x + y)), p);
  EXPECT_TRUE(common_divisor(p, p + Polynomial(variables, Integer(1))).is_one());
}

TEST(Moved, VariablesTakeTheirNewPlaces) {
  std::mt19937_64 random(11);
  const std::vector<std::vector<int>> places{{0, 1, 3, 5}, {2, 3, 4, 5}, {5, 0, 3, 1}, {3, 2, 1, 0}};
  for (int round = 0; round < 200; ++round) {
    const Polynomial p = drawn(random, 6, 0, variables);
    for (const std::vector<int>& place : places) {
      const std::vector<slong> map(place.begin(), place.end());
      Polynomial expected(6);
      fmpz_mpoly_compose_fmpz_mpoly_gen(expected.get(), p.get(), map.data(), p.ring(), expected.ring());
      EXPECT_EQ(p.moved(place, 6), expected);
    }
  }
}

TEST(Moved, WhatDoesNotOccurIsLeftOut) {
  const Polynomial y = Polynomial::variable(variables, 1), z = Polynomial::variable(variables, 2);
  EXPECT_EQ((y * y + z).moved({-1, 0, 1, -1}, 2),
            Polynomial::variable(2, 0) * Polynomial::variable(2, 0) + Polynomial::variable(2, 1));
  EXPECT_TRUE(Polynomial(variables, Integer(1)).moved({-1, -1, -1, -1}, 0).is_one());
}

}  // namespace formula_divisor_test
}  // namespace poinsot::symbolic
