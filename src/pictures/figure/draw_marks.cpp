// Axes, named points, dimensions, curves.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "pictures/drawing/label_text.h"
#include "pictures/figure/arrows.h"
#include "pictures/figure/panel.h"

namespace poinsot::pictures {
namespace {

constexpr std::size_t most_dimensions = 8, most_points = 24;
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

void draw_points(Panel& panel, const std::vector<scene::Arrow>& arrows) {
  // Points that something drawn stands at come first; others are left out where there are too many.
  std::vector<Vector> places;
  for (const scene::Symbol& symbol : panel.scene.symbols) places.push_back(panel.ground(symbol.place));
  for (const scene::Link& link : panel.scene.links) {
    places.push_back(panel.ground(link.from));
    places.push_back(panel.ground(link.to));
  }
  for (const scene::Arrow& arrow : arrows) places.push_back(panel.ground(arrow.at));
  for (const int body : panel.bodies)
    if (body >= 0) places.push_back(panel.ground({body, panel.scene.bodies.at(static_cast<std::size_t>(body)).center}));
  const double near = 1e-3 * panel.scene.length;
  const auto matters = [&](const Vector& at) {
    return std::ranges::any_of(places, [&](const Vector& place) { return norm(place - at) < near; });
  };
  std::vector<std::pair<Vector, std::string>> drawn;
  for (const bool first : {true, false})
    for (const scene::Point& point : panel.scene.points) {
      if (!panel.draws(point.place.body)) continue;
      const Vector at = panel.ground(point.place);
      if (matters(at) != first || (!first && panel.scene.points.size() > most_points)) continue;
      const auto same = std::ranges::find_if(drawn, [&](const auto& other) { return norm(other.first - at) < near; });
      if (same == drawn.end())
        drawn.emplace_back(at, point.name);
      else
        same->second += ", " + point.name;
    }
  if (drawn.size() > 2 * most_points) drawn.resize(2 * most_points);
  for (const auto& [at, name] : drawn) {
    const Point2 paper = panel.projection(at);
    panel.area(circle(paper, point_radius), "#1a1a1a", Role::point);
    panel.labels.push_back({name_label(name), {{paper, {-0.5, -0.8}, 4, 0}}, 2.5});
  }
}

void draw_body_names(Panel& panel) {
  std::size_t shown = 0;
  for (const int body : panel.bodies)
    if (body >= 0) ++shown;
  if (shown < 2) return;
  for (const int body : panel.bodies) {
    if (body < 0) continue;
    const scene::Body& own = panel.scene.bodies.at(static_cast<std::size_t>(body));
    if (own.shapes.empty()) continue;
    Label label = words_label(own.name, 12);
    label.ink = Ink::grey;
    Box box;
    for (const Solid& solid : panel.solids)
      if (solid.body == body && !solid.hole)
        for (const Vector& vertex : solid.vertices) box.include(panel.projection(vertex));
    if (box.empty()) continue;
    panel.labels.push_back({std::move(label),
                            {{box.center(), {}, 3, 0},
                             {{box.center().x, box.top}, {0, -1}, 4, 2},
                             {{box.center().x, box.bottom}, {0, 1}, 4, 2},
                             {{box.left, box.center().y}, {-1, 0}, 4, 2},
                             {{box.right, box.center().y}, {1, 0}, 4, 2}},
                            0.5,
                            true});
  }
}

namespace {

// The symbol sloped, its value upright.
Label label_of(const scene::Dimension& dimension) {
  const std::size_t sign = dimension.text.find(" = ");
  if (sign == std::string::npos) return name_label(dimension.text.empty() ? dimension.name : dimension.text, 12);
  std::string value = dimension.text.substr(sign + 1);
  if (value.ends_with(" deg")) value.replace(value.size() - 4, 4, "°");
  return joined(name_label(std::string_view(dimension.text).substr(0, sign), 12), words_label(value, 12), 3);
}

void draw_length(Panel& panel, const scene::Dimension& dimension) {
  const Point2 from = panel.paper(dimension.from), to = panel.paper(dimension.to);
  const double length = norm(to - from);
  Label label = label_of(dimension);
  if (length < 14) return;
  const Point2 along = direction(to - from), side = turned_left(along);
  const Box box = content(panel);
  double best_offset = 16, least = 1e9;
  for (const double offset : {16.0, -16.0, 28.0, -28.0, 42.0, -42.0, 60.0, -60.0}) {
    const Point2 a = from + offset * side, b = to + offset * side;
    double cost = std::abs(offset) / 30 + 4 * panel.visibility.covered(a, b);
    for (const Mark& mark : panel.marks) {
      const auto* stroke = std::get_if<Stroke>(&mark);
      if (stroke == nullptr || stroke->role == Role::body) continue;
      for (std::size_t i = 0; i + 1 < stroke->points.size(); ++i) {
        const Point2 p = stroke->points[i], q = stroke->points[i + 1];
        Box near;
        near.include(a);
        near.include(b);
        if (std::abs(along.x) > 0.99 || std::abs(along.y) > 0.99) cost += length_within(near.grown(5), p, q) / 20;
        if (distance(p, a, b) < 7 && distance(q, a, b) < 7) cost += norm(q - p) / 12;
      }
    }
    // Outside of the picture rather than across it.
    if (!box.contains(a) || !box.contains(b)) cost -= 0.2;
    if (cost < least) {
      least = cost;
      best_offset = offset;
    }
  }
  const double sign = best_offset > 0 ? 1 : -1;
  const Point2 a = from + best_offset * side, b = to + best_offset * side;
  panel.line({from + (sign * 4) * side, a + (sign * 3) * side}, Role::dimension, 0.6, Ink::grey);
  panel.line({to + (sign * 4) * side, b + (sign * 3) * side}, Role::dimension, 0.6, Ink::grey);
  const Point2 middle = 0.5 * (a + b);
  if (length > 30) {
    plain_arrow(panel, middle, a, Role::dimension, 0.7, Ink::grey, 6);
    plain_arrow(panel, middle, b, Role::dimension, 0.7, Ink::grey, 6);
  } else {
    plain_arrow(panel, a - 12.0 * along, a, Role::dimension, 0.7, Ink::grey, 6);
    plain_arrow(panel, b + 12.0 * along, b, Role::dimension, 0.7, Ink::grey, 6);
  }
  panel.labels.push_back({std::move(label), {{middle, sign * side, 3, 0}, {middle, -sign * side, 3, 0.5}}, 1.5});
}

void draw_angle(Panel& panel, const scene::Dimension& dimension) {
  const Vector corner = panel.ground(dimension.corner);
  const Vector a = panel.ground(dimension.from) - corner, b = panel.ground(dimension.to) - corner;
  if (!(norm(a) > 0) || !(norm(b) > 0)) return;
  const Vector first = normalized(a);
  const Vector second = unit_or(b - dot(b, first) * first, Vector{});
  if (norm(second) == 0) return;
  const double angle = std::atan2(dot(b, second), dot(b, first));
  const double radius = 34 / panel.projection.scale();
  std::vector<Point2> points;
  for (int i = 0; i <= 24; ++i) {
    const double turn = angle * i / 24;
    points.push_back(panel.projection(corner + radius * (std::cos(turn) * first + std::sin(turn) * second)));
  }
  const Point2 at = panel.projection(corner);
  for (const Vector& arm : {first, normalized(b)})
    panel.line({at, panel.projection(corner + (1.25 * radius) * arm)}, Role::dimension, 0.6, Ink::grey);
  const Point2 middle = points[12];
  panel.line(std::move(points), Role::dimension, 0.8, Ink::grey);
  Label label = label_of(dimension);
  panel.labels.push_back({std::move(label), {{middle, middle - at, 4, 0}}, 1.5});
}

}  // namespace

void draw_dimensions(Panel& panel) {
  std::size_t drawn = 0;
  for (const scene::Dimension& dimension : panel.scene.dimensions) {
    if (!panel.draws(dimension.from.body) || !panel.draws(dimension.to.body)) continue;
    if (++drawn > most_dimensions) break;
    dimension.angle ? draw_angle(panel, dimension) : draw_length(panel, dimension);
  }
}

void draw_curves(Panel& panel, CurvesDrawn which) {
  for (const scene::Curve& curve : panel.scene.curves) {
    const bool path = curve.kind == scene::CurveKind::path || curve.kind == scene::CurveKind::axis_path;
    if (path != (which == CurvesDrawn::paths)) continue;
    if (!panel.draws(curve.body)) continue;
    std::vector<Point2> points;
    for (const Vector& point : curve.points) points.push_back(panel.paper({curve.body, point}));
    if (points.size() < 2) continue;
    panel.marks.emplace_back(Stroke{.points = std::move(points),
                                    .width = 1,
                                    .ink = Ink::motion,
                                    .dash = curve.kind == scene::CurveKind::herpolhode ? Dash::fine : Dash::none,
                                    .role = Role::curve,
                                    .closed = curve.closed});
  }
}

void draw_cones(Panel& panel) {
  for (const scene::Cone& cone : panel.scene.cones) {
    const Vector apex = panel.ground({cone.body, cone.apex});
    const Vector axis = unit_or(turned_to_ground(cone.body, cone.axis, panel.poses), {0, 0, 1});
    const Vector first = across(axis), second = cross(axis, first);
    const double side = 110 / panel.projection.scale();
    const double height = side * std::cos(cone.half_angle), radius = side * std::sin(cone.half_angle);
    std::vector<Point2> rim;
    for (int i = 0; i < 72; ++i) {
      const double angle = 2 * 3.14159265358979 * i / 72;
      rim.push_back(
          panel.projection(apex + height * axis + radius * (std::cos(angle) * first + std::sin(angle) * second)));
    }
    // Its outline: the lines from the apex that touch the rim.
    const Point2 at = panel.projection(apex);
    std::size_t left = 0, right = 0;
    bool inside = true;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      if (cross(rim[left] - at, rim[i] - at) > 0) left = i;
      if (cross(rim[right] - at, rim[i] - at) < 0) right = i;
      if (cross(rim[(i + 1) % rim.size()] - rim[i], at - rim[i]) * cross(rim[1] - rim[0], at - rim[0]) < 0)
        inside = false;
    }
    const bool body_cone = cone.body >= 0;
    panel.marks.emplace_back(
        Fill{.loops = {rim}, .color = body_cone ? "#f0d9b5" : "#cfdcec", .role = Role::body, .opacity = 0.45});
    if (!inside)
      panel.marks.emplace_back(Fill{.loops = {{at, rim[left], rim[right]}},
                                    .color = body_cone ? "#f0d9b5" : "#cfdcec",
                                    .role = Role::body,
                                    .opacity = 0.45});
    panel.marks.emplace_back(Stroke{
        .points = rim, .width = 1, .dash = body_cone ? Dash::none : Dash::fine, .role = Role::outline, .closed = true});
    if (!inside)
      for (const std::size_t end : {left, right})
        panel.line({at, rim[end]}, Role::outline, 1, Ink::black, body_cone ? Dash::none : Dash::fine);
    panel.labels.push_back({words_label(cone.name, 12), {{rim[left], {}, 5, 0}, {rim[right], {}, 5, 0}}, 1});
    if (norm(cone.touching_line) > 0) {
      const Vector line = side * 1.12 * normalized(turned_to_ground(cone.body, cone.touching_line, panel.poses));
      panel.line({at, panel.projection(apex + line)}, Role::curve, 1.2, Ink::motion);
    }
  }
}

}  // namespace poinsot::pictures
