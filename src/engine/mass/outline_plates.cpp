// Pictures of thin plates.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "outline_builder.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::outlines {
namespace {

// Whether a point lies in a triangle of a plane with this normal, or on its border.
bool lies_in(const Point& p, const std::array<Point, 3>& corners, const Point& normal) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& from = corners[k];
    if (dot(cross(corners[(k + 1) % 3] - from, p - from), normal) < 0) return false;
  }
  return true;
}

// Twice the area of a polygon, with its normal.
Point area_vector(const std::vector<Point>& points) {
  Point sum = Point::zero();
  for (std::size_t k = 1; k + 1 < points.size(); ++k) sum += cross(points[k] - points[0], points[k + 1] - points[0]);
  return sum;
}

// The triangles of a simple polygon: an ear, which holds no other corner, is cut off again and again.
void cut_ears(OutlineBuilder& builder, const std::vector<Point>& points, const Point& normal) {
  std::vector<std::uint32_t> left(points.size());
  std::iota(left.begin(), left.end(), 0U);
  const auto is_ear = [&](std::size_t at) {
    const std::size_t count = left.size();
    const std::array<std::uint32_t, 3> corners{left[(at + count - 1) % count], left[at], left[(at + 1) % count]};
    const std::array<Point, 3> P{points[corners[0]], points[corners[1]], points[corners[2]]};
    if (!(dot(cross(P[1] - P[0], P[2] - P[0]), normal) > 0)) return false;
    constexpr Work of_a_corner = 10;
    count_work(of_a_corner * count);
    return std::none_of(left.begin(), left.end(), [&](std::uint32_t other) {
      return std::find(corners.begin(), corners.end(), other) == corners.end() && lies_in(points[other], P, normal);
    });
  };
  const auto cut = [&](std::size_t at) {
    const std::size_t count = left.size();
    builder.triangle({left[(at + count - 1) % count], left[at], left[(at + 1) % count]}, {normal, normal, normal});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
  };
  std::size_t at = 0;
  for (std::size_t tried = 0; left.size() > 3 && tried < left.size();) {
    at %= left.size();
    if (!is_ear(at)) {
      ++at;
      ++tried;
      continue;
    }
    cut(at);
    // The next ear is sought on the other side of the neighbour, so that no fan of thin triangles arises.
    ++at;
    tried = 0;
  }
  // What is left is a triangle, or rounding has made the rest as good as flat.
  while (left.size() >= 3) cut(0);
}

}  // namespace

Outline rectangle(const Point& center, const Point& edge_a, const Point& edge_b) {
  const Point a = 0.5 * edge_a, b = 0.5 * edge_b;
  return polygon({center - a - b, center + a - b, center + a + b, center - a + b});
}

Outline rectangle_from_corners(const Point& A, const Point& B, const Point& C) { return polygon({A, B, C, A + C - B}); }

Outline triangle(const Point& A, const Point& B, const Point& C) { return polygon({A, B, C}); }

Outline polygon(const std::vector<Point>& vertices) {
  OutlineBuilder builder;
  std::vector<std::uint32_t> border;
  for (const Point& point : vertices) border.push_back(builder.vertex(point));
  cut_ears(builder, vertices, normalized(area_vector(vertices)));
  border.push_back(border.front());
  builder.edge(std::move(border));
  return builder.finish();
}

Outline disk(const Point& center, const Point& normal, double radius, int per_turn) {
  OutlineBuilder builder;
  builder.turned(center, Triad(normal), {straight({radius, 0}, {0, 0})}, {true, false}, whole_turn(per_turn));
  return builder.finish();
}

Outline annulus(const Point& center, const Point& normal, double outer_radius, double inner_radius, int per_turn) {
  if (!(inner_radius > 0)) return disk(center, normal, outer_radius, per_turn);
  OutlineBuilder builder;
  builder.turned(center, Triad(normal), {straight({outer_radius, 0}, {inner_radius, 0})}, {true, true},
                 whole_turn(per_turn));
  return builder.finish();
}

Outline sector(const Point& center, const Point& normal, double radius, const Point& middle, double angle,
               int per_turn) {
  const Turn turn = part_of_turn(-0.5 * angle, angle, per_turn);
  if (turn.whole()) return disk(center, normal, radius, per_turn);
  const Triad triad(normal, middle);
  OutlineBuilder builder;
  std::vector<std::uint32_t> border = builder.circle(center, triad, radius, turn);
  const std::uint32_t tip = builder.vertex(center);
  for (std::size_t k = 0; k + 1 < border.size(); ++k)
    builder.triangle({tip, border[k], border[k + 1]}, {triad.third, triad.third, triad.third});
  border.push_back(tip);
  border.push_back(border.front());
  builder.edge(std::move(border));
  return builder.finish();
}

Outline annular_sector(const Point& center, const Point& normal, double outer_radius, double inner_radius,
                       const Point& middle, double angle, int per_turn) {
  if (!(inner_radius > 0)) return sector(center, normal, outer_radius, middle, angle, per_turn);
  const Turn turn = part_of_turn(-0.5 * angle, angle, per_turn);
  if (turn.whole()) return annulus(center, normal, outer_radius, inner_radius, per_turn);
  const Triad triad(normal, middle);
  OutlineBuilder builder;
  std::vector<std::uint32_t> border = builder.circle(center, triad, outer_radius, turn);
  const std::vector<std::uint32_t> inner = builder.circle(center, triad, inner_radius, turn);
  for (std::size_t k = 0; k + 1 < border.size(); ++k)
    builder.face({inner[k], border[k], border[k + 1], inner[k + 1]}, triad.third);
  border.insert(border.end(), inner.rbegin(), inner.rend());
  border.push_back(border.front());
  builder.edge(std::move(border));
  return builder.finish();
}

Outline semicircle(const Point& A, const Point& B, const Point& toward, int per_turn) {
  const Point along = normalized(B - A), middle = toward - dot(toward, along) * along;
  return sector(0.5 * (A + B), cross(along, middle), 0.5 * norm(B - A), middle, std::numbers::pi, per_turn);
}

}  // namespace poinsot::outlines
