// Entire functions of the square of an angle, for exponentials of rotations.
//
//   sinc_of_square(x)          = sin(a)/a            = 1 - x/6 + x^2/120 - ...       x = a^2
//   cosine_of_square(x)        = cos(a)              = 1 - x/2 + x^2/24 - ...
//   cosine_rest_of_square(x)   = (1 - cos(a))/a^2    = 1/2 - x/24 + ...
//   sine_rest_of_square(x)     = (a - sin(a))/a^3    = 1/6 - x/120 + ...
//
// All are smooth at x = 0, so that duals may pass through zero rotation. The series serves where the closed form would
// lose more than two bits (x < 4), with terms to the last place of a long double there: no digits are lost at the
// switch.
#pragma once

#include <cmath>
#include <concepts>

#include "poinsot/engine/math/algebra/sine_cosine.h"

namespace poinsot {

namespace detail {

// sum over k of (-x)^k first_offset! / (first_offset + 2 k)!, by Horner's rule, for |x| <= 4.
template <class Scalar>
Scalar alternating_factorial_series(const Scalar& x, int first_offset) {
  Scalar sum(1);
  for (int k = 14; k >= 1; --k) {
    const double next = (first_offset + 2.0 * k) * (first_offset + 2.0 * k - 1.0);
    sum = Scalar(1) - x / Scalar(next) * sum;
  }
  return sum;
}

}  // namespace detail

// Scalar: a type with one truth value per comparison (built-in numbers and duals). Packs have their own overloads.
template <class Scalar>
Scalar sinc_of_square(const Scalar& x) {
  using std::sqrt;
  if (x < Scalar(4)) return detail::alternating_factorial_series(x, 1);
  const Scalar a = sqrt(x);
  return sine_cosine(a).sine / a;
}
template <class Scalar>
Scalar cosine_of_square(const Scalar& x) {
  using std::sqrt;
  if (x < Scalar(4)) return detail::alternating_factorial_series(x, 0);
  return sine_cosine(Scalar(sqrt(x))).cosine;
}
template <class Scalar>
Scalar cosine_rest_of_square(const Scalar& x) {
  using std::sqrt;
  if (x < Scalar(4)) return detail::alternating_factorial_series(x, 2) / Scalar(2);
  return (Scalar(1) - sine_cosine(Scalar(sqrt(x))).cosine) / x;
}
template <class Scalar>
Scalar sine_rest_of_square(const Scalar& x) {
  using std::sqrt;
  if (x < Scalar(4)) return detail::alternating_factorial_series(x, 3) / Scalar(6);
  const Scalar a = sqrt(x);
  return (a - sine_cosine(a).sine) / (x * a);
}

}  // namespace poinsot
