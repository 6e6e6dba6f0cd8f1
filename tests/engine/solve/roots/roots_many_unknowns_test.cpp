#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "engine/solve/roots/roots_problems.h"
#include "poinsot/engine/solve/roots/roots.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {
namespace roots_many_unknowns_test {

RootProblem of_three(std::function<std::vector<double>(double, double, double)> f) {
  RootProblem problem;
  problem.ranges.assign(3, {-infinity, infinity, 1});
  problem.equations = [f = std::move(f)](const std::vector<double>& x) { return equations_from(f(x[0], x[1], x[2])); };
  return problem;
}

TEST(RootsOfManyUnknowns, ASphereAndTwoPlanesMeetTwice) {
  const Roots roots = find_roots(of_three([](double x, double y, double z) {
    return std::vector{x * x + y * y + z * z - 9, x - y, z - 1};
  }));
  EXPECT_EQ(roots.search, RootSearch::many_starts);
  ASSERT_EQ(roots.points.size(), 2u);
  for (const auto& p : roots.points) {
    EXPECT_NEAR(std::abs(p[0]), 2, 1e-10);
    EXPECT_NEAR(p[1], p[0], 1e-10);
    EXPECT_NEAR(p[2], 1, 1e-10);
  }
}

TEST(RootsOfManyUnknowns, ADoubleRootHasNoNearDuplicates) {
  const Roots roots = find_roots(of_three([](double x, double y, double z) {
    return std::vector{(x - 1) * (x - 1), y - x, z + y};
  }));
  ASSERT_EQ(roots.points.size(), 1u);
  EXPECT_NEAR(roots.points[0][0], 1, 1e-4);
  EXPECT_FALSE(roots.open);
}

TEST(RootsOfManyUnknowns, AStallIsNoRoot) {
  const Roots roots = find_roots(of_three([](double x, double y, double z) {
    return std::vector{(x - 1) * (x - 1) + 1e-4, y - x, z + y};
  }));
  EXPECT_TRUE(roots.points.empty());
  EXPECT_NEAR(roots.best_misfit, 1e-4, 1e-5);
}

TEST(RootsOfManyUnknowns, RandomQuadraticSystemsAreSatisfiedAtTheRootsListed) {
  std::mt19937_64 random(12);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    Eigen::Vector3d root;
    Eigen::Matrix3d A, B;
    for (int i = 0; i < 3; ++i) {
      root[i] = normal(random);
      for (int j = 0; j < 3; ++j) {
        A(i, j) = normal(random);
        B(i, j) = 0.3 * normal(random);
      }
    }
    const auto f = [&](double x, double y, double z) {
      const Eigen::Vector3d d = Eigen::Vector3d(x, y, z) - root, r = A * d + B * d.cwiseAbs2();
      return std::vector{r[0], r[1], r[2]};
    };
    const Roots roots = find_roots(of_three(f));
    ASSERT_FALSE(roots.points.empty());
    for (std::size_t i = 0; i < roots.points.size(); ++i) {
      const auto& p = roots.points[i];
      for (double value : f(p[0], p[1], p[2])) EXPECT_LT(std::abs(value), 1e-8 * (1 + std::abs(p[0])));
      for (std::size_t j = 0; j < i; ++j) {
        const auto& q = roots.points[j];
        EXPECT_GT(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 1e-6);
      }
    }
  }
}

// Full steps would lead out of the ranges, where the equations have no value.
TEST(RootsOfManyUnknowns, RangesEndWhereTheEquationsDo) {
  RootProblem problem;
  problem.ranges.assign(4, {0, infinity, 1});
  problem.equations = [](const std::vector<double>& x) -> std::optional<RootEquations> {
    for (const double value : x)
      if (value < 0) return std::nullopt;
    return equations_from(
        {x[0] * x[0] + x[1] * x[1] - 1, x[1] * x[1] + x[2] * x[2] - 1, x[2] * x[3] - 0.5, x[3] * x[1] - 2.0 / 3});
  };
  const Roots roots = find_roots(problem);
  ASSERT_EQ(roots.points.size(), 1u);
  EXPECT_NEAR(roots.points[0][0], 0.6, 1e-10);
  EXPECT_NEAR(roots.points[0][1], 0.8, 1e-10);
  EXPECT_NEAR(roots.points[0][3], 0.5 / 0.6, 1e-10);
}

// The search ends, with the best place that it met.
TEST(RootsOfManyUnknowns, ASearchEndsWhenItsWorkIsDone) {
  constexpr Work of_an_evaluation = 1'000'000;
  const RootProblem problem = of_three([](double x, double y, double z) {
    count_work(of_an_evaluation);
    return std::vector{x * x + y * y + z * z + 1, x * y * z - 3, std::sin(x) + y * y + 2};
  });
  for (const std::size_t evaluations : {40, 200, 600}) {
    const Work begin = work_done();
    const Roots roots = find_roots(problem, evaluations * of_an_evaluation);
    EXPECT_TRUE(roots.points.empty());
    EXPECT_EQ(roots.search, RootSearch::many_starts);
    EXPECT_LT(roots.evaluations, evaluations + evaluations / 4 + 40);
    EXPECT_EQ(work_done() - begin, roots.evaluations * (of_an_evaluation + 500));
    EXPECT_EQ(roots.best.size(), 3U);
    EXPECT_GT(roots.best_misfit, 0.5);
  }
}

TEST(RootsOfManyUnknowns, ACurveOfSolutionsIsOpen) {
  const Roots roots = find_roots(of_three([](double x, double y, double z) {
    return std::vector{x * x + y * y - 4, z - x * y};
  }));
  EXPECT_TRUE(roots.open);
  EXPECT_EQ(roots.open_unknowns.size(), 3u);
  ASSERT_EQ(roots.alternative.size(), 3u);
  EXPECT_NEAR(std::hypot(roots.alternative[0], roots.alternative[1]), 2, 1e-8);
}

}  // namespace roots_many_unknowns_test
}  // namespace poinsot::solve
