#include "pictures/figure/draw_slides.h"

#include <algorithm>
#include <cmath>

namespace poinsot::pictures {
namespace {

// How far a body reaches on the paper from a place to a side, and to both sides along it.
struct Reach {
  double out = 0, back = 0, before = 0;
};

bool has_area(const Solid& solid) {
  return solid.extent == scene::Extent::volume || solid.extent == scene::Extent::surface;
}

Reach reach_of(const Panel& panel, int body, Point2 at, Point2 side) {
  Reach reach;
  const Point2 along = turned_left(side);
  for (const Solid& solid : panel.solids)
    if (solid.body == body && has_area(solid) && !solid.hole)
      for (const Vector& vertex : solid.vertices) {
        const Point2 d = panel.projection(vertex) - at;
        reach.out = std::max(reach.out, dot(d, side));
        reach.back = std::max(reach.back, -dot(d, along));
        reach.before = std::max(reach.before, dot(d, along));
      }
  return reach;
}

// The rails of a slide run beside the body; one that weight presses down lies on the lower one.
void rails(Panel& panel, const scene::Symbol& symbol, Point2 at, const Vector& axis) {
  constexpr double level = 1e-6, gauge = 8, half = 26;
  const bool on_ground = symbol.from < 0;
  const Point2 along = direction(panel.projection.direction_of(axis));
  Point2 side = turned_left(along);
  if (side.y < 0) side = -side;
  const bool wide =
      std::max(reach_of(panel, symbol.to, at, side).out, reach_of(panel, symbol.to, at, -side).out) > gauge;
  const bool lies = on_ground && wide && panel.scene.gravity && symbol.kind == scene::SymbolKind::prismatic &&
                    std::abs(dot(axis, panel.scene.up)) < level;
  for (const double s : {-1.0, 1.0}) {
    if (lies && s < 0) continue;
    const Reach reach = reach_of(panel, symbol.to, at, s * side);
    const double beside = reach.out + 0.7, aside = !on_ground ? gauge : lies ? beside : std::max(gauge, beside);
    // A rail is a little longer than what slides on it.
    constexpr double overhang = 14;
    const double first = lies ? reach.back + overhang : half, last = lies ? reach.before + overhang : half;
    const Point2 direction_along = turned_left(s * side), middle = at + (s * aside) * side;
    const Point2 begin = middle - first * direction_along, end = middle + last * direction_along;
    if (on_ground)
      cross(end - begin, s * side) > 0 ? hatch(panel, begin, end, 4) : hatch(panel, end, begin, 4);
    else
      panel.line({begin, end}, Role::symbol, 1.1);
  }
}

}  // namespace

void draw_slide(Panel& panel, const scene::Symbol& symbol, Point2 at, const Vector& axis, bool end_on) {
  // Between bodies a spring along the way tells how they move.
  const bool sprung = symbol.from >= 0 && std::ranges::any_of(panel.scene.links, [&](const scene::Link& link) {
                        return link.name == symbol.name && link.to.body == symbol.to && link.from.body == symbol.from;
                      });
  if (sprung) return;
  if (!end_on) return rails(panel, symbol, at, axis);
  constexpr double half = 6;
  panel.loop({at + Point2{-half, -half}, at + Point2{half, -half}, at + Point2{half, half}, at + Point2{-half, half}},
             Role::symbol, 1.1);
}

}  // namespace poinsot::pictures
