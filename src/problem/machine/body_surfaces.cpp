#include "problem/machine/body_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/round_surface.h"
#include "problem/machine/shape_arguments.h"
#include "problem/machine/shape_row.h"

namespace poinsot::problem {
namespace {

// Whether a place is on a corner, an edge or a flat side of one of the parts.
template <class Scalar>
bool lies_on_sides(const std::vector<Part>& parts, DataScope<Scalar>& data, const Vector3<double>& C);

}  // namespace

template <class Scalar>
RollingSurface<Scalar> rolling_surface(const Body& body, DataScope<Scalar>& data, const Vector3<Scalar>& p_OC,
                                       const Vector3<Scalar>& n, const Vector3<Scalar>& center_of_mass) {
  using Vector = Vector3<Scalar>;
  RollingSurface<Scalar> nearest_surface;
  double nearest_gap = std::numeric_limits<double>::infinity();  // as a part of its radius
  bool round_all_over = true, curved = false;
  for (const Part& part : body.parts) {
    const ShapeRow<Scalar>& row = shape_row<Scalar>(part.shape.kind);
    round_all_over = round_all_over && row.other == OtherSurface::none;
    curved = curved || row.other == OtherSurface::curved;
  }
  for (const auto* list : {&body.parts, &body.added})
    for (const Part& part : *list) {
      const ShapeRow<Scalar>& row = shape_row<Scalar>(part.shape.kind);
      if (!row.round || part.hole) continue;
      const RoundSurface<Scalar> surface = row.round(ShapeArguments<Scalar>(part.shape, data, part.name, false));
      const auto touched = std::visit([&](const auto& round) { return round.touched_at(p_OC, n); }, surface);
      if (!touched || !(touched->gap / plain(touched->radius) < nearest_gap)) continue;
      nearest_gap = touched->gap / plain(touched->radius);
      nearest_surface = *touched;
    }
  if (nearest_gap <= on_round_surface) return nearest_surface;
  if (body.parts.empty()) {
    if (body.inertia && body.inertia->axis) {
      const Vector axis = data.direction(*body.inertia->axis);
      const Vector foot = center_of_mass + dot(p_OC - center_of_mass, axis) * axis;
      // If the point is on the axis, up to rounding, the circle is a point, and its radius has no derivative.
      const Vector r = p_OC - foot;
      constexpr double rounding = 1e-12;  // of the places, which were computed from data
      const bool beside = norm(plain(r)) > rounding * (norm(plain(p_OC)) + norm(plain(center_of_mass)));
      return {ContactShape::round, foot, axis, beside ? norm(r) : Scalar(0), 0, {}, -1};
    }
    // It may have corners and flat sides by what is added to it.
    const bool straight = lies_on_sides(body.added, data, plain(p_OC));
    return {straight ? ContactShape::corner : ContactShape::unknown, {}, {}, Scalar(0), 0, {}, -1};
  }
  if (round_all_over)
    return {ContactShape::missed, {}, nearest_surface.axis, nearest_surface.radius, nearest_surface.gap, {}, -1};
  return {curved ? ContactShape::unknown : ContactShape::corner, {}, {}, Scalar(0), 0, {}, -1};
}

template <class Scalar>
bool normal_fits(const RollingSurface<Scalar>& surface, const Vector3<Scalar>& place, const Vector3<Scalar>& normal) {
  constexpr double tolerance = 1e-6;  // a sine: places are given with the six digits of a figure
  if (surface.shape != ContactShape::round || !(plain(surface.radius) > 0)) return true;
  const Vector3<double> radius = plain(place - surface.center) / plain(surface.radius), n = plain(normal);
  const Vector3<double> axis = plain(surface.axis);
  if (norm(axis) == 0) return norm(cross(radius, n)) <= tolerance;
  return std::abs(dot(cross(axis, radius), n)) <= tolerance;
}

template bool normal_fits(const RollingSurface<double>&, const Vector3<double>&, const Vector3<double>&);
template bool normal_fits(const RollingSurface<Dual<1>>&, const Vector3<Dual<1>>&, const Vector3<Dual<1>>&);
template bool normal_fits(const RollingSurface<Formula>&, const Vector3<Formula>&, const Vector3<Formula>&);
template RollingSurface<double> rolling_surface(const Body&, DataScope<double>&, const Vector3<double>&,
                                                const Vector3<double>&, const Vector3<double>&);
template RollingSurface<Dual<1>> rolling_surface(const Body&, DataScope<Dual<1>>&, const Vector3<Dual<1>>&,
                                                 const Vector3<Dual<1>>&, const Vector3<Dual<1>>&);
template RollingSurface<Formula> rolling_surface(const Body&, DataScope<Formula>&, const Vector3<Formula>&,
                                                 const Vector3<Formula>&, const Vector3<Formula>&);

namespace {

using Vector = Vector3<double>;

constexpr double at_place = 1e-6;  // distance up to which a place is on a side, as a part of the size of the side

// The directions in which a side goes on from a place in it; nothing if the place is not on the side.
std::optional<std::vector<Vector>> directions_on(const Side& side, const Vector& C) {
  double size = 0;
  for (const Vector& corner : side) size = std::max(size, norm(corner - side.front()));
  // A particle has no size of its own.
  if (side.size() == 1) size = norm(C) + norm(side.front());
  const double tolerance = at_place * size;
  for (const Vector& corner : side)
    if (norm(C - corner) <= tolerance) return std::vector<Vector>{};
  for (std::size_t i = 0; i < (side.size() == 2 ? 1 : side.size()); ++i) {
    const Vector A = side[i], AB = side[(i + 1) % side.size()] - A;
    if (!(norm(AB) > 0)) continue;
    const Vector e = normalized(AB);
    const double along = dot(C - A, e);
    if (along > 0 && along < norm(AB) && norm(C - A - along * e) <= tolerance) return std::vector<Vector>{e};
  }
  if (side.size() < 3) return std::nullopt;
  // The place is inside if the angles that the edges subtend add up to full turns (one turn for a simple polygon).
  Vector area = Vector::zero();
  for (std::size_t i = 0; i < side.size(); ++i) area = area + cross(side[i], side[(i + 1) % side.size()]);
  if (!(norm(area) > 0)) return std::nullopt;
  const Vector normal = normalized(area);
  if (std::abs(dot(C - side.front(), normal)) > tolerance) return std::nullopt;
  double turn = 0;
  for (std::size_t i = 0; i < side.size(); ++i) {
    const Vector a = side[i] - C, b = side[(i + 1) % side.size()] - C;
    turn += std::atan2(dot(cross(a, b), normal), dot(a, b));
  }
  if (std::abs(turn) < 1) return std::nullopt;
  const Vector e = normalized(side[1] - side[0]);
  return std::vector<Vector>{e, cross(normal, e)};
}

double distance_to_edge(const Vector& A, const Vector& B, const Vector& C) {
  const Vector AB = B - A;
  const double square = norm_squared(AB);
  const double along = square > 0 ? std::clamp(dot(C - A, AB) / square, 0.0, 1.0) : 0;
  return norm(C - A - along * AB);
}

double distance_to_side(const Side& side, const Vector& C) {
  double least = norm(C - side.front());
  for (std::size_t i = 0; i + 1 < side.size() + (side.size() > 2 ? 1 : 0); ++i)
    least = std::min(least, distance_to_edge(side[i], side[(i + 1) % side.size()], C));
  if (side.size() < 3) return least;
  Vector area = Vector::zero();
  for (std::size_t i = 0; i < side.size(); ++i) area = area + cross(side[i], side[(i + 1) % side.size()]);
  if (!(norm(area) > 0)) return least;
  const Vector normal = normalized(area);
  const double height = dot(C - side.front(), normal);
  return directions_on(side, C - height * normal) ? std::min(least, std::abs(height)) : least;
}

template <class Scalar>
bool lies_on_sides(const std::vector<Part>& parts, DataScope<Scalar>& data, const Vector3<double>& C) {
  return std::ranges::any_of(parts, [&](const Part& part) {
    const ShapeRow<Scalar>& row = shape_row<Scalar>(part.shape.kind);
    if (part.hole || !row.sides) return false;
    const auto sides = row.sides(ShapeArguments<Scalar>(part.shape, data, part.name, false));
    return std::ranges::any_of(sides, [&](const Side& side) { return directions_on(side, C).has_value(); });
  });
}

}  // namespace

template <class Scalar>
std::optional<double> gap_to_sides(const Body& body, DataScope<Scalar>& data, const Vector3<double>& C) {
  std::optional<double> least;
  if (body.parts.empty()) return least;
  for (const auto* list : {&body.parts, &body.added})
    for (const Part& part : *list) {
      const ShapeRow<Scalar>& row = shape_row<Scalar>(part.shape.kind);
      if (row.round || !row.sides || row.other == OtherSurface::curved) return std::nullopt;
      if (part.hole) continue;
      for (const Side& side : row.sides(ShapeArguments<Scalar>(part.shape, data, part.name, false)))
        least = std::min(least.value_or(std::numeric_limits<double>::infinity()), distance_to_side(side, C));
    }
  return least;
}

template std::optional<double> gap_to_sides(const Body&, DataScope<double>&, const Vector3<double>&);
template std::optional<double> gap_to_sides(const Body&, DataScope<Dual<1>>&, const Vector3<double>&);
template std::optional<double> gap_to_sides(const Body&, DataScope<Formula>&, const Vector3<double>&);

template <class Scalar>
std::vector<Vector3<double>> straight_directions(const Body& body, DataScope<Scalar>& data, const Vector3<double>& C,
                                                 const Vector3<double>& n) {
  constexpr double across = 1e-6;  // cosine to the normal, of sides between corners that a figure gives to six digits
  std::optional<std::vector<Vector>> fewest;
  for (const auto* list : {&body.parts, &body.added})
    for (const Part& part : *list) {
      const ShapeRow<Scalar>& row = shape_row<Scalar>(part.shape.kind);
      if (part.hole || !row.sides) continue;
      for (const Side& side : row.sides(ShapeArguments<Scalar>(part.shape, data, part.name, false)))
        if (const auto found = directions_on(side, C); found && (!fewest || found->size() < fewest->size()))
          fewest = found;
    }
  if (!fewest) return {};
  // If a direction is not perpendicular to the normal, the body does not lie on the surface but stands on it, as the
  // end of a bar does.
  for (const Vector& direction : *fewest)
    if (std::abs(dot(direction, n)) > across) return {};
  return *fewest;
}

template std::vector<Vector3<double>> straight_directions(const Body&, DataScope<double>&, const Vector3<double>&,
                                                          const Vector3<double>&);
template std::vector<Vector3<double>> straight_directions(const Body&, DataScope<Dual<1>>&, const Vector3<double>&,
                                                          const Vector3<double>&);
template std::vector<Vector3<double>> straight_directions(const Body&, DataScope<Formula>&, const Vector3<double>&,
                                                          const Vector3<double>&);

}  // namespace poinsot::problem
