// What the engine asks of a scalar, and these functions for the built-in ones.
//
// A scalar has + - * / among its own kind, is constructed from a double, and provides, found by argument-dependent
// look-up: sqrt, sine_cosine (sine_cosine.h), every_value and positive_sign (here), and sinc_of_square and its
// relatives (angle_functions.h) where positions are integrated. Dual (dual.h) and Pack (pack.h) do.
#pragma once

#include <cmath>
#include <concepts>

namespace poinsot {

// True if the predicate on the number holds for every number that x carries: x itself, the value of a dual, all lanes
// of a pack. For checks of data at the edges, never inside an algorithm.
template <std::floating_point Scalar, class Predicate>
constexpr bool every_value(const Scalar& x, Predicate predicate) {
  return predicate(static_cast<double>(x));
}

// 1 where x >= +0, -1 where x <= -0: never zero.
template <std::floating_point Scalar>
Scalar positive_sign(const Scalar& x) {
  return std::copysign(Scalar(1), x);
}

// A scalar whose comparisons give one truth value.
template <class Scalar>
concept Ordered = requires(const Scalar& a, const Scalar& b) {
  { a < b } -> std::same_as<bool>;
};

}  // namespace poinsot
