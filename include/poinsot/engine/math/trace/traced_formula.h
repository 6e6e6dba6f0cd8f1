// Computes formulas in a trace.
#pragma once

#include <functional>
#include <string>

#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/math/trace/traced.h"

namespace poinsot {

// Computes the formula, in its shortest form, in the trace that is being recorded. letter: gives the value of a
// letter.
Traced traced(const Formula& x, const std::function<Traced(const std::string& letter)>& letter);

}  // namespace poinsot
