#include "poinsot/engine/solve/linear/linear_system.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

namespace poinsot::solve {
namespace linear_system_test {

struct Rows {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
};

LinearSystem system_of(const Rows& rows, const std::vector<double>& unknown_scale = {},
                       const std::vector<double>& equation_scale = {}) {
  LinearSystem system;
  for (Eigen::Index j = 0; j < rows.A.cols(); ++j)
    system.add_unknown("x" + std::to_string(j), unknown_scale.empty() ? 1 : unknown_scale[static_cast<std::size_t>(j)]);
  for (Eigen::Index i = 0; i < rows.A.rows(); ++i) {
    const std::size_t row = system.add_equation(
        "equation " + std::to_string(i), equation_scale.empty() ? 1 : equation_scale[static_cast<std::size_t>(i)]);
    for (Eigen::Index j = 0; j < rows.A.cols(); ++j)
      if (rows.A(i, j) != 0) system.add(row, static_cast<std::size_t>(j), rows.A(i, j));
    system.add_right_side(row, rows.b[i]);
  }
  return system;
}

Eigen::VectorXd vector_of(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Eigen::Index integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index columns) {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return (*this)(-1, 1); });
  }

 private:
  std::mt19937_64 engine_;
};

TEST(LinearSystem, SolvesADeterminedSystem) {
  LinearSystem system;
  const std::size_t x = system.add_unknown("x"), y = system.add_unknown("y");
  const std::size_t sum = system.add_equation("the sum"), difference = system.add_equation("the difference");
  system.add(sum, x, 1);
  system.add(sum, y, 1);
  system.add_right_side(sum, 5);
  system.add(difference, x, 1);
  system.add(difference, y, -1);
  system.add_right_side(difference, 1);
  const LinearSolution solution = system.solve();
  EXPECT_NEAR(solution.value[x], 3, 1e-14);
  EXPECT_NEAR(solution.value[y], 2, 1e-14);
  EXPECT_TRUE(solution.open.empty());
  EXPECT_TRUE(solution.conflict.empty());
  EXPECT_TRUE(solution.determined(x));
  EXPECT_LT(solution.residual, 1e-14);
  EXPECT_EQ(system.name(y), "y");
  EXPECT_EQ(system.words(sum), "the sum");
}

TEST(LinearSystem, AddsUpEntriesAndRightSides) {
  LinearSystem system;
  const std::size_t x = system.add_unknown("x"), row = system.add_equation("row");
  system.add(row, x, 1.5);
  system.add(row, x, 0.5);
  system.add_right_side(row, 3);
  system.add_right_side(row, 5);
  EXPECT_NEAR(system.solve().value[x], 4, 1e-15);
}

TEST(LinearSystem, KnowsNothingOfUnknownsInNoEquation) {
  LinearSystem system;
  system.add_unknown("x");
  const LinearSolution solution = system.solve();
  EXPECT_EQ(solution.value, std::vector<double>{0});
  EXPECT_TRUE(solution.conflict.empty());
  EXPECT_FALSE(solution.determined(0));
  EXPECT_EQ(solution.open, (std::vector<std::vector<double>>{{1}}));
}

TEST(LinearSystem, AnUnknownInNoEquationIsOpen) {
  LinearSystem system;
  const std::size_t x = system.add_unknown("x"), y = system.add_unknown("y"), row = system.add_equation("row");
  system.add(row, x, 2);
  system.add_right_side(row, 4);
  const LinearSolution solution = system.solve();
  EXPECT_NEAR(solution.value[x], 2, 1e-15);
  EXPECT_TRUE(solution.determined(x));
  EXPECT_FALSE(solution.determined(y));
  ASSERT_EQ(solution.open.size(), 1U);
}

TEST(LinearSystem, AnEquationWithoutUnknownsMustHoldByItself) {
  LinearSystem system;
  system.add_unknown("x");
  const std::size_t first = system.add_equation("nothing is zero"), second = system.add_equation("nothing is one");
  system.add(first, 0, 0);
  system.add_right_side(second, 1);
  const LinearSolution solution = system.solve();
  EXPECT_EQ(solution.conflict, std::vector<std::size_t>{second});
}

