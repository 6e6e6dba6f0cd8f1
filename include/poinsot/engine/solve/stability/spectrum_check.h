// A second road to the rates near a steady motion, which shares no derivation with linearise().
#pragma once

#include <optional>

#include "poinsot/engine/solve/stability/linearisation.h"

namespace poinsot::solve {

// How far the rates, and the shapes if they are known, are from those of the bodies in redundant coordinates, as a part
// of the pace: the place and turn of each body, what joins them by geometry, Newton's and Euler's equations for each. 1
// where the numbers of freedoms differ or a rate is missing. The redundant equations are linearised by differences,
// which leaves some 1e-8. Nothing where that road does not lead (redundant_bodies.h).
std::optional<double> spectrum_misfit(const SteadyMotion& motion, const Linearisation& found);

// The misfit beyond which rates and shapes are not confirmed, a hundred times what the differences leave: a mistake in
// the equations is seen in the first digits.
constexpr double spectrum_tolerance = 1e-6;

}  // namespace poinsot::solve
