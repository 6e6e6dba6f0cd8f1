#include "poinsot/engine/solve/roots/roots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/solve/roots/roots_problems.h"

namespace poinsot::solve {
namespace roots_test {

TEST(Roots, ALinearSystemHasItsOnlySolutionFoundInOneStep) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 1000; ++trial) {
    double A[3][3], x[3], b[3];
    for (int i = 0; i < 3; ++i) {
      x[i] = normal(random);
      for (double& a : A[i]) a = normal(random);
    }
    for (int i = 0; i < 3; ++i) b[i] = A[i][0] * x[0] + A[i][1] * x[1] + A[i][2] * x[2];
    RootProblem problem;
    problem.ranges.assign(3, {-infinity, infinity, 1});
    problem.equations = [&](const std::vector<double>& y) {
      RootEquations equations;
      for (int i = 0; i < 3; ++i) equations.values.push_back(A[i][0] * y[0] + A[i][1] * y[1] + A[i][2] * y[2] - b[i]);
      equations.size = 10;
      return equations;
    };
    const double determinant = A[0][0] * (A[1][1] * A[2][2] - A[1][2] * A[2][1]) -
                               A[0][1] * (A[1][0] * A[2][2] - A[1][2] * A[2][0]) +
                               A[0][2] * (A[1][0] * A[2][1] - A[1][1] * A[2][0]);
    if (std::abs(determinant) < 1e-2) continue;
    const Roots roots = find_roots(problem);
    EXPECT_EQ(roots.search, RootSearch::linear);
    ASSERT_EQ(roots.points.size(), 1u);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(roots.points[0][i], x[i], 1e-9 * (1 + 1 / std::abs(determinant)));
  }
}

TEST(Roots, AllRootsOfAPolynomialInTheRangeAreFoundInOrder) {
  const Roots roots = find_roots(of_one(-5, 5, [](double x) { return (x + 3) * (x - 0.5) * (x - 2) * (x - 7) / 100; }));
  ASSERT_EQ(roots.points.size(), 3u);
  EXPECT_NEAR(roots.points[0][0], -3, 1e-9);
  EXPECT_NEAR(roots.points[1][0], 0.5, 1e-9);
  EXPECT_NEAR(roots.points[2][0], 2, 1e-9);
  EXPECT_EQ(roots.search, RootSearch::certified);
}

TEST(Roots, RootsOfVeryDifferentSizeAreFoundInAnOpenRange) {
  const Roots roots = find_roots(of_one(-infinity, infinity, [](double x) { return (x - 0.02) * (x + 400); }));
  ASSERT_EQ(roots.points.size(), 2u);
  EXPECT_NEAR(roots.points[0][0], -400, 1e-6);
  EXPECT_NEAR(roots.points[1][0], 0.02, 1e-9);
}

TEST(Roots, AnExcludedEndIsNoRoot) {
  RootProblem problem = of_one(0, 3, [](double x) { return std::sin(x) * (x - 1); });
  EXPECT_EQ(find_roots(problem).points.size(), 2u);
  problem.ranges[0].lower_open = true;
  const Roots roots = find_roots(problem);
  ASSERT_EQ(roots.points.size(), 1u);
  EXPECT_NEAR(roots.points[0][0], 1, 1e-9);
}

TEST(Roots, NoRootIsSaidWithTheSmallestMisfit) {
  const Roots roots = find_roots(of_one(-4, 4, [](double x) { return x * x + 1; }));
  EXPECT_TRUE(roots.points.empty());
  EXPECT_NEAR(roots.best_misfit, 1, 1e-6);
}

// The equations with a weight that jumps, and smooth ones without it that can be had alone.
RootProblem weighted(double lift, int* evaluations) {
  const auto smooth = [lift](const std::vector<double>& x) {
    return std::vector<double>{x[0] * x[0] + x[1] * x[1] - 4 + lift, std::sin(x[0]) - x[1]};
  };
  RootProblem problem;
  problem.ranges.assign(2, {-3, 3, 1});
  problem.equations = [=](const std::vector<double>& x) {
    ++*evaluations;
    RootEquations equations{smooth(x), 4, smooth(x), 4};
    for (double& value : equations.values) value *= x[0] > 0.1 ? 2 : 1;
    return equations;
  };
  problem.smooth = [=](const std::vector<double>& x) { return RootEquations{{}, 0, smooth(x), 4}; };
  return problem;
}

TEST(Roots, SmoothEquationsThatCanBeHadAloneSpareMostEvaluations) {
  int with = 0, without = 0;
  const RootProblem problem = weighted(0, &with);
  RootProblem plain = weighted(0, &without);
  plain.smooth = nullptr;
  const Roots roots = find_roots(problem), same = find_roots(plain);
  ASSERT_EQ(roots.points.size(), 2u);
  EXPECT_EQ(roots.search, RootSearch::certified);
  EXPECT_EQ(roots.points, same.points);
  EXPECT_LT(2 * with, without);
}

TEST(Roots, WhereThereIsNoneTheBestPlacesAreJudgedByTheEquationsThemselves) {
  int evaluations = 0;
  const RootProblem problem = weighted(6, &evaluations);
  RootProblem plain = problem;
  plain.smooth = nullptr;
  const Roots roots = find_roots(problem), same = find_roots(plain);
  EXPECT_TRUE(roots.points.empty());
  EXPECT_EQ(roots.search, RootSearch::certified);
  EXPECT_EQ(roots.best, same.best);
  EXPECT_EQ(roots.best_misfit, same.best_misfit);
}

