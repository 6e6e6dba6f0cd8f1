#include "problem/formulas/formula_instant.h"

#include <algorithm>
#include <array>
#include <utility>

#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/math/formula/formula_decision.h"
#include "poinsot/engine/math/formula/formula_sizes.h"
#include "poinsot/engine/solve/instant/closure.h"
#include "problem/language/diagnostic.h"
#include "problem/language/scalar_value.h"
#include "problem/near/near_in_letters.h"
#include "problem/quantities/slip_constraint.h"
#include "problem/quantities/tooth_flanks.h"

namespace poinsot::problem {

FormulaInstant::FormulaInstant(const Situation& situation, const FormulaValues& values, const SolvedInstant& numbers,
                               OpenLetters* open, FormulaLinearSolve linear_solve)
    : situation_(situation), numbers_(numbers), open_(open), linear_solve_(std::move(linear_solve)) {
  const DecidedSizesScope lengths(decides_lengths());
  if (open_ && follows_time(situation)) {
    time_ = Formula::letter("time", poinsot::Sign::positive);
    open_->made.push_back({"time", si_unit(dimensions::time), {}});
  }
  data_ = std::make_unique<DataScope<Formula>>(situation, no_settings_, time_);
  DataScope<TimeJetOf<Formula>> timed(situation, no_settings_, time_jet(time_));
  for (const auto& [name, value] : values) {
    data_->vary(name, value);
    timed.vary(name, lifted<TimeJetOf<Formula>>(value));
  }
  MachineOptions options;
  if (!situation.stages.empty()) options.loads = situation.stages.front().loads;
  // Values given as `any`, and gravity of which nothing is said, have no influence on the answers that are given, so
  // that any number will do.
  const AnyValue any = [](const Dimension&) { return 1.0; };
  machine_ = build_machine(situation, *data_, timed, any, options);
  const DecidedSizesScope sizes(decides_sizes());
  scales_ = solve::natural_scales(machine_.mechanism);
  mechanism_state_.emplace(machine_.mechanism);
  mechanism_state_->set_positions(machine_.q);
  facts_ = instants_at_start(situation);
  set_positions(facts_);
  solve_velocities();
  if (numbers.after_blow()) solve_blow();
}

std::string letter_of_turn(const std::string& body, std::size_t axis) {
  return "tangent of half the turn of " + body + " along " + "xyz"[axis];
}

InstantView<Formula> FormulaInstant::view() const {
  return {situation_, *data_, machine_, *mechanism_state_, scales_, time_, before_ ? &*before_ : nullptr};
}

// On which side of a round body it touches is seen in the pose as drawn: the lowest point of a disk tilted by b lies
// r |cos(b)| below its center, which is r cos(b) for tilts like the one drawn. What is open for claims is any pose.
bool FormulaInstant::decides_sizes() const {
  return decides_lengths() ||
         (!open_ && std::ranges::any_of(machine_.mechanism.constraints,
                                        [](const VelocityConstraint<Formula>& c) { return moves_over_surfaces(c); }));
}

// So is the way of a cord from one wheel to the other side of another, sqrt(d^2 - (r + s)^2) long, which is h where
// it hangs straight down by h.
bool FormulaInstant::decides_lengths() const {
  return !open_ && (!situation_.belts.empty() || std::ranges::any_of(situation_.cords, &Cord::is_led));
}

// Makes letters of coordinates without value. The pose of a free body or ball has three: it is the quaternion (1, a,
// b, c) / sqrt(1 + a^2 + b^2 + c^2).
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
    Formula square(1);
    std::array<Formula, 3> part;
    for (std::size_t k = 0; k < 3; ++k) {
      part[k] = letter(letter_of_turn(tree.name(i), k), dimensions::none);
      square += part[k] * part[k];
    }
    const Formula length = sqrt(square);
    machine_.q[q] = Formula(1) / length;
    for (std::size_t k = 0; k < 3; ++k) machine_.q[q + 1 + k] = part[k] / length;
  }
}

