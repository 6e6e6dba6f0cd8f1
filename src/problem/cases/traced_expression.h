// Conditions as they are told, traced: "g - r*w^2 >= 0".
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "poinsot/engine/math/trace/traced.h"

namespace poinsot::problem {

// The left side less the right one, or the other way round, of a comparison that holds where this is positive (or not
// negative), computed in the trace that is being recorded; nothing if the words are no comparison of formulas. Numbers
// and letters are in SI units. letter: the value of a letter, nothing for a name that is none.
std::optional<Traced> traced_condition(const std::string& words,
                                       const std::function<std::optional<Traced>(const std::string&)>& letter);

}  // namespace poinsot::problem
