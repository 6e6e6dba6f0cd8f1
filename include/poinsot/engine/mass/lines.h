// Particles, rods and wires: closed forms of length, centroid and inertia per unit mass.
//
// Points are given from the origin (m); directions need not be unit vectors. Nothing is checked here: see
// poinsot/engine/mass/shape_faults.h, whose functions take the same arguments.
#pragma once

#include <cmath>
#include <concepts>
#include <vector>

#include "poinsot/engine/mass/inertia_tensors.h"
#include "poinsot/engine/mass/pi.h"
#include "poinsot/engine/mass/shape_properties.h"
#include "poinsot/engine/math/algebra/plain.h"

namespace poinsot::shapes {

template <class Scalar>
ShapeProperties<Scalar> particle(const Vector3<Scalar>& point) {
  return {Scalar(0), point, SymmetricMatrix3<Scalar>::zero()};
}

// Slender rod from A to B: I = l^2/12 about every axis through its middle and perpendicular to it.
template <class Scalar>
ShapeProperties<Scalar> rod(const Vector3<Scalar>& A, const Vector3<Scalar>& B) {
  return {norm(B - A), Scalar(0.5) * (A + B), (Scalar(1) / Scalar(12)) * unit_mass_inertia(B - A)};
}

// Bent wire through the points in order.
template <class Scalar>
ShapeProperties<Scalar> polyline(const std::vector<Vector3<Scalar>>& points) {
  std::vector<ShapeProperties<Scalar>> sides;
  for (std::size_t i = 1; i < points.size(); ++i) sides.push_back(rod(points[i - 1], points[i]));
  return united(sides);
}

namespace detail {

// Numbers, whose size says how a difference is best formed; formulas and packs keep the closed form.
template <class Scalar>
inline constexpr bool is_plain_number = std::floating_point<Scalar>;
template <int N, class Base>
inline constexpr bool is_plain_number<Dual<N, Base>> = is_plain_number<Base>;

// sum over k >= first of (-1)^k c_k t^2k with c_k = factor(k) / (2k + shift)!, for |t| up to some 2.
template <class Scalar, class Factor>
Scalar alternating_series(const Scalar& t, int first, int shift, Factor factor) {
  constexpr int terms = 16;
  Scalar sum(0);
  for (int k = first + terms; k >= first; --k) {
    Scalar coefficient((k % 2 == 0 ? 1 : -1) * factor(k));
    for (int i = 2; i <= 2 * k + shift; ++i) coefficient = coefficient / Scalar(i);
    sum = sum * (t * t) + coefficient;
  }
  for (int k = 0; k < first; ++k) sum = sum * (t * t);
  return sum;
}

// 1 - sin(t)/t, which loses digits as 1/t^2 where t is small.
template <class Scalar>
Scalar one_less_sinc(const Scalar& t) {
  using std::sin;
  if constexpr (is_plain_number<Scalar>) {
    if (std::fabs(plain(t)) < 2) return -alternating_series(t, 1, 1, [](int) { return 1; });
  }
  return Scalar(1) - sin(t) / t;
}

// (1 + sin(t)/t)/2 - (sin(t/2)/(t/2))^2 = t^4/720 - ..., the mean square distance of an arc's points from its centroid
// along its middle, over r^2.
template <class Scalar>
Scalar arc_depth(const Scalar& t) {
  using std::sin;
  if constexpr (is_plain_number<Scalar>) {
    if (std::fabs(plain(t)) < 2) return alternating_series(t, 2, 2, [](int k) { return k - 1; });
  }
  const Scalar half = Scalar(0.5) * t;
  const Scalar chord = sin(half) / half;
  return Scalar(0.5) * (Scalar(1) + sin(t) / t) - chord * chord;
}

// Arc or sector about the unit vector `middle`, seen from its circle's center: the centroid's distance from there, and
// the mean squares of the distances from the centroid along `middle` and across it in the plane.
template <class Scalar>
ShapeProperties<Scalar> circular_part(const Scalar& measure, const Vector3<Scalar>& center,
                                      const Vector3<Scalar>& normal, const Vector3<Scalar>& middle,
                                      const Scalar& distance, const Scalar& along, const Scalar& across) {
  const auto axes = Matrix3<Scalar>::from_columns(normal, middle, cross(normal, middle));
  return {measure, center + distance * middle, principal_tensor(axes, Vector3<Scalar>{along + across, across, along})};
}

}  // namespace detail

// Wire bent to an arc of a circle: from `start_direction` (its part in the plane) through `angle` (rad), right-handed
// about `normal`. Centroid at r sin(angle/2)/(angle/2).
template <class Scalar>
ShapeProperties<Scalar> arc(const Vector3<Scalar>& center, const Vector3<Scalar>& normal,
                            const Vector3<Scalar>& start_direction, const Scalar& radius, const Scalar& angle) {
  using std::cos;
  using std::sin;
  const Vector3<Scalar> n = normalized(normal);
  const Vector3<Scalar> start = normalized(perpendicular_part(start_direction, n));
  const Scalar half_angle = Scalar(0.5) * angle;
  const Vector3<Scalar> middle = cos(half_angle) * start + sin(half_angle) * cross(n, start);
  const Scalar square = radius * radius;
  return detail::circular_part(radius * angle, center, n, middle, radius * sin(half_angle) / half_angle,
                               square * detail::arc_depth(angle), Scalar(0.5) * square * detail::one_less_sinc(angle));
}

// The same arc by the point where it starts; the radius is the point's distance from the axis of the circle.
template <class Scalar>
ShapeProperties<Scalar> arc_from_point(const Vector3<Scalar>& center, const Vector3<Scalar>& normal,
                                       const Vector3<Scalar>& start_point, const Scalar& angle) {
  const Vector3<Scalar> start = perpendicular_part(start_point - center, normalized(normal));
  return arc(center, normal, start, norm(start), angle);
}

// Full circle of wire: I = r^2 about its axis, r^2/2 about its diameters.
template <class Scalar>
ShapeProperties<Scalar> ring(const Vector3<Scalar>& center, const Vector3<Scalar>& normal, const Scalar& radius) {
  const Scalar square = radius * radius;
  return {Scalar(2) * pi<Scalar>() * radius, center,
          axisymmetric_tensor(normalized(normal), square, Scalar(0.5) * square)};
}

// Half a circle of wire from A to B, bulging toward the direction `toward` (its part perpendicular to AB). Centroid at
// 2 r/pi from the middle of AB.
template <class Scalar>
ShapeProperties<Scalar> semicircular_arc(const Vector3<Scalar>& A, const Vector3<Scalar>& B,
                                         const Vector3<Scalar>& toward) {
  const Scalar radius = Scalar(0.5) * norm(B - A);
  const Vector3<Scalar> along = normalized(B - A);
  const Vector3<Scalar> middle = normalized(perpendicular_part(toward, along));
  const Vector3<Scalar> offset = (Scalar(2) * radius / pi<Scalar>()) * middle;
  const Scalar square = radius * radius;
  return {pi<Scalar>() * radius, Scalar(0.5) * (A + B) + offset,
          axisymmetric_tensor(cross(along, middle), square, Scalar(0.5) * square) - unit_mass_inertia(offset)};
}

}  // namespace poinsot::shapes
