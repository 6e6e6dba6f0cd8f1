// Vectors of three components on one set of right-handed axes.
//
// Template parameter Scalar: double, long double, Dual<N>, Pack<W> or any type with + - * / and, where a function
// says so, sqrt. Nothing here branches on a value.
#pragma once

#include <cmath>
#include <cstddef>

namespace poinsot {

template <class Scalar>
struct Vector3 {
  Scalar x{};
  Scalar y{};
  Scalar z{};

  constexpr Scalar& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr const Scalar& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }

  constexpr Vector3& operator+=(const Vector3& b) {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
  constexpr Vector3& operator-=(const Vector3& b) {
    x -= b.x;
    y -= b.y;
    z -= b.z;
    return *this;
  }
  constexpr Vector3& operator*=(const Scalar& s) {
    x *= s;
    y *= s;
    z *= s;
    return *this;
  }

  static constexpr Vector3 zero() { return {Scalar(0), Scalar(0), Scalar(0)}; }
  // The unit vector of axis i (0, 1 or 2).
  static constexpr Vector3 unit(std::size_t i) {
    return {Scalar(i == 0 ? 1 : 0), Scalar(i == 1 ? 1 : 0), Scalar(i == 2 ? 1 : 0)};
  }
};

template <class Scalar>
constexpr Vector3<Scalar> operator+(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Scalar>
constexpr Vector3<Scalar> operator-(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Scalar>
constexpr Vector3<Scalar> operator-(const Vector3<Scalar>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class Scalar>
constexpr Vector3<Scalar> operator*(const Scalar& s, const Vector3<Scalar>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class Scalar>
constexpr Vector3<Scalar> operator*(const Vector3<Scalar>& a, const Scalar& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class Scalar>
constexpr Vector3<Scalar> operator/(const Vector3<Scalar>& a, const Scalar& s) {
  return {a.x / s, a.y / s, a.z / s};
}

template <class Scalar>
constexpr Scalar dot(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Scalar>
constexpr Vector3<Scalar> cross(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Scalar>
constexpr Scalar norm_squared(const Vector3<Scalar>& a) {
  return dot(a, a);
}

template <class Scalar>
Scalar norm(const Vector3<Scalar>& a) {
  using std::sqrt;
  return sqrt(norm_squared(a));
}

// a divided by its norm; not finite for the zero vector.
template <class Scalar>
Vector3<Scalar> normalized(const Vector3<Scalar>& a) {
  return a / norm(a);
}

}  // namespace poinsot
