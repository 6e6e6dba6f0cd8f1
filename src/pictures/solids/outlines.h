// The lines of solids as they are seen: features, silhouettes and thin bodies, without what is hidden.
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
  bool stand_in = false;
  bool closed = false;
};

struct Lines {
  std::vector<SeenLine> edges;
  std::vector<SeenLine> rods;  // bodies that are lines
  // What of these is hidden by nothing but solids that stand for a shape that is not stated.
  std::vector<SeenLine> rods_within;
};

Lines seen_lines(const std::vector<Solid>& solids, const std::vector<Intersection>& intersections,
                 const Projection& projection, const Visibility& visibility);

// The hidden parts of the features that run through one of the places: who looks for a named point that lies behind a
// body sees it where they end.
std::vector<SeenLine> hidden_lines(const std::vector<Solid>& solids, const std::vector<Vector>& places, double near,
                                   const Projection& projection, const Visibility& visibility);

// The outlines of bodies of which others hide nearly all, as a drum in its casing. seen: the lines that are seen.
std::vector<SeenLine> lines_of_hidden_bodies(const std::vector<Solid>& solids, const Lines& seen,
                                             const Projection& projection, const Visibility& visibility);

}  // namespace poinsot::pictures
