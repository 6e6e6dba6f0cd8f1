// Where contacts cease to stick, to the last digits.
#pragma once

#include <functional>
#include <optional>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// That contacts stick is decided up to the rounding of forces, and the value at which they cease to is then off by far
// more where the forces change slowly with it. margin: how far they are from sliding, which falls through zero at the
// end; nothing where that is not known. inside, outside: beside each other, found by that decision. Nothing if the
// margin does not vanish near there.
std::optional<double> sticking_end(const std::function<std::optional<double>(double)>& margin, double inside,
                                   double outside);

// The least margin of all instants of a sample that have one.
std::optional<double> margin_of_sticking(const Sample& sample);

// Whether at some instant contacts share a load and no share of it lets all of them stick that should, by the second
// road to that; nothing if they share nothing.
std::optional<bool> none_shares(const Sample& sample);

}  // namespace poinsot::problem
