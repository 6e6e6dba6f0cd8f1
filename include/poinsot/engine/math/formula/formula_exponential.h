// Powers of e in formulas: e^(mu*beta), by which the tensions of a cord on a rough post differ.
//
// A power enters by letters of its own, one for each product of letters in the exponent, e^(a + 2 b) = e^a (e^b)^2.
// These are independent of each other and of the letters themselves (Ax 1971, the exponential case of Schanuel's
// conjecture), so that the zero test of formulas stays certain; where the exponents are numbers or differ by parts,
// as a/2 and a/3 do, it is by digits.
#pragma once

#include <optional>
#include <vector>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

// e^x
Formula exp(const Formula& x);
// The natural logarithm, whose sums and differences are not drawn together: ln(x) + ln(y) is compared with ln(x*y) by
// digits. What is seen to be not positive throws std::domain_error.
Formula ln(const Formula& x);
// y with x = e^y, if x is written as a power of e; nothing of other formulas.
std::optional<Formula> exponent_of(const Formula& x);
// The exponents of the powers of e in a formula, those within its roots and other functions among them.
std::vector<Formula> exponents_of(const Formula& x);

}  // namespace poinsot
