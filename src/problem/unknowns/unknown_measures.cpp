// Scales and pivots of the equations for unknowns, which are held so that misfits at different places can be compared.
#include <optional>
#include <vector>

#include "problem/unknowns/unknown_equations.h"

namespace poinsot::problem {
namespace {

// Which equations of a system state facts of an instant.
std::vector<bool> facts_among(const SolvedInstant& instant, InstantSystem which) {
  std::vector<bool> facts(instant.equations_of(which).equations());
  for (std::size_t i = 0; i < facts.size(); ++i) facts[i] = instant.source_of(which, i).instant != nullptr;
  return facts;
}

}  // namespace

// Pivots are taken where the equations have the highest rank. Places of lower rank are rare, but zero and the ends of
// ranges are among them; so places are tried until one brings no higher rank.
void UnknownEquations::hold_measures() {
  if (measured_) return;
  measured_ = true;
  for (const std::vector<double>& x : places(4)) {
    try {
      if (!take_measures(x)) break;
    } catch (const StatementError& error) {
      refuse(error);
    }
  }
}

bool UnknownEquations::take_measures(const std::vector<double>& x) {
  bool told_more = false;
  put(x, trial_);
  for (std::size_t i : system_.situations()) {
    const bool velocities = system_.has({i, Aspect::velocities}), forces = system_.has({i, Aspect::forces});
    if (!velocities && !forces && !system_.has({i, Aspect::positions})) continue;
    const Situation& situation = statement_.situations[i];
    OpenChoice choice = choice_;
    if (const auto held = measures_.scales.find(i); held != measures_.scales.end()) choice.scales = held->second;
    SolvedInstant instant(situation, trial_[i], When{0, situation.has_blow()}, choice);
    if (forces) instant.solve_forces();
    measures_.scales.emplace(i, instant.scales());
    const auto hold = [&](InstantSystem which) {
      solve::LinearElimination elimination(instant.equations_of(which), facts_among(instant, which));
      // An elimination of rank zero tells nothing: numbers may not be finite there.
      told_more = told_more || elimination.rank() == 0;
      const auto [held, fresh] = measures_.eliminations.try_emplace({i, which}, elimination);
      if (!fresh && elimination.rank() <= held->second.rank()) return;
      held->second = elimination;
      // No rank is higher than the number of unknowns.
      told_more = told_more || elimination.rank() < instant.equations_of(which).unknowns();
    };
    if (velocities) hold(InstantSystem::velocities);
    if (velocities && instant.after_blow()) hold(InstantSystem::blow);
    if (forces) hold(InstantSystem::motion);
  }
  return told_more;
}

}  // namespace poinsot::problem
