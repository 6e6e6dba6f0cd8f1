// Claims without formulas: the statement is solved by numbers at points, with what it leaves open drawn too.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "problem/claims/claim_ground.h"

namespace poinsot::problem {

struct NumberTrials {
  bool possible = false;  // whether there was a point that satisfies what is assumed, and at which it was decided
  bool close = false;     // whether there was one so near the edge that it was not
  std::optional<std::pair<Point, Verdict>> refuted;  // where it fails
  std::size_t most_modes = 0;  // rates of growth that do not vanish, of the steady motion where it is claimed stable
};

// Whether all that is claimed is the stability of a steady motion.
bool claims_stability(const Situation& situation, const Claim& claim);

// Tries a claim until it fails, for some time. Throws the StatementError that keeps the statement from being solved at
// any point, where that is no matter of what is assumed.
NumberTrials try_by_numbers(const Statement& statement, std::size_t situation, const Claim& claim, ClaimGround& ground);

}  // namespace poinsot::problem
