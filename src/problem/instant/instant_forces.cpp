// Solves for the accelerations and forces of an instant.
#include <algorithm>
#include <cmath>
#include <utility>

#include "problem/instant/instant.h"
#include "problem/instant/one_sided_shares.h"
#include "problem/language/diagnostic.h"
#include "problem/machine/contact_limits.h"
#include "problem/quantities/tooth_flanks.h"

namespace poinsot::problem {
namespace {

const Mark& place_of_friction(const Situation& situation) {
  return std::ranges::find_if(situation.contacts, &Contact::rubs)->friction->mark;
}

// What has parted in a blow carries nothing just after it, but the equations of that instant still have it.
void refuse_what_gave_way(const std::string& file, const Mark& mark, const std::string& name) {
  throw UnansweredError(file, mark, "'" + name + "' gives way in the blow: what follows it moves without it",
                        "ask for accelerations and forces in the motion that follows: @ 0 s");
}

}  // namespace

void SolvedInstant::solve_forces() {
  if (before_ && !moving_ && !machine_.rough_contacts.empty())
    throw UnansweredError(situation_.file, place_of_friction(situation_),
                          "forces just after a blow are not told where contacts have friction: their states after it "
                          "are others than in it",
                          "ask at a time, such as 1 ms, or for impulses and velocities");
  const auto parted = std::ranges::find(blow_acting_, false) - blow_acting_.begin();
  if (before_ && !moving_ && !choice_.trial && parted < std::ssize(blow_acting_))
    refuse_what_gave_way(situation_.file, situation_.bodies.front().mark,
                         machine_.mechanism.actions[static_cast<std::size_t>(parted)].name);
  if (!motion_) solve_motion_equations(state_motion_equations());
}

void SolvedInstant::assemble_forces() {
  if (motion_) return;
  const std::vector<const Fact*> nonlinear = state_motion_equations();
  if (!nonlinear.empty()) solve_motion_equations(nonlinear);
}

Diagnostic unknown_surface(const Situation& situation, const Machine& machine,
                           const VelocityConstraint<double>& constraint) {
  const std::string& name = machine.mechanism.actions[static_cast<std::size_t>(constraint.action)].name;
  const auto contact = std::find_if(situation.contacts.begin(), situation.contacts.end(),
                                    [&](const Contact& c) { return c.name == name; });
  if (contact->corner && contact->against != "ground")
    return {situation.file, contact->mark,
            "how the corner of contact '" + name + "' moves is not known: the surface of '" + contact->against +
                "' there is not known",
            "velocities can be asked; for forces, accelerations and stability give '" + contact->against +
                "' a shape that is touched there, such as added: {top: {rectangle: {...}, mass: 0 kg}}"};
  return {situation.file, contact->mark,
          "how the point of contact '" + name + "' moves is not known: the surface of a body there is not known",
          "velocities can be asked; for forces, accelerations and stability write corner: in place of at: if a point "
          "of the body touches, give it a shape that touches there (added: {skin: {ellipsoid: {...}, mass: 0 kg}}), "
          "or its inertia by axis:, axial:, transverse:"};
}

namespace {

// A load that depends on the motion may have no value here: a power divided by a speed of zero.
void require_loads(const Situation& situation, const Mechanism<double>& mechanism, const solve::MechanismState& state) {
  for (const KnownForce<double>& force : mechanism.forces) {
    if (!force.by_motion || std::isfinite(norm_squared(force.now(mechanism.tree, state.workspace())))) continue;
    const Action& action = mechanism.actions[static_cast<std::size_t>(force.action)];
    const auto load = std::ranges::find(situation.loads, action.name, &Load::name);
    const auto joint = std::ranges::find(situation.joints, action.joint, &Joint::name);
    const bool at_joint = action.kind == ActionKind::drive && joint != situation.joints.end();
    throw DomainError(situation.file, at_joint ? joint->mark : load->mark,
                      (at_joint ? "what drives joint '" + joint->name : "load '" + action.name) +
                          "' has no value in this motion: a division by zero, or the root of a negative number");
  }
}

}  // namespace

std::vector<const Fact*> SolvedInstant::state_motion_equations() {
  require_loads(situation_, machine_.mechanism, *mechanism_state_);
  for (const Strike& strike : situation_.strikes)
    if (before_ && strike.stays && !strike.mass_neglected)
      throw UnansweredError(situation_.file, strike.mark,
                            "with the particle of strike '" + strike.name +
                                "', which stays, the body moves on as another one than before",
                            "ask for its accelerations and forces in the motion that follows: @ 0 s");
  for (const VelocityConstraint<double>& constraint : machine_.mechanism.constraints)
    if (constraint.shape_unknown && !constraint.carried_by)
      throw StatementError(unknown_surface(situation_, machine_, constraint));
  for (const Contact& contact : situation_.contacts)
    if (contact.rubs() && contact.grip == Grip::unknown)
      fail(situation_.file, contact.friction->mark,
           "whether " + contact.words() + " sticks or slides is not known here",
           "its state is found for the start of a situation only");
  if (!choice_.trial && !moving_)
    for (const ContactLimit& limit : machine_.contact_limits) {
      if (goes_beyond(limit, *mechanism_state_))
        throw UnansweredError(situation_.file, limit.mark, words_of_end(limit) + " as it moves on",
                              "it turns about a corner there: give it a shape with that corner, such as a polygon");
      if (leaves_plane(limit, *mechanism_state_, pace()))
        throw UnansweredError(situation_.file, limit.mark, words_of_side(limit), hint_of_side(limit));
    }
  assemble_motion_equations();
  find_pressing();
  return nonlinear_.at(System::motion);
}

void SolvedInstant::assemble_motion_equations() {
  StatedConditions<double> stated = force_conditions(view(), facts_, !moving_);
  motion_equations_ = solve::motion_equations(*mechanism_state_, scales_, stated.linear);
  find_flanks(stated.linear);
  sources_[System::motion] = std::move(stated.sources);
  nonlinear_[System::motion] = std::move(stated.nonlinear);
}

namespace {

const Gear& gear_named(const Situation& situation, const std::string& name) {
  return *std::ranges::find(situation.gears, name, &Gear::name);
}

// The components that turn wheels whose teeth rub.
std::vector<int> rubbing_leaders(const Mechanism<double>& mechanism) {
  std::vector<int> leaders;
  for (const Component<double>& component : mechanism.components)
    if (component.rubs) leaders.push_back(component.follows);
  return leaders;
}

}  // namespace

solve::LinearSolution SolvedInstant::tie_motion(const std::vector<solve::Condition>& conditions) {
  const std::size_t first = solve::force_unknowns(machine_.mechanism).accelerations;
  for (;;) {
    motion_equations_ = solve::motion_equations(*mechanism_state_, scales_, conditions);
    solve::LinearSolution solution = motion_equations_.solve();
    if (!tie_flanks(machine_.mechanism, solution, first)) return solution;
  }
}

// The force with which teeth push their wheels apart does no work, however it is taken up: the forces that turn the
// wheels are found without it, and their signs tell which flanks carry. Where they are open without it, it stays open
// too, unless the flanks of other wheels close them. The friction of teeth that slide does work: there both flanks are
// tried, of all such teeth together, and those carry whose force has their sign. So it is where bearings rub by what
// they carry.
void SolvedInstant::find_flanks(const std::vector<solve::Condition>& conditions) {
  Mechanism<double>& mechanism = machine_.mechanism;
  if (!untie_flanks(mechanism)) return;
  std::vector<int> leaders = rubbing_leaders(mechanism);
  const bool rubs = !leaders.empty();
  if (rubs) {
    if (const ToothMeshOf<double>* mesh = turn_against_slip(machine_, *mechanism_state_)) {
      const Gear& gear = gear_named(situation_, mesh->name);
      throw UnansweredError(situation_.file, gear.friction->mark(),
                            "the teeth of gear '" + gear.name +
                                "' do not slide here, and how much of their friction acts at rest is not told",
                            "state the rate at which a wheel turns, or leave out friction:");
    }
  }
  tie_motion(conditions);
  // What rubs in bearings depends on what they carry, so that it may take the flanks to tell the forces.
  for (const Component<double>& component : mechanism.components)
    if (component.parts_wheels && component.flank == 0 &&
        std::ranges::find(leaders, component.follows) == leaders.end())
      leaders.push_back(component.follows);
  constexpr std::size_t most = 6;  // each set of flanks is solved for
  if (leaders.empty() || (leaders.size() > most && !rubs)) return;
  if (leaders.size() > most)
    fail(situation_.file, situation_.gears.front().mark, "these are too many gears for friction in their teeth");
  const std::size_t first = solve::force_unknowns(mechanism).accelerations;
  struct Held {
    std::vector<int> flanks;
    std::vector<double> forces;
  };
  std::vector<Held> held;
  for (std::size_t choice = 0; choice < std::size_t{1} << leaders.size(); ++choice) {
    const auto sign = [&](std::size_t k) { return (choice >> k & 1) != 0 ? -1 : 1; };
    untie_flanks(mechanism);
    for (std::size_t k = 0; k < leaders.size(); ++k)
      for (Component<double>& component : mechanism.components)
        if (component.parts_wheels && component.follows == leaders[k]) component.flank = sign(k);
    const solve::LinearSolution solution = tie_motion(conditions);
    double largest = 0;
    for (std::size_t k = first; k < solution.value.size(); ++k)
      largest = std::max(largest, std::abs(solution.value[k]));
    const double rounding = 1e-9 * largest;  // what its equation leaves of a force that vanishes
    bool holds = solution.conflict.empty() || choice_.trial;
    Held one{flanks_of(mechanism), {}};
    for (std::size_t k = 0; k < leaders.size(); ++k) {
      const std::size_t turning = first + static_cast<std::size_t>(leaders[k]);
      holds = holds && solution.determined(turning) && solution.value[turning] * sign(k) >= -rounding;
      one.forces.push_back(solution.value[turning]);
    }
    // A force that vanishes is the same on either flank.
    const bool known = std::ranges::any_of(held, [&](const Held& other) {
      return std::ranges::equal(other.forces, one.forces,
                                [&](double a, double b) { return std::abs(a - b) <= 2 * rounding; });
    });
    if (holds && !known) held.push_back(std::move(one));
  }
  if (held.size() == 1 || (rubs && choice_.trial && !held.empty())) {
    put_flanks(mechanism, held.front().flanks);
    motion_equations_ = solve::motion_equations(*mechanism_state_, scales_, conditions);
    return;
  }
  if (rubs && !choice_.trial) {
    const auto rubbing =
        std::ranges::find_if(situation_.gears, [](const Gear& gear) { return gear.friction.has_value(); });
    if (!held.empty())
      throw UnansweredError(situation_.file, rubbing->friction->mark(),
                            "the friction of teeth lets either flank carry, so that there are several motions",
                            "state more of what drives the wheels");
    throw UnansweredError(situation_.file, rubbing->friction->mark(),
                          "the friction of teeth lets neither flank carry: the wheels jam in this motion, or what is "
                          "stated of forces does not tell which do",
                          "a wheel cannot drive its worm where the lead angle is too small for the friction");
  }
  // The push stays open where several sets of flanks hold, or all leave it open.
  untie_flanks(mechanism);
  tie_motion(conditions);
}

void SolvedInstant::solve_motion_equations(const std::vector<const Fact*>& nonlinear) {
  solve::LinearSolution solution = motion_equations_.solve();
  if (choice_.trial)
    take_misfits(solution);
  else if (!solution.conflict.empty())
    contradiction(System::motion, solution);
  if (!choice_.trial) require_known_pressing(solution);
  const std::size_t accelerations = solve::force_unknowns(machine_.mechanism).accelerations;
  // The forces set the pace by which facts are held.
  motion_ = std::move(solution);
  unknowns_ = motion_->value;
  try {
    hold_nonlinear(System::motion, nonlinear, *motion_);
  } catch (...) {
    motion_.reset();
    throw;
  }
  const std::vector<std::size_t> one_sided = one_sided_unknowns(accelerations);
  const std::vector<FrictionCone> cones = friction_cones(accelerations);
  for (const std::vector<int>& chain : machine_.chains) {
    std::vector<std::size_t> sides;
    for (const int side : chain) sides.push_back(accelerations + static_cast<std::size_t>(side));
    slacken_chain(*motion_, sides);
  }
  if (!choice_.trial) {
    share_without_pull(*motion_, one_sided, accelerations);
    if (!cones.empty()) share_within_cones(*motion_, one_sided, cones, accelerations);
  }
  unknowns_ = motion_->value;
  if (choice_.forces) {
    // By about as much as acts here: moved by more, the forces that stay the same would change by its rounding.
    move_along(*motion_, unknowns_, motion_->size > 0 ? motion_->size : 1);
    keep_pushing(motion_->value, one_sided, unknowns_);
    if (!cones.empty()) keep_sticking(motion_->value, cones, unknowns_);
  }
  const auto n = static_cast<std::ptrdiff_t>(machine_.mechanism.tree.velocity_size());
  mechanism_state_->set_accelerations(std::vector<double>(unknowns_.begin(), unknowns_.begin() + n));
  if (!choice_.trial && !moving_)
    for (const ContactLimit& limit : machine_.contact_limits)
      if (!is_of_rod(limit, situation_) && begins_to_leave_plane(limit, *mechanism_state_, pace())) {
        motion_.reset();
        throw UnansweredError(situation_.file, limit.mark, words_of_side(limit), hint_of_flat_side(limit));
      }
}

std::vector<std::size_t> SolvedInstant::one_sided_unknowns(std::size_t first) const {
  std::vector<std::size_t> unknowns;
  for (std::size_t k = 0; k < machine_.mechanism.components.size(); ++k)
    if (machine_.mechanism.components[k].one_sided) unknowns.push_back(first + k);
  return unknowns;
}

std::vector<FrictionCone> SolvedInstant::friction_cones(std::size_t first) const {
  std::vector<FrictionCone> cones;
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    if (contact.grip != Grip::sticks) continue;
    if (contact.of_belt) continue;  // What its sides share is told by its initial tension.
    if (contact.on_cord()) {
      // Neither tension is more than so many times the other.
      const double most = capstan_of(*mechanism_state_, contact).value_or(1);
      std::vector<std::size_t> sides;
      for (std::size_t k = 0; k < machine_.mechanism.components.size(); ++k)
        if (const int action = machine_.mechanism.components[k].action;
            action == contact.action || action == contact.behind)
          sides.push_back(first + k);
      if (sides.size() != 2) continue;
      cones.push_back({sides[0], sides[1], std::nullopt, most});
      cones.push_back({sides[1], sides[0], std::nullopt, most});
      continue;
    }
    // Its components are the push and two across it, or in a planar problem one, in this order.
    std::vector<std::size_t> own;
    for (std::size_t k = 0; k < machine_.mechanism.components.size(); ++k)
      if (machine_.mechanism.components[k].action == contact.action) own.push_back(first + k);
    if (own.size() < 2) continue;
    cones.push_back({own[0], own[1], own.size() > 2 ? std::optional(own[2]) : std::nullopt, contact.resting});
  }
  return cones;
}

