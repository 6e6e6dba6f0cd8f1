// Values over other scalars: how they convert, and functions of time as dual numbers of dual numbers.
#pragma once

#include "poinsot/engine/math/algebra/dual.h"
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

// A function of time with its first two derivatives.
template <class Scalar>
using TimeJetOf = Dual<1, Dual<1, Scalar>>;
using TimeJet = TimeJetOf<double>;
template <class Scalar>
TimeJetOf<Scalar> time_jet(const Scalar& time) {
  return TimeJetOf<Scalar>(Dual<1, Scalar>::variable(time, 0), {Dual<1, Scalar>(1)});
}

}  // namespace poinsot::problem
