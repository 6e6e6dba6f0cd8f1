#include "problem/course/course.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "poinsot/engine/dynamics/action_forces.h"
#include "poinsot/engine/motion/mechanism/lone_body.h"
#include "poinsot/engine/solve/instant/equations.h"
#include "problem/course/motion_piece.h"
#include "problem/entries/absorbed_particles.h"
#include "problem/instant/massless_turning.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {
namespace {

// The push that makes a motion leave an unstable equilibrium, in radians or natural lengths: far above the error with
// which the motion is followed, 1e-12 a step, and so small that its square is not seen in eleven digits.
constexpr double nudge = 1e-7;

// Of a time, which is a sum over the steps: ten thousand of them at the most, each rounded to 1e-16.
constexpr double rounding_of_times = 1e-12;

// Whether velocities carry free bodies along without turning anything.
bool carries_along(const Machine& machine, const std::vector<double>& velocities) {
  std::vector<double> rest = velocities;
  for (const auto& body : machine.mechanism.tree.bodies())
    if (body.joint == JointType::free)
      for (std::size_t k = 3; k < 6; ++k) rest[static_cast<std::size_t>(body.v) + k] = 0;
  return std::ranges::all_of(rest, [](double component) { return component == 0; });
}

}  // namespace

Course::Course(const Situation& situation, const Settings& settings, const OpenChoice& choice, bool flights_open)
    : stated_(situation),
      changed_(with_absorbed_particles(situation)),
      situation_(changed_ ? *changed_ : situation),
      settings_(settings),
      choice_(choice),
      timed_(follows_time(situation)) {
  if (const Freedom* sought = situation.sought_effort())
    throw UnansweredError(situation.file, sought->effort->mark(),
                          "what drives the bodies is to be found at an instant, and is not known along the motion",
                          "state it in place of any");
  for (const Gear& gear : situation.gears)
    if (gear.friction)
      throw UnansweredError(situation.file, gear.friction->mark(),
                            "a motion with friction in the teeth of gear '" + gear.name +
                                "' is not followed: the flanks that carry may change in it",
                            "ask of the start only, or leave out the friction");
  for (const Contact& contact : situation.contacts) {
    if (contact.rubs() && contact.grip == Grip::unknown)
      throw UnansweredError(situation.file, contact.friction->mark,
                            "motions with friction are followed for questions of a statement only: whether contact '" +
                                contact.name + "' sticks or slides at the start is not known here",
                            "list what is wanted under ask:");
  }
  const When begins{0, situation.has_blow()};
  start_ = std::make_unique<SolvedInstant>(situation, settings, begins, choice_);
  if (!start_->scales().has_length && !choice_.scales) {
    choice_.scales = own_scales(begins);
    if (choice_.scales) start_ = std::make_unique<SolvedInstant>(situation, settings, begins, choice_);
  }
  std::vector<std::vector<double>> open = start_->velocities().open;
  const std::vector<std::vector<double>> moving_nothing = take_massless(start_->machine(), open);
  const auto flies = [&](const std::vector<double>& direction) { return carries_along(start_->machine(), direction); };
  open_flights_ = flights_open && !open.empty() && std::ranges::all_of(open, flies);
  if (!choice.trial && !choice.velocities && !open_flights_ && !open.empty()) {
    // Of what moves masses that which moves most in the first direction that is open.
    const auto most = std::ranges::max_element(open.front(), {}, [](double part) { return std::abs(part); });
    const auto unknown = static_cast<std::size_t>(most - open.front().begin());
    throw UnansweredError(situation.file, mark_of(0),
                          words_of(0) + " is not fixed at its start: " +
                              std::string(start_->velocity_equations().name(unknown)) + " is unknown",
                          "state it under instants: {start: {...}}");
  }
  for (const std::vector<std::size_t>& share : start_->velocities().share) {
    std::vector<std::string>& names = open_turnings_.emplace_back();
    for (const std::size_t k : share) names.emplace_back(start_->velocity_equations().name(k));
  }
  if (start_->rough_blow())
    happenings_.push_back(words_of_blow(*start_->rough_blow(), start_->struck().impacts.front()));
  if (start_->after_blow()) open_impulses_ = start_->blow().open.size();
  stages_.resize(std::max<std::size_t>(1, situation.stages.size()));
  StageRun& first = stages_.front();
  MotionState state = start_->state();
  // Turning that moves no mass is zero. Where it is varied, to see what depends on it, it is slower than what moves, or
  // the steps would go with its turns however long the motion lasts.
  constexpr double slow = 1e-3;
  reduce_components(moving_nothing, state.v, choice.velocities ? slow : 0);
  if (start_->after_blow()) state.acting = start_->blow_acting();
  has_later_contacts_ = std::ranges::any_of(situation_.contacts, &Contact::strikes_later);
  for (const Contact& contact : situation_.contacts) {
    // What parts at the start flies from then on; what does so in a blow is found anew after it.
    if (!contact.open && (contact.grip != Grip::parts || situation.has_blow())) continue;
    const auto& actions = start_->machine().mechanism.actions;
    if (state.acting.empty()) state.acting.assign(actions.size(), true);
    for (std::size_t i = 0; i < actions.size(); ++i)
      if (actions[i].kind == ActionKind::contact && actions[i].name == contact.name) state.acting[i] = false;
  }
  // A cord that is slack at the start exerts nothing there.
  const Mechanism<double>& at_start = start_->machine().mechanism;
  for (std::size_t i = 0; i < at_start.actions.size(); ++i) {
    const auto pulls = [&](const Component<double>& c) { return c.action == static_cast<int>(i); };
    if (at_start.actions[i].kind != ActionKind::cord || std::ranges::any_of(at_start.components, pulls)) continue;
    if (state.acting.empty()) state.acting.assign(at_start.actions.size(), true);
    state.acting[i] = false;
    has_later_contacts_ = true;
  }
  if (changed_) start_ = std::make_unique<SolvedInstant>(situation_, settings, state, choice_);
  if (!state.acting.empty()) state.acting.resize(start_->machine().mechanism.actions.size());
  // An unstable equilibrium is left by a small push at the stated coordinate.
  for (const Instant& instant : situation.instants)
    for (const auto& [name, mark] : instant.nudged) {
      const NamedCoordinate* coordinate = start_->machine().coordinate(name);
      if (!coordinate) {
        std::vector<std::string> names;
        for (const NamedCoordinate& c : start_->machine().coordinates)
          if (!c.name.empty()) names.push_back(c.name);
        fail(situation.file, mark, "'" + name + "' is no coordinate", did_you_mean(name, names));
      }
      state.q[static_cast<std::size_t>(coordinate->position)] +=
          nudge * (coordinate->turning ? 1 : start_->natural_size(dimensions::length));
    }
  first.q = state.q;
  first.v = state.v;
  in_states_.push_back(&situation_);
  if (std::ranges::find(state.acting, false) != state.acting.end()) put_in_flight(first, state.acting);
  // At values that are tried for unknowns contacts with friction may start in other states than those followed here.
  const bool varied = choice.any || choice.velocities || choice.forces || choice.gravity > 0;
  if (situation.has_friction() && !situation.has_blow() && !varied) {
    start_->solve_forces();
    for (const SolvedInstant::OneSidedFault& fault : start_->one_sided_faults())
      for (const RoughContactOf<double>& contact : start_->machine().rough_contacts)
        if (fault.broken != Holding::pulls && contact.action == static_cast<int>(fault.action))
          throw UnansweredError(situation.file, mark_of(0),
                                "the motion does not start with '" + contact.name + "' in this state",
                                "give values at which it does");
  }
  probe_ = &probe_in(0, state);
  set_pace(state);
  // What sticks and slides after a blow is found anew.
  if (situation.has_blow() && situation.has_friction()) {
    find_contact_states(0, 0, "");
    first.states_fresh = true;
  }
}

