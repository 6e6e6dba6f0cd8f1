#include "engine/solve/linear/column_pivoted_qr.h"

#include <gtest/gtest.h>

#include <random>

#include "poinsot/engine/work/budget.h"

namespace poinsot::solve {
namespace column_pivoted_qr_test {

using Eigen::MatrixXd;

// Full rank, less, none, and columns that nearly repeat, whose norms have to be computed anew.
TEST(ColumnPivotedQr, has_the_bits_of_eigens) {
  std::mt19937 random(3);
  std::normal_distribution<double> draw;
  for (const auto& [rows, columns] : {std::pair<int, int>{1, 1}, {5, 5}, {12, 7}, {7, 12}, {40, 40}}) {
    for (int kind = 0; kind < 4; ++kind) {
      MatrixXd A = MatrixXd::NullaryExpr(rows, columns, [&] { return draw(random); });
      if (kind == 1) A.rightCols(columns / 2) = A.leftCols(columns / 2);
      if (kind == 2) A.rightCols(columns / 2) = A.leftCols(columns / 2) + 1e-9 * A.rightCols(columns / 2);
      if (kind == 3) A.setZero();
      const Eigen::ColPivHouseholderQR<MatrixXd> expected(A);
      const ColumnPivotedQr qr(A);
      EXPECT_EQ(qr.matrixQR(), expected.matrixQR());
      EXPECT_EQ(qr.hCoeffs(), expected.hCoeffs());
      EXPECT_EQ(qr.colsPermutation().indices(), expected.colsPermutation().indices());
      EXPECT_EQ(qr.nonzeroPivots(), expected.nonzeroPivots());
      EXPECT_EQ(qr.maxPivot(), expected.maxPivot());
      EXPECT_EQ(qr.rank(), expected.rank());
      EXPECT_EQ(qr.colsPermutation().determinant(), expected.colsPermutation().determinant());
    }
  }
}

TEST(ColumnPivotedQr, is_ended_by_a_budget) {
  int looks = 0;
  const auto clock = [&looks] { return Budget::Clock::time_point{} + std::chrono::milliseconds(++looks); };
  const BudgetScope scope(Budget().by_clock(clock).end_at(Budget::Clock::time_point{} + std::chrono::milliseconds(20)));
  EXPECT_THROW(ColumnPivotedQr(MatrixXd::Random(40, 40)), BudgetEnded);
  EXPECT_EQ(looks, 20);
}

}  // namespace column_pivoted_qr_test
}  // namespace poinsot::solve
