// Whether what was solved and told of an instant is right, by the bodies as particles.
#pragma once

#include "problem/instant/instant.h"

namespace poinsot::problem {

// Of the instant and of what was written down of what it told.
bool confirmed_by_particles(const SolvedInstant& instant);

}  // namespace poinsot::problem
