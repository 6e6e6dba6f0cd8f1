// Pictures of particles, rods and wires.
#include <cmath>
#include <numbers>

#include "outline_builder.h"

namespace poinsot::outlines {
namespace {

Outline line_of(const Point& center, const Triad& triad, double radius, const Turn& turn) {
  OutlineBuilder builder;
  builder.edge(builder.circle(center, triad, radius, turn));
  return builder.finish();
}

}  // namespace

Outline particle(const Point& point) { return {{point}, {}, {}, {}}; }

Outline rod(const Point& A, const Point& B) { return polyline({A, B}); }

Outline polyline(const std::vector<Point>& points) {
  OutlineBuilder builder;
  std::vector<std::uint32_t> line;
  for (const Point& point : points) {
    const bool closes = line.size() + 1 == points.size() && norm(point - points.front()) == 0;
    line.push_back(closes ? line.front() : builder.vertex(point));
  }
  builder.edge(std::move(line));
  return builder.finish();
}

Outline arc_from_point(const Point& center, const Point& normal, const Point& start, double angle, int per_turn) {
  const Triad triad(normal, start - center);
  return line_of(center, triad, dot(start - center, triad.first), part_of_turn(0, angle, per_turn));
}

Outline ring(const Point& center, const Point& normal, double radius, int per_turn) {
  return line_of(center, Triad(normal), radius, whole_turn(per_turn));
}

Outline semicircular_arc(const Point& A, const Point& B, const Point& toward, int per_turn) {
  const Point center = 0.5 * (A + B);
  return line_of(center, Triad(cross(A - B, toward), A - B), 0.5 * norm(A - B),
                 part_of_turn(0, std::numbers::pi, per_turn));
}

}  // namespace poinsot::outlines
