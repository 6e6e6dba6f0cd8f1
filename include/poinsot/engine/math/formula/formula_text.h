// Writes formulas in the form that people recognise.
//
// The form depends only on the value, not on how it was computed: exact numbers; common factors in front; sines and
// cosines as powers, of double angles or of sums of angles, whichever needs the fewest operators.
#pragma once

#include <string>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

enum class Notation {
  plain,       // m*r^2/2, with sqrt sin cos tan asin acos atan atan2 and pi
  with_sizes,  // the same with abs(x) in place of sqrt(x^2), for people
  c,           // m*r*r/2, for doubles, with the functions of <math.h> and M_PI
  python,      // m*r**2/2, with the functions of Python's math
  sympy,       // the same with exact numbers
  tex          // \frac{m r^{2}}{2}
};

// Throws FormulaTooLarge as the operations on formulas do. Sums of more than some sixty terms are written as they
// stand.
std::string text(const Formula& x, Notation notation = Notation::plain);

}  // namespace poinsot
