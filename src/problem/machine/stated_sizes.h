// The sizes that a statement speaks of, which give what it leaves open by `any` a size.
#pragma once

#include <concepts>

#include "problem/language/exact_numbers.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

struct StatedSizes {
  double length = 1;   // m: the largest distance of a point of the situation from the first; 1 if it states no two
  double mass = 1;     // kg: the largest stated mass; 1 if none is stated
  double gravity = 1;  // m/s^2; all to the next power of two

  // A quantity of this dimension, in SI units. Weights are those of the mass.
  double of(const Dimension& dimension) const;
};

// Points and masses that have no value yet do not count. The scalar is double or Dual<1>.
template <class Scalar>
StatedSizes stated_sizes(DataScope<Scalar>& data);

// The size of what a statement leaves open, in SI units: one for formulas, which have no rounding to drown in.
template <class Scalar>
double stated_size(DataScope<Scalar>& data, const Dimension& dimension) {
  if constexpr (std::same_as<Scalar, Formula>)
    return 1;
  else
    return stated_sizes(data).of(dimension);
}

}  // namespace poinsot::problem
