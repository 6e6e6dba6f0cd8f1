// The shapes of modes: eigenvectors of the deviations that constraints allow.
#pragma once

#include <optional>

#include "engine/solve/stability/doubted_rates.h"
#include "poinsot/engine/solve/stability/linearisation.h"

namespace poinsot::solve {

// x' = A x near a steady motion, for x on a basis of all deviations that the constraints allow, those that lead to the
// same motion elsewhere among them. Rates are parts of the pace.
struct AllowedDeviations {
  Matrix A;
  Matrix basis;  // a column for each x: deviations of the coordinates and of the velocities, as parts of `scale`
  Vector scale;
};
// Nothing if the motion is not steady.
std::optional<AllowedDeviations> allowed_deviations(const SteadyMotion& motion);

// The eigenvector of a rate, of length one, and how far A is from having another one for it: the second smallest
// singular value of A - rate.
struct RateMotion {
  ComplexVector motion;
  Real apart = 0;
};
RateMotion motion_of_rate(const Matrix& A, std::complex<Real> rate);
// As a part of the pace: eigenvectors of rates that are closer together are not told. Those of the second road, whose
// slopes are differences, are then still good to a few digits.
constexpr Real apart_enough = 1e-5L;

// Whether a mode neither grows, dies out nor swings, as far as it is known.
bool is_neutral(const Mode& mode);
// The slowest rate among modes that is known, 1/s; zero if there is none.
double slowest_rate(const std::vector<Mode>& modes);
// The same where others are not known that are slower by far, as drifts are; else zero.
double slowest_beside_drifts(const Linearisation& linearisation);

}  // namespace poinsot::solve
