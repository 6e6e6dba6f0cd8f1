// Bodies after particles have struck them and stay.
#pragma once

#include <optional>

#include "poinsot/statement/problem.h"

namespace poinsot::statement {

// The problem of the motion that follows a blow in which particles of some mass stay: they belong to the bodies, and
// nothing sudden happens any more. None if no particle stays.
std::optional<Problem> with_absorbed_particles(const Problem& problem);

}  // namespace poinsot::statement
