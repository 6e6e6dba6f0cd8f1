// Conversion of values from one scalar to another.
#pragma once

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/value.h"

namespace poinsot::problem {

using poinsot::lifted;

// A value as a constant of another scalar: its derivatives are zero.
template <class Scalar, class Source>
Value<Scalar> lifted(const Value<Source>& value) {
  Value<Scalar> result;
  result.kind = static_cast<typename Value<Scalar>::Kind>(value.kind);
  result.dimension = value.dimension;
  result.bare = value.bare;
  result.number = lifted<Scalar>(value.number);
  result.vector = lifted<Scalar>(value.vector);
  for (const Value<Source>& item : value.items) result.items.push_back(lifted<Scalar>(item));
  result.truth = value.truth;
  result.text = value.text;
  return result;
}

}  // namespace poinsot::problem
