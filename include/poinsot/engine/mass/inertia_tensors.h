// Small tensors and vectors from which the inertias of shapes are composed.
#pragma once

#include <cmath>

#include "poinsot/engine/math/algebra/matrix3.h"

namespace poinsot {

// |a| without a branch on the sign; exact but for under- and overflow of the square.
template <class Scalar>
Scalar magnitude(const Scalar& a) {
  using std::sqrt;
  return sqrt(a * a);
}

// The dyad v v^T.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> dyad(const Vector3<Scalar>& v) {
  return {v.x * v.x, v.y * v.y, v.z * v.z, v.x * v.y, v.y * v.z, v.z * v.x};
}

// The tensor with the same moment about every axis.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> isotropic_tensor(const Scalar& moment) {
  return SymmetricMatrix3<Scalar>::diagonal(moment, moment, moment);
}

// The tensor with the moment `axial` about the unit vector `axis` and `transverse` about every axis perpendicular to
// it.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> axisymmetric_tensor(const Vector3<Scalar>& axis, const Scalar& axial,
                                                       const Scalar& transverse) {
  return isotropic_tensor(transverse) + (axial - transverse) * dyad(axis);
}

// The tensor with these moments about three perpendicular unit vectors, the columns of `axes`.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> principal_tensor(const Matrix3<Scalar>& axes, const Vector3<Scalar>& moments) {
  return moments.x * dyad(axes.column(0)) + moments.y * dyad(axes.column(1)) + moments.z * dyad(axes.column(2));
}

// The part of v perpendicular to the unit vector `axis`.
template <class Scalar>
constexpr Vector3<Scalar> perpendicular_part(const Vector3<Scalar>& v, const Vector3<Scalar>& axis) {
  return v - dot(v, axis) * axis;
}

}  // namespace poinsot
