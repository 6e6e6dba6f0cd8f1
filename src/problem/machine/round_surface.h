// The round surfaces that shapes have, on which a body can roll: each says where and how a contact touches it.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/machine/rolling_surface.h"

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

template <class Scalar>
using RoundSurface = std::variant<SphereSurface<Scalar>, HemisphereSurface<Scalar>, CircleSurface<Scalar>,
                                  FrustumSurface<Scalar>, ArcSurface<Scalar>>;

}  // namespace poinsot::problem