// A free body may be anywhere, and where contacts and cords bind it, anywhere along them. Where these places lie in a
// plane or on a line, as on a floor or an incline, they are those at which all stays closed to first order; of cords
// and round surfaces they are not, and the pose has no formula.
void FormulaInstant::open_places() {
  const Model<Formula>& tree = machine_.mechanism.tree;
  const auto& constraints = machine_.mechanism.constraints;
  std::vector<std::size_t> places;
  std::vector<Formula> drawn, moved;
  std::map<std::string, Formula> unmoved;
  solve::LinearSystemOf<Formula> stays_closed;
  for (int i = 0; i < tree.body_count(); ++i) {
    const auto& body = tree.body(i);
    if (body.joint != JointType::free) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(body.q) + 4 + k;
      if (machine_.position_given[at]) continue;
      const std::string name = "place " + std::to_string(k + 1) + " of " + tree.name(i);
      places.push_back(at);
      drawn.push_back(machine_.q[at]);
      moved.push_back(Formula::letter(name, poinsot::Sign::real));
      unmoved[name] = Formula(0);
      stays_closed.add_unknown(name);
    }
  }
  if (places.empty()) return;
  const auto move_by = [&](const std::vector<Formula>& moves) {
    for (std::size_t k = 0; k < places.size(); ++k) machine_.q[places[k]] = drawn[k] + moves[k];
    mechanism_state_->set_positions(machine_.q);
  };
  move_by(moved);
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    if (!solve::binds_positions(constraints[i])) continue;
    const Formula gap =
        constraint_gap(tree, mechanism_state_->workspace(), constraints[i], axis_left_free(constraints, i));
    const std::size_t row = stays_closed.add_equation(constraints[i].words);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Formula slope = derivative(gap, std::string(stays_closed.name(k)));
      if (!slope.is_zero()) stays_closed.add(row, k, poinsot::substituted(slope, unmoved));
    }
  }
  move_by(solve::solve_exactly(stays_closed, [&](std::size_t k) {
            const std::string name(stays_closed.name(k));
            open_->made.push_back({name, si_unit(dimensions::length), {}, true});
            return Formula::letter(name, poinsot::Sign::real);
          }).value);
  if (!all_gaps_are_closed())
    throw NoFormula("the places to which contacts and cords let a body go are found by numbers only");
}

bool FormulaInstant::all_gaps_are_closed() const {
  const auto& constraints = machine_.mechanism.constraints;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    if (!solve::binds_positions(constraints[i])) continue;
    const Formula gap = constraint_gap(machine_.mechanism.tree, mechanism_state_->workspace(), constraints[i],
                                       axis_left_free(constraints, i));
    if (!gap.is_zero()) return false;
  }
  return true;
}

void FormulaInstant::set_positions(const std::vector<const Instant*>& instants) {
  for_each_stated_position(machine_, instants, [&](const Fact& fact, const NamedCoordinate& coordinate) {
    const auto k = static_cast<std::size_t>(coordinate.position);
    const Formula value = stated_position(*data_, fact, coordinate);
    if (machine_.position_given[k] && !(machine_.q[k] - value).is_zero()) remainders_.push_back(machine_.q[k] - value);
    machine_.q[k] = value;
    machine_.position_given[k] = true;
  });
  if (open_) open_positions();
  if (open_ && open_->all_places) open_places();
  mechanism_state_->set_positions(machine_.q);
  // Loops are closed in the pose as drawn. If they do not stay closed, the pose is found by Newton's method and has
  // no formula.
  const auto& constraints = machine_.mechanism.constraints;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    if (!solve::binds_positions(constraints[i])) continue;
    const Formula gap = constraint_gap(machine_.mechanism.tree, mechanism_state_->workspace(), constraints[i],
                                       axis_left_free(constraints, i));
    if (!gap.is_zero()) throw NoFormula("the pose that closes " + constraints[i].words + " is found by numbers only");
  }
  solve::update_contacts(machine_.mechanism, *mechanism_state_);
  for (const auto& [fact, difference] : position_differences(view(), instants))
    if (!difference.value.is_zero()) remainders_.push_back(difference.value);
}

