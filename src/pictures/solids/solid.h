// The shapes of a scene on ground axes, made fit for drawing: vertices that coincide are one, and each edge of a mesh
// knows the triangles on its sides.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pictures/solids/projection.h"
#include "poinsot/scene.h"

namespace poinsot::pictures {

struct MeshEdge {
  std::uint32_t from = 0, to = 0;
  int first = -1, second = -1;  // triangles; -1 at the border of a surface
  bool same_sense = false;      // whether both run along the edge in the same direction, so that one is turned over
  bool feature = false;         // whether a draughtsman draws it from any side
};

struct Solid {
  int body = 0;
  scene::Extent extent = scene::Extent::volume;
  bool hole = false;
  bool massless = false;
  bool stand_in = false;
  int plate = -1;  // of a surface that is a hole: the solid from which it is left out
  std::vector<Vector> vertices{};
  std::vector<std::array<std::uint32_t, 3>> triangles{};
  std::vector<MeshEdge> mesh_edges{};
  std::vector<std::vector<std::uint32_t>> lines{};  // features, and the lines that are bodies
};

// Meshes beyond this many triangles are made coarser, so that a drawing of them takes as long as one of a few shapes.
constexpr std::size_t most_triangles = 12000;

// The straight arms from a body's shapes to what holds it, on the axes of the body, as they are at the shown instant.
std::vector<std::array<Vector, 2>> arms_of(const scene::Scene& scene, int body);

std::vector<Solid> solids_of(const scene::Scene& scene, const std::vector<int>& bodies,
                             const std::vector<scene::Pose>& poses);

}  // namespace poinsot::pictures
