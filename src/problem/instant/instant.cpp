#include "problem/instant/instant.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "poinsot/engine/solve/instant/closure.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/machine/contact_limits.h"
#include "problem/quantities/quantity_values.h"

namespace poinsot::problem {
namespace {

using Vector = Vector3<double>;

}  // namespace

SolvedInstant::SolvedInstant(const Situation& situation, const Settings& settings, const When& when,
                             const OpenChoice& choice)
    : situation_(situation), settings_(settings), choice_(choice) {
  build(0, situation.stages.empty() ? std::nullopt : situation.stages.front().loads);
  const auto instants = instants_at_start(situation);
  set_positions(instants);
  solve_velocities(instants, std::nullopt);
  if (when.after_blow) solve_blow();
}

Machine SolvedInstant::machine_at(double time, const std::optional<std::vector<std::string>>& loads) {
  if (elsewhen_)
    elsewhen_->set_time(time);
  else
    elsewhen_ = std::make_unique<DataScope<double>>(situation_, settings_, time);
  return machine_from(*elsewhen_, time, loads);
}

MachineOptions SolvedInstant::machine_options(double time, const std::optional<std::vector<std::string>>& loads) const {
  MachineOptions options;
  options.time = time;
  options.lenient = choice_.trial;
  options.particles = choice_.particles;
  options.loads = loads;
  options.open_contacts = whole_;
  if (choice_.gravity > 0) {
    std::mt19937_64 random(choice_.seed + 1);
    std::uniform_real_distribution<double> size(-choice_.gravity, choice_.gravity);
    options.open_gravity = {size(random), size(random), size(random)};
  }
  return options;
}

Machine SolvedInstant::machine_from(DataScope<double>& data, double time,
                                    const std::optional<std::vector<std::string>>& loads) {
  std::size_t next = 0;
  // Each time the machine is built, it must take the same values for what is open.
  const AnyValue any = [&](const Dimension&) {
    if (next == any_values_.size()) {
      const double value = choice_.any ? std::uniform_real_distribution<double>(0.5, 2)(random()) : 1;
      any_values_.push_back(value);
    }
    return any_values_[next++];
  };
  DataScope<TimeJet> timed(situation_, settings_, time_jet(time));
  const MachineOptions options = machine_options(time, loads);
  if (masses_) {
    next = any_in_masses_;
    return build_machine(situation_, *masses_, data, timed, any, options);
  }
  std::vector<BodyMassOf<double>> masses = body_masses(situation_, data, any, options);
  if (!data.follows_time()) {
    masses_ = masses;
    any_in_masses_ = next;
  }
  return build_machine(situation_, std::move(masses), data, timed, any, options);
}

void SolvedInstant::build(double time, const std::optional<std::vector<std::string>>& loads) {
  time_ = time;
  if (data_)
    data_->set_time(time);
  else
    data_ = std::make_unique<DataScope<double>>(situation_, settings_, time);
  machine_ = machine_from(*data_, time, loads);
  scales_ = choice_.scales ? *choice_.scales : solve::natural_scales(machine_.mechanism);
  mechanism_state_.emplace(machine_.mechanism);
  mechanism_state_->set_positions(machine_.q);
  motion_.reset();
}

// The instants stated for the start: that of the only state, of the first stage, or before a blow.
std::vector<const Instant*> instants_at_start(const Situation& situation) {
  std::vector<const Instant*> found;
  const auto add = [&](const Instant& instant) {
    if (!is_later(situation, instant)) found.push_back(&instant);
  };
  if (situation.has_blow()) {
    for (const Instant& instant : situation.instants) {
      if (instant.name != "before" && instant.name != "after" && !is_later(situation, instant))
        fail(situation.file, instant.mark,
             "the instants of a blow are called before and after, not '" + instant.name + "'",
             "write instants: {before: {...}} for what is known just before it");
      if (instant.name == "before") found.push_back(&instant);
    }
    return found;
  }
  if (situation.stages.empty()) {
    for (const Instant& instant : situation.instants) add(instant);
    if (found.size() > 1)
      fail(situation.file, found[1]->mark,
           "the instants '" + found[0]->name + "' and '" + found[1]->name +
               "' need a motion that leads from one to the other",
           "state one instant, call the later one by its time such as `2 s`, or name the stages between them");
    return found;
  }
  std::vector<std::string> names;
  for (const Stage& stage : situation.stages)
    names.insert(names.end(), {stage.name, stage.name + ".start", stage.name + ".end"});
  for (const Instant& instant : situation.instants) {
    const std::string& first = situation.stages.front().name;
    if (instant.name == "start" || instant.name == first || instant.name == first + ".start") {
      add(instant);
      continue;
    }
    if (is_later(situation, instant)) continue;
    const std::string hint = did_you_mean(instant.name, names);
    fail(situation.file, instant.mark, "there is no stage for the instant '" + instant.name + "'",
         hint.empty() ? "the start of a stage is called STAGE.start, its end STAGE.end" : hint);
  }
  return found;
}

// A fact about positions that is a mere name must name a coordinate. What others demand of positions is considered in
// position_facts().
void SolvedInstant::refuse_misnamed_positions(const std::vector<const Instant*>& instants) const {
  for (const Instant* instant : instants)
    for (const Fact& fact : instant->facts) {
      const Name* name = fact.quantity.as<Name>();
      if (!name || level_of(situation_, fact.quantity) != Level::position) continue;
      if (name->primes == 0 && machine_.coordinate(name->name)) continue;
      std::vector<std::string> names;
      for (const NamedCoordinate& c : machine_.coordinates)
        if (!c.name.empty()) names.push_back(c.name);
      fail(situation_.file, fact.mark, "'" + to_string(fact.quantity) + "' is no coordinate",
           did_you_mean(to_string(fact.quantity), names));
    }
}

void SolvedInstant::set_positions(const std::vector<const Instant*>& instants) {
  std::vector<double> q = machine_.q;
  std::vector<bool> given = machine_.position_given;
  refuse_misnamed_positions(instants);
  for_each_stated_position(machine_, instants, [&](const Fact& fact, const NamedCoordinate& coordinate) {
    const auto k = static_cast<std::size_t>(coordinate.position);
    const double value = stated_position(*data_, fact, coordinate);
    // The same value, written in another way, differs by the rounding of a few operations: of itself, and of a radian
    // or the length of the machine where it is what is left of larger ones. Ten times more would be another value to
    // a reader of twelve digits.
    const double size = std::abs(value) + (coordinate.turning ? 1 : scales_.length);
    if (given[k] && std::abs(q[k] - value) > 1e-12 * size)
      fail(situation_.file, fact.mark, "'" + coordinate.name + "' already has another value", "state it once");
    q[k] = value;
    given[k] = true;
  });
  const solve::Closure closure = solve::close_pose(machine_.mechanism, q, given);
  // Newton's method closes what can be closed to some 1e-14 of the machine's length. What stays open by more than this
  // part of it does not close; a part ten times larger would be what the check of constraints by geometry refuses.
  if (closure.relative > 1e-9) {
    Mark mark = situation_.joints.empty() ? Mark{1, 1} : situation_.joints.front().mark;
    for (const Joint& joint : situation_.joints)
      if (joint.name == machine_.constraint_joints[closure.constraint]) mark = joint.mark;
    for (const NamedCoordinate& coordinate : machine_.coordinates)
      if (given[static_cast<std::size_t>(coordinate.position)] && q[static_cast<std::size_t>(coordinate.position)] != 0)
        mark = coordinate.mark;
    fail(situation_.file, mark,
         "the mechanism does not close in the stated pose: " +
             machine_.mechanism.constraints[closure.constraint].words + " is open by " + with_digits(closure.gap, 3),
         "the values of the coordinates do not fit together, or no position of the others closes the loop");
  }
  machine_.q = closure.q;
  mechanism_state_->set_positions(machine_.q);
  solve::update_contacts(machine_.mechanism, *mechanism_state_);
  if (!choice_.trial)
    for (const ContactLimit& limit : machine_.contact_limits)
      if (left_of_surface(limit, *mechanism_state_).value_or(0) < -1e-9)
        fail(situation_.file, limit.mark, "in the stated pose " + words_of_end(limit),
             "correct the pose, or state the contact at the corner that touches there");
  position_facts(instants);
  position_misfits_ = misfits_.size();
}

void SolvedInstant::take_misfits(const solve::LinearSolution& solution) {
  misfits_.insert(misfits_.end(), solution.misfit.begin(), solution.misfit.end());
  misfit_size_ = std::max(misfit_size_, solution.size);
}

std::mt19937_64& SolvedInstant::random() {
  if (!random_) random_ = std::make_unique<std::mt19937_64>(choice_.seed);
  return *random_;
}

// Adds multiples of the open directions, which gives another solution of the equations.
void SolvedInstant::move_along(const solve::LinearSolution& solution, std::vector<double>& values, double pace) {
  for (std::size_t d = 0; d < solution.open.size(); ++d) {
    if (d != choice_.direction && choice_.direction != OpenChoice::every) continue;
    const double amount = std::uniform_real_distribution<double>(0.5, 2)(random());
    for (std::size_t k = 0; k < values.size(); ++k) values[k] += pace * amount * solution.open[d][k];
  }
}

void SolvedInstant::solve_velocities(const std::vector<const Instant*>& instants,
                                     const std::optional<std::vector<double>>& v) {
  facts_ = instants;
  if (v) {
    // The velocities are those at the end of the stage before. What is stated must still hold for them.
    v_ = *v;
    velocities_ = {};
    velocities_.value = v_;
    mechanism_state_->set_velocities(v_);
    return;
  }
  StatedConditions<double> stated = velocity_conditions(view(), instants);
  velocity_equations_ = solve::velocity_equations(*mechanism_state_, scales_, stated.linear);
  sources_[System::velocities] = std::move(stated.sources);
  velocities_ = velocity_equations_.solve();
  if (choice_.trial)
    take_misfits(velocities_);
  else if (!velocities_.conflict.empty())
    contradiction(System::velocities, velocities_);
  mechanism_state_->set_velocities(velocities_.value);
  hold_nonlinear(System::velocities, stated.nonlinear, velocities_);
  v_ = velocities_.value;
  if (choice_.velocities) {
    // The open velocities are as large as the known ones, so that neither drowns in the other's rounding.
    double pace = 0;
    for (std::size_t k = 0; k < v_.size(); ++k)
      pace = std::max(pace,
                      std::abs(v_[k]) /
                          (solve::coordinate_turns(machine_.mechanism.tree, static_cast<int>(k)) ? 1 : scales_.length));
    move_along(velocities_, v_, pace > 0 ? pace : 1);
  }
  mechanism_state_->set_velocities(v_);
}

QuantityScope<double> SolvedInstant::scope_for(const Expression& expression, const std::optional<Expression>& axes,
                                               const Elsewhere& elsewhere, const MotionFeatureValues& features) {
  // A question about the whole motion finds forces along the motion.
  const Call* call = expression.as<Call>();
  const bool of_motion = (call && is_motion_feature(*call)) || !asks_forces(situation_, expression);
  if (level_of(situation_, expression) >= Level::force && !(before_ && of_motion)) {
    try {
      solve_forces();
    } catch (const StatementError&) {
      // At the pole of Eulerian angles no forces can be found at the start. If something else is wrong the motion
      // reports it.
      if (!of_motion) throw;
    }
  }
  QuantityScope<double> quantities(machine_, before_ ? machine_.tree_after_blow() : machine_.mechanism.tree, *data_,
                                   State<double>{machine_.q, v_});
  if (!situation_.strikes.empty() && !moving_)
    quantities.set_flying(
        flying_particles(situation_, machine_, before_ ? *before_ : *mechanism_state_, before_ ? &blow_ : nullptr));
  if (motion_) {
    quantities.set_accelerations(mechanism_state_->accelerations());
    quantities.set_forces(&*mechanism_state_, &unknowns_);
  }
  if (before_) quantities.set_blow(&*before_, &blow_, &impulses_);
  if (writes_told_) quantities.set_told(&told_);
  if (axes) quantities.set_axes(*axes);
  if (elsewhere) quantities.set_elsewhere(elsewhere);
  quantities.set_motion_features(features);
  quantities.set_linearisation([this](const Mark& mark, bool with_shapes) -> const solve::Linearisation& {
    return linearisation(mark, with_shapes);
  });
  quantities.set_response(
      [this, axes](const Call& response_call, const Mark& mark) { return response(response_call, mark, axes); });
  return quantities;
}

Value<double> SolvedInstant::raw(const Expression& expression, const std::optional<Expression>& axes,
                                 const Elsewhere& elsewhere, const MotionFeatureValues& features) {
  return scope_for(expression, axes, elsewhere, features).value(expression);
}

Value<double> SolvedInstant::ask(const Expression& expression, const std::optional<Expression>& axes,
                                 const Elsewhere& elsewhere, const MotionFeatureValues& features) {
  QuantityScope<double> quantities = scope_for(expression, axes, elsewhere, features);
  Value<double> value = quantities.value(expression);
  const auto on_axes = [&](const auto& self, Value<double>& v) -> void {
    const Vector3<double> raw = v.vector;
    if (v.is_vector()) v.vector = transpose_times(quantities.axes(), v.vector);
    // A vector on the axes of a body rides with it: what stands on them, turned as the body is, is the vector.
    if (const Name* body = axes ? plain_name(*axes) : nullptr; body && writes_told_ && v.is_vector())
      told_.push_back({.kind = ToldQuantity::Kind::direction,
                       .body = machine_.index.at(body->name),
                       .first = v.vector,
                       .value = raw,
                       .words = "axes"});
    for (Value<double>& item : v.items) self(self, item);
  };
  on_axes(on_axes, value);
  return value;
}

double SolvedInstant::number(const Expression& expression, const std::optional<Expression>& axes) {
  return raw(expression, axes, nullptr).number;
}

double SolvedInstant::natural_size(const Dimension& d) const {
  // Only a quantity that grows with the pace of the motion has a natural size by which rounding is measured. At rest
  // there is none.
  if (d.time > 0) return 0;
  double pace = 0;
  for (const BodyMotion<double>& motion : mechanism_state_->workspace().motion) {
    pace = std::max({pace, norm(motion.w), norm(motion.v) / scales_.length});
    pace = std::max({pace, std::sqrt(norm(motion.alpha)), std::sqrt(norm(motion.a) / scales_.length)});
  }
  pace = std::max(pace, std::sqrt(norm(machine_.mechanism.tree.gravity()) / scales_.length));
  // Forces in balance set a pace too: that with which they would move the machine.
  if (motion_)
    for (std::size_t i = 0; i < machine_.mechanism.actions.size(); ++i) {
      const SpatialForce<double> wrench = solve::action_wrench(*mechanism_state_, unknowns_, i);
      const double force = std::max(norm(wrench.force), norm(wrench.moment) / scales_.length);
      pace = std::max(pace, std::sqrt(force / (scales_.mass * scales_.length)));
    }
  // What comes to rest in a blow had a pace before it, and impulses that cancel would have given one.
  if (before_) {
    for (const BodyMotion<double>& motion : before_->workspace().motion)
      pace = std::max({pace, norm(motion.w), norm(motion.v) / scales_.length});
    for (std::size_t i = 0; !impulses_.empty() && i < machine_.mechanism.actions.size(); ++i) {
      const SpatialForce<double> wrench = solve::action_impulse(*before_, blow_, impulses_, i);
      const double impulse = std::max(norm(wrench.force), norm(wrench.moment) / scales_.length);
      pace = std::max(pace, impulse / (scales_.mass * scales_.length));
    }
  }
  return natural_unit(d) * part_of_turning(d) * (d.time == 0 ? 1 : std::pow(pace, -d.time / 12.0));
}

std::optional<SolvedInstant::WayOfChange> SolvedInstant::way_of_change() const {
  std::optional<WayOfChange> way;
  double fastest = 0;
  constexpr double rounding = 1e-14;  // of v^2/a to the metre, that which balanced forces leave
  for (const BodyMotion<double>& motion : mechanism_state_->workspace().motion) {
    const double speed = norm(motion.v), push = norm(motion.a);
    if (!(speed > fastest) || !(push > rounding * speed * speed)) continue;
    fastest = speed;
    way = {speed * speed / push, dot(motion.v, motion.a) < 0};
  }
  return way;
}

// A body turns by couples that are nothing beside the moments of its way round a far center.
double SolvedInstant::part_of_turning(const Dimension& d) const {
  if (machine_.mechanism.attractions.empty() || d.length != 24) return 1;
  double largest = 0;
  for (const auto& body : machine_.mechanism.tree.bodies()) {
    const SpatialInertia<double>& I = body.inertia;
    if (!(I.mass > 0)) continue;
    const double spread = I.inertia.xx + I.inertia.yy + I.inertia.zz - 2 * norm_squared(I.first_moment) / I.mass;
    largest = std::max(largest, spread / (2 * I.mass));
  }
  return largest > 0 ? std::min(1.0, largest / (scales_.length * scales_.length)) : 1;
}

}  // namespace poinsot::problem
