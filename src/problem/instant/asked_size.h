// By what size rounding in an answer is judged: that of the bodies it speaks of, not of the largest in the file.
#pragma once

#include "problem/instant/instant.h"

namespace poinsot::problem {

// The size that a quantity of this dimension naturally has, SI, for the bodies that the ask names: from their masses,
// radii of gyration, velocities and, once they are solved, accelerations and forces. Where it names what acts between
// bodies, for the one of them for which it is least; where it names neither, for the whole machine. Zero for what does
// not grow with the pace of a motion.
double asked_size(const SolvedInstant& instant, const Situation& situation, const Ask& ask, const Dimension& dimension);

}  // namespace poinsot::problem
