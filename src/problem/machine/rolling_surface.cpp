#include "problem/machine/rolling_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/shape_arguments.h"

namespace poinsot::problem {
namespace {

// A part of a circle that extends by the half angle to both sides of its middle.
template <class Scalar>
struct ArcOf {
  Vector3<Scalar> center, axis;
  Scalar radius;
  Vector3<Scalar> middle;
  double half_angle = 0;
};

// The arc of an arc, a semicircle or a sector.
template <class Scalar>
ArcOf<Scalar> arc_of(const ShapeArguments<Scalar>& a) {
  using std::cos, std::sin;
  using Vector = Vector3<Scalar>;
  if (a.has("diameter")) {
    const auto ends = a.places("diameter", 2);
    const Vector center = Scalar(0.5) * (ends[0] + ends[1]), across = normalized(ends[1] - ends[0]);
    const Vector side = a.toward("toward", center), middle = normalized(side - dot(side, across) * across);
    return {center, cross(across, middle), Scalar(0.5) * norm(ends[1] - ends[0]), middle, 0.5 * 3.14159265358979323846};
  }
  const Vector center = a.place("center"), axis = a.direction("normal");
  const Scalar half = Scalar(0.5) * a.angle("angle");
  if (!a.has("start")) return {center, axis, a.length("radius"), a.toward("middle", center), plain(half)};
  const Vector start = a.place("start") - center;
  const Vector middle = normalized(cos(half) * start + sin(half) * cross(axis, start));
  return {center, axis, norm(start), middle, std::abs(plain(half))};
}

}  // namespace

template <class Scalar>
RollingSurface<Scalar> rolling_surface(const Body& body, DataScope<Scalar>& data, const Vector3<Scalar>& p_OC,
                                       const Vector3<Scalar>& n, const Vector3<Scalar>& center_of_mass) {
  using Vector = Vector3<Scalar>;
  constexpr double on_surface = 1e-6;  // part of the radius up to which a point counts as on the surface
  const std::string& file = data.situation().file;
  RollingSurface<Scalar> nearest_surface;
  double nearest_gap = std::numeric_limits<double>::infinity();
  bool other_shapes = false;
  // Offers a circle about an axis (for a zero axis a sphere) at the distance `gap` from the point. The nearest
  // surface is kept.
  const auto offer = [&](const Vector& center, const Vector& axis, const Scalar& radius, double gap) {
    if (gap / plain(radius) >= nearest_gap) return;
    nearest_gap = gap / plain(radius);
    nearest_surface = {ContactShape::round, center, axis, radius, gap, {}, -1};
  };
  // Offers an arc. At its ends the contact is a corner, unless the normal there is along the radius.
  const auto offer_arc = [&](const Vector& center, const Vector& axis, const Scalar& radius, const Vector& middle,
                             double half_angle) {
    constexpr double pi = 3.14159265358979323846;
    const Vector r = p_OC - center;
    const double along = plain(dot(r, axis));
    const double gap = std::hypot(norm(plain(r - dot(r, axis) * axis)) - plain(radius), along);
    if (half_angle >= pi) return offer(center, axis, radius, gap);
    const double angle = std::atan2(norm(cross(plain(middle), plain(r))), dot(plain(middle), plain(r)));
    if (angle > half_angle + on_surface) return;
    const double slant = std::abs(dot(cross(plain(axis), plain(r)), plain(n))) / plain(radius);
    if (angle > half_angle - on_surface && slant > on_surface) return;
    if (gap / plain(radius) >= nearest_gap) return;
    offer(center, axis, radius, gap);
    nearest_surface.middle = middle;
    nearest_surface.cosine = std::cos(half_angle);
  };
  for (const Part& part : body.parts) {
    const std::string& kind = part.shape.kind;
    const auto place = [&](const char* name) { return data.place(shape_argument(part.shape, name, file)); };
    const auto direction = [&](const char* name) { return data.direction(shape_argument(part.shape, name, file)); };
    const auto length = [&](const char* name) {
      return data.number(shape_argument(part.shape, name, file), dimensions::length);
    };
    // Offers the circle through the point on a frustum from A (radius r_A) to B (radius r_B).
    const auto frustum = [&](const Vector& A, const Scalar& r_A, const Vector& B, const Scalar& r_B) {
      const Vector axis = normalized(B - A);
      const Scalar height = norm(B - A), along = dot(p_OC - A, axis);
      const Scalar inside = plain(along) < 0 ? Scalar(0) : plain(along) > plain(height) ? height : along;
      const Scalar radius = r_A + (r_B - r_A) * inside / height;
      const double rho = norm(plain(p_OC - (A + along * axis)));
      offer(A + inside * axis, axis, plain(radius) > 1e-300 ? radius : Scalar(1e-300),
            std::hypot(rho - plain(radius), plain(along - inside)));
    };
    if (kind == "sphere" || kind == "sphere_shell") {
      const Vector center = place("center");
      const Scalar radius = length("radius");
      offer(center, Vector::zero(), radius, std::abs(norm(plain(p_OC - center)) - plain(radius)));
    } else if (kind == "hemisphere" || kind == "hemisphere_shell") {
      const ShapeArguments<Scalar> arguments(part.shape, data, part.name, false);
      const Vector center = place("center"), toward = arguments.toward("toward", center);
      const Scalar radius = length("radius");
      const Vector3<double> r = plain(p_OC - center) / plain(radius);
      const double height = dot(r, plain(toward));
      // On the rim of a half sphere the circle touches, unless the normal is that of the sphere. Behind the rim there
      // is no surface.
      if (std::abs(height) <= on_surface && norm(cross(r, plain(n))) > on_surface) {
        offer(center, toward, radius, std::abs(norm(r) - 1) * plain(radius));
      } else if (std::max(std::abs(norm(r) - 1), -height) < nearest_gap) {
        offer(center, Vector::zero(), radius, std::max(std::abs(norm(r) - 1), -height) * plain(radius));
        nearest_surface.middle = toward;
        nearest_surface.cosine = 0;
      }
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
    } else if (kind == "arc" || kind == "semicircle" || kind == "sector") {
      other_shapes = true;
      const ArcOf<Scalar> arc = arc_of(ShapeArguments<Scalar>(part.shape, data, part.name, false));
      offer_arc(arc.center, arc.axis, arc.radius, arc.middle, arc.half_angle);
    } else {
      other_shapes = true;
    }
  }
  if (nearest_gap <= on_surface) return nearest_surface;
  if (body.parts.empty()) {
    if (body.inertia && body.inertia->axis) {
      const Vector axis = data.direction(*body.inertia->axis);
      const Vector foot = center_of_mass + dot(p_OC - center_of_mass, axis) * axis;
      // If the point is on the axis, up to rounding, the circle is a point, and its radius has no derivative.
      const Vector r = p_OC - foot;
      const bool beside = norm(plain(r)) > 1e-12 * (norm(plain(p_OC)) + norm(plain(center_of_mass)));
      return {ContactShape::round, foot, axis, beside ? norm(r) : Scalar(0), 0, {}, -1};
    }
    return {ContactShape::unknown, {}, {}, Scalar(0), 0, {}, -1};
  }
  if (!other_shapes) return {ContactShape::missed, {}, {}, nearest_surface.radius, nearest_surface.gap, {}, -1};
  const bool curved = std::any_of(body.parts.begin(), body.parts.end(), [](const Part& part) {
    return part.shape.kind == "torus" || part.shape.kind == "ellipsoid" || part.shape.kind == "mesh";
  });
  return {curved ? ContactShape::unknown : ContactShape::corner, {}, {}, Scalar(0), 0, {}, -1};
}

template <class Scalar>
bool normal_fits(const RollingSurface<Scalar>& surface, const Vector3<Scalar>& place, const Vector3<Scalar>& normal) {
  constexpr double tolerance = 1e-6;
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
