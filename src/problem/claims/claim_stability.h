// Proofs that a steady motion is stable, by the signs of the coefficients of its characteristic polynomial.
#pragma once

#include <optional>
#include <vector>

#include "problem/claims/claim_proof.h"
#include "problem/near/near_steady_formulas.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// Whether by the linearised equations no disturbance grows, apart from such displacements, for all values of the
// letters that satisfy the assumptions. This is decided for trees of bodies (without loops, contacts or cords) with
// up to five degrees of freedom. The deviations x of the coordinates, on axes that follow the frame, grow at the
// rates l for which
//
//   det(M l^2 + C l + K) = 0.
//
// If no odd powers of l occur, the motion is stable if all l^2 are negative and different, which holds if the
// coefficients have one sign and the discriminant is positive (up to the third power of l^2); or if K is definite and
// C does no work (Thomson and Tait). Otherwise all real parts are negative if Hurwitz's determinants are positive.
// shown: receives what a reader needs to follow this, also if no criterion is met; nothing if the motion is of
// another kind. Throws what operations on formulas throw.
using StabilityShown = SolvedClaim::Stability;
bool proves_stability(const SteadyFormulas& motion, const WorkedAssumptions& assumptions,
                      std::optional<StabilityShown>* shown);

}  // namespace poinsot::problem