// Particles in one place have no length of their own. What is fast and hardly pushed changes on a way of many metres;
// what rubs and slows down comes to rest on its own way, however short that is.
std::optional<solve::Scales> Course::own_scales(const When& begins) const {
  SolvedInstant pushed(situation_, settings_, begins, choice_);
  try {
    pushed.solve_forces();
  } catch (const StatementError&) {
    return std::nullopt;  // it is told where the motion is followed
  }
  solve::Scales scales = pushed.scales();
  const std::optional<SolvedInstant::WayOfChange> way = pushed.way_of_change();
  // Within a thousandfold the metre serves as well, also where what slows down in air goes on for long.
  constexpr double serves = 1e3;
  if (!way || (way->length <= serves * scales.length && !(way->slows && situation_.has_friction())))
    return std::nullopt;
  scales.length = way->length;
  return scales;
}

// If the motion starts from rest, loads determine how fast it changes.
void Course::set_pace(const MotionState& state) {
  SolvedInstant pushed(situation_, settings_, state, choice_);
  try {
    pushed.solve_forces();
  } catch (const StatementError&) {
    // At the pole of Eulerian angles no forces can be found. The motion of a single body is known there all the same.
    const Machine& machine = pushed.machine();
    if (timed_ || !machine.accelerations.empty() || !LoneBody::find(machine.mechanism)) throw;
  }
  const double pace = pushed.pace();
  pace_time_ = pace > 0 ? 1 / pace : 1;
}