void FormulaInstant::solve_velocities() {
  const StatedConditions<Formula> stated = velocity_conditions(view(), facts_);
  const auto equations = solve::velocity_equations(*mechanism_state_, scales_, stated.linear);
  const auto open = [&](std::size_t k) {
    std::string name(equations.name(k));
    for (const NamedCoordinate& coordinate : machine_.coordinates)
      if (coordinate.velocity == static_cast<int>(k) && !coordinate.name.empty()) name = coordinate.name + "'";
    const bool turns = solve::coordinate_turns(machine_.mechanism.tree, static_cast<int>(k));
    open_->made.push_back({name, si_unit(turns ? dimensions::angular_velocity : dimensions::velocity), {}, true});
    return Formula::letter(name, poinsot::Sign::real);
  };
  solve::ExactSolution solution = open_ ? solve::solve_exactly(equations, open) : solved(equations);
  remainders_.insert(remainders_.end(), solution.remainders.begin(), solution.remainders.end());
  v_ = v_before_ = std::move(solution.value);
  present_.reset();
  mechanism_state_->set_velocities(v_);
  hold_nonlinear(stated.nonlinear);
}

// Facts that are not linear leave a remainder, once the state that they speak of is solved.
void FormulaInstant::hold_nonlinear(const std::vector<const Fact*>& facts) {
  const Elsewhere earlier = [this](const At& past, const Mark& mark) {
    if (past.instant != "before" || !before_)
      fail(situation_.file, mark, "a fact can look back to `before` a blow only, not to '" + past.instant + "'");
    QuantityScope<Formula> scope(machine_, machine_.mechanism.tree, *data_, before_->state());
    scope.set_flying(flying_particles<Formula>(situation_, machine_, *before_, nullptr));
    return scope.value(past.expression);
  };
  for (const Fact* fact : facts) {
    QuantityScope<Formula> scope = scope_for(fact->quantity, std::nullopt, earlier);
    for (const Difference<Formula>& difference : differences(*fact, scope, situation_.file))
      if (!difference.value.is_zero()) remainders_.push_back(difference.value);
  }
}

solve::ExactSolution FormulaInstant::solved(const solve::LinearSystemOf<Formula>& equations) const {
  return linear_solve_ ? linear_solve_(equations) : solve::solve_exactly(equations);
}

solve::ExactSolution FormulaInstant::solve_with_unfixed(const solve::LinearSystemOf<Formula>& equations) {
  if (!open_) return solved(equations);
  return solve::solve_exactly(equations, [&](std::size_t k) {
    const std::string name(equations.name(k));
    open_->unfixed.insert(name);
    return Formula::letter(name, poinsot::Sign::real);
  });
}

void FormulaInstant::solve_blow() {
  before_.emplace(*mechanism_state_);
  blow_ = stated_blow(view());
  const std::optional<RoughBlow>& rough = numbers_.rough_blow();
  if (rough && rough->form == RoughBlow::Form::numbers)
    throw NoFormula("a blow with friction is followed by numbers where the slip turns, or stops and the push moves it");
  if (rough) put_friction(blow_, *before_, *rough);
  put_flanks(machine_.mechanism, numbers_.blow_flanks());
  const StatedConditions<Formula> stated = blow_conditions(view(), blow_);
  solve::ExactSolution solution =
      solve_with_unfixed(solve::impulse_equations(*before_, scales_, blow_, stated.linear, numbers_.blow_acting()));
  remainders_.insert(remainders_.end(), solution.remainders.begin(), solution.remainders.end());
  impulses_ = std::move(solution.value);
  note_flanks(impulses_);
  note_who_acts();
  v_.assign(impulses_.begin(),
            impulses_.begin() + static_cast<std::ptrdiff_t>(machine_.mechanism.tree.velocity_size()));
  present_.reset();
  mechanism_state_->set_velocities(v_);
  if (rough) note_rough_blow(*rough);
  hold_nonlinear(stated.nonlinear);
}

