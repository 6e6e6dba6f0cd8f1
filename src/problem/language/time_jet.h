// Functions of time with their first two derivatives, as dual numbers of dual numbers.
#pragma once

#include "poinsot/engine/math/algebra/dual.h"

namespace poinsot::problem {

// A function of time with its first two derivatives.
template <class Scalar>
using TimeJetOf = Dual<1, Dual<1, Scalar>>;
using TimeJet = TimeJetOf<double>;
template <class Scalar>
TimeJetOf<Scalar> time_jet(const Scalar& time) {
  return TimeJetOf<Scalar>(Dual<1, Scalar>::variable(time, 0), {Dual<1, Scalar>(1)});
}

}  // namespace poinsot::problem
