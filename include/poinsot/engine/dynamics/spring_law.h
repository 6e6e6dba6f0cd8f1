// A spring with a damper between two points: it pulls them together along the line that joins them,
//
//   F = k (l - l_0) + c dl/dt,      V = k (l - l_0)^2 / 2,      unstored power = -c (dl/dt)^2,
//
// l the distance of the points, l_0 the free length.
#pragma once

#include "poinsot/engine/dynamics/force_law.h"
#include "poinsot/engine/dynamics/place.h"
#include "poinsot/engine/math/algebra/plain.h"

namespace poinsot {

template <class Scalar>
struct SpringLaw {
  int action = 0;
  Place<Scalar> at, toward;  // at on `on`, toward on `from`
  Scalar stiffness{}, free_length{}, damping{};

  PlacedForce<Scalar> exerted(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    const Vector3<Scalar> none = Vector3<Scalar>::zero();
    const Vector3<Scalar> P = point_position(tree, w, at.body, at.point);
    const Vector3<Scalar> span = point_position(tree, w, toward.body, toward.point) - P;
    if (pulls_as_its_span()) return {P, stiffness * span, none};
    const Scalar length = norm(span);
    const Vector3<Scalar> u = span / length;
    return {P, (stiffness * (length - free_length) + damping * lengthening(tree, w, u)) * u, none};
  }
  Scalar stored_energy(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    const Vector3<Scalar> span = span_of(tree, w);
    if (pulls_as_its_span()) return Scalar(0.5) * stiffness * norm_squared(span);
    const Scalar stretch = norm(span) - free_length;
    return Scalar(0.5) * stiffness * stretch * stretch;
  }
  Scalar unstored_power(const Model<Scalar>& tree, const Workspace<Scalar>& w, int, int) const {
    if (pulls_as_its_span()) return Scalar(0);
    const Vector3<Scalar> span = span_of(tree, w);
    const Scalar rate = lengthening(tree, w, span / norm(span));
    return -damping * rate * rate;
  }
  bool feeds() const { return false; }
  bool drains() const { return !vanishes(damping); }
  bool stores() const { return true; }

  template <class Target, class Convert>
  SpringLaw<Target> converted(const Convert& to) const {
    return {action, to(at), to(toward), to(stiffness), to(free_length), to(damping)};
  }

 private:
  Vector3<Scalar> span_of(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    return point_position(tree, w, toward.body, toward.point) - point_position(tree, w, at.body, at.point);
  }
  // dl/dt, m/s; u: the direction from `at` to `toward`.
  Scalar lengthening(const Model<Scalar>& tree, const Workspace<Scalar>& w, const Vector3<Scalar>& u) const {
    return dot(u, point_velocity(tree, w, toward.body, toward.point) - point_velocity(tree, w, at.body, at.point));
  }
  // Without free length and damper the pull is k times the span itself, also where the ends meet and the span has no
  // direction.
  bool pulls_as_its_span() const {
    if constexpr (requires(const Scalar& x) { plain(x); }) return vanishes(free_length) && vanishes(damping);
    return false;
  }
};

}  // namespace poinsot
