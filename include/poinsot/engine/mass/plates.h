// Thin plates: closed forms of area, centroid and inertia per unit mass.
//
// Points are given from the origin (m); directions need not be unit vectors. Nothing is checked here: see
// poinsot/engine/mass/shape_faults.h, whose functions take the same arguments.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "poinsot/engine/mass/lines.h"

namespace poinsot::shapes {

// Rectangle with the edge vectors a and b (any parallelogram): I_x = b^2/12 and so on.
template <class Scalar>
ShapeProperties<Scalar> rectangle(const Vector3<Scalar>& center, const Vector3<Scalar>& edge_a,
                                  const Vector3<Scalar>& edge_b) {
  return {norm(cross(edge_a, edge_b)), center,
          (Scalar(1) / Scalar(12)) * (unit_mass_inertia(edge_a) + unit_mass_inertia(edge_b))};
}

// Rectangle by three corners in order round it; B is the corner between A and C.
template <class Scalar>
ShapeProperties<Scalar> rectangle_from_corners(const Vector3<Scalar>& A, const Vector3<Scalar>& B,
                                               const Vector3<Scalar>& C) {
  return rectangle(Scalar(0.5) * (A + C), A - B, C - B);
}

// A twelfth of the mass at each corner has the triangle's moments about the centroid.
template <class Scalar>
ShapeProperties<Scalar> triangle(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Vector3<Scalar>& C) {
  const Vector3<Scalar> center = (A + B + C) / Scalar(3);
  return {Scalar(0.5) * norm(cross(B - A, C - A)), center,
          (Scalar(1) / Scalar(12)) *
              (unit_mass_inertia(A - center) + unit_mass_inertia(B - center) + unit_mass_inertia(C - center))};
}

template <class Scalar>
Vector3<Scalar> mean_of(const std::vector<Vector3<Scalar>>& points) {
  Vector3<Scalar> sum = Vector3<Scalar>::zero();
  for (const auto& point : points) sum += point;
  return sum / Scalar(static_cast<double>(points.size()));
}

// The vector area of a polygon, whose direction is the normal of its plane.
template <class Scalar>
Vector3<Scalar> vector_area_of(const std::vector<Vector3<Scalar>>& vertices) {
  const Vector3<Scalar> reference = mean_of(vertices);
  Vector3<Scalar> area = Vector3<Scalar>::zero();
  for (std::size_t i = 0; i < vertices.size(); ++i)
    area += Scalar(0.5) * cross(vertices[i] - reference, vertices[(i + 1) % vertices.size()] - reference);
  return area;
}

// Any simple polygon, convex or not, by its vertices in order round it (either way): the sum of the signed triangles
// between its sides and the mean of its vertices.
template <class Scalar>
ShapeProperties<Scalar> polygon(const std::vector<Vector3<Scalar>>& vertices) {
  const Scalar half(0.5);
  const Vector3<Scalar> reference = mean_of(vertices);
  const Vector3<Scalar> vector_area = vector_area_of(vertices);
  const Scalar area = norm(vector_area);
  const Vector3<Scalar> normal = vector_area / area;

  // Each triangle by its share of the area; p and q are its sides from the reference point.
  Vector3<Scalar> offset = Vector3<Scalar>::zero();
  SymmetricMatrix3<Scalar> inertia = SymmetricMatrix3<Scalar>::zero();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vector3<Scalar> p = vertices[i] - reference;
    const Vector3<Scalar> q = vertices[(i + 1) % vertices.size()] - reference;
    const Scalar share = half * dot(cross(p, q), normal) / area;
    offset += (share / Scalar(3)) * (p + q);
    inertia += (share / Scalar(12)) * (unit_mass_inertia(p) + unit_mass_inertia(q) + unit_mass_inertia(p + q));
  }
  return {area, reference + offset, inertia - unit_mass_inertia(offset)};
}

// The same by coordinates (u, v) in a plane with the given origin; u along `axis_u`, v along the part of `axis_v`
// perpendicular to it.
template <class Scalar>
std::vector<Vector3<Scalar>> points_in_plane(const std::vector<std::array<Scalar, 2>>& coordinates,
                                             const Vector3<Scalar>& origin, const Vector3<Scalar>& axis_u,
                                             const Vector3<Scalar>& axis_v) {
  const Vector3<Scalar> u = normalized(axis_u);
  const Vector3<Scalar> v = normalized(perpendicular_part(axis_v, u));
  std::vector<Vector3<Scalar>> points;
  points.reserve(coordinates.size());
  for (const auto& c : coordinates) points.push_back(origin + c[0] * u + c[1] * v);
  return points;
}
template <class Scalar>
ShapeProperties<Scalar> polygon_in_plane(const std::vector<std::array<Scalar, 2>>& coordinates,
                                         const Vector3<Scalar>& origin, const Vector3<Scalar>& axis_u,
                                         const Vector3<Scalar>& axis_v) {
  return polygon(points_in_plane(coordinates, origin, axis_u, axis_v));
}

