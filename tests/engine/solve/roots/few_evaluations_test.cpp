// Roots of equations of which an evaluation takes long.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "poinsot/engine/solve/roots/roots.h"

namespace poinsot::solve {
namespace few_evaluations_test {

constexpr double infinite = std::numeric_limits<double>::infinity();

Roots roots_of(const RootRange& range, const std::function<double(double)>& f) {
  RootProblem problem;
  problem.ranges = {range};
  problem.costly = true;
  problem.equations = [&](const std::vector<double>& x) -> std::optional<RootEquations> {
    return RootEquations{{f(x[0])}, 1, {}, 0};
  };
  return find_roots(problem);
}

TEST(FewEvaluations, RootsInAFiniteRange) {
  const Roots roots = roots_of({1, 10, 1, false, false}, [](double x) { return std::sin(x); });
  EXPECT_EQ(roots.search, RootSearch::few_evaluations);
  EXPECT_LT(roots.evaluations, 200U);
  ASSERT_EQ(roots.points.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(roots.points[k][0], 3.141592653589793 * static_cast<double>(k + 1), 1e-9);
}

TEST(FewEvaluations, RootsOnAHalfLineAndOnALine) {
  const Roots up = roots_of({0, infinite, 1, true, false}, [](double x) { return std::log(x / 6.2139); });
  ASSERT_EQ(up.points.size(), 1U);
  EXPECT_NEAR(up.points[0][0], 6.2139, 1e-9);
  const Roots line = roots_of({-infinite, infinite, 1, false, false}, [](double x) { return x * x - 30; });
  ASSERT_EQ(line.points.size(), 2U);
  EXPECT_NEAR(line.points[0][0], -std::sqrt(30), 1e-9);
  EXPECT_NEAR(line.points[1][0], std::sqrt(30), 1e-9);
}

// What looks linear where it is probed may be anything elsewhere.
TEST(FewEvaluations, TheyAreNeverTakenForLinear) {
  const auto f = [](double x) { return x < 3 ? x - 5 : 6 * std::exp(3 - x) - 8; };
  const Roots roots = roots_of({0, infinite, 1, false, false}, f);
  EXPECT_EQ(roots.search, RootSearch::few_evaluations);
  EXPECT_TRUE(roots.points.empty());
  EXPECT_GT(roots.best_misfit, 1.9);
}

TEST(FewEvaluations, WhereTheyHaveNoValueIsPassedOver) {
  RootProblem problem;
  problem.ranges = {{0, 4, 1, false, false}};
  problem.costly = true;
  problem.equations = [](const std::vector<double>& x) -> std::optional<RootEquations> {
    if (x[0] > 2) return std::nullopt;
    return RootEquations{{x[0] * x[0] - 2}, 2, {}, 0};
  };
  const Roots roots = find_roots(problem);
  ASSERT_EQ(roots.points.size(), 1U);
  EXPECT_NEAR(roots.points[0][0], std::sqrt(2), 1e-9);
}

TEST(FewEvaluations, TwoUnknowns) {
  RootProblem problem;
  problem.ranges = {{0, 4, 1, false, false}, {0, 4, 1, false, false}};
  problem.costly = true;
  problem.equations = [](const std::vector<double>& x) -> std::optional<RootEquations> {
    return RootEquations{{x[0] * x[1] - 3, x[0] + x[1] - 4}, 4, {}, 0};
  };
  const Roots roots = find_roots(problem);
  ASSERT_EQ(roots.points.size(), 2U);
  EXPECT_NEAR(roots.points[0][0], 1, 1e-8);
  EXPECT_NEAR(roots.points[1][0], 3, 1e-8);
}

// With rough equations the close ones are asked a few times for each root.
TEST(FewEvaluations, RootsAreLookedForRoughlyAndFoundClosely) {
  RootProblem problem;
  problem.ranges = {{1, 10, 1, false, false}};
  problem.costly = true;
  int close = 0;
  problem.equations = [&](const std::vector<double>& x) -> std::optional<RootEquations> {
    ++close;
    return RootEquations{{std::sin(x[0])}, 1, {}, 0};
  };
  problem.rough = [](const std::vector<double>& x) -> std::optional<RootEquations> {
    return RootEquations{{std::sin(x[0]) + 1e-8 * std::sin(1e9 * x[0])}, 1, {}, 0};
  };
  const Roots roots = find_roots(problem);
  ASSERT_EQ(roots.points.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(roots.points[k][0], 3.141592653589793 * static_cast<double>(k + 1), 1e-13);
  EXPECT_LT(close, 40);
}

TEST(FewEvaluations, WhereTheRoughEquationsHaveNoValueTheCloseOnesAreSearched) {
  RootProblem problem;
  problem.ranges = {{0, 4, 1, false, false}};
  problem.costly = true;
  problem.equations = [](const std::vector<double>& x) -> std::optional<RootEquations> {
    return RootEquations{{x[0] * x[0] - 2}, 2, {}, 0};
  };
  problem.rough = [](const std::vector<double>&) -> std::optional<RootEquations> { return std::nullopt; };
  const Roots roots = find_roots(problem);
  ASSERT_EQ(roots.points.size(), 1U);
  EXPECT_NEAR(roots.points[0][0], std::sqrt(2), 1e-13);
}

TEST(FewEvaluations, ACurveOfRootsIsSeenThroughRoughEquationsToo) {
  RootProblem problem;
  problem.ranges = {{0, 4, 1, false, false}, {0, 4, 1, false, false}};
  problem.costly = true;
  problem.equations = [](const std::vector<double>& x) -> std::optional<RootEquations> {
    return RootEquations{{x[0] * x[1] - 3, 2 * x[0] * x[1] - 6}, 6, {}, 0};
  };
  problem.rough = [&](const std::vector<double>& x) -> std::optional<RootEquations> {
    auto equations = problem.equations(x);
    equations->values[1] += 1e-8 * std::sin(1e9 * x[0] + 1e8 * x[1]);
    return equations;
  };
  const Roots roots = find_roots(problem);
  EXPECT_TRUE(roots.open);
  EXPECT_EQ(roots.open_unknowns.size(), 2U);
}

}  // namespace few_evaluations_test
}  // namespace poinsot::solve