Course::~Course() = default;

const Mark& Course::mark_of(std::size_t stage) const {
  static const Mark beginning{1, 1};
  return stage < situation_.stages.size() ? situation_.stages[stage].mark
         : situation_.instants.empty()    ? beginning
                                          : situation_.instants.front().mark;
}
std::string Course::words_of(std::size_t stage) const {
  return stage < situation_.stages.size() ? "stage '" + situation_.stages[stage].name + "'" : "the motion";
}

bool Course::dissipates() const {
  const Machine machine =
      start_->machine_at(0, situation_.stages.empty() ? std::nullopt : situation_.stages.back().loads);
  // Blows take energy, too, but where all of it is given back.
  const bool blows_drain = std::ranges::any_of(situation_.contacts, [&](const Contact& contact) {
    return contact.strikes_later() &&
           (!contact.restitution || start_->data_number(*contact.restitution, dimensions::none) < 1);
  });
  return !timed_ && machine.accelerations.empty() && !laws_feed(machine.mechanism) &&
         (laws_drain(machine.mechanism) || blows_drain);
}
bool Course::may_come_to_rest() const {
  return situation_.has_friction() || std::ranges::any_of(situation_.contacts, &Contact::strikes_later);
}
bool Course::ends_in_center(double time) {
  // Of the distance at the start, and of the direction then, which what falls straight down keeps.
  constexpr double as_good_as_there = 1e-2, straight = 1e-8;
  const Mechanism<double>& mechanism = start_->machine().mechanism;
  Workspace<double> begun(mechanism.tree), now(mechanism.tree);
  update_poses<double>(mechanism.tree, begun, at(0).q);
  update_poses<double>(mechanism.tree, now, at(time).q);
  for (const AttractionLaw<double>& pull : mechanism.attractions)
    for (const AttractedPart<double>& part : pull.parts)
      if (const Vector3<double> from = pull.way_to(mechanism.tree, begun, part),
          left = pull.way_to(mechanism.tree, now, part);
          norm(left) < as_good_as_there * norm(from) && norm(cross(left, from)) < straight * norm(left) * norm(from))
        return true;
  return false;
}
bool Course::has_springs() const { return laws_store(start_->machine().mechanism); }

double Course::reached() const {
  double time = 0;
  for (const StageRun& stage : stages_)
    if (stage.begun) time = std::max(time, stage.time);
  return time;
}

bool Course::followed_by_many_steps(double until) const {
  constexpr std::size_t enough = 100'000;  // steps, in a motion that may go on without end
  std::size_t steps = 0;
  for (const StageRun& stage : stages_)
    for (const Trajectory& piece : stage.pieces)
      if (!piece.empty() && piece.start_time() < until) steps += piece.step_count();
  return steps >= enough && until >= reached();
}

