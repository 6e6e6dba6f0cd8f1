// Rotation matrices. R_AB takes components on the axes of B to components on those of A; its columns are the axes of B.
#pragma once

#include "poinsot/engine/math/algebra/angle_functions.h"
#include "poinsot/engine/math/algebra/matrix3.h"
#include "poinsot/engine/math/algebra/scalar.h"
#include "poinsot/engine/math/algebra/sine_cosine.h"

namespace poinsot {

// Rotation by an angle (rad) about a unit axis: R = c 1 + s [n]x + (1 - c) n n^T (Rodrigues).
template <class Scalar>
Matrix3<Scalar> rotation_about(const Vector3<Scalar>& unit_axis, const Scalar& angle) {
  const auto [s, versine] = sine_versine(angle);
  const Vector3<Scalar>& n = unit_axis;
  const Vector3<Scalar> a = versine * n;
  const Vector3<Scalar> b = s * n;
  return {{Scalar(1) - a.y * n.y - a.z * n.z, a.x * n.y - b.z, a.x * n.z + b.y},
          {a.x * n.y + b.z, Scalar(1) - a.z * n.z - a.x * n.x, a.y * n.z - b.x},
          {a.x * n.z - b.y, a.y * n.z + b.x, Scalar(1) - a.x * n.x - a.y * n.y}};
}

// Rotation by the vector a (rad, along the axis): R = 1 + sinc(|a|) [a]x + (1 - cos |a|)/|a|^2 [a]x [a]x. Smooth at a =
// 0.
template <class Scalar>
Matrix3<Scalar> rotation_exponential(const Vector3<Scalar>& a) {
  const Scalar x = norm_squared(a);
  const Matrix3<Scalar> A = cross_matrix(a);
  return Matrix3<Scalar>::identity() + sinc_of_square(x) * A + cosine_rest_of_square(x) * (A * A);
}

// R * rotation about z, given the sine and cosine of the angle: 12 products.
template <class Scalar>
constexpr Matrix3<Scalar> turned_about_z(const Matrix3<Scalar>& R, const SineCosine<Scalar>& turn) {
  const Scalar& s = turn.sine;
  const Scalar& c = turn.cosine;
  return {{c * R.row0.x + s * R.row0.y, c * R.row0.y - s * R.row0.x, R.row0.z},
          {c * R.row1.x + s * R.row1.y, c * R.row1.y - s * R.row1.x, R.row1.z},
          {c * R.row2.x + s * R.row2.y, c * R.row2.y - s * R.row2.x, R.row2.z}};
}

// R A R^T, the tensor A on other axes, in 45 products.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> turned(const Matrix3<Scalar>& R, const SymmetricMatrix3<Scalar>& A) {
  const Vector3<Scalar> t0 = A * R.row0;
  const Vector3<Scalar> t1 = A * R.row1;
  const Vector3<Scalar> t2 = A * R.row2;
  return {dot(R.row0, t0), dot(R.row1, t1), dot(R.row2, t2), dot(R.row0, t1), dot(R.row1, t2), dot(R.row2, t0)};
}

// A right-handed rotation whose third column is the unit vector n, without singular direction (Duff et al., "Building
// an Orthonormal Basis, Revisited", JCGT 6, 2017). Exact for n along an axis.
template <class Scalar>
Matrix3<Scalar> axes_with_z_along(const Vector3<Scalar>& n) {
  const Scalar sign = positive_sign(n.z);
  const Scalar a = -Scalar(1) / (sign + n.z);
  const Scalar b = n.x * n.y * a;
  return Matrix3<Scalar>::from_columns({Scalar(1) + sign * n.x * n.x * a, sign * b, -sign * n.x},
                                       {b, sign + n.y * n.y * a, -n.y}, n);
}

// Largest entry of |R^T R - 1|, plus 2 if R is a reflection: zero up to rounding for a rotation,
// not a number if an entry is none.
template <class Scalar>
Scalar orthonormality_defect(const Matrix3<Scalar>& R) {
  const Matrix3<Scalar> E = transpose(R) * R - Matrix3<Scalar>::identity();
  Scalar largest(0);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Scalar size = E(i, j) < Scalar(0) ? Scalar(-E(i, j)) : E(i, j);
      const bool none = largest != largest;  // NOLINT(misc-redundant-expression): so it is not a number, which stays
      if (!none && !(size <= largest)) largest = size;
    }
  }
  return determinant(R) < Scalar(0) ? Scalar(largest + Scalar(2)) : largest;
}

}  // namespace poinsot
