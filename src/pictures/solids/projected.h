// Solids on the paper.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pictures/solids/solid.h"
#include "pictures/solids/visibility.h"

namespace poinsot::pictures {

// The vertices of a solid.
inline std::vector<DeepPoint> projected(const Solid& solid, const Projection& projection) {
  std::vector<DeepPoint> points;
  points.reserve(solid.vertices.size());
  for (const Vector& vertex : solid.vertices) points.push_back({projection(vertex), projection.depth(vertex)});
  return points;
}

// Twice the area of a triangle, below zero where it faces the viewer: y runs downward.
inline double signed_area(const std::array<std::uint32_t, 3>& t, const std::vector<DeepPoint>& p) {
  return cross(p[t[1]].at - p[t[0]].at, p[t[2]].at - p[t[0]].at);
}

}  // namespace poinsot::pictures
