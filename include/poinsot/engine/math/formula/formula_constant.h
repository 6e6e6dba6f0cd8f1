// Writes a constant of nature, of which multiples stand in the numbers of a formula, as a factor by itself.
#pragma once

#include <string>
#include <string_view>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

// The text of a formula for people (Notation::with_sizes) with a constant as a factor wherever that leaves fewer digits
// beside it: with "9.80665" it is 5*m*9.80665/2 in place of 24.516625*m, and sqrt(2*9.80665*h) in place of 7*sqrt(...).
// The value is exactly the same. digits: a positive decimal, told apart from other numbers by a large prime factor;
// others are left as they are.
std::string text_with_constant(const Formula& x, std::string_view digits);

// A positive multiple of x in whose terms the numbers beside the constant have no common factor or divisor:
// 2*L*w^2 - 3*9.80665 in place of 20000*L*w^2/588399 - 1/2.
Formula with_plain_numbers(const Formula& x, std::string_view digits);

}  // namespace poinsot
