// The paths of points, and the cones and curves of a body on which nothing acts.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pictures/drawing/label_text.h"
#include "pictures/figure/arrows.h"
#include "pictures/figure/draw_details.h"
#include "pictures/figure/herpolhode.h"
#include "pictures/figure/panel.h"

namespace poinsot::pictures {
namespace {

constexpr double side_length = 140;  // of a cone, from its apex to its rim
constexpr double beyond = 1.15;      // of the side: how long the lines are that run out of the cones

struct SeenCone {
  Point2 apex;
  std::vector<Point2> rim;
  std::size_t left = 0, right = 0;  // where the lines from the apex touch the rim
  bool inside = true;               // whether the apex lies within the rim, so that no line touches it
};

SeenCone seen(const Panel& panel, const Vector& apex, const Vector& axis, double half_angle) {
  constexpr int corners = 72;
  const Vector first = across(axis), second = cross(axis, first);
  const double side = side_length / panel.projection.scale();
  const double height = side * std::cos(half_angle), radius = side * std::sin(half_angle);
  SeenCone cone{panel.projection(apex), {}};
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    cone.rim.push_back(
        panel.projection(apex + height * axis + radius * (std::cos(angle) * first + std::sin(angle) * second)));
  }
  const auto& rim = cone.rim;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    if (cross(rim[cone.left] - cone.apex, rim[i] - cone.apex) > 0) cone.left = i;
    if (cross(rim[cone.right] - cone.apex, rim[i] - cone.apex) < 0) cone.right = i;
    if (cross(rim[(i + 1) % rim.size()] - rim[i], cone.apex - rim[i]) * cross(rim[1] - rim[0], cone.apex - rim[0]) < 0)
      cone.inside = false;
  }
  return cone;
}

void draw_cone(Panel& panel, const SeenCone& cone, bool of_body, const std::string& name) {
  const char* color = of_body ? "#f0d9b5" : "#cfdcec";
  const Dash dash = of_body ? Dash::none : Dash::fine;
  const auto add = [&](std::vector<Point2> loop) {
    panel.marks.emplace_back(Fill{.loops = {std::move(loop)}, .color = color, .role = Role::body, .opacity = 0.45});
  };
  add(cone.rim);
  if (!cone.inside) add({cone.apex, cone.rim[cone.left], cone.rim[cone.right]});
  panel.marks.emplace_back(Stroke{.points = cone.rim, .width = 1, .dash = dash, .role = Role::outline, .closed = true});
  if (!cone.inside)
    for (const std::size_t end : {cone.left, cone.right})
      panel.line({cone.apex, cone.rim[end]}, Role::outline, 1, Ink::black, dash);
  panel.labels.push_back(
      {words_label(name, 12), {{cone.rim[cone.left], {}, 5, 0}, {cone.rim[cone.right], {}, 5, 0}}, 1});
}

// A direction as an arrow, whose length says nothing.
void draw_direction(Panel& panel, const Vector& from, const Vector& along, Ink ink, const char* symbol, double length) {
  const Point2 begin = panel.projection(from), end = panel.projection(from + length * along);
  const Point2 ahead = direction(end - begin), aside = turned_left(ahead);
  panel.line({begin, end}, Role::arrow, 1.4, ink);
  for (const double back : {0.0, 8.0}) {
    const Point2 tip = end - back * ahead;
    panel.line({tip - 9.0 * ahead + 3.2 * aside, tip, tip - 9.0 * ahead - 3.2 * aside}, Role::arrowhead, 1.4, ink);
  }
  Label label = tex_label(symbol);
  label.ink = ink;
  const Point2 middle = begin + 0.6 * (end - begin);
  panel.labels.push_back(
      {std::move(label), {{end, ahead, 4, 0}, {middle, aside, 4, 2}, {middle, -aside, 4, 2}}, 3, false, ink});
}

void add_curve(Panel& panel, std::vector<Point2> points, const scene::Curve& curve) {
  if (points.size() < 2) return;
  panel.marks.emplace_back(Stroke{.points = std::move(points),
                                  .width = 1,
                                  .ink = Ink::motion,
                                  .dash = curve.kind == scene::CurveKind::herpolhode ? Dash::fine : Dash::none,
                                  .role = Role::curve,
                                  .closed = curve.closed});
}

// At one of its outermost points.
void name_curve(Panel& panel, const std::vector<Point2>& points, const std::string& name) {
  std::vector<Anchor> anchors;
  for (const Point2 outward : {Point2{-1, 0}, Point2{1, 0}, Point2{0, -1}, Point2{0, 1}}) {
    const Point2 outermost = *std::ranges::max_element(points, {}, [&](Point2 p) { return dot(p, outward); });
    anchors.push_back({outermost, outward, 5, 0});
  }
  panel.labels.push_back({words_label(name, 12), std::move(anchors), 1});
}

