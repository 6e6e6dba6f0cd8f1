// Joints, supports and contacts as engineers draw them. Symbols have the same size whatever that of the bodies.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pictures/figure/draw_slides.h"
#include "pictures/figure/panel.h"
#include "pictures/figure/symbol_places.h"

namespace poinsot::pictures {
namespace {

using scene::SymbolKind;

constexpr double pi = std::numbers::pi;
constexpr const char* metal = "#ffffff";

// Draws around a point with vectors in units of the paper.
class Sketch {
 public:
  Sketch(Panel& panel, const Vector& at) : panel_(panel), at_(panel.projection(at)) {}

  Point2 operator()(const Vector& v) const { return at_ + panel_.projection.direction_of(v); }
  Point2 at() const { return at_; }

  // A short tube along the axis: a bearing, a sleeve.
  void tube(const Vector& axis, double half_length, double radius) {
    const Vector& viewer = panel_.projection.view().viewer;
    const Vector along = dot(axis, viewer) < 0 ? -axis : axis;
    const Vector side = across(along), other = cross(along, side);
    std::vector<Point2> rims, near_rim;
    for (const double end : {-half_length, half_length})
      for (int i = 0; i < 24; ++i) {
        const double angle = 2 * pi * i / 24;
        rims.push_back((*this)(end * along + radius * (std::cos(angle) * side + std::sin(angle) * other)));
      }
    near_rim.assign(rims.begin() + 24, rims.end());
    panel_.shape(hull(std::move(rims)), metal, Role::symbol, 1.1);
    panel_.loop(std::move(near_rim), Role::symbol, 0.9);
  }

