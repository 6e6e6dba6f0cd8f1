// The paths of points, and the cones and curves of a body on which nothing acts.
#include <cmath>
#include <numbers>
#include <utility>

#include "pictures/drawing/label_text.h"
#include "pictures/figure/arrows.h"
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
void draw_direction(Panel& panel, const Vector& from, const Vector& along, Ink ink, const char* symbol) {
  const double length = beyond * side_length / panel.projection.scale();
  const Point2 begin = panel.projection(from), end = panel.projection(from + length * along);
  const Point2 ahead = direction(end - begin), aside = turned_left(ahead);
  panel.line({begin, end}, Role::arrow, 1.4, ink);
  for (const double back : {0.0, 8.0}) {
    const Point2 tip = end - back * ahead;
    panel.line({tip - 9.0 * ahead + 3.2 * aside, tip, tip - 9.0 * ahead - 3.2 * aside}, Role::arrowhead, 1.4, ink);
  }
  Label label = tex_label(symbol);
  label.ink = ink;
  panel.labels.push_back({std::move(label), {{end, ahead, 4, 0}}, 3, false, ink});
}

}  // namespace

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
    draw_cone(panel, seen(panel, apex, axis, cone.half_angle), cone.body >= 0, cone.name);
  }
  for (const scene::Cone& cone : panel.scene.cones) {
    const Vector apex = panel.ground({cone.body, cone.apex});
    const Vector axis = unit_or(turned_to_ground(cone.body, cone.axis, panel.poses), {0, 0, 1});
    if (cone.body >= 0) {
      const double length = beyond * side_length / panel.projection.scale();
      panel.line({panel.projection(apex), panel.projection(apex + length * axis)}, Role::axis, 0.8, Ink::grey,
                 Dash::chain);
      if (norm(cone.touching_line) > 0)
        draw_direction(panel, apex, normalized(turned_to_ground(cone.body, cone.touching_line, panel.poses)),
                       Ink::motion, "\\boldsymbol{\\omega}");
    } else {
      draw_direction(panel, apex, axis, Ink::momentum, "\\mathbf{H}_G");
    }
  }
}

}  // namespace poinsot::pictures