// Disk: I = r^2/2 about its axis, r^2/4 about its diameters.
template <class Scalar>
ShapeProperties<Scalar> disk(const Vector3<Scalar>& center, const Vector3<Scalar>& normal, const Scalar& radius) {
  const Scalar square = radius * radius;
  return {pi<Scalar>() * square, center,
          axisymmetric_tensor(normalized(normal), Scalar(0.5) * square, Scalar(0.25) * square)};
}

// Disk with a concentric hole: as the disk with R^2 + r^2 in place of r^2.
template <class Scalar>
ShapeProperties<Scalar> annulus(const Vector3<Scalar>& center, const Vector3<Scalar>& normal,
                                const Scalar& outer_radius, const Scalar& inner_radius) {
  const Scalar squares = outer_radius * outer_radius + inner_radius * inner_radius;
  return {pi<Scalar>() * (outer_radius - inner_radius) * (outer_radius + inner_radius), center,
          axisymmetric_tensor(normalized(normal), Scalar(0.5) * squares, Scalar(0.25) * squares)};
}

// Half disk on the diameter AB, bulging toward the direction `toward` (its part perpendicular to AB). Centroid at
// 4 r/(3 pi) from the middle of AB.
template <class Scalar>
ShapeProperties<Scalar> semicircle(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Vector3<Scalar>& toward) {
  const Scalar radius = Scalar(0.5) * norm(B - A);
  const Vector3<Scalar> along = normalized(B - A);
  const Vector3<Scalar> middle = normalized(perpendicular_part(toward, along));
  const Vector3<Scalar> offset = (Scalar(4) * radius / (Scalar(3) * pi<Scalar>())) * middle;
  const Scalar square = radius * radius;
  return {Scalar(0.5) * pi<Scalar>() * square, Scalar(0.5) * (A + B) + offset,
          axisymmetric_tensor(cross(along, middle), Scalar(0.5) * square, Scalar(0.25) * square) -
              unit_mass_inertia(offset)};
}

// Sector of a disk, `angle` (rad) wide, symmetric about `middle_direction` (its part in the plane). Centroid at
// 2/3 r sin(angle/2)/(angle/2).
template <class Scalar>
ShapeProperties<Scalar> sector(const Vector3<Scalar>& center, const Vector3<Scalar>& normal, const Scalar& radius,
                               const Vector3<Scalar>& middle_direction, const Scalar& angle) {
  using std::sin;
  const Vector3<Scalar> n = normalized(normal);
  const Vector3<Scalar> middle = normalized(perpendicular_part(middle_direction, n));
  const Scalar square = radius * radius;
  const Scalar distance = Scalar(4) * radius * sin(Scalar(0.5) * angle) / (Scalar(3) * angle);
  const Scalar across = Scalar(0.25) * square * detail::one_less_sinc(angle);
  return detail::circular_part(Scalar(0.5) * square * angle, center, n, middle, distance,
                               Scalar(0.5) * square - across - distance * distance, across);
}

// The part of a sector between two radii R > r. With s = R + r and d = R - r distances from the center have the mean
// (3 s^2 + d^2)/(6 s) and the variance d^2 (3 s^2 - d^2)/(36 s^2), so that nothing cancels in a narrow one; places on
// the arc do not depend on them.
template <class Scalar>
ShapeProperties<Scalar> annular_sector(const Vector3<Scalar>& center, const Vector3<Scalar>& normal,
                                       const Scalar& outer_radius, const Scalar& inner_radius,
                                       const Vector3<Scalar>& middle_direction, const Scalar& angle) {
  using std::sin;
  const Vector3<Scalar> n = normalized(normal);
  const Vector3<Scalar> middle = normalized(perpendicular_part(middle_direction, n));
  const Scalar sum = outer_radius + inner_radius, difference = outer_radius - inner_radius;
  const Scalar sums = sum * sum, differences = difference * difference;
  const Scalar mean = (Scalar(3) * sums + differences) / (Scalar(6) * sum);
  const Scalar variance = differences * (Scalar(3) * sums - differences) / (Scalar(36) * sums);
  const Scalar half = Scalar(0.5) * detail::one_less_sinc(angle);  // the mean square of the sine along the arc
  return detail::circular_part(Scalar(0.5) * sum * difference * angle, center, n, middle,
                               mean * sin(Scalar(0.5) * angle) / (Scalar(0.5) * angle),
                               variance * (Scalar(1) - half) + mean * mean * detail::arc_depth(angle),
                               Scalar(0.25) * (sums + differences) * half);
}

}  // namespace poinsot::shapes
