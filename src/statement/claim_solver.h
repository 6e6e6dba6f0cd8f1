// Decides one claim.
#pragma once

#include "poinsot/statement/solve_statement.h"
#include "statement/claim_ground.h"

namespace poinsot::statement {

// ground: of that situation. tell: also what a worked solution shows of it. Throws StatementError for claims that can
// never be right.
SolvedClaim solve_claim(const Statement& statement, std::size_t situation, const Claim& claim, ClaimGround& ground,
                        bool tell);

}  // namespace poinsot::statement
