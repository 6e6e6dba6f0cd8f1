// How the solution of linear equations varies, against differences of the solution.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <random>

#include "poinsot/engine/solve/linear/linear_system.h"

namespace poinsot::solve {
namespace linear_factors_test {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Eigen::Index integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  Matrix matrix(Eigen::Index rows, Eigen::Index columns) {
    return Matrix::NullaryExpr(rows, columns, [&] { return uniform(-1, 1); });
  }
  // Without small entries, which equilibration would blow up.
  Matrix even_matrix(Eigen::Index rows, Eigen::Index columns) {
    return Matrix::NullaryExpr(rows, columns, [&] { return (uniform(-1, 1) < 0 ? -1 : 1) * uniform(0.3, 1); });
  }
  Vector vector(Eigen::Index size) { return matrix(size, 1); }

 private:
  std::mt19937_64 engine_;
};

// Equations that vary with t: A(t) and b(t) are polynomials of the second degree, in natural units.
struct Family {
  std::vector<Matrix> A;
  std::vector<Vector> b;
  std::vector<double> unknown_scale, equation_scale;

  template <class Number>
  static auto at(const std::vector<Number>& terms, double t) {
    return Number(terms[0] + t * terms[1] + t * t * terms[2]);
  }
  template <class Scalar>
  LinearSystemOf<Scalar> system(double t) const {
    const Matrix matrix = at(A, t), slope = A[1] + 2 * t * A[2];
    const Vector right = at(b, t), right_slope = b[1] + 2 * t * b[2];
    const auto scalar = [](double value, [[maybe_unused]] double derivative) {
      Scalar x(value);
      if constexpr (!std::is_same_v<Scalar, double>) x.partial[0] = derivative;
      return x;
    };
    LinearSystemOf<Scalar> system;
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) system.add_unknown("x", unit_of_unknown(j));
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      const double unit = unit_of_equation(i);
      const std::size_t row = system.add_equation("row", unit);
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        const double factor = unit / unit_of_unknown(j);
        system.add(row, static_cast<std::size_t>(j), scalar(factor * matrix(i, j), factor * slope(i, j)));
      }
      system.add_right_side(row, scalar(unit * right[i], unit * right_slope[i]));
    }
    return system;
  }
  double unit_of_unknown(Eigen::Index j) const {
    return unknown_scale.empty() ? 1 : unknown_scale[static_cast<std::size_t>(j)];
  }
  double unit_of_equation(Eigen::Index i) const {
    return equation_scale.empty() ? 1 : equation_scale[static_cast<std::size_t>(i)];
  }
};

Vector vector_of(const std::vector<double>& x) {
  return Eigen::Map<const Vector>(x.data(), static_cast<Eigen::Index>(x.size()));
}

