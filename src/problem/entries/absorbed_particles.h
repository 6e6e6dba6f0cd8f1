// The bodies after particles have struck them and stuck.
#pragma once

#include <optional>

#include "problem/entries/statement.h"

namespace poinsot::problem {

// The situation after a blow in which particles with mass stick to bodies: they are now parts of these bodies, and
// nothing sudden happens any more. Returns nothing if no particle sticks.
std::optional<Situation> with_absorbed_particles(const Situation& situation);

}  // namespace poinsot::problem
