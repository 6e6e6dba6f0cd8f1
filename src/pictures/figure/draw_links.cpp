// Cords, springs and dashpots.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pictures/drawing/label_text.h"
#include "pictures/figure/panel.h"

namespace poinsot::pictures {
namespace {

constexpr double coil_pitch = 7, coil_radius = 5.5;
constexpr int most_coils = 16;

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
  // More than readers count make a grey band.
  const int turns = std::clamp(static_cast<int>((length - 2 * ends) / coil_pitch), 3, most_coils);
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

// Whether the end of a slide's spring or damper is that on the body along which the other one slides.
bool is_on_carrier(const Panel& panel, const scene::Link& link, const scene::Place& end) {
  return (link.kind == scene::LinkKind::spring || link.kind == scene::LinkKind::damper) && end.body >= 0 &&
         std::ranges::any_of(panel.scene.symbols, [&](const scene::Symbol& symbol) {
           return symbol.kind == scene::SymbolKind::prismatic && symbol.name == link.name && symbol.from == end.body;
         });
}

// A plate of the body against which a spring rests: without one it would end nowhere.
void plate_at(Panel& panel, Point2 at, Point2 other) {
  constexpr double half = 8;
  const Point2 across = turned_left(direction(at - other, {0, -1}));
  panel.line({at - half * across, at + half * across}, Role::link, 2);
}

bool is_on_post(const Panel& panel, const scene::Place& end) {
  return std::ranges::any_of(panel.scene.curves, [&](const scene::Curve& curve) {
    if (curve.kind != scene::CurveKind::post) return false;
    const double chord = norm(curve.points[1] - curve.points[0]);
    return std::ranges::any_of(curve.points, [&](const Vector& p) { return norm(p - end.at) < chord; });
  });
}

// Whether another part of the cord goes on from there, as through an eyelet.
bool goes_on_from(const Panel& panel, const scene::Link& link, const scene::Place& end) {
  const double near = 1e-6 * panel.scene.length;
  const auto is_here = [&](const scene::Place& place) { return place.body < 0 && norm(place.at - end.at) <= near; };
  return std::ranges::any_of(panel.links, [&](const scene::Link& other) {
    return &other != &link && other.name == link.name && (is_here(other.from) || is_here(other.to));
  });
}

// An eyelet that the ground holds: where two parts of a cord meet.
void eyelet(Panel& panel, Point2 at) { panel.shape(circle(at, 4.5), "#ffffff", Role::symbol, 1.6); }

// How far aside a spring or damper is drawn of another one between the same places, else 0.
double beside_others(const Panel& panel, const scene::Link& link) {
  constexpr double aside = 10;
  const double near = 1e-9 * panel.scene.length;
  const auto runs_so = [&](const scene::Link& other) {
    return (other.kind == scene::LinkKind::spring || other.kind == scene::LinkKind::damper) &&
           norm(panel.ground(other.from) - panel.ground(link.from)) <= near &&
           norm(panel.ground(other.to) - panel.ground(link.to)) <= near;
  };
  if (!runs_so(link)) return 0;
  const auto count = std::ranges::count_if(panel.links, runs_so);
  if (count != 2) return 0;
  return &*std::ranges::find_if(panel.links, runs_so) == &link ? aside : -aside;
}

void name_tension(Panel& panel, const scene::Link& link, Point2 from, Point2 to) {
  // A slack cord pulls nothing.
  if (link.symbol.empty() || link.slack || norm(to - from) < 30) return;
  const Point2 middle = 0.5 * (from + to), side = turned_left(direction(to - from));
  Label label = tex_label(link.symbol);
  label.ink = Ink::force;
  // It pulls what it holds at both ends: two heads on the line itself, each away from its end.
  constexpr double head = 9, half_width = 3, from_end = 14;
  const Ruler ruler(from, to);
  const double length = norm(to - from);
  if (length > 2 * (from_end + head))
    for (const auto& [at, tip] :
         {std::pair{from_end, from_end + head}, std::pair{length - from_end, length - from_end - head}})
      panel.area({ruler(tip, 0), ruler(at, half_width), ruler(at, -half_width)}, color_of(Ink::force), Role::link);
  panel.labels.push_back(
      {std::move(label), {{middle, side, 4, 0}, {middle, -side, 4, 0}, {from + 0.25 * (to - from), side, 4, 0.4}}, 2});
}

}  // namespace

void draw_links(Panel& panel) {
  for (const scene::Link& link : panel.links) {
    if (!panel.draws(link.from.body) || !panel.draws(link.to.body)) continue;
    Point2 from = panel.paper(link.from), to = panel.paper(link.to);
    if (const double aside = beside_others(panel, link); aside != 0) {
      // Bars join what runs side by side.
      const Point2 along = direction(to - from), side = aside * turned_left(along);
      constexpr double bar_place = 9;
      for (const Point2& end : {from + bar_place * along, to - bar_place * along})
        panel.line({end, end + side}, Role::link, 1.2);
      from = from + bar_place * along + side;
      to = to - bar_place * along + side;
      panel.line({from - side, from - side - bar_place * along}, Role::link, 1.2);
      panel.line({to - side, to - side + bar_place * along}, Role::link, 1.2);
    }
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
    name_tension(panel, link, from, to);
    const auto end_at = [&](const scene::Place& place, Point2 at, Point2 other) {
      if (is_on_carrier(panel, link, place)) plate_at(panel, at, other);
      if (place.body >= 0 || is_on_post(panel, place)) return;
      goes_on_from(panel, link, place) ? eyelet(panel, at) : end_on_ground(panel, at, other);
    };
    end_at(link.from, from, to);
    if (!link.far) end_at(link.to, to, from);
  }
}

}  // namespace poinsot::pictures
