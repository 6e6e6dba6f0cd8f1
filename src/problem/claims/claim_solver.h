// Decides one claim.
#pragma once

#include "problem/claims/claim_ground.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// ground: of that situation. tell: also what a worked solution shows of it. Throws StatementError for claims that can
// never be right.
SolvedClaim solve_claim(const Statement& statement, std::size_t situation, const Claim& claim, ClaimGround& ground,
                        bool tell);

}  // namespace poinsot::problem
