#include "statement/problem_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "poinsot/motion/integrate.h"
#include "poinsot/motion/lone_body.h"
#include "poinsot/motion/mechanism_dynamics.h"
#include "statement/absorbed_particles.h"
#include "statement/lost_contact.h"
#include "statement/massless_turning.h"
#include "statement/motion_features.h"
#include "statement/reader.h"

namespace poinsot::statement {
namespace {

constexpr std::int64_t most_steps = 400'000;

}  // namespace

ProblemMotion::ProblemMotion(const Problem& problem, const Settings& settings, const OpenChoice& choice)
    : stated_(problem),
      changed_(with_absorbed_particles(problem)),
      problem_(changed_ ? *changed_ : problem),
      settings_(settings),
      choice_(choice),
      timed_(follows_time(problem)) {
  start_ = std::make_unique<SolvedInstant>(problem, settings, When{0, problem.has_blow()}, choice);
  std::vector<std::vector<double>> open = start_->velocities().open;
  const std::vector<std::vector<double>> moving_nothing = take_massless(start_->machine(), open);
  if (!choice.trial && !choice.velocities && !open.empty())
    fail(problem.file, mark_of(0),
         "the motion at the start of " + words_of(0) + " is not fixed: " +
             start_->velocity_equations().name(start_->velocities().share.front().front()) + " is unknown",
         "state it under instants: {start: {...}}");
  stages_.resize(std::max<std::size_t>(1, problem.stages.size()));
  StageRun& first = stages_.front();
  MotionState state = start_->state();
  remove_components(moving_nothing, state.v);
  if (start_->after_blow()) state.acting = start_->blow_acting();
  if (changed_) start_ = std::make_unique<SolvedInstant>(problem_, settings, state, choice);
  if (!state.acting.empty()) state.acting.resize(start_->machine().mechanism.actions.size());
  // A small push where the undisturbed motion would stay.
  for (const Instant& instant : problem.instants)
    for (const auto& [name, mark] : instant.nudged) {
      const NamedCoordinate* coordinate = start_->machine().coordinate(name);
      if (!coordinate) {
        std::vector<std::string> names;
        for (const NamedCoordinate& c : start_->machine().coordinates)
          if (!c.name.empty()) names.push_back(c.name);
        fail(problem.file, mark, "'" + name + "' is no coordinate", did_you_mean(name, names));
      }
      constexpr double nudge = 1e-7;
      state.q[static_cast<std::size_t>(coordinate->position)] +=
          nudge * (coordinate->turning ? 1 : start_->natural_size(dimensions::length));
    }
  first.q = state.q;
  first.v = state.v;
  if (std::ranges::find(state.acting, false) != state.acting.end()) {
    first.pieces.emplace_back();
    first.acting.push_back(state.acting);
  }
  probe_ = std::make_unique<SolvedInstant>(problem_, settings, state, choice);
  // From rest, the loads set the pace.
  SolvedInstant pushed(problem_, settings, state, choice);
  pushed.solve_forces();
  const double pace = pushed.pace();
  pace_time_ = pace > 0 ? 1 / pace : 1;
}

ProblemMotion::~ProblemMotion() = default;

const Mark& ProblemMotion::mark_of(std::size_t stage) const {
  static const Mark beginning{1, 1};
  return stage < problem_.stages.size() ? problem_.stages[stage].mark
         : problem_.instants.empty()    ? beginning
                                        : problem_.instants.front().mark;
}
std::string ProblemMotion::words_of(std::size_t stage) const {
  return stage < problem_.stages.size() ? "stage '" + problem_.stages[stage].name + "'" : "the motion";
}

double ProblemMotion::reached() const {
  double time = 0;
  for (const StageRun& stage : stages_)
    if (stage.begun) time = std::max(time, stage.time);
  return time;
}

bool ProblemMotion::followed_enough(double until) const {
  constexpr std::size_t enough = 100'000;  // steps
  std::size_t steps = 0;
  for (const StageRun& stage : stages_)
    for (const Trajectory& piece : stage.pieces)
      if (!piece.empty() && piece.start_time() < until) steps += piece.step_count();
  return (steps >= enough && until >= reached()) || until > 1e6 * pace_time_;
}

void ProblemMotion::begin(std::size_t stage) {
  StageRun& now = stages_[stage];
  if (now.begun) return;
  if (stage > 0) {
    begin(stage - 1);
    StageRun& before = stages_[stage - 1];
    if (!before.done) run(stage - 1, before.end ? *before.end : std::numeric_limits<double>::infinity());
    now.start = *before.end;
    now.q = before.q;
    now.v = before.v;
  }
  now.begun = true;
  now.time = now.start;
  if (stage >= problem_.stages.size()) return;
  const Stage& stated = problem_.stages[stage];
  if (stated.lasts) {
    const double duration = start_->data_number(*stated.lasts, dimensions::time);
    if (!(duration >= 0)) fail(problem_.file, stated.lasts->mark(), "a stage lasts no negative time");
    now.end = now.start + duration;
    if (duration == 0) now.done = true;
  } else if (!stated.until && stage + 1 < problem_.stages.size()) {
    fail(problem_.file, stated.mark, "stage '" + stated.name + "' does not say how long it lasts",
         "write lasts: 2 s, or until: theta == 30 deg");
  }
}

double ProblemMotion::stage_start(std::size_t stage) {
  begin(stage);
  return stages_[stage].start;
}

std::optional<double> ProblemMotion::stage_end(std::size_t stage) {
  begin(stage);
  if (!stages_[stage].end && stage < problem_.stages.size() && problem_.stages[stage].until)
    run(stage, std::numeric_limits<double>::infinity());
  return stages_[stage].end;
}

// Integrates a stage up to a time, or up to the event that ends it.
void ProblemMotion::run(std::size_t stage, double until) {
  begin(stage);
  StageRun& now = stages_[stage];
  const bool by_event = stage < problem_.stages.size() && problem_.stages[stage].until.has_value();
  // Towards an event in growing spans, until it happens or the motion has been followed long enough.
  double span = 20 * pace_time_;
  double target = now.end ? std::min(until, *now.end) : by_event ? std::min(until, now.time + span) : until;
  int changes = 0;
  while (!now.done && now.time < target) {
    if (now.slips) throw_slip(now);
    std::vector<bool> acting = now.acting.empty() ? std::vector<bool>() : now.acting.back();
    const std::optional<std::vector<std::string>> loads =
        stage < problem_.stages.size() ? problem_.stages[stage].loads : std::nullopt;
    Machine machine = start_->machine_at(now.time, loads);
    for (VelocityConstraint<double>& constraint : machine.mechanism.constraints) {
      constraint.carried_by.reset();
      if (constraint.shape_unknown)
        fail(problem_.file, mark_of(stage),
             "how a contact moves is not known (" + constraint.words +
                 "): the surfaces there are no circle, sphere or corner on a plane",
             "give the body a round shape");
    }
    if (acting.empty()) acting.assign(machine.mechanism.actions.size(), true);
    std::vector<int> held;
    for (const StatedRate& rate : machine.accelerations) held.push_back(rate.velocity);
    MechanismDynamics dynamics(machine.mechanism, held);
    const auto refresh = [&](double time) {
      if (!timed_) return;
      const Machine then = start_->machine_at(time, loads);
      for (const StatedRate& rate : then.accelerations) dynamics.set_held_acceleration(rate.velocity, rate.value);
      for (std::size_t i = 0; i < then.mechanism.forces.size(); ++i)
        dynamics.set_force(i, then.mechanism.forces[i].vector);
      for (std::size_t i = 0; i < then.mechanism.drives.size(); ++i)
        dynamics.set_effort(i, then.mechanism.drives[i].effort);
    };
    for (const StatedRate& rate : machine.accelerations) dynamics.set_held_acceleration(rate.velocity, rate.value);
    const auto set_acting = [&] {
      for (std::size_t i = 0; i < acting.size(); ++i) dynamics.set_acting(static_cast<int>(i), acting[i]);
    };
    set_acting();
    std::vector<MasslessSpin> spins;
    // The turning of a particle, or of a rod about its own line, moves nothing: it rests.
    while (const std::optional<int> massless = massless_coordinate(machine, dynamics.open_coordinates(now.q))) {
      held.push_back(*massless);
      const std::optional<MasslessSpin> spin = massless_spin(machine, *massless);
      if (spin && spin->alone) spins.push_back(*spin);
      dynamics = MechanismDynamics(machine.mechanism, held);
      for (const StatedRate& rate : machine.accelerations) dynamics.set_held_acceleration(rate.velocity, rate.value);
      set_acting();
    }
    // What a body does by itself needs no coordinates that are good everywhere: Eulerian angles may start at their
    // pole.
    const bool given_motion = timed_ || !machine.accelerations.empty();
    const std::optional<LoneBody> lone = given_motion ? std::nullopt : LoneBody::find(machine.mechanism);
    for (const OpenCoordinate& open : lone ? std::vector<OpenCoordinate>() : dynamics.open_coordinates(now.q))
      fail(problem_.file, mark_of(stage),
           words_of(stage) + " is not determined: nothing fixes the " +
               machine.mechanism.coordinate_names[static_cast<std::size_t>(open.coordinate)] +
               (open.without_inertia ? ", which moves no mass" : ""),
           "say what drives it, give it mass, or hold it");

    MotionEquations equations;
    equations.position_size = machine.mechanism.tree.position_size();
    equations.velocity_size = machine.mechanism.tree.velocity_size();
    const Model<double>& tree = machine.mechanism.tree;
    equations.position_rate = [&](double, std::span<const double> q, std::span<const double> v,
                                  std::span<double> rate) { position_rate<double>(tree, q, v, rate); };
    equations.accelerations = [&](double time, std::span<const double> q, std::span<const double> v,
                                  std::span<double> a) {
      refresh(time);
      dynamics.accelerations(q, v, a);
      for (const MasslessSpin& spin : spins) take_out(spin, a);
    };
    if (!machine.mechanism.constraints.empty())
      equations.project = [&](double, std::span<double> q, std::span<double> v) { dynamics.project(q, v); };
    const double length = start_->natural_size(dimensions::length);
    for (const auto& body : tree.bodies()) {
      const int size = position_size(body.joint);
      if (size > 1) equations.quaternions.push_back(body.q);
      for (int k = 0; k < size; ++k) {
        const bool shift = body.joint == JointType::prismatic || (body.joint == JointType::free && k >= 4);
        equations.position_sizes.push_back(shift ? length : 1);
      }
    }
    const bool conserves =
        !timed_ && machine.accelerations.empty() && machine.mechanism.forces.empty() &&
        std::none_of(machine.mechanism.drives.begin(), machine.mechanism.drives.end(),
                     [](const Drive<double>& drive) { return drive.damping != 0 || drive.effort != 0; }) &&
        std::none_of(machine.mechanism.springs.begin(), machine.mechanism.springs.end(),
                     [](const SpringLaw<double>& spring) { return spring.damping != 0; });
    if (conserves)
      equations.conserved.push_back({"energy", [&](double, std::span<const double> q, std::span<const double> v) {
                                       return dynamics.kinetic_energy(q, v) + dynamics.potential_energy(q);
                                     }});

    std::vector<Event> events;
    std::vector<std::size_t> event_action;
    std::vector<double> a(static_cast<std::size_t>(equations.velocity_size));
    bool released = false;
    double until_size = 0;
    if (by_event) {
      const Comparison* comparison = problem_.stages[stage].until->as<Comparison>();
      if (!comparison || comparison->operands.size() != 2)
        fail(problem_.file, problem_.stages[stage].until->mark(), "the event that ends a stage is a comparison",
             "write until: theta == 30 deg");
      const Relation relation = comparison->relations.front();
      const int sense = relation == Relation::less || relation == Relation::less_equal         ? -1
                        : relation == Relation::greater || relation == Relation::greater_equal ? 1
                                                                                               : 0;
      Event event;
      event.name = "until";
      event.terminal = true;
      event.value = [&, comparison](double time, std::span<const double> q, std::span<const double> v) {
        probe_->move_to({time, stage, {q.begin(), q.end()}, {v.begin(), v.end()}, acting});
        const double left = probe_->number(comparison->operands[0], std::nullopt),
                     right = probe_->number(comparison->operands[1], std::nullopt);
        until_size = std::max({until_size, std::abs(left), std::abs(right)});
        return left - right;
      };
      // It may have been met just where the motion was followed to before.
      for (const Trajectory& piece : now.pieces) {
        if (piece.empty()) continue;
        const State<double> before = piece.state(piece.start_time());
        event.value(piece.start_time(), before.q, before.v);  // for the size of what is compared
      }
      const double left = std::abs(event.value(now.time, now.q, now.v));
      if (now.time == now.start && sense * event.value(now.time, now.q, now.v) > 1e-11 * until_size)
        throw UnansweredError(problem_.file, problem_.stages[stage].until->mark(),
                              "what ends " + words_of(stage) + " holds from its start on",
                              "turn the comparison round, or leave the stage out");
      if (now.time > now.start && left <= 1e-11 * until_size) {
        now.end = now.time;
        now.done = true;
        return;
      }
      events.push_back(std::move(event));
      event_action.push_back(machine.mechanism.actions.size());
    }
    for (std::size_t k = 0; k < machine.mechanism.components.size(); ++k) {
      const Component<double>& component = machine.mechanism.components[k];
      const auto action = static_cast<std::size_t>(component.action);
      if (!component.one_sided) continue;
      Event event;
      event.terminal = true;
      if (acting[action]) {
        event.name = "slack";
        event.crossing = Crossing::falling;
        event.size = start_->natural_size(dimensions::force);
        event.value = [&, k](double time, std::span<const double> q, std::span<const double> v) {
          refresh(time);
          dynamics.accelerations(q, v, a);
          return dynamics.component_force(k);
        };
        // One that would have to pull or push the wrong way from the start on does not act at all.
        if (event.value(now.time, now.q, now.v) < -1e-9 * event.size) {
          if (would_press_in(dynamics, action, now.q, now.v, pace_time_)) slips(stage, action, now);
          change_holds(stage, action, acting, now);
          now.acting.push_back(acting);
          now.pieces.emplace_back();
          ++changes;
          released = true;
          break;
        }
      } else {
        const auto constraint = std::find_if(machine.mechanism.constraints.begin(), machine.mechanism.constraints.end(),
                                             [&](const VelocityConstraint<double>& c) {
                                               return c.action == component.action &&
                                                      (c.normal || c.kind == VelocityConstraintKind::cord_length);
                                             });
        if (constraint == machine.mechanism.constraints.end()) continue;
        const auto index = static_cast<std::size_t>(constraint - machine.mechanism.constraints.begin());
        const bool cord = constraint->kind == VelocityConstraintKind::cord_length;
        event.name = "taut";
        event.crossing = cord ? Crossing::rising : Crossing::falling;
        event.size = length;
        event.value = [&, index](double, std::span<const double> q, std::span<const double>) {
          return dynamics.gap(index, q);
        };
      }
      events.push_back(std::move(event));
      event_action.push_back(action);
    }
    if (changes > 1000)
      fail(problem_.file, mark_of(stage),
           "cords and contacts give way and catch again without end in " + words_of(stage));
    if (released) continue;
    IntegrationOptions options;
    options.tolerance = tolerance_;
    options.most_steps = most_steps;
    options.seconds = most_seconds_;
    const double end = std::min(target, now.end.value_or(target));
    std::optional<IntegrationResult> by_itself;
    if (lone) {
      options.largest_step = pace_time_;
      by_itself = lone->follow(equations, now.time, now.q, now.v, end, options, events);
      options.largest_step = 0;
    }
    const IntegrationResult result =
        by_itself ? *by_itself : integrate(equations, now.time, now.q, now.v, end, options, events);
    methods_.insert(result.method);
    if (result.ending == Ending::step_limit)
      throw UnansweredError(problem_.file, mark_of(stage),
                            words_of(stage) + " moves too much to be followed farther than " +
                                std::to_string(result.time) + " s: that took " + std::to_string(most_steps) + " steps",
                            "ask for earlier times");
    if (!result.complete())
      throw UnansweredError(problem_.file, mark_of(stage),
                            words_of(stage) + " cannot be followed: " + poinsot::describe(result),
                            "let it last shorter");
    if (!result.drift.empty()) {
      const double size = std::max(std::abs(result.drift[0].start), dynamics.kinetic_energy(result.q, result.v));
      energy_drift_ = std::max(energy_drift_.value_or(0), size > 0 ? result.drift[0].largest / size : 0);
    }
    now.pieces.push_back(result.trajectory);
    now.acting.push_back(acting);
    now.q = result.q;
    now.v = result.v;
    now.time = result.time;
    if (result.ending == Ending::terminal_event) {
      const std::size_t event = result.hits.back().event;
      if (event_action[event] == machine.mechanism.actions.size()) {
        now.end = now.time;
        now.done = true;
      } else {
        const std::size_t action = event_action[event];
        if (acting[action] && would_press_in(dynamics, action, now.q, now.v, pace_time_)) slips(stage, action, now);
        change_holds(stage, action, acting, now);
        // The next piece begins with the other hold.
        now.pieces.emplace_back();
        now.acting.push_back(acting);
        ++changes;
      }
    } else if (now.end && now.time >= *now.end) {
      now.done = true;
    } else if (by_event && now.time >= target && until > target && !followed_enough(target)) {
      target = std::min(until, now.time + (span *= 2));
    }
  }
  if (!now.done && by_event && until > target) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g s", now.time - now.start);
    throw UnansweredError(problem_.file, problem_.stages[stage].until->mark(),
                          "what ends " + words_of(stage) + " has not happened after " + text,
                          "check the condition, or write lasts:");
  }
}

