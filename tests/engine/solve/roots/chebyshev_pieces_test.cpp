#include "engine/solve/roots/chebyshev_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace poinsot::solve {
namespace chebyshev_pieces_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ChebyshevSeries series_of(Index count0, Index count1, const std::function<VectorXd(double, double)>& f) {
  MatrixXd values(f(0, 0).size(), count0 * count1);
  for (Index j = 0; j < count1; ++j)
    for (Index i = 0; i < count0; ++i) values.col(i + count0 * j) = f(inner_point(count0, i), inner_point(count1, j));
  return interpolated(values, count0, count1);
}

bool holds(const Piece& piece, const Pair& s) {
  return std::abs(s[0] - piece.middle[0]) <= piece.half[0] + 1e-12 &&
         std::abs(s[1] - piece.middle[1]) <= piece.half[1] + 1e-12;
}

TEST(ChebyshevPieces, SimpleZerosOfALineAreFoundEach) {
  const ChebyshevSeries series =
      series_of(6, 1, [](double s, double) { return VectorXd{{(s - 0.5) * (s - 0.501) * (s + 0.7) * (s - 1.5)}}; });
  const PieceZeros found = zeros_of_pieces(series, 1e-14, 0);
  EXPECT_TRUE(found.left.empty());
  EXPECT_FALSE(found.curve);
  for (const double zero : {0.5, 0.501, -0.7}) {
    double nearest = 1;
    for (const Pair& s : found.zeros) nearest = std::min(nearest, std::abs(s[0] - zero));
    EXPECT_LT(nearest, 1e-11);
  }
  for (const Pair& s : found.zeros) EXPECT_LT(std::abs((s[0] - 0.5) * (s[0] - 0.501) * (s[0] + 0.7)), 1e-13);
}

TEST(ChebyshevPieces, ZerosOfASquareAreFoundEach) {
  const ChebyshevSeries series = series_of(4, 4, [](double x, double y) {
    return VectorXd{{x * x + y * y - 0.5, x - y, (x - y) * (x + 3)}};
  });
  const PieceZeros found = zeros_of_pieces(series, 1e-14, 0);
  EXPECT_TRUE(found.left.empty());
  ASSERT_GE(found.zeros.size(), 2u);
  for (const Pair& s : found.zeros) {
    EXPECT_NEAR(std::abs(s[0]), 0.5, 1e-12);
    EXPECT_NEAR(s[0], s[1], 1e-12);
  }
}

TEST(ChebyshevPieces, AZeroOfSomeComponentsOnlyIsNone) {
  const ChebyshevSeries series = series_of(3, 3, [](double x, double y) {
    return VectorXd{{x - 0.2, y + 0.1, x * y + 0.05}};
  });
  const PieceZeros found = zeros_of_pieces(series, 1e-13, 0);
  EXPECT_TRUE(found.zeros.empty());
  EXPECT_TRUE(found.left.empty());
}

TEST(ChebyshevPieces, AroundADoubleZeroATinyPieceIsLeft) {
  const ChebyshevSeries line = series_of(3, 1, [](double s, double) { return VectorXd{{(s - 0.3) * (s - 0.3)}}; });
  const PieceZeros found = zeros_of_pieces(line, 1e-13, 0);
  EXPECT_TRUE(found.zeros.empty());
  ASSERT_FALSE(found.left.empty());
  for (const Piece& piece : found.left) {
    EXPECT_LT(piece.half[0], 1e-5);
    EXPECT_NEAR(piece.middle[0], 0.3, 1e-5);
  }
}

TEST(ChebyshevPieces, WhereTheErrorAllowsAZeroNothingIsExcluded) {
  // The line is shifted by less than the error: its zero at 0.4 must stay possible.
  const ChebyshevSeries line =
      series_of(3, 1, [](double s, double) { return VectorXd{{(s - 0.4) * (s - 0.4) + 1e-3}}; });
  const PieceZeros found = zeros_of_pieces(line, 2e-3, 0);
  bool possible = false;
  for (const Piece& piece : found.left) possible = possible || holds(piece, {0.4, 0});
  EXPECT_TRUE(possible);
  EXPECT_TRUE(zeros_of_pieces(line, 1e-6, 0).left.empty());
}

TEST(ChebyshevPieces, ValuesThatTouchZeroAreNoted) {
  const ChebyshevSeries line =
      series_of(3, 1, [](double s, double) { return VectorXd{{(s - 0.4) * (s - 0.4) + 1e-6}}; });
  const PieceZeros found = zeros_of_pieces(line, 1e-14, 1e-5);
  EXPECT_TRUE(found.zeros.empty());
  EXPECT_TRUE(found.left.empty());
  double nearest = 1;
  for (const Pair& s : found.touching) nearest = std::min(nearest, std::abs(s[0] - 0.4));
  EXPECT_LT(nearest, 1e-3);
  EXPECT_TRUE(zeros_of_pieces(line, 1e-14, 1e-7).touching.empty());
}

TEST(ChebyshevPieces, ACurveOfZerosIsRecognised) {
  const ChebyshevSeries series = series_of(5, 5, [](double x, double y) {
    const double circle = x * x + y * y - 0.5;
    return VectorXd{{circle * (1 + 0.2 * x), circle * (y - 0.1)}};
  });
  const PieceZeros found = zeros_of_pieces(series, 1e-14, 0);
  ASSERT_TRUE(found.curve);
  for (const Pair& s : *found.curve) EXPECT_NEAR(s[0] * s[0] + s[1] * s[1], 0.5, 1e-10);
  const Pair &a = (*found.curve)[0], &b = (*found.curve)[1];
  EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1]), 5e-3);
}

}  // namespace chebyshev_pieces_test
}  // namespace poinsot::solve
