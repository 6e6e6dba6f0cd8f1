#include "pictures/solids/intersections.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace poinsot::pictures {
namespace {

constexpr std::size_t most_pairs = 600000;  // of triangles, for two solids

struct Bounds {
  Vector low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  void include(const Vector& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  bool overlaps(const Bounds& other) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (low[i] > other.high[i] || other.low[i] > high[i]) return false;
    return true;
  }
};

using Corners = std::array<Vector, 3>;

Corners corners_of(const Solid& solid, std::size_t t) {
  const auto& v = solid.triangles[t];
  return {solid.vertices[v[0]], solid.vertices[v[1]], solid.vertices[v[2]]};
}

Bounds bounds_of(const Corners& corners) {
  Bounds bounds;
  for (const Vector& p : corners) bounds.include(p);
  return bounds;
}

// The part of the line of two planes that lies in a triangle, by the distances of its corners from the other plane: as
// the places of its ends along `line`.
std::optional<std::array<double, 2>> crossing(const Corners& c, const std::array<double, 3>& away, const Vector& line) {
  std::array<double, 2> ends{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = away[k], b = away[(k + 1) % 3];
    if ((a > 0) == (b > 0) || count == 2) continue;
    ends[count++] = dot(c[k] + (a / (a - b)) * (c[(k + 1) % 3] - c[k]), line);
  }
  if (count < 2) return std::nullopt;
  if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
  return ends;
}

std::optional<std::array<Vector, 2>> crossing(const Corners& a, const Corners& b, double little) {
  const Vector na = unit_or(cross(a[1] - a[0], a[2] - a[0]), {}), nb = unit_or(cross(b[1] - b[0], b[2] - b[0]), {});
  const Vector line = cross(na, nb);
  if (norm(line) < 1e-3) return std::nullopt;
  std::array<double, 3> of_a{}, of_b{};
  for (std::size_t k = 0; k < 3; ++k) {
    of_a[k] = dot(a[k] - b[0], nb);
    of_b[k] = dot(b[k] - a[0], na);
  }
  // Surfaces that only touch have an edge there already.
  for (const auto& away : {of_a, of_b})
    if (*std::ranges::min_element(away) > -little || *std::ranges::max_element(away) < little) return std::nullopt;
  const Vector along = normalized(line);
  const auto first = crossing(a, of_a, along), second = crossing(b, of_b, along);
  if (!first || !second) return std::nullopt;
  const double begin = std::max((*first)[0], (*second)[0]), end = std::min((*first)[1], (*second)[1]);
  if (end - begin < little) return std::nullopt;
  // A point of both planes: from a corner of `a` within its plane towards the other.
  const Vector toward = cross(na, along);
  const Vector on_both = a[0] - (of_a[0] / dot(toward, nb)) * toward;
  const Vector base = on_both - dot(on_both, along) * along;
  return std::array<Vector, 2>{base + begin * along, base + end * along};
}

}  // namespace

std::vector<Intersection> intersections_of(const std::vector<Solid>& solids) {
  std::vector<Bounds> bounds(solids.size());
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (const Vector& p : solids[i].vertices) bounds[i].include(p);
  std::vector<Intersection> result;
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Solid &a = solids[i], &b = solids[k];
      if (a.hole || b.hole || !bounds[i].overlaps(bounds[k])) continue;
      const auto within = [&](const Solid& solid, const Bounds& other) {
        std::vector<std::size_t> found;
        for (std::size_t t = 0; t < solid.triangles.size(); ++t)
          if (bounds_of(corners_of(solid, t)).overlaps(other)) found.push_back(t);
        return found;
      };
      const std::vector<std::size_t> of_a = within(a, bounds[k]), of_b = within(b, bounds[i]);
      if (of_a.size() * of_b.size() > most_pairs) continue;
      const double size = std::min(norm(bounds[i].high - bounds[i].low), norm(bounds[k].high - bounds[k].low));
      std::vector<Bounds> bounds_b;
      for (const std::size_t t : of_b) bounds_b.push_back(bounds_of(corners_of(b, t)));
      for (const std::size_t t : of_a) {
        const Corners corners = corners_of(a, t);
        const Bounds own = bounds_of(corners);
        for (std::size_t u = 0; u < of_b.size(); ++u)
          if (own.overlaps(bounds_b[u]))
            if (const auto ends = crossing(corners, corners_of(b, of_b[u]), 1e-5 * size))
              result.push_back({(*ends)[0], (*ends)[1], i, k, {t, of_b[u]}});
      }
    }
  return result;
}

}  // namespace poinsot::pictures