bool Course::followed_enough(double until) const {
  constexpr double longest = 1e6;  // in pace times
  return followed_by_many_steps(until) || until > longest * pace_time_;
}

double Course::turning_time(double until) {
  // Slower than this part of the pace moves only what was at rest and nudged; ten times the nudge.
  constexpr double at_rest = 10 * nudge;
  constexpr std::size_t looks = 64;
  const Mechanism<double>& mechanism = start_->machine().mechanism;
  const std::vector<double> times = nodes(0, until);
  double fastest = 0;
  for (std::size_t i = 0; i < times.size(); i += 1 + times.size() / looks) {
    const MotionState there = at(times[i]);
    for (std::size_t k = 0; k < there.v.size(); ++k)
      fastest = std::max(
          fastest, std::abs(there.v[k]) /
                       (solve::coordinate_turns(mechanism.tree, static_cast<int>(k)) ? 1 : start_->scales().length));
  }
  return fastest * pace_time_ > at_rest ? std::max(pace_time_, 1 / fastest) : pace_time_;
}

void Course::begin(std::size_t stage) {
  StageRun& now = stages_[stage];
  if (now.begun) return;
  if (stage > 0) {
    begin(stage - 1);
    StageRun& before = stages_[stage - 1];
    if (!before.done) run(stage - 1, before.end ? *before.end : std::numeric_limits<double>::infinity());
    now.start = *before.end;
    now.q = before.q;
    now.v = before.v;
    now.states_now = before.states_now;
    // What has gone slack or has parted is so at first in the next stage, too.
    if (!before.acting.empty() && std::ranges::find(before.acting.back(), false) != before.acting.back().end())
      now.begin_piece(before.acting.back());
  }
  if (stage < situation_.stages.size()) {
    const Stage& stated = situation_.stages[stage];
    if (stated.lasts) {
      const double duration = start_->data_number(*stated.lasts, dimensions::time);
      if (!(duration >= 0)) fail(situation_.file, stated.lasts->mark(), "a stage lasts no negative time");
      now.end = now.start + duration;
      if (duration == 0) now.done = true;
    } else if (!stated.until && stage + 1 < situation_.stages.size()) {
      fail(situation_.file, stated.mark, "stage '" + stated.name + "' does not say how long it lasts",
           "write lasts: 2 s, or until: theta == 30 deg");
    }
  }
  now.time = now.start;
  // Other loads may act now.
  if (stage > 0 && rubs(now)) {
    find_contact_states(stage, now.time, "");
    now.states_fresh = !timed_;
  }
  // A stage with an impossible duration does not begin, so that asking again gives the same message.
  now.begun = true;
}

double Course::stage_start(std::size_t stage) {
  begin(stage);
  return stages_[stage].start;
}

std::optional<double> Course::stage_end(std::size_t stage) {
  begin(stage);
  if (!stages_[stage].end && stage < situation_.stages.size() && situation_.stages[stage].until)
    run(stage, std::numeric_limits<double>::infinity());
  return stages_[stage].end;
}

std::size_t Course::stage_at(double time) {
  for (std::size_t stage = 0; stage + 1 < stages_.size(); ++stage) {
    begin(stage);
    // The event that ends a stage is not sought beyond the time that was followed.
    if (!stages_[stage].done && time <= stages_[stage].time) return stage;
    const std::optional<double> end = stage_end(stage);
    if (end && time < *end) return stage;
  }
  begin(stages_.size() - 1);
  return stages_.size() - 1;
}

MotionState Course::end_of(std::size_t stage) {
  const std::optional<double> end = stage_end(stage);
  StageRun& now = stages_[stage];
  if (end && !now.done) run(stage, *end);
  MotionState state{now.time, stage, now.q, now.v, {}};
  if (!now.acting.empty()) state.acting = now.acting.back();
  return state;
}

