// The double behind a scalar: what the checks of an evaluation look at.
#pragma once

#include <algorithm>
#include <type_traits>

#include "poinsot/math/dual.h"
#include "poinsot/statement/value.h"

namespace poinsot::statement {

inline double plain(double x) { return x; }
template <int N, class Base>
double plain(const Dual<N, Base>& x) {
  return plain(x.value);
}

// Without derivatives, so the same whatever the unknowns are.
inline bool is_constant(double) { return true; }
template <int N, class Base>
bool is_constant(const Dual<N, Base>& x) {
  return is_constant(x.value) &&
         std::all_of(x.partial.begin(), x.partial.end(), [](const Base& p) { return plain(p) == 0 && is_constant(p); });
}

// A value as a constant of another scalar.
template <class Scalar>
Value<Scalar> lifted(const Value<double>& value) {
  Value<Scalar> result;
  result.kind = static_cast<typename Value<Scalar>::Kind>(value.kind);
  result.dimension = value.dimension;
  result.bare = value.bare;
  result.number = Scalar(value.number);
  result.vector = {Scalar(value.vector.x), Scalar(value.vector.y), Scalar(value.vector.z)};
  for (const Value<double>& item : value.items) result.items.push_back(lifted<Scalar>(item));
  result.truth = value.truth;
  result.text = value.text;
  return result;
}

}  // namespace poinsot::statement
