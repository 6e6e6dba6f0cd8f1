#include "problem/course/motion_piece.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

#include "poinsot/engine/dynamics/action_forces.h"
#include "poinsot/engine/work/work.h"
#include "problem/course/corners.h"
#include "problem/course/touching.h"
#include "problem/instant/open_words.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

// Whether the event is a rise through zero (1), a fall (-1) or either (0).
int sense_of(Relation relation) {
  if (relation == Relation::less || relation == Relation::less_equal) return -1;
  return relation == Relation::greater || relation == Relation::greater_equal ? 1 : 0;
}

bool conserves_energy(const Machine& machine) {
  return std::ranges::none_of(machine.rough_contacts, [](const auto& c) { return c.grip == Grip::slides; }) &&
         machine.accelerations.empty() && !laws_feed(machine.mechanism) && !laws_drain(machine.mechanism);
}

// Whether two springs meet in a body without mass, whose place would follow from their balance.
bool joins_springs(const Situation& situation, const Machine& machine) {
  return std::ranges::any_of(situation.bodies, [&](const Body& body) {
    const auto ends = [&](const Spring& spring) { return spring.from == body.name || spring.to == body.name; };
    const int index = machine.index.at(body.name);
    return index != ground && !(machine.mechanism.tree.body(index).inertia.mass > 0) &&
           std::ranges::count_if(situation.springs, ends) > 1;
  });
}

}  // namespace

Course::Piece::Piece(Course& motion, std::size_t stage, const Driving::Span& span)
    : motion_(motion),
      stage_(stage),
      span_(span),
      now_(motion.stages_[stage]),
      loads_(stage < motion.situation_.stages.size() ? motion.situation_.stages[stage].loads : std::nullopt),
      machine_(motion.probe_in(now_.states_now, {now_.time, stage, now_.q, now_.v, {}})
                   .machine_at(inside(now_.time), loads_)),
      drawn_(machine_.mechanism.components),
      limit_state_(machine_.mechanism),
      acting_(now_.acting.empty() ? std::vector<bool>() : now_.acting.back()) {
  for (VelocityConstraint<double>& constraint : machine_.mechanism.constraints) {
    constraint.carried_by.reset();
    if (constraint.shape_unknown)
      fail(motion_.situation_.file, motion_.mark_of(stage),
           "how a contact moves is not known (" + constraint.words + "): the surface of a body there is not known",
           "give the body a shape that touches there, or write corner: in place of at: if a point of it touches");
  }
  if (acting_.empty()) acting_.assign(machine_.mechanism.actions.size(), true);
  slips_turn_ = std::ranges::any_of(machine_.rough_contacts, [](const auto& contact) { return contact.turns; });
  set_up_joint_friction();
  set_up_dynamics();
  set_up_equations();
}

void Course::Piece::set_given_motion() {
  for (const StatedRate& rate : machine_.accelerations) dynamics_->set_held_acceleration(rate.velocity, rate.value);
  for (std::size_t i = 0; i < acting_.size(); ++i) dynamics_->set_acting(static_cast<int>(i), acting_[i]);
}

void Course::Piece::set_up_dynamics() {
  std::vector<int> held;
  for (const StatedRate& rate : machine_.accelerations) held.push_back(rate.velocity);
  dynamics_.emplace(machine_.mechanism, held);
  set_given_motion();
  // The turning of a particle, or of a rod about its own line, moves no mass. It is held at rest.
  while (const std::optional<int> massless = massless_coordinate(machine_, dynamics_->open_coordinates(now_.q))) {
    held.push_back(*massless);
    const std::optional<MasslessSpin> spin = massless_spin(machine_, *massless);
    if (spin && spin->alone) spins_.push_back(*spin);
    dynamics_.emplace(machine_.mechanism, held);
    set_given_motion();
    // A couple would turn something without inertia infinitely fast.
    if (!turns_particle(machine_, *massless)) continue;
    std::vector<double> accelerations(now_.v.size());
    dynamics_->accelerations(now_.q, now_.v, accelerations);
    const double couple = motion_.start_->natural_size(dimensions::force * dimensions::length);
    constexpr double no_couple =
        1e-9;  // of the natural one: what sums of moments about a line leave, magnified by arms
    if (std::abs(dynamics_->held_effort(*massless)) > no_couple * couple)
      fail(motion_.situation_.file, motion_.mark_of(stage_),
           "a couple acts on " + machine_.mechanism.coordinate_names[static_cast<std::size_t>(*massless)] +
               ", which moves no mass",
           "let loads and springs act at the particle itself, or give the body a size");
  }
  // The motion of a single body needs no coordinates that are regular everywhere: Eulerian angles may start at their
  // pole.
  if (!motion_.timed_ && machine_.accelerations.empty() && loads_on_joints_.empty())
    lone_ = LoneBody::find(machine_.mechanism);
  if (lone_) return;
  for (const OpenCoordinate& open : dynamics_->open_coordinates(now_.q)) {
    const std::string& name = machine_.mechanism.coordinate_names[static_cast<std::size_t>(open.coordinate)];
    fail(motion_.situation_.file, motion_.mark_of(stage_),
         motion_.words_of(stage_) + " is not determined: nothing fixes " + with_article(name) +
             (open.without_inertia ? ", which moves no mass" : ""),
         std::string("say what drives it, give it mass, or hold it") +
             (open.without_inertia && joins_springs(motion_.situation_, machine_)
                  ? "; springs in series through a massless point are one, 1/k = 1/k1 + 1/k2, with both free lengths"
                  : ""));
  }
}