TEST(Roots, ContradictoryLinearEquationsHaveNone) {
  RootProblem problem;
  problem.ranges = {{-infinity, infinity, 1}};
  problem.equations = [](const std::vector<double>& x) { return RootEquations{{x[0] - 1, x[0] - 2}, 2}; };
  const Roots roots = find_roots(problem);
  EXPECT_EQ(roots.search, RootSearch::linear);
  EXPECT_TRUE(roots.points.empty());
}

TEST(Roots, WithoutUnknownsTheEquationsHoldOrDoNot) {
  for (const double misfit : {0.0, 1e-3}) {
    RootProblem problem;
    problem.equations = [=](const std::vector<double>&) { return RootEquations{{misfit}, 1}; };
    EXPECT_EQ(find_roots(problem).points.size(), misfit == 0 ? 1u : 0u);
  }
}

TEST(Roots, AnUnknownThatChangesNothingIsOpen) {
  RootProblem problem;
  problem.ranges = {{-infinity, infinity, 1}, {-infinity, infinity, 1}};
  problem.equations = [](const std::vector<double>& x) { return RootEquations{{x[0] - 3, 0}, 3}; };
  const Roots roots = find_roots(problem);
  ASSERT_EQ(roots.points.size(), 1u);
  EXPECT_NEAR(roots.points[0][0], 3, 1e-12);
  EXPECT_TRUE(roots.open);
  EXPECT_EQ(roots.open_unknowns, std::vector<std::size_t>{1});
  ASSERT_EQ(roots.alternative.size(), 2u);
  EXPECT_NEAR(roots.alternative[0], 3, 1e-12);
  EXPECT_NE(roots.alternative[1], roots.points[0][1]);
}

// A line of solutions may be far shorter between the ends of the ranges than the natural sizes. A double root there is
// no line.
TEST(Roots, AShortLineOfSolutionsIsOpen) {
  for (const double length : {1.0, 2e-3, 1e-5}) {
    RootProblem problem;
    problem.ranges = {{0, infinity, 1}, {0, infinity, 1}};
    problem.equations = [&](const std::vector<double>& x) {
      const double sum = x[0] + x[1];
      return RootEquations{{(sum - length) / (1 + sum), 0.0}, 1};
    };
    const Roots roots = find_roots(problem);
    EXPECT_TRUE(roots.open) << length;
    EXPECT_EQ(roots.open_unknowns, (std::vector<std::size_t>{0, 1})) << length;
    ASSERT_EQ(roots.alternative.size(), 2u) << length;
    EXPECT_NEAR(roots.alternative[0] + roots.alternative[1], length, 1e-12);
    problem.equations = [&](const std::vector<double>& x) {
      const double sum = x[0] + x[1] - length, difference = x[0] - length / 3;
      return RootEquations{{sum / (1 + x[0]), difference * difference}, 1};
    };
    EXPECT_FALSE(find_roots(problem).open) << length;
  }
}

TEST(Roots, EquationsWithoutValueSomewhereStillGiveTheirRoots) {
  RootProblem problem;
  problem.ranges = {{-2, 9, 1}};
  problem.equations = [](const std::vector<double>& x) -> std::optional<RootEquations> {
    if (x[0] < 0) return std::nullopt;
    return RootEquations{{std::sqrt(x[0]) - 2}, 2};
  };
  const Roots roots = find_roots(problem);
  ASSERT_EQ(roots.points.size(), 1u);
  EXPECT_NEAR(roots.points[0][0], 4, 1e-8);
}

TEST(Roots, CirclesAndLinesMeetInBothPoints) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> angle(0, 6.28), offset(-0.9, 0.9);
  for (int trial = 0; trial < 50; ++trial) {
    const double a = angle(random), d = offset(random);
    RootProblem problem;
    problem.ranges = {{-3, 3, 1}, {-3, 3, 1}};
    problem.equations = [&](const std::vector<double>& x) {
      return RootEquations{{x[0] * x[0] + x[1] * x[1] - 1, std::cos(a) * x[0] + std::sin(a) * x[1] - d}, 1};
    };
    const Roots roots = find_roots(problem);
    ASSERT_EQ(roots.points.size(), 2u);
    for (const auto& p : roots.points) EXPECT_NEAR(p[0] * p[0] + p[1] * p[1], 1, 1e-8);
  }
}

// Equations of different sizes must vanish each beside its own terms: far out the first has huge ones, and the second
// still misses.
TEST(Roots, TermsOfOneEquationDoNotExcuseAnother) {
  RootProblem problem;
  problem.ranges = {{0, infinity, 1}};
  problem.costly = true;
  problem.equations = [](const std::vector<double>& x) {
    RootEquations equations;
    equations.values = {0, std::atan(x[0] - 4) - 0.5};
    equations.size = 1 + x[0];
    equations.sizes = {1 + x[0], 1};
    return equations;
  };
  const Roots roots = find_roots(problem);
  EXPECT_FALSE(roots.open);
  ASSERT_EQ(roots.points.size(), 1u);
  EXPECT_NEAR(roots.points[0][0], 4 + std::tan(0.5), 1e-8);
}

// A root just beyond an end counts as at the end only if it is as good a root there.
TEST(Roots, AnEndIsARootOnlyIfTheEquationsHoldThere) {
  for (const double root : {-1e-10, -3e-10, 0.0, 1e-10}) {
    RootProblem problem = of_one(0, infinity, [&](double x) { return 1e3 * (x - root); });
    problem.zero = 1e-13;
    EXPECT_EQ(find_roots(problem).points.size(), root < 0 ? 0u : 1u) << root;
  }
}

}  // namespace roots_test
}  // namespace poinsot::solve
