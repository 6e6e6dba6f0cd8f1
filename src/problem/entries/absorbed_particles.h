// Bodies after particles have struck them and stay.
#pragma once

#include <optional>

#include "problem/entries/statement.h"

namespace poinsot::problem {

// The problem of the motion that follows a blow in which particles of some mass stay: they belong to the bodies, and
// nothing sudden happens any more. None if no particle stays.
std::optional<Situation> with_absorbed_particles(const Situation& situation);

}  // namespace poinsot::problem
