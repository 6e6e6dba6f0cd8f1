// The lines of solids as they are seen: features, silhouettes and thin bodies, without what is hidden; and the areas
// that they cover.
#pragma once

#include <vector>

#include "pictures/drawing/drawing.h"
#include "pictures/solids/intersections.h"
#include "pictures/solids/visibility.h"

namespace poinsot::pictures {

struct SeenLine {
  std::vector<Point2> points;
  int body = 0;
  double depth = 0;  // of its middle
  bool silhouette = false;
  bool closed = false;
};

struct Lines {
  std::vector<SeenLine> edges;
  std::vector<SeenLine> rods;  // bodies that are lines
};

Lines seen_lines(const std::vector<Solid>& solids, const std::vector<Intersection>& intersections,
                 const Projection& projection, const Visibility& visibility);

// The areas of bodies from the farthest to the nearest.
struct Area {
  int body = 0;
  std::vector<std::vector<Point2>> loops;  // wound in one sense around what is covered
};
std::vector<Area> areas_of(const std::vector<Solid>& solids, const std::vector<Intersection>& intersections,
                           const Projection& projection);

}  // namespace poinsot::pictures
