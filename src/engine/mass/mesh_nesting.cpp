#include "engine/mass/mesh_nesting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "engine/mass/solid_angle.h"

namespace poinsot {
namespace {

using Vector = Vector3<double>;

constexpr double most_work = 5e7;        // solid angles of triangles: a second or two
constexpr std::size_t most_points = 64;  // of one surface, which are tried until one is clearly in or out
// Of a point below its triangle, as a part of the triangle's size: thinner walls than a millionth of their triangles
// would be pierced, and rounding of far coordinates is a millionth of that.
constexpr double depth = 1e-6;
// Of a point, as a part of the way to the middle of the triangle, for where the middle lies on another surface.
constexpr double near_corner = 1e-3;
// How near a winding number must be to a whole one: it is a half where the point lies on a surface, and off by rounding
// only where it does not; a surface with a hole of two percent of a sphere is seen to be open.
constexpr double clearly_whole = 0.02;

constexpr const char* inside_out = "is inside out and no cavity in another part: reverse the corners of its triangles";
constexpr const char* doubled =
    "lies in another part or overlaps it, so that space would count twice: join the two, or reverse the corners of the "
    "inner one's triangles if it is a cavity";

// Which surface each triangle belongs to, numbered from 0; their count.
struct Surfaces {
  std::vector<std::size_t> of_triangle;
  std::size_t count = 0;
};
Surfaces surfaces_of(const TriangleMesh<double>& mesh) {
  std::vector<std::size_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& t : mesh.triangles) {
    count_work(work_of_triangle);
    parent[root(t[1])] = root(t[0]);
    parent[root(t[2])] = root(t[0]);
  }
  Surfaces surfaces;
  std::vector<std::size_t> number(mesh.vertices.size(), mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    count_work(work_of_triangle);
    std::size_t& own = number[root(t[0])];
    if (own == mesh.vertices.size()) own = surfaces.count++;
    surfaces.of_triangle.push_back(own);
  }
  return surfaces;
}

}  // namespace

std::optional<MeshFault> find_nesting_fault(const TriangleMesh<double>& mesh, const std::string& name) {
  const Surfaces surfaces = surfaces_of(mesh);
  if (surfaces.count < 2) return std::nullopt;
  std::vector<std::vector<std::size_t>> triangles(surfaces.count);
  std::vector<double> volume(surfaces.count, 0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    count_work(work_of_triangle);
    const std::size_t own = surfaces.of_triangle[i];
    triangles[own].push_back(i);
    const Vector& apex = mesh.vertices[mesh.triangles[triangles[own].front()][0]];
    const auto& t = mesh.triangles[i];
    volume[own] += dot(mesh.vertices[t[0]] - apex, cross(mesh.vertices[t[1]] - apex, mesh.vertices[t[2]] - apex)) / 6;
  }
  double work = 0;
  const double each = most_work / (4 * static_cast<double>(surfaces.count * mesh.triangles.size()));
  const std::size_t points = std::clamp<std::size_t>(static_cast<std::size_t>(each), 1, most_points);
  for (std::size_t own = 0; own < surfaces.count; ++own) {
    const std::size_t step = std::max<std::size_t>(1, triangles[own].size() / points);
    for (std::size_t k = 0; k < triangles[own].size(); k += step) {
      const auto& corners = mesh.triangles[triangles[own][k]];
      const Vector &A = mesh.vertices[corners[0]], &B = mesh.vertices[corners[1]], &C = mesh.vertices[corners[2]];
      const Vector middle = (1.0 / 3) * (A + B + C), across = cross(B - A, C - A);
      const Vector down = -depth / std::sqrt(norm(across)) * across;
      for (const Vector& towards : {middle, A, B, C}) {
        work += static_cast<double>(mesh.triangles.size());
        if (work > 2 * most_work) return std::nullopt;
        const Vector p = towards + near_corner * (middle - towards) + down;
        double around = 0;  // how often the other surfaces go around the point
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
          if (surfaces.of_triangle[i] == own) continue;
          count_work(work_of_triangle);
          const auto& t = mesh.triangles[i];
          around += winding(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
        }
        const bool clear = std::abs(around - std::round(around)) < clearly_whole;
        if (!clear || std::lround(around) == (volume[own] < 0 ? 1 : 0)) continue;
        return MeshFault{MeshRule::separate_parts,
                         fmt::format("mesh '{}': the part with the point ({:.10g}, {:.10g}, {:.10g}) {}", name, A.x,
                                     A.y, A.z, volume[own] < 0 ? inside_out : doubled),
                         triangles[own].size()};
      }
    }
  }
  return std::nullopt;
}

}  // namespace poinsot