// How many of its points a herpolhode takes for some turns about the angular momentum: with more of them it would be a
// blot.
std::size_t points_of_turns(const scene::Curve& herpolhode, const Vector& center) {
  constexpr double most = 3 * 2 * std::numbers::pi;
  const Vector axis = direction_across(herpolhode, center);
  double turned = 0;
  std::size_t count = 1;
  for (; count < herpolhode.points.size() && std::abs(turned) < most; ++count) {
    const auto aside = [&](std::size_t i) {
      const Vector d = herpolhode.points[i] - center;
      return Vector(d - dot(d, axis) * axis);
    };
    const Vector a = aside(count - 1), b = aside(count);
    turned += std::atan2(dot(axis, cross(a, b)), dot(a, b));
  }
  return count;
}

// The herpolhode as it is seen along the angular momentum, where it is too small in the figure.
void draw_herpolhode_enlarged(Panel& panel, const scene::Curve& herpolhode, const Vector& center, double factor) {
  constexpr double readable = 26;  // units of the paper
  const Vector axis = direction_across(herpolhode, center);
  if (!(norm(axis) > 0)) return;
  const Vector first = across(axis), second = cross(axis, first);
  const std::size_t count = points_of_turns(herpolhode, center);
  Detail::Line line{.points = {}, .name = "herpolhode", .ink = Ink::motion, .dash = Dash::fine, .closed = false};
  double radius = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector d = factor * panel.projection.scale() * (herpolhode.points[i] - center);
    line.points.push_back({dot(d, first), -dot(d, second)});
    radius = std::max(radius, norm(line.points.back()));
  }
  if (line.points.empty() || radius > readable) return;
  const Point2 now = line.points.front();
  draw_detail(panel, {.lines = {std::move(line)},
                      .spots = {{{0, 0}, "\\mathbf{H}_G", Ink::momentum}, {now, "\\boldsymbol{\\omega}", Ink::motion}},
                      .words = "Seen along the angular momentum"});
}

// Needles of cones: what a plane across the angular momentum cuts of them, where they are too narrow in the figure.
void draw_cones_enlarged(Panel& panel) {
  constexpr double readable = 14;  // units of the paper
  constexpr int corners = 72;
  const scene::Cone* space = nullptr;
  for (const scene::Cone& cone : panel.scene.cones) {
    if (side_length * std::sin(cone.half_angle) > readable) return;
    if (cone.body < 0) space = &cone;
  }
  if (space == nullptr) return;
  const Vector axis = unit_or(space->axis, {0, 0, 1}), first = across(axis), second = cross(axis, first);
  const auto cut = [&](const Vector& direction) {
    const Vector d = side_length / dot(direction, axis) * direction;
    return Point2{dot(d, first), -dot(d, second)};
  };
  Detail detail{
      .lines = {}, .spots = {{{0, 0}, "\\mathbf{H}_G", Ink::momentum}}, .words = "Cut across the angular momentum"};
  for (const scene::Cone& cone : panel.scene.cones) {
    const Vector own = unit_or(turned_to_ground(cone.body, cone.axis, panel.poses), {0, 0, 1});
    const Vector side = across(own), other = cross(own, side);
    Detail::Line line{.points = {}, .name = cone.name, .dash = cone.body < 0 ? Dash::fine : Dash::none};
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      line.points.push_back(cut(std::cos(cone.half_angle) * own +
                                std::sin(cone.half_angle) * (std::cos(angle) * side + std::sin(angle) * other)));
    }
    detail.lines.push_back(std::move(line));
    if (cone.body >= 0 && norm(cone.touching_line) > 0)
      detail.spots.push_back({cut(normalized(turned_to_ground(cone.body, cone.touching_line, panel.poses))),
                              "\\boldsymbol{\\omega}", Ink::motion});
  }
  draw_detail(panel, detail);
}

// Around the herpolhode, across the angular momentum.
template <class Enlarged>
void draw_invariable_plane(Panel& panel, const scene::Curve& herpolhode, const Enlarged& enlarged, const Vector& foot,
                           const Vector& normal) {
  constexpr double margin = 1.2;
  constexpr int corners = 48;
  double radius = 0;
  for (const Vector& point : herpolhode.points) radius = std::max(radius, margin * norm(point - foot));
  const Vector first = across(normal), second = cross(normal, first);
  std::vector<Point2> rim;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    rim.push_back(panel.projection(enlarged(foot + radius * (std::cos(angle) * first + std::sin(angle) * second))));
  }
  name_curve(panel, rim, "invariable plane");
  panel.marks.emplace_back(Fill{.loops = {rim}, .color = "#cfdcec", .role = Role::body, .opacity = 0.45});
  panel.marks.emplace_back(
      Stroke{.points = std::move(rim), .width = 0.7, .ink = Ink::grey, .role = Role::curve, .closed = true});
}

}  // namespace

