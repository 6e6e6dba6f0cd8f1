// Points of a line as an SVG path: where they follow each other like those of a curve, a curve runs through them.
#pragma once

#include <string>
#include <vector>

#include "pictures/drawing/plane.h"

namespace poinsot::pictures {

// As the digits of an SVG: two behind the point.
std::string path_number(double value);

// Straight from point to point.
std::string straight_path(const std::vector<Point2>& points, bool closed);
// Straight at corners and along sides, bent where short chords turn a little each.
std::string smooth_path(const std::vector<Point2>& points, bool closed);

}  // namespace poinsot::pictures
