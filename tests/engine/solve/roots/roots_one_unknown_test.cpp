#include <gtest/gtest.h>

#include <random>

#include "engine/solve/roots/roots_problems.h"
#include "poinsot/engine/solve/roots/roots.h"

namespace poinsot::solve {
namespace roots_one_unknown_test {

double product(const std::vector<double>& roots, double x) {
  double value = 1;
  for (double root : roots) value *= (x - root) / 2;
  return value;
}

void expect_points(const Roots& roots, const std::vector<double>& expected, double tolerance) {
  ASSERT_EQ(roots.points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(roots.points[i][0], expected[i], tolerance);
}

TEST(RootsOfOneUnknown, AllRootsOfRandomPolynomialsAreFoundAndCertified) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-4, 4);
  std::size_t evaluations = 0, searches = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::vector<double> known(2 + trial % 7);
    for (double& root : known) root = place(random);
    std::sort(known.begin(), known.end());
    bool apart = true;
    for (std::size_t i = 0; i + 1 < known.size(); ++i) apart = apart && known[i + 1] - known[i] > 1e-4;
    if (!apart) continue;
    const double end = trial % 2 ? infinity : 3;
    std::vector<double> expected;
    for (double root : known)
      if (std::abs(root) <= end) expected.push_back(root);
    const Roots roots = find_roots(of_one(-end, end, [&](double x) { return product(known, x); }));
    EXPECT_EQ(roots.search, RootSearch::certified);
    expect_points(roots, expected, 1e-8);
    EXPECT_TRUE(roots.unresolved.empty());
    evaluations += roots.evaluations;
    ++searches;
  }
  EXPECT_LT(evaluations, 40 * searches);
}

TEST(RootsOfOneUnknown, QuadraticsCostAboutTwentyEvaluations) {
  for (const double lower : {-infinity, 0.0, -9.0}) {
    const Roots roots = find_roots(of_one(lower, infinity, [](double x) { return (x - 0.3) * (x - 7); }));
    EXPECT_EQ(roots.search, RootSearch::certified);
    expect_points(roots, {0.3, 7}, 1e-12);
    EXPECT_LE(roots.evaluations, 24u);
  }
}

TEST(RootsOfOneUnknown, ClustersAreSeparatedDownToAFewMillionthsOfTheRange) {
  for (const double gap : {1e-2, 1e-3, 1e-4, 1e-5}) {
    for (const double end : {4.0, infinity}) {
      const Roots pair = find_roots(of_one(-end, end, [&](double x) { return (x - 1) * (x - 1 - gap) * (x + 2); }));
      EXPECT_EQ(pair.search, RootSearch::certified);
      expect_points(pair, {-2, 1, 1 + gap}, 1e-3 * gap);
    }
  }
}

TEST(RootsOfOneUnknown, AMultipleRootIsReportedOnce) {
  const Roots twice = find_roots(of_one(-3, 4, [](double x) { return (x - 1) * (x - 1) * (x + 2); }));
  EXPECT_EQ(twice.search, RootSearch::certified);
  expect_points(twice, {-2, 1}, 1e-6);
  const Roots thrice = find_roots(of_one(-3, 4, [](double x) { return std::pow(x - 1, 3); }));
  EXPECT_EQ(thrice.search, RootSearch::certified);
  expect_points(thrice, {1}, 1e-4);
  const Roots at_end = find_roots(of_one(0, infinity, [](double x) { return x * x; }));
  EXPECT_EQ(at_end.search, RootSearch::certified);
  expect_points(at_end, {0}, 1e-6);
}

TEST(RootsOfOneUnknown, AMinimumCountsAsARootJustWhenTheEquationsCountAsSatisfied) {
  EXPECT_EQ(find_roots(of_one(-3, 4, [](double x) { return (x - 1) * (x - 1) + 1e-10; })).points.size(), 1u);
  const Roots none = find_roots(of_one(-3, 4, [](double x) { return (x - 1) * (x - 1) + 1e-8; }));
  EXPECT_EQ(none.search, RootSearch::certified);
  EXPECT_TRUE(none.points.empty());
  EXPECT_NEAR(none.best_misfit, 1e-8, 1e-9);
}

