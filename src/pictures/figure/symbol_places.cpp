#include "pictures/figure/symbol_places.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace poinsot::pictures {
namespace {

using scene::SymbolKind;

// Where a line crosses the solids of a body, as distances from a place on it.
std::vector<double> crossings(const Panel& panel, int body, const Vector& place, const Vector& axis) {
  const Vector first = across(axis), second = cross(axis, first);
  std::vector<double> found;
  for (const Solid& solid : panel.solids) {
    if (solid.body != body || solid.hole) continue;
    for (const auto& triangle : solid.triangles) {
      std::array<Point2, 3> corner;
      std::array<double, 3> weight{}, along{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector d = solid.vertices[triangle[k]] - place;
        corner[k] = {dot(d, first), dot(d, second)};
        along[k] = dot(d, axis);
      }
      for (std::size_t k = 0; k < 3; ++k) weight[k] = cross(corner[(k + 1) % 3], corner[(k + 2) % 3]);
      const double sum = weight[0] + weight[1] + weight[2];
      if (sum == 0 || weight[0] * sum < 0 || weight[1] * sum < 0 || weight[2] * sum < 0) continue;
      found.push_back((weight[0] * along[0] + weight[1] * along[1] + weight[2] * along[2]) / sum);
    }
  }
  return found;
}

// Both ends of the way of an axis through a body that is held inside of itself; else nothing.
std::vector<Vector> ends_of_axis(const Panel& panel, const scene::Symbol& symbol, const Vector& place) {
  if (symbol.kind != SymbolKind::revolute || !turns_about_fixed_axis(symbol)) return {};
  const Vector axis = axis_on_ground(panel, symbol);
  constexpr double clear = 9,
                   aside = 3;  // units of the paper: a bearing is as wide, and a place on a face is not inside
  const double away = clear / panel.projection.scale(), offset = aside / panel.projection.scale();
  const Vector first = across(axis), second = cross(axis, first);
  double low = -1e300, high = 1e300;
  for (const Vector& side : {first + 0.3 * second, second - 0.3 * first, -first - 0.3 * second, 0.3 * first - second}) {
    const std::vector<double> met = crossings(panel, symbol.to, place + offset * side, axis);
    if (met.empty()) return {};
    const auto [near, far] = std::ranges::minmax(met);
    low = std::max(low, near);
    high = std::min(high, far);
  }
  if (!(low < -away && high > away)) return {};
  return {place + (low - away) * axis, place + (high + away) * axis};
}

// Where the axis comes to the middle of what it carries, if another joint already stands at the place of the bearing.
std::optional<Vector> clear_of_joints(const Panel& panel, const scene::Symbol& symbol, const Vector& place) {
  if (symbol.kind != SymbolKind::revolute || !turns_about_fixed_axis(symbol)) return std::nullopt;
  const double near = 1e-6 * panel.scene.length;
  const bool taken = std::ranges::any_of(panel.scene.symbols, [&](const scene::Symbol& other) {
    return &other != &symbol && other.from >= 0 && (other.to == symbol.to || other.from == symbol.to) &&
           (other.kind == SymbolKind::universal || other.kind == SymbolKind::ball) &&
           norm(panel.ground(other.place) - place) < near;
  });
  if (!taken) return std::nullopt;
  const Vector axis = axis_on_ground(panel, symbol);
  const Vector center = panel.ground({symbol.to, panel.scene.bodies.at(static_cast<std::size_t>(symbol.to)).center});
  constexpr double part = 0.6;  // of the way to the middle, so that the bearing is not on it
  return place + part * dot(center - place, axis) * axis;
}

// The point of a body that is lowest along the normal of a contact.
Vector lowest_point(const Panel& panel, const scene::Symbol& symbol, const Vector& normal) {
  Vector best = panel.ground(symbol.place);
  double least = 1e300;
  for (const Solid& solid : panel.solids) {
    if (solid.body != symbol.to || solid.extent == scene::Extent::line || solid.hole) continue;
    for (const Vector& vertex : solid.vertices)
      if (const double height = dot(vertex, normal); height < least) {
        least = height;
        best = vertex;
      }
  }
  return best;
}

bool has_moved(const Panel& panel, int body) {
  const scene::Pose &now = panel.poses.at(static_cast<std::size_t>(body)),
                    &shown = panel.scene.bodies.at(static_cast<std::size_t>(body)).pose;
  constexpr double noticeable = 1e-9;
  double turned = 0;
  for (std::size_t i = 0; i < 3; ++i) turned = std::max(turned, norm((now.R - shown.R) * Vector::unit(i)));
  return turned > noticeable || norm(now.p - shown.p) > noticeable * panel.scene.length;
}

}  // namespace

bool is_contact(const scene::Symbol& symbol) {
  return symbol.kind == SymbolKind::contact || symbol.kind == SymbolKind::rolling_contact;
}

bool turns_about_fixed_axis(const scene::Symbol& symbol) {
  switch (symbol.kind) {
    case SymbolKind::revolute:
    case SymbolKind::hinge:
    case SymbolKind::journal:
    case SymbolKind::thrust:
    case SymbolKind::clevis:
    case SymbolKind::fork:
      return symbol.from < 0;
    default:
      return false;
  }
}

Vector axis_on_ground(const Panel& panel, const scene::Symbol& symbol) {
  if (is_contact(symbol) && symbol.from < 0 && symbol.to >= 0)
    return unit_or(panel.scene.bodies.at(static_cast<std::size_t>(symbol.to)).pose.R * symbol.axis, Vector{});
  return unit_or(turned_to_ground(symbol.to, symbol.axis, panel.poses), Vector{});
}

std::vector<Vector> places_of_symbol(const Panel& panel, const scene::Symbol& symbol,
                                     const std::vector<std::optional<Gimbal>>& gimbals) {
  std::vector<Vector> places = bearings_of(panel.scene, symbol, gimbals, panel.poses);
  if (places.size() != 1 || symbol.to < 0) return places;
  if (is_contact(symbol) && symbol.from < 0 && has_moved(panel, symbol.to))
    return {lowest_point(panel, symbol, axis_on_ground(panel, symbol))};
  if (const std::optional<Vector> clear = clear_of_joints(panel, symbol, places.front())) return {*clear};
  if (std::vector<Vector> ends = ends_of_axis(panel, symbol, places.front()); !ends.empty()) return ends;
  return places;
}

bool is_behind_body(const Panel& panel, const Vector& place) {
  const DeepPoint at{panel.projection(place), panel.projection.depth(place)};
  if (panel.visibility.seen(at)) return false;
  constexpr double near = 2;  // units of the paper
  for (const Solid& solid : panel.solids) {
    if (solid.hole || solid.stand_in) continue;
    bool before = false, after = false;
    for (const auto& triangle : solid.triangles) {
      std::array<Point2, 3> corner;
      std::array<double, 3> weight{}, depth{};
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = panel.projection(solid.vertices[triangle[k]]) - at.at;
        depth[k] = panel.projection.depth(solid.vertices[triangle[k]]);
      }
      for (std::size_t k = 0; k < 3; ++k) weight[k] = cross(corner[(k + 1) % 3], corner[(k + 2) % 3]);
      const double sum = weight[0] + weight[1] + weight[2];
      if (sum == 0 || weight[0] * sum < 0 || weight[1] * sum < 0 || weight[2] * sum < 0) continue;
      const double here = (weight[0] * depth[0] + weight[1] * depth[1] + weight[2] * depth[2]) / sum - at.depth;
      before = before || here > near;
      after = after || here < near;
    }
    if (before && !after) return true;
  }
  return false;
}

}  // namespace poinsot::pictures
