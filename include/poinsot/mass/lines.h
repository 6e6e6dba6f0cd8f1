// Particles, rods and wires: closed forms of length, centroid and inertia per unit mass.
//
// Points are given from the origin (m); directions need not be unit vectors. Nothing is checked here: see
// poinsot/mass/shape_faults.h, whose functions take the same arguments.
#pragma once

#include <cmath>
#include <vector>

#include "poinsot/mass/inertia_tensors.h"
#include "poinsot/mass/pi.h"
#include "poinsot/mass/shape_properties.h"

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

// Arc or sector of half-angle a = angle/2 about the unit vector `middle`, seen from its circle's center, where the mean
// of r^2 is `mean_square` and the centroid's distance `distance`:
//   I_normal = <r^2>,  I_middle = <r^2>/2 (1 - sin(angle)/angle),  I_tangent = <r^2>/2 (1 + sin(angle)/angle).
// The moments about the centroid lose digits as 1/angle^2 for small angles.
template <class Scalar>
ShapeProperties<Scalar> circular_part(const Scalar& measure, const Vector3<Scalar>& center,
                                      const Vector3<Scalar>& normal, const Vector3<Scalar>& middle, const Scalar& angle,
                                      const Scalar& distance, const Scalar& mean_square) {
  using std::sin;
  const Scalar half = Scalar(0.5) * mean_square;
  const Scalar ripple = half * sin(angle) / angle;
  const Vector3<Scalar> offset = distance * middle;
  const auto axes = Matrix3<Scalar>::from_columns(normal, middle, cross(normal, middle));
  return {
      measure, center + offset,
      principal_tensor(axes, Vector3<Scalar>{mean_square, half - ripple, half + ripple}) - unit_mass_inertia(offset)};
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
  return detail::circular_part(radius * angle, center, n, middle, angle, radius * sin(half_angle) / half_angle,
                               radius * radius);
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
