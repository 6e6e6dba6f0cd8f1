// Where a point is with respect to the outline of a shape.
#pragma once

#include "poinsot/engine/mass/outlines.h"

namespace poinsot {

// How large an outline is: the diagonal of the box round it, along the coordinate axes.
double size_of(const Outline& outline);

// Whether a point is on the surface of an outline, up to a distance `near`.
bool lies_on(const Outline& outline, const Vector3<double>& point, double near);

// Whether a point is within a closed outline. What it says of a point on the surface is open.
bool lies_within(const Outline& outline, const Vector3<double>& point);

}  // namespace poinsot
