#include "statement/rolling_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "poinsot/math/plain.h"
#include "statement/exact_numbers.h"
#include "statement/shapes.h"

namespace poinsot::statement {

template <class Scalar>
RollingSurface<Scalar> rolling_surface(const Body& body, DataScope<Scalar>& data, const Vector3<Scalar>& p_OC,
                                       const Vector3<Scalar>& center_of_mass) {
  using Vector = Vector3<Scalar>;
  constexpr double on_surface = 1e-6;  // of its radius
  const std::string& file = data.problem().file;
  RollingSurface<Scalar> nearest_surface;
  double nearest_gap = std::numeric_limits<double>::infinity();
  bool other_shapes = false;
  // A circle about an axis (a sphere for a zero axis) on which the point may lie, `gap` off it.
  const auto offer = [&](const Vector& center, const Vector& axis, const Scalar& radius, double gap) {
    if (gap / plain(radius) >= nearest_gap) return;
    nearest_gap = gap / plain(radius);
    nearest_surface = {ContactShape::round, center, axis, radius, gap, false};
  };
  for (const Part& part : body.parts) {
    const std::string& kind = part.shape.kind;
    const auto place = [&](const char* name) { return data.place(shape_argument(part.shape, name, file)); };
    const auto direction = [&](const char* name) { return data.direction(shape_argument(part.shape, name, file)); };
    const auto length = [&](const char* name) {
      return data.number(shape_argument(part.shape, name, file), dimensions::length);
    };
    // A frustum from A (radius r_A) to B (radius r_B): the circle about its axis through the point.
    const auto frustum = [&](const Vector& A, const Scalar& r_A, const Vector& B, const Scalar& r_B) {
      const Vector axis = normalized(B - A);
      const Scalar height = norm(B - A), along = dot(p_OC - A, axis);
      const Scalar inside = plain(along) < 0 ? Scalar(0) : plain(along) > plain(height) ? height : along;
      const Scalar radius = r_A + (r_B - r_A) * inside / height;
      const double rho = norm(plain(p_OC - (A + along * axis)));
      offer(A + inside * axis, axis, plain(radius) > 1e-300 ? radius : Scalar(1e-300),
            std::hypot(rho - plain(radius), plain(along - inside)));
    };
    if (kind == "sphere" || kind == "sphere_shell" || kind == "hemisphere" || kind == "hemisphere_shell") {
      const Vector center = place("center");
      const Scalar radius = length("radius");
      offer(center, Vector::zero(), radius, std::abs(norm(plain(p_OC - center)) - plain(radius)));
      nearest_surface.edged = kind == "hemisphere" || kind == "hemisphere_shell";
    } else if (kind == "disk" || kind == "ring" || kind == "annulus") {
      const Vector center = place("center"), axis = direction("normal");
      const Scalar along = dot(p_OC - center, axis), radius = length("radius");
      offer(center, axis, radius, std::hypot(norm(plain(p_OC - center - along * axis)) - plain(radius), plain(along)));
    } else if (kind == "cylinder" || kind == "tube" || kind == "cylinder_shell" || kind == "closed_cylinder_shell") {
      const Vector half = Scalar(0.5) * length("length") * direction("axis");
      frustum(place("center") - half, length("radius"), place("center") + half, length("radius"));
    } else if (kind == "cone" || kind == "cone_shell") {
      frustum(place("apex"), Scalar(0), place("base"), length("radius"));
    } else if (kind == "frustum") {
      frustum(place("base"), length("base_radius"), place("top"), length("top_radius"));
    } else {
      other_shapes = true;
    }
  }
  if (nearest_gap <= on_surface) return nearest_surface;
  if (body.parts.empty()) {
    if (body.inertia && body.inertia->axis) {
      const Vector axis = data.direction(*body.inertia->axis);
      const Vector foot = center_of_mass + dot(p_OC - center_of_mass, axis) * axis;
      // On the axis itself the circle is a point, and its radius has no derivative.
      const Vector r = p_OC - foot;
      return {ContactShape::round, foot, axis, norm(plain(r)) > 0 ? norm(r) : Scalar(0), 0, false};
    }
    return {ContactShape::unknown, {}, {}, Scalar(0), 0, false};
  }
  if (!other_shapes) return {ContactShape::missed, {}, {}, nearest_surface.radius, nearest_surface.gap, false};
  const bool curved = std::any_of(body.parts.begin(), body.parts.end(), [](const Part& part) {
    return part.shape.kind == "torus" || part.shape.kind == "ellipsoid" || part.shape.kind == "mesh" ||
           part.shape.kind == "arc";
  });
  return {curved ? ContactShape::unknown : ContactShape::corner, {}, {}, Scalar(0), 0, false};
}

template <class Scalar>
bool normal_fits(const RollingSurface<Scalar>& surface, const Vector3<Scalar>& place, const Vector3<Scalar>& normal) {
  constexpr double tolerance = 1e-6;
  if (surface.shape != ContactShape::round || surface.edged || !(plain(surface.radius) > 0)) return true;
  const Vector3<double> radius = plain(place - surface.center) / plain(surface.radius), n = plain(normal);
  const Vector3<double> axis = plain(surface.axis);
  if (norm(axis) == 0) return norm(cross(radius, n)) <= tolerance;
  return std::abs(dot(cross(axis, radius), n)) <= tolerance;
}

template bool normal_fits(const RollingSurface<double>&, const Vector3<double>&, const Vector3<double>&);
template bool normal_fits(const RollingSurface<Dual<1>>&, const Vector3<Dual<1>>&, const Vector3<Dual<1>>&);
template bool normal_fits(const RollingSurface<Formula>&, const Vector3<Formula>&, const Vector3<Formula>&);
template RollingSurface<double> rolling_surface(const Body&, DataScope<double>&, const Vector3<double>&,
                                                const Vector3<double>&);
template RollingSurface<Dual<1>> rolling_surface(const Body&, DataScope<Dual<1>>&, const Vector3<Dual<1>>&,
                                                 const Vector3<Dual<1>>&);
template RollingSurface<Formula> rolling_surface(const Body&, DataScope<Formula>&, const Vector3<Formula>&,
                                                 const Vector3<Formula>&);

}  // namespace poinsot::statement