// The numbers decide how the point that is struck slips. With letters its form must hold in general, and its borders
// are noted: a slip along one line changes evenly with the push, so that it keeps its sense where it has it at both
// ends; one that the push does not move vanishes where its friction has been less than mu times the push.
void FormulaInstant::note_rough_blow(const RoughBlow& rough) const {
  using Form = RoughBlow::Form;
  using Vector = Vector3<Formula>;
  const auto none = [](const Vector& v) { return v.x.is_zero() && v.y.is_zero() && v.z.is_zero(); };
  const solve::ImpactOf<Formula>& impact = blow_.impacts[rough.impact];
  const std::size_t push = impulses_.size() - blow_.impacts.size() + rough.impact;
  const Vector n = before_->direction(impact.push);
  const auto across = [&](const Vector& u) { return Vector(u - dot(u, n) * n); };
  const Vector comes = impact_velocity(*before_, impact), slip = across(comes),
               left = across(impact_velocity(*mechanism_state_, impact));
  note_sign(dot(comes, n));
  note_sign(impulses_[push]);
  if (rough.form == Form::slides) {
    if (!none(cross(slip, left))) throw NoFormula("the slip turns in the blow, which is followed by numbers");
    note_sign(dot(slip, left));
    return;
  }
  solve::MechanismStateOf<Formula> struck = *before_;
  struck.set_velocities(std::vector<Formula>(v_.size()));
  solve::BlowOf<Formula> unit;
  unit.held_coordinates = blow_.held_coordinates;
  unit.impacts.push_back(impact);
  unit.impacts.front().given = Formula(1);
  std::vector<Formula> moved =
      solved(solve::impulse_equations(struck, scales_, unit, {}, numbers_.blow_acting())).value;
  moved.resize(v_.size());
  struck.set_velocities(moved);
  if (!none(left) || !none(across(impact_velocity(struck, impact))) || (rough.form == Form::still && !none(slip)))
    throw NoFormula("with other letters the point slips in the blow otherwise than with these");
  if (rough.form == Form::stops) note_sign(*impact.friction * impulses_[push] - impulses_[push + 1]);
}

// The numbers decide which cords and contacts act in the blow. This records the assumption for each: that those that
// act pull or push, and that the others part.
void FormulaInstant::note_who_acts() const {
  const Mechanism<Formula>& mechanism = machine_.mechanism;
  const auto n = static_cast<std::size_t>(mechanism.tree.velocity_size());
  const std::vector<bool>& acting = numbers_.blow_acting();
  for (std::size_t k = 0; k < mechanism.components.size(); ++k)
    if (mechanism.components[k].one_sided && acting[static_cast<std::size_t>(mechanism.components[k].action)])
      note_sign(impulses_[n + k]);
  for (const VelocityConstraint<Formula>& constraint : mechanism.constraints) {
    if (constraint.action < 0 || acting[static_cast<std::size_t>(constraint.action)]) continue;
    // What has parted may slip either way.
    if (against_slipping(mechanism, constraint)) continue;
    const std::vector<Formula> row = solve::constraint_coefficients(*before_, constraint);
    Formula rate;
    for (std::size_t k = 0; k < n; ++k) rate += row[k] * impulses_[k];
    note_sign(rate);
  }
}

