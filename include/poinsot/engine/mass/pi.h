// The number pi in the precision of a scalar.
#pragma once

#include <numbers>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

// Specialise this for scalars that hold pi otherwise than as a double (a symbol, more digits).
template <class Scalar>
struct Pi {
  static Scalar value() { return Scalar(std::numbers::pi); }
};
template <>
struct Pi<long double> {
  static long double value() { return std::numbers::pi_v<long double>; }
};
template <>
struct Pi<Formula> {
  static Formula value() { return Formula::pi(); }
};

template <class Scalar>
Scalar pi() {
  return Pi<Scalar>::value();
}

}  // namespace poinsot
