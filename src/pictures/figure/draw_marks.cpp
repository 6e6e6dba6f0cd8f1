// Axes, named points, curves, cones.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "pictures/drawing/label_text.h"
#include "pictures/figure/arrows.h"
#include "pictures/figure/panel.h"

namespace poinsot::pictures {
namespace {

constexpr std::size_t most_points = 24;
constexpr double corner_axis = 34, point_radius = 2.2;

Box content(const Panel& panel) { return extent(panel.marks); }

void draw_axis(Panel& panel, const Vector& origin, const Vector& axis, double length, const std::string& name,
               bool behind_bodies) {
  const Point2 seen = panel.projection.direction_of(axis);
  const Point2 from = panel.projection(origin), to = from + length * seen;
  Label label = name_label(name);
  if (norm(seen) < 0.1) {
    // Along the line of sight.
    panel.shape(circle(from, 4), "#ffffff", Role::axis, 0.9);
    if (dot(axis, panel.projection.view().viewer) > 0) panel.area(circle(from, 1.4), "#1a1a1a", Role::axis);
    panel.labels.push_back({std::move(label), {{from, {-1, 1}, 6, 0}}, 2});
    return;
  }
  const Point2 along = direction(seen), side = turned_left(along);
  const Vector end = origin + (length / panel.projection.scale()) * axis;
  if (behind_bodies) {
    const DeepPoint a{from, panel.projection.depth(origin)}, b{to, panel.projection.depth(end)};
    const std::vector<Interval> parts = panel.visibility.seen(a, b);
    for (const Interval& part : parts)
      panel.line({from + part.first * (to - from), from + part.second * (to - from)}, Role::axis, 0.8, Ink::grey);
    for (const Interval& part : remainder(parts))
      panel.line({from + part.first * (to - from), from + part.second * (to - from)}, Role::hidden, 0.6, Ink::grey,
                 Dash::fine);
  } else {
    panel.line({from, to}, Role::axis, 0.9, Ink::black);
  }
  panel.line({to - 6.0 * along + 2.6 * side, to, to - 6.0 * along - 2.6 * side}, Role::axis, 0.9,
             behind_bodies ? Ink::grey : Ink::black);
  panel.labels.push_back({std::move(label), {{to, along, 3, 0}}, 2});
}

// From the origin until its end is clear of bodies.
void draw_axis_of_ground(Panel& panel, std::size_t i) {
  constexpr double least = 44, most = 420, step = 8, beyond = 12;
  const Vector axis = Vector::unit(i);
  const Point2 origin = panel.projection(Vector{}), along = panel.projection.direction_of(axis);
  double length = least;
  if (norm(along) >= 0.1)
    while (length < most && (panel.visibility.over_body(origin + length * along) ||
                             panel.visibility.over_body(origin + length * along + beyond * direction(along))))
      length += step;
  draw_axis(panel, {}, axis, length, panel.scene.axes[i], true);
}

// Those of frames of reference that stand or are turned otherwise than the ground.
void draw_axes_of_frames(Panel& panel) {
  constexpr double length = 34, near_part = 0.02, noticeable = 0.02;
  std::string primes;
  if (panel.small) return;
  for (const int body : panel.bodies) {
    if (body < 0 || !panel.scene.bodies.at(static_cast<std::size_t>(body)).frame) continue;
    primes += "'";
    const Vector origin = panel.ground({body, panel.scene.bodies[static_cast<std::size_t>(body)].center});
    double turned = 0;
    for (std::size_t i = 0; i < 3; ++i)
      turned = std::max(turned, norm(turned_to_ground(body, Vector::unit(i), panel.poses) - Vector::unit(i)));
    if (turned < noticeable && norm(origin) < near_part * panel.scene.length) continue;
    for (std::size_t i = 0; i < 3; ++i)
      draw_axis(panel, origin, turned_to_ground(body, Vector::unit(i), panel.poses), length,
                panel.scene.axes[i] + primes, true);
  }
}

// The mass centers to which momenta and their rates belong, where no point has a name: "\\dot{\\mathbf{H}}_{G}" tells
// it.
void name_centers(Panel& panel, const std::vector<scene::Arrow>& arrows, std::vector<Vector> named) {
  const double near = 1e-3 * panel.scene.length;
  for (const scene::Arrow& arrow : arrows) {
    const bool of_center = arrow.quantity == scene::Quantity::angular_momentum ||
                           arrow.quantity == scene::Quantity::rate_of_angular_momentum;
    const std::size_t index = arrow.symbol.find("_{");
    if (!of_center || index == std::string::npos || !arrow.symbol.ends_with('}')) continue;
    if (!panel.draws(arrow.at.body)) continue;
    const Vector at = panel.ground(arrow.at);
    if (std::ranges::any_of(named, [&](const Vector& other) { return norm(other - at) < near; })) continue;
    named.push_back(at);
    const Point2 paper = panel.projection(at);
    panel.area(circle(paper, point_radius), "#1a1a1a", Role::point);
    panel.labels.push_back({tex_label(arrow.symbol.substr(index + 2, arrow.symbol.size() - index - 3)),
                            {{paper, {-0.5, -0.8}, 4, 0}},
                            2.4});
  }
}

}  // namespace

void draw_axes(Panel& panel, bool at_origin) {
  const Box box = content(panel);
  const Point2 origin = panel.projection(Vector{});
  if (at_origin && !box.empty() && box.grown(0.1 * std::max(box.width(), box.height()) + 4).contains(origin)) {
    for (std::size_t i = 0; i < 3; ++i) draw_axis_of_ground(panel, i);
    draw_axes_of_frames(panel);
    return;
  }
  // In the lower left corner, where its longest axis stays clear of everything.
  const Point2 corner = box.empty() ? Point2{} : Point2{box.left - 26, box.bottom + 8};
  const View& view = panel.projection.view();
  const Point2 from = panel.projection(panel.projection.center());
  const Point2 d = corner - from;
  const Vector place = panel.projection.center() + (d.x / panel.projection.scale()) * view.right -
                       (d.y / panel.projection.scale()) * view.up;
  for (std::size_t i = 0; i < 3; ++i) draw_axis(panel, place, Vector::unit(i), corner_axis, panel.scene.axes[i], false);
}

void draw_points(Panel& panel, const std::vector<scene::Arrow>& arrows, bool cut_free,
                 const std::vector<scene::Arrow>& momenta) {
  // Points that something drawn stands at come first; others are left out where there are too many.
  std::vector<Vector> places;
  // What is cut free has left behind where the rest is held.
  const auto counts = [&](int body) { return !cut_free || (body >= 0 && panel.draws(body)); };
  for (const scene::Symbol& symbol : panel.scene.symbols)
    if (counts(symbol.to)) places.push_back(panel.ground(symbol.place));
  for (const scene::Link& link : panel.scene.links)
    for (const scene::Place& place : {link.from, link.to})
      if (counts(place.body)) places.push_back(panel.ground(place));
  for (const scene::Arrow& arrow : arrows) places.push_back(panel.ground(arrow.at));
  for (const int body : panel.bodies)
    if (body >= 0) places.push_back(panel.ground({body, panel.scene.bodies.at(static_cast<std::size_t>(body)).center}));
  const double near = 1e-3 * panel.scene.length;
  const auto matters = [&](const Vector& at) {
    return std::ranges::any_of(places, [&](const Vector& place) { return norm(place - at) < near; });
  };
  // A point that only defines an axis may lie far from the body.
  const Box box = content(panel);
  constexpr double beside = 0.15;
  const Box near_content = box.empty() ? box : box.grown(beside * std::max(box.width(), box.height()) + corner_axis);
  // Where something cut off was held, its points stay: a pin is named on both bodies that it joins.
  const auto is_at_cut = [&](const Vector& at) {
    const auto is_drawn = [&](int body) { return body >= 0 && panel.draws(body); };
    return cut_free && std::ranges::any_of(panel.scene.symbols, [&](const scene::Symbol& symbol) {
             return (is_drawn(symbol.to) || is_drawn(symbol.from)) && norm(panel.ground(symbol.place) - at) < near;
           });
  };
  struct NamedPoint {
    Vector at;
    std::string name;
    bool of_other = false;  // it belongs to a body that is not drawn, and is left out where it finds no room
  };
  std::vector<NamedPoint> drawn;
  for (const bool first : {true, false})
    for (const scene::Point& point : panel.scene.points) {
      const Vector at = panel.ground(point.place);
      const bool of_other = !panel.draws(point.place.body);
      if (of_other && !is_at_cut(at)) continue;
      if (matters(at) != first || (!first && panel.scene.points.size() > most_points)) continue;
      if (cut_free && !first && (point.place.body < 0 || !near_content.contains(panel.projection(at)))) continue;
      const auto same = std::ranges::find_if(drawn, [&](const auto& other) { return norm(other.at - at) < near; });
      if (same == drawn.end()) {
        drawn.push_back({at, point.name, of_other});
      } else if (!of_other) {
        same->name = same->of_other ? point.name : same->name + ", " + point.name;
        same->of_other = false;
      }
    }
  if (drawn.size() > 2 * most_points) drawn.resize(2 * most_points);
  for (const auto& [at, name, of_other] : drawn) {
    const Point2 paper = panel.projection(at);
    panel.area(circle(paper, point_radius), "#1a1a1a", Role::point);
    panel.labels.push_back(
        {name_label(name), {{paper, {-0.5, -0.8}, 4, 0}}, 2.5, of_other || drawn.size() > most_points});
  }
  std::vector<Vector> named;
  for (const NamedPoint& point : drawn) named.push_back(point.at);
  name_centers(panel, momenta.empty() ? arrows : momenta, std::move(named));
}

namespace {

// The lines of a body on the paper: of a volume or a surface the sides of its triangles.
std::vector<std::pair<Point2, Point2>> lines_of(const std::vector<Solid>& solids, const Projection& projection) {
  std::vector<std::pair<Point2, Point2>> lines;
  for (const Solid& solid : solids) {
    if (solid.hole) continue;
    std::vector<Point2> at;
    for (const Vector& vertex : solid.vertices) at.push_back(projection(vertex));
    for (const auto& line : solid.lines)
      for (std::size_t i = 0; i + 1 < line.size(); ++i) lines.emplace_back(at[line[i]], at[line[i + 1]]);
    for (const auto& triangle : solid.triangles)
      for (std::size_t k = 0; k < 3; ++k) lines.emplace_back(at[triangle[k]], at[triangle[(k + 1) % 3]]);
  }
  return lines;
}

// The point of the lines that is nearest to another; this one if there are none.
Point2 onto(const std::vector<std::pair<Point2, Point2>>& lines, Point2 from) {
  Point2 nearest = from;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : lines) {
    const Point2 along = b - a;
    const double square = dot(along, along);
    const Point2 at = a + (square > 0 ? std::clamp(dot(from - a, along) / square, 0.0, 1.0) : 0.0) * along;
    if (const double away = norm(at - from); away < least) {
      least = away;
      nearest = at;
    }
  }
  return nearest;
}

}  // namespace