// Nothing is stated of how a contact slips: there the motion ends.
void ProblemMotion::slips(std::size_t stage, std::size_t action, StageRun& run) {
  const std::string& name = start_->machine().mechanism.actions[action].name;
  const auto contact = std::ranges::find(problem_.contacts, name, &Contact::name);
  char time[40];
  std::snprintf(time, sizeof time, " at %.6g s", run.time);
  run.slips = Slip{contact == problem_.contacts.end() ? mark_of(stage) : contact->mark,
                   "the contact '" + name + "' presses no more" + time +
                       ", where the motion still needs its friction: it slips before, and how is not stated"};
  throw_slip(run);
}

void ProblemMotion::throw_slip(const StageRun& run) const {
  throw UnansweredError(problem_.file, run.slips->mark, run.slips->words, "let the motion end before");
}

// A cord or contact gives way, or catches again: then the motion changes as by a blow without rebound.
void ProblemMotion::change_holds(std::size_t, std::size_t action, std::vector<bool>& acting, StageRun& run) {
  probe_->move_to({run.time, static_cast<std::size_t>(&run - stages_.data()), run.q, run.v,
                   std::vector<bool>(acting.size(), true)});
  const Action& named = probe_->machine().mechanism.actions[action];
  const std::string what =
      named.kind == ActionKind::cord ? "the cord '" + named.name + "' " : "the contact '" + named.name + "' ";
  char time[40];
  std::snprintf(time, sizeof time, " at %.6g s", run.time);
  acting[action] = !acting[action];
  if (!acting[action]) {
    happenings_.push_back(what + (named.kind == ActionKind::cord ? "goes slack" : "is lost") + time);
    return;
  }
  happenings_.push_back(what + (named.kind == ActionKind::cord ? "goes taut" : "touches again") + time +
                        ", without rebound");
  run.v = probe_->caught(acting);
}

