// What is left of overdetermined equations when all unknowns are eliminated with held pivots.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "poinsot/engine/solve/linear/linear_system.h"

namespace poinsot::solve {
namespace linear_elimination_test {

constexpr std::size_t unknowns = 4, laws = 4, facts = 3;

// Four laws for four unknowns, and three facts that hold when `off` is zero.
LinearSystem random_system(std::mt19937_64& random, double off) {
  std::uniform_real_distribution<double> draw(-1, 1);
  std::vector<double> x;
  for (std::size_t j = 0; j < unknowns; ++j) x.push_back(draw(random));
  LinearSystem system;
  for (std::size_t j = 0; j < unknowns; ++j)
    system.add_unknown("x" + std::to_string(j), std::pow(10, 3.0 * draw(random)));
  for (std::size_t i = 0; i < laws + facts; ++i) {
    system.add_equation((i < laws ? "law " : "fact ") + std::to_string(i));
    double right = 0;
    for (std::size_t j = 0; j < unknowns; ++j) {
      const double a = draw(random);
      system.add(i, j, a);
      right += a * x[j];
    }
    system.add_right_side(i, right + (i == laws + facts - 1 ? off : 0));
  }
  return system;
}

std::vector<bool> facts_late() {
  std::vector<bool> late(laws + facts, false);
  for (std::size_t i = laws; i < laws + facts; ++i) late[i] = true;
  return late;
}

TEST(LinearElimination, FactsAreLeftOverAndVanishWhereTheyHold) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    const LinearElimination held(random_system(random, 0), facts_late());
    ASSERT_EQ(held.rank(), unknowns);
    const auto holds = held.remainder(random_system(random, 0)), fails = held.remainder(random_system(random, 1));
    ASSERT_TRUE(holds && fails);
    ASSERT_EQ(holds->values.size(), facts);
    for (std::size_t i = 0; i < facts; ++i) {
      EXPECT_GE(holds->equations[i], laws);
      EXPECT_LT(std::abs(holds->values[i]), 1e-9 * holds->size);
      // Only the last fact is off.
      if (fails->equations[i] == laws + facts - 1)
        EXPECT_GT(std::abs(fails->values[i]), 0);
      else
        EXPECT_LT(std::abs(fails->values[i]), 1e-9 * fails->size);
    }
  }
}

TEST(LinearElimination, AFactIsAPivotWhereTheLawsDoNotSuffice) {
  LinearSystem system;
  system.add_unknown("x");
  system.add_unknown("y");
  for (const char* words : {"law", "same law", "fact", "same fact"}) system.add_equation(words);
  system.add(0, 0, 1);
  system.add(1, 0, 2);
  system.add(2, 1, 1);
  system.add(3, 1, 3);
  const LinearElimination held(system, {false, false, true, true});
  EXPECT_EQ(held.rank(), 2U);
  const auto left = held.remainder(system);
  ASSERT_TRUE(left);
  ASSERT_EQ(left->equations.size(), 2U);
  EXPECT_LT(std::min(left->equations[0], left->equations[1]), 2U);
  EXPECT_GE(std::max(left->equations[0], left->equations[1]), 2U);
}

TEST(LinearElimination, SystemsOfAnotherFormOrWithoutNumbersHaveNone) {
  std::mt19937_64 random(8);
  const LinearElimination held(random_system(random, 0), facts_late());
  LinearSystem other = random_system(random, 0);
  other.add_equation("one more");
  EXPECT_FALSE(held.remainder(other));
  LinearSystem infinite = random_system(random, 0);
  infinite.add(0, 0, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(held.remainder(infinite));
  const LinearElimination nothing(LinearSystem{});
  const auto left = nothing.remainder(LinearSystem{});
  ASSERT_TRUE(left);
  EXPECT_TRUE(left->values.empty());
}

}  // namespace linear_elimination_test
}  // namespace poinsot::solve
