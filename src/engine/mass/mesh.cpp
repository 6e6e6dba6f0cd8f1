#include "poinsot/engine/mass/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/mass/mesh_nesting.h"

namespace poinsot {
namespace {

// A triangle whose height is below this part of its longest side is a line to rounding: corners are differences of
// coordinates, good to some fifty units in the last place. Slivers of programs for drawing are thicker.
constexpr double thinnest = 1e-14;
// A volume below this part of extent times area is zero to rounding: the sum over a million triangles, each rounded in
// its own direction, of the terms of a determinant.
constexpr double no_volume = 1e-13;

std::string coordinates(const Vector3<double>& v) { return fmt::format("({:.10g}, {:.10g}, {:.10g})", v.x, v.y, v.z); }

// Counts what breaks a rule and remembers the first case.
class Tally {
 public:
  explicit Tally(MeshRule rule) : rule_(rule) {}
  template <class Describe>
  void add(const Describe& describe) {
    if (count_ == 0) first_ = describe();
    ++count_;
  }
  void report(const std::string& name, std::string_view singular, std::string_view plural, std::string_view advice,
              std::vector<MeshFault>& faults) const {
    if (count_ == 0) return;
    faults.push_back(
        {rule_,
         fmt::format("mesh '{}': {} {}, first {}; {}", name, count_, count_ == 1 ? singular : plural, first_, advice),
         count_});
  }

