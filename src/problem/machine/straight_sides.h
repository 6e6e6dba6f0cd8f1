// Finds where a body is straight: on rods, edges of plates and blocks, and flat sides; and what is not on any of them.
#pragma once

#include <optional>
#include <vector>

#include "problem/machine/data.h"

namespace poinsot::problem {

// The directions (as drawn) in which the body goes on straight to both sides of the place C, perpendicular to the
// normal n of a contact there: one for an edge, two for a flat side. There are none at a corner, at a particle, and
// where the body is not known to be straight. The scalar is double, Dual<1> or Formula; plain numbers decide.
template <class Scalar>
std::vector<Vector3<double>> straight_directions(const Body& body, DataScope<Scalar>& data, const Vector3<double>& C,
                                                 const Vector3<double>& n);

// How far the place C is from the surface of a body that is straight everywhere (m); nothing of a body that is round
// somewhere, of one without shape, and of one that has no surface that is known here.
template <class Scalar>
std::optional<double> gap_to_sides(const Body& body, DataScope<Scalar>& data, const Vector3<double>& C);

}  // namespace poinsot::problem