std::size_t ProblemMotion::stage_at(double time) {
  for (std::size_t stage = 0; stage + 1 < stages_.size(); ++stage) {
    begin(stage);
    // An event that ends a stage is not sought beyond what has been followed.
    if (!stages_[stage].done && time <= stages_[stage].time) return stage;
    const std::optional<double> end = stage_end(stage);
    if (end && time < *end) return stage;
  }
  begin(stages_.size() - 1);
  return stages_.size() - 1;
}

MotionState ProblemMotion::end_of(std::size_t stage) {
  const std::optional<double> end = stage_end(stage);
  StageRun& now = stages_[stage];
  if (end && !now.done) run(stage, *end);
  MotionState state{now.time, stage, now.q, now.v, {}};
  if (!now.acting.empty()) state.acting = now.acting.back();
  return state;
}

MotionState ProblemMotion::at(double time) {
  const std::size_t stage = stage_at(time);
  StageRun& now = stages_[stage];
  const auto beyond = [&] { return now.end && time > *now.end * (1 + 1e-12) + 1e-12; };
  if (!beyond() && time > now.time) run(stage, time);
  if (beyond())
    throw UnansweredError(problem_.file, mark_of(stage), words_of(stage) + " ends before that time",
                          "let it last longer");
  MotionState state{time, stage, now.q, now.v, {}};
  for (std::size_t i = 0; i < now.pieces.size(); ++i) {
    const Trajectory& piece = now.pieces[i];
    if (piece.empty() || time > piece.end_time() || time < piece.start_time()) continue;
    State<double> there = piece.state(time);
    state.q = std::move(there.q);
    state.v = std::move(there.v);
    state.acting = now.acting[i];
    return state;
  }
  if (!now.acting.empty()) state.acting = now.acting.back();
  return state;
}

