#include "statement/claim_steady.h"

#include <algorithm>

#include "poinsot/math/expression_decision.h"
#include "statement/claim_stability.h"
#include "statement/claim_trials.h"
#include "statement/formula_answers.h"
#include "statement/formula_deadline.h"

namespace poinsot::statement {
namespace {

// The motion as formulas; nothing where it cannot be.
std::optional<SteadyFormulas> steady_formulas(const ClaimFormulas& formulas, ClaimGround& ground,
                                              std::size_t most_modes) {
  const MachineOf<Formula>& machine = formulas.instant().machine();
  SteadyFormulas motion{machine,
                        formulas.positions(),
                        formulas.velocities(),
                        machine.index.at(ground.problem().steady->frame),
                        still_coordinates(ground.base().machine()),
                        0};
  for (const auto& rate : machine.accelerations) motion.held.push_back(rate.velocity);
  std::sort(motion.held.begin(), motion.held.end());
  motion.held.erase(std::unique(motion.held.begin(), motion.held.end()), motion.held.end());
  // What has no rate of growth among the modes are displacements to the same motion.
  const std::size_t all = 2 * (motion.v.size() - motion.held.size());
  if (most_modes > all) return std::nullopt;
  motion.symmetries = all - most_modes;
  return motion;
}

}  // namespace

bool proves_steady_stability(const Claim& claim, ClaimGround& ground, std::size_t most_modes,
                             std::optional<SolvedClaim::Stability>* told) {
  const Problem& problem = ground.problem();
  if (most_modes == 0 || problem.has_blow()) return false;
  for (const Frame& frame : problem.frames)
    if (frame.name == problem.steady->frame && !frame.rides_on.empty()) return false;
  const ExpressionLimitScope limits({most_formula_terms, formula_deadline(most_formula_seconds)});
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
    const std::optional<SteadyFormulas> motion = steady_formulas(*formulas, ground, most_modes);
    if (!motion) return false;
    const bool decided =
        instant.decisions().signs.empty() && !instant.decisions().zeros_by_digits && taken.signs().empty();
    return proves_stability(*motion, worked, told) && decided && !taken.zeros_by_digits();
  } catch (const NoFormula&) {
  } catch (const std::domain_error&) {
  } catch (const ExpressionTooLarge&) {
  } catch (const StatementError&) {
    // Then it stays with the samples.
  }
  return false;
}

}  // namespace poinsot::statement
