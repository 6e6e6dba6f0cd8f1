// Tries claims without formulas: the situation is solved by numbers at random points, and what it leaves open is
// random too.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "problem/claims/claim_ground.h"

namespace poinsot::problem {

struct NumberTrials {
  bool possible = false;  // whether there was a point that satisfies the assumptions and at which the claim was decided
  std::size_t tried = 0;  // points in all
  bool close = false;     // whether there was one at which it was so close that rounding might decide
  std::optional<Point> close_alike;     // such a point at which letters of a kind are equal, where a strict claim ends
  std::optional<Point> close_at_end{};  // where an assumption just holds and the claim is not decided
  std::optional<std::pair<Point, Verdict>> refuted;  // a point at which the claim fails
  // for a claim of stability, the largest number of eigenvalues of the steady motion that do not vanish
  std::size_t most_modes = 0;
};

// Whether the claim is just that a steady motion is stable.
bool claims_stability(const Situation& situation, const Claim& claim);

// Tries a claim at points until it fails or the search ends. Throws the StatementError that prevents a solution at
// every point, unless the assumptions are the reason.
NumberTrials try_by_numbers(const Statement& statement, std::size_t situation, const Claim& claim, ClaimGround& ground);

}  // namespace poinsot::problem
