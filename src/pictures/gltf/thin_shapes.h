// The shapes of cords, springs, arcs and arrows, along z from the origin.
#pragma once

#include "pictures/gltf/moving_parts.h"

namespace poinsot::pictures {

// Between the origin and one unit along z; size: of the scene, of which coils and cylinders have a part as radius.
ThinShape link_shape(scene::LinkKind kind, double size);
// Of radius one about z, from x on.
ThinShape arc_shape(double angle);
// Of a length. Couples and turning have two heads and an arc with a head around the axis; inertial terms a shaft of
// dashes, so that they differ from forces by more than their colour; what acts to and fro has heads at both ends.
ThinShape arrow_shape(scene::Quantity quantity, bool swings, double length, double size);

}  // namespace poinsot::pictures
