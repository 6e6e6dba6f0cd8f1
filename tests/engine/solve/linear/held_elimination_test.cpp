#include "engine/solve/linear/held_elimination.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poinsot::solve {
namespace held_elimination_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(std::mt19937_64& random, Index rows, Index columns) {
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&](Index, Index) { return normal(random); });
}

std::optional<Remainder> remainder_of(const HeldPivots& pivots, const MatrixXd& A, const VectorXd& b) {
  return solve::remainder_of(pivots, A, b, b.cwiseAbs());
}

TEST(HeldElimination, TheRemainderVanishesJustWhereTheEquationsCanBeSatisfied) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 1000; ++trial) {
    const Index m = 3 + trial % 5, n = 1 + trial % 4, rank = std::min({m - 1, n, Index{1} + trial % 3});
    const HeldPivots pivots = pivots_of(random_matrix(random, m, rank) * random_matrix(random, rank, n));
    ASSERT_EQ(pivots.rank, rank);
    const MatrixXd A = random_matrix(random, m, rank) * random_matrix(random, rank, n);
    const VectorXd y = random_matrix(random, n, 1), b = A * y;
    const auto solvable = remainder_of(pivots, A, b);
    ASSERT_TRUE(solvable);
    EXPECT_EQ(solvable->values.size(), m - rank);
    EXPECT_LT(solvable->values.norm(), 1e-9 * solvable->size);
    EXPECT_LT((A * solvable->solution - b).norm(), 1e-6 * (1 + A.norm() * solvable->solution.norm()));
    // Off the range of A, by the projection on its complement.
    VectorXd off = random_matrix(random, m, 1);
    off -= A * A.completeOrthogonalDecomposition().solve(off);
    const auto contradictory = remainder_of(pivots, A, b + off);
    ASSERT_TRUE(contradictory);
    EXPECT_GT(contradictory->values.norm(), 1e-6 * contradictory->size);
  }
}

TEST(HeldElimination, WithOneEquationTooManyItIsTheDeterminantOfTheBorderedMatrix) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 1000; ++trial) {
    const Index n = 1 + trial % 6;
    const MatrixXd reference = random_matrix(random, n + 1, n), A = random_matrix(random, n + 1, n);
    const VectorXd b = random_matrix(random, n + 1, 1), b_reference = random_matrix(random, n + 1, 1);
    const HeldPivots pivots = pivots_of(reference);
    const auto at_reference = remainder_of(pivots, reference, b_reference), there = remainder_of(pivots, A, b);
    ASSERT_TRUE(at_reference && there);
    const auto bordered = [](const MatrixXd& matrix, const VectorXd& right) {
      MatrixXd C(matrix.rows(), matrix.cols() + 1);
      C << matrix, right;
      return C.determinant();
    };
    const double expected = bordered(A, b) * at_reference->values[0], scale = bordered(reference, b_reference);
    EXPECT_NEAR(there->values[0] * scale, expected, 1e-9 * (std::abs(expected) + std::abs(there->size * scale)));
  }
}

TEST(HeldElimination, WhereAPivotVanishesTheRemainderPassesSmoothly) {
  // y (x - 1) = 2, y = x: solvable for x^2 - x - 2 = 0; the first equation is the pivot's at x = 11.
  const auto A = [](double x) { return MatrixXd{{x - 1}, {1.0}}; };
  const auto b = [](double x) { return VectorXd{{2.0, x}}; };
  const HeldPivots pivots = pivots_of(A(11));
  for (const double x : {-3.0, 0.0, 0.99, 1.01, 1.000001, 2.0, 5.0})
    EXPECT_NEAR(remainder_of(pivots, A(x), b(x))->values[0], (x * (x - 1) - 2) / 10, 1e-12) << x;
}

// Polynomials of the second degree in t: differences of the fourth order are exact for A, b, and far better than the
// tolerance for what is made of them.
TEST(HeldElimination, RatesAreThoseOfValuesAndSolution) {
  std::mt19937_64 random(5);
  int tried = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Index n = 1 + trial % 5, m = n + trial % 4, rank = std::max(Index{1}, n - trial % 2);
    const MatrixXd mixing = random_matrix(random, rank, n);
    std::vector<MatrixXd> A;
    std::vector<VectorXd> b;
    for (int k = 0; k < 3; ++k) {
      A.push_back(random_matrix(random, m, rank) * mixing);
      b.push_back(random_matrix(random, m, 1));
    }
    const auto A_at = [&](double t) { return MatrixXd(A[0] + t * A[1] + t * t * A[2]); };
    const auto b_at = [&](double t) { return VectorXd(b[0] + t * b[1] + t * t * b[2]); };
    const HeldPivots pivots = pivots_of(random_matrix(random, m, rank) * mixing);
    const auto here = remainder_of(pivots, A_at(0), b_at(0));
    ASSERT_TRUE(here);
    if (here->solution.norm() > 30) continue;  // a pivot of other systems that is small here
    ++tried;
    const RemainderRates rates = remainder_rates(pivots, A[0], *here, A[1], b[1]);
    VectorXd values = VectorXd::Zero(m - rank), solution = VectorXd::Zero(n);
    constexpr double h = 1e-4;
    for (const auto& [step, weight] : {std::pair{1, 8.0}, {-1, -8.0}, {2, -1.0}, {-2, 1.0}}) {
      const auto there = remainder_of(pivots, A_at(step * h), b_at(step * h));
      ASSERT_TRUE(there);
      values += weight / (12 * h) * there->values;
      solution += weight / (12 * h) * there->solution;
    }
    EXPECT_LE((rates.values - values).norm(), 1e-8 * (here->size + values.norm())) << trial;
    EXPECT_LT((rates.solution - solution).norm(), 1e-6 * (1 + solution.norm())) << trial;
  }
  EXPECT_GT(tried, 500);
}

TEST(HeldElimination, AHigherRankThanThatOfThePivotsHasNoRemainder) {
  const HeldPivots pivots = pivots_of(MatrixXd{{1, 1}, {1, 1}, {2, 2}});
  EXPECT_EQ(pivots.rank, 1);
  EXPECT_FALSE(remainder_of(pivots, MatrixXd{{1, 1}, {1, 2}, {2, 2}}, VectorXd{{1, 2, 3}}));
  EXPECT_TRUE(remainder_of(pivots, MatrixXd{{1, 2}, {1, 2}, {2, 4}}, VectorXd{{1, 2, 3}}));
}

TEST(HeldElimination, OtherSizesAndNumbersThatAreNotFiniteHaveNoRemainder) {
  const HeldPivots pivots = pivots_of(MatrixXd{{1.0}, {2.0}});
  EXPECT_FALSE(remainder_of(pivots, MatrixXd{{1.0}, {2.0}, {3.0}}, VectorXd{{1, 2, 3}}));
  EXPECT_FALSE(remainder_of(pivots, MatrixXd{{std::nan("")}, {2.0}}, VectorXd{{1, 2}}));
}

TEST(HeldElimination, EquationsWithoutUnknownsRemainAsTheyAre) {
  const HeldPivots pivots = pivots_of(MatrixXd::Zero(2, 3));
  EXPECT_EQ(pivots.rank, 0);
  const auto left = remainder_of(pivots, MatrixXd::Zero(2, 3), VectorXd{{4, -5}});
  ASSERT_TRUE(left);
  EXPECT_EQ(left->values, (VectorXd{{4, -5}}));
}

}  // namespace held_elimination_test
}  // namespace poinsot::solve