void FormulaInstant::solve_forces() {
  if (!forces_solved_) {
    if (!no_forces_.empty()) throw NoFormula(no_forces_);
    forces_solved_ = true;
    std::optional<DecisionScope> decisions;
    if (notes_decisions()) decisions.emplace();
    const DecidedSizesScope sizes(decides_sizes());
    try {
      find_forces();
    } catch (const std::exception& error) {
      forces_solved_ = false;
      no_forces_ = error.what();
      throw;
    }
    if (decisions) signs_of_forces_ = decisions->signs();
    if (decisions && decisions->zeros_by_digits()) forces_by_digits_ = true;
  }
  // Whoever asks for forces rests on these, whether they are solved for it or were before.
  for (const Formula& sign : signs_of_forces_) note_sign(sign);
  if (forces_by_digits_) note_zero_by_digits();
}

// The numbers decide which flanks of teeth carry.
void FormulaInstant::take_flanks() {
  const Mechanism<double>& numbers = numbers_.machine().mechanism;
  if (std::ranges::none_of(machine_.mechanism.components, &Component<Formula>::parts_wheels)) return;
  if (!numbers_.forces_solved() || numbers.components.size() != machine_.mechanism.components.size())
    throw NoFormula("which flanks of teeth carry is found by numbers");
  put_flanks(machine_.mechanism, flanks_of(numbers));
  turn_against_slip(machine_, *mechanism_state_);
}

// This records the assumption for each: that the force that turns the wheels keeps its sign.
void FormulaInstant::note_flanks(const std::vector<Formula>& unknowns) const {
  const auto n = static_cast<std::size_t>(machine_.mechanism.tree.velocity_size());
  for (const Component<Formula>& component : machine_.mechanism.components)
    if (component.parts_wheels && component.flank != 0)
      note_sign(unknowns[n + static_cast<std::size_t>(component.follows)]);
}

// Of joints whose friction follows from what they carry, while they move: which way what presses points, V/|V|, is that
// without friction where it does not turn with the friction. Where it does for a single joint, V = V0 + M V1, the
// friction M along its slip is the negative root of the quadratic M^2 = m^2 |V0 + M V1|^2.
void FormulaInstant::find_pressing() {
  std::vector<std::size_t> moving;
  for (std::size_t k = 0; k < machine_.rough_contacts.size(); ++k)
    if (machine_.rough_contacts[k].found_with_reactions()) moving.push_back(k);
  if (moving.empty()) return;
  using Pressing = std::vector<std::vector<Vector3<Formula>>>;
  const auto pressing_now = [&] {
    const StatedConditions<Formula> stated = force_conditions(view(), facts_, true);
    const std::vector<Formula> unknowns =
        solved(solve::motion_equations(*mechanism_state_, scales_, stated.linear)).value;
    Pressing all;
    for (const std::size_t k : moving)
      all.push_back(pressing_in(*mechanism_state_, unknowns, machine_.rough_contacts[k]));
    return all;
  };
  const auto vanishes = [](const Vector3<Formula>& v) { return v.x.is_zero() && v.y.is_zero() && v.z.is_zero(); };
  const Pressing without = pressing_now();
  for (std::size_t i = 0; i < moving.size(); ++i)
    for (std::size_t part = 0; part < without[i].size(); ++part) {
      const Vector3<Formula>& V = without[i][part];
      if (vanishes(V)) continue;
      auto& toward = machine_.rough_contacts[moving[i]].pressing[part].toward;
      // Along an axis it has the sense of the numbers, which the conditions of the state tell.
      const auto& in_numbers = numbers_.machine().rough_contacts[moving[i]].pressing[part].toward;
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (in_numbers && vanishes(cross(V, Vector3<Formula>::unit(axis))))
          toward = Formula((*in_numbers)[axis] < 0 ? -1 : 1) * Vector3<Formula>::unit(axis);
      if (!toward) toward = V / sqrt(dot(V, V));
    }
  const Pressing with = pressing_now();
  bool turns = false;
  for (std::size_t i = 0; i < moving.size(); ++i)
    for (std::size_t part = 0; part < with[i].size(); ++part) {
      const auto& toward = machine_.rough_contacts[moving[i]].pressing[part].toward;
      turns = turns || !vanishes(toward ? cross(with[i][part], *toward) : with[i][part]);
    }
  if (!turns) return;
  RoughContactOf<Formula>& contact = machine_.rough_contacts[moving.front()];
  if (moving.size() > 1 || contact.pressing.size() != 1)
    throw NoFormula("what joint '" + contact.name + "' carries turns with its friction");
  contact.pressing.front().toward.reset();
  contact.friction_known = Formula(1);
  const Vector3<Formula> V0 = without.front().front(), V1 = pressing_now().front().front() - V0;
  const Formula m = contact.sliding * contact.sliding, a = Formula(1) - m * dot(V1, V1), b = m * dot(V0, V1),
                root = sqrt(b * b + a * m * dot(V0, V0));
  contact.friction_known = (b - root) / a;
  note_sign(a);
}

