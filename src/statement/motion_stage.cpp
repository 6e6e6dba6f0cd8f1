// A stage of a motion, followed piece by piece: from one change of what holds to the next.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/motion/integrate.h"
#include "poinsot/motion/lone_body.h"
#include "poinsot/motion/mechanism_dynamics.h"
#include "statement/driving.h"
#include "statement/lost_contact.h"
#include "statement/massless_turning.h"
#include "statement/open_words.h"
#include "statement/problem_motion.h"
#include "statement/reader.h"

namespace poinsot::statement {
namespace {

constexpr std::int64_t most_steps = 400'000;
constexpr int most_changes = 1000;  // of what holds, in one stage

// 1: the event is a rise through zero, -1: a fall, 0: either.
int sense_of(Relation relation) {
  if (relation == Relation::less || relation == Relation::less_equal) return -1;
  return relation == Relation::greater || relation == Relation::greater_equal ? 1 : 0;
}

bool conserves_energy(const Machine& machine) {
  const Mechanism<double>& mechanism = machine.mechanism;
  return machine.accelerations.empty() && mechanism.forces.empty() &&
         std::none_of(mechanism.drives.begin(), mechanism.drives.end(),
                      [](const Drive<double>& drive) { return drive.damping != 0 || drive.effort != 0; }) &&
         std::none_of(mechanism.springs.begin(), mechanism.springs.end(),
                      [](const SpringLaw<double>& spring) { return spring.damping != 0; });
}

// "crank at 180 deg, joint 'B' at 0 deg".
std::string pose_in_words(const std::vector<NamedCoordinate>& coordinates, const IntegrationResult& result) {
  constexpr double degree = 3.14159265358979323846 / 180;
  char number[40];
  std::string words;
  for (const NamedCoordinate& c : coordinates) {
    const double value = result.q[static_cast<std::size_t>(c.position)];
    std::snprintf(number, sizeof number, c.turning ? " at %.4g deg" : " at %.4g m", c.turning ? value / degree : value);
    words += (words.empty() ? "" : ", ") + (c.name.empty() ? "joint '" + c.joint + "'" : c.name) + number;
  }
  return words;
}

}  // namespace

// The equations and events of a motion in which the same cords and contacts hold.
class ProblemMotion::Piece {
 public:
  // span: in which what drives is smooth.
  Piece(ProblemMotion& motion, std::size_t stage, const Driving::Span& span);
  Piece(const Piece&) = delete;
  Piece& operator=(const Piece&) = delete;

  // The event that ends the stage. False if the motion stands at it already.
  bool add_ending(const Expression& condition);
  // The events of all that may give way or catch. The action of one that would have to pull or push the wrong way
  // from the start on, and does not act at all.
  std::optional<std::size_t> add_holds();
  // seconds: of real time.
  IntegrationResult follow(double end, double seconds);
  // The action that an event gives way to or catches; none if it ends the stage.
  std::optional<std::size_t> action_of(std::size_t event) const { return event_action_[event]; }

  bool would_press_in(std::size_t action) {
    return statement::would_press_in(*dynamics_, action, now_.q, now_.v, motion_.pace_time_);
  }
  double kinetic_energy(std::span<const double> q, std::span<const double> v) {
    return dynamics_->kinetic_energy(q, v);
  }
  std::vector<bool>& acting() { return acting_; }
  const std::vector<NamedCoordinate>& coordinates() const { return machine_.coordinates; }

 private:
  void set_up_dynamics();
  void set_given_motion();
  void set_up_equations();
  void refresh(double time);
  double inside(double time) const;
  Event slack(std::size_t component);
  std::optional<Event> taut(const Component<double>& component);

