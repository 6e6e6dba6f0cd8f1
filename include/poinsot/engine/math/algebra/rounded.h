// A number with a bound on how far rounding has carried it off (running error analysis: Wilkinson, "Error analysis
// revisited", IMA Bulletin 22, 192, 1986; Higham, Accuracy and Stability of Numerical Algorithms, section 3.3).
//
// Every operation adds its own rounding to what its operands were off by, to first order and their products. An
// algorithm that is a template on the scalar thus tells how accurate its results are; over Dual<N, Rounded> it tells
// how accurate their derivatives are. Values are long doubles, so that hardly more is lost than was lost of the doubles
// that went in. What is exactly zero stays so: a term that is not there has no rounding.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "poinsot/engine/math/algebra/sine_cosine.h"

namespace poinsot {

struct Rounded {
  long double value = 0;
  long double error = 0;  // the true number lies no farther than this from the value

  constexpr Rounded() = default;
  // A number that is exact.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  constexpr Rounded(Number number) : value(number) {}
  constexpr Rounded(long double number, long double off) : value(number), error(off) {}

  // A double that stands for a number near by: it was read from decimals and carried through a unit or a product.
  static Rounded stated(double number) {
    return {number, std::numeric_limits<double>::epsilon() * std::fabs(static_cast<long double>(number))};
  }

  // Of the result of one operation.
  static constexpr long double own(long double result) {
    return std::numeric_limits<long double>::epsilon() * (result < 0 ? -result : result);
  }
  constexpr long double size() const { return value < 0 ? -value : value; }
  // Whether it may be zero, for all that is known of it.
  constexpr bool may_vanish() const { return !(size() > error); }

  constexpr Rounded& operator+=(const Rounded& b) { return *this = *this + b; }
  constexpr Rounded& operator-=(const Rounded& b) { return *this = *this - b; }
  constexpr Rounded& operator*=(const Rounded& b) { return *this = *this * b; }
  constexpr Rounded& operator/=(const Rounded& b) { return *this = *this / b; }

  friend constexpr Rounded operator+(const Rounded& a) { return a; }
  friend constexpr Rounded operator-(const Rounded& a) { return {-a.value, a.error}; }
  friend constexpr Rounded operator+(const Rounded& a, const Rounded& b) {
    const long double c = a.value + b.value;
    return {c, a.error + b.error + own(c)};
  }
  friend constexpr Rounded operator-(const Rounded& a, const Rounded& b) {
    const long double c = a.value - b.value;
    return {c, a.error + b.error + own(c)};
  }
  friend constexpr Rounded operator*(const Rounded& a, const Rounded& b) {
    const long double c = a.value * b.value;
    return {c, a.size() * b.error + b.size() * a.error + a.error * b.error + own(c)};
  }
  // Without bound if the divisor may vanish.
  friend constexpr Rounded operator/(const Rounded& a, const Rounded& b) {
    const Rounded c{a.value / b.value, 0};
    if (b.may_vanish()) return {c.value, std::numeric_limits<long double>::infinity()};
    return {c.value, (a.error + c.size() * b.error) / (b.size() - b.error) + own(c.value)};
  }

  friend constexpr bool operator==(const Rounded& a, const Rounded& b) { return a.value == b.value; }
  friend constexpr bool operator<(const Rounded& a, const Rounded& b) { return a.value < b.value; }
  friend constexpr bool operator>(const Rounded& a, const Rounded& b) { return b.value < a.value; }
  friend constexpr bool operator<=(const Rounded& a, const Rounded& b) { return a.value <= b.value; }
  friend constexpr bool operator>=(const Rounded& a, const Rounded& b) { return b.value <= a.value; }
};

inline Rounded sqrt(const Rounded& x) {
  const long double root = std::sqrt(x.value);
  // sqrt(x + e) - sqrt(x) = e / (sqrt(x + e) + sqrt(x))
  const long double least = root + std::sqrt(std::max(0.0L, x.value - x.error));
  return {root, (x.error == 0 ? 0 : least > 0 ? x.error / least : std::sqrt(x.error)) + Rounded::own(root)};
}
inline SineCosine<Rounded> sine_cosine(const Rounded& x) {
  const long double s = std::sin(x.value), c = std::cos(x.value), curved = x.error * x.error / 2;
  return {{s, x.error * std::fabs(c) + curved + Rounded::own(s)},
          {c, x.error * std::fabs(s) + curved + Rounded::own(c)}};
}
// The angle of (x, y), whose rate is at most that of the vector over its length. Without bound if the vector may
// vanish.
inline Rounded atan2(const Rounded& y, const Rounded& x) {
  const long double angle = std::atan2(y.value, x.value), size = std::hypot(x.value, y.value);
  const long double off = std::hypot(x.error, y.error);
  if (off == 0) return {angle, Rounded::own(angle)};
  if (!(size > off)) return {angle, std::numeric_limits<long double>::infinity()};
  return {angle, std::asin(off / size) * (1 + Rounded::own(1)) + Rounded::own(angle)};
}

inline double plain(const Rounded& x) { return static_cast<double>(x.value); }
constexpr bool is_constant(const Rounded&) { return true; }
template <class Predicate>
constexpr bool every_value(const Rounded& x, Predicate predicate) {
  return predicate(static_cast<double>(x.value));
}
inline Rounded positive_sign(const Rounded& x) { return std::copysign(1.0L, x.value); }

}  // namespace poinsot
