// The sign of a formula for all values of its letters.
#pragma once

#include <vector>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

struct SeenSign {
  int sign = 0;         // 1: nowhere negative; -1: nowhere positive; 0: changes, or is not seen
  bool strict = false;  // and nowhere zero
};

// For all positive values of the positive letters and all values of the others, wherever the formula has a value; 0 for
// zero. Seen are products of polynomials whose terms have one sign, or whose coefficients by a letter have; definite
// quadratic forms, by their discriminants; and sums with square roots that squaring decides.
SeenSign seen_sign(const Formula& x);

// The irreducible factors of the numerator, each once, that are not seen to have no zero: x = 0 exactly where one of
// them vanishes and the rest has a value.
std::vector<Formula> vanishing_factors(const Formula& x);
// The product of those factors of x, with its sign, on which the sign of x depends: it is positive where x is and
// negative where x is. keep_zeros: it also keeps all factors that may vanish, and is zero where x is.
Formula sign_part(const Formula& x, bool keep_zeros);

}  // namespace poinsot
