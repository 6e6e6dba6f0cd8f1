// The plain number behind a scalar. Decisions look at it, such as whether a mass is positive or two axes are
// parallel.
//
// A program that runs on dual numbers takes the same branches as on doubles, and its results carry the derivatives
// along these branches. Other scalars bring their own `plain` and `is_constant`, which argument-dependent look-up
// finds.
#pragma once

#include <concepts>
#include <vector>

#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/matrix3.h"

namespace poinsot {

template <std::floating_point Scalar>
constexpr double plain(const Scalar& x) {
  return static_cast<double>(x);
}
template <int N, class Base>
constexpr double plain(const Dual<N, Base>& x) {
  return plain(x.value);
}
template <class Scalar>
constexpr Vector3<double> plain(const Vector3<Scalar>& a) {
  return {plain(a.x), plain(a.y), plain(a.z)};
}
template <class Scalar>
constexpr Matrix3<double> plain(const Matrix3<Scalar>& a) {
  return {plain(a.row0), plain(a.row1), plain(a.row2)};
}
template <class Scalar>
constexpr SymmetricMatrix3<double> plain(const SymmetricMatrix3<Scalar>& a) {
  return {plain(a.xx), plain(a.yy), plain(a.zz), plain(a.xy), plain(a.yz), plain(a.zx)};
}

template <class Item>
auto plain(const std::vector<Item>& items) {
  std::vector<decltype(plain(items.front()))> result;
  result.reserve(items.size());
  for (const Item& item : items) result.push_back(plain(item));
  return result;
}

// Whether a number has no derivatives, so that it is the same for all values of the variables.
template <std::floating_point Scalar>
constexpr bool is_constant(const Scalar&) {
  return true;
}
template <int N, class Base>
constexpr bool is_constant(const Dual<N, Base>& x) {
  for (const Base& partial : x.partial)
    if (plain(partial) != 0 || !is_constant(partial)) return false;
  return is_constant(x.value);
}

// Whether a term is zero for all values of the variables, and so may be left out.
template <class Scalar>
constexpr bool vanishes(const Scalar& x) {
  return plain(x) == 0 && is_constant(x);
}

// A number of one scalar as a constant of another: a double as a dual number, a dual number as a dual of duals.
template <class Target, class Source>
constexpr Target lifted(const Source& x) {
  if constexpr (std::same_as<Target, Source> || std::floating_point<Source>) {
    return Target(x);
  } else {
    return Target(lifted<decltype(Target::value)>(x));
  }
}
template <class Target, class Source>
constexpr Vector3<Target> lifted(const Vector3<Source>& a) {
  return {lifted<Target>(a.x), lifted<Target>(a.y), lifted<Target>(a.z)};
}
template <class Target, class Source>
constexpr SymmetricMatrix3<Target> lifted(const SymmetricMatrix3<Source>& a) {
  return {lifted<Target>(a.xx), lifted<Target>(a.yy), lifted<Target>(a.zz),
          lifted<Target>(a.xy), lifted<Target>(a.yz), lifted<Target>(a.zx)};
}

}  // namespace poinsot