TEST(LinearSystem, NamesWhatSharesALoad) {
  // Two forces in one line carry one load; a third is fixed.
  LinearSystem system;
  const std::size_t left = system.add_unknown("left"), right = system.add_unknown("right"),
                    side = system.add_unknown("side");
  const std::size_t along = system.add_equation("along"), across = system.add_equation("across");
  system.add(along, left, 1);
  system.add(along, right, 1);
  system.add_right_side(along, 10);
  system.add(across, side, 2);
  system.add_right_side(across, 6);
  const LinearSolution solution = system.solve();
  EXPECT_FALSE(solution.determined(left));
  EXPECT_FALSE(solution.determined(right));
  EXPECT_TRUE(solution.determined(side));
  EXPECT_NEAR(solution.value[side], 3, 1e-15);
  EXPECT_NEAR(solution.value[left] + solution.value[right], 10, 1e-14);
  ASSERT_EQ(solution.share.size(), 1U);
  std::vector<std::size_t> shared = solution.share.front();
  std::sort(shared.begin(), shared.end());
  EXPECT_EQ(shared, (std::vector<std::size_t>{left, right}));
}

TEST(LinearSystem, NamesOnlyTheEquationsThatContradict) {
  LinearSystem system;
  const std::size_t x = system.add_unknown("x"), y = system.add_unknown("y");
  const std::size_t one = system.add_equation("x is one"), two = system.add_equation("x is two"),
                    other = system.add_equation("y is seven");
  system.add(one, x, 1);
  system.add_right_side(one, 1);
  system.add(two, x, 1);
  system.add_right_side(two, 2);
  system.add(other, y, 1);
  system.add_right_side(other, 7);
  const LinearSolution solution = system.solve();
  EXPECT_EQ(solution.conflict, (std::vector<std::size_t>{one, two}));
  EXPECT_NEAR(solution.value[y], 7, 1e-14);
}

TEST(LinearSystem, NamesAnEquationWhoseSmallMisfitIsPartOfTheContradiction) {
  // 1e6 x = 1e6 and x = 1 + 1e-3 contradict each other, whatever their sizes.
  LinearSystem system;
  const std::size_t x = system.add_unknown("x");
  const std::size_t large = system.add_equation("large"), small = system.add_equation("small");
  system.add(large, x, 1e6);
  system.add_right_side(large, 1e6);
  system.add(small, x, 1);
  system.add_right_side(small, 1.001);
  EXPECT_EQ(system.solve().conflict, (std::vector<std::size_t>{large, small}));
}

TEST(LinearSystem, NoUnknownsOrNoEquations) {
  EXPECT_TRUE(LinearSystem().solve().value.empty());
  LinearSystem system;
  system.add_equation("0 = 0");
  EXPECT_TRUE(system.solve().conflict.empty());
  const std::size_t wrong = system.add_equation("0 = 1");
  system.add_right_side(wrong, 1);
  EXPECT_EQ(system.solve().conflict, std::vector<std::size_t>{wrong});
}

TEST(LinearSystem, NumbersThatAreNotFiniteAreAConflict) {
  LinearSystem system;
  const std::size_t x = system.add_unknown("x"), row = system.add_equation("row");
  system.add(row, x, 1);
  system.add_right_side(row, std::nan(""));
  EXPECT_FALSE(system.solve().conflict.empty());
}

// Random systems of known rank against the singular value decomposition.
TEST(LinearSystem, AgreesWithTheSingularValueDecomposition) {
  Random random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Index m = random.integer(1, 14), n = random.integer(1, 14);
    const Eigen::Index rank = random.integer(1, static_cast<int>(std::min(m, n)));
    const Eigen::MatrixXd A = random.matrix(m, rank) * random.matrix(rank, n);
    const Eigen::VectorXd x = random.matrix(n, 1);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
    if (svd.singularValues()[rank - 1] < 1e-4 * svd.singularValues()[0]) continue;
    const Rows rows{A, A * x};
    const LinearSolution solution = system_of(rows).solve();
    EXPECT_TRUE(solution.conflict.empty()) << trial;
    EXPECT_EQ(solution.open.size(), static_cast<std::size_t>(n - rank)) << trial;
    EXPECT_LT((A * vector_of(solution.value) - rows.b).norm(), 1e-11 * (1 + vector_of(solution.value).norm())) << trial;
    for (const auto& direction : solution.open) {
      const Eigen::VectorXd d = vector_of(direction);
      EXPECT_LT((A * d).norm(), 1e-10 * d.norm()) << trial;
    }
    // Determined exactly where the null space of the decomposition has no component.
    const Eigen::MatrixXd null_space = svd.matrixV().rightCols(n - rank);
    for (Eigen::Index j = 0; j < n; ++j) {
      const double moved = n > rank ? null_space.row(j).norm() : 0;
      if (moved > 1e-9 && moved < 1e-6) continue;
      EXPECT_EQ(solution.determined(static_cast<std::size_t>(j)), moved < 1e-9) << trial << " unknown " << j;
      if (moved < 1e-9) {
        EXPECT_NEAR(solution.value[static_cast<std::size_t>(j)], x[j], 1e-9) << trial;
      }
    }
  }
}

