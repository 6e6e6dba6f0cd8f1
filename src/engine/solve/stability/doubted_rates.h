// Eigenvalues of a matrix whose entries are known with an error bound each, and the error bounds of the eigenvalues.
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <concepts>
#include <optional>

namespace poinsot::solve {

// In natural units a slow growth beside a fast spin is a small difference of large numbers. So the matrix is built
// from differences in doubles but its eigenvalues are computed in long doubles.
using Real = long double;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using ComplexMatrix = Eigen::Matrix<std::complex<Real>, Eigen::Dynamic, Eigen::Dynamic>;

// What costs time here is compiling, not computing: Eigen is compiled anew for each kind of expression that is
// multiplied or solved for. Factors are therefore plain matrices, whose products and inverses are compiled in one file:
// for them these operators are taken before those of Eigen.
Matrix product(const Matrix& A, const Matrix& B);
Vector product(const Matrix& A, const Vector& x);
ComplexMatrix product(const ComplexMatrix& A, const ComplexMatrix& B);
template <std::same_as<Matrix> Plain>
Matrix operator*(const Plain& A, const Plain& B) {
  return product(A, B);
}
template <std::same_as<Matrix> Plain, std::same_as<Vector> Column>
Vector operator*(const Plain& A, const Column& x) {
  return product(A, x);
}
template <std::same_as<ComplexMatrix> Plain>
ComplexMatrix operator*(const Plain& A, const Plain& B) {
  return product(A, B);
}

// left^T A right.
Matrix between(const Matrix& left, const Matrix& A, const Matrix& right);

ComplexMatrix inverse(const ComplexMatrix& A);

// A matrix, and a bound for the error of each entry.
struct Doubted {
  Matrix value, doubt;
};

using ComplexVector = Eigen::Matrix<std::complex<Real>, Eigen::Dynamic, 1>;

// Eigenvalues, and if they are wanted eigenvectors, one a column. Nothing if they cannot be computed.
struct Spectrum {
  ComplexVector value;
  ComplexMatrix motion;
};
std::optional<Spectrum> spectrum_of(const Matrix& A, bool with_motions);

struct Rates {
  ComplexVector value;
  Eigen::VectorXd doubt;  // a bound for the error of each, by perturbation of first order
  ComplexMatrix motion;   // eigenvectors, a column for each value
};

// The eigenvalues and a bound for the error of each: |w| D |x|, with left and right eigenvectors w x = 1 and the
// bounds D of the entries. Where eigenvalues coincide the bound becomes infinite.
Rates rates_of(const Doubted& A);

}  // namespace poinsot::solve
