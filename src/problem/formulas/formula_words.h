// A formula as it stands in answers, conditions and assumptions.
#pragma once

#include <string>

#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

// The text of a formula of the statement's letters and numbers, with standard gravity as a factor by itself:
// 5*m*9.80665/2.
std::string formula_words(const Formula& x);

}  // namespace poinsot::problem