std::optional<double> Course::blow_at(double time) const {
  const auto blow =
      std::ranges::lower_bound(blows_, time - rounding_of_times * std::abs(time), std::less{}, &Blow::time);
  if (blow == blows_.end() || blow->time > time + rounding_of_times * std::abs(time)) return {};
  return blow->time;
}

MotionState Course::at(double time) {
  const std::size_t stage = stage_at(time);
  StageRun& now = stages_[stage];
  const auto beyond = [&] { return now.end && time > *now.end * (1 + rounding_of_times); };
  if (!beyond() && time > now.time) run(stage, time);
  if (beyond())
    throw UnansweredError(situation_.file, mark_of(stage), words_of(stage) + " ends before that time",
                          "let it last longer");
  MotionState state{time, stage, now.q, now.v, {}};
  if (rubs(now)) state.off_line = off_line * natural_speed();
  // At the instant of a blow what was just before it is meant.
  const double within = blow_at(time).value_or(time);
  for (std::size_t i = 0; i < now.pieces.size(); ++i) {
    const Trajectory& piece = now.pieces[i];
    if (piece.empty() || within > piece.end_time() || within < piece.start_time()) continue;
    State<double> there = piece.state(within);
    state.q = std::move(there.q);
    state.v = std::move(there.v);
    state.acting = now.acting[i];
    return state;
  }
  if (!now.acting.empty()) state.acting = now.acting.back();
  return state;
}

// The piece of the motion followed so far that contains a time, if it is one with steps. `at` decides in all other
// cases.
const Trajectory* Course::piece_at(double time) const {
  if (blow_at(time)) return nullptr;
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    const StageRun& stage = stages_[k];
    // At the end of a stage the next one has begun.
    if (stage.done && k + 1 < stages_.size() && time >= stage.time) continue;
    if (!stage.begun || time < stage.start || time > stage.time) return nullptr;
    for (const Trajectory& piece : stage.pieces)
      if (!piece.empty() && time >= piece.start_time() && time <= piece.end_time()) return &piece;
    return nullptr;
  }
  return nullptr;
}

double Course::follow(double time) {
  for (std::size_t stage = 0;; ++stage) {
    begin(stage);
    StageRun& now = stages_[stage];
    if (!now.done && now.time < time) run(stage, time);
    if (!now.done || stage + 1 == stages_.size()) return now.time;
  }
}

std::optional<UnansweredError> Course::follow_as_far(double& until, double& reached, bool all) {
  try {
    reached = follow(until);
    return std::nullopt;
  } catch (const UnansweredError& error) {
    if (all) throw;
    reached = until = Course::reached();
    return error;
  }
}

MotionCheckpoint Course::checkpoint() const {
  std::size_t stage = stages_.size() - 1;
  while (stage > 0 && !stages_[stage].begun) --stage;
  const StageRun& now = stages_[stage];
  return {{now.time, stage, now.q, now.v, now.acting.empty() ? std::vector<bool>() : now.acting.back()},
          now.start,
          struck_,
          now.flight};
}

void Course::continue_from(const MotionCheckpoint& checkpoint) {
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
  to_balance_.clear();
  energy_drift_.reset();
  blow_misfit_.reset();
  rough_blow_misfit_.reset();
  rests_from_.reset();
  largest_kinetic_ = 0;
  blows_.clear();
  later_blows_.clear();
  settled_.clear();
  struck_ = checkpoint.struck;
  // What was open at the start may touch by now.
  open_checked_ = state.time > 0;
  // A new probe is made, as the old one keeps rounding from earlier places of the contacts.
  probes_.clear();
  in_states_.resize(1);
  changed_states_.clear();
  now.states_now = 0;
  if (!state.acting.empty()) put_in_flight(now, state.acting);
  now.flight = checkpoint.flight;
  if (rubs(now)) find_contact_states(state.stage, state.time, "");
  probe_ = &probe_in(now.states_now, state);
  happenings_.clear();
  changes_.clear();
}

}  // namespace poinsot::problem
