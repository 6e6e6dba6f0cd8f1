// The number of a formula where its sign alone matters, or its first digits.
#pragma once

#include <optional>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

// As value_at, at values that are taken as exact; zero only if it is zero. Nothing where some four thousand bits do not
// tell it from zero, or where there is no value.
std::optional<double> certain_value_at(const Formula& x, const LetterValues& values);

// As value_at, to thirteen digits, which takes less.
double near_value_at(const Formula& x, const LetterValues& values);

}  // namespace poinsot
