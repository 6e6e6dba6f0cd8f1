// Unit quaternions for attitudes: q = w + x i + y j + z k, R(q) takes body components to ground components, and q and
// -q are the same attitude. With w_B the angular velocity on body axes, dq/dt = q (0, w_B) / 2.
#pragma once

#include "poinsot/engine/math/algebra/angle_functions.h"
#include "poinsot/engine/math/algebra/matrix3.h"
#include "poinsot/engine/math/algebra/scalar.h"

namespace poinsot {

template <class Scalar>
struct Quaternion {
  Scalar w{};
  Scalar x{};
  Scalar y{};
  Scalar z{};

  static constexpr Quaternion identity() { return {Scalar(1), Scalar(0), Scalar(0), Scalar(0)}; }
};

template <class Scalar>
constexpr Vector3<Scalar> vector_part(const Quaternion<Scalar>& q) {
  return {q.x, q.y, q.z};
}
// Hamilton's product: R(a * b) = R(a) R(b).
template <class Scalar>
constexpr Quaternion<Scalar> operator*(const Quaternion<Scalar>& a, const Quaternion<Scalar>& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
template <class Scalar>
constexpr Quaternion<Scalar> conjugate(const Quaternion<Scalar>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}
template <class Scalar>
constexpr Scalar norm_squared(const Quaternion<Scalar>& q) {
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}
// q divided by its norm; not finite for zero.
template <class Scalar>
Quaternion<Scalar> normalized(const Quaternion<Scalar>& q) {
  using std::sqrt;
  const Scalar inverse = Scalar(1) / sqrt(norm_squared(q));
  return {inverse * q.w, inverse * q.x, inverse * q.y, inverse * q.z};
}

// The rotation matrix of a unit quaternion.
template <class Scalar>
constexpr Matrix3<Scalar> rotation_matrix(const Quaternion<Scalar>& q) {
  const Scalar x2 = q.x + q.x;
  const Scalar y2 = q.y + q.y;
  const Scalar z2 = q.z + q.z;
  const Scalar xx = q.x * x2;
  const Scalar yy = q.y * y2;
  const Scalar zz = q.z * z2;
  const Scalar xy = q.x * y2;
  const Scalar yz = q.y * z2;
  const Scalar zx = q.z * x2;
  const Scalar wx = q.w * x2;
  const Scalar wy = q.w * y2;
  const Scalar wz = q.w * z2;
  const Scalar one(1);
  return {
      {one - (yy + zz), xy - wz, zx + wy}, {xy + wz, one - (zz + xx), yz - wx}, {zx - wy, yz + wx, one - (xx + yy)}};
}

// A unit quaternion of the rotation R with w >= 0, by Shepperd's choice of the largest component, which never divides
// by a small number. Scalar: one truth value per comparison.
template <Ordered Scalar>
Quaternion<Scalar> quaternion_of(const Matrix3<Scalar>& R) {
  const Scalar trace = R.row0.x + R.row1.y + R.row2.z;
  const Scalar one(1);
  Quaternion<Scalar> q;  // four times the largest component times the quaternion
  if (trace >= R.row0.x && trace >= R.row1.y && trace >= R.row2.z) {
    q = {one + trace, R.row2.y - R.row1.z, R.row0.z - R.row2.x, R.row1.x - R.row0.y};
  } else if (R.row0.x >= R.row1.y && R.row0.x >= R.row2.z) {
    q = {R.row2.y - R.row1.z, one + R.row0.x - R.row1.y - R.row2.z, R.row0.y + R.row1.x, R.row0.z + R.row2.x};
  } else if (R.row1.y >= R.row2.z) {
    q = {R.row0.z - R.row2.x, R.row0.y + R.row1.x, one + R.row1.y - R.row2.z - R.row0.x, R.row1.z + R.row2.y};
  } else {
    q = {R.row1.x - R.row0.y, R.row0.z + R.row2.x, R.row1.z + R.row2.y, one + R.row2.z - R.row0.x - R.row1.y};
  }
  q = normalized(q);
  return q.w < Scalar(0) ? Quaternion<Scalar>{-q.w, -q.x, -q.y, -q.z} : q;
}

// The attitude after a turn by the vector a (rad) from the identity: (cos |a|/2, sin |a|/2 a/|a|). Smooth at a = 0.
template <class Scalar>
Quaternion<Scalar> quaternion_exponential(const Vector3<Scalar>& a) {
  const Scalar quarter_square = Scalar(0.25) * norm_squared(a);
  const Scalar s = Scalar(0.5) * sinc_of_square(quarter_square);
  return {cosine_of_square(quarter_square), s * a.x, s * a.y, s * a.z};
}

// dq/dt = q (0, w_B) / 2, w_B the angular velocity on body axes, rad/s.
template <class Scalar>
constexpr Quaternion<Scalar> quaternion_rate(const Quaternion<Scalar>& q, const Vector3<Scalar>& w_B) {
  const Scalar half(0.5);
  return q * Quaternion<Scalar>{Scalar(0), half * w_B.x, half * w_B.y, half * w_B.z};
}

}  // namespace poinsot