void FormulaInstant::find_forces() {
  if (before_ && std::ranges::find(numbers_.blow_acting(), false) != numbers_.blow_acting().end())
    throw NoFormula("what gives way in the blow carries nothing just after it");
  for (const VelocityConstraint<Formula>& constraint : machine_.mechanism.constraints)
    if (constraint.shape_unknown && !constraint.carried_by)
      throw NoFormula("how a point of contact moves is not known");
  take_flanks();
  find_pressing();
  const StatedConditions<Formula> stated = force_conditions(view(), facts_, true);
  solve::ExactSolution solution =
      solve_with_unfixed(solve::motion_equations(*mechanism_state_, scales_, stated.linear));
  note_flanks(solution.value);
  remainders_.insert(remainders_.end(), solution.remainders.begin(), solution.remainders.end());
  unknowns_ = std::move(solution.value);
  mechanism_state_->set_accelerations(std::vector<Formula>(
      unknowns_.begin(), unknowns_.begin() + static_cast<std::ptrdiff_t>(machine_.mechanism.tree.velocity_size())));
  hold_nonlinear(stated.nonlinear);
}

const QuantityScope<Formula>& FormulaInstant::present_scope() {
  const bool noted = notes_decisions();
  if (!present_ || present_->with_forces != forces_solved_ || present_->noted != noted) {
    std::optional<DecisionScope> decisions;
    if (noted) decisions.emplace();
    const DecidedSizesScope sizes(decides_sizes());
    QuantityScope<Formula> scope(machine_, before_ ? machine_.tree_after_blow() : machine_.mechanism.tree, *data_,
                                 State<Formula>{machine_.q, v_});
    if (!situation_.strikes.empty())
      scope.set_flying(
          flying_particles(situation_, machine_, before_ ? *before_ : *mechanism_state_, before_ ? &blow_ : nullptr));
    if (forces_solved_) {
      scope.set_accelerations(mechanism_state_->accelerations());
      scope.set_forces(&*mechanism_state_, &unknowns_);
    }
    present_.emplace(Present{forces_solved_, noted, std::move(scope), {}, false});
    if (decisions) {
      present_->signs = decisions->signs();
      present_->zeros_by_digits = decisions->zeros_by_digits();
    }
  }
  for (const Formula& sign : present_->signs) note_sign(sign);
  if (present_->zeros_by_digits) note_zero_by_digits();
  return present_->scope;
}

QuantityScope<Formula> FormulaInstant::scope_for(const Expression& expression, const std::optional<Expression>& axes,
                                                 const Elsewhere& elsewhere) {
  if (level_of(situation_, expression) >= Level::force) solve_forces();
  QuantityScope<Formula> quantities = present_scope();
  if (before_) quantities.set_blow(&*before_, &blow_, &impulses_);
  if (axes) quantities.set_axes(*axes);
  if (elsewhere) quantities.set_elsewhere(elsewhere);
  if (!before_)
    quantities.set_near_in_letters([this](const Call& call, const Mark&) {
      return near_in_letters({situation_, *data_, machine_, machine_.q, v_, numbers_.machine()}, call);
    });
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

}  // namespace poinsot::problem
