// The round surfaces that shapes have, on which a body can roll: each says where and how a contact touches it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "poinsot/engine/dynamics/contact_surface.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "problem/machine/body_surfaces.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

// Of the radius: what lies closer than this to a surface is on it, since places are given with the six digits of a
// figure.
constexpr double on_round_surface = 1e-6;

template <class Scalar>
RollingSurface<Scalar> round_contact(const Vector3<Scalar>& center, const Vector3<Scalar>& axis, const Scalar& radius,
                                     double gap) {
  return {ContactShape::round, center, axis, radius, gap, {}, -1};
}

template <class Scalar>
struct SphereSurface {
  Vector3<Scalar> center;
  Scalar radius;

  std::optional<RollingSurface<Scalar>> touched_at(const Vector3<Scalar>& p_OC, const Vector3<Scalar>&) const {
    return round_contact(center, Vector3<Scalar>::zero(), radius, std::abs(norm(plain(p_OC - center)) - plain(radius)));
  }
};

// Half a sphere on the side of its unit vector `toward`, open or closed by a disk.
template <class Scalar>
struct HemisphereSurface {
  Vector3<Scalar> center, toward;
  Scalar radius;

  // On the rim the circle touches, unless the normal is that of the sphere; behind it there is nothing.
  std::optional<RollingSurface<Scalar>> touched_at(const Vector3<Scalar>& p_OC, const Vector3<Scalar>& n) const {
    const Vector3<double> r = plain(p_OC - center) / plain(radius);
    const double height = dot(r, plain(toward)), off_sphere = std::abs(norm(r) - 1);
    if (std::abs(height) <= on_round_surface && norm(cross(r, plain(n))) > on_round_surface)
      return round_contact(center, toward, radius, off_sphere * plain(radius));
    auto contact =
        round_contact(center, Vector3<Scalar>::zero(), radius, std::max(off_sphere, -height) * plain(radius));
    contact.middle = toward;
    contact.cosine = 0;
    return contact;
  }
};

template <class Scalar>
struct CircleSurface {
  Vector3<Scalar> center, axis;
  Scalar radius;

  std::optional<RollingSurface<Scalar>> touched_at(const Vector3<Scalar>& p_OC, const Vector3<Scalar>&) const {
    const Scalar along = dot(p_OC - center, axis);
    return round_contact(center, axis, radius,
                         std::hypot(norm(plain(p_OC - center - along * axis)) - plain(radius), plain(along)));
  }
};

// From A (radius r_A) to B (radius r_B), about the line that joins them: a cylinder, a cone or a frustum. What touches
// is the circle about its axis through the point.
template <class Scalar>
struct FrustumSurface {
  Vector3<Scalar> A;
  Scalar r_A;
  Vector3<Scalar> B;
  Scalar r_B;

  std::optional<RollingSurface<Scalar>> touched_at(const Vector3<Scalar>& p_OC, const Vector3<Scalar>&) const {
    const Vector3<Scalar> axis = normalized(B - A);
    const Scalar height = norm(B - A), along = dot(p_OC - A, axis);
    const Scalar inside = plain(along) < 0 ? Scalar(0) : plain(along) > plain(height) ? height : along;
    const Scalar radius = r_A + (r_B - r_A) * inside / height;
    const double rho = norm(plain(p_OC - (A + along * axis)));
    // At the tip of a cone the circle is a point.
    constexpr double least_radius = 1e-300;
    return round_contact(A + inside * axis, axis, plain(radius) > least_radius ? radius : Scalar(least_radius),
                         std::hypot(rho - plain(radius), plain(along - inside)));
  }
};

// The round half of a cylinder between A and B, on the side of its unit vector `toward`.
template <class Scalar>
struct HalfCylinderSurface {
  FrustumSurface<Scalar> whole;
  Vector3<Scalar> toward;

