#include "engine/solve/linear/linear_program.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <random>

namespace poinsot::solve {
namespace linear_program_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Every corner of what the equations allow: choices of as many unknowns as there are equations, all others zero.
std::optional<double> best_corner(const MatrixXd& A, const VectorXd& b, const VectorXd& c) {
  std::optional<double> best;
  std::vector<bool> chosen(static_cast<std::size_t>(A.cols()), false);
  std::fill_n(chosen.begin(), A.rows(), true);
  do {
    MatrixXd B(A.rows(), A.rows());
    std::vector<Index> columns;
    for (Index k = 0; k < A.cols(); ++k)
      if (chosen[static_cast<std::size_t>(k)]) {
        B.col(static_cast<Index>(columns.size())) = A.col(k);
        columns.push_back(k);
      }
    const Eigen::FullPivLU<MatrixXd> lu(B);
    if (!lu.isInvertible()) continue;
    const VectorXd x = lu.solve(b);
    if (x.minCoeff() < -1e-9) continue;
    double value = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) value += c[columns[i]] * x[static_cast<Index>(i)];
    best = std::max(best.value_or(-std::numeric_limits<double>::infinity()), value);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return best;
}

TEST(LinearProgram, RandomOnesAsTheBestOfAllCorners) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int infeasible = 0, found = 0;
  for (int n = 0; n < 2000; ++n) {
    const Index rows = 1 + n % 3, columns = rows + 1 + n % 5;
    // The first equation bounds the sum of all, so that nothing grows without end.
    const MatrixXd A =
        MatrixXd::NullaryExpr(rows, columns, [&](Index i, Index) { return i == 0 ? 1 : uniform(random); });
    VectorXd b = VectorXd::NullaryExpr(rows, [&](Index i) { return i == 0 ? 1 : 0.5 * uniform(random); });
    const VectorXd c = VectorXd::NullaryExpr(columns, [&](Index) { return uniform(random); });
    const auto optimum = maximise(A, b, c);
    const auto corner = best_corner(A, b, c);
    ASSERT_EQ(optimum.has_value(), corner.has_value()) << n;
    infeasible += !corner;
    if (!corner) continue;
    ++found;
    EXPECT_TRUE(optimum->bounded);
    EXPECT_NEAR(optimum->value, *corner, 1e-9);
    EXPECT_LT((A * optimum->x - b).norm(), 1e-9);
    EXPECT_GE(optimum->x.minCoeff(), 0);
  }
  EXPECT_GT(infeasible, 100);
  EXPECT_GT(found, 1000);
}

TEST(LinearProgram, WithoutEndOrWithRepeatedEquations) {
  const MatrixXd A{{1, -1, 0}, {2, -2, 0}};
  const auto grows = maximise(A, VectorXd{{1, 2}}, VectorXd{{1, 0, 0}});
  ASSERT_TRUE(grows);
  EXPECT_FALSE(grows->bounded);
  const auto bounded = maximise(A, VectorXd{{1, 2}}, VectorXd{{-1, 0, -1}});
  ASSERT_TRUE(bounded);
  EXPECT_TRUE(bounded->bounded);
  EXPECT_NEAR(bounded->value, -1, 1e-12);
  EXPECT_FALSE(maximise(A, VectorXd{{1, 3}}, VectorXd{{1, 0, 0}}));
  // E. M. L. Beale's example, on which the usual choice of the entering unknown goes round in a circle.
  const MatrixXd B{{0.25, -8, -1, 9, 1, 0, 0}, {0.5, -12, -0.5, 3, 0, 1, 0}, {0, 0, 1, 0, 0, 0, 1}};
  const auto beale = maximise(B, VectorXd{{0, 0, 1}}, VectorXd{{0.75, -20, 0.5, -6, 0, 0, 0}});
  ASSERT_TRUE(beale);
  EXPECT_NEAR(beale->value, 1.25, 1e-12);
}

}  // namespace linear_program_test
}  // namespace poinsot::solve
