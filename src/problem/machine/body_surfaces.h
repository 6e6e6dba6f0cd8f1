// The shape with which a body touches what it rolls on, and where a body is straight: on rods, edges of plates and
// blocks, and flat sides.
#pragma once

#include <optional>
#include <vector>

#include "problem/machine/data.h"

namespace poinsot::problem {

enum class ContactShape {
  round,    // a circle or sphere of the body
  corner,   // a point fixed in the body
  unknown,  // curved in an unknown way, so that it is not known how the point of contact moves
  missed,   // the body is round everywhere, and the point is not on it
};

// The surface of a body at a place of contact.
template <class Scalar>
struct RollingSurface {
  ContactShape shape = ContactShape::corner;
  Vector3<Scalar> center{};
  Vector3<Scalar> axis{};  // unit vector; zero for a sphere
  Scalar radius{};
  double gap = 0;  // the distance from the place to the surface, m
  // For an arc or a part of a sphere: the unit vector from the center to its middle, and the cosine of the angle from
  // there to its end. `middle` is zero if the surface has no end.
  Vector3<Scalar> middle{};
  double cosine = -1;
};

// Whether the normal is possible at this place: it is along the radius of a sphere, or perpendicular to the circle
// through the place.
template <class Scalar>
bool normal_fits(const RollingSurface<Scalar>& surface, const Vector3<Scalar>& place, const Vector3<Scalar>& normal);

// Finds the surface of the body on which the place C lies, or the circle through C about the body's axis of symmetry.
// At the end of an arc and on the rim of a half sphere the normal n decides whether the round surface or the edge
// touches. The scalar is double, Dual<1> or Formula.
template <class Scalar>
RollingSurface<Scalar> rolling_surface(const Body& body, DataScope<Scalar>& data, const Vector3<Scalar>& p_OC,
                                       const Vector3<Scalar>& n, const Vector3<Scalar>& center_of_mass);

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
