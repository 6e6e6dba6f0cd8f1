// From formulas to traced computing.
#pragma once

#include <functional>
#include <string>

#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/math/trace/traced.h"

namespace poinsot {

// Computes the expression in the trace that is being recorded, in its shortest form; letter: what stands for a letter.
Traced traced(const Formula& x, const std::function<Traced(const std::string& letter)>& letter);

}  // namespace poinsot