// The piece of the motion followed so far that a time falls into, if it is one of those with steps; `at` is the judge
// of all others.
const Trajectory* ProblemMotion::piece_at(double time) const {
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    const StageRun& stage = stages_[k];
    // At the end of a stage the next one begins.
    if (stage.done && k + 1 < stages_.size() && time >= stage.time) continue;
    if (!stage.begun || time < stage.start || time > stage.time) return nullptr;
    for (const Trajectory& piece : stage.pieces)
      if (!piece.empty() && time >= piece.start_time() && time <= piece.end_time()) return &piece;
    return nullptr;
  }
  return nullptr;
}

double ProblemMotion::follow(double time) {
  for (std::size_t stage = 0;; ++stage) {
    begin(stage);
    StageRun& now = stages_[stage];
    if (!now.done && now.time < time) run(stage, time);
    if (!now.done || stage + 1 == stages_.size()) return now.time;
  }
}

MotionCheckpoint ProblemMotion::checkpoint() const {
  std::size_t stage = stages_.size() - 1;
  while (stage > 0 && !stages_[stage].begun) --stage;
  const StageRun& now = stages_[stage];
  return {{now.time, stage, now.q, now.v, now.acting.empty() ? std::vector<bool>() : now.acting.back()}, now.start};
}

void ProblemMotion::continue_from(const MotionCheckpoint& checkpoint) {
  const MotionState& state = checkpoint.state;
  stages_.assign(stages_.size(), {});
  for (std::size_t stage = 0; stage < state.stage; ++stage) {
    StageRun& before = stages_[stage];
    before.begun = before.done = true;
    before.end = before.time = checkpoint.stage_start;
    before.q = state.q;
    before.v = state.v;
  }
  StageRun& now = stages_[state.stage];
  now.q = state.q;
  now.v = state.v;
  begin(state.stage);
  now.time = state.time;
  if (!state.acting.empty()) {
    now.pieces.emplace_back();
    now.acting.push_back(state.acting);
  }
  happenings_.clear();
  energy_drift_.reset();
  // Where contacts were before leaves traces of rounding.
  probe_ = std::make_unique<SolvedInstant>(problem_, settings_, state, choice_);
}