 private:
  Panel& panel_;
  Point2 at_;
};

// Across the axis, as far down on the paper as possible: where the ground is.
Vector down_across(const Panel& panel, const Vector& axis) {
  const View& view = panel.projection.view();
  const Vector down = -panel.scene.up;
  const Vector left = down - dot(down, axis) * axis;
  if (norm(left) > 0.3) return normalized(left);
  const Vector on_paper = cross(axis, view.viewer);
  return unit_or(on_paper, across(axis));
}

// Whether a point of the paper lies over a body or a rod.
bool is_covered(const Panel& panel, Point2 at) {
  constexpr double beside_rod = 6;
  if (panel.visibility.over_body(at)) return true;
  for (const Solid& solid : panel.solids) {
    if (solid.extent != scene::Extent::line) continue;
    for (const auto& line : solid.lines)
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        if (distance(at, panel.projection(solid.vertices[line[i]]), panel.projection(solid.vertices[line[i + 1]])) <
            beside_rod)
          return true;
  }
  return false;
}

// How much of a bracket that reaches to a place on the paper stands over bodies, or along an axis of the ground.
int covered_part(const Panel& panel, Point2 at, Point2 toward) {
  constexpr double reach = 16, half = 8, along = 0.9;
  const Point2 side = turned_left(toward), base = at + reach * toward;
  int count = 0;
  if (norm(at - panel.projection(Vector{})) < half)
    for (std::size_t i = 0; i < 3; ++i)
      count += dot(panel.projection.direction_of(Vector::unit(i)), toward) > along ? 2 : 0;
  for (const Point2 p : {base - half * side, base, base + half * side, at + 0.7 * reach * toward})
    count += is_covered(panel, p) ? 1 : 0;
  return count;
}

// Where on the paper the ground is that holds a joint: below, if the body that is held leaves it free; else on the side
// that it does.
Point2 ground_on_paper(const Panel& panel, Point2 at, Point2 down) {
  Point2 best = down;
  int least = covered_part(panel, at, down);
  for (const Point2 other : {-down, turned_left(down), -turned_left(down)})
    if (const int covered = covered_part(panel, at, other); covered < least) {
      least = covered;
      best = other;
    }
  return best;
}

// The same for a bracket that stands across an axis.
Vector ground_across(const Panel& panel, Point2 at, const Vector& axis) {
  const Vector down = down_across(panel, axis);
  Vector best = down;
  int least = 1000;
  for (const Vector& other : {down, -down, cross(axis, down), -cross(axis, down)}) {
    const Point2 seen = panel.projection.direction_of(other);
    constexpr double foreshortened = 0.4;
    if (norm(seen) < foreshortened && least < 1000) continue;
    if (const int covered = covered_part(panel, at, direction(seen, {0, 1})); covered < least) {
      least = covered;
      best = other;
    }
  }
  return best;
}

constexpr double foot_length = 9;  // from the sleeve to the ground

// A bracket from the sleeve to hatched ground.
void foot(Panel& panel, const Sketch& sketch, const Vector& axis, double radius) {
  const Vector down = ground_across(panel, sketch.at(), axis);
  const Point2 toward = panel.projection.direction_of(down);
  const Point2 along = direction(panel.projection.direction_of(axis), turned_left(direction(toward)));
  const Point2 begin = sketch.at() + radius * toward;
  const Point2 base = sketch.at() + (radius + foot_length) * direction(toward, {0, 1});
  const double half = 11;
  Point2 across_foot =
      std::abs(cross(along, direction(toward, {0, 1}))) > 0.5 ? along : turned_left(direction(toward, {0, 1}));
  panel.line({begin, base}, Role::symbol, 3);
  if (cross(across_foot, direction(toward, {0, 1})) < 0) across_foot = -across_foot;
  hatch(panel, base - half * across_foot, base + half * across_foot);
}

// Whether the paper lies flat, so that no direction on it is down.
bool seen_from_above(const Panel& panel) {
  constexpr double steep = 0.95;
  return std::abs(dot(panel.scene.up, panel.projection.view().viewer)) > steep;
}

// A pin seen along its axis: a circle, on a triangle where the ground holds it.
void pin(Panel& panel, Point2 at, bool on_ground, const Vector& axis) {
  if (on_ground) {
    const Point2 down =
        ground_on_paper(panel, at, direction(panel.projection.direction_of(down_across(panel, axis)), {0, 1}));
    const Point2 side = turned_left(down);
    const Point2 left = at + 15 * down - 9 * side, right = at + 15 * down + 9 * side;
    panel.shape({at, left, right}, metal, Role::symbol, 1.1);
    const Point2 begin = left - 4 * side, end = right + 4 * side;
    cross(end - begin, down) > 0 ? hatch(panel, begin, end) : hatch(panel, end, begin);
  }
  panel.shape(circle(at, 4), metal, Role::symbol, 1.2);
}

void ball(Panel& panel, Point2 at, bool on_ground, const Vector& axis) {
  Point2 down = direction(panel.projection.direction_of(down_across(panel, axis)), {0, 1});
  if (on_ground) down = ground_on_paper(panel, at, down);
  const double angle = std::atan2(-down.y, down.x);
  if (on_ground) {
    const Point2 side = turned_left(down);
    const Point2 base = at + 13 * down;
    panel.line({at + 8 * down, base}, Role::symbol, 3);
    const Point2 begin = base - 10 * side, end = base + 10 * side;
    cross(end - begin, down) > 0 ? hatch(panel, begin, end) : hatch(panel, end, begin);
  }
  panel.shape(circle(at, 5), metal, Role::symbol, 1.2);
  panel.line(arc(at, 8, angle - 1.9, angle + 1.9), Role::symbol, 1.4);
}

void screw(Panel& panel, Sketch& sketch, const Vector& axis) {
  sketch.tube(axis, 11, 5);
  const Point2 along = panel.projection.direction_of(axis), side = turned_left(direction(along));
  for (const double s : {-7.0, -2.0, 3.0})
    panel.line({sketch.at() + s * along - 5 * side, sketch.at() + (s + 4) * along + 5 * side}, Role::symbol, 0.9);
}

void universal(Panel& panel, const Sketch& sketch, const Vector& first, const Vector& second) {
  panel.shape(circle(sketch.at(), 8), metal, Role::symbol, 1.1);
  const Vector other = norm(second) > 0 ? second : cross(first, panel.projection.view().viewer);
  for (const Vector& axis : {first, other}) {
    const Point2 d = direction(panel.projection.direction_of(axis));
    panel.line({sketch.at() - 7 * d, sketch.at() + 7 * d}, Role::symbol, 2);
  }
}

void weld(Panel& panel, const Sketch& sketch, const Vector& axis, bool on_ground) {
  if (!on_ground) return panel.area(circle(sketch.at(), 3), "#333333", Role::symbol);
  // A wall across the axis, or under the point.
  const Vector into = norm(axis) > 0 ? -axis : -panel.scene.up;
  const Point2 toward = direction(panel.projection.direction_of(into), {0, 1});
  Point2 side = turned_left(toward);
  if (cross(side, toward) < 0) side = -side;
  hatch(panel, sketch.at() - 16 * side, sketch.at() + 16 * side, 8);
}

// Half the side of the piece of ground that is drawn under a body: less than the body is wide.
double half_of_ground(const Panel& panel, int body) {
  constexpr double least = 12, most = 34, part = 0.4;
  Box box;
  for (const Solid& solid : panel.solids)
    if (solid.body == body)
      for (const Vector& vertex : solid.vertices) box.include(panel.projection(vertex));
  // A particle is drawn larger than it is.
  return box.empty() || box.width() + box.height() < least
             ? most
             : std::clamp(part * std::max(box.width(), box.height()), least, most);
}

// How much farther a round body is seen to reach than to the place where it touches, which lies on its back.
double reach_beyond(const Panel& panel, int body, Point2 at, Point2 into) {
  double reach = 0;
  for (const Solid& solid : panel.solids)
    if (solid.body == body)
      for (const Vector& vertex : solid.vertices) reach = std::max(reach, dot(panel.projection(vertex) - at, into));
  return reach;
}

// Whether the half of a surface to this side of a place is behind another surface there, as a floor is beyond a wall.
bool is_behind_surface(const Panel& panel, const scene::Symbol& symbol, const Vector& side) {
  constexpr double same = 1e-6, noticeable = 1e-3;
  return symbol.to < 0 && std::ranges::any_of(panel.scene.symbols, [&](const scene::Symbol& other) {
           return is_contact(other) && other.from < 0 && other.to < 0 &&
                  norm(Vector(other.place.at - symbol.place.at)) <= same * panel.scene.length &&
                  dot(axis_on_ground(panel, other), side) < -noticeable;
         });
}

// The surface that is touched: a piece of it around the place, as far as a round body hides it from above; seen from
// the side it is a line across the normal.
void contact(Panel& panel, const Sketch& sketch, const scene::Symbol& symbol, const Vector& normal, bool on_ground) {
  const int body = symbol.to;
  const Vector& viewer = panel.projection.view().viewer;
  const Vector along = unit_or(cross(normal, viewer), across(normal));
  const Point2 d = panel.projection.direction_of(along), into = panel.projection.direction_of(-normal);
  const double half = on_ground ? half_of_ground(panel, body) : 9;
  const Point2 begin = sketch.at() - (is_behind_surface(panel, symbol, -along) ? 0 : half) * d,
               end = sketch.at() + (is_behind_surface(panel, symbol, along) ? 0 : half) * d;
  if (!on_ground) {
    if (symbol.kind == SymbolKind::rolling_contact) panel.line({begin, end}, Role::symbol, 1.1);
    return;
  }
  constexpr double from_the_side = 0.1;
  const double seen_from_above = dot(normal, viewer);
  if (seen_from_above < from_the_side)
    return cross(end - begin, into) > 0 ? hatch(panel, begin, end) : hatch(panel, end, begin);
  // So far to the front that a ball does not hide it; what reaches farther stands over an edge.
  constexpr double clear = 2, most = 60;
  const double reach = reach_beyond(panel, body, sketch.at(), direction(into, {0, 1})) + clear;
  const double before = std::max(half, reach < most ? reach / seen_from_above : 0);
  const Point2 near = panel.projection.direction_of(cross(along, normal));
  const Point2 toward = dot(near, into) < 0 ? -near : near, front = before * toward, back = half * toward;
  const std::vector<Point2> piece{begin - back, end - back, end + front, begin + front};
  panel.area(piece, "#f1f1ee", Role::paper);
  panel.loop(piece, Role::curve, 0.8, Ink::grey);
  // Seen from above a surface shows no cut.
  constexpr double from_above = 0.85;
  if (seen_from_above > from_above) return;
  cross(end - begin, into) > 0 ? hatch(panel, begin + front, end + front) : hatch(panel, end + front, begin + front);
}

// The plane in which a body moves: as a piece of ground around the place, below it if the normal is upright.
void plane_of_motion(Panel& panel, const Sketch& sketch, const Vector& normal, bool on_ground) {
  constexpr double half = 26, from_the_side = 0.1;
  const Vector& viewer = panel.projection.view().viewer;
  const Vector outward = dot(normal, panel.scene.up) < 0 ? -normal : normal;
  const Vector along = unit_or(cross(outward, viewer), across(outward)), depth = cross(along, outward);
  const Point2 side = half * direction(panel.projection.direction_of(along), {1, 0}),
               back = half * panel.projection.direction_of(depth);
  const Point2 at = sketch.at(), into = panel.projection.direction_of(-outward);
  const auto ground = [&](Point2 from, Point2 to) {
    cross(to - from, into) > 0 ? hatch(panel, from, to, 4) : hatch(panel, to, from, 4);
  };
  if (std::abs(dot(outward, viewer)) > from_the_side) {
    panel.loop({at - side - back, at + side - back, at + side + back, at - side + back}, Role::symbol, 0.9, Ink::grey);
    const Point2 front = dot(back, into) > 0 ? back : -back;
    if (on_ground) ground(at - side + front, at + side + front);
  } else {
    on_ground ? ground(at - side, at + side) : panel.line({at - side, at + side}, Role::symbol, 1.1);
  }
}

bool is_seen_end_on(const Panel& panel, const Vector& axis) {
  return std::abs(dot(axis, panel.projection.view().viewer)) > 0.85;
}

// The radius of the sleeve that stands on the ground by a bracket, if there is one.
std::optional<double> sleeve_on_ground(const Panel& panel, const scene::Symbol& symbol) {
  const Vector axis = axis_on_ground(panel, symbol);
  if (symbol.from >= 0) return std::nullopt;
  const bool has_axis = norm(axis) > 0;
  const bool end_on = is_seen_end_on(panel, has_axis ? axis : panel.scene.up);
  if (symbol.kind == SymbolKind::cylindrical) return 6;
  if (symbol.kind == SymbolKind::screw) return 5;
  const bool has_sleeve = turns_about_axis(symbol) || symbol.kind == SymbolKind::listed_support;
  return has_sleeve && has_axis && !end_on ? std::optional(5.0) : std::nullopt;
}

// Its bracket, where it belongs to a layer: what stands before a body may be held behind it.
void draw_foot(Panel& panel, const scene::Symbol& symbol, const Vector& at, Layer layer, bool behind) {
  const std::optional<double> radius = sleeve_on_ground(panel, symbol);
  if (!radius) return;
  const Sketch sketch(panel, at);
  const Vector axis = unit_or(axis_on_ground(panel, symbol), panel.scene.up);
  const Vector base = at + (*radius + foot_length) / panel.projection.scale() * ground_across(panel, sketch.at(), axis);
  if ((behind || is_behind_body(panel, base)) == (layer == Layer::behind_bodies)) foot(panel, sketch, axis, *radius);
}

void draw(Panel& panel, const scene::Symbol& symbol, const Vector& at) {
  const Vector axis = axis_on_ground(panel, symbol);
  const bool has_axis = norm(axis) > 0;
  const Vector along = has_axis ? axis : panel.scene.up;
  const bool on_ground = symbol.from < 0;
  const bool end_on = is_seen_end_on(panel, along);
  Sketch sketch(panel, at);
  switch (symbol.kind) {
    case SymbolKind::weld:
      return weld(panel, sketch, axis, on_ground);
    case SymbolKind::ball:
    case SymbolKind::ball_support:
      return ball(panel, sketch.at(), on_ground, {});
    case SymbolKind::revolute:
    case SymbolKind::hinge:
    case SymbolKind::clevis:
    case SymbolKind::fork:
    case SymbolKind::journal:
    case SymbolKind::thrust:
    case SymbolKind::listed_support:
      if (end_on || !has_axis) return pin(panel, sketch.at(), on_ground && !seen_from_above(panel), along);
      sketch.tube(along, 7, 5);
      if (symbol.kind == SymbolKind::thrust) {
        // The plate on which the end of the shaft bears.
        const Point2 side = turned_left(direction(panel.projection.direction_of(along)));
        const Point2 plate = sketch(-10.0 * along);
        panel.line({plate - 7 * side, plate + 7 * side}, Role::symbol, 2.4);
      }
      return;
    case SymbolKind::cylindrical:
    case SymbolKind::collar:
      if (end_on) return panel.shape(circle(sketch.at(), 6), metal, Role::symbol, 1.2);
      return sketch.tube(along, 11, 6);
    case SymbolKind::prismatic:
    case SymbolKind::slot:
      return draw_slide(panel, symbol, sketch.at(), along, end_on);
    case SymbolKind::planar:
      // A plane that is the paper needs no line.
      if (!end_on) plane_of_motion(panel, sketch, along, on_ground);
      return;
    case SymbolKind::screw:
      return screw(panel, sketch, along);
    case SymbolKind::universal:
      return universal(panel, sketch, along, turned_to_ground(symbol.to, symbol.second_axis, panel.poses));
    case SymbolKind::contact:
    case SymbolKind::rolling_contact:
      return contact(panel, sketch, symbol, along, on_ground);
  }
}

}  // namespace

void hatch(Panel& panel, Point2 from, Point2 to, double depth) {
  const Point2 along = direction(to - from);
  const Point2 into = depth * direction(Point2{-along.y, along.x} - 0.8 * along);
  panel.line({from, to}, Role::symbol, 1.4);
  const int count = std::max(2, static_cast<int>(norm(to - from) / 4.5));
  for (int i = 0; i < count; ++i) {
    const Point2 begin = from + ((i + 0.8) / count) * (to - from);
    panel.line({begin, begin + into}, Role::symbol, 0.7);
  }
}

void draw_symbols(Panel& panel, Layer layer) {
  if (layer == Layer::before_bodies) draw_center_lines(panel);
  const std::vector<std::optional<Gimbal>> gimbals = gimbals_of(panel.scene, panel.poses);
  for (const scene::Symbol& symbol : panel.scene.symbols) {
    if (!panel.draws(symbol.to) || !panel.draws(symbol.from)) continue;
    for (const Vector& at : places_of_symbol(panel, symbol, gimbals)) {
      const bool behind = is_contact(symbol) || is_behind_body(panel, at);
      draw_foot(panel, symbol, at, layer, behind);
      if (behind == (layer == Layer::behind_bodies)) draw(panel, symbol, at);
    }
  }
}

}  // namespace poinsot::pictures
