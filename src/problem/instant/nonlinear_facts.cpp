// Facts about energies, sizes and directions. They are not linear in velocities or forces and do not determine these;
// they are conditions on the data that velocities and forces follow from.
#include <algorithm>
#include <cmath>

#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {
namespace {

// How far the sides of a fact that holds may differ: a part of themselves, as data are often stated to nine digits; or
// of the natural size of such a quantity at the pace of the motion, since the sides may be differences of larger terms.
constexpr double most_misfit = 1e-8, most_natural = 1e-9;

double size_of(const Value<double>& value) { return std::max(std::abs(value.number), norm(value.vector)); }

}  // namespace

template <class Scalar>
QuantityScope<Scalar> solution_scope(const InstantView<Scalar>& view, InstantSystem system,
                                     const std::vector<Scalar>& unknowns, const solve::BlowOf<Scalar>* blow) {
  const MachineOf<Scalar>& machine = view.machine;
  const bool struck = system == InstantSystem::blow;
  const Model<Scalar>& tree = struck ? machine.tree_after_blow() : machine.mechanism.tree;
  const bool motion = system == InstantSystem::motion;
  const std::vector<Scalar> first(unknowns.begin(), unknowns.begin() + tree.velocity_size());
  QuantityScope<Scalar> scope(machine, tree, view.data,
                              State<Scalar>{machine.q, motion ? view.mechanism_state.state().v : first});
  if (motion) {
    scope.set_accelerations(first);
    scope.set_forces(&view.mechanism_state, &unknowns);
  } else if (system == InstantSystem::blow) {
    scope.set_blow(view.before, blow, &unknowns);
    if (!view.situation.strikes.empty())
      scope.set_flying(flying_particles(view.situation, machine, *view.before, blow));
    scope.set_elsewhere([view](const At& past, const Mark& mark) {
      if (past.instant != "before")
        fail(view.situation.file, mark, "a fact can look back to `before` a blow only, not to '" + past.instant + "'");
      QuantityScope<Scalar> past_scope(view.machine, view.machine.mechanism.tree, view.data, view.before->state());
      past_scope.set_flying(flying_particles<Scalar>(view.situation, view.machine, *view.before, nullptr));
      return past_scope.value(past.expression);
    });
  }
  return scope;
}

SolvedInstant::FactSides SolvedInstant::sides_of(const Fact& fact, System system,
                                                 const std::vector<double>& unknowns) const {
  QuantityScope<double> scope = solution_scope(view(), system, unknowns, &blow_);
  FactSides sides;
  sides.differences = differences(fact, scope, situation_.file);
  sides.size = size_of(scope.value(fact.quantity));
  for (const Difference<double>& difference : sides.differences)
    sides.size = std::max(sides.size, std::abs(difference.value));
  return sides;
}

std::vector<SolvedInstant::NonlinearMisfit> SolvedInstant::nonlinear_misfits(
    System system, const std::vector<double>& unknowns) const {
  std::vector<NonlinearMisfit> misfits;
  const auto facts = nonlinear_.find(system);
  if (facts == nonlinear_.end()) return misfits;
  for (const Fact* fact : facts->second) {
    const FactSides sides = sides_of(*fact, system, unknowns);
    for (const Difference<double>& difference : sides.differences) {
      const double unit = natural_unit(difference.dimension);
      misfits.push_back({source_of(*fact), difference.value / unit, sides.size / unit});
    }
  }
  return misfits;
}

void SolvedInstant::hold_nonlinear(System system, const std::vector<const Fact*>& facts,
                                   const solve::LinearSolution& solution) {
  nonlinear_[system] = facts;
  const bool motion = system == System::motion;
  // Of the sides: along an open direction a fact stays what it is, but for rounding.
  constexpr double same_along = 1e-9;
  for (const Fact* fact : facts) {
    const FactSides sides = sides_of(*fact, system, solution.value);
    for (const std::vector<double>& direction : solution.open) {
      std::vector<double> moved = solution.value;
      for (std::size_t k = 0; k < moved.size(); ++k) moved[k] += 0.7 * direction[k];
      const FactSides there = sides_of(*fact, system, moved);
      for (std::size_t i = 0; i < sides.differences.size(); ++i)
        if (!(std::abs(there.differences.at(i).value - sides.differences[i].value) <=
              same_along * std::max(sides.size, there.size)))
          fail(situation_.file, fact->mark,
               "'" + to_string(fact->quantity) + "' is not linear in the " +
                   (motion ? "accelerations and forces" : "velocities") + ": it does not fix them alone",
               motion ? "state accelerations, forces or couples, or make a datum that they follow from an unknown"
                      : "state rates, velocities or momenta, or make a rate an unknown under find:");
    }
    for (const Difference<double>& difference : sides.differences)
      if (!choice_.trial && !(std::abs(difference.value) <=
                              std::max(most_misfit * sides.size, most_natural * natural_size(difference.dimension))))
        fail(situation_.file, fact->mark,
             "'" + to_string(fact->quantity) + "' is not what is stated: it follows from the other facts and the data",
             "correct it, or leave a datum that it follows from to be found");
  }
  if (!choice_.trial) return;
  for (const NonlinearMisfit& misfit : nonlinear_misfits(system, solution.value)) {
    misfits_.push_back(misfit.value);
    misfit_size_ = std::max(misfit_size_, misfit.size);
  }
}

template QuantityScope<Dual<1>> solution_scope(const InstantView<Dual<1>>&, InstantSystem, const std::vector<Dual<1>>&,
                                               const solve::BlowOf<Dual<1>>*);

}  // namespace poinsot::problem
