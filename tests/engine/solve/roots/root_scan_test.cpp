// The scan against functions whose roots are known by construction, with and without some of them kept from it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "engine/solve/roots/roots_problems.h"
#include "poinsot/engine/solve/roots/roots.h"

namespace poinsot::solve {
namespace root_scan_test {

constexpr Work enough = 1'000'000;

Roots known(std::vector<std::vector<double>> points) {
  Roots roots;
  roots.points = std::move(points);
  return roots;
}

double product(const std::vector<double>& roots, double x) {
  double value = 1;
  for (double root : roots) value *= (x - root) / 2;
  return value;
}

// Whatever root is kept from it, the scan finds; what it is told it meets, and it finds no others.
TEST(RootScan, ARootThatIsNotKnownIsFound) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-4, 4);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> all(1 + trial % 4);
    for (double& root : all) root = place(random);
    std::sort(all.begin(), all.end());
    bool apart = true;
    for (std::size_t i = 0; i + 1 < all.size(); ++i) apart = apart && all[i + 1] - all[i] > 0.25;
    if (!apart) continue;
    const double end = trial % 2 ? infinity : 5;
    const RootProblem problem = of_one(-end, end, [&](double x) { return product(all, x); });
    std::vector<std::vector<double>> points;
    for (double root : all) points.push_back({root});
    const auto whole = scan_roots(problem, known(points), enough);
    ASSERT_TRUE(whole);
    EXPECT_TRUE(whole->missed.empty());
    EXPECT_LT(whole->farthest, 1e-9);
    const std::size_t hidden = static_cast<std::size_t>(trial) % all.size();
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(hidden));
    const auto scan = scan_roots(problem, known(points), enough);
    ASSERT_EQ(scan->missed.size(), 1u) << all[hidden];
    EXPECT_NEAR(scan->missed[0][0], all[hidden], 1e-9);
  }
}

TEST(RootScan, AValueThatOnlyTouchesZeroIsARootToo) {
  for (const double at : {0.37, -1.9, 120.0}) {
    const RootProblem problem = of_one(-infinity, infinity, [&](double x) { return std::pow(x / at - 1, 2); });
    const auto scan = scan_roots(problem, known({}), enough);
    ASSERT_EQ(scan->missed.size(), 1u) << at;
    EXPECT_NEAR(scan->missed[0][0], at, 1e-5 * std::abs(at));
    EXPECT_TRUE(scan_roots(problem, known({{at}}), enough)->missed.empty());
  }
}

// Corners and jumps: of |x| - 3 a search that takes it for linear has one of two; a jump through zero is no root.
TEST(RootScan, CornersAndJumps) {
  const RootProblem corner = of_one(-20, 20, [](double x) { return std::abs(x) - 3; });
  const auto scan = scan_roots(corner, known({{3}}), enough);
  ASSERT_EQ(scan->missed.size(), 1u);
  EXPECT_NEAR(scan->missed[0][0], -3, 1e-9);
  const RootProblem jump = of_one(-20, 20, [](double x) { return x < 1.3 ? -1.0 : 1.0; });
  EXPECT_TRUE(scan_roots(jump, known({}), enough)->missed.empty());
  const RootProblem pole = of_one(-20, 20, [](double x) { return 1 / (x - 1.3); });
  EXPECT_TRUE(scan_roots(pole, known({}), enough)->missed.empty());
}

// A circle and a line through random places: two roots or none.
TEST(RootScan, TwoUnknowns) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> place(-3, 3);
  int found = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const double a = place(random), b = place(random), slope = place(random);
    const RootProblem problem = of_two({-6, 6, 1}, {-6, 6, 1}, [&](double x, double y) {
      return std::vector<double>{std::pow(x - a, 2) + std::pow(y - b, 2) - 4, y - b - slope * (x - a)};
    });
    const double half = 2 / std::sqrt(1 + slope * slope);
    const std::vector<std::vector<double>> both = {{a - half, b - slope * half}, {a + half, b + slope * half}};
    const auto whole = scan_roots(problem, known(both), enough);
    EXPECT_TRUE(whole->missed.empty());
    EXPECT_LT(whole->farthest, 1e-7);
    const auto scan = scan_roots(problem, known({both[trial % 2]}), enough);
    ASSERT_EQ(scan->missed.size(), 1u);
    EXPECT_NEAR(scan->missed[0][0], both[1 - trial % 2][0], 1e-8);
    ++found;
  }
  EXPECT_EQ(found, 40);
}

// The work goes with that of the search, but for a few dozen places.
TEST(RootScan, TheWorkIsBounded) {
  const RootProblem line = of_one(-20, 20, [](double x) { return x - 3; });
  EXPECT_LT(scan_roots(line, known({{3}}), 0)->places, 60u);
  EXPECT_GT(scan_roots(line, known({{3}}), enough)->places, 300u);
  const RootProblem plane = of_two({-6, 6, 1}, {-6, 6, 1}, [](double x, double y) {
    return std::vector<double>{x, y};
  });
  EXPECT_LT(scan_roots(plane, known({{0, 0}}), 0)->places, 200u);
}

TEST(RootScan, WhatIsOpenOrCostlyIsNotScanned) {
  RootProblem problem = of_one(-20, 20, [](double x) { return x - 3; });
  Roots open = known({{3}});
  open.open = true;
  EXPECT_FALSE(scan_roots(problem, open, enough));
  problem.costly = true;
  EXPECT_FALSE(scan_roots(problem, known({{3}}), enough));
}

}  // namespace root_scan_test
}  // namespace poinsot::solve
