// Whether what was solved and told of an instant is right, by the bodies as particles.
#pragma once

#include "problem/instant/instant.h"

namespace poinsot::problem {

// Relative misfit allowed in the check with particles. Right answers leave 1e-15 of their terms, and 1e-10 where loops
// are closed and unknowns found to nine digits; a wrong term of an equation is no hundred-millionth of the others. The
// scan of what is told of a motion leaves 1e-11.
inline constexpr double check_tolerance = 1e-8;

// The second road along a blow with friction goes by steps of which ten thousand make a blow.
inline constexpr double blow_tolerance = 1e-3;

// The largest misfit of the instant and of what was written down of what it told.
double misfit_by_particles(const SolvedInstant& instant);
bool confirmed_by_particles(const SolvedInstant& instant);
// And by the second spectrum, where rates near a steady motion were found.
bool confirmed_by_all_roads(const SolvedInstant& instant);

}  // namespace poinsot::problem
