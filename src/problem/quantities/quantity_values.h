// Small conversions that the functions of quantities share.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

#include "poinsot/engine/math/algebra/vector3.h"
#include "problem/language/expression.h"
#include "problem/language/scalar_value.h"
#include "problem/language/value.h"

namespace poinsot::problem {

template <class Scalar>
Value<Scalar> vector_value(const Vector3<Scalar>& v, const Dimension& dimension) {
  return Value<Scalar>::of_vector(v, dimension);
}

template <class Scalar>
Value<Scalar> number_value(const Scalar& x, const Dimension& dimension) {
  return Value<Scalar>::of_number(x, dimension);
}

// The expression as a name without primes; nullptr if it is anything else.
inline const Name* plain_name(const Expression& expression) {
  const Name* name = expression.as<Name>();
  return name && name->primes == 0 ? name : nullptr;
}

// Stands before the last values of a kind: a row of the table of quantities without a value of its own would have them.
inline void require_one_of(std::string_view function, std::initializer_list<std::string_view> last) {
  if (std::ranges::find(last, function) == last.end())
    throw std::logic_error("the quantity '" + std::string(function) + "' has a row in its table and no value");
}

}  // namespace poinsot::problem
