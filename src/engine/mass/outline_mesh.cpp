// Pictures of bodies that are given by meshes.
#include <algorithm>
#include <cmath>
#include <map>

#include "poinsot/engine/mass/outlines.h"

namespace poinsot::outlines {
namespace {

using Side = std::pair<std::uint32_t, std::uint32_t>;

// Cosine of the angle beyond which two triangles meet at an edge: 35 degrees, more than between the facets of a
// cylinder of a dozen sides.
constexpr double crease = 0.819;

// Lines through the sides, each as long as it can go on.
std::vector<std::vector<std::uint32_t>> joined(const std::vector<Side>& sides) {
  std::multimap<std::uint32_t, std::size_t> at;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    at.emplace(sides[s].first, s);
    at.emplace(sides[s].second, s);
  }
  std::vector<bool> drawn(sides.size(), false);
  std::vector<std::vector<std::uint32_t>> lines;
  for (std::size_t first = 0; first < sides.size(); ++first) {
    if (drawn[first]) continue;
    drawn[first] = true;
    std::vector<std::uint32_t> line{sides[first].first, sides[first].second};
    for (bool grown = true; grown;) {
      grown = false;
      const auto [begin, end] = at.equal_range(line.back());
      for (auto next = begin; next != end && !grown; ++next) {
        if (drawn[next->second]) continue;
        const auto& [from, to] = sides[next->second];
        drawn[next->second] = true;
        line.push_back(from == line.back() ? to : from);
        grown = true;
      }
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

Outline solid_of_mesh(const TriangleMesh<double>& mesh, const Point& at) {
  Outline outline{mesh.vertices, mesh.triangles, {}, {}};
  std::vector<Point> areas, normals;  // of each triangle
  std::vector<std::vector<std::uint32_t>> around(mesh.vertices.size());
  std::map<Side, std::uint32_t> other;
  std::vector<Side> sharp;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    count_work(work_of_triangle);
    const auto& [i, j, k] = mesh.triangles[t];
    areas.push_back(cross(mesh.vertices[j] - mesh.vertices[i], mesh.vertices[k] - mesh.vertices[i]));
    normals.push_back(normalized(areas.back()));
    for (const Side& side : {Side{i, j}, Side{j, k}, Side{k, i}}) {
      around[side.first].push_back(t);
      const auto neighbour = other.find({side.second, side.first});
      if (neighbour == other.end())
        other.emplace(side, t);
      else if (dot(normals[neighbour->second], normals[t]) < crease)
        sharp.push_back(side);
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Point, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) {
      Point sum = Point::zero();
      for (const std::uint32_t beside : around[mesh.triangles[t][c]]) {
        count_work(work_of_triangle);
        if (dot(normals[beside], normals[t]) >= crease) sum += areas[beside];
      }
      corners[c] = normalized(sum);
    }
    outline.normals.push_back(corners);
  }
  for (Point& vertex : outline.vertices) vertex += at;
  outline.edges = joined(sharp);
  return outline;
}

Outline box_of_mesh(const TriangleMesh<double>& mesh, const Point& at) {
  Point low = mesh.vertices.front(), high = low;
  for (const Point& vertex : mesh.vertices)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], vertex[k]);
      high[k] = std::max(high[k], vertex[k]);
    }
  return box_between(low + at, high + at);
}

}  // namespace poinsot::outlines