  // At its straight edges it is a corner, unless the normal goes along the radius there.
  std::optional<RollingSurface<Scalar>> touched_at(const Vector3<Scalar>& p_OC, const Vector3<Scalar>& n) const {
    auto contact = whole.touched_at(p_OC, n);
    const Vector3<double> r = plain(p_OC - contact->center) / plain(contact->radius);
    const double height = dot(r, plain(toward));
    if (height < -on_round_surface) return std::nullopt;
    if (height < on_round_surface && norm(cross(r, plain(n))) > on_round_surface) return std::nullopt;
    contact->middle = toward;
    contact->cosine = 0;
    return contact;
  }
};

// The part of a circle within the half angle on both sides of its middle.
template <class Scalar>
struct ArcSurface {
  Vector3<Scalar> center, axis;
  Scalar radius;
  Vector3<Scalar> middle;
  double half_angle = 0;

  // At its ends it is a corner, unless the normal goes along the radius there.
  std::optional<RollingSurface<Scalar>> touched_at(const Vector3<Scalar>& p_OC, const Vector3<Scalar>& n) const {
    const Vector3<Scalar> r = p_OC - center;
    const double along = plain(dot(r, axis));
    const double gap = std::hypot(norm(plain(r - dot(r, axis) * axis)) - plain(radius), along);
    auto contact = round_contact(center, axis, radius, gap);
    if (half_angle >= std::numbers::pi) return contact;
    const double angle = std::atan2(norm(cross(plain(middle), plain(r))), dot(plain(middle), plain(r)));
    if (angle > half_angle + on_round_surface) return std::nullopt;
    const double slant = std::abs(dot(cross(plain(axis), plain(r)), plain(n))) / plain(radius);
    if (angle > half_angle - on_round_surface && slant > on_round_surface) return std::nullopt;
    contact.middle = middle;
    contact.cosine = std::cos(half_angle);
    return contact;
  }
};

// Surfaces on which no circle or sphere of the body rolls: they touch as touching_surfaces.h has it.
template <class Scalar>
struct EllipsoidSurface {
  Vector3<Scalar> center;
  std::array<Vector3<Scalar>, 3> semi_axes;

  std::optional<RollingSurface<Scalar>> touched_at(const Vector3<Scalar>&, const Vector3<Scalar>&) const {
    return std::nullopt;
  }
};
template <class Scalar>
struct TorusSurface {
  Vector3<Scalar> center, axis;
  Scalar radius, tube;

  std::optional<RollingSurface<Scalar>> touched_at(const Vector3<Scalar>&, const Vector3<Scalar>&) const {
    return std::nullopt;
  }
};

template <class Scalar>
using RoundSurface =
    std::variant<SphereSurface<Scalar>, HemisphereSurface<Scalar>, CircleSurface<Scalar>, FrustumSurface<Scalar>,
                 ArcSurface<Scalar>, HalfCylinderSurface<Scalar>, EllipsoidSurface<Scalar>, TorusSurface<Scalar>>;

// The surfaces and edges of each kind for contacts of curved surfaces.
//
// A surface of a body that may be the one at a place of contact (touching_surfaces.h), on the axes of the drawing.
template <class Scalar>
struct Candidate {
  ContactSurface<Scalar> surface;
  double size = 1;  // m
  std::optional<ContactLimit::End> end{};
};

template <class Scalar>
ContactSurface<Scalar> plane_at(const Vector3<Scalar>& point, const Vector3<Scalar>& out) {
  ContactSurface<Scalar> s;
  s.center = point;
  s.axis = out;
  return s;
}
template <class Scalar>
ContactSurface<Scalar> sphere_at(const Vector3<Scalar>& center, const Scalar& radius) {
  ContactSurface<Scalar> s;
  s.kind = SurfaceKind::sphere;
  s.center = center;
  s.radius = radius;
  return s;
}
template <class Scalar>
ContactSurface<Scalar> cylinder_about(const Vector3<Scalar>& point, const Vector3<Scalar>& axis, const Scalar& radius) {
  ContactSurface<Scalar> s = sphere_at(point, radius);
  s.kind = SurfaceKind::cylinder;
  s.axis = axis;
  return s;
}
template <class Scalar>
ContactSurface<Scalar> torus_about(const Vector3<Scalar>& center, const Vector3<Scalar>& axis, const Scalar& radius,
                                   const Scalar& tube) {
  ContactSurface<Scalar> s = cylinder_about(center, axis, radius);
  s.kind = SurfaceKind::torus;
  s.tube = tube;
  return s;
}

