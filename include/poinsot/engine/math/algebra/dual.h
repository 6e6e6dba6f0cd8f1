// Numbers with their partial derivatives: forward differentiation, exact to rounding.
//
// Dual<N, Base> carries a value and its derivatives by N variables, each of type Base. Duals of duals give second
// derivatives: Dual<N, Dual<N>>. Comparisons look at the value alone.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "poinsot/engine/math/algebra/scalar.h"
#include "poinsot/engine/math/algebra/sine_cosine.h"

namespace poinsot {

template <int N, class Base = double>
struct Dual {
  Base value{};
  std::array<Base, N> partial{};

  constexpr Dual() = default;
  template <class Number>
  requires std::is_arithmetic_v<Number>
  constexpr Dual(Number number) : value(static_cast<Base>(number)) {}
  constexpr Dual(const Base& number) requires(!std::is_arithmetic_v<Base>) : value(number) {}
  constexpr Dual(const Base& number, const std::array<Base, N>& partials) : value(number), partial(partials) {}

  // The variable number i (0 to N - 1) at a value: its derivative by itself is 1.
  static constexpr Dual variable(const Base& number, int i) {
    Dual x;
    x.value = number;
    x.partial[static_cast<std::size_t>(i)] = Base(1);
    return x;
  }
  // f(x) with derivative slope * x'.
  constexpr Dual chained(const Base& function_value, const Base& slope) const {
    Dual y;
    y.value = function_value;
    for (std::size_t i = 0; i < N; ++i) y.partial[i] = slope * partial[i];
    return y;
  }

  constexpr Dual& operator+=(const Dual& b) {
    value += b.value;
    for (std::size_t i = 0; i < N; ++i) partial[i] += b.partial[i];
    return *this;
  }
  constexpr Dual& operator-=(const Dual& b) {
    value -= b.value;
    for (std::size_t i = 0; i < N; ++i) partial[i] -= b.partial[i];
    return *this;
  }
  constexpr Dual& operator*=(const Dual& b) { return *this = *this * b; }
  constexpr Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend constexpr Dual operator+(const Dual& a) { return a; }
  friend constexpr Dual operator-(const Dual& a) {
    Dual c;
    c.value = -a.value;
    for (std::size_t i = 0; i < N; ++i) c.partial[i] = -a.partial[i];
    return c;
  }
  friend constexpr Dual operator+(Dual a, const Dual& b) { return a += b; }
  friend constexpr Dual operator-(Dual a, const Dual& b) { return a -= b; }
  friend constexpr Dual operator*(const Dual& a, const Dual& b) {
    Dual c;
    c.value = a.value * b.value;
    for (std::size_t i = 0; i < N; ++i) c.partial[i] = a.partial[i] * b.value + a.value * b.partial[i];
    return c;
  }
  friend constexpr Dual operator/(const Dual& a, const Dual& b) {
    const Base inverse = Base(1) / b.value;
    Dual c;
    c.value = a.value / b.value;
    for (std::size_t i = 0; i < N; ++i) c.partial[i] = (a.partial[i] - c.value * b.partial[i]) * inverse;
    return c;
  }

  friend constexpr bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend constexpr bool operator!=(const Dual& a, const Dual& b) { return !(a.value == b.value); }
  friend constexpr bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend constexpr bool operator>(const Dual& a, const Dual& b) { return b.value < a.value; }
  friend constexpr bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend constexpr bool operator>=(const Dual& a, const Dual& b) { return b.value <= a.value; }
};

template <int N, class Base>
Dual<N, Base> sqrt(const Dual<N, Base>& x) {
  using std::sqrt;
  const Base root = sqrt(x.value);
  return x.chained(root, Base(0.5) / root);
}
template <int N, class Base>
SineCosine<Dual<N, Base>> sine_cosine(const Dual<N, Base>& x) {
  const auto [s, c] = sine_cosine(x.value);
  return {x.chained(s, c), x.chained(c, -s)};
}
template <int N, class Base>
Dual<N, Base> sin(const Dual<N, Base>& x) {
  return sine_cosine(x).sine;
}
template <int N, class Base>
Dual<N, Base> cos(const Dual<N, Base>& x) {
  return sine_cosine(x).cosine;
}
template <int N, class Base>
Dual<N, Base> tan(const Dual<N, Base>& x) {
  using std::tan;
  const Base t = tan(x.value);
  return x.chained(t, Base(1) + t * t);
}
template <int N, class Base>
Dual<N, Base> asin(const Dual<N, Base>& x) {
  using std::asin;
  using std::sqrt;
  return x.chained(asin(x.value), Base(1) / sqrt((Base(1) - x.value) * (Base(1) + x.value)));
}
template <int N, class Base>
Dual<N, Base> acos(const Dual<N, Base>& x) {
  using std::acos;
  using std::sqrt;
  return x.chained(acos(x.value), Base(-1) / sqrt((Base(1) - x.value) * (Base(1) + x.value)));
}
template <int N, class Base>
Dual<N, Base> atan(const Dual<N, Base>& x) {
  using std::atan;
  return x.chained(atan(x.value), Base(1) / (Base(1) + x.value * x.value));
}
template <int N, class Base>
Dual<N, Base> atan2(const Dual<N, Base>& y, const Dual<N, Base>& x) {
  using std::atan2;
  const Base inverse = Base(1) / (x.value * x.value + y.value * y.value);
  Dual<N, Base> angle;
  angle.value = atan2(y.value, x.value);
  for (std::size_t i = 0; i < N; ++i) {
    angle.partial[i] = (x.value * y.partial[i] - y.value * x.partial[i]) * inverse;
  }
  return angle;
}
template <int N, class Base>
Dual<N, Base> exp(const Dual<N, Base>& x) {
  using std::exp;
  const Base e = exp(x.value);
  return x.chained(e, e);
}
template <int N, class Base>
Dual<N, Base> log(const Dual<N, Base>& x) {
  using std::log;
  return x.chained(log(x.value), Base(1) / x.value);
}
// |x|, with the derivative from the right at zero.
template <int N, class Base>
constexpr Dual<N, Base> abs(const Dual<N, Base>& x) {
  return x.value < Base(0) ? -x : x;
}
template <int N, class Base>
constexpr Dual<N, Base> fabs(const Dual<N, Base>& x) {
  return abs(x);
}
// A constant power; at x = 0 only if the power is at least 1 (or 0).
template <int N, class Base>
Dual<N, Base> pow(const Dual<N, Base>& x, double power) {
  using std::pow;
  if (power == 0.0) return Dual<N, Base>(1);
  return x.chained(pow(x.value, power), Base(power) * pow(x.value, power - 1.0));
}
// A variable power of a positive number.
template <int N, class Base>
Dual<N, Base> pow(const Dual<N, Base>& x, const Dual<N, Base>& power) {
  return exp(power * log(x));
}
template <int N, class Base>
bool isfinite(const Dual<N, Base>& x) {
  using std::isfinite;
  for (const Base& p : x.partial) {
    if (!isfinite(p)) return false;
  }
  return isfinite(x.value);
}

template <int N, class Base, class Predicate>
constexpr bool every_value(const Dual<N, Base>& x, Predicate predicate) {
  return every_value(x.value, predicate);
}
template <int N, class Base>
Dual<N, Base> positive_sign(const Dual<N, Base>& x) {
  return Dual<N, Base>(positive_sign(x.value));
}

}  // namespace poinsot