 private:
  MeshRule rule_;
  std::size_t count_ = 0;
  std::string first_;
};

bool is_proper(const TriangleMesh<double>& mesh, const std::array<std::uint32_t, 3>& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return false;
  const Vector3<double> a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
  const Vector3<double> b = mesh.vertices[t[2]] - mesh.vertices[t[1]];
  const Vector3<double> c = mesh.vertices[t[0]] - mesh.vertices[t[2]];
  const double longest = std::max({norm(a), norm(b), norm(c)});
  // Twice the area over the longest side is the height; sides are scaled so that no square can vanish or overflow.
  return longest > 0 && norm(cross((1 / longest) * a, (1 / longest) * b)) > thinnest;
}

struct Edge {
  std::uint32_t low;
  std::uint32_t high;
  bool forward;  // runs from low to high
};

// By the lower vertex, then by the higher one. Counting the edges of each lower vertex tells where they belong; those
// of one vertex are few.
std::vector<Edge> sorted_edges(const TriangleMesh<double>& mesh) {
  const auto for_each_edge = [&](const auto& visit) {
    for (const auto& t : mesh.triangles) {
      count_work(work_of_triangle);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = t[i];
        const std::uint32_t to = t[(i + 1) % 3];
        visit(Edge{std::min(from, to), std::max(from, to), from < to});
      }
    }
  };
  std::vector<std::size_t> next(mesh.vertices.size() + 1);  // where the next edge of a vertex goes
  for_each_edge([&](const Edge& edge) { ++next[edge.low + 1]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Edge> edges(3 * mesh.triangles.size());
  for_each_edge([&](const Edge& edge) { edges[next[edge.low]++] = edge; });
  for (std::size_t vertex = 0, begin = 0; vertex < mesh.vertices.size(); begin = next[vertex++]) {
    count_work(work_of_triangle);
    std::sort(edges.begin() + static_cast<std::ptrdiff_t>(begin),
              edges.begin() + static_cast<std::ptrdiff_t>(next[vertex]),
              [](const Edge& a, const Edge& b) { return a.high < b.high; });
  }
  return edges;
}

void find_edge_faults(const TriangleMesh<double>& mesh, const std::string& name, std::vector<MeshFault>& faults) {
  const std::vector<Edge> edges = sorted_edges(mesh);

  Tally open(MeshRule::closed_surface);
  Tally turned(MeshRule::consistent_orientation);
  for (std::size_t begin = 0; begin < edges.size();) {
    count_work(work_of_triangle);
    std::size_t end = begin;
    std::size_t forward = 0;
    while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high) {
      forward += edges[end].forward ? 1 : 0;
      ++end;
    }
    const auto describe = [&] {
      return fmt::format("from {} to {}, which belongs to {} triangle{}", coordinates(mesh.vertices[edges[begin].low]),
                         coordinates(mesh.vertices[edges[begin].high]), end - begin, end - begin == 1 ? "" : "s");
    };
    if (end - begin != 2) {
      open.add(describe);
    } else if (forward != 1) {
      turned.add(describe);
    }
    begin = end;
  }
  open.report(name, "edge is not shared by exactly two triangles", "edges are not shared by exactly two triangles",
              "a body needs a closed surface: fill the holes and remove double or inner faces", faults);
  turned.report(name, "edge has two triangles that run along it the same way",
                "edges have two triangles that run along them the same way",
                "neighbouring triangles must be turned alike: reverse the corners of the odd ones", faults);
}

void find_volume_fault(const TriangleMesh<double>& mesh, const std::string& name, std::vector<MeshFault>& faults) {
  double extent = 0;
  for (const auto& v : mesh.vertices) extent = std::max(extent, norm(v - mesh.vertices.front()));
  const double volume = solid_of_mesh(mesh).measure;
  const double rounding = no_volume * extent * shell_of_mesh(mesh).measure;
  std::string what;
  if (!std::isfinite(volume)) {
    what = fmt::format("its volume is beyond all numbers ({}); check the unit of its coordinates", volume);
  } else if (std::abs(volume) <= rounding) {
    what = "it encloses no volume; a body needs a closed surface around some space";
  } else if (volume < 0) {
    what = fmt::format(
        "it is inside out (its volume is {:.10g} m^3); reverse the corners of every triangle so that they "
        "run counter-clockwise seen from outside",
        volume);
  } else {
    return;
  }
  faults.push_back({MeshRule::outward_orientation, fmt::format("mesh '{}': {}", name, what), mesh.triangles.size()});
}

}  // namespace

std::vector<MeshFault> find_faults(const TriangleMesh<double>& mesh, const std::string& name) {
  std::vector<MeshFault> faults;
  if (mesh.triangles.empty()) {
    faults.push_back({MeshRule::has_triangles,
                      fmt::format("mesh '{}': it has no triangles; a body needs a closed surface", name), 0});
    return faults;
  }

  // Vertices first: nothing else makes sense without them.
  Tally unknown(MeshRule::known_vertices);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t corner : mesh.triangles[i]) {
      if (corner >= mesh.vertices.size())
        unknown.add([&] { return fmt::format("vertex {} of triangle {}", corner, i); });
    }
  }
  unknown.report(name, "corner names a vertex that does not exist", "corners name vertices that do not exist",
                 fmt::format("vertices are numbered from 0 to below {}", mesh.vertices.size()), faults);
  Tally infinite(MeshRule::finite_vertices);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const auto& v = mesh.vertices[i];
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
      infinite.add([&] { return fmt::format("vertex {} at {}", i, coordinates(v)); });
    }
  }
  infinite.report(name, "vertex is not finite", "vertices are not finite", "every coordinate must be a finite number",
                  faults);
  if (!faults.empty()) return faults;

  Tally degenerate(MeshRule::proper_triangles);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    count_work(work_of_triangle);
    if (!is_proper(mesh, t)) {
      degenerate.add([&] {
        return fmt::format("triangle {} with the corners {}, {}, {}", i, coordinates(mesh.vertices[t[0]]),
                           coordinates(mesh.vertices[t[1]]), coordinates(mesh.vertices[t[2]]));
      });
    }
  }
  degenerate.report(name, "triangle has its corners on one line", "triangles have their corners on one line",
                    "remove them and join their neighbours", faults);
  find_edge_faults(mesh, name, faults);
  if (!faults.empty()) return faults;

  find_volume_fault(mesh, name, faults);
  if (!faults.empty()) return faults;
  if (std::optional<MeshFault> nesting = find_nesting_fault(mesh, name)) faults.push_back(*std::move(nesting));
  return faults;
}

}  // namespace poinsot
