#include "pictures/solids/bent_arms.h"

#include <algorithm>
#include <cmath>

namespace poinsot::pictures {
namespace {

// The corners of a way that takes a part of its length along the first axis at its begin, and the rest at its end.
std::vector<Vector> corners_of(const ArmEnd& from, const Vector& along, const Vector& across_both, const Vector& other,
                               double part, double near) {
  std::vector<Vector> way{from.at};
  for (const Vector& leg : {part * along, across_both, other, (1 - part) * along})
    if (norm(leg) > near) way.push_back(way.back() + leg);
  return way;
}

bool is_clear(const std::vector<Vector>& way, const std::vector<Sweep>& sweeps) {
  constexpr int samples = 24;
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
    for (int k = 0; k <= samples; ++k) {
      const Vector p = way[i] + (static_cast<double>(k) / samples) * (way[i + 1] - way[i]);
      if (std::ranges::any_of(sweeps, [&](const Sweep& sweep) { return sweep.takes(p); })) return false;
    }
  return true;
}

}  // namespace

bool Sweep::takes(const Vector& place) const {
  // On the axis an arm may come up to the body, and its faces may touch the arm.
  constexpr double axle = 0.15, touching = 0.05;
  const Vector d = place - at;
  const double along = dot(d, axis), aside = norm(cross(d, axis));
  return aside > axle * radius && aside < radius && along > low + touching * radius && along < high - touching * radius;
}

Sweep sweep_of(const Vector& at, const Vector& axis, const std::vector<Vector>& vertices) {
  Sweep sweep{at, axis};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vector d = vertices[i] - at;
    const double along = dot(d, axis);
    sweep.radius = std::max(sweep.radius, norm(cross(d, axis)));
    sweep.low = i == 0 ? along : std::min(sweep.low, along);
    sweep.high = i == 0 ? along : std::max(sweep.high, along);
  }
  return sweep;
}

std::vector<Vector> bent_way(const ArmEnd& from, const ArmEnd& to, const std::vector<Sweep>& sweeps, double near) {
  constexpr double askew = 1e-3;
  std::vector<Vector> straight{from.at, to.at};
  const Vector d = to.at - from.at;
  if (std::abs(dot(from.axis, to.axis)) > askew) return straight;
  const Vector along = dot(d, from.axis) * from.axis, other = dot(d, to.axis) * to.axis;
  const Vector across_both = d - along - other;
  for (const double part : {1.0, 0.75, 0.5, 0.25, 0.0}) {
    std::vector<Vector> way = corners_of(from, along, across_both, other, part, near);
    if (is_clear(way, sweeps)) {
      way.back() = to.at;
      return way;
    }
  }
  return straight;
}

std::vector<Vector> fork_way(const Vector& from, const Vector& to, const Vector& stem, const Sweep& sweep,
                             double near) {
  constexpr double clear_part = 1.15;
  const auto is_on_axis = [&](const Vector& place) { return norm(cross(place - sweep.at, sweep.axis)) < near; };
  const Vector arm = stem - from, aside = arm - dot(arm, sweep.axis) * sweep.axis;
  const double clear = clear_part * sweep.radius;
  const double middle = dot(0.5 * (from + to) - sweep.at, sweep.axis);
  if (!(middle > sweep.low && middle < sweep.high)) return {};
  if (!is_on_axis(from) || !is_on_axis(to) || !(sweep.radius > near) || !(norm(aside) > clear + near)) return {};
  const Vector out = clear * normalized(aside);
  return {from, from + out, to + out, to};
}

}  // namespace poinsot::pictures
