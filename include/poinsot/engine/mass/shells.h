// Thin shells: closed forms of area, centroid and inertia per unit mass.
//
// Points are given from the origin (m); directions need not be unit vectors. Nothing is checked here: see
// poinsot/engine/mass/shape_faults.h, whose functions take the same arguments.
#pragma once

#include "poinsot/engine/mass/lines.h"

namespace poinsot::shapes {

// Six rectangular sheets on the faces of the box with perpendicular edge vectors a, b, c. For the direction of a the
// two faces bc lie at a/2 and the other four have a mean square of a^2/12.
template <class Scalar>
ShapeProperties<Scalar> box_shell(const Vector3<Scalar>& center, const Vector3<Scalar>& edge_a,
                                  const Vector3<Scalar>& edge_b, const Vector3<Scalar>& edge_c) {
  const Scalar a = norm(edge_a);
  const Scalar b = norm(edge_b);
  const Scalar c = norm(edge_c);
  const Scalar area = Scalar(2) * (a * b + b * c + c * a);
  const auto sheets = [&area](const Vector3<Scalar>& edge, const Scalar& across, const Scalar& along) {
    return ((across / Scalar(2) + along / Scalar(6)) / area) * unit_mass_inertia(edge);
  };
  return {area, center,
          sheets(edge_a, b * c, a * b + c * a) + sheets(edge_b, c * a, a * b + b * c) +
              sheets(edge_c, a * b, b * c + c * a)};
}

// The same by two opposite corners and its axes, the columns of `axes` (perpendicular unit vectors).
template <class Scalar>
ShapeProperties<Scalar> box_shell_between(const Vector3<Scalar>& corner, const Vector3<Scalar>& opposite,
                                          const Matrix3<Scalar>& axes = Matrix3<Scalar>::identity()) {
  const Vector3<Scalar> size = transpose_times(axes, opposite - corner);
  return box_shell(Scalar(0.5) * (corner + opposite), size.x * axes.column(0), size.y * axes.column(1),
                   size.z * axes.column(2));
}

// I = 2/3 r^2.
template <class Scalar>
ShapeProperties<Scalar> sphere_shell(const Vector3<Scalar>& center, const Scalar& radius) {
  const Scalar square = radius * radius;
  return {Scalar(4) * pi<Scalar>() * square, center, isotropic_tensor(Scalar(2) / Scalar(3) * square)};
}

// Half a sphere on the circle about `center`, its pole on the side of `axis`. Centroid at r/2: I = 2/3 r^2 about the
// axis, 5/12 r^2 across it.
template <class Scalar>
ShapeProperties<Scalar> hemisphere_shell(const Vector3<Scalar>& center, const Vector3<Scalar>& axis,
                                         const Scalar& radius) {
  const Vector3<Scalar> pole = normalized(axis);
  const Scalar square = radius * radius;
  return {Scalar(2) * pi<Scalar>() * square, center + (Scalar(0.5) * radius) * pole,
          axisymmetric_tensor(pole, Scalar(2) / Scalar(3) * square, Scalar(5) / Scalar(12) * square)};
}

// Tube of sheet, open at both ends; A and B are the centers of its ends. I = r^2 and r^2/2 + h^2/12.
template <class Scalar>
ShapeProperties<Scalar> cylinder_shell(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Scalar& radius) {
  const Scalar height = norm(B - A);
  const Scalar square = radius * radius;
  return {Scalar(2) * pi<Scalar>() * radius * height, Scalar(0.5) * (A + B),
          axisymmetric_tensor(normalized(B - A), square, Scalar(0.5) * square + height * height / Scalar(12))};
}

// The same with a disk on each end: h parts of wall to r parts of ends, in units of 2 pi r.
template <class Scalar>
ShapeProperties<Scalar> closed_cylinder_shell(const Vector3<Scalar>& A, const Vector3<Scalar>& B,
                                              const Scalar& radius) {
  const Scalar height = norm(B - A);
  const Scalar square = radius * radius;
  const Scalar all = height + radius;
  const Scalar axial = square * (height + Scalar(0.5) * radius) / all;
  const Scalar along = height * height * (height / Scalar(12) + Scalar(0.25) * radius) / all;
  return {Scalar(2) * pi<Scalar>() * radius * all, Scalar(0.5) * (A + B),
          axisymmetric_tensor(normalized(B - A), axial, Scalar(0.5) * axial + along)};
}

// Lateral surface of a cone, without its base. Centroid at 2/3 of the height from the apex; I = r^2/2 and
// r^2/4 + h^2/18.
template <class Scalar>
ShapeProperties<Scalar> cone_shell(const Vector3<Scalar>& apex, const Vector3<Scalar>& base_center,
                                   const Scalar& radius) {
  using std::sqrt;
  const Vector3<Scalar> height = base_center - apex;
  const Scalar height_square = norm_squared(height);
  const Scalar square = radius * radius;
  return {pi<Scalar>() * radius * sqrt(square + height_square), apex + (Scalar(2) / Scalar(3)) * height,
          axisymmetric_tensor(normalized(height), Scalar(0.5) * square,
                              Scalar(0.25) * square + height_square / Scalar(18))};
}

}  // namespace poinsot::shapes
