// Polynomials of one or two variables in [-1, 1] with vectors as values, in products of Chebyshev polynomials.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstddef>

namespace poinsot::solve {

using Pair = std::array<double, 2>;

// sum_ij c_ij T_i(s_0) T_j(s_1). A polynomial of one variable has the size 1 in the second one.
class ChebyshevSeries {
 public:
  ChebyshevSeries() = default;
  ChebyshevSeries(Eigen::Index components, Eigen::Index size0, Eigen::Index size1);

  Eigen::Index components() const { return c_.rows(); }
  Eigen::Index size(int variable) const { return size_[static_cast<std::size_t>(variable)]; }
  // A column with one coefficient for each component.
  auto coefficient(Eigen::Index i, Eigen::Index j) { return c_.col(i + size_[0] * j); }
  auto coefficient(Eigen::Index i, Eigen::Index j) const { return c_.col(i + size_[0] * j); }
  // All coefficients: components x (size0 * size1).
  const Eigen::MatrixXd& coefficients() const { return c_; }
  Eigen::MatrixXd& coefficients() { return c_; }

  Eigen::VectorXd operator()(const Pair& s) const;
  // The values, and their derivatives by the variables: components x 2.
  Eigen::VectorXd with_slopes(const Pair& s, Eigen::MatrixXd& slopes) const;

  // The same polynomial on the part s = middle + half * s' of one variable, as a series in s'.
  ChebyshevSeries restricted(int variable, double middle, double half) const;
  // The derivative by a variable.
  ChebyshevSeries derivative(int variable) const;
  // Drops the highest coefficients as long as the sum of their norms stays below `tolerance`; returns that sum.
  double trim(double tolerance);

 private:
  std::array<Eigen::Index, 2> size_{1, 1};
  Eigen::MatrixXd c_;
};

// Interpolation at the `count` points cos(k pi / (count + 1)), k = 1...count: zeros of the Chebyshev polynomials of the
// second kind, without the ends of the interval, and those for count are among those for 2 count + 1 (W. Filippi,
// 1964).
double inner_point(Eigen::Index count, Eigen::Index k);  // k from 0, descending
// values: one column for each point of a grid, the first variable running fastest.
ChebyshevSeries interpolated(const Eigen::MatrixXd& values, Eigen::Index count0, Eigen::Index count1);

}  // namespace poinsot::solve
