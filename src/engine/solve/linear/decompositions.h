// Eigen's decompositions of dense matrices, compiled once. Who includes this header in place of <Eigen/Dense> takes the
// algorithms from decompositions.cpp: compiling them wherever they are used, above all the singular values, takes a
// large part of the time of building the engine.
#pragma once

#include <Eigen/Dense>

namespace Eigen {

extern template void ColPivHouseholderQR<MatrixXd>::computeInPlace();
extern template void CompleteOrthogonalDecomposition<MatrixXd>::computeInPlace();
extern template void FullPivLU<MatrixXd>::computeInPlace();
extern template void PartialPivLU<MatrixXd>::compute();
extern template JacobiSVD<MatrixXd>& JacobiSVD<MatrixXd>::compute(const MatrixXd&, unsigned);
extern template LDLT<MatrixXd>& LDLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);

// What qr.solve(b) calls where b is a vector by itself. For other right sides (a part of a vector, a negative) it is
// compiled where it stands.
extern template void ColPivHouseholderQR<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;
extern template void CompleteOrthogonalDecomposition<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;

}  // namespace Eigen