  ProblemMotion& motion_;
  const std::size_t stage_;
  const Driving::Span span_;
  StageRun& now_;
  std::optional<std::vector<std::string>> loads_;
  Machine machine_;
  std::vector<bool> acting_;
  std::optional<MechanismDynamics> dynamics_;
  std::vector<MasslessSpin> spins_;
  std::optional<LoneBody> lone_;
  MotionEquations equations_;
  std::vector<Event> events_;
  std::vector<std::optional<std::size_t>> event_action_;
  std::vector<double> acceleration_;
  double compared_size_ = 0;  // of what the event that ends the stage compares
};

ProblemMotion::Piece::Piece(ProblemMotion& motion, std::size_t stage, const Driving::Span& span)
    : motion_(motion),
      stage_(stage),
      span_(span),
      now_(motion.stages_[stage]),
      loads_(stage < motion.problem_.stages.size() ? motion.problem_.stages[stage].loads : std::nullopt),
      machine_(motion.start_->machine_at(inside(now_.time), loads_)),
      acting_(now_.acting.empty() ? std::vector<bool>() : now_.acting.back()) {
  for (VelocityConstraint<double>& constraint : machine_.mechanism.constraints) {
    constraint.carried_by.reset();
    if (constraint.shape_unknown)
      fail(motion_.problem_.file, motion_.mark_of(stage),
           "how a contact moves is not known (" + constraint.words +
               "): the surfaces there are no circle, sphere or corner on a plane",
           "give the body a round shape");
  }
  if (acting_.empty()) acting_.assign(machine_.mechanism.actions.size(), true);
  set_up_dynamics();
  set_up_equations();
}

void ProblemMotion::Piece::set_given_motion() {
  for (const StatedRate& rate : machine_.accelerations) dynamics_->set_held_acceleration(rate.velocity, rate.value);
  for (std::size_t i = 0; i < acting_.size(); ++i) dynamics_->set_acting(static_cast<int>(i), acting_[i]);
}

void ProblemMotion::Piece::set_up_dynamics() {
  std::vector<int> held;
  for (const StatedRate& rate : machine_.accelerations) held.push_back(rate.velocity);
  dynamics_.emplace(machine_.mechanism, held);
  set_given_motion();
  // The turning of a particle, or of a rod about its own line, moves nothing: it rests.
  while (const std::optional<int> massless = massless_coordinate(machine_, dynamics_->open_coordinates(now_.q))) {
    held.push_back(*massless);
    const std::optional<MasslessSpin> spin = massless_spin(machine_, *massless);
    if (spin && spin->alone) spins_.push_back(*spin);
    dynamics_.emplace(machine_.mechanism, held);
    set_given_motion();
  }
  // What a body does by itself needs no coordinates that are good everywhere: Eulerian angles may start at their pole.
  if (!motion_.timed_ && machine_.accelerations.empty()) lone_ = LoneBody::find(machine_.mechanism);
  if (lone_) return;
  for (const OpenCoordinate& open : dynamics_->open_coordinates(now_.q)) {
    const std::string& name = machine_.mechanism.coordinate_names[static_cast<std::size_t>(open.coordinate)];
    fail(motion_.problem_.file, motion_.mark_of(stage_),
         motion_.words_of(stage_) + " is not determined: nothing fixes " + (name.starts_with("the ") ? "" : "the ") +
             name + (open.without_inertia ? ", which moves no mass" : ""),
         "say what drives it, give it mass, or hold it");
  }
}

// What drives may change abruptly at the ends of its span: there it counts as it is just inside.
double ProblemMotion::Piece::inside(double time) const {
  if (!motion_.timed_) return time;
  const double margin =
      1e-13 * (span_.end - span_.begin) + 1e-15 * std::max(std::abs(span_.begin), std::abs(span_.end));
  return std::clamp(time, span_.begin + margin, std::max(span_.begin + margin, span_.end - margin));
}

// Loads and given motions that follow the time.
void ProblemMotion::Piece::refresh(double time) {
  if (!motion_.timed_) return;
  const Machine then = motion_.start_->machine_at(inside(time), loads_);
  for (const StatedRate& rate : then.accelerations) dynamics_->set_held_acceleration(rate.velocity, rate.value);
  for (std::size_t i = 0; i < then.mechanism.forces.size(); ++i)
    dynamics_->set_force(i, then.mechanism.forces[i].vector);
  for (std::size_t i = 0; i < then.mechanism.drives.size(); ++i)
    dynamics_->set_effort(i, then.mechanism.drives[i].effort);
}

void ProblemMotion::Piece::set_up_equations() {
  const Model<double>& tree = machine_.mechanism.tree;
  equations_.position_size = tree.position_size();
  equations_.velocity_size = tree.velocity_size();
  acceleration_.resize(static_cast<std::size_t>(equations_.velocity_size));
  equations_.position_rate = [&tree](double, std::span<const double> q, std::span<const double> v,
                                     std::span<double> rate) { position_rate<double>(tree, q, v, rate); };
  equations_.accelerations = [this](double time, std::span<const double> q, std::span<const double> v,
                                    std::span<double> a) {
    refresh(time);
    dynamics_->accelerations(q, v, a);
    for (const MasslessSpin& spin : spins_) take_out(spin, a);
  };
  if (!machine_.mechanism.constraints.empty())
    equations_.project = [this](double, std::span<double> q, std::span<double> v) { dynamics_->hold(q, v); };
  const double length = motion_.start_->natural_size(dimensions::length);
  for (const auto& body : tree.bodies()) {
    const int size = position_size(body.joint);
    if (size > 1) equations_.quaternions.push_back(body.q);
    for (int k = 0; k < size; ++k) {
      const bool shift = body.joint == JointType::prismatic || (body.joint == JointType::free && k >= 4);
      equations_.position_sizes.push_back(shift ? length : 1);
    }
  }
  if (!motion_.timed_ && conserves_energy(machine_))
    equations_.conserved.push_back({"energy", [this](double, std::span<const double> q, std::span<const double> v) {
                                      return dynamics_->kinetic_energy(q, v) + dynamics_->potential_energy(q);
                                    }});
}

bool ProblemMotion::Piece::add_ending(const Expression& condition) {
  const std::string& file = motion_.problem_.file;
  const Comparison* comparison = condition.as<Comparison>();
  if (!comparison || comparison->operands.size() != 2)
    fail(file, condition.mark(), "the event that ends a stage is a comparison", "write until: theta == 30 deg");
  Event event;
  event.name = "until";
  event.terminal = true;
  event.value = [this, comparison](double time, std::span<const double> q, std::span<const double> v) {
    SolvedInstant& probe = *motion_.probe_;
    probe.move_to({time, stage_, {q.begin(), q.end()}, {v.begin(), v.end()}, acting_});
    const double left = probe.number(comparison->operands[0], std::nullopt),
                 right = probe.number(comparison->operands[1], std::nullopt);
    compared_size_ = std::max({compared_size_, std::abs(left), std::abs(right)});
    return left - right;
  };
  // It may have been met just where the motion was followed to before.
  for (const Trajectory& piece : now_.pieces) {
    if (piece.empty()) continue;
    const State<double> before = piece.state(piece.start_time());
    event.value(piece.start_time(), before.q, before.v);  // for the size of what is compared
  }
  const double value = event.value(now_.time, now_.q, now_.v);
  if (now_.time == now_.start && sense_of(comparison->relations.front()) * value > 1e-11 * compared_size_)
    throw UnansweredError(file, condition.mark(), "what ends " + motion_.words_of(stage_) + " holds from its start on",
                          "turn the comparison round, or leave the stage out");
  if (now_.time > now_.start && std::abs(value) <= 1e-11 * compared_size_) return false;
  events_.push_back(std::move(event));
  event_action_.push_back(std::nullopt);
  return true;
}

Event ProblemMotion::Piece::slack(std::size_t component) {
  Event event;
  event.name = "slack";
  event.crossing = Crossing::falling;
  event.size = motion_.start_->natural_size(dimensions::force);
  event.value = [this, component](double time, std::span<const double> q, std::span<const double> v) {
    refresh(time);
    dynamics_->accelerations(q, v, acceleration_);
    return dynamics_->component_force(component);
  };
  return event;
}

std::optional<Event> ProblemMotion::Piece::taut(const Component<double>& component) {
  const auto& constraints = machine_.mechanism.constraints;
  const auto constraint =
      std::find_if(constraints.begin(), constraints.end(), [&](const VelocityConstraint<double>& c) {
        return c.action == component.action && (c.normal || c.kind == VelocityConstraintKind::cord_length);
      });
  if (constraint == constraints.end()) return std::nullopt;
  Event event;
  event.name = "taut";
  event.crossing = constraint->kind == VelocityConstraintKind::cord_length ? Crossing::rising : Crossing::falling;
  event.size = motion_.start_->natural_size(dimensions::length);
  event.value = [this, index = static_cast<std::size_t>(constraint - constraints.begin())](
                    double, std::span<const double> q, std::span<const double>) { return dynamics_->gap(index, q); };
  return event;
}

std::optional<std::size_t> ProblemMotion::Piece::add_holds() {
  for (std::size_t k = 0; k < machine_.mechanism.components.size(); ++k) {
    const Component<double>& component = machine_.mechanism.components[k];
    if (!component.one_sided) continue;
    const auto action = static_cast<std::size_t>(component.action);
    std::optional<Event> event = acting_[action] ? slack(k) : taut(component);
    if (!event) continue;
    event->terminal = true;
    if (acting_[action] && event->value(now_.time, now_.q, now_.v) < -1e-9 * event->size) return action;
    events_.push_back(std::move(*event));
    event_action_.emplace_back(action);
  }
  return std::nullopt;
}

IntegrationResult ProblemMotion::Piece::follow(double end, double seconds) {
  IntegrationOptions options;
  options.tolerance = motion_.tolerance_;
  options.most_steps = most_steps;
  options.seconds = std::max(seconds, 0.0);
  options.largest_step = span_.largest_step;
  if (lone_) {
    IntegrationOptions fine = options;
    fine.largest_step = motion_.pace_time_;
    if (auto by_itself = lone_->follow(equations_, now_.time, now_.q, now_.v, end, fine, events_)) return *by_itself;
  }
  return integrate(equations_, now_.time, now_.q, now_.v, end, options, events_);
}

// From where the stage stands, to a time or to where what drives is no longer smooth.
Driving::Span ProblemMotion::smooth_span(std::size_t stage, double until) {
  const StageRun& now = stages_[stage];
  if (!timed_) return {now.time, until, 0};
  driving_.resize(stages_.size());
  if (!driving_[stage]) {
    const auto loads = stage < problem_.stages.size() ? problem_.stages[stage].loads : std::nullopt;
    const std::optional<double> lasts = now.end ? std::optional(*now.end - now.start) : std::nullopt;
    driving_[stage] = std::make_unique<Driving>(problem_, settings_, loads, now.start, lasts, pace_time_, looks_);
  }
  Driving::Span span = driving_[stage]->span_from(now.time);
  // What would be left is rounding.
  if (span.end > until - 1e-13 * std::abs(until)) span.end = until;
  return span;
}

// Integrates a stage up to a time, or up to the event that ends it.
void ProblemMotion::run(std::size_t stage, double until) {
  begin(stage);
  StageRun& now = stages_[stage];
  const Expression* ending =
      stage < problem_.stages.size() && problem_.stages[stage].until ? &*problem_.stages[stage].until : nullptr;
  // Towards an event in growing spans, until it happens or the motion has been followed long enough.
  double span = 20 * pace_time_;
  double target = now.end ? std::min(until, *now.end) : ending ? std::min(until, now.time + span) : until;
  int changes = 0;
  using Clock = std::chrono::steady_clock;
  const auto begun = Clock::now();
  const auto taken = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
  while (!now.done && now.time < target) {
    if (now.slips) throw_slip(now);
    const Driving::Span smooth = smooth_span(stage, target);
    Piece piece(*this, stage, smooth);
    if (ending && !piece.add_ending(*ending)) {
      now.end = now.time;
      now.done = true;
      return;
    }
    const std::optional<std::size_t> released = piece.add_holds();
    if (released) {
      change_holds(stage, *released, piece);
      ++changes;
    }
    if (changes > most_changes)
      fail(problem_.file, mark_of(stage),
           "cords and contacts give way and catch again without end in " + words_of(stage));
    if (released) continue;
    const IntegrationResult result =
        piece.follow(std::min(smooth.end, now.end.value_or(target)), most_seconds_ - taken());
    keep(stage, piece, result);
    if (result.ending == Ending::terminal_event) {
      if (const std::optional<std::size_t> action = piece.action_of(result.hits.back().event)) {
        change_holds(stage, *action, piece);
        ++changes;
      } else {
        now.end = now.time;
        now.done = true;
      }
    } else if (now.end && now.time >= *now.end) {
      now.done = true;
    } else if (ending && now.time >= target && until > target && !followed_enough(target)) {
      target = std::min(until, now.time + (span *= 2));
    }
  }
  if (!now.done && ending && until > target) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g s", now.time - now.start);
    throw UnansweredError(problem_.file, ending->mark(),
                          "what ends " + words_of(stage) + " has not happened after " + text,
                          "check the condition, or write lasts:");
  }
}

