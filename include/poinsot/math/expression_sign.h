// The sign of a formula for all values of its letters.
#pragma once

#include "poinsot/math/expression.h"

namespace poinsot {

struct SeenSign {
  int sign = 0;         // 1: nowhere negative; -1: nowhere positive; 0: changes, or is not seen
  bool strict = false;  // and nowhere zero
};

// For all positive values of the positive letters and all values of the others, wherever the formula has a value; 0 for
// zero. Seen are products of polynomials whose terms have one sign, definite squares, and sums with square roots that
// squaring decides.
SeenSign seen_sign(const Expression& x);

}  // namespace poinsot
