// The plane in which a herpolhode lies.
#pragma once

#include "pictures/solids/projection.h"

namespace poinsot::pictures {

// The unit vector from the center towards the plane of the curve and across it, which is the direction of the angular
// momentum; zero if the points lie on one line.
Vector direction_across(const scene::Curve& herpolhode, const Vector& center);

}  // namespace poinsot::pictures