// What an integration has reached belongs to the stage. Throws UnansweredError if it did not come to its end.
void ProblemMotion::keep(std::size_t stage, Piece& piece, const IntegrationResult& result) {
  methods_.insert(result.method);
  if (result.ending == Ending::step_limit)
    throw UnansweredError(problem_.file, mark_of(stage),
                          words_of(stage) + " moves too much to be followed farther than " +
                              std::to_string(result.time) + " s: that took " + std::to_string(most_steps) + " steps",
                          "ask for earlier times");
  if (result.ending == Ending::singular_pose)
    throw UnansweredError(problem_.file, mark_of(stage),
                          words_of(stage) + " comes at " + std::to_string(result.time) +
                              " s to a pose from which it can go on in more than one way, or in none: " +
                              pose_in_words(piece.coordinates(), result),
                          "ask for earlier times, or draw the mechanism without this pose on its way");
  if (!result.complete())
    throw UnansweredError(problem_.file, mark_of(stage),
                          words_of(stage) + " cannot be followed: " + poinsot::describe(result), "let it last shorter");
  if (!result.drift.empty()) {
    const double size = std::max(std::abs(result.drift[0].start), piece.kinetic_energy(result.q, result.v));
    energy_drift_ = std::max(energy_drift_.value_or(0), size > 0 ? result.drift[0].largest / size : 0);
  }
  StageRun& now = stages_[stage];
  now.pieces.push_back(result.trajectory);
  now.acting.push_back(piece.acting());
  now.q = result.q;
  now.v = result.v;
  now.time = result.time;
}

