#include "problem/claims/claim_steady.h"

#include <algorithm>

#include "poinsot/engine/math/formula/formula_decision.h"
#include "problem/claims/claim_stability.h"
#include "problem/claims/claim_trials.h"
#include "problem/formulas/formula_answers.h"

namespace poinsot::problem {
namespace {

// The steady motion with formulas for its numbers; nothing if it has none.
std::optional<SteadyFormulas> steady_motion(const ClaimFormulas& formulas, ClaimGround& ground,
                                            std::size_t most_modes) {
  SteadyFormulas motion = steady_formulas(ground.situation(), formulas.instant().machine(), formulas.positions(),
                                          formulas.velocities(), ground.base().machine());
  // Twice as many eigenvalues as free velocities exist. Those that are not among the modes belong to displacements
  // that do not change the motion.
  const std::size_t all = 2 * (motion.v.size() - motion.held.size());
  if (most_modes > all) return std::nullopt;
  motion.symmetries = all - most_modes;
  return motion;
}

}  // namespace

bool proves_steady_stability(const Claim& claim, ClaimGround& ground, std::size_t most_modes,
                             std::optional<SolvedClaim::Stability>* told) {
  const Situation& situation = ground.situation();
  if (most_modes == 0 || situation.has_blow()) return false;
  for (const Frame& frame : situation.frames)
    if (frame.name == situation.steady->frame && !frame.rides_on.empty()) return false;
  const FormulaLimitScope limits({most_formula_terms, most_formula_work});
  try {
    ClaimFormulas* formulas = ground.formulas(false);
    if (!formulas) return false;
    const PlainPointScope decisions(ground.base_point());
    const DecisionScope taken;
    Claim assumed = claim;
    assumed.of.clear();
    const ClaimInstant instant(*formulas, assumed);
    std::vector<std::string> positive;
    for (const Letter& letter : ground.letters())
      if (is_positive(letter)) positive.push_back(letter.name);
    const WorkedAssumptions worked(instant.assumptions(), positive);
    const std::optional<SteadyFormulas> motion = steady_motion(*formulas, ground, most_modes);
    if (!motion) return false;
    const bool decided =
        instant.decisions().signs.empty() && !instant.decisions().zeros_by_digits && taken.signs().empty();
    return proves_stability(*motion, worked, told) && decided && !taken.zeros_by_digits();
  } catch (const NoFormula&) {
  } catch (const std::domain_error&) {
  } catch (const FormulaTooLarge&) {
  } catch (const StatementError&) {
    // The claim is then decided by samples.
  }
  return false;
}

}  // namespace poinsot::problem