template <class Scalar>
std::vector<Candidate<Scalar>> candidates(const SphereSurface<Scalar>& s) {
  return {{sphere_at(s.center, s.radius), plain(s.radius)}};
}
template <class Scalar>
std::vector<Candidate<Scalar>> candidates(const HemisphereSurface<Scalar>& s) {
  // It ends at its rim alone: the farthest place from that is no end, and rounding must not make one of it.
  const double r = plain(s.radius);
  return {{sphere_at(s.center, s.radius), r, ContactLimit::End{plain(s.center), plain(s.toward), 2 * r}},
          {torus_about(s.center, s.toward, s.radius, Scalar(0)), r}};
}
template <class Scalar>
std::vector<Candidate<Scalar>> candidates(const CircleSurface<Scalar>& s) {
  return {{torus_about(s.center, s.axis, s.radius, Scalar(0)), plain(s.radius)}};
}
template <class Scalar>
std::vector<Candidate<Scalar>> candidates(const FrustumSurface<Scalar>& s) {
  using std::sqrt;
  const Scalar height = norm(s.B - s.A), widens = s.r_B - s.r_A;
  const Vector3<Scalar> axis = (s.B - s.A) / height;
  const double size = std::max(plain(s.r_A), plain(s.r_B));
  Candidate<Scalar> side{cylinder_about(s.A, axis, s.r_A), size,
                         ContactLimit::End{plain(s.A), plain(axis), plain(height)}};
  if (!vanishes(widens)) {
    // From the apex into the cone.
    side.surface.kind = SurfaceKind::cone;
    side.surface.center = s.A - (s.r_A * height / widens) * axis;
    const Scalar slant = sqrt(height * height + widens * widens);
    const Scalar sign(plain(widens) > 0 ? 1 : -1);
    side.surface.axis = sign * axis;
    side.surface.sine = sign * widens / slant;
    side.surface.cosine = height / slant;
  }
  std::vector<Candidate<Scalar>> found{std::move(side)};
  for (const auto& [center, radius, out] :
       {std::tuple{s.A, s.r_A, Vector3<Scalar>(-axis)}, std::tuple{s.B, s.r_B, axis}})
    if (plain(radius) > 0) found.push_back({torus_about(center, out, radius, Scalar(0)), size});
  return found;
}
template <class Scalar>
std::vector<Candidate<Scalar>> candidates(const ArcSurface<Scalar>& s) {
  const double r = plain(s.radius), low = r * std::cos(s.half_angle);
  Candidate<Scalar> found{torus_about(s.center, s.axis, s.radius, Scalar(0)), r};
  // Its ends lie at one height, and its middle, the farthest from them, is none.
  if (s.half_angle < std::numbers::pi)
    found.end = ContactLimit::End{plain(s.center) + low * plain(s.middle), plain(s.middle), 2 * (r - low)};
  return {std::move(found)};
}
// Its ends are two kinds, of which a candidate has one: other bodies touch it as far as they are flat.
template <class Scalar>
std::vector<Candidate<Scalar>> candidates(const HalfCylinderSurface<Scalar>&) {
  return {};
}
template <class Scalar>
std::vector<Candidate<Scalar>> candidates(const EllipsoidSurface<Scalar>& s) {
  ContactSurface<Scalar> surface;
  surface.kind = SurfaceKind::ellipsoid;
  surface.center = s.center;
  surface.semi_axes = s.semi_axes;
  return {{std::move(surface),
           std::max({norm(plain(s.semi_axes[0])), norm(plain(s.semi_axes[1])), norm(plain(s.semi_axes[2]))})}};
}
template <class Scalar>
std::vector<Candidate<Scalar>> candidates(const TorusSurface<Scalar>& s) {
  return {{torus_about(s.center, s.axis, s.radius, s.tube), plain(s.radius)}};
}

}  // namespace poinsot::problem
