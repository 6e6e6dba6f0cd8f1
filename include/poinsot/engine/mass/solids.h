// Solids: closed forms of volume, centroid and inertia per unit mass.
//
// Points are given from the origin (m); directions need not be unit vectors. Nothing is checked here: see
// poinsot/engine/mass/shape_faults.h, whose functions take the same arguments.
#pragma once

#include <vector>

#include "poinsot/engine/mass/plates.h"

namespace poinsot::shapes {

// Box with the edge vectors a, b, c (any parallelepiped): I_x = (b^2 + c^2)/12 and so on.
template <class Scalar>
ShapeProperties<Scalar> box(const Vector3<Scalar>& center, const Vector3<Scalar>& edge_a, const Vector3<Scalar>& edge_b,
                            const Vector3<Scalar>& edge_c) {
  return {
      magnitude(dot(edge_a, cross(edge_b, edge_c))), center,
      (Scalar(1) / Scalar(12)) * (unit_mass_inertia(edge_a) + unit_mass_inertia(edge_b) + unit_mass_inertia(edge_c))};
}

// The same by two opposite corners and its axes, the columns of `axes` (perpendicular unit vectors).
template <class Scalar>
ShapeProperties<Scalar> box_between(const Vector3<Scalar>& corner, const Vector3<Scalar>& opposite,
                                    const Matrix3<Scalar>& axes = Matrix3<Scalar>::identity()) {
  const Vector3<Scalar> size = transpose_times(axes, opposite - corner);
  return box(Scalar(0.5) * (corner + opposite), size.x * axes.column(0), size.y * axes.column(1),
             size.z * axes.column(2));
}

// Cube of edge a in any attitude: I = a^2/6 about every axis through its center.
template <class Scalar>
ShapeProperties<Scalar> cube(const Vector3<Scalar>& center, const Scalar& edge) {
  const Scalar square = edge * edge;
  return {square * edge, center, isotropic_tensor(square / Scalar(6))};
}

// Cube whose body diagonal runs from B to C. Its roll about the diagonal does not matter.
template <class Scalar>
ShapeProperties<Scalar> cube_from_diagonal(const Vector3<Scalar>& B, const Vector3<Scalar>& C) {
  using std::sqrt;
  return cube(Scalar(0.5) * (B + C), Scalar(norm(C - B) / sqrt(Scalar(3))));
}

// I = 2/5 r^2.
template <class Scalar>
ShapeProperties<Scalar> sphere(const Vector3<Scalar>& center, const Scalar& radius) {
  const Scalar square = radius * radius;
  return {Scalar(4) / Scalar(3) * pi<Scalar>() * square * radius, center,
          isotropic_tensor(Scalar(2) / Scalar(5) * square)};
}

// Half a ball on the circle about `center`, its pole on the side of `axis`. Centroid at 3/8 r: I = 2/5 r^2 about the
// axis, 83/320 r^2 across it.
template <class Scalar>
ShapeProperties<Scalar> hemisphere(const Vector3<Scalar>& center, const Vector3<Scalar>& axis, const Scalar& radius) {
  const Vector3<Scalar> pole = normalized(axis);
  const Scalar square = radius * radius;
  return {Scalar(2) / Scalar(3) * pi<Scalar>() * square * radius, center + (Scalar(3) / Scalar(8) * radius) * pole,
          axisymmetric_tensor(pole, Scalar(2) / Scalar(5) * square, Scalar(83) / Scalar(320) * square)};
}

// Cylinder between the centers A and B of its ends: I = r^2/2 and r^2/4 + h^2/12.
template <class Scalar>
ShapeProperties<Scalar> cylinder(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Scalar& radius) {
  const Scalar height = norm(B - A);
  const Scalar square = radius * radius;
  return {pi<Scalar>() * square * height, Scalar(0.5) * (A + B),
          axisymmetric_tensor(normalized(B - A), Scalar(0.5) * square,
                              Scalar(0.25) * square + height * height / Scalar(12))};
}

// Hollow cylinder between the centers A and B of its ends: as the cylinder with R^2 + r^2 in place of r^2.
template <class Scalar>
ShapeProperties<Scalar> tube(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Scalar& outer_radius,
                             const Scalar& inner_radius) {
  const Scalar height = norm(B - A);
  const Scalar squares = outer_radius * outer_radius + inner_radius * inner_radius;
  return {pi<Scalar>() * (outer_radius - inner_radius) * (outer_radius + inner_radius) * height, Scalar(0.5) * (A + B),
          axisymmetric_tensor(normalized(B - A), Scalar(0.5) * squares,
                              Scalar(0.25) * squares + height * height / Scalar(12))};
}

// Cone: centroid at 3/4 of the height from the apex; I = 3/10 r^2 and 3/20 r^2 + 3/80 h^2.
template <class Scalar>
ShapeProperties<Scalar> cone(const Vector3<Scalar>& apex, const Vector3<Scalar>& base_center, const Scalar& radius) {
  const Vector3<Scalar> height = base_center - apex;
  const Scalar height_square = norm_squared(height);
  const Scalar square = radius * radius;
  return {pi<Scalar>() / Scalar(3) * square * norm(height), apex + (Scalar(3) / Scalar(4)) * height,
          axisymmetric_tensor(normalized(height), Scalar(3) / Scalar(10) * square,
                              Scalar(3) / Scalar(20) * square + Scalar(3) / Scalar(80) * height_square)};
}

// Cone cut off parallel to its base: radius a at A and b at B, either of which may be zero, or both equal. With
// s = a^2 + ab + b^2: V = pi h s/3, centroid at h (a^2 + 2ab + 3b^2)/(4 s) from A, I = 3/10 (a^4 + ... + b^4)/s, and
// a mean square along the axis of 3/80 h^2 (a^4 + 4 a^3 b + 10 a^2 b^2 + 4 a b^3 + b^4)/s^2.
template <class Scalar>
ShapeProperties<Scalar> frustum(const Vector3<Scalar>& A, const Scalar& radius_A, const Vector3<Scalar>& B,
                                const Scalar& radius_B) {
  const Vector3<Scalar> height = B - A;
  const Scalar height_square = norm_squared(height);
  const Scalar aa = radius_A * radius_A;
  const Scalar ab = radius_A * radius_B;
  const Scalar bb = radius_B * radius_B;
  const Scalar s = aa + ab + bb;
  const Scalar axial = Scalar(3) / Scalar(10) * (aa * aa + aa * ab + ab * ab + ab * bb + bb * bb) / s;
  const Scalar along = Scalar(3) / Scalar(80) * height_square *
                       (aa * aa + Scalar(4) * (aa * ab + ab * bb) + Scalar(10) * ab * ab + bb * bb) / (s * s);
  return {pi<Scalar>() / Scalar(3) * s * norm(height),
          A + ((aa + Scalar(2) * ab + Scalar(3) * bb) / (Scalar(4) * s)) * height,
          axisymmetric_tensor(normalized(height), axial, Scalar(0.5) * axial + along)};
}

// Ellipsoid with the semi-axis vectors a, b, c: I_x = (b^2 + c^2)/5 and so on.
template <class Scalar>
ShapeProperties<Scalar> ellipsoid(const Vector3<Scalar>& center, const Vector3<Scalar>& semi_axis_a,
                                  const Vector3<Scalar>& semi_axis_b, const Vector3<Scalar>& semi_axis_c) {
  return {Scalar(4) / Scalar(3) * pi<Scalar>() * magnitude(dot(semi_axis_a, cross(semi_axis_b, semi_axis_c))), center,
          (Scalar(1) / Scalar(5)) *
              (unit_mass_inertia(semi_axis_a) + unit_mass_inertia(semi_axis_b) + unit_mass_inertia(semi_axis_c))};
}

// Ring of round section: `ring_radius` R from the axis to the middle of the section, `section_radius` r <= R.
// V = 2 pi^2 R r^2, I = R^2 + 3/4 r^2 and R^2/2 + 5/8 r^2.
template <class Scalar>
ShapeProperties<Scalar> torus(const Vector3<Scalar>& center, const Vector3<Scalar>& axis, const Scalar& ring_radius,
                              const Scalar& section_radius) {
  const Scalar R2 = ring_radius * ring_radius;
  const Scalar r2 = section_radius * section_radius;
  return {Scalar(2) * pi<Scalar>() * pi<Scalar>() * ring_radius * r2, center,
          axisymmetric_tensor(normalized(axis), R2 + Scalar(0.75) * r2, Scalar(0.5) * R2 + Scalar(0.625) * r2)};
}

// A twentieth of the mass at each corner has the tetrahedron's moments about the centroid.
template <class Scalar>
ShapeProperties<Scalar> tetrahedron(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Vector3<Scalar>& C,
                                    const Vector3<Scalar>& D) {
  const Vector3<Scalar> center = Scalar(0.25) * (A + B + C + D);
  return {magnitude(dot(B - A, cross(C - A, D - A))) / Scalar(6), center,
          (Scalar(1) / Scalar(20)) * (unit_mass_inertia(A - center) + unit_mass_inertia(B - center) +
                                      unit_mass_inertia(C - center) + unit_mass_inertia(D - center))};
}

namespace detail {

// What a plate sweeps that moves along an edge vector e, straight or aslant: places in the plate and on the way do not
// depend on each other, so that each has its own moments, those of the way as of a rod.
template <class Scalar>
ShapeProperties<Scalar> swept(const ShapeProperties<Scalar>& plate, const Vector3<Scalar>& edge, const Scalar& volume) {
  return {volume, plate.center + Scalar(0.5) * edge,
          plate.inertia_center + (Scalar(1) / Scalar(12)) * unit_mass_inertia(edge)};
}

}  // namespace detail

// Prism on a base with these vertices (as of a polygon), whose points go along the edge vector to the other base.
template <class Scalar>
ShapeProperties<Scalar> prism(const std::vector<Vector3<Scalar>>& base, const Vector3<Scalar>& edge) {
  return detail::swept(polygon(base), edge, magnitude(dot(vector_area_of(base), edge)));
}

// Half a cylinder: A and B are the middles of the ends of its flat face, and it bulges toward the direction `toward`
// (its part across AB). Centroid at 4 r/(3 pi) from the flat face.
template <class Scalar>
ShapeProperties<Scalar> half_cylinder(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Scalar& radius,
                                      const Vector3<Scalar>& toward) {
  const Vector3<Scalar> edge = B - A;
  const Vector3<Scalar> across = radius * normalized(cross(edge, toward));
  const ShapeProperties<Scalar> end = semicircle(Vector3<Scalar>(A - across), Vector3<Scalar>(A + across),
                                                 perpendicular_part(toward, normalized(edge)));
  return detail::swept(end, edge, Scalar(end.measure * norm(edge)));
}

// A sector as thick as this along its axis, half on each side of the center; with an inner radius a piece of a tube.
template <class Scalar>
ShapeProperties<Scalar> thick_sector(const Vector3<Scalar>& center, const Vector3<Scalar>& normal,
                                     const Scalar& outer_radius, const Scalar& inner_radius,
                                     const Vector3<Scalar>& middle_direction, const Scalar& angle,
                                     const Scalar& thickness) {
  const Vector3<Scalar> edge = thickness * normalized(normal);
  const ShapeProperties<Scalar> plate = annular_sector(Vector3<Scalar>(center - Scalar(0.5) * edge), normal,
                                                       outer_radius, inner_radius, middle_direction, angle);
  return detail::swept(plate, edge, Scalar(plate.measure * thickness));
}

// Paraboloid of revolution: centroid at 2/3 of the height from the apex; I = r^2/3 and r^2/6 + h^2/18.
template <class Scalar>
ShapeProperties<Scalar> paraboloid(const Vector3<Scalar>& apex, const Vector3<Scalar>& base_center,
                                   const Scalar& radius) {
  const Vector3<Scalar> height = base_center - apex;
  const Scalar square = radius * radius;
  return {Scalar(0.5) * pi<Scalar>() * square * norm(height), apex + (Scalar(2) / Scalar(3)) * height,
          axisymmetric_tensor(normalized(height), square / Scalar(3),
                              square / Scalar(6) + norm_squared(height) / Scalar(18))};
}

}  // namespace poinsot::shapes
