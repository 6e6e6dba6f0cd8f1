// How a stated body touches what it rolls on.
#pragma once

#include "problem/machine/data.h"

namespace poinsot::problem {

enum class ContactShape {
  round,    // a circle or sphere of the body
  corner,   // a point fixed in the body
  unknown,  // curved in a way that is not known here: how the point of contact moves cannot be told
  missed,   // the body is round all over, and the point is not on it
};

// How a body touches at a place.
template <class Scalar>
struct RollingSurface {
  ContactShape shape = ContactShape::corner;
  Vector3<Scalar> center{};
  Vector3<Scalar> axis{};  // unit vector; zero for a sphere
  Scalar radius{};
  double gap = 0;  // from the place to the surface, m
  // Of an arc or a part of a sphere: the unit vector from the center to its middle, and the cosine of the angle from
  // there to its end. Zero where the surface goes all round.
  Vector3<Scalar> middle{};
  double cosine = -1;
};

// Whether a normal may stand at the place: along the radius of a sphere, across the circle through the place.
template <class Scalar>
bool normal_fits(const RollingSurface<Scalar>& surface, const Vector3<Scalar>& place, const Vector3<Scalar>& normal);

// From the shape of the body whose surface the place C lies on, or from its axis of symmetry. The normal n tells, at
// the end of an arc and on the rim of a half sphere, whether the round surface or its edge touches. Scalar: double,
// Dual<1> or a formula.
template <class Scalar>
RollingSurface<Scalar> rolling_surface(const Body& body, DataScope<Scalar>& data, const Vector3<Scalar>& p_OC,
                                       const Vector3<Scalar>& n, const Vector3<Scalar>& center_of_mass);

}  // namespace poinsot::problem
