#include "problem/instant/varied_instant.h"

#include <stdexcept>

#include "poinsot/engine/solve/instant/closure.h"
#include "problem/language/scalar_value.h"
#include "problem/quantities/tooth_flanks.h"

namespace poinsot::problem {
namespace {

using Varied = VariedInstant::Varied;

// The solution of a linear system, with its derivatives.
std::vector<Varied> varied_solution(const solve::LinearSystem& system, const solve::LinearSystemOf<Varied>& varied) {
  const solve::LinearFactors factors(system);
  const std::vector<double>& value = factors.solution().value;
  const std::vector<double> rate = factors.derivative(varied).value;
  std::vector<Varied> solution;
  for (std::size_t k = 0; k < value.size(); ++k) solution.push_back({value[k], {rate[k]}});
  return solution;
}

}  // namespace

VariedInstant::VariedInstant(const SolvedInstant& base, const std::string& name, std::size_t component)
    : base_(base), situation_(base.situation_), data_(base.situation_, base.settings_, Varied(base.time_)) {
  build(name, component);
  set_positions();
  set_velocities();
  if (base_.before_) strike();
  if (base_.motion_) set_forces();
}

InstantView<Varied> VariedInstant::view() {
  return {situation_,
          data_,
          machine_,
          *mechanism_state_,
          base_.scales_,
          Varied(base_.time_),
          before_ ? &*before_ : nullptr};
}

void VariedInstant::build(const std::string& name, std::size_t component) {
  const Value<Varied> variable = as_variable(base_.settings_.at(name), component);
  DataScope<TimeJetOf<Varied>> timed(situation_, base_.settings_, time_jet(Varied(base_.time_)));
  data_.vary(name, variable);
  timed.vary(name, lifted<TimeJetOf<Varied>>(variable));
  std::size_t next = 0;
  const AnyValue any = [&](const Dimension&) { return base_.any_values_.at(next++); };
  const auto loads = situation_.stages.empty() ? std::nullopt : situation_.stages.front().loads;
  machine_ = build_machine(situation_, data_, timed, any, base_.machine_options(base_.time_, loads));
  mechanism_state_.emplace(machine_.mechanism);
}

void VariedInstant::set_positions() {
  std::vector<Varied>& q = machine_.q;
  std::vector<bool>& given = machine_.position_given;
  for_each_stated_position(machine_, base_.facts_, [&](const Fact& fact, const NamedCoordinate& coordinate) {
    const auto k = static_cast<std::size_t>(coordinate.position);
    q[k] = stated_position(data_, fact, coordinate);
    given[k] = true;
  });
  q = solve::varied_pose(machine_.mechanism, base_.machine_.q, q, given);
  mechanism_state_->set_positions(q);
  solve::update_contacts(machine_.mechanism, *mechanism_state_);
  for (const auto& [fact, difference] : position_differences(view(), base_.facts_))
    position_misfits_.push_back(difference.value / Varied(base_.natural_unit(difference.dimension)));
}

// A fact that is linear for doubles must also be linear for dual numbers.
void VariedInstant::expect_same(InstantSystem system, const std::vector<const Fact*>& nonlinear) const {
  if (base_.nonlinear_.at(system) != nonlinear)
    throw std::domain_error("a fact has another form over dual numbers than over doubles");
}

void VariedInstant::set_velocities() {
  const StatedConditions<Varied> stated = velocity_conditions(view(), base_.facts_);
  expect_same(InstantSystem::velocities, stated.nonlinear);
  systems_[InstantSystem::velocities] = solve::velocity_equations(*mechanism_state_, base_.scales_, stated.linear);
  if (!base_.before_ && !base_.motion_) return;
  if (base_.choice_.velocities && !base_.velocities_.open.empty())
    throw std::domain_error("velocities that are chosen have no derivatives");
  mechanism_state_->set_velocities(varied_solution(base_.velocity_equations_, systems_.at(InstantSystem::velocities)));
}

void VariedInstant::strike() {
  before_.emplace(*mechanism_state_);
  blow_ = stated_blow(view());
  if (base_.rough_blow_) {
    if (base_.rough_blow_->form == RoughBlow::Form::numbers)
      throw std::domain_error("impulses that are followed along a blow have no derivatives");
    put_friction(blow_, *before_, *base_.rough_blow_);
  }
  put_flanks(machine_.mechanism, base_.blow_flanks_);
  const StatedConditions<Varied> stated = blow_conditions(view(), blow_);
  expect_same(InstantSystem::blow, stated.nonlinear);
  systems_[InstantSystem::blow] =
      solve::impulse_equations(*before_, base_.scales_, blow_, stated.linear, base_.blow_acting_);
  if (!base_.motion_) return;
  if (base_.choice_.forces && !base_.blow_solution_.open.empty())
    throw std::domain_error("impulses that are chosen have no derivatives");
  std::vector<Varied> v = varied_solution(base_.blow_equations_, systems_.at(InstantSystem::blow));
  v.resize(static_cast<std::size_t>(machine_.mechanism.tree.velocity_size()));
  mechanism_state_->set_velocities(v);
}

void VariedInstant::set_forces() {
  put_flanks(machine_.mechanism, flanks_of(base_.machine_.mechanism));
  turn_against_slip(machine_, *mechanism_state_);
  // By how much |V| varies is told by its direction alone (quantities/joint_pressing.h).
  for (std::size_t k = 0; k < machine_.rough_contacts.size(); ++k)
    for (std::size_t i = 0; i < machine_.rough_contacts[k].pressing.size(); ++i)
      if (const auto& toward = base_.machine_.rough_contacts[k].pressing[i].toward)
        machine_.rough_contacts[k].pressing[i].toward = lifted<Varied>(*toward);
  const StatedConditions<Varied> stated = force_conditions(view(), base_.facts_, true);
  expect_same(InstantSystem::motion, stated.nonlinear);
  systems_[InstantSystem::motion] = solve::motion_equations(*mechanism_state_, base_.scales_, stated.linear);
}

std::vector<Varied> VariedInstant::nonlinear_misfits(InstantSystem system, const std::vector<Varied>& unknowns) {
  std::vector<Varied> misfits;
  const auto facts = base_.nonlinear_.find(system);
  if (facts == base_.nonlinear_.end()) return misfits;
  for (const Fact* fact : facts->second) {
    QuantityScope<Varied> scope = solution_scope(view(), system, unknowns, &blow_);
    for (const Difference<Varied>& difference : differences(*fact, scope, situation_.file))
      misfits.push_back(difference.value / Varied(base_.natural_unit(difference.dimension)));
  }
  return misfits;
}

}  // namespace poinsot::problem
