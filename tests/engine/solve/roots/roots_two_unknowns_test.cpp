#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <random>

#include "engine/solve/roots/roots_problems.h"
#include "poinsot/engine/solve/roots/roots.h"

namespace poinsot::solve {
namespace roots_two_unknowns_test {

using Points = std::vector<std::vector<double>>;

const RootRange whole_line{-infinity, infinity, 1};
const RootRange half_line{0, infinity, 1};
const RootRange three{-3, 3, 1};
const RootRange turn{-3.141592653589793, 3.141592653589793, 1};

// Every expected point is among those found, and they are as many.
void expect_points(const Roots& roots, const Points& expected, double tolerance) {
  EXPECT_EQ(roots.points.size(), expected.size());
  for (const auto& p : expected) {
    double nearest = infinity;
    for (const auto& found : roots.points) nearest = std::min(nearest, std::hypot(found[0] - p[0], found[1] - p[1]));
    EXPECT_LT(nearest, tolerance) << p[0] << ", " << p[1];
  }
}

// a0 + a1 x + a2 y + a3 x^2 + a4 x y + a5 y^2
using Conic = std::array<double, 6>;
double value(const Conic& c, double x, double y) {
  return c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
}

std::vector<double> times(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}
std::vector<double> minus(std::vector<double> a, const std::vector<double>& b) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] -= b[i];
  return a;
}

// Their intersections by another road: the resultant with respect to y, of degree four in x, by the eigenvalues of its
// companion matrix. `clear`: no two of them close together or nearly real.
Points intersections(const Conic& f, const Conic& g, bool& clear) {
  // As quadratics in y: a y^2 + b(x) y + c(x).
  const std::vector<double> a{f[5]}, b{f[2], f[4]}, c{f[0], f[1], f[3]}, p{g[5]}, q{g[2], g[4]}, s{g[0], g[1], g[3]};
  const std::vector<double> ap = minus(times(a, s), times(p, c)), bq = minus(times(a, q), times(p, b)),
                            cs = minus(times(b, s), times(q, c));
  const std::vector<double> resultant = minus(times(ap, ap), times(bq, cs));
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 4; ++i) {
    companion(i, 3) = -resultant[static_cast<std::size_t>(i)] / resultant[4];
    if (i > 0) companion(i, i - 1) = 1;
  }
  const Eigen::Vector4cd x = companion.eigenvalues();
  Points points;
  clear = true;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) clear = clear && std::abs(x[i] - x[j]) > 1e-2;
    if (std::abs(x[i].imag()) > 1e-7) continue;
    const double at = x[i].real();
    points.push_back({at, -(ap[0] + ap[1] * at + ap[2] * at * at) / (bq[0] + bq[1] * at)});
    clear = clear && std::abs(at) < 50 && std::abs(bq[0] + bq[1] * at) > 1e-2;
  }
  return points;
}

TEST(RootsOfTwoUnknowns, ConicsMeetWhereTheirResultantVanishes) {
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  std::size_t evaluations = 0, searches = 0;
  for (int trial = 0; trial < 500; ++trial) {
    Conic f, g;
    for (double& c : f) c = normal(random);
    for (double& c : g) c = normal(random);
    bool clear;
    Points expected = intersections(f, g, clear);
    if (!clear) continue;
    const bool infinite = trial % 2;
    if (!infinite) std::erase_if(expected, [](const auto& p) { return std::max(std::abs(p[0]), std::abs(p[1])) > 3; });
    const RootRange& range = infinite ? whole_line : three;
    const Roots roots = find_roots(of_two(range, range, [&](double x, double y) {
      return std::vector{value(f, x, y), value(g, x, y)};
    }));
    EXPECT_EQ(roots.search, RootSearch::certified);
    expect_points(roots, expected, 1e-6);
    evaluations += roots.evaluations;
    ++searches;
  }
  EXPECT_GT(searches, 200u);
  EXPECT_LT(evaluations, 120 * searches);
}

TEST(RootsOfTwoUnknowns, ProductsOfLinesMeetAtKnownPlaces) {
  std::mt19937_64 random(10);
  std::uniform_real_distribution<double> place(-2.5, 2.5);
  for (int trial = 0; trial < 100; ++trial) {
    const std::array<double, 3> a{place(random), place(random), place(random)},
        b{place(random), place(random), place(random)};
    const double slant = 0.3 * place(random);
    // x + slant y = a_i with y = b_j.
    Points expected;
    bool apart = true;
    for (double ai : a)
      for (double bj : b) {
        const std::vector<double> p{ai - slant * bj, bj};
        for (const auto& q : expected) apart = apart && std::hypot(p[0] - q[0], p[1] - q[1]) > 1e-3;
        expected.push_back(p);
      }
    if (!apart) continue;
    std::erase_if(expected, [](const auto& p) { return std::abs(p[0]) > 3; });
    const Roots roots = find_roots(of_two(three, three, [&](double x, double y) {
      double first = 1, second = 1;
      for (double ai : a) first *= x + slant * y - ai;
      for (double bj : b) second *= y - bj;
      return std::vector{first, second};
    }));
    EXPECT_EQ(roots.search, RootSearch::certified);
    expect_points(roots, expected, 1e-7);
  }
}

