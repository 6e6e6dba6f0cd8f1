// Eigenvalues of a matrix whose entries are known so far only, each with its own accuracy.
#pragma once

#include <Eigen/Dense>
#include <complex>

namespace poinsot::solve {

// A slow growth beside a fast spin is a small difference of large numbers, once they are taken as parts of one pace:
// what is computed of differences is computed in longer numbers.
using Real = long double;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using ComplexMatrix = Eigen::Matrix<std::complex<Real>, Eigen::Dynamic, Eigen::Dynamic>;

// A matrix, and by how much each of its entries may be off.
struct Doubted {
  Matrix value, doubt;
};

struct Rates {
  Eigen::Matrix<std::complex<Real>, Eigen::Dynamic, 1> value;
  Eigen::VectorXd doubt;  // of each, by perturbation of first order
  ComplexMatrix motion;   // a column for each
};

// Eigenvalues, each with its own accuracy: |w| D |x| of left and right vectors with w x = 1 and the entries' doubts D.
// Where some meet, the doubt grows beyond bounds.
Rates rates_of(const Doubted& A);

}  // namespace poinsot::solve
