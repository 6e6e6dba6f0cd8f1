// Splits the rates in claims of conservation into parts that cancel.
#pragma once

#include <vector>

#include "problem/claims/claim_instant.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// For each comparison of a rate with zero, adds the parts of the rate: the rates of the addends, or the parts that
// come from each coordinate and velocity. A comparison that cannot be split is left as it is. comparisons: those of
// the claim's terms, in their order.
void add_rate_parts(ClaimFormulas& formulas, const Claim& claim, std::vector<SolvedClaim::Comparison>& comparisons);

}  // namespace poinsot::problem