SolvedInstant& ProblemMotion::instant_at(double time) {
  probe_->move_to(at(time));
  return *probe_;
}

Value<double> ProblemMotion::value(double time, const Expression& expression, const std::optional<Expression>& axes) {
  values_until_ = std::max(values_until_, time);
  probe_->move_to(at(time));
  return probe_->ask(expression, axes, nullptr);
}

NumberInTime ProblemMotion::number(const Expression& expression, const std::optional<Expression>& axes) {
  if (const std::optional<StateEntry> entry = state_entry(expression))
    return [this, entry](double time) { return state_number(time, *entry); };
  return [this, expression, axes](double time) {
    probe_->move_to(at(time));
    return probe_->number(expression, axes);
  };
}

NumberWithRate ProblemMotion::with_rate(const Expression& expression, const std::optional<Expression>& axes) {
  NumberWithRate both{number(expression, axes), {}};
  const Name* name = expression.as<Name>();
  const NamedCoordinate* coordinate = name && name->primes == 0 ? start_->machine().coordinate(name->name) : nullptr;
  if (coordinate)
    both.rate = [this, entry = StateEntry{true, static_cast<std::size_t>(coordinate->velocity)}](double time) {
      return state_number(time, entry);
    };
  return both;
}

// Coordinates and their rates stand in the state itself.
std::optional<ProblemMotion::StateEntry> ProblemMotion::state_entry(const Expression& expression) const {
  const Name* name = expression.as<Name>();
  const NamedCoordinate* coordinate = name && name->primes < 2 ? start_->machine().coordinate(name->name) : nullptr;
  if (!coordinate) return std::nullopt;
  const bool rate = name->primes == 1;
  return StateEntry{rate, static_cast<std::size_t>(rate ? coordinate->velocity : coordinate->position)};
}

