// Slides: what moves along a line or in a plane.
#pragma once

#include "pictures/figure/panel.h"

namespace poinsot::pictures {

// axis: the direction of sliding, or the normal of the plane, on ground axes; end_on: whether it is seen along itself.
void draw_slide(Panel& panel, const scene::Symbol& symbol, Point2 at, const Vector& axis, bool end_on);

}  // namespace poinsot::pictures
