// Proves claims that a steady motion is stable.
#pragma once

#include <cstddef>
#include <optional>

#include "problem/claims/claim_ground.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// Whether a steady motion that numbers show to be stable at many points is stable for all values of the letters.
// most_modes: the largest number of eigenvalues found there that do not vanish. told: receives the polynomial and
// what is known of its signs, also if that does not suffice; nothing if there are no formulas. It may be null.
bool proves_steady_stability(const Claim& claim, ClaimGround& ground, std::size_t most_modes,
                             std::optional<SolvedClaim::Stability>* told);

}  // namespace poinsot::problem