void draw_body_names(Panel& panel) {
  std::size_t shown = 0;
  for (const int body : panel.bodies)
    if (body >= 0) ++shown;
  if (shown < 2) return;
  for (const int body : panel.bodies) {
    if (body < 0) continue;
    const scene::Body& own = panel.scene.bodies.at(static_cast<std::size_t>(body));
    if (own.shapes.empty()) continue;
    std::string words = own.name;
    std::ranges::replace(words, '_', ' ');
    Label label = words_label(words, 12);
    label.ink = Ink::grey;
    Box box;
    // The name stands at the body rather than at the arms that hold it.
    const auto is_arm = [&](const Solid& solid) { return solid.massless && !own.massless; };
    for (const Solid& solid : panel.solids)
      if (solid.body == body && !solid.hole && !is_arm(solid))
        for (const Vector& vertex : solid.vertices) box.include(panel.projection(vertex));
    if (box.empty()) continue;
    std::vector<Solid> solids;
    for (const Solid& solid : panel.solids) {
      if (solid.body != body) continue;
      solids.push_back(solid);
      if (solid.extent != scene::Extent::point) continue;
      for (const Vector& vertex : solid.vertices)
        for (const Point2& corner : block_of_particle(panel, body, vertex)) box.include(corner);
    }
    // On another body it would be read as that one's.
    const auto alone = std::make_shared<const Visibility>(solids, panel.projection);
    std::vector<Anchor> anchors{{box.center(), {}, 3, 0},
                                {{box.center().x, box.top}, {0, -1}, 4, 2},
                                {{box.center().x, box.bottom}, {0, 1}, 4, 2},
                                {{box.left, box.center().y}, {-1, 0}, 4, 2},
                                {{box.right, box.center().y}, {1, 0}, 4, 2}};
    // A slanting rod is far from the middles of the sides of its box.
    std::erase_if(solids, is_arm);
    const auto lines = lines_of(solids, panel.projection);
    constexpr double at_body = 6;
    for (Anchor& anchor : anchors) {
      const Point2 nearest = onto(lines, anchor.at);
      if (norm(nearest - anchor.at) > at_body && !alone->over_body(anchor.at)) anchor = {nearest, {}, 4, anchor.cost};
    }
    panel.labels.push_back({std::move(label), std::move(anchors), 0.5, true, Ink::grey, [alone, &panel](Point2 at) {
                              return panel.visibility.over_body(at) && !alone->over_body(at);
                            }});
  }
}

}  // namespace poinsot::pictures
