// The rates that claims of conservation speak of, in parts that cancel.
#pragma once

#include <vector>

#include "problem/claims/claim_instant.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// Adds to comparisons of a rate with zero the parts of the rate: those of the addends of what it is the rate of, or by
// the coordinates and velocities in that. Leaves out what has none. comparisons: those of the claim's terms, in order.
void add_rate_parts(ClaimFormulas& formulas, const Claim& claim, std::vector<SolvedClaim::Comparison>& comparisons);

}  // namespace poinsot::problem
