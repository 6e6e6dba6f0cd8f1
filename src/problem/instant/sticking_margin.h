// How far contacts with dry friction that are at rest are from sliding.
#pragma once

#include <optional>
#include <vector>

#include "problem/instant/instant.h"

namespace poinsot::problem {

// The least m N - |F| of contacts that stick, beside the largest of these forces: below zero where they do not all
// stick. Forces must be solved. Nothing where none sticks, or one does of a cord or in a joint, whose laws are others.
std::optional<double> sticking_margin(const SolvedInstant& instant);

// The forces on one side, and the cones of the contacts that stick, of an instant of which forces are solved; nothing
// in the same cases as of the margin.
struct StickingForces {
  std::vector<std::size_t> one_sided;
  std::vector<FrictionCone> cones;
};
std::optional<StickingForces> sticking_forces(const SolvedInstant& instant);

}  // namespace poinsot::problem
