// Proofs that a steady motion is stable, by the signs of the coefficients of its characteristic polynomial.
#pragma once

#include <optional>
#include <vector>

#include "problem/claims/claim_proof.h"
#include "problem/machine/machine.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// A steady motion over formulas.
struct SteadyFormulas {
  const MachineOf<Formula>& machine;
  const std::vector<Formula>&q, &v;
  int frame = 0;          // in which all rests but spins
  std::vector<int> held;  // velocity coordinates whose motion is given, and those that turn nothing
  // How many rates of growth vanish because the whole may be displaced and still moves in the same way.
  std::size_t symmetries = 0;
};

// Whether no disturbance grows by the linearised equations, apart from such displacements, for all values of the
// letters that satisfy the assumptions. Seen for trees of bodies (no loops, contacts or cords) of up to five freedoms:
// with x the deviations of the coordinates on axes that follow the frame,
//
//   det(M l^2 + C l + K) = 0
//
// for the rates of growth l. If odd powers of l are missing, all l^2 are negative and differ where the coefficients
// have one sign and the discriminant is positive (up to the third power of l^2), or where K is definite and C l takes
// no part in the energy (Thomson and Tait). Else all real parts are negative where Hurwitz's determinants are positive.
// shown: what a reader may follow it by, also where no criterion is met; nothing if it is none of this kind. Throws
// what operations on formulas do.
using StabilityShown = SolvedClaim::Stability;
bool proves_stability(const SteadyFormulas& motion, const WorkedAssumptions& assumptions,
                      std::optional<StabilityShown>* shown);

}  // namespace poinsot::problem
