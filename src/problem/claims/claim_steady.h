// Claims that a steady motion is stable.
#pragma once

#include <cstddef>
#include <optional>

#include "problem/claims/claim_ground.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// Whether a steady motion that numbers found stable at many points is so for all values of the letters. most_modes:
// rates of growth there that do not vanish. told: the polynomial and what was seen of it, also where that was not
// enough; nothing where there are no formulas, or where none is wanted (null).
bool proves_steady_stability(const Claim& claim, ClaimGround& ground, std::size_t most_modes,
                             std::optional<SolvedClaim::Stability>* told);

}  // namespace poinsot::problem
