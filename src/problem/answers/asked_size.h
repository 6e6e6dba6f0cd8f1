// The size by which rounding in an answer is judged: that of the bodies that it is about, not of the largest in the
// file.
#pragma once

#include "problem/instant/instant.h"

namespace poinsot::problem {

// The natural size of an answer of this dimension, in SI units, for the bodies that the ask names. It follows from
// their masses, radii of gyration, velocities and, once these are solved, accelerations and forces. If the ask names
// something that acts between bodies, the smaller of the sizes for the two is taken; if it names nothing, that of the
// whole machine. Factors that are data count with their values, and of a sum the largest term counts: the size of
// kinetic_energy(disk)/c^2 is that of the energy, divided by c^2. It is zero for quantities that do not grow with the
// pace of the motion.
double asked_size(SolvedInstant& instant, const Situation& situation, const Ask& ask, const Dimension& dimension);

}  // namespace poinsot::problem