TEST(RootsOfOneUnknown, TrigonometricEquationsHaveTheRootsThatADenseScanSees) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  constexpr double half_turn = 3.141592653589793;
  constexpr int steps = 20000;
  for (int trial = 0; trial < 300; ++trial) {
    double a[7];
    for (double& c : a) c = normal(random);
    const auto f = [&](double x) {
      return a[0] + a[1] * std::cos(x) + a[2] * std::sin(x) + a[3] * std::cos(2 * x) + a[4] * std::sin(2 * x) +
             a[5] * std::cos(3 * x) + a[6] * std::sin(3 * x);
    };
    std::vector<double> changes;
    bool touches = false;  // between two samples of a scan a pair of roots can hide
    const double h = 2 * half_turn / steps;
    for (int i = 0; i < steps; ++i) {
      const double x = -half_turn + i * h, here = f(x), next = f(x + h);
      if (here * next < 0) changes.push_back(x + h / 2);
      touches = touches || (std::abs(here) < 1e-5 && std::abs(next - here) < 1e-6);
    }
    if (touches) continue;
    const Roots roots = find_roots(of_one(-half_turn, half_turn, f));
    EXPECT_EQ(roots.search, RootSearch::certified);
    expect_points(roots, changes, h);
    EXPECT_LT(roots.evaluations, 150u);
  }
}

TEST(RootsOfOneUnknown, PolesAreNoRoots) {
  const Roots tangent = find_roots(of_one(0, 20, [](double x) { return std::tan(x) - x; }));
  EXPECT_EQ(tangent.search, RootSearch::certified);
  expect_points(tangent,
                {0, 4.493409457909064, 7.725251836937707, 10.90412165942890, 14.06619391283147, 17.22075527193077},
                1e-4);
  for (std::size_t i = 1; i < tangent.points.size(); ++i) {
    const double x = tangent.points[i][0];
    EXPECT_NEAR(std::tan(x), x, 1e-9 * x);
  }
  const Roots hyperbola = find_roots(of_one(-infinity, infinity, [](double x) { return 1 / x; }));
  EXPECT_EQ(hyperbola.search, RootSearch::certified);
  EXPECT_TRUE(hyperbola.points.empty());
  const Roots shifted = find_roots(of_one(0, infinity, [](double x) { return 1 / x - 2; }));
  EXPECT_EQ(shifted.search, RootSearch::certified);
  expect_points(shifted, {0.5}, 1e-12);
}

TEST(RootsOfOneUnknown, ARootCloseToAPoleIsNotTakenForPartOfIt) {
  for (const double gap : {1e-1, 1e-3, 1e-5}) {
    const Roots roots = find_roots(of_one(-3, 4, [&](double x) { return (x - 1) / (x - 1 - gap); }));
    expect_points(roots, {1}, 1e-9);
  }
}

TEST(RootsOfOneUnknown, CornersAndJumpsAreSurvived) {
  expect_points(find_roots(of_one(-3, 4, [](double x) { return std::abs(x - 1) - 0.5; })), {0.5, 1.5}, 1e-10);
  const Roots jump = find_roots(of_one(-3, 4, [](double x) { return x < 0.3 ? -1.0 : 2 + x; }));
  EXPECT_TRUE(jump.points.empty());
}

TEST(RootsOfOneUnknown, RootsAtAnEndCountAndThoseOutsideDoNot) {
  const auto f = [](double end) { return [=](double x) { return (x - end) * (x - 1); }; };
  expect_points(find_roots(of_one(0, infinity, f(0))), {0, 1}, 1e-12);
  expect_points(find_roots(of_one(0, infinity, f(-1e-6))), {1}, 1e-12);
  RootProblem problem = of_one(0, infinity, f(0));
  problem.ranges[0].lower_open = true;
  const Roots open = find_roots(problem);
  EXPECT_EQ(open.search, RootSearch::certified);
  expect_points(open, {1}, 1e-12);
}

TEST(RootsOfOneUnknown, InfiniteRangesAreCertifiedAsFarAsTheReach) {
  const Roots roots = find_roots(of_one(0, infinity, [](double x) { return (x - 3e5) * (x - 1); }));
  EXPECT_EQ(roots.search, RootSearch::certified);
  EXPECT_GE(roots.reach, 3e5);
  ASSERT_EQ(roots.points.size(), 2u);
  EXPECT_NEAR(roots.points[1][0], 3e5, 1e-4);
  const Roots downward = find_roots(of_one(-infinity, 2, [](double x) { return (x + 70) * (x - 1) * (x - 3); }));
  EXPECT_EQ(downward.search, RootSearch::certified);
  expect_points(downward, {-70, 1}, 1e-9);
}

TEST(RootsOfOneUnknown, TheScaleOfTheUnknownDoesNotMatter) {
  for (const double scale : {1e-9, 1e-3, 1.0, 1e12}) {
    RootProblem problem;
    problem.ranges = {{-infinity, infinity, scale}};
    problem.equations = [=](const std::vector<double>& x) {
      const double u = x[0] / scale;
      return equations_from({(u - 0.4) * (u + 3)});
    };
    const Roots roots = find_roots(problem);
    EXPECT_EQ(roots.search, RootSearch::certified);
    ASSERT_EQ(roots.points.size(), 2u);
    EXPECT_NEAR(roots.points[1][0], 0.4 * scale, 1e-12 * scale);
  }
}

