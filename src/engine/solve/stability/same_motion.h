// Deviations from a steady motion that lead to the same motion again, or to the same motion at another place. They do
// not decay, and say nothing about stability, so they are taken out before rates of growth are computed.
#pragma once

#include <vector>

#include "engine/solve/stability/doubted_rates.h"

namespace poinsot::solve {

// The conditions that deviations satisfy: rows of length one, and a bound for the error of each.
struct DeviationRows {
  Matrix value;
  Vector doubt;
};

struct SameMotion {
  // Independent columns: displacements that change nothing; pairs that go round in a frame that turns, with the
  // velocities by which they move farther away; and what makes these change steadily, as rolling in another direction
  // does.
  Matrix elsewhere;
  std::vector<double> going_round;  // the angular frequencies of these pairs, as parts of the pace
  Eigen::Index momenta = 0;         // how many further eigenvalues vanish because momenta are conserved
};

// A: the matrix of the deviations, coordinates first, then velocities, in natural units. displacements: candidates of
// length one; those that the rows exclude are left out.
SameMotion same_motion(const Doubted& A, const DeviationRows& rows, const std::vector<Vector>& displacements);

// How closely displacements must satisfy the constraints, or may depend on each other, as parts of their length: far
// above the rounding of long doubles, far below any displacement that is meant.
constexpr Real within = 1e-9L;

// An orthonormal basis of all vectors that are perpendicular to the columns. dependent: the part of a column, of the
// longest, that counts as rounding where the rest of it depends on the others.
Matrix complement(const Matrix& columns, Real dependent = within);

// The directions for which A n vanishes within its doubt, as columns of length one, and what A is on their complement
// `others`, where it has its other eigenvalues.
struct VanishingDirections {
  Matrix directions, others;
  Doubted rest;
};
VanishingDirections vanishing_directions(const Doubted& A);

}  // namespace poinsot::solve
