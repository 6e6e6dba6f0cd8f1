// The sign of a formula for all values of its letters.
#pragma once

#include <vector>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

struct SeenSign {
  int sign = 0;         // 1 if nowhere negative, -1 if nowhere positive, 0 if it changes or is not known
  bool strict = false;  // and nowhere zero
};

// The sign for all positive values of the positive letters and all values of the others, wherever the formula has a
// value; 0 for zero. It is found for products of polynomials whose terms have one sign or whose coefficients by a
// letter do, for definite quadratic forms by their discriminants, and for sums with square roots by squaring.
SeenSign seen_sign(const Formula& x);

// The irreducible factors of the numerator, without repetition, for which it is not known that they have no zero. x =
// 0 exactly where one of them vanishes and the rest has a value.
std::vector<Formula> vanishing_factors(const Formula& x);
// The product, with its sign, of those factors of x that determine the sign of x: it is positive where x is and
// negative where x is. keep_zeros: also with all factors that may vanish, so that it is zero where x is.
Formula sign_part(const Formula& x, bool keep_zeros);
// The same over powers of 1 + t^2 for the tangents t of half angles, such that it is written in sines and cosines.
Formula sign_part_in_sines(const Formula& x, bool keep_zeros);

}  // namespace poinsot
