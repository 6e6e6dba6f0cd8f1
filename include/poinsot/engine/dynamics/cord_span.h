// A straight part of a cord that is led over wheels.
//
// A wheel has its center C and radius r in a plane across its axis e. With u the unit vector along the cord from the
// wheel or point a that it leaves to the wheel or point b that it comes to, and n = e x u, the cord touches at
//
//   P_a = C_a + s_a r_a n,   P_b = C_b + s_b r_b n,
//
// where s = 1 or -1 is the side of the wheel. A point is a wheel of no size. From P_b - P_a = L u with D = C_b - C_a
// and h = s_a r_a - s_b r_b = D . n follows
//
//   L = sqrt(D^2 - h^2),   u = (L D - h e x D) / D^2.
//
// A cord that does not slip on the wheels moves with their material points there, so that its straight part grows by
// u . (v_b(P_b) - v_a(P_a)) = 0. On a wheel between two straight parts it turns from the one to the other by an angle
// about e, of which the wheel takes up -s r times the length.
//
// If the plane of the cord tilts by a little, the part of D along e lengthens it as if it left the wheel where it
// touches it now, which is right to the second order.
#pragma once

#include <cmath>

#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/dynamics/place.h"
#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/plain.h"

namespace poinsot {

// What a cord touches: a wheel of a body, or a point of it.
template <class Scalar>
struct CordEnd {
  Place<Scalar> center;
  Scalar reach{};  // s r, m; zero for a point

  int body() const { return center.body; }
};

template <class Scalar>
struct CordSpan {
  CordEnd<Scalar> from, to;
  Direction<Scalar> axis;  // e; zero if both ends are points
  // If the part before this one comes to the wheel that this one leaves: cosine and sine of the turn there as drawn.
  Scalar turn_cosine{1}, turn_sine{};

  template <class Target, class Convert>
  CordSpan<Target> converted(const Convert& to_target) const {
    const auto end = [&](const CordEnd<Scalar>& one) {
      return CordEnd<Target>{to_target(one.center), to_target(one.reach)};
    };
    return {end(from), end(to), to_target(axis), to_target(turn_cosine), to_target(turn_sine)};
  }
};

template <class Scalar>
struct SpanLine {
  Vector3<Scalar> start, end, along;  // P_a, P_b and u, on ground axes
  Scalar length{};
};

// centers, axis: on ground axes.
template <class Scalar>
SpanLine<Scalar> line_between(const Vector3<Scalar>& C_a, const Vector3<Scalar>& C_b, const Vector3<Scalar>& e,
                              const Scalar& reach_a, const Scalar& reach_b) {
  using std::sqrt;
  const Vector3<Scalar> D = C_b - C_a;
  if (vanishes(reach_a) && vanishes(reach_b)) {
    const Scalar length = norm(D);
    return {C_a, C_b, D / length, length};
  }
  const Scalar h = reach_a - reach_b, tilt = dot(D, e);
  const Vector3<Scalar> in_plane = vanishes(tilt) ? D : Vector3<Scalar>(D - tilt * e);
  const Scalar square = norm_squared(in_plane);
  Scalar length = sqrt(square - h * h);
  Vector3<Scalar> u = (length * in_plane - h * cross(e, in_plane)) / square;
  const Vector3<Scalar> n = cross(e, u);
  if (!vanishes(tilt)) {
    const Vector3<Scalar> whole = length * u + tilt * e;
    length = norm(whole);
    u = whole / length;
  }
  return {C_a + reach_a * n, C_b + reach_b * n, u, length};
}

// After update_poses.
template <class Scalar>
SpanLine<Scalar> line_of(const Model<Scalar>& tree, const Workspace<Scalar>& w, const CordSpan<Scalar>& span) {
  const auto center = [&](const CordEnd<Scalar>& end) {
    return point_position(tree, w, end.center.body, end.center.point);
  };
  return line_between<Scalar>(center(span.from), center(span.to),
                              direction_on_ground(tree, w, span.axis.body, span.axis.vector), span.from.reach,
                              span.to.reach);
}

// The force of size one at its end, along the cord: reversed, what a tension of one exerts on the body there. After
// update_poses.
template <class Scalar>
PlacedForce<Scalar> span_force(const Model<Scalar>& tree, const Workspace<Scalar>& w, const CordSpan<Scalar>& span) {
  const SpanLine<Scalar> line = line_of(tree, w, span);
  return {line.end, line.along, Vector3<Scalar>::zero()};
}

// By how much more of the cord lies on the wheel at the beginning of a straight part than as drawn, m, if the part
// before it goes along `before`: within half a turn of it.
template <class Scalar>
Scalar taken_up(const Model<Scalar>& tree, const Workspace<Scalar>& w, const CordSpan<Scalar>& span,
                const Vector3<Scalar>& before, const Vector3<Scalar>& along) {
  using std::atan2;
  if (vanishes(span.from.reach)) return Scalar(0);
  const Vector3<Scalar> e = direction_on_ground(tree, w, span.axis.body, span.axis.vector);
  const Scalar cosine = dot(before, along), sine = dot(e, cross(before, along));
  const Scalar more = sine * span.turn_cosine - cosine * span.turn_sine,
               alike = cosine * span.turn_cosine + sine * span.turn_sine;
  if (vanishes(more) && plain(alike) > 0) return Scalar(0);
  return -span.from.reach * atan2(more, alike);
}

// The same line as its ends move. After update_velocities.
template <class Scalar>
struct MovingSpanLine {
  SpanLine<Scalar> line;
  Vector3<Scalar> start_rate, end_rate, along_rate;
};
template <class Scalar>
MovingSpanLine<Scalar> moving_line(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                   const CordSpan<Scalar>& span) {
  using Moving = Dual<1, Scalar>;
  const auto moving = [](const Vector3<Scalar>& value, const Vector3<Scalar>& rate) {
    return Vector3<Moving>{{value.x, {rate.x}}, {value.y, {rate.y}}, {value.z, {rate.z}}};
  };
  const auto center = [&](const CordEnd<Scalar>& end) {
    return moving(point_position(tree, w, end.center.body, end.center.point),
                  point_velocity(tree, w, end.center.body, end.center.point));
  };
  const Vector3<Scalar> e = direction_on_ground(tree, w, span.axis.body, span.axis.vector);
  const SpanLine<Moving> line =
      line_between<Moving>(center(span.from), center(span.to), moving(e, cross(angular_velocity(w, span.axis.body), e)),
                           Moving(span.from.reach), Moving(span.to.reach));
  const auto value = [](const Vector3<Moving>& a) { return Vector3<Scalar>{a.x.value, a.y.value, a.z.value}; };
  const auto rate = [](const Vector3<Moving>& a) {
    return Vector3<Scalar>{a.x.partial[0], a.y.partial[0], a.z.partial[0]};
  };
  return {{value(line.start), value(line.end), value(line.along), line.length.value},
          rate(line.start),
          rate(line.end),
          rate(line.along)};
}

}  // namespace poinsot
