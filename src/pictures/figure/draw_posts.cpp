// What stands on the ground beside bodies: posts that cords are led round, surfaces that are touched later, what pulls.
#include <algorithm>
#include <cmath>
#include <optional>

#include "pictures/figure/panel.h"

namespace poinsot::pictures {
namespace {

constexpr double hatch_distance = 5;

// Where a line at a level across a convex area begins and ends, along it.
std::optional<Interval> chord(const std::vector<Point2>& points, Point2 along, Point2 across, double level) {
  double begin = 1e300, end = -1e300;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 &a = points[i], &b = points[(i + 1) % points.size()];
    const double u = dot(a, across) - level, v = dot(b, across) - level;
    if ((u > 0) == (v > 0)) continue;
    const double place = dot(a + (u / (u - v)) * (b - a), along);
    begin = std::min(begin, place);
    end = std::max(end, place);
  }
  return begin < end ? std::optional(Interval{begin, end}) : std::nullopt;
}

// Strokes inside the border of a convex area, as a draughtsman marks what is fixed: all of what is small, and of what
// is large a rim, so that there is room within.
void hatch_area(Panel& panel, const std::vector<Point2>& points) {
  constexpr double rim = 9, small = 3 * rim;
  Box box;
  for (const Point2& p : points) box.include(p);
  const Point2 middle = box.center();
  const double half = 0.5 * std::min(box.width(), box.height());
  std::vector<Point2> within;
  if (half > small)
    for (const Point2& p : points) within.push_back(middle + (1 - rim / half) * (p - middle));
  const Point2 along = direction(Point2{1, -1}), across = turned_left(along);
  double low = 1e300, high = -1e300;
  for (const Point2& p : points) {
    low = std::min(low, dot(p, across));
    high = std::max(high, dot(p, across));
  }
  const double first = low + 0.5 * hatch_distance;
  const int levels = high > first ? static_cast<int>(std::ceil((high - first) / hatch_distance)) : 0;
  for (int i = 0; i < levels; ++i) {
    const double level = first + i * hatch_distance;
    const std::optional<Interval> whole = chord(points, along, across, level);
    if (!whole) continue;
    const auto stroke = [&](double begin, double end) {
      panel.line({begin * along + level * across, end * along + level * across}, Role::symbol, 0.6, Ink::grey);
    };
    if (const std::optional<Interval> free = chord(within, along, across, level)) {
      stroke(whole->first, free->first);
      stroke(free->second, whole->second);
    } else {
      stroke(whole->first, whole->second);
    }
  }
}

void draw_post(Panel& panel, const scene::Curve& curve) {
  std::vector<Point2> points;
  for (const Vector& point : curve.points) points.push_back(panel.projection(point));
  panel.area(points, "#f1f1ee", Role::paper);
  hatch_area(panel, points);
  panel.loop(std::move(points), Role::symbol, 1.4);
}

// A piece of the surface across its normal, as far as no other surface hides it: a groove and a corner have no cross.
void draw_surface(Panel& panel, const scene::Curve& curve) {
  constexpr double half = 40, from_the_side = 0.3;
  const Vector normal = curve.points[1] - curve.points[0];
  const Vector& viewer = panel.projection.view().viewer;
  const Point2 into = panel.projection.direction_of(-normal);
  if (norm(into) < from_the_side) return;
  const Vector across = cross(normal, viewer);
  const double seen = norm(panel.projection.direction_of(across)) * panel.projection.scale();
  if (!(seen > 0)) return;
  const double reach = half / seen;
  double begin = -reach, end = reach;
  for (const scene::Curve& other : panel.scene.curves) {
    if (&other == &curve || other.kind != scene::CurveKind::surface || other.body != curve.body) continue;
    const Vector out = other.points[1] - other.points[0];
    const double here = dot(out, Vector(curve.points[0] - other.points[0])), slope = dot(out, across);
    // What stands behind the other altogether, or runs along it, is not cut.
    if (here < -1e-9 * norm(out) * panel.scene.length || !(std::abs(slope) > 1e-9 * norm(out) * norm(across))) continue;
    const double meets = -std::max(here, 0.0) / slope;
    slope > 0 ? begin = std::max(begin, meets) : end = std::min(end, meets);
  }
  if (!(end > begin)) return;
  const Point2 from = panel.projection(Vector(curve.points[0] + begin * across)),
               to = panel.projection(Vector(curve.points[0] + end * across));
  cross(to - from, into) > 0 ? hatch(panel, from, to) : hatch(panel, to, from);
}

}  // namespace

void draw_posts(Panel& panel) {
  for (const scene::Curve& curve : panel.scene.curves) {
    if (curve.kind == scene::CurveKind::post) draw_post(panel, curve);
    if (curve.kind == scene::CurveKind::surface) draw_surface(panel, curve);
    // Of a planet the place counts; it has no size here.
    if (curve.kind == scene::CurveKind::attractor)
      panel.shape(circle(panel.projection(curve.points.front()), 11), "#e6e2d6", Role::symbol, 1.2);
  }
}

}  // namespace poinsot::pictures
