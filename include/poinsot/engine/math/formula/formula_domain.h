// Where formulas with inverse functions have a value, and on which side of a bound it lies.
#pragma once

#include <vector>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

// What must not be negative where x has a value: 1 - u and 1 + u for each asin(u) and acos(u) in it, but for what is
// seen to be so always. What stands under roots is told by root_assumptions().
std::vector<Formula> not_negative_in_domain(const Formula& x);

// What root_assumptions() tells, as formulas: each was taken not to be negative when a root was simplified.
std::vector<Formula> assumed_not_negative(const Formula& x);

// The same condition x > 0, wherever x has a value, without the inverse function of which x is a multiple and a number:
// u for pi/2 - acos(u), and 1 if it holds everywhere. Other formulas stay as they are, and so do bounds that are no
// part of pi.
Formula bound_without_inverse(const Formula& x);

}  // namespace poinsot