TEST(RootsOfOneUnknown, SeveralEquationsHaveTheirCommonRootsOnly) {
  RootProblem problem;
  problem.ranges = {{-infinity, infinity, 1}};
  problem.equations = [](const std::vector<double>& x) {
    const double common = x[0] - 0.7;
    return equations_from({common * (x[0] + 2), 0, common * (x[0] - 5), -2 * common * (x[0] + 2)});
  };
  const Roots roots = find_roots(problem);
  EXPECT_EQ(roots.search, RootSearch::certified);
  expect_points(roots, {0.7}, 1e-12);
}

TEST(RootsOfOneUnknown, EquationsThatHoldInAWholePartLeaveTheUnknownOpen) {
  const Roots roots = find_roots(of_one(-3, 4, [](double x) { return std::max(x, 0.0) - x; }));
  EXPECT_TRUE(roots.open);
  EXPECT_EQ(roots.open_unknowns, std::vector<std::size_t>{0});
  ASSERT_FALSE(roots.points.empty());
  EXPECT_GE(roots.points[0][0], 0);
  ASSERT_EQ(roots.alternative.size(), 1u);
  EXPECT_NE(roots.alternative[0], roots.points[0][0]);
}

TEST(RootsOfOneUnknown, WithoutAnyValueNothingIsCertified) {
  RootProblem problem;
  problem.ranges = {{-infinity, infinity, 1}};
  problem.equations = [](const std::vector<double>&) { return std::nullopt; };
  const Roots roots = find_roots(problem);
  EXPECT_EQ(roots.search, RootSearch::many_starts);
  EXPECT_TRUE(roots.points.empty());
  EXPECT_EQ(roots.best_misfit, infinity);
}

TEST(RootsOfOneUnknown, RootsAreFoundThroughNoise) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> noise(-1e-11, 1e-11);
  const Roots roots = find_roots(of_one(-3, 4, [&](double x) { return x * x * x - x + 0.2 + noise(random); }));
  expect_points(roots, {-1.088033914, 0.209148848, 0.878885066}, 1e-8);
}

TEST(RootsOfOneUnknown, WhatIsNoFunctionEndsWithoutACertificate) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const Roots roots = find_roots(of_one(-3, 4, [&](double) { return normal(random); }));
  EXPECT_EQ(roots.search, RootSearch::many_starts);
  EXPECT_FALSE(roots.unresolved.empty());
  EXPECT_LE(roots.unresolved.size(), 6u);
  EXPECT_LT(roots.evaluations, 30000u);
}

TEST(RootsOfOneUnknown, AZeroOfTheSmootherFunctionMustSatisfyTheEquations) {
  RootProblem problem;
  problem.ranges = {{-infinity, infinity, 1}};
  problem.equations = [](const std::vector<double>& x) {
    // The equations have a corner; multiplied with x + 2 and squared off they are smooth.
    RootEquations equations = equations_from({std::abs(x[0] - 1)});
    equations.smooth = {(x[0] - 1) * (x[0] + 2)};
    equations.smooth_size = 1 + x[0] * x[0];
    return equations;
  };
  const Roots roots = find_roots(problem);
  EXPECT_EQ(roots.points.size(), 1u);
  EXPECT_NEAR(roots.points[0][0], 1, 1e-9);
}

TEST(RootsOfOneUnknown, GivenSlopesAreUsed) {
  RootProblem problem = of_one(-3, 4, [](double x) { return std::abs(x) * x - 1; });
  int calls = 0;
  problem.slopes = [&](const std::vector<double>& x, std::vector<std::vector<double>>* slopes) {
    ++calls;
    *slopes = {{2 * std::abs(x[0])}};
    return equations_from({std::abs(x[0]) * x[0] - 1});
  };
  RootProblem touching = of_one(-3, 4, [](double x) { return x * x; });
  touching.slopes = [&](const std::vector<double>& x, std::vector<std::vector<double>>* slopes) {
    ++calls;
    *slopes = {{2 * x[0]}};
    return equations_from({x[0] * x[0]});
  };
  expect_points(find_roots(problem), {1}, 1e-10);
  expect_points(find_roots(touching), {0}, 1e-6);
  EXPECT_GT(calls, 0);
}

TEST(RootsOfOneUnknown, WhereNoSlopesAreGivenDifferencesAreTaken) {
  RootProblem touching = of_one(-3, 4, [](double x) { return x * x; });
  int calls = 0;
  touching.slopes = [&](const std::vector<double>&, std::vector<std::vector<double>>*) {
    ++calls;
    return std::nullopt;
  };
  expect_points(find_roots(touching), {0}, 1e-6);
  EXPECT_GT(calls, 0);
}

}  // namespace roots_one_unknown_test
}  // namespace poinsot::solve
