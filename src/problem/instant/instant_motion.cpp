// Moves a situation through the states of a motion.
#include <algorithm>

#include "poinsot/engine/solve/instant/closure.h"
#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {

// A later instant is called by a time with its unit, a datum that is a time, or the end of a stage.
bool is_later(const Situation& situation, const Instant& instant) {
  if (instant.found_when) return true;
  if (instant.when && !instant.when.as<Name>()) return true;
  for (std::size_t k = 0; k < situation.stages.size(); ++k) {
    const std::string& name = situation.stages[k].name;
    if (instant.name == name + ".end") return true;
    if (k > 0 && (instant.name == name || instant.name == name + ".start")) return true;
  }
  const auto datum = std::find_if(situation.given.begin(), situation.given.end(),
                                  [&](const NamedExpression& item) { return item.name == instant.name; });
  const auto unknown = std::find_if(situation.find.begin(), situation.find.end(),
                                    [&](const Unknown& item) { return item.name == instant.name; });
  return datum != situation.given.end() || unknown != situation.find.end();
}

bool follows_time(const Situation& situation) {
  const auto timed = [&](const std::optional<Expression>& expression) {
    return expression && depends_on_time(situation, *expression);
  };
  bool any = false;
  for_each_stated_law(situation, [&](const auto& law) {
    law.for_each_part([&](LawPart, const std::optional<Expression>& part) { any = any || timed(part); });
  });
  if (any) return true;
  for (const Joint& joint : situation.joints)
    for (const Freedom& freedom : joint.freedoms)
      if (timed(freedom.position) || timed(freedom.rate) || timed(freedom.accel) || timed(freedom.effort)) return true;
  for (const Frame& frame : situation.frames)
    if (timed(frame.rate) || timed(frame.accel) || timed(frame.velocity) || timed(frame.acceleration)) return true;
  return false;
}

bool turns_nothing(const Machine& machine, int coordinate) {
  for (const auto& body : machine.mechanism.tree.bodies()) {
    const int k = coordinate - body.v;
    const bool turning = body.joint == JointType::ball || body.joint == JointType::free;
    if (!turning || k < 0 || k >= 3) continue;
    const SymmetricMatrix3<double>& I = body.inertia.inertia;
    const double moment = k == 0 ? I.xx : k == 1 ? I.yy : I.zz;
    const double size =
        I.xx + I.yy + I.zz + norm_squared(body.inertia.first_moment) / std::max(body.inertia.mass, 1e-300);
    constexpr double no_inertia = 1e-12;  // rods have some 1e-16 about their own line, wires of a micrometre 1e-11
    return moment <= no_inertia * size || size == 0;
  }
  return false;
}

SolvedInstant::SolvedInstant(const Situation& situation, const Settings& settings, const MotionState& state,
                             const OpenChoice& choice)
    : situation_(situation), settings_(settings), choice_(choice), whole_(true) {
  move_to(state);
}

void SolvedInstant::move_to(const MotionState& state) {
  const bool same = built_stage_ == state.stage && built_acting_ == state.acting;
  if (!timed_) timed_ = follows_time(situation_);
  if (!same || *timed_) {
    build(state.time, state.stage < situation_.stages.size() ? situation_.stages[state.stage].loads : std::nullopt);
    release(state.acting);
    built_stage_ = state.stage;
    built_acting_ = state.acting;
  } else {
    time_ = state.time;
    data_->set_time(state.time);
    motion_.reset();
  }
  for (RoughContactOf<double>& contact : machine_.rough_contacts) contact.off_line = state.off_line;
  moving_ = true;
  before_.reset();
  rough_blow_.reset();
  linearisation_.reset();
  shaken_.clear();
  facts_.clear();
  machine_.q = state.q;
  v_ = state.v;
  velocities_ = {};
  velocities_.value = v_;
  mechanism_state_->set_positions(machine_.q);
  solve::update_contacts(machine_.mechanism, *mechanism_state_);
  mechanism_state_->set_velocities(v_);
  turn_slips();
}

// Where a slip turns, its friction is against the slip of this instant. On curved surfaces it turns with the normal
// from where it was drawn, whatever way the contact took.
void SolvedInstant::turn_slips() {
  for (std::size_t k = 0; k < machine_.rough_contacts.size(); ++k) {
    RoughContactOf<double>& contact = machine_.rough_contacts[k];
    const bool curved = contact.motions.front().kind == VelocityConstraintKind::touching;
    if (contact.grip != Grip::slides || !(contact.turns || curved)) continue;
    const Vector3<double> slip = contact.turns ? rough_motion_as_drawn(k, false).slip : contact.slip->vector;
    if (!(norm(slip) > 0)) continue;
    contact.slip->vector = normalized(slip);
    if (contact.in_joint()) continue;
    Vector3<double> along = along_sliding_force(contact);
    if (curved) {
      const int from = contact.normal.body;
      along = direction_on_body(machine_.mechanism.tree, mechanism_state_->workspace(), from,
                                direction_now(*mechanism_state_, contact, {from, along}));
    }
    for (Component<double>& component : machine_.mechanism.components)
      if (component.action == contact.action) component.along.vector = along;
  }
}

// Actions that do not act impose no constraints and carry no forces.
void SolvedInstant::release(const std::vector<bool>& acting) {
  if (std::find(acting.begin(), acting.end(), false) == acting.end()) return;
  Mechanism<double>& mechanism = machine_.mechanism;
  const auto released = [&](int action) { return action >= 0 && !acting[static_cast<std::size_t>(action)]; };
  for (std::size_t i = mechanism.constraints.size(); i-- > 0;) {
    if (!released(mechanism.constraints[i].action)) continue;
    mechanism.constraints.erase(mechanism.constraints.begin() + static_cast<std::ptrdiff_t>(i));
    machine_.constraint_joints.erase(machine_.constraint_joints.begin() + static_cast<std::ptrdiff_t>(i));
  }
  std::size_t leader = 0;
  // The parts of a cord are released together, so that those that follow another still stand behind it.
  std::vector<Component<double>> kept;
  for (Component<double>& component : mechanism.components) {
    if (released(component.action)) continue;
    if (component.follows >= 0)
      component.follows = static_cast<int>(leader);
    else
      leader = kept.size();
    kept.push_back(std::move(component));
  }
  mechanism.components = std::move(kept);
  mechanism_state_.emplace(mechanism);
}

std::vector<double> SolvedInstant::caught(const std::vector<bool>& acting) {
  solve::Blow blow;
  for (const StatedRate& rate : machine_.accelerations) blow.held_coordinates.push_back(rate.velocity);
  const solve::LinearSolution solution = solve::solve_impulse(*mechanism_state_, scales_, blow, {}, acting);
  return {solution.value.begin(), solution.value.begin() + static_cast<std::ptrdiff_t>(v_.size())};
}

}  // namespace poinsot::problem
