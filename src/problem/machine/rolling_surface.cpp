#include "problem/machine/rolling_surface.h"

#include <cmath>
#include <limits>
#include <variant>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/round_surface.h"
#include "problem/machine/shape_arguments.h"
#include "problem/machine/shape_row.h"

namespace poinsot::problem {

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
    if (!row.round) continue;
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
    return {ContactShape::unknown, {}, {}, Scalar(0), 0, {}, -1};
  }
  if (round_all_over) return {ContactShape::missed, {}, {}, nearest_surface.radius, nearest_surface.gap, {}, -1};
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

}  // namespace poinsot::problem
