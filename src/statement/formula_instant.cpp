#include "statement/formula_instant.h"

#include <algorithm>
#include <array>

#include "poinsot/dynamics/velocity_constraint.h"
#include "poinsot/solve/closure.h"
#include "statement/scalar_value.h"

namespace poinsot::statement {

FormulaInstant::FormulaInstant(const Problem& problem, const FormulaValues& values, const SolvedInstant& numbers,
                               OpenLetters* open)
    : problem_(problem), numbers_(numbers), open_(open) {
  if (open_ && follows_time(problem)) {
    time_ = Formula::letter("time", poinsot::Sign::positive);
    open_->made.push_back({"time", si_unit(dimensions::time), {}});
  }
  data_ = std::make_unique<DataScope<Formula>>(problem, no_settings_, time_);
  DataScope<TimeJetOf<Formula>> timed(problem, no_settings_, time_jet(time_));
  for (const auto& [name, value] : values) {
    data_->vary(name, value);
    timed.vary(name, lifted<TimeJetOf<Formula>>(value));
  }
  MachineOptions options;
  if (!problem.stages.empty()) options.loads = problem.stages.front().loads;
  // Values given as `any`, and gravity of which nothing is said, change no answer that is given.
  const AnyValue any = [](const Dimension&) { return 1.0; };
  machine_ = build_machine(problem, *data_, timed, any, options);
  scales_ = solve::natural_scales(machine_.mechanism);
  moment_.emplace(machine_.mechanism);
  moment_->set_positions(machine_.q);
  facts_ = instants_at_start(problem);
  set_positions(facts_);
  solve_velocities();
  if (numbers.after_blow()) solve_blow();
}

InstantView<Formula> FormulaInstant::view() const {
  return {problem_, *data_, machine_, *moment_, scales_, time_, before_ ? &*before_ : nullptr};
}

// Coordinates without value, with a pose of free bodies and balls by the quaternion (1, a, b, c) / sqrt(1 + ...).
void FormulaInstant::open_positions() {
  const auto letter = [&](const std::string& name, const Dimension& dimension) {
    open_->made.push_back({name, si_unit(dimension), {}, true});
    return Formula::letter(name, poinsot::Sign::real);
  };
  for (const NamedCoordinate& coordinate : machine_.coordinates) {
    const auto k = static_cast<std::size_t>(coordinate.position);
    if (machine_.position_given[k] || (coordinate.name.empty() && !open_->all_poses)) continue;
    const Dimension dimension = coordinate.turning ? dimensions::angle : dimensions::length;
    machine_.q[k] =
        letter(coordinate.name.empty() ? "position of joint '" + coordinate.joint + "'" : coordinate.name, dimension);
  }
  if (!open_->all_poses) return;
  const Model<Formula>& tree = machine_.mechanism.tree;
  for (int i = 0; i < tree.body_count(); ++i) {
    const auto& body = tree.body(i);
    if (body.joint != JointType::ball && body.joint != JointType::free) continue;
    const auto q = static_cast<std::size_t>(body.q);
    if (machine_.position_given[q]) continue;
    const std::string owner = machine_.mechanism.coordinate_names[static_cast<std::size_t>(body.v)];
    Formula square(1);
    std::array<Formula, 3> part;
    for (std::size_t k = 0; k < 3; ++k) {
      part[k] = letter("pose " + std::to_string(k + 1) + " of " + owner, dimensions::none);
      square += part[k] * part[k];
    }
    const Formula length = sqrt(square);
    machine_.q[q] = Formula(1) / length;
    for (std::size_t k = 0; k < 3; ++k) machine_.q[q + 1 + k] = part[k] / length;
  }
}

void FormulaInstant::set_positions(const std::vector<const Instant*>& instants) {
  for (const Instant* instant : instants)
    for (const Fact& fact : instant->facts) {
      const Name* name = fact.quantity.as<Name>();
      const NamedCoordinate* coordinate = name && name->primes == 0 ? machine_.coordinate(name->name) : nullptr;
      if (!coordinate) continue;
      const auto k = static_cast<std::size_t>(coordinate->position);
      const Formula value = data_->number(fact.value, coordinate->turning ? dimensions::angle : dimensions::length);
      if (machine_.position_given[k] && !(machine_.q[k] - value).is_zero())
        remainders_.push_back(machine_.q[k] - value);
      machine_.q[k] = value;
      machine_.position_given[k] = true;
    }
  if (open_) open_positions();
  moment_->set_positions(machine_.q);
  // Loops are closed as drawn; where they do not stay so, the pose is found by Newton's method and has no formula.
  const auto& constraints = machine_.mechanism.constraints;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    if (!solve::binds_positions(constraints[i])) continue;
    const Formula gap =
        constraint_gap(machine_.mechanism.tree, moment_->workspace(), constraints[i], axis_left_free(constraints, i));
    if (!gap.is_zero()) throw NoFormula("the pose that closes " + constraints[i].words + " is found by numbers only");
  }
  solve::update_contacts(machine_.mechanism, *moment_);
  for (const auto& [fact, difference] : position_differences(view(), instants))
    if (!difference.value.is_zero()) remainders_.push_back(difference.value);
}

