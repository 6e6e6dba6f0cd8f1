// The double behind a scalar: what the checks of an evaluation look at.
#pragma once

#include <algorithm>
#include <type_traits>

#include "poinsot/math/dual.h"

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

}  // namespace poinsot::statement
