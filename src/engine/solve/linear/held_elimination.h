// Overdetermined linear equations A y = b whose numbers vary with something else: what is left of them when the
// unknowns y are eliminated, as a function that is as smooth as A and b.
//
// The misfit of a least-squares solution also vanishes just where the equations can be satisfied, but it has narrow
// features where A loses rank, and corners where its weights have them. Gauss's elimination with the same pivots
// everywhere gives, with A11 for the pivots' rows and columns,
//   remainder = det A11 (b2 - A21 A11^-1 b1),
// whose entries are determinants (bordered minors of [A b], Cramer's rule): polynomials in the entries of A and b.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

namespace poinsot::solve {

// The pivots of one system, to be held for others of its size.
struct HeldPivots {
  Eigen::PermutationMatrix<Eigen::Dynamic> rows, columns;  // bring the pivots to the upper left corner
  Eigen::Index rank = 0;
  double log_determinant = 0;  // of |det A11|
  bool negative = false;       // sign of det A11
};

// By complete pivoting. A: equations x unknowns, with rows and columns scaled to entries near one; the scaling must be
// the same for all systems. The system should be one of the highest rank. late: of each row, whether it is a pivot's
// only where the others have none of good size left.
HeldPivots pivots_of(const Eigen::MatrixXd& A, double rank_tolerance = 1e-11, const std::vector<bool>& late = {});

struct Remainder {
  Eigen::VectorXd values;    // one for each equation that is no pivot's, relative to det A11 of the pivots' system
  double size = 0;           // of the largest term in them
  double ratio = 1;          // of det A11 to that of the pivots' system
  Eigen::VectorXd solution;  // of the pivots' equations; unknowns without a pivot are zero
};

// A y = b has a solution only where all values vanish; conversely they tell that it has one unless A11 is singular
// there. right_size: of the terms that b was made from. Nothing where A11 is singular to the last digit, where the
// numbers are not finite, or where A has a higher rank than the pivots (which then belong to a special system).
std::optional<Remainder> remainder_of(const HeldPivots& pivots, const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                      const Eigen::VectorXd& right_size);

// How values and solution vary when A and b do, with the pivots held. Of the remainder of the same system.
struct RemainderRates {
  Eigen::VectorXd values, solution;
};
RemainderRates remainder_rates(const HeldPivots& pivots, const Eigen::MatrixXd& A, const Remainder& remainder,
                               const Eigen::MatrixXd& A_rate, const Eigen::VectorXd& b_rate);

}  // namespace poinsot::solve