double ProblemMotion::state_number(double time, const StateEntry& entry) {
  if (const Trajectory* piece = piece_at(time)) {
    state_.q.resize(static_cast<std::size_t>(piece->position_size()));
    state_.v.resize(static_cast<std::size_t>(piece->velocity_size()));
    piece->state(time, state_.q, state_.v);
    return entry.rate ? state_.v[entry.place] : state_.q[entry.place];
  }
  const MotionState state = at(time);
  return entry.rate ? state.v[entry.place] : state.q[entry.place];
}

Dimension ProblemMotion::dimension(const Expression& expression, const std::optional<Expression>& axes) {
  probe_->move_to(at(0));
  const Value<double> value = probe_->ask(expression, axes, nullptr);
  if (!value.is_number())
    fail(problem_.file, expression.mark(),
         "'" + to_string(expression) + "' is no number that could be compared in time",
         "ask for a component or norm(...)");
  return value.dimension;
}

std::vector<double> ProblemMotion::nodes(double from, double to) {
  at(to);
  std::vector<double> nodes{from};
  for (const StageRun& stage : stages_)
    for (const Trajectory& piece : stage.pieces)
      for (std::size_t i = 0; i < piece.step_count(); ++i) {
        const StepView step = piece.step(i);
        if (step.start > from && step.start < to && step.start > nodes.back()) nodes.push_back(step.start);
      }
  if (to > nodes.back()) nodes.push_back(to);
  return nodes;
}