void FormulaInstant::solve_velocities() {
  std::vector<solve::ConditionOf<Formula>> conditions = rate_conditions(view());
  for (auto& condition : velocity_facts(view(), facts_)) conditions.push_back(std::move(condition));
  if (problem_.steady) add_steady(view(), conditions, false);
  const auto equations = solve::velocity_equations(*moment_, scales_, conditions);
  const auto open = [&](std::size_t k) {
    std::string name = equations.name(k);
    for (const NamedCoordinate& coordinate : machine_.coordinates)
      if (coordinate.velocity == static_cast<int>(k) && !coordinate.name.empty()) name = coordinate.name + "'";
    const bool turns = solve::coordinate_turns(machine_.mechanism.tree, static_cast<int>(k));
    open_->made.push_back({name, si_unit(turns ? dimensions::angular_velocity : dimensions::velocity), {}, true});
    return Formula::letter(name, poinsot::Sign::real);
  };
  solve::ExactSolution solution = open_ ? solve::solve_exactly(equations, open) : solve::solve_exactly(equations);
  remainders_.insert(remainders_.end(), solution.remainders.begin(), solution.remainders.end());
  v_ = std::move(solution.value);
  moment_->set_velocities(v_);
}

solve::ExactSolution FormulaInstant::solve_with_unfixed(const solve::LinearSystemOf<Formula>& equations) {
  if (!open_) return solve::solve_exactly(equations);
  return solve::solve_exactly(equations, [&](std::size_t k) {
    open_->unfixed.insert(equations.name(k));
    return Formula::letter(equations.name(k), poinsot::Sign::real);
  });
}

void FormulaInstant::solve_blow() {
  before_.emplace(*moment_);
  blow_ = stated_blow(view());
  std::vector<const Instant*> after;
  for (const Instant& instant : problem_.instants)
    if (instant.name == "after") after.push_back(&instant);
  const auto conditions = velocity_facts(view(), after);
  solve::ExactSolution solution =
      solve_with_unfixed(solve::impulse_equations(*before_, scales_, blow_, conditions, numbers_.blow_acting()));
  remainders_.insert(remainders_.end(), solution.remainders.begin(), solution.remainders.end());
  impulses_ = std::move(solution.value);
  v_.assign(impulses_.begin(),
            impulses_.begin() + static_cast<std::ptrdiff_t>(machine_.mechanism.tree.velocity_size()));
  moment_->set_velocities(v_);
}

void FormulaInstant::solve_forces() {
  if (forces_solved_) return;
  forces_solved_ = true;
  for (const VelocityConstraint<Formula>& constraint : machine_.mechanism.constraints)
    if (constraint.shape_unknown && !constraint.carried_by)
      throw NoFormula("how a point of contact moves is not known");
  std::vector<solve::ConditionOf<Formula>> conditions = force_facts(view(), facts_);
  if (problem_.steady) add_steady(view(), conditions, true);
  solve::ExactSolution solution = solve_with_unfixed(solve::motion_equations(*moment_, scales_, conditions));
  remainders_.insert(remainders_.end(), solution.remainders.begin(), solution.remainders.end());
  unknowns_ = std::move(solution.value);
  moment_->set_accelerations(std::vector<Formula>(
      unknowns_.begin(), unknowns_.begin() + static_cast<std::ptrdiff_t>(machine_.mechanism.tree.velocity_size())));
}

QuantityScope<Formula> FormulaInstant::scope_for(const Expression& expression, const std::optional<Expression>& axes,
                                                 const Elsewhere& elsewhere) {
  if (level_of(problem_, expression) >= Level::force) solve_forces();
  QuantityScope<Formula> quantities(machine_, machine_.mechanism.tree, *data_, State<Formula>{machine_.q, v_});
  if (forces_solved_) {
    quantities.set_accelerations(moment_->accelerations());
    quantities.set_forces(&*moment_, &unknowns_);
  }
  if (before_) quantities.set_blow(&*before_, &blow_, &impulses_);
  if (axes) quantities.set_axes(*axes);
  if (elsewhere) quantities.set_elsewhere(elsewhere);
  return quantities;
}

Value<Formula> FormulaInstant::raw(const Expression& expression, const std::optional<Expression>& axes,
                                   const Elsewhere& elsewhere) {
  return scope_for(expression, axes, elsewhere).value(expression);
}

Value<Formula> FormulaInstant::ask(const Expression& expression, const std::optional<Expression>& axes,
                                   const Elsewhere& elsewhere) {
  QuantityScope<Formula> quantities = scope_for(expression, axes, elsewhere);
  Value<Formula> value = quantities.value(expression);
  const auto on_axes = [&](const auto& self, Value<Formula>& v) -> void {
    if (v.is_vector()) v.vector = transpose_times(quantities.axes(), v.vector);
    for (Value<Formula>& item : v.items) self(self, item);
  };
  on_axes(on_axes, value);
  return value;
}

}  // namespace poinsot::statement
