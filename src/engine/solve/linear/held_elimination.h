// Overdetermined linear equations A y = b whose numbers depend on further unknowns. The unknowns y are eliminated,
// and the remainder is a function of the further unknowns that is as smooth as A and b are.
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

// The pivots found for one system. They are kept for other systems of the same size.
struct HeldPivots {
  Eigen::PermutationMatrix<Eigen::Dynamic> rows, columns;  // bring the pivots to the upper left corner
  Eigen::Index rank = 0;
  double log_determinant = 0;  // of |det A11|
  bool negative = false;       // sign of det A11
};

// Finds the pivots by complete pivoting. A has a row for each equation and a column for each unknown, both scaled to
// entries near one; the scaling must be the same for all systems, and the system should be one of the highest rank.
// late[i]: whether row i gives a pivot only when no other row has a good one left.
HeldPivots pivots_of(const Eigen::MatrixXd& A, double rank_tolerance = 1e-11, const std::vector<bool>& late = {});

struct Remainder {
  // one for each equation without a pivot, divided by det A11 of the system that the pivots come from
  Eigen::VectorXd values;
  double size = 0;           // of the largest term in the values
  double ratio = 1;          // of det A11 to that of the system that the pivots come from
  Eigen::VectorXd solution;  // of the equations with pivots; unknowns without a pivot are zero
};

// A y = b has a solution only where all values vanish. Conversely, where they vanish it has one, unless A11 is
// singular there. right_size: the sizes of the terms that b is the sum of. Returns nothing where A11 is singular to
// the last digit, where numbers are not finite, or where A has a higher rank than the pivots (these were then taken
// from a special system).
std::optional<Remainder> remainder_of(const HeldPivots& pivots, const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                      const Eigen::VectorXd& right_size);

// The rates of the remainder's values and of its solution when A and b change at the given rates and the pivots are
// held. The remainder must be that of the same A and b.
struct RemainderRates {
  Eigen::VectorXd values, solution;
};
RemainderRates remainder_rates(const HeldPivots& pivots, const Eigen::MatrixXd& A, const Remainder& remainder,
                               const Eigen::MatrixXd& A_rate, const Eigen::VectorXd& b_rate);

}  // namespace poinsot::solve
