// Formulas as text, in the form that people recognise.
//
// The form depends on the value alone, not on the way it was reached: exact numbers; common factors pulled out; sines
// and cosines as powers, of double angles or of sums of angles, whatever is shortest by the count of operators.
#pragma once

#include <string>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

enum class Notation {
  plain,   // m*r^2/2, with sqrt sin cos tan asin acos atan atan2 and pi
  c,       // m*r*r/2, for doubles, with the functions of <math.h> and M_PI
  python,  // m*r**2/2, with the functions of Python's math
  sympy,   // the same with exact numbers
  tex      // \frac{m r^{2}}{2}
};

// Throws ExpressionTooLarge as the operations on expressions do. Sums of more than some sixty terms are written as they
// stand.
std::string text(const Formula& x, Notation notation = Notation::plain);

}  // namespace poinsot
