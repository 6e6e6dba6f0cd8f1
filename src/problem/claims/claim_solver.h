// Decides a single claim.
#pragma once

#include "problem/claims/claim_ground.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// ground: that of the situation. tell: whether to collect what a worked solution shows of the proof. Throws
// StatementError for a claim that can never be right.
SolvedClaim solve_claim(const Statement& statement, std::size_t situation, const Claim& claim, ClaimGround& ground,
                        bool tell);

}  // namespace poinsot::problem