// Loads and given motions may jump at the ends of their span. There they have the values just inside.
double Course::Piece::inside(double time) const {
  if (!motion_.timed_) return time;
  // More than the last place of a time, and so little that a load that grows by its own size in the span is right to
  // the last digits.
  const double margin =
      1e-13 * (span_.end - span_.begin) + 1e-15 * std::max(std::abs(span_.begin), std::abs(span_.end));
  return std::clamp(time, span_.begin + margin, std::max(span_.begin + margin, span_.end - margin));
}

// Updates the loads and given motions that depend on the time.
void Course::Piece::refresh(double time) {
  if (!motion_.timed_) return;
  const Machine then = motion_.probes_[now_.states_now]->machine_at(inside(time), loads_);
  for (const StatedRate& rate : then.accelerations) dynamics_->set_held_acceleration(rate.velocity, rate.value);
  for (std::size_t i = 0; i < then.mechanism.forces.size(); ++i)
    dynamics_->set_force(i, then.mechanism.forces[i].vector);
  for (std::size_t i = 0; i < then.mechanism.drives.size(); ++i)
    dynamics_->set_effort(i, then.mechanism.drives[i].effort);
  if (loads_on_joints_.empty()) return;
  for (std::size_t i = 0; i < then.mechanism.forces.size(); ++i)
    machine_.mechanism.forces[i].vector = then.mechanism.forces[i].vector;
  for (std::size_t i = 0; i < then.mechanism.drives.size(); ++i)
    machine_.mechanism.drives[i].effort = then.mechanism.drives[i].effort;
}

