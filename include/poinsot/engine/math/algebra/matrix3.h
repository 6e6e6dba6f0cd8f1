// 3x3 matrices, general and symmetric.
#pragma once

#include "poinsot/engine/math/algebra/vector3.h"

namespace poinsot {

// A general matrix, kept as its three rows.
template <class Scalar>
struct Matrix3 {
  Vector3<Scalar> row0;
  Vector3<Scalar> row1;
  Vector3<Scalar> row2;

  constexpr Vector3<Scalar>& row(std::size_t i) { return i == 0 ? row0 : i == 1 ? row1 : row2; }
  constexpr const Vector3<Scalar>& row(std::size_t i) const { return i == 0 ? row0 : i == 1 ? row1 : row2; }
  constexpr Vector3<Scalar> column(std::size_t i) const { return {row0[i], row1[i], row2[i]}; }
  constexpr Scalar& operator()(std::size_t i, std::size_t j) { return row(i)[j]; }
  constexpr const Scalar& operator()(std::size_t i, std::size_t j) const { return row(i)[j]; }

  static constexpr Matrix3 zero() {
    return {Vector3<Scalar>::zero(), Vector3<Scalar>::zero(), Vector3<Scalar>::zero()};
  }
  static constexpr Matrix3 identity() {
    return {Vector3<Scalar>::unit(0), Vector3<Scalar>::unit(1), Vector3<Scalar>::unit(2)};
  }
  static constexpr Matrix3 from_columns(const Vector3<Scalar>& a, const Vector3<Scalar>& b, const Vector3<Scalar>& c) {
    return {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}};
  }
};

template <class Scalar>
constexpr Matrix3<Scalar> transpose(const Matrix3<Scalar>& a) {
  return Matrix3<Scalar>::from_columns(a.row0, a.row1, a.row2);
}
template <class Scalar>
constexpr Vector3<Scalar> operator*(const Matrix3<Scalar>& a, const Vector3<Scalar>& v) {
  return {dot(a.row0, v), dot(a.row1, v), dot(a.row2, v)};
}
// transpose(a) * v without forming the transpose.
template <class Scalar>
constexpr Vector3<Scalar> transpose_times(const Matrix3<Scalar>& a, const Vector3<Scalar>& v) {
  return {a.row0.x * v.x + a.row1.x * v.y + a.row2.x * v.z, a.row0.y * v.x + a.row1.y * v.y + a.row2.y * v.z,
          a.row0.z * v.x + a.row1.z * v.y + a.row2.z * v.z};
}
template <class Scalar>
constexpr Matrix3<Scalar> operator*(const Matrix3<Scalar>& a, const Matrix3<Scalar>& b) {
  return {transpose_times(b, a.row0), transpose_times(b, a.row1), transpose_times(b, a.row2)};
}
template <class Scalar>
constexpr Matrix3<Scalar> operator+(const Matrix3<Scalar>& a, const Matrix3<Scalar>& b) {
  return {a.row0 + b.row0, a.row1 + b.row1, a.row2 + b.row2};
}
template <class Scalar>
constexpr Matrix3<Scalar> operator-(const Matrix3<Scalar>& a, const Matrix3<Scalar>& b) {
  return {a.row0 - b.row0, a.row1 - b.row1, a.row2 - b.row2};
}
template <class Scalar>
constexpr Matrix3<Scalar> operator*(const Scalar& s, const Matrix3<Scalar>& a) {
  return {s * a.row0, s * a.row1, s * a.row2};
}
// The matrix [a]x of the map v -> a x v.
template <class Scalar>
constexpr Matrix3<Scalar> cross_matrix(const Vector3<Scalar>& a) {
  return {{Scalar(0), -a.z, a.y}, {a.z, Scalar(0), -a.x}, {-a.y, a.x, Scalar(0)}};
}
template <class Scalar>
constexpr Scalar determinant(const Matrix3<Scalar>& a) {
  return dot(a.row0, cross(a.row1, a.row2));
}

// A symmetric matrix by its six different entries. For a tensor of inertia the off-diagonal entries are minus the
// products of inertia (Eq. 18.8): xy = -I_xy.
template <class Scalar>
struct SymmetricMatrix3 {
  Scalar xx{};
  Scalar yy{};
  Scalar zz{};
  Scalar xy{};
  Scalar yz{};
  Scalar zx{};

  static constexpr SymmetricMatrix3 zero() {
    return {Scalar(0), Scalar(0), Scalar(0), Scalar(0), Scalar(0), Scalar(0)};
  }
  static constexpr SymmetricMatrix3 diagonal(const Scalar& x, const Scalar& y, const Scalar& z) {
    return {x, y, z, Scalar(0), Scalar(0), Scalar(0)};
  }
  constexpr SymmetricMatrix3& operator+=(const SymmetricMatrix3& b) {
    xx += b.xx;
    yy += b.yy;
    zz += b.zz;
    xy += b.xy;
    yz += b.yz;
    zx += b.zx;
    return *this;
  }
};

template <class Scalar>
constexpr SymmetricMatrix3<Scalar> operator+(SymmetricMatrix3<Scalar> a, const SymmetricMatrix3<Scalar>& b) {
  return a += b;
}
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> operator-(const SymmetricMatrix3<Scalar>& a, const SymmetricMatrix3<Scalar>& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.yz - b.yz, a.zx - b.zx};
}
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> operator*(const Scalar& s, const SymmetricMatrix3<Scalar>& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.zx};
}
template <class Scalar>
constexpr Vector3<Scalar> operator*(const SymmetricMatrix3<Scalar>& a, const Vector3<Scalar>& v) {
  return {a.xx * v.x + a.xy * v.y + a.zx * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
          a.zx * v.x + a.yz * v.y + a.zz * v.z};
}
template <class Scalar>
constexpr Matrix3<Scalar> as_matrix(const SymmetricMatrix3<Scalar>& a) {
  return {{a.xx, a.xy, a.zx}, {a.xy, a.yy, a.yz}, {a.zx, a.yz, a.zz}};
}
// The symmetric part of a matrix that is symmetric up to rounding.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> symmetric_part(const Matrix3<Scalar>& a) {
  const Scalar half(0.5);
  return {a.row0.x,
          a.row1.y,
          a.row2.z,
          half * (a.row0.y + a.row1.x),
          half * (a.row1.z + a.row2.y),
          half * (a.row2.x + a.row0.z)};
}
// The same tensor on other axes: R a R^T, R taking components on the old axes to components on the new ones.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> rotated(const Matrix3<Scalar>& R, const SymmetricMatrix3<Scalar>& a) {
  return symmetric_part(R * (as_matrix(a) * transpose(R)));
}
// |d|^2 1 - d d^T: the moments of a unit mass at d about the origin (Eqs. 18.5, 18.6).
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> unit_mass_inertia(const Vector3<Scalar>& d) {
  return {d.y * d.y + d.z * d.z, d.z * d.z + d.x * d.x, d.x * d.x + d.y * d.y, -d.x * d.y, -d.y * d.z, -d.z * d.x};
}

}  // namespace poinsot
