// Shared helpers of evaluation: values in words, zeros, and the dimension of a sum.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "problem/language/exact_numbers.h"
#include "problem/language/expression.h"
#include "problem/language/scalar_value.h"
#include "problem/language/value.h"

namespace poinsot::problem {

// A number as messages show it: "25", "0.3".
std::string number_text(double x);

// The dimension of the sum of two quantities of one kind. A pure number plus an angle is an angle, a rate plus a
// turning rate is a turning rate (pi/2 - theta, omega + 2 pi/T). Where other units are present the radian is left out
// (v + omega r is a velocity).
Dimension joined_dimension(const Dimension& a, const Dimension& b);

struct UnknownCall {
  std::string message;
  std::string hint;
};
UnknownCall describe_unknown_call(const Call& call, const std::vector<std::string>& others);

template <class Scalar>
std::string kind_in_words(const Value<Scalar>& value) {
  using Kind = typename Value<Scalar>::Kind;
  switch (value.kind) {
    case Kind::number:
      return "a number";
    case Kind::vector:
      return "a vector";
    case Kind::list:
      return "a list";
    case Kind::boolean:
      return "a truth value";
    case Kind::text:
      return "a text";
    case Kind::any:
      break;
  }
  return "'any'";
}

// A value in words: "a force", "the number 3 without unit".
template <class Scalar>
std::string quantity_in_words(const Value<Scalar>& value) {
  if (value.bare && value.is_number()) return "the number " + number_text(plain(value.number)) + " without unit";
  if (value.bare) return "a vector without unit";
  return to_string(value.dimension);
}

template <class Scalar>
bool is_zero(const Value<Scalar>& value) {
  if (value.is_number()) return plain(value.number) == 0;
  return value.is_vector() && plain(value.vector.x) == 0 && plain(value.vector.y) == 0 && plain(value.vector.z) == 0;
}

// Whether this is a zero written without unit, which fits every dimension.
template <class Scalar>
bool is_bare_zero(const Value<Scalar>& value) {
  return value.bare && is_zero(value);
}

// Turns a list of three numbers of one kind into a vector, where a bare zero fits any kind. Other values are returned
// unchanged.
template <class Scalar>
Value<Scalar> as_vector(Value<Scalar> value) {
  if (!value.is_list() || value.items.size() != 3) return value;
  std::optional<Dimension> common;
  bool bare = true;
  for (const Value<Scalar>& item : value.items) {
    if (!item.is_number()) return value;
    bare = bare && item.bare;
    if (is_bare_zero(item)) continue;
    if (common && !same_kind(*common, item.dimension)) return value;
    common = common ? joined_dimension(*common, item.dimension) : item.dimension;
  }
  return Value<Scalar>::of_vector({value.items[0].number, value.items[1].number, value.items[2].number},
                                  common.value_or(dimensions::none), bare);
}

// A list of numbers that have names, such as the parts of a mode: the name of each is its text.
template <class Scalar>
bool is_record(const Value<Scalar>& value) {
  return value.is_list() && !value.items.empty() &&
         std::all_of(value.items.begin(), value.items.end(),
                     [](const Value<Scalar>& item) { return item.is_number() && !item.text.empty(); });
}
template <class Scalar>
std::vector<std::string> names_in(const Value<Scalar>& record) {
  std::vector<std::string> names;
  for (const Value<Scalar>& item : record.items) names.push_back(item.text);
  return names;
}

template <class Scalar>
bool is_finite(const Value<Scalar>& value) {
  if constexpr (Recording<Scalar>) return true;  // whether it is finite the motion will tell
  if (value.is_number()) return std::isfinite(plain(value.number));
  if (!value.is_vector()) return true;
  return std::isfinite(plain(value.vector.x)) && std::isfinite(plain(value.vector.y)) &&
         std::isfinite(plain(value.vector.z));
}

}  // namespace poinsot::problem
