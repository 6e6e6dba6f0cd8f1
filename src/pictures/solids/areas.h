// The areas that solids cover on the paper.
#pragma once

#include <vector>

#include "pictures/drawing/drawing.h"
#include "pictures/solids/intersections.h"
#include "pictures/solids/projection.h"
#include "pictures/solids/solid.h"

namespace poinsot::pictures {

// The areas of bodies from the farthest to the nearest.
struct Area {
  int body = 0;
  std::vector<std::vector<Point2>> loops;  // wound in one sense around what is covered
};
std::vector<Area> areas_of(const std::vector<Solid>& solids, const std::vector<Intersection>& intersections,
                           const Projection& projection);

}  // namespace poinsot::pictures