Value<double> ProblemMotion::feature(const Call& call, const std::optional<Expression>& axes, const Mark& mark) {
  const Expression& of = call.arguments.front().value;
  const Dimension kind = dimension(of, axes);
  const MotionFeatures features(*this, with_rate(of, axes), to_string(of), problem_.file, mark);
  const double found = call.function == "period" ? features.period()
                       : call.function == "min"  ? features.smallest().value
                                                 : features.largest().value;
  double& until = call.function == "period" ? values_until_ : extremes_until_;
  until = std::max(until, features.latest());
  return Value<double>::of_number(found, call.function == "period" ? dimensions::time : kind);
}

std::vector<double> ProblemMotion::times(const Expression& condition, const std::optional<Expression>& axes,
                                         double from, std::optional<double> to) {
  const Comparison* comparison = condition.as<Comparison>();
  if (!comparison || comparison->operands.size() != 2)
    fail(problem_.file, condition.mark(), "when something happens is told by one comparison",
         "write first_time: reaction(A).z == 0");
  // theta == min(theta): a touching of the extreme.
  for (std::size_t side = 0; side < 2; ++side) {
    const Call* call = comparison->operands[side].as<Call>();
    const Expression& other = comparison->operands[1 - side];
    if (!call || (call->function != "min" && call->function != "max") || call->arguments.size() != 1) continue;
    if (to_string(call->arguments[0].value) != to_string(other)) continue;
    const MotionFeatures features(*this, with_rate(other, axes), to_string(other), problem_.file, condition.mark());
    const std::vector<double> found = features.times_of_extreme(call->function == "max", from, to);
    values_until_ = std::max(values_until_, features.latest());
    return found;
  }
  const NumberInTime left = number(comparison->operands[0], axes), right = number(comparison->operands[1], axes);
  if (!same_kind(dimension(comparison->operands[0], axes), dimension(comparison->operands[1], axes)) &&
      left(from) != 0 && right(from) != 0)
    fail(problem_.file, condition.mark(), "the two sides of this comparison are of different kinds");
  const MotionFeatures features(*this, {[left, right](double time) { return left(time) - right(time); }, {}},
                                to_string(condition), problem_.file, condition.mark());
  const Relation relation = comparison->relations.front();
  const int sense = relation == Relation::less || relation == Relation::less_equal         ? -1
                    : relation == Relation::greater || relation == Relation::greater_equal ? 1
                                                                                           : 0;
  const std::vector<double> found = features.zeros(from, to, sense);
  values_until_ = std::max(values_until_, features.latest());
  return found;
}