// A cord or contact gives way, or catches again: then the motion changes as by a blow without rebound. The next piece
// begins with the other hold.
void ProblemMotion::change_holds(std::size_t stage, std::size_t action, Piece& piece) {
  StageRun& now = stages_[stage];
  std::vector<bool>& acting = piece.acting();
  if (acting[action] && piece.would_press_in(action)) slips(stage, action);
  probe_->move_to({now.time, stage, now.q, now.v, std::vector<bool>(acting.size(), true)});
  const Action& named = probe_->machine().mechanism.actions[action];
  const bool cord = named.kind == ActionKind::cord;
  char time[40];
  std::snprintf(time, sizeof time, " at %.6g s", now.time);
  acting[action] = !acting[action];
  const std::string change =
      acting[action] ? (cord ? "goes taut" : "touches again") : (cord ? "goes slack" : "is lost");
  happenings_.push_back((cord ? "the cord '" : "the contact '") + named.name + "' " + change + time +
                        (acting[action] ? ", without rebound" : ""));
  if (acting[action]) now.v = probe_->caught(acting);
  now.pieces.emplace_back();
  now.acting.push_back(acting);
}

// Nothing is stated of how a contact slips: there the motion ends.
void ProblemMotion::slips(std::size_t stage, std::size_t action) {
  StageRun& run = stages_[stage];
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

}  // namespace poinsot::statement
