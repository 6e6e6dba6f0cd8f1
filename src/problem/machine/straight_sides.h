// Where a stated body is straight: rods, edges of plates and blocks, flat sides.
#pragma once

#include <vector>

#include "problem/machine/data.h"

namespace poinsot::problem {

// The directions (as drawn) in which the body goes on straight to both sides of the place C, across the normal n of a
// contact there: that of an edge, two of a flat side. None at a corner, at a particle, and where the body is not known
// to be straight. Scalar: double, Dual<1> or a formula; plain numbers decide.
template <class Scalar>
std::vector<Vector3<double>> straight_directions(const Body& body, DataScope<Scalar>& data, const Vector3<double>& C,
                                                 const Vector3<double>& n);

}  // namespace poinsot::problem