void draw_paths(Panel& panel) {
  for (const scene::Curve& curve : panel.scene.curves) {
    if (curve.kind != scene::CurveKind::path && curve.kind != scene::CurveKind::axis_path) continue;
    if (!panel.draws(curve.body)) continue;
    std::vector<Point2> points;
    for (const Vector& point : curve.points) points.push_back(panel.paper({curve.body, point}));
    // What stays where it is has no path.
    constexpr double least = 3;
    Box box;
    for (const Point2& p : points) box.include(p);
    if (points.empty() || std::max(box.width(), box.height()) < least) continue;
    constexpr double begin_radius = 3;
    const std::vector<Point2> begin = circle(points.front(), begin_radius);
    add_curve(panel, std::move(points), curve);
    if (!curve.closed) panel.shape(begin, "#ffffff", Role::point, 1, Ink::motion);
  }
}

void draw_polhodes(Panel& panel) {
  const scene::Curve* polhode = nullptr;
  for (const scene::Curve& curve : panel.scene.curves) {
    if (curve.kind == scene::CurveKind::polhode) polhode = &curve;
    if (curve.kind != scene::CurveKind::herpolhode || polhode == nullptr || !panel.draws(polhode->body)) continue;
    const Vector center =
        panel.ground({polhode->body, panel.scene.bodies.at(static_cast<std::size_t>(polhode->body)).center});
    double largest = 0;
    for (const Vector& point : curve.points) largest = std::max(largest, norm(point - center));
    if (!(largest > 0)) continue;
    const double factor = side_length / (panel.projection.scale() * largest);
    const auto enlarged = [&](const Vector& point) { return center + factor * (point - center); };
    if (const Vector across_plane = direction_across(curve, center); norm(across_plane) > 0) {
      const double height = dot(curve.points.front() - center, across_plane);
      draw_invariable_plane(panel, curve, enlarged, center + height * across_plane, across_plane);
      draw_direction(panel, center, across_plane, Ink::momentum, "\\mathbf{H}_G", factor * height);
    }
    for (const scene::Curve* own : {polhode, &curve}) {
      const std::size_t count = own == &curve ? points_of_turns(curve, center) : own->points.size();
      std::vector<Point2> points;
      for (std::size_t i = 0; i < count; ++i)
        points.push_back(panel.projection(enlarged(panel.ground({own->body, own->points[i]}))));
      name_curve(panel, points, own->name);
      add_curve(panel, std::move(points), *own);
    }
    draw_herpolhode_enlarged(panel, curve, center, factor);
    const Vector w = curve.points.front() - center;
    draw_direction(panel, center, normalized(w), Ink::motion, "\\boldsymbol{\\omega}", factor * norm(w));
    polhode = nullptr;
  }
}

void draw_cones(Panel& panel) {
  for (const scene::Cone& cone : panel.scene.cones) {
    const Vector apex = panel.ground({cone.body, cone.apex});
    const Vector axis = unit_or(turned_to_ground(cone.body, cone.axis, panel.poses), {0, 0, 1});
    draw_cone(panel, seen(panel, apex, axis, cone.half_angle), cone.body >= 0, cone.name);
  }
  const double length = beyond * side_length / panel.projection.scale();
  for (const scene::Cone& cone : panel.scene.cones) {
    const Vector apex = panel.ground({cone.body, cone.apex});
    const Vector axis = unit_or(turned_to_ground(cone.body, cone.axis, panel.poses), {0, 0, 1});
    if (cone.body >= 0) {
      panel.line({panel.projection(apex), panel.projection(apex + length * axis)}, Role::axis, 0.8, Ink::grey,
                 Dash::chain);
      if (norm(cone.touching_line) > 0)
        draw_direction(panel, apex, normalized(turned_to_ground(cone.body, cone.touching_line, panel.poses)),
                       Ink::motion, "\\boldsymbol{\\omega}", length);
    } else {
      draw_direction(panel, apex, axis, Ink::momentum, "\\mathbf{H}_G", length);
    }
  }
  draw_cones_enlarged(panel);
}

}  // namespace poinsot::pictures
