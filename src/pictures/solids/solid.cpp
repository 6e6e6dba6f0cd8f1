#include "pictures/solids/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "pictures/solids/skeleton.h"

namespace poinsot::pictures {
namespace {

constexpr double coarse_cells = 40;  // along the longest side of a mesh that is made coarser
constexpr double weld_part = 1e-7;   // vertices this near, as a part of the shape's size, are one
constexpr double coplanar_part = 1e-3;

struct Extents {
  Vector low{}, high{};
  double size = 0;
};

Extents extents_of(const std::vector<Vector>& points) {
  Extents e;
  if (points.empty()) return e;
  e.low = e.high = points.front();
  for (const Vector& p : points)
    for (std::size_t i = 0; i < 3; ++i) {
      e.low[i] = std::min(e.low[i], p[i]);
      e.high[i] = std::max(e.high[i], p[i]);
    }
  e.size = std::max({e.high.x - e.low.x, e.high.y - e.low.y, e.high.z - e.low.z});
  return e;
}

// For each vertex the first one in the same cell of a lattice.
std::vector<std::uint32_t> welded(const std::vector<Vector>& vertices, double cell, const Vector& origin) {
  std::unordered_map<std::uint64_t, std::uint32_t> first;
  std::vector<std::uint32_t> same(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const Vector d = vertices[i] - origin;
    std::uint64_t key = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double place = std::clamp(std::floor(d[k] / cell + 0.5), -1e6, 2e7);
      key = key * 0x1fffffffULL + static_cast<std::uint64_t>(static_cast<std::int64_t>(place) + (1LL << 20));
    }
    same[i] = first.try_emplace(key, i).first->second;
  }
  return same;
}

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
}

void find_mesh_edges(Solid& solid) {
  std::unordered_map<std::uint64_t, std::uint32_t> at;
  at.reserve(solid.triangles.size() * 2);
  for (std::size_t t = 0; t < solid.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = solid.triangles[t][k], to = solid.triangles[t][(k + 1) % 3];
      const auto [place, is_new] = at.try_emplace(key_of(from, to), solid.mesh_edges.size());
      if (is_new) {
        solid.mesh_edges.push_back({from, to, static_cast<int>(t)});
      } else if (MeshEdge& edge = solid.mesh_edges[place->second]; edge.second < 0) {
        edge.second = static_cast<int>(t);
        edge.same_sense = edge.from == from;
      }
    }
  for (const auto& line : solid.lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      if (const auto found = at.find(key_of(line[i], line[i + 1])); found != at.end())
        solid.mesh_edges[found->second].feature = true;
}

Solid solid_of(const scene::Shape& shape, const scene::Pose& pose, int body, bool massless) {
  Solid solid{
      .body = body, .extent = shape.extent, .hole = shape.hole, .massless = massless, .stand_in = shape.stand_in};
  for (const Vector& vertex : shape.vertices) solid.vertices.push_back(pose.R * vertex + pose.p);
  const Extents extents = extents_of(solid.vertices);
  const bool coarse = shape.triangles.size() > most_triangles;
  const double cell = std::max(extents.size, 1e-300) * (coarse ? 1 / coarse_cells : weld_part);
  const std::vector<std::uint32_t> same = welded(solid.vertices, cell, extents.low);
  for (const auto& triangle : shape.triangles) {
    const std::array<std::uint32_t, 3> t{same[triangle[0]], same[triangle[1]], same[triangle[2]]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) solid.triangles.push_back(t);
  }
  if (coarse) {
    // Thin walls fall together: triangles there come twice.
    std::ranges::sort(solid.triangles);
    solid.triangles.erase(std::unique(solid.triangles.begin(), solid.triangles.end()), solid.triangles.end());
  }
  for (const auto& edge : shape.edges) {
    std::vector<std::uint32_t> line;
    for (const std::uint32_t vertex : edge)
      if (line.empty() || line.back() != same[vertex]) line.push_back(same[vertex]);
    if (line.size() > 1) solid.lines.push_back(std::move(line));
  }
  find_mesh_edges(solid);
  return solid;
}

// The plate in whose plane the hole lies.
void find_plates(std::vector<Solid>& solids) {
  for (Solid& hole : solids) {
    if (!hole.hole || hole.extent != scene::Extent::surface || hole.triangles.empty()) continue;
    const auto corner = [&](std::size_t k) { return hole.vertices[hole.triangles[0][k]]; };
    const Vector normal = unit_or(cross(corner(1) - corner(0), corner(2) - corner(0)), {0, 0, 1});
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const Solid& plate = solids[i];
      if (plate.hole || plate.body != hole.body || plate.extent != scene::Extent::surface || plate.vertices.empty())
        continue;
      double away = 0;
      for (const Vector& p : plate.vertices) away = std::max(away, std::abs(dot(p - corner(0), normal)));
      if (away < nearest && away <= coplanar_part * extents_of(plate.vertices).size) {
        nearest = away;
        hole.plate = static_cast<int>(i);
      }
    }
  }
}

}  // namespace

std::vector<std::array<Vector, 2>> arms_of(const scene::Scene& scene, int body) {
  const scene::Body& own = scene.bodies.at(static_cast<std::size_t>(body));
  std::vector<scene::Pose> poses;
  for (const scene::Body& one : scene.bodies) poses.push_back(one.pose);
  std::vector<Solid> shapes;
  for (const scene::Shape& shape : own.shapes) shapes.push_back(solid_of(shape, own.pose, body, own.massless));
  std::vector<std::array<Vector, 2>> arms = skeleton_of(scene, body, shapes, poses);
  for (std::array<Vector, 2>& arm : arms)
    for (Vector& end : arm) end = transpose(own.pose.R) * (end - own.pose.p);
  return arms;
}

std::vector<Solid> solids_of(const scene::Scene& scene, const std::vector<int>& bodies,
                             const std::vector<scene::Pose>& poses) {
  std::vector<Solid> solids;
  for (const int body : bodies) {
    if (body < 0) continue;
    const scene::Body& own = scene.bodies.at(static_cast<std::size_t>(body));
    std::vector<Solid> shapes;
    for (const scene::Shape& shape : own.shapes)
      shapes.push_back(solid_of(shape, poses.at(static_cast<std::size_t>(body)), body, own.massless));
    Solid arms{.body = body, .extent = scene::Extent::line, .massless = true};
    for (const auto& arm : skeleton_of(scene, body, shapes, poses)) {
      const auto number = static_cast<std::uint32_t>(arms.vertices.size());
      arms.vertices.insert(arms.vertices.end(), arm.begin(), arm.end());
      arms.lines.push_back({number, number + 1});
    }
    std::ranges::move(shapes, std::back_inserter(solids));
    if (!arms.lines.empty()) solids.push_back(std::move(arms));
  }
  find_plates(solids);
  return solids;
}

}  // namespace poinsot::pictures
