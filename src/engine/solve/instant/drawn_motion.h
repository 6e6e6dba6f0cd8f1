// Bodies on their way through space, from the figure alone: how each link takes the drawn space along, and differences
// over time. The checks that share nothing with the solver stand on it.
#pragma once

#include <array>
#include <vector>

#include "poinsot/engine/solve/instant/particle_check.h"

namespace poinsot::solve::drawn {

using Real = long double;
using Vector = Vector3<Real>;

inline Vector widened(const Vector3<double>& a) { return {a.x, a.y, a.z}; }

// A rigid displacement from the drawn pose, on ground axes: x goes to shift + turn x.
struct Displacement {
  Matrix3<Real> turn = Matrix3<Real>::identity();
  Vector shift = Vector::zero();
  Vector operator()(const Vector& x) const { return turn * x + shift; }
};

// Where each link carries the space of the drawing at the time t from now. Coordinates go as q + v t + a t^2/2: first
// and second derivatives at t = 0 depend on no more.
std::vector<Displacement> displacements(const std::vector<CheckLink>& links, const std::vector<double>& q,
                                        const std::vector<double>& v, const std::vector<double>& a, Real t);

// Central differences of eighth order over nine points.
inline constexpr std::array<Real, 4> first_weights{Real(4) / 5, -Real(1) / 5, Real(4) / 105, -Real(1) / 280};
inline constexpr std::array<Real, 4> second_weights{Real(8) / 5, -Real(1) / 5, Real(8) / 315, -Real(1) / 560};

// In the time 1/pace everything moves by about its own size: the sum over the coordinates of the rates and of the roots
// of the accelerations, lengths divided by `length`.
Real pace_of(const std::vector<CheckLink>& links, const std::vector<double>& v, const std::vector<double>& a,
             Real length);

// The time between two points of the differences, as part of 1/pace: no angle changes by more than a few hundredths, so
// that what the differences leave out, of the eighth power, is less than 1e-13. A shorter step would leave more of the
// rounding of coordinates.
inline constexpr Real step_of_pace = Real(0.02);

}  // namespace poinsot::solve::drawn