TEST(RootsOfTwoUnknowns, TheAnglesOfATwoLinkArmAreFoundForEveryTarget) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> angle(-3, 3), elbow(0.2, 2.9);
  for (int trial = 0; trial < 50; ++trial) {
    const double a = angle(random), b = elbow(random);
    const double X = 2 * std::cos(a) + std::cos(a + b), Y = 2 * std::sin(a) + std::sin(a + b);
    // The other position is the mirror image in the line to the target.
    const double line = std::atan2(Y, X);
    double other = 2 * line - a;
    other = std::remainder(other, 2 * turn.upper);
    const Roots roots = find_roots(of_two(turn, turn, [&](double p, double q) {
      return std::vector{2 * std::cos(p) + std::cos(p + q) - X, 2 * std::sin(p) + std::sin(p + q) - Y};
    }));
    EXPECT_EQ(roots.search, RootSearch::certified);
    expect_points(roots, {{a, b}, {other, -b}}, 1e-8);
  }
}

TEST(RootsOfTwoUnknowns, TouchingCirclesMeetOnceNearlyTouchingOnesTwiceOrNot) {
  for (const RootRange& range : {three, whole_line}) {
    const auto circles = [&](double distance) {
      return find_roots(of_two(range, range, [=](double x, double y) {
        return std::vector{x * x + y * y - 1, (x - distance) * (x - distance) + y * y - 1};
      }));
    };
    const Roots touching = circles(2), crossing = circles(2 - 1e-7), apart = circles(2 + 1e-6);
    EXPECT_EQ(touching.search, RootSearch::certified);
    expect_points(touching, {{1, 0}}, 1e-4);
    EXPECT_EQ(crossing.search, RootSearch::certified);
    const double half = 1 - 0.5e-7, height = std::sqrt(1 - half * half);
    expect_points(crossing, {{half, height}, {half, -height}}, 1e-8);
    EXPECT_EQ(apart.search, RootSearch::certified);
    EXPECT_TRUE(apart.points.empty());
    EXPECT_FALSE(touching.open || crossing.open || apart.open);
  }
}

TEST(RootsOfTwoUnknowns, ACurveOfSolutionsIsOpenAfterAFewEvaluations) {
  for (const RootRange& range : {three, whole_line, half_line}) {
    const Roots roots = find_roots(of_two(range, range, [](double x, double y) {
      const double circle = x * x + y * y - 1;
      return std::vector{circle * (1.5 + x), circle * (2 - x * y), 0.0};
    }));
    EXPECT_TRUE(roots.open);
    EXPECT_EQ(roots.open_unknowns, (std::vector<std::size_t>{0, 1}));
    EXPECT_NE(roots.search, RootSearch::certified);
    ASSERT_EQ(roots.points.size(), 1u);
    ASSERT_EQ(roots.alternative.size(), 2u);
    for (const auto& p : {roots.points[0], roots.alternative}) EXPECT_NEAR(std::hypot(p[0], p[1]), 1, 1e-8);
    EXPECT_GT(std::hypot(roots.points[0][0] - roots.alternative[0], roots.points[0][1] - roots.alternative[1]), 1e-3);
    EXPECT_LT(roots.evaluations, 300u);
  }
}

TEST(RootsOfTwoUnknowns, AnUnknownWithoutInfluenceIsOpenAtAllRootsOfTheOther) {
  const Roots roots = find_roots(of_two(whole_line, half_line, [](double x, double) {
    return std::vector{x * x - 2, 0.0};
  }));
  EXPECT_TRUE(roots.open);
  EXPECT_EQ(roots.open_unknowns, std::vector<std::size_t>{1});
  ASSERT_EQ(roots.points.size(), 2u);
  EXPECT_NEAR(roots.points[0][0], -std::sqrt(2), 1e-12);
  EXPECT_NEAR(roots.points[1][0], std::sqrt(2), 1e-12);
  ASSERT_EQ(roots.alternative.size(), 2u);
  EXPECT_NEAR(std::abs(roots.alternative[0]), std::sqrt(2), 1e-12);
}

