// Systems in which all unknowns but one or two enter linearly: all roots, against a dense scan of a determinant.
#include "engine/solve/roots/partly_linear.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "case_count.h"
#include "engine/solve/roots/roots_problems.h"
#include "poinsot/engine/solve/roots/roots.h"

namespace poinsot::solve {
namespace partly_linear_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// [A(x) b(x)] with entries a + b x + c sin(d x + e): so many equations for one less linear unknowns and x.
class RandomSystem {
 public:
  RandomSystem(std::mt19937_64& random, Index equations) : equations_(equations) {
    std::normal_distribution<double> normal;
    for (Index i = 0; i < equations * equations; ++i)
      entries_.push_back({normal(random), normal(random), normal(random), 2 * normal(random), normal(random)});
  }

  MatrixXd bordered(double x) const {
    MatrixXd M(equations_, equations_);
    for (Index i = 0; i < equations_; ++i)
      for (Index j = 0; j < equations_; ++j) {
        const auto& c = entries_[static_cast<std::size_t>(i * equations_ + j)];
        M(i, j) = c[0] + c[1] * x + c[2] * std::sin(c[3] * x + c[4]);
      }
    return M;
  }

  // Unknowns: the linear ones and x among them at `place`.
  RootProblem problem(Index place) const {
    RootProblem problem;
    problem.ranges.assign(static_cast<std::size_t>(equations_), {-infinity, infinity, 1});
    problem.ranges[static_cast<std::size_t>(place)] = {-2, 2, 1};
    problem.equations = [this, place](const std::vector<double>& u) {
      const MatrixXd M = bordered(u[static_cast<std::size_t>(place)]);
      VectorXd y(equations_);
      for (Index k = 0, j = 0; k < equations_; ++k)
        if (k != place) y[j++] = u[static_cast<std::size_t>(k)];
      y[equations_ - 1] = 1;
      RootEquations equations;
      const VectorXd r = M * y;
      equations.values.assign(r.begin(), r.end());
      equations.size = (M.cwiseAbs() * y.cwiseAbs()).maxCoeff();
      return equations;
    };
    return problem;
  }

  // Where the determinant vanishes; nothing where two places, or one and the end, can hardly be told apart, or where
  // the linear unknowns are hardly fixed.
  std::optional<std::vector<double>> scanned() const {
    constexpr int count = 20000;
    std::vector<double> f, roots;
    double size = 0;
    for (int i = 0; i <= count; ++i) {
      f.push_back(bordered(-2 + 4.0 * i / count).determinant());
      size = std::max(size, std::abs(f.back()));
    }
    if (std::abs(f.front()) < 1e-4 * size || std::abs(f.back()) < 1e-4 * size) return std::nullopt;
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0 && std::abs(f[i]) < std::abs(f[i - 1]) && std::abs(f[i]) < std::abs(f[i + 1]) &&
          f[i - 1] * f[i + 1] > 0 && std::abs(f[i]) < 1e-4 * size)
        return std::nullopt;
      if (f[i] * f[i + 1] > 0) continue;
      double low = -2 + 4.0 * static_cast<double>(i) / count, high = low + 4.0 / count;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle = (low + high) / 2;
        (bordered(low).determinant() * bordered(middle).determinant() <= 0 ? high : low) = middle;
      }
      const MatrixXd A = bordered(low).leftCols(equations_ - 1);
      if (Eigen::JacobiSVD<MatrixXd>(A).singularValues().minCoeff() < 1e-2) return std::nullopt;
      roots.push_back(low);
    }
    for (std::size_t i = 1; i < roots.size(); ++i)
      if (roots[i] - roots[i - 1] < 1e-2) return std::nullopt;
    return roots;
  }

 private:
  Index equations_;
  std::vector<std::array<double, 5>> entries_;
};

TEST(PartlyLinear, AllRootsOfOneUnknownAndLinearOnes) {
  std::mt19937_64 random(91);
  constexpr int cases = poinsot::testing::case_count(300);
  int done = 0;
  std::size_t most = 0;
  for (int trial = 0; done < cases && trial < 10 * cases; ++trial) {
    const Index equations = 3 + trial % 3;
    const RandomSystem system(random, equations);
    const auto expected = system.scanned();
    if (!expected) continue;
    ++done;
    most = std::max(most, expected->size());
    const Index place = trial % equations;
    const RootProblem problem = system.problem(place);
    const Roots roots = find_roots(problem);
    EXPECT_EQ(roots.search, RootSearch::certified) << trial;
    EXPECT_FALSE(roots.open);
    ASSERT_EQ(roots.points.size(), expected->size()) << trial;
    std::vector<double> found;
    for (const auto& point : roots.points) found.push_back(point[static_cast<std::size_t>(place)]);
    std::sort(found.begin(), found.end());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], (*expected)[i], 1e-9) << trial;
    for (const auto& point : roots.points) {
      const auto values = problem.equations(point);
      for (const double value : values->values) EXPECT_LT(std::abs(value), 1e-10 * values->size);
    }
  }
  EXPECT_EQ(done, cases);
  EXPECT_GE(most, 4U);
}

// x^2 + y^2 = 4 and y = x^3 - x, with two that follow: u = x + y, v + u y = 1.
TEST(PartlyLinear, TwoUnknownsAndLinearOnes) {
  RootProblem problem;
  problem.ranges.assign(4, {-infinity, infinity, 1});
  problem.ranges[1] = problem.ranges[3] = {-3, 3, 1};
  problem.equations = [](const std::vector<double>& p) {
    const double u = p[0], x = p[1], v = p[2], y = p[3];
    return equations_from({x * x + y * y - 4, u - x - y, v + u * y - 1, y - x * x * x + x});
  };
  const Roots roots = find_roots(problem);
  EXPECT_EQ(roots.search, RootSearch::certified);
  ASSERT_EQ(roots.points.size(), 2u);
  for (const auto& p : roots.points) {
    EXPECT_NEAR(p[1] * p[1] + p[3] * p[3], 4, 1e-10);
    EXPECT_NEAR(p[3], p[1] * p[1] * p[1] - p[1], 1e-10);
    EXPECT_NEAR(p[2], 1 - (p[1] + p[3]) * p[3], 1e-10);
  }
}

TEST(PartlyLinear, WithoutARootNoneExists) {
  RootProblem problem;
  problem.ranges.assign(3, {-infinity, infinity, 1});
  problem.equations = [](const std::vector<double>& p) {
    return equations_from({p[0] * p[0] + p[1] + 2, p[1] - p[2], p[1] + p[2] + 2 - p[0] * p[0]});
  };
  // y = z = -x^2 - 2 = x^2/2 - 1.
  const Roots roots = find_roots(problem);
  EXPECT_EQ(roots.search, RootSearch::certified);
  EXPECT_TRUE(roots.points.empty());
}

// A root outside the range of a linear unknown is none.
TEST(PartlyLinear, RangesOfTheLinearUnknownsCount) {
  RootProblem problem;
  problem.ranges = {{-3, 3, 1}, {0, infinity, 1}, {-infinity, infinity, 1}};
  problem.equations = [](const std::vector<double>& p) {
    return equations_from({p[0] * p[0] - 4, p[1] - p[0], p[2] - p[0] * p[1]});
  };
  const Roots roots = find_roots(problem);
  EXPECT_EQ(roots.search, RootSearch::certified);
  ASSERT_EQ(roots.points.size(), 1u);
  EXPECT_NEAR(roots.points[0][1], 2, 1e-12);
  EXPECT_NEAR(roots.points[0][2], 4, 1e-12);
}

}  // namespace partly_linear_test
}  // namespace poinsot::solve