void Course::Piece::set_up_equations() {
  const Model<double>& tree = machine_.mechanism.tree;
  equations_.position_size = tree.position_size();
  equations_.velocity_size = tree.velocity_size();
  acceleration_.resize(static_cast<std::size_t>(equations_.velocity_size));
  equations_.position_rate = [&tree](double, std::span<const double> q, std::span<const double> v,
                                     std::span<double> rate) { position_rate<double>(tree, q, v, rate); };
  equations_.accelerations = [this](double time, std::span<const double> q, std::span<const double> v,
                                    std::span<double> a) {
    if (still_) {
      std::ranges::fill(a, 0.0);
      return;
    }
    refresh(time);
    accelerate(q, v, a);
    for (const MasslessSpin& spin : spins_) take_out(spin, a);
  };
  if (!machine_.mechanism.constraints.empty())
    equations_.project = [this](double, std::span<double> q, std::span<double> v) {
      if (!still_) dynamics_->hold(q, v);
    };
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

bool Course::Piece::add_ending(const Expression& condition) {
  const std::string& file = motion_.situation_.file;
  const Comparison* comparison = condition.as<Comparison>();
  if (!comparison || comparison->operands.size() != 2)
    fail(file, condition.mark(), "the event that ends a stage is a comparison", "write until: theta == 30 deg");
  Event event;
  event.name = "until";
  event.terminal = true;
  event.value = [this, comparison](double time, std::span<const double> q, std::span<const double> v) {
    SolvedInstant& probe = *motion_.probes_[now_.states_now];
    probe.move_to({time, stage_, {q.begin(), q.end()}, {v.begin(), v.end()}, acting_});
    const double left = probe.number(comparison->operands[0], std::nullopt),
                 right = probe.number(comparison->operands[1], std::nullopt);
    compared_size_ = std::max({compared_size_, std::abs(left), std::abs(right)});
    return left - right;
  };
  for (const Expression& side : comparison->operands)
    for (const CornerOf& corner : corners_of(motion_.situation_, side))
      event.corners.push_back({[this, corner](double time, std::span<const double> q, std::span<const double> v) {
                                 SolvedInstant& probe = *motion_.probes_[now_.states_now];
                                 probe.move_to({time, stage_, {q.begin(), q.end()}, {v.begin(), v.end()}, acting_});
                                 const double number = probe.number(corner.number, std::nullopt);
                                 return corner.turns ? number * number : number;
                               },
                               corner.turns});
  std::ranges::stable_sort(event.corners, std::greater(), &EventCorner::turns);
  // The event may have been reached just where the motion was followed to before.
  for (const Trajectory& piece : now_.pieces) {
    if (piece.empty()) continue;
    const State<double> before = piece.state(piece.start_time());
    event.value(piece.start_time(), before.q, before.v);  // for the size of what is compared
  }
  const double value = event.value(now_.time, now_.q, now_.v);
  // Of the sizes that are compared: the state in which a stage has ended is good to the tolerance of a motion, 1e-12.
  constexpr double of_sizes = 1e-11;
  if (now_.time == now_.start && sense_of(comparison->relations.front()) * value > of_sizes * compared_size_)
    throw UnansweredError(file, condition.mark(), "what ends " + motion_.words_of(stage_) + " holds from its start on",
                          "turn the comparison round, or leave the stage out");
  if (now_.time > now_.start && std::abs(value) <= of_sizes * compared_size_) return false;
  events_.push_back(std::move(event));
  event_action_.push_back(std::nullopt);
  event_limit_.push_back(nullptr);
  return true;
}

Event Course::Piece::slack(std::size_t component) {
  Event event;
  event.name = "slack";
  event.crossing = Crossing::falling;
  // Where there is no weight and nothing moves yet, no force is natural.
  const double force = motion_.start_->natural_size(dimensions::force);
  event.size = force > 0 ? force : 1;
  event.value = [this, component](double time, std::span<const double> q, std::span<const double> v) {
    refresh(time);
    accelerate(q, v, acceleration_);
    return dynamics_->component_force(component);
  };
  accelerate(now_.q, now_.v, acceleration_);
  if (dynamics_->component_determined(component)) return event;
  // Of contacts that share a load the equations give one share, in which some carry nothing but rounding, and some may
  // pull though there are shares without. One is lost where it pulls and there is no such share, as at an instant.
  constexpr double rounding = 1e-13, nothing = 1e-9;  // of the size
  event.value = [this, component, in_one_share = event.value, size = event.size](double time, std::span<const double> q,
                                                                                 std::span<const double> v) {
    const double own = in_one_share(time, q, v);
    if (own >= -rounding * size) return own + rounding * size;
    SolvedInstant& probe = *motion_.probes_[now_.states_now];
    probe.move_to({inside(time), stage_, {q.begin(), q.end()}, {v.begin(), v.end()}, acting_});
    probe.solve_forces();
    const double shared =
        probe.motion().value[solve::force_unknowns(probe.machine().mechanism).accelerations + component];
    return shared > nothing * size ? shared : own + rounding * size;
  };
  return event;
}

std::optional<Event> Course::Piece::taut(const Component<double>& component) {
  const auto& constraints = machine_.mechanism.constraints;
  const auto constraint =
      std::find_if(constraints.begin(), constraints.end(), [&](const VelocityConstraint<double>& c) {
        return c.action == component.action && (c.normal || is_cord_length(c));
      });
  if (constraint == constraints.end()) return std::nullopt;
  Event event;
  event.name = "taut";
  event.crossing = is_cord_length(*constraint) ? Crossing::rising : Crossing::falling;
  event.size = motion_.start_->natural_size(dimensions::length);
  event.value = [this, index = static_cast<std::size_t>(constraint - constraints.begin())](
                    double, std::span<const double> q, std::span<const double>) { return dynamics_->gap(index, q); };
  if (motion_.has_later_contacts_ && motion_.later_contact(static_cast<std::size_t>(component.action)))
    event.value = gap_beyond_rounding(event.value, event.size, event.value(0, motion_.start_->machine().q, {}));
  return event;
}

std::optional<std::size_t> Course::Piece::add_holds() {
  for (std::size_t k = 0; k < machine_.mechanism.components.size(); ++k) {
    const Component<double>& component = machine_.mechanism.components[k];
    if (!component.one_sided) continue;
    const auto action = static_cast<std::size_t>(component.action);
    std::optional<Event> event = acting_[action] ? slack(k) : taut(component);
    if (!event) continue;
    event->terminal = true;
    // A cord or contact that carries nothing goes on: its force is then rounding, of forces a thousand times larger
    // too.
    constexpr double no_pull = 1e-9;
    if (acting_[action] && event->value(now_.time, now_.q, now_.v) < -no_pull * event->size) return action;
    events_.push_back(std::move(*event));
    event_action_.emplace_back(action);
    event_limit_.push_back(nullptr);
  }
  add_ends_of_surfaces();
  add_ends_of_cords();
  return add_belts();
}

// A belt acts as long as all its sides pull. What is open of their tensions is so throughout.
std::optional<std::size_t> Course::Piece::add_belts() {
  for (const int action : machine_.belt_actions) {
    const auto& components = machine_.mechanism.components;
    std::vector<double> acceleration(now_.v.size());
    dynamics_->accelerations(now_.q, now_.v, acceleration);
    bool known = true;
    for (std::size_t k = 0; k < components.size(); ++k)
      known = known && (components[k].action != action || dynamics_->component_determined(k));
    if (!known) continue;
    Event event;
    event.name = "slack";
    event.crossing = Crossing::falling;
    event.terminal = true;
    event.size = motion_.start_->natural_size(dimensions::force);
    event.value = [this, action](double time, std::span<const double> q, std::span<const double> v) {
      refresh(time);
      accelerate(q, v, acceleration_);
      double tension = 0;
      for (std::size_t k = 0; k < machine_.mechanism.components.size(); ++k)
        if (machine_.mechanism.components[k].action == action) tension += dynamics_->component_force(k);
      return tension;
    };
    // A belt pulls where nothing else exerts a force.
    if (!(event.size > 0)) event.size = 1;
    constexpr double no_pull = 1e-9;  // as of cords
    if (event.value(now_.time, now_.q, now_.v) < -no_pull * event.size) return static_cast<std::size_t>(action);
    events_.push_back(std::move(event));
    event_action_.emplace_back(static_cast<std::size_t>(action));
    event_limit_.push_back(nullptr);
  }
  return std::nullopt;
}

// A contact acts only as long as it is on its surface.
void Course::Piece::add_ends_of_surfaces() {
  for (const ContactLimit& limit : machine_.contact_limits) {
    if (!acting_[static_cast<std::size_t>(limit.action)] || !limit.ends()) continue;
    Event event;
    event.name = "end of surface";
    event.crossing = Crossing::falling;
    event.terminal = true;
    event.size = 1;
    event.value = [this, &limit](double, std::span<const double> q, std::span<const double>) {
      limit_state_.set_positions({q.begin(), q.end()});
      return left_of_surface(limit, limit_state_).value_or(1);
    };
    events_.push_back(std::move(event));
    event_action_.push_back(std::nullopt);
    event_limit_.push_back(&limit);
  }
}

// A point at the end of a cord that comes to the wheel from which the cord leads to it has no straight part left.
void Course::Piece::add_ends_of_cords() {
  // Of the square of the radius: the straight part is then a ten thousandth of it. Nearer its direction turns faster
  // than a motion can be followed.
  constexpr double nothing = 1e-8;
  for (const VelocityConstraint<double>& c : machine_.mechanism.constraints) {
    if (c.kind != VelocityConstraintKind::led_cord || !acting_[static_cast<std::size_t>(c.action)]) continue;
    for (const CordSpan<double>& span : c.spans) {
      const double reach = span.from.reach - span.to.reach;
      if ((span.from.reach == 0) == (span.to.reach == 0)) continue;
      Event event;
      event.name = "end of cord";
      event.crossing = Crossing::falling;
      event.terminal = true;
      event.size = 1;
      event.value = [this, &span, reach](double, std::span<const double> q, std::span<const double>) {
        limit_state_.set_positions({q.begin(), q.end()});
        const Model<double>& tree = limit_state_.mechanism().tree;
        const Workspace<double>& w = limit_state_.workspace();
        const auto center = [&](const CordEnd<double>& end) {
          return point_position(tree, w, end.center.body, end.center.point);
        };
        const Vector3<double> e = direction_on_ground(tree, w, span.axis.body, span.axis.vector);
        const Vector3<double> apart = center(span.to) - center(span.from);
        const Vector3<double> in_plane = apart - dot(apart, e) * e;
        return norm_squared(in_plane) / (reach * reach) - 1 - nothing;
      };
      event_cord_[events_.size()] = static_cast<std::size_t>(c.action);
      events_.push_back(std::move(event));
      event_action_.push_back(std::nullopt);
      event_limit_.push_back(nullptr);
    }
  }
}

const ContactLimit* Course::Piece::beyond_surface() const {
  solve::MechanismState state(machine_.mechanism);
  state.set_positions(now_.q);
  state.set_velocities(now_.v);
  for (const ContactLimit& limit : machine_.contact_limits)
    if (acting_[static_cast<std::size_t>(limit.action)] && goes_beyond(limit, state)) return &limit;
  return nullptr;
}

void Course::Piece::check_sides(const Trajectory* way) const {
  constexpr std::size_t looks = 64;
  solve::MechanismState state(machine_.mechanism);
  const auto check = [&](const std::vector<double>& q, const std::vector<double>& v) {
    state.set_positions(q);
    state.set_velocities(v);
    for (const ContactLimit& limit : machine_.contact_limits)
      if (acting_[static_cast<std::size_t>(limit.action)] && leaves_plane(limit, state, 1 / motion_.pace_time_))
        throw UnansweredError(motion_.situation_.file, limit.mark, words_of_side(limit), hint_of_side(limit));
  };
  if (std::ranges::all_of(machine_.contact_limits, [](const ContactLimit& limit) { return limit.straight.empty(); }))
    return;
  if (!way) return check(now_.q, now_.v);
  if (way->empty()) return;
  for (std::size_t k = 1; k <= looks; ++k) {
    const double part = static_cast<double>(k) / looks;
    const State<double> then = way->state(way->start_time() + part * (way->end_time() - way->start_time()));
    check(then.q, then.v);
  }
}

// The angle of a torsional spring is that within half a turn of the figure as drawn: where the bodies turn farther it
// jumps by a whole turn from one look to the next. Steps resolve the turning, so a few looks at each are enough.
void Course::Piece::check_winding(const Trajectory& way) const {
  constexpr int looks = 4;
  const Mechanism<double>& mechanism = machine_.mechanism;
  if (mechanism.torsions.empty() || way.empty()) return;
  Workspace<double> workspace(mechanism.tree);
  std::vector<double> before;
  for (std::size_t i = 0; i < way.step_count(); ++i) {
    const StepView step = way.step(i);
    for (int k = 0; k <= looks; ++k) {
      const double time = step.start + (step.end - step.start) * k / looks;
      update_poses<double>(mechanism.tree, workspace, way.state(time).q);
      std::vector<double> angles;
      for (const TorsionLaw<double>& torsion : mechanism.torsions)
        angles.push_back(torsion.angle(mechanism.tree, workspace));
      for (std::size_t j = 0; j < before.size(); ++j) {
        if (std::abs(angles[j] - before[j]) < std::numbers::pi) continue;
        const std::string& name = mechanism.actions[static_cast<std::size_t>(mechanism.torsions[j].action)].name;
        const auto spring = std::ranges::find(motion_.situation_.springs, name, &Spring::name);
        throw UnansweredError(motion_.situation_.file, spring->mark,
                              "the torsional spring '" + name + "' is wound by half a turn at " + with_digits(time, 6) +
                                  " s: farther its angle is not followed",
                              "ask for earlier times, or state the spring at a joint that turns about this axis: "
                              "there whole turns count");
      }
      before = std::move(angles);
    }
  }
}

// How a center pulls is known from outside a body alone. Steps resolve how fast it comes nearer.
void Course::Piece::check_nearness(const Trajectory& way) const {
  constexpr int looks = 4;
  const Mechanism<double>& mechanism = machine_.mechanism;
  if (mechanism.attractions.empty() || way.empty()) return;
  Workspace<double> workspace(mechanism.tree);
  for (std::size_t i = 0; i < way.step_count(); ++i) {
    const StepView step = way.step(i);
    for (int k = 0; k <= looks; ++k) {
      const double time = step.start + (step.end - step.start) * k / looks;
      update_poses<double>(mechanism.tree, workspace, way.state(time).q);
      for (const AttractionLaw<double>& pull : mechanism.attractions)
        for (const AttractedPart<double>& part : pull.parts)
          if (!(norm(pull.way_to(mechanism.tree, workspace, part)) > part.reach))
            throw UnansweredError(motion_.situation_.file, motion_.situation_.central_gravity->mark,
                                  "the center that pulls comes within body '" + mechanism.tree.name(pull.at.body) +
                                      "' at " + with_digits(time, 6) + " s: there its pull is not known",
                                  "ask for earlier times");
    }
  }
}

double Course::Piece::largest_kinetic_energy(const Trajectory& way) {
  constexpr std::size_t looks = 64;
  const auto at = [&](double time) {
    const State<double> there = way.state(time);
    return dynamics_->kinetic_energy(there.q, there.v);
  };
  double largest = 0;
  for (std::size_t i = 0; i < way.step_count(); i += 1 + way.step_count() / looks)
    largest = std::max(largest, at(way.step(i).start));
  return way.empty() ? largest : std::max(largest, at(way.end_time()));
}

}  // namespace poinsot::problem
