// Cords, springs and dashpots.
#include <cmath>
#include <numbers>
#include <utility>

#include "pictures/figure/panel.h"

namespace poinsot::pictures {
namespace {

constexpr double coil_pitch = 7, coil_radius = 5.5;

// Points along a segment with offsets across it.
class Ruler {
 public:
  Ruler(Point2 from, Point2 to) : from_(from), along_(direction(to - from)), across_(turned_left(along_)) {}
  Point2 operator()(double along, double across) const { return from_ + along * along_ + across * across_; }

 private:
  Point2 from_, along_, across_;
};

void coil(Panel& panel, Point2 from, Point2 to) {
  const double length = norm(to - from), ends = std::min(12.0, length / 5);
  const int turns = std::max(3, static_cast<int>((length - 2 * ends) / coil_pitch));
  const Ruler ruler(from, to);
  std::vector<Point2> points{ruler(0, 0), ruler(ends, 0)};
  const double step = (length - 2 * ends) / turns;
  for (int i = 0; i < turns; ++i) {
    points.push_back(ruler(ends + (i + 0.25) * step, coil_radius));
    points.push_back(ruler(ends + (i + 0.75) * step, -coil_radius));
  }
  points.push_back(ruler(length - ends, 0));
  points.push_back(ruler(length, 0));
  panel.line(std::move(points), Role::link, 1.2);
}

void dashpot(Panel& panel, Point2 from, Point2 to) {
  const double length = norm(to - from), middle = length / 2, half = std::min(10.0, length / 4);
  const Ruler ruler(from, to);
  panel.line({ruler(0, 0), ruler(middle - half, 0)}, Role::link, 1.2);
  panel.line({ruler(middle + half, 6), ruler(middle - half, 6), ruler(middle - half, -6), ruler(middle + half, -6)},
             Role::link, 1.2);
  panel.line({ruler(middle, 5), ruler(middle, -5)}, Role::link, 2);
  panel.line({ruler(middle, 0), ruler(length, 0)}, Role::link, 1.2);
}

void spiral(Panel& panel, Point2 at) {
  std::vector<Point2> points;
  for (int i = 0; i <= 60; ++i) {
    const double angle = 4.5 * std::numbers::pi * i / 60;
    points.push_back(at + (2 + 9.0 * i / 60) * Point2{std::cos(angle), -std::sin(angle)});
  }
  panel.line(std::move(points), Role::link, 1.1);
}

void cord(Panel& panel, const scene::Link& link) {
  const Vector from = panel.ground(link.from), to = panel.ground(link.to);
  if (!link.slack) {
    panel.seen_line(from, to, Role::link, 1.4, Ink::black);
  } else {
    const Point2 a = panel.projection(from), b = panel.projection(to);
    std::vector<Point2> points;
    const double sag = 0.15 * norm(b - a);
    for (int i = 0; i <= 24; ++i) {
      const double t = i / 24.0;
      points.push_back(a + t * (b - a) + Point2{0, 4 * sag * t * (1 - t)});
    }
    panel.line(std::move(points), Role::link, 1.4);
  }
}

// The mark of what goes on beyond the paper.
void goes_on(Panel& panel, Point2 from, Point2 end) {
  const Ruler ruler(end, end + direction(end - from, {0, -1}));
  panel.line({ruler(0, -6), ruler(3, -2), ruler(-3, 2), ruler(0, 6)}, Role::link, 1);
}

void end_on_ground(Panel& panel, Point2 at, Point2 other) {
  const Point2 away = direction(at - other, {0, -1});
  Point2 side = turned_left(away);
  if (cross(side, away) < 0) side = -side;
  hatch(panel, at - 10 * side, at + 10 * side);
}

}  // namespace

void draw_links(Panel& panel) {
  for (const scene::Link& link : panel.links) {
    if (!panel.draws(link.from.body) || !panel.draws(link.to.body)) continue;
    const Point2 from = panel.paper(link.from), to = panel.paper(link.to);
    switch (link.kind) {
      case scene::LinkKind::cord:
        cord(panel, link);
        break;
      case scene::LinkKind::spring:
        coil(panel, from, to);
        break;
      case scene::LinkKind::damper:
        dashpot(panel, from, to);
        break;
      case scene::LinkKind::torsion:
        spiral(panel, from);
        continue;
    }
    if (link.far) goes_on(panel, from, to);
    if (link.from.body < 0) end_on_ground(panel, from, to);
    if (link.to.body < 0 && !link.far) end_on_ground(panel, to, from);
  }
}

}  // namespace poinsot::pictures
