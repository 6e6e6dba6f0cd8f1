// Numbers and units of a statement as exact scalars: 0.1 is 1/10, 25 deg is 5 pi/36, an inch 127/5000 m.
#pragma once

#include <numbers>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula.h"
#include "problem/language/expression.h"
#include "problem/language/units.h"

namespace poinsot::problem {

// Thrown where something has no formula; what() says why.
class NoFormula : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A scalar that records what is computed on motions whose values are not known; its constants have a scalar of their
// own.
template <class Scalar>
concept Recording = requires {
  typename Scalar::Constant;
};

// Whether a scalar is exact: formulas and duals of them.
template <class Scalar>
inline constexpr bool is_exact = false;
template <>
inline constexpr bool is_exact<Formula> = true;
template <int N, class Base>
inline constexpr bool is_exact<Dual<N, Base>> = is_exact<Base>;

// One of the unit, in SI base units and radians, as an exact number.
Formula exact_factor(const Unit& unit);
// The value of a literal in SI units, as an exact number.
Formula exact_value(const Number& number);

// A number of the statement that may be no double exactly, 0.1 or pi, as the operations on it are rounded now: itself
// if they are rounded to the nearest, else its neighbour on the side to which they are. So what is left of 0.3 - 0.1 -
// 0.2 or cos(90 deg) changes with the direction like all other rounding. Few binary digits are exact: 0.25 stays.
double rounded_datum(double value);

// The value of a literal in SI units, of a decimal text, and of pi, in either kind of scalar.
template <class Scalar>
Scalar literal_value(const Number& number) {
  if constexpr (Recording<Scalar>)
    return Scalar(literal_value<typename Scalar::Constant>(number));
  else if constexpr (is_exact<Scalar>)
    return lifted<Scalar>(exact_value(number));
  else
    return Scalar(rounded_datum(number.value * number.unit.factor));
}
template <class Scalar>
Scalar decimal_value(double value, std::string_view digits) {
  if constexpr (is_exact<Scalar>)
    return lifted<Scalar>(Formula::number(digits));
  else
    return Scalar(rounded_datum(value));
}
template <class Scalar>
Scalar pi_value() {
  if constexpr (Recording<Scalar>)
    return Scalar(pi_value<typename Scalar::Constant>());
  else if constexpr (is_exact<Scalar>)
    return lifted<Scalar>(Formula::pi());
  else
    return Scalar(rounded_datum(std::numbers::pi));
}

}  // namespace poinsot::problem
