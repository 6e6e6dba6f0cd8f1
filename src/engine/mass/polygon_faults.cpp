#include <algorithm>
#include <array>
#include <cmath>

#include "engine/mass/shape_check.h"
#include "poinsot/engine/mass/plates.h"

namespace poinsot::shape_faults {
namespace {

using Flat = std::array<double, 2>;

Flat minus(const Flat& a, const Flat& b) { return {a[0] - b[0], a[1] - b[1]}; }
double dot(const Flat& a, const Flat& b) { return a[0] * b[0] + a[1] * b[1]; }
double turn(const Flat& a, const Flat& b) { return a[0] * b[1] - a[1] * b[0]; }

double distance_to_side(const Flat& p, const Flat& a, const Flat& b) {
  const Flat side = minus(b, a);
  const double part = std::clamp(dot(minus(p, a), side) / dot(side, side), 0.0, 1.0);
  return std::hypot(p[0] - a[0] - part * side[0], p[1] - a[1] - part * side[1]);
}

// Two sides without a common corner: they cross, or an end of one is within `reach` of the other.
bool meet(const Flat& a, const Flat& b, const Flat& c, const Flat& d, double reach) {
  // Far apart in one coordinate, as most pairs are.
  for (std::size_t i = 0; i < 2; ++i) {
    if (std::max(a[i], b[i]) + reach < std::min(c[i], d[i]) || std::max(c[i], d[i]) + reach < std::min(a[i], b[i])) {
      return false;
    }
  }
  const bool apart_from_ab = (turn(minus(b, a), minus(c, a)) < 0) == (turn(minus(b, a), minus(d, a)) < 0);
  const bool apart_from_cd = (turn(minus(d, c), minus(a, c)) < 0) == (turn(minus(d, c), minus(b, c)) < 0);
  if (!apart_from_ab && !apart_from_cd) return true;
  return std::min({distance_to_side(a, c, d), distance_to_side(b, c, d), distance_to_side(c, a, b),
                   distance_to_side(d, a, b)}) <= reach;
}

}  // namespace

void check_outline(ShapeCheck& check, const std::vector<Point>& vertices, double tolerance) {
  const std::size_t count = vertices.size();
  check.require(count >= 3, ShapeRule::enough_points, "a polygon needs at least 3 vertices, but {} {} given", count,
                count == 1 ? "is" : "are");
  for (std::size_t i = 0; i < count && check.good(); ++i) check.point(fmt::format("vertex {}", i + 1), vertices[i]);
  for (std::size_t i = 0; i < count && check.good(); ++i) {
    const std::size_t j = (i + 1) % count;
    check.distinct(fmt::format("vertex {}", i + 1), vertices[i], fmt::format("vertex {}", j + 1), vertices[j]);
  }
  if (!check.good()) return;

  // The plane through the first vertex, the one farthest from it, and the one farthest from their line.
  const Point& origin = vertices.front();
  Point along = Point::zero();
  for (const auto& v : vertices) {
    if (norm(v - origin) > norm(along)) along = v - origin;
  }
  const double extent = norm(along);
  const Point u = normalized(along);
  Point widest = Point::zero();
  for (const auto& v : vertices) {
    const Point side = perpendicular_part(v - origin, u);
    if (norm(side) > norm(widest)) widest = side;
  }
  check.require(norm(widest) > zero_length * extent, ShapeRule::not_collinear,
                "all vertices lie on one line; a plate needs an area");
  if (!check.good()) return;
  const Point v = normalized(widest);
  const Point normal = cross(u, v);
  std::vector<Flat> outline;
  for (std::size_t i = 0; i < count; ++i) {
    const Point p = vertices[i] - origin;
    const double height = poinsot::dot(p, normal);
    check.require(std::abs(height) <= tolerance * extent, ShapeRule::flat,
                  "vertex {} at {} is {:.4g} m off the plane of the others; all vertices must lie in one "
                  "plane",
                  i + 1, text(vertices[i]), std::abs(height));
    outline.push_back({poinsot::dot(p, u), poinsot::dot(p, v)});
  }

  // Neighbouring sides must not fold back on each other, others must not meet.
  const double reach = zero_length * extent;
  for (std::size_t i = 0; i < count && check.good(); ++i) {
    const std::size_t j = (i + 1) % count;
    const Flat before = minus(outline[j], outline[i]);
    const Flat after = minus(outline[(j + 1) % count], outline[j]);
    const double size = std::sqrt(dot(before, before) * dot(after, after));
    check.require(dot(before, after) > 0 || std::abs(turn(before, after)) > zero_length * size,
                  ShapeRule::simple_outline, "the outline turns back on itself at vertex {} {}", j + 1,
                  text(vertices[j]));
    for (std::size_t k = i + 2; k < count && check.good(); ++k) {
      const std::size_t l = (k + 1) % count;
      if (l == i) continue;
      if (!meet(outline[i], outline[j], outline[k], outline[l], reach)) continue;
      check.require(false, ShapeRule::simple_outline,
                    "the side from vertex {} to {} meets the side from vertex {} to {}; list the vertices "
                    "in order round the plate",
                    i + 1, j + 1, k + 1, l + 1);
    }
  }
}

Fault polygon(std::string_view name, const std::vector<Point>& vertices, double tolerance) {
  ShapeCheck check("polygon", name);
  check_outline(check, vertices, tolerance);
  return check.result();
}

Fault polygon_in_plane(std::string_view name, const std::vector<std::array<double, 2>>& coordinates,
                       const Point& origin, const Point& axis_u, const Point& axis_v, double tolerance) {
  ShapeCheck check("polygon", name);
  check.point("the plane's origin", origin).direction("the plane's first axis", axis_u);
  check.across("the plane's second axis", axis_v, "the first", axis_u);
  if (check.good()) check_outline(check, shapes::points_in_plane(coordinates, origin, axis_u, axis_v), tolerance);
  return check.result();
}

Fault prism(std::string_view name, const std::vector<Point>& base, const Point& edge, double tolerance) {
  ShapeCheck check("prism", name);
  check.edge("the edge 'along'", edge);
  if (check.good()) check_outline(check, base, tolerance);
  if (!check.good()) return check.result();
  const Point area = shapes::vector_area_of(base);
  return check
      .require(std::abs(dot(area, edge)) > zero_length * norm(area) * norm(edge), ShapeRule::clear_direction,
               "the edge 'along' {} lies in the plane of the base; give one that leaves it", text(edge))
      .result();
}

}  // namespace poinsot::shape_faults
