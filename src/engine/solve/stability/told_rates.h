// Whether what is told of the modes near a steady motion is what the spectrum of the second road says.
#pragma once

#include "engine/solve/stability/doubted_rates.h"
#include "poinsot/engine/solve/stability/linearisation.h"

namespace poinsot::solve {

// Rates below this part of the pace may belong to displacements that change nothing: where several vanish together,
// their errors are roots of those of the equations.
inline constexpr Real slow_rate = 1e-2L;
// A rate of this road that is this far from all of the other's, as a part of the pace, has none among them. Differences
// leave 1e-8 in simple rates and the root of that where two nearly meet; a forgotten term of the equations moves a rate
// in its first digits.
inline constexpr Real far_rate = 1e-3L;

// own: the rates of the second road, as parts of the pace.
bool agrees(const Linearisation& found, const ComplexVector& own);

}  // namespace poinsot::solve