Vector3<double> SolvedInstant::rough_normal(std::size_t contact) const {
  return machine_.rough_contacts[contact].normal.vector;
}

RoughMotion<double> SolvedInstant::rough_motion_as_drawn(std::size_t contact, bool accelerations) const {
  const RoughContactOf<double>& rough = machine_.rough_contacts[contact];
  RoughMotion<double> motion = rough_motion(*mechanism_state_, rough, accelerations);
  if (rough.all_ways) {
    motion.slip =
        direction_on_body(machine_.mechanism.tree, mechanism_state_->workspace(), rough.normal.body, motion.slip);
    return motion;
  }
  Vector3<double> slip{};
  for (const std::size_t k : {1, 2})
    slip += dot(motion.slip, direction_now(*mechanism_state_, rough, rough.motions[k].along)) *
            rough.motions[k].along.vector;
  motion.slip = slip;
  return motion;
}

std::optional<std::vector<SolvedInstant::Between>> SolvedInstant::over_all_shares(
    const Expression& expression, const std::optional<Expression>& axes) {
  if (!motion_ || motion_->open.empty()) return std::nullopt;
  const std::vector<double> found = unknowns_;
  // Other shares are not what is told.
  const bool writes_told = std::exchange(writes_told_, false);
  const auto numbers_at = [&](const std::vector<double>& forces) {
    unknowns_ = forces;
    const Value<double> value = ask(expression, axes, nullptr);
    return value.is_vector()   ? std::vector<double>{value.vector.x, value.vector.y, value.vector.z}
           : value.is_number() ? std::vector<double>{value.number}
                               : std::vector<double>{};
  };
  const std::size_t directions = motion_->open.size();
  // One more place shows whether the value is linear; rounding leaves a millionth of a millionth of its terms.
  constexpr double rounding = 1e-10;
  std::vector<double> here, size;
  std::vector<std::vector<double>> slopes;  // of each number, along each direction
  bool linear = true;
  try {
    const auto moved = [&](const std::vector<double>& t) {
      std::vector<double> forces = found;
      for (std::size_t d = 0; d < directions; ++d)
        for (std::size_t k = 0; k < forces.size(); ++k) forces[k] += t[d] * motion_->open[d][k];
      return numbers_at(forces);
    };
    here = numbers_at(found);
    slopes.assign(here.size(), std::vector<double>(directions, 0));
    const double amount = motion_->size > 0 ? motion_->size : 1;
    std::vector<double> all(directions), expected = here;
    size.assign(here.size(), 0);
    for (std::size_t d = 0; d < directions; ++d) {
      std::vector<double> one(directions, 0);
      one[d] = amount;
      all[d] = (d % 2 == 0 ? -0.7 : 1.3) * amount;
      const std::vector<double> there = moved(one);
      for (std::size_t i = 0; i < here.size(); ++i) {
        slopes[i][d] = (there[i] - here[i]) / amount;
        expected[i] += all[d] * slopes[i][d];
        size[i] += std::abs(all[d] * slopes[i][d]) + std::abs(here[i]);
      }
    }
    const std::vector<double> there = moved(all);
    for (std::size_t i = 0; i < here.size(); ++i)
      linear = linear && std::abs(there[i] - expected[i]) <= rounding * size[i];
  } catch (const StatementError&) {
    linear = false;
  }
  unknowns_ = found;
  writes_told_ = writes_told;
  if (!linear || here.empty()) return std::nullopt;
  const std::size_t accelerations = solve::force_unknowns(machine_.mechanism).accelerations;
  const std::vector<std::size_t> one_sided = one_sided_unknowns(accelerations);
  const std::vector<FrictionCone> cones = friction_cones(accelerations);
  const auto largest = [&](const std::vector<double>& along) {
    return cones.empty() ? largest_over_shares(*motion_, one_sided, accelerations, along)
                         : largest_within_cones(*motion_, one_sided, cones, accelerations, along);
  };
  std::vector<Between> ranges;
  for (std::size_t i = 0; i < here.size(); ++i) {
    std::vector<double> down = slopes[i];
    for (double& slope : down) slope = -slope;
    const std::optional<double> more = largest(slopes[i]), less = largest(down);
    if (!more || !less) return std::nullopt;
    const auto without_rounding = [&](double end) { return std::abs(end) <= rounding * size[i] ? 0 : end; };
    ranges.push_back({without_rounding(here[i] - *less), without_rounding(here[i] + *more)});
  }
  return ranges;
}

}  // namespace poinsot::problem
