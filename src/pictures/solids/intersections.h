// Where the surfaces of solids that reach into each other meet.
#pragma once

#include <array>
#include <vector>

#include "pictures/solids/solid.h"

namespace poinsot::pictures {

struct Intersection {
  Vector from, to;
  std::size_t first = 0, second = 0;  // the solids
  std::array<std::size_t, 2> triangles{};
};

// Segments along which triangles of different solids cross. None between solids of so many triangles that it would take
// long.
std::vector<Intersection> intersections_of(const std::vector<Solid>& solids);

}  // namespace poinsot::pictures
