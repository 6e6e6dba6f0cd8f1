// Deviations from a steady motion that lead to the same motion again, or to the same elsewhere: they are none of the
// motion near it.
#pragma once

#include <vector>

#include "engine/solve/stability/doubted_rates.h"

namespace poinsot::solve {

// What deviations satisfy: rows of length one, and by how much each may be off.
struct DeviationRows {
  Matrix value;
  Vector doubt;
};

struct SameMotion {
  // Independent columns: displacements that change nothing, pairs that go round in a frame that turns (with velocities
  // by which they go ever farther), and what lets these change steadily, as rolling in another direction does.
  Matrix elsewhere;
  std::vector<double> going_round;  // the frequencies of these pairs, as parts of the pace
  Eigen::Index momenta = 0;         // how many rates of momenta may vanish beside them
};

// A: of the deviations, coordinates first, then velocities, in natural units. displacements: of length one, those that
// may lead to the same motion again; what the rows do not allow does not.
SameMotion same_motion(const Doubted& A, const DeviationRows& rows, const std::vector<Vector>& displacements);

// An orthonormal basis of what is at right angles to all columns.
Matrix complement(const Matrix& columns);

}  // namespace poinsot::solve