TEST(LinearSystem, FindsContradictionsThatTheDecompositionFinds) {
  Random random(2);
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Index n = random.integer(1, 8), m = n + random.integer(1, 5);
    const Eigen::MatrixXd A = random.matrix(m, n);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
    if (svd.singularValues()[n - 1] < 1e-4 * svd.singularValues()[0]) continue;
    // A right side with a part of the given size that no x reaches.
    const double size = std::pow(10.0, random(-6, 1));
    const Eigen::VectorXd unreachable = svd.matrixU().rightCols(m - n) * random.matrix(m - n, 1).normalized();
    const Rows rows{A, A * random.matrix(n, 1) + size * unreachable};
    const LinearSolution solution = system_of(rows).solve();
    EXPECT_FALSE(solution.conflict.empty()) << trial;
    EXPECT_GT(solution.residual, 1e-9) << trial;
    // An equation that is orthogonal to the unreachable part has no share in it.
    for (std::size_t i : solution.conflict) EXPECT_LT(i, static_cast<std::size_t>(m)) << trial;
  }
}

// Units of any size: the scales bring the system back to numbers near one.
TEST(LinearSystem, IsIndifferentToTheUnitsOfUnknownsAndEquations) {
  Random random(3);
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Index m = random.integer(2, 10), n = random.integer(2, 10);
    const Eigen::Index rank = random.integer(1, static_cast<int>(std::min(m, n)));
    const Eigen::MatrixXd A = random.matrix(m, rank) * random.matrix(rank, n);
    if (const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A); svd.singularValues()[rank - 1] < 1e-3 * svd.singularValues()[0])
      continue;
    const Eigen::VectorXd x = random.matrix(n, 1);
    std::vector<double> unknown_scale, equation_scale;
    Rows scaled{A, A * x};
    for (Eigen::Index j = 0; j < n; ++j) {
      unknown_scale.push_back(std::pow(10.0, random(-9, 9)));
      scaled.A.col(j) /= unknown_scale.back();
    }
    for (Eigen::Index i = 0; i < m; ++i) {
      equation_scale.push_back(std::pow(10.0, random(-9, 9)));
      scaled.A.row(i) *= equation_scale.back();
      scaled.b[i] *= equation_scale.back();
    }
    const LinearSolution plain = system_of({A, A * x}).solve();
    const LinearSolution solution = system_of(scaled, unknown_scale, equation_scale).solve();
    EXPECT_TRUE(solution.conflict.empty()) << trial;
    EXPECT_EQ(solution.open.size(), plain.open.size()) << trial;
    for (std::size_t j = 0; j < static_cast<std::size_t>(n); ++j) {
      EXPECT_EQ(solution.determined(j), plain.determined(j)) << trial;
      if (plain.determined(j)) {
        EXPECT_NEAR(solution.value[j] / unknown_scale[j], plain.value[j], 1e-9) << trial;
      }
    }
  }
}

// Sizes that nobody announced: bodies of a gram beside bodies of a tonne.
TEST(LinearSystem, SolvesBadlyScaledSystemsWithoutBeingToldTheScales) {
  Random random(4);
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Index n = random.integer(2, 10);
    Eigen::MatrixXd A = random.matrix(n, n) + 2.0 * static_cast<double>(n) * Eigen::MatrixXd::Identity(n, n);
    Eigen::VectorXd x = random.matrix(n, 1);
    for (Eigen::Index j = 0; j < n; ++j) {
      const double unit = std::pow(10.0, random(-2.5, 2.5));
      A.col(j) *= unit;
      x[j] /= unit;
    }
    for (Eigen::Index i = 0; i < n; ++i) A.row(i) *= std::pow(10.0, random(-2.5, 2.5));
    const LinearSolution solution = system_of({A, A * x}).solve();
    EXPECT_TRUE(solution.open.empty()) << trial;
    EXPECT_TRUE(solution.conflict.empty()) << trial;
    for (Eigen::Index j = 0; j < n; ++j)
      EXPECT_NEAR(solution.value[static_cast<std::size_t>(j)] / x[j], 1,
                  1e-10 / std::min(1.0, std::abs(x[j]) / x.cwiseAbs().maxCoeff()))
          << trial;
  }
}

}  // namespace linear_system_test
}  // namespace poinsot::solve