TEST(RootsOfTwoUnknowns, AngleAndLengthCostAboutAHundredEvaluations) {
  const Roots roots = find_roots(of_two({0, 1.5707963267948966, 1, true, true}, half_line, [](double angle, double L) {
    return std::vector{L * std::sin(angle) - 0.3 * std::cos(angle) + 0.1 * L * L * std::sin(angle) * std::cos(angle),
                       L * std::cos(angle) - 0.7};
  }));
  EXPECT_EQ(roots.search, RootSearch::certified);
  ASSERT_EQ(roots.points.size(), 1u);
  EXPECT_NEAR(roots.points[0][1] * std::cos(roots.points[0][0]), 0.7, 1e-12);
  EXPECT_LT(roots.evaluations, 130u);
}

TEST(RootsOfTwoUnknowns, RootsOnTheBorderCount) {
  const Roots corner = find_roots(of_two(half_line, half_line, [](double x, double y) {
    return std::vector{x * (x - 2) + y, y * (y - 3)};
  }));
  EXPECT_EQ(corner.search, RootSearch::certified);
  expect_points(corner, {{0, 0}, {2, 0}}, 1e-9);
  RootRange open = half_line;
  open.lower_open = true;
  const Roots inner = find_roots(of_two(open, half_line, [](double x, double y) {
    return std::vector{x * (x - 2) + y, y * (y - 3)};
  }));
  expect_points(inner, {{2, 0}}, 1e-9);
}

TEST(RootsOfTwoUnknowns, NoRootIsCertifiedToo) {
  const Roots roots = find_roots(of_two(whole_line, whole_line, [](double x, double y) {
    return std::vector{x * x + y * y - 1, x * y - 0.6};
  }));
  EXPECT_EQ(roots.search, RootSearch::certified);
  EXPECT_TRUE(roots.points.empty());
  EXPECT_GT(roots.best_misfit, 1e-2);
}

TEST(RootsOfTwoUnknowns, RootsAtInfinityAreNone) {
  const Roots roots = find_roots(of_two(whole_line, whole_line, [](double x, double y) {
    return std::vector{x * y - 1, y + y * y};
  }));
  EXPECT_EQ(roots.search, RootSearch::certified);
  expect_points(roots, {{-1, -1}}, 1e-10);
}

TEST(RootsOfTwoUnknowns, RationalEquationsAreFollowedBetweenTheirSingularities) {
  const Roots roots = find_roots(of_two(three, half_line, [](double x, double y) {
    return std::vector{(x * x + y - 2) / (1 + x * x + y * y), (x - 0.3 * y) / (2 + x * x)};
  }));
  EXPECT_EQ(roots.search, RootSearch::certified);
  const double x = (-1 / 0.3 + std::sqrt(1 / 0.09 + 8)) / 2;
  expect_points(roots, {{x, x / 0.3}}, 1e-9);
}

TEST(RootsOfTwoUnknowns, WhereTheEquationsHaveNoValueThereAreNoRoots) {
  RootProblem problem;
  problem.ranges = {whole_line, whole_line};
  problem.equations = [](const std::vector<double>& x) -> std::optional<RootEquations> {
    if (x[0] < 0) return std::nullopt;
    return equations_from({x[0] * x[0] - x[1] - 1, x[0] + x[1] - 3});
  };
  const Roots roots = find_roots(problem);
  const double x = (-1 + std::sqrt(17)) / 2;
  expect_points(roots, {{x, 3 - x}}, 1e-9);
  EXPECT_EQ(roots.search, RootSearch::certified);
}

TEST(RootsOfTwoUnknowns, WithoutSmoothnessTheSearchFallsBackAndSaysWhere) {
  const Roots roots = find_roots(of_two(three, three, [](double x, double y) {
    // A ragged factor, with the root untouched.
    const double ragged = 2 + std::sin(1e4 * (x + y)) + std::abs(std::cos(7e3 * (x - y)));
    return std::vector{ragged * (x - 0.5), ragged * (y + 0.25 * x * x)};
  }));
  EXPECT_EQ(roots.search, RootSearch::many_starts);
  ASSERT_FALSE(roots.unresolved.empty());
  EXPECT_LE(roots.unresolved.size(), 6u);
  for (const UnresolvedPart& part : roots.unresolved) {
    ASSERT_EQ(part.lower.size(), 2u);
    EXPECT_LT(part.lower[0], part.upper[0]);
    EXPECT_FALSE(part.reason.empty());
  }
  EXPECT_LT(roots.evaluations, 40000u);
}

}  // namespace roots_two_unknowns_test
}  // namespace poinsot::solve
