#include <cstddef>
#include <vector>

#include "problem/explanation/explanation_instant.h"

namespace poinsot::problem {

InstantFigures<double> figures_of(const SolvedInstant& solved, const SolvedInstant* before) {
  InstantFigures<double> figures{&solved.machine(), solve::MechanismState(solved.machine().mechanism)};
  const MotionState state = solved.state();
  figures.now.set_positions(state.q);
  figures.now.set_velocities(state.v);
  if (solved.forces_solved()) {
    figures.forces = true;
    figures.unknowns = solved.motion().value;
    figures.now.set_accelerations(std::vector<double>(
        figures.unknowns.begin(), figures.unknowns.begin() + static_cast<std::ptrdiff_t>(state.v.size())));
  }
  if (solved.after_blow()) {
    figures.before.emplace(solved.machine().mechanism);
    figures.before->set_positions(state.q);
    figures.before->set_velocities(before ? before->state().v : solved.velocities_before());
    figures.blow = solved.struck();
    figures.impulses = solved.blow().value;
  }
  return figures;
}

InstantFigures<Formula> figures_of(const FormulaInstant& formulas, bool forces) {
  InstantFigures<Formula> figures{&formulas.machine(), formulas.mechanism_state()};
  figures.forces = forces;
  figures.unknowns = formulas.unknowns();
  if (formulas.before()) figures.before.emplace(*formulas.before());
  figures.blow = formulas.blow();
  figures.impulses = formulas.impulses();
  return figures;
}

}  // namespace poinsot::problem
