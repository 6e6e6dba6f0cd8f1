#include "engine/motion/mechanism/pivoted_qr.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace poinsot::detail {
namespace pivoted_qr_test {

using Matrix = Eigen::MatrixXd;

// A random matrix of the given rank.
Matrix random_matrix(std::mt19937_64& random, int rows, int columns, int rank) {
  std::normal_distribution<double> part;
  const auto any = [&] { return part(random); };
  return Matrix::NullaryExpr(rows, rank, any) * Matrix::NullaryExpr(rank, columns, any);
}

TEST(PivotedQr, FactorsSolvesAndFindsTheRank) {
  std::mt19937_64 random(3);
  PivotedQr qr;
  qr.reserve(20, 20);
  for (int i = 0; i < 1000; ++i) {
    std::uniform_int_distribution<int> size(1, i % 2 ? 8 : 20);
    const int rows = size(random), columns = size(random);
    const int rank = std::min({rows, columns, size(random)});
    const Matrix A = random_matrix(random, rows, columns, rank);
    qr.resize(rows, columns);
    for (int j = 0; j < columns; ++j)
      for (int k = 0; k < rows; ++k) qr.entry(k, j) = A(k, j);
    qr.factor(1e-10);
    ASSERT_EQ(qr.rank(), rank);
    // A P = Q R, column by column.
    for (int k = 0; k < columns; ++k) {
      Eigen::VectorXd x = Eigen::VectorXd::Zero(rows);
      for (int j = 0; j <= std::min(k, rank - 1); ++j) x[j] = qr.R(j, k);
      qr.apply(x.data());
      EXPECT_LT((x - A.col(qr.chosen(k))).norm(), 1e-12 * (1 + A.norm()));
      qr.apply_transposed(x.data());
      for (int j = std::min(k + 1, rank); j < rows; ++j) EXPECT_NEAR(x[j], 0, 1e-12 * (1 + A.norm()));
    }
    Eigen::MatrixXd R(rank, rank);
    for (int k = 0; k < rank; ++k)
      for (int j = 0; j < rank; ++j) R(j, k) = j <= k ? qr.R(j, k) : 0;
    const Eigen::VectorXd b = random_matrix(random, rank, 1, 1);
    Eigen::VectorXd x = b, y = b;
    qr.solve_upper(x.data());
    qr.solve_transposed(y.data());
    EXPECT_LT((R * x - b).norm(), 1e-12 * (1 + R.norm() * x.norm()));
    EXPECT_LT((R.transpose() * y - b).norm(), 1e-12 * (1 + R.norm() * y.norm()));
    EXPECT_NEAR(qr.least_pivot(), R.diagonal().cwiseAbs().minCoeff() / R.diagonal().cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(PivotedQr, ReflectsColumnsTogetherAsAlone) {
  std::mt19937_64 random(5);
  PivotedQr qr;
  qr.reserve(21, 19);
  for (int i = 0; i < 300; ++i) {
    std::uniform_int_distribution<int> size(1, 19);
    const int rows = size(random) + 2, columns = size(random), together = size(random);
    const Matrix A = random_matrix(random, rows, columns, std::min({rows, columns, size(random)}));
    qr.resize(rows, columns);
    for (int j = 0; j < columns; ++j)
      for (int k = 0; k < rows; ++k) qr.entry(k, j) = A(k, j);
    qr.factor(1e-10);
    const Matrix X = random_matrix(random, rows, together, std::min(rows, together));
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> turned = X;
    qr.apply_transposed(turned.data(), together);
    for (int j = 0; j < together; ++j) {
      Eigen::VectorXd x = X.col(j);
      qr.apply_transposed(x.data());
      EXPECT_LE((x - turned.col(j)).norm(), 1e-14 * x.norm());
    }
  }
}

TEST(PivotedQr, ColumnsOfTheHigherClassComeFirst) {
  PivotedQr qr;
  qr.reserve(2, 3);
  qr.resize(2, 3);
  const double entries[2][3] = {{10, 1, 0}, {0, 1, 0}};
  for (int i = 0; i < 2; ++i) std::copy_n(entries[i], 3, &qr.entry(i, 0));
  const char classes[] = {0, 1, 1};
  qr.factor(1e-12, classes);
  EXPECT_EQ(qr.rank(), 2);
  EXPECT_EQ(qr.chosen(0), 1);
  EXPECT_EQ(qr.chosen(1), 0);
}

TEST(PivotedQr, AnEmptyMatrixHasRankZero) {
  PivotedQr qr;
  qr.reserve(3, 3);
  qr.resize(3, 0);
  qr.factor(1e-12);
  EXPECT_EQ(qr.rank(), 0);
  EXPECT_EQ(qr.least_pivot(), 1);
}

}  // namespace pivoted_qr_test
}  // namespace poinsot::detail