// By differences of the eighth order.
Vector slope_of(const std::function<Vector(double)>& f, double h = 5e-4) {
  constexpr double weights[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  Vector slope = Vector::Zero(f(0).size());
  for (int k = 1; k <= 4; ++k) slope += weights[k - 1] / h * (f(k * h) - f(-k * h));
  return slope;
}

double size_of(const Vector& x) { return x.size() ? x.cwiseAbs().maxCoeff() : 0; }

// Whether there is no corner nearby, as where another entry of a row becomes the largest, which sets its weight.
bool is_smooth(const std::function<Vector(double)>& f) {
  const Vector wide = slope_of(f), narrow = slope_of(f, 5e-5);
  return size_of(wide - narrow) <= 1e-8 * (1 + size_of(wide));
}

void expect_near(const Vector& a, const Vector& b, std::size_t seed) {
  ASSERT_EQ(a.size(), b.size());
  for (Eigen::Index i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-7 * (1 + std::abs(b[i]))) << "seed " << seed;
}

Family random_family(Random& random, Eigen::Index m, Eigen::Index n) {
  Family family;
  for (int k = 0; k < 3; ++k) {
    family.A.push_back(k == 0 ? random.even_matrix(m, n) : random.matrix(m, n));
    family.b.push_back(random.vector(m));
  }
  return family;
}

// Far from a change of rank.
bool well_conditioned(const Matrix& A) { return A.jacobiSvd().singularValues().minCoeff() > 0.2; }

// Contradicting equations: solution and misfit vary as the compromise of least squares does, whose weights vary too.
TEST(LinearFactors, DerivativesAreThoseOfTheSolutionAndOfTheMisfit) {
  Random random(1);
  std::size_t tried = 0, smooth = 0;
  for (std::size_t seed = 0; seed < 1000; ++seed) {
    const Eigen::Index n = random.integer(1, 6), m = n + random.integer(0, 4);
    Family family = random_family(random, m, n);
    if (!well_conditioned(family.A[0])) continue;
    for (Eigen::Index j = 0; j < n; ++j) family.unknown_scale.push_back(std::pow(10, random.uniform(-2, 2)));
    for (Eigen::Index i = 0; i < m; ++i) family.equation_scale.push_back(std::pow(10, random.uniform(-2, 2)));
    ++tried;
    const LinearFactors factors(family.system<double>(0));
    const auto solved = [&](double t) { return family.system<double>(t).solve(); };
    const auto misfit = [&](double t) { return vector_of(solved(t).misfit); };
    if (!is_smooth(misfit)) continue;
    ++smooth;
    const LinearDerivative derivative = factors.derivative(family.system<Dual<1>>(0));
    Vector natural = vector_of(derivative.value),
           slope = slope_of([&](double t) { return vector_of(solved(t).value); });
    for (Eigen::Index j = 0; j < n; ++j) {
      natural[j] /= family.unit_of_unknown(j);
      slope[j] /= family.unit_of_unknown(j);
    }
    expect_near(natural, slope, seed);
    expect_near(vector_of(derivative.misfit), slope_of(misfit), seed);
  }
  EXPECT_GT(smooth, tried / 2);
  EXPECT_GT(tried, 100u);
}

// Columns that depend on each other for every t: the misfit varies as if only those of a basis were there, and what is
// fixed varies as it must.
TEST(LinearFactors, RedundantUnknownsDoNotDisturb) {
  Random random(2);
  std::size_t tried = 0, smooth = 0;
  for (std::size_t seed = 0; seed < 1000; ++seed) {
    const Eigen::Index rank = random.integer(1, 4), n = rank + random.integer(1, 3), m = rank + random.integer(0, 3);
    Family family = random_family(random, m, rank);
    if (!well_conditioned(family.A[0])) continue;
    const Matrix mixing = random.even_matrix(rank, n);
    if (!well_conditioned(mixing)) continue;
    for (Matrix& A : family.A) A = A * mixing;
    if (family.A[0].cwiseAbs().minCoeff() < 0.1) continue;
    ++tried;
    const LinearFactors factors(family.system<double>(0));
    ASSERT_EQ(factors.solution().open.size(), static_cast<std::size_t>(n - rank)) << seed;
    const LinearDerivative derivative = factors.derivative(family.system<Dual<1>>(0));
    const auto solved = [&](double t) { return family.system<double>(t).solve(); };
    const auto misfit = [&](double t) { return vector_of(solved(t).misfit); };
    if (!is_smooth(misfit)) continue;
    ++smooth;
    expect_near(vector_of(derivative.misfit), slope_of(misfit), seed);
    // A x is fixed whatever is open.
    const auto sides = [&](double t) { return Vector(Family::at(family.A, t) * vector_of(solved(t).value)); };
    expect_near(family.A[0] * vector_of(derivative.value) + family.A[1] * vector_of(factors.solution().value),
                slope_of(sides), seed);
  }
  EXPECT_GT(smooth, tried / 2);
  EXPECT_GT(tried, 100u);
}

// Where all equations hold, the misfit grows with the same slope whatever the scaling: that of the search for roots.
TEST(LinearFactors, TheMisfitLeavesARootAsItsDerivativeSays) {
  Random random(3);
  std::size_t tried = 0;
  for (std::size_t seed = 0; seed < 1000; ++seed) {
    const Eigen::Index n = random.integer(1, 5), m = n + random.integer(1, 4);
    Family family = random_family(random, m, n);
    if (!well_conditioned(family.A[0])) continue;
    family.b[0] = family.A[0] * random.vector(n);
    ++tried;
    const LinearFactors factors(family.system<double>(0));
    ASSERT_TRUE(factors.solution().conflict.empty()) << seed;
    const Vector derivative = vector_of(factors.derivative(family.system<Dual<1>>(0)).misfit);
    // The scaling is not smooth: a difference of the first order, extrapolated.
    const auto misfit = [&](double t) { return vector_of(family.system<double>(t).solve().misfit); };
    constexpr double h = 1e-6;
    const Vector coarse = (misfit(h) - misfit(-h)) / (2 * h);
    EXPECT_LT(size_of(coarse - derivative), 1e-4 * (1 + size_of(derivative))) << seed;
    EXPECT_GT(size_of(derivative), 1e-6) << seed;
  }
  EXPECT_GT(tried, 100u);
}

TEST(LinearFactors, TheyOfferTheSolutionOfTheSystem) {
  Random random(4);
  for (std::size_t seed = 0; seed < 100; ++seed) {
    const Family family = random_family(random, random.integer(1, 6), random.integer(1, 6));
    const LinearSolution own = family.system<double>(0).solve();
    const LinearSolution of_duals = LinearFactors(family.system<Dual<1>>(0)).solution();
    EXPECT_EQ(own.value, of_duals.value);
    EXPECT_EQ(own.misfit, of_duals.misfit);
    EXPECT_EQ(own.open, of_duals.open);
    EXPECT_EQ(own.conflict, of_duals.conflict);
  }
}

TEST(LinearFactors, ASystemListsItsCoefficients) {
  LinearSystem system;
  const std::size_t x = system.add_unknown("x"), y = system.add_unknown("y");
  const std::size_t row = system.add_equation("sum");
  system.add(row, x, 2);
  system.add(row, y, 3);
  system.add(row, y, 4);
  system.add_right_side(row, 5);
  EXPECT_EQ(system.coefficients(), (std::vector<std::vector<double>>{{2, 7}}));
  EXPECT_EQ(system.right_sides(), std::vector<double>{5});
}

TEST(LinearFactors, WithoutEquationsNothingVaries) {
  LinearSystemOf<Dual<1>> system;
  system.add_unknown("x");
  const LinearDerivative derivative = LinearFactors(system).derivative(system);
  EXPECT_EQ(derivative.value, std::vector<double>{0});
  EXPECT_EQ(derivative.misfit, std::vector<double>{0});
}

TEST(LinearFactors, WithoutUnknownsTheMisfitVariesAsTheRightSide) {
  LinearSystemOf<Dual<1>> system;
  system.add_right_side(system.add_equation("zero = f"), {2.0, {3.0}});
  const LinearFactors factors(system);
  EXPECT_EQ(factors.solution().misfit, std::vector<double>{2});
  EXPECT_EQ(factors.derivative(system).misfit, std::vector<double>{3});
}

TEST(LinearFactors, WhatIsNotFiniteHasNoDerivative) {
  LinearSystemOf<Dual<1>> system;
  const std::size_t x = system.add_unknown("x"), row = system.add_equation("overflow");
  system.add(row, x, {std::numeric_limits<double>::infinity(), {1.0}});
  const LinearFactors factors(system);
  EXPECT_EQ(factors.solution().conflict, std::vector<std::size_t>{row});
  const LinearDerivative derivative = factors.derivative(system);
  ASSERT_EQ(derivative.value.size(), 1u);
  EXPECT_TRUE(std::isnan(derivative.value[0]));
  EXPECT_TRUE(std::isnan(derivative.misfit.at(0)));
}

}  // namespace linear_factors_test
}  // namespace poinsot::solve
