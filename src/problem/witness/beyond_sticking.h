// The second road to where contacts at rest no longer stick.
#pragma once

#include <optional>

#include "problem/instant/instant.h"

namespace poinsot::problem {

// Whether contacts that stick and share a load stick in no share: by a virtual motion in which their forces could do
// no work of the other sign. It is held against the equations of motion themselves, whatever shares were found of
// them. Nothing where they share nothing. Forces must be solved.
std::optional<bool> sticks_in_no_share(const SolvedInstant& instant);

}  // namespace poinsot::problem
