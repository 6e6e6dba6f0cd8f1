// The axes of joints.
#include <algorithm>
#include <cmath>

#include "pictures/figure/panel.h"
#include "pictures/figure/symbol_places.h"

namespace poinsot::pictures {
namespace {

// The axis of a joint as a chain line, as far as named points lie on it; a fixed one through all of the body that
// turns, and a little beyond.
void draw_center_line(Panel& panel, const scene::Symbol& symbol) {
  if (is_contact(symbol) || !(norm(symbol.axis) > 0)) return;
  const Vector at = panel.ground(symbol.place);
  const Vector axis = normalized(turned_to_ground(symbol.to, symbol.axis, panel.poses));
  const double near = 1e-6 * panel.scene.length;
  double first = 0, last = 0;
  for (const scene::Point& point : panel.scene.points) {
    if (!panel.draws(point.place.body)) continue;
    const Vector d = panel.ground(point.place) - at;
    if (norm(cross(d, axis)) > near) continue;
    first = std::min(first, dot(d, axis));
    last = std::max(last, dot(d, axis));
  }
  // Of a hinge between two bodies to where it is nearest to their mass centers.
  if (turns_about_axis(symbol) && symbol.from >= 0)
    for (const int body : {symbol.from, symbol.to}) {
      const scene::Body& own = panel.scene.bodies.at(static_cast<std::size_t>(body));
      if (own.massless) continue;
      const double along = dot(panel.ground({body, own.center}) - at, axis);
      first = std::min(first, along);
      last = std::max(last, along);
    }
  bool through_body = false;
  if (turns_about_fixed_axis(symbol)) {
    constexpr double overhang = 16;
    const double beyond = overhang / panel.projection.scale();
    for (const Solid& solid : panel.solids) {
      if (solid.body != symbol.to || solid.extent == scene::Extent::line || solid.hole) continue;
      through_body = true;
      for (const Vector& vertex : solid.vertices) {
        first = std::min(first, dot(vertex - at, axis) - beyond);
        last = std::max(last, dot(vertex - at, axis) + beyond);
      }
    }
  }
  if (last - first <= near) return;
  const Vector from = at + first * axis, to = at + last * axis;
  panel.seen_line(from, to, Role::hidden, 0.7, Ink::grey, Dash::chain);
  if (!through_body) return;
  const DeepPoint a{panel.projection(from), panel.projection.depth(from)},
      b{panel.projection(to), panel.projection.depth(to)};
  for (const Interval& part : remainder(panel.visibility.seen(a, b)))
    panel.line({a.at + part.first * (b.at - a.at), a.at + part.second * (b.at - a.at)}, Role::hidden, 0.6, Ink::grey,
               Dash::hidden);
}

// The pitch circles of gears, which touch where their teeth meet.
void draw_pitch_circles(Panel& panel) {
  for (const scene::Curve& curve : panel.scene.curves) {
    if (curve.kind != scene::CurveKind::pitch_circle || !panel.draws(curve.body)) continue;
    std::vector<Point2> points;
    for (const Vector& point : curve.points) points.push_back(panel.paper({curve.body, point}));
    panel.marks.emplace_back(Stroke{.points = std::move(points),
                                    .width = 0.7,
                                    .ink = Ink::grey,
                                    .dash = Dash::chain,
                                    .role = Role::hidden,
                                    .closed = true});
  }
}

}  // namespace

void draw_center_lines(Panel& panel) {
  draw_pitch_circles(panel);
  for (const scene::Symbol& symbol : panel.scene.symbols)
    if (panel.draws(symbol.to) && panel.draws(symbol.from)) draw_center_line(panel, symbol);
}

}  // namespace poinsot::pictures