double ProblemMotion::time_of(const Expression& quantity, double value, const Mark& mark) {
  const NumberInTime number_at = number(quantity, std::nullopt);
  const MotionFeatures features(*this, {[number_at, value](double time) { return number_at(time) - value; }, {}},
                                to_string(quantity), problem_.file, mark);
  try {
    const double time = features.zeros(0, std::nullopt, 0).front();
    values_until_ = std::max(values_until_, time);
    return time;
  } catch (const UnansweredError&) {
    double least = number_at(0), most = least;
    for (const double time : nodes(0, reached())) {
      least = std::min(least, number_at(time));
      most = std::max(most, number_at(time));
    }
    // A motion that could not be followed is another matter.
    if (least > value || most < value) {
      const bool turning = same_kind(dimension(quantity, std::nullopt), dimensions::angle);
      const double unit = turning ? std::numbers::pi / 180 : 1;
      char text[200];
      std::snprintf(text, sizeof text, "'%s' does not come to %.6g %s up to %.4g s: it runs from %.6g to %.6g %s",
                    to_string(quantity).c_str(), value / unit, turning ? "deg" : "m", reached(), least / unit,
                    most / unit, turning ? "deg" : "m");
      throw UnansweredError(problem_.file, mark, text, "let the table run over what is reached");
    }
    throw;
  }
}

bool has_later_facts(const Problem& problem) {
  return std::any_of(problem.instants.begin(), problem.instants.end(), [&](const Instant& instant) {
    if (is_later(problem, instant)) return instant.rest || !instant.facts.empty();
    return std::any_of(instant.facts.begin(), instant.facts.end(),
                       [&](const Fact& fact) { return level_of(problem, fact.quantity) == Level::motion; });
  });
}

std::vector<double> later_misfits(const Problem& problem, const Settings& settings, const OpenChoice& choice) {
  std::vector<double> misfits;
  ProblemMotion motion(problem, settings, choice);
  // At trial values a motion may be one that nobody would follow.
  if (choice.trial) motion.set_time_limit(1);
  for (const Instant& instant : problem.instants) {
    const bool later = is_later(problem, instant);
    if (later && instant.found_when) continue;
    std::vector<const Fact*> facts;
    for (const Fact& fact : instant.facts)
      if (later || level_of(problem, fact.quantity) == Level::motion) facts.push_back(&fact);
    if (later && instant.rest)
      fail(problem.file, instant.mark, "rest at a later instant is not sought",
           "state the velocities that vanish there");
    if (facts.empty()) continue;
    const std::vector<double> more = motion.fact_misfits(later ? motion.time_of_instant(instant) : 0, facts);
    misfits.insert(misfits.end(), more.begin(), more.end());
  }
  return misfits;
}

double ProblemMotion::time_of_instant(const Instant& instant) {
  for (std::size_t k = 0; k < problem_.stages.size(); ++k) {
    const std::string& name = problem_.stages[k].name;
    if (instant.name == name || instant.name == name + ".start") return stage_start(k);
    if (instant.name == name + ".end") {
      if (const auto end = stage_end(k)) return *end;
      fail(problem_.file, instant.mark, "stage '" + name + "' has no end", "write lasts: or until:");
    }
  }
  if (instant.found_when) return times(*instant.found_when, std::nullopt, 0, std::nullopt).front();
  return start_->data_number(parse_expression(instant.name, problem_.file, instant.mark), dimensions::time);
}

std::vector<double> ProblemMotion::fact_misfits(double time, const std::vector<const Fact*>& facts) {
  const MotionState state = at(time);
  probe_->move_to(state);
  // Features move the probe themselves: they are asked of another.
  SolvedInstant here(problem_, settings_, state, choice_);
  here.set_motion([this](const Call& call, const std::optional<Expression>& axes, const Mark& mark) {
    return feature(call, axes, mark);
  });
  return here.fact_misfits(facts);
}

}  // namespace poinsot::statement
