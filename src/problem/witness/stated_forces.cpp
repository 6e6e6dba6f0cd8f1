// With x the extent of a spring, x_0 its free one, and the effort M of a motor,
//
//   between two points, or about an axis:  -(k (x - x_0) + c dx/dt) along the way in which x grows,
//   in the freedom of a joint:             M - k (x - x_0) - c dx/dt.
#include "problem/witness/stated_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "poinsot/engine/model/state.h"
#include "poinsot/engine/solve/instant/equations.h"
#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"
#include "problem/witness/stated_attraction.h"
#include "problem/witness/stated_motion.h"
#include "problem/witness/stated_springs.h"

namespace poinsot::problem {
namespace {

using Real = StatedForce::Real;
using Vector = StatedForce::Vector;

class StatedForces {
 public:
  StatedForces(const solve::ParticlePaths& paths, const Machine& machine, DataScope<double>& data,
               const std::vector<double>& v, const std::optional<std::vector<std::string>>& loads)
      : paths_(paths), machine_(machine), data_(data), v_(v), loads_(loads), springs_(paths, machine, data, v) {}

  std::vector<StatedForce> all() {
    const Situation& situation = data_.situation();
    for_each_stated_law(situation, [&](const auto& law) { take([&] { return of(law); }); });
    for (const Joint& joint : situation.joints)
      for (const Freedom& freedom : joint.freedoms)
        if (freedom.effort || freedom.stiffness || freedom.damping) take([&] { return of(joint, freedom); });
    for (std::size_t i = 0; situation.central_gravity && i < machine_.masses.size(); ++i)
      take([&] { return of_center(i); });
    return std::move(found_);
  }

 private:
  template <class Of>
  void take(const Of& of) {
    try {
      if (const std::optional<StatedForce> force = of()) found_.push_back(*force);
    } catch (const StatementError&) {
      // Where a load has no value, such as at a speed of zero, the road ends.
    }
  }

  std::optional<std::size_t> action(ActionKind kind, const std::string& name) const {
    const std::vector<Action>& actions = machine_.mechanism.actions;
    const auto found =
        std::ranges::find_if(actions, [&](const Action& one) { return one.kind == kind && one.name == name; });
    if (found == actions.end()) return std::nullopt;
    return static_cast<std::size_t>(found - actions.begin());
  }

  // The size of a load with its direction, on ground axes; nothing where its direction is rounding.
  std::optional<Vector> vector_of(const Load& load) {
    const int axes = machine_.index.at(load.axes);
    StatedMotion scope(paths_, machine_, data_, v_, axes);
    const Evaluator<double> evaluator(scope, data_.situation().file);
    const Expression& size = load.couple ? *load.couple : *load.force;
    const Dimension dimension = load.couple ? dimensions::moment : dimensions::force;
    if (!load.direction) return paths_.turn(axes) * widened(evaluator.vector(size, dimension));
    const Value<double> direction = evaluator(*load.direction);
    const Vector along = widened(direction.vector);
    constexpr Real none = 1e-9L;
    const Real beside = direction.dimension.time != 0 ? paths_.pace() * paths_.length() : 0;
    if (!direction.is_vector() || !(norm(along) > none * beside)) return std::nullopt;
    return paths_.turn(axes) * (Real(evaluator.number(size, dimension)) * normalized(along));
  }

  std::optional<StatedForce> of(const Load& load) {
    const std::optional<std::size_t> place = action(ActionKind::load, load.name);
    if (!place) return std::nullopt;
    StatedForce found{*place};
    if (loads_ && std::ranges::find(*loads_, load.name) == loads_->end()) return found;
    const std::optional<Vector> vector = vector_of(load);
    if (!vector) return std::nullopt;
    (load.couple ? found.couple : found.force) = *vector;
    const int body = machine_.index.at(load.body);
    if (load.at)
      found.at = paths_.place(body, widened(data_.place(*load.at)));
    else if (!load.couple)
      found.at = paths_.place(body, StatedMotion(paths_, machine_, data_, v_, body).drawn_center(body));
    return found;
  }

  std::optional<StatedForce> of(const Spring& spring) {
    const std::optional<std::size_t> place = action(ActionKind::spring, spring.name);
    const std::optional<DrawnSpring> drawn = springs_.drawn(spring);
    if (!place || !drawn) return std::nullopt;
    const Real k = springs_.stiffness(spring), c = springs_.damping(spring);
    StatedForce found{*place};
    (spring.about ? found.couple : found.force) = -(k * drawn->out + c * drawn->rate) * drawn->along;
    found.at = drawn->end;
    found.size = k * drawn->size + c * std::max(std::abs(drawn->rate), paths_.pace() * drawn->size);
    return found;
  }

  std::optional<StatedForce> of(const Joint& joint, const Freedom& freedom) {
    const std::optional<std::size_t> place =
        action(ActionKind::drive, joint.name + (freedom.name.empty() ? "" : "." + freedom.name));
    const std::vector<Drive<double>>& drives = machine_.mechanism.drives;
    const auto drive = std::ranges::find_if(
        drives, [&](const Drive<double>& one) { return place && one.action == static_cast<int>(*place); });
    // How far it has come tells of springs and dampers alone.
    const std::optional<DrawnSpring> drawn = freedom.stiffness || freedom.damping
                                                 ? springs_.drawn(joint, freedom)
                                                 : std::optional<DrawnSpring>(std::in_place);
    if (drive == drives.end() || !drawn) return std::nullopt;
    const Real k = springs_.stiffness(freedom), c = springs_.damping(freedom);
    Real effort = -k * drawn->out - c * drawn->rate;
    StatedMotion scope(paths_, machine_, data_, v_, ground);
    if (freedom.effort)
      effort += Evaluator<double>(scope, data_.situation().file)
                    .number(*freedom.effort, freedom.turning ? dimensions::moment : dimensions::force);
    // The link of the freedom turns or slides along its axis as drawn, seen from its parent; the effort is that on
    // `to`.
    const int link = link_of(drive->coordinate), to = machine_.index.at(joint.to);
    const solve::CheckLink& moved = machine_.links[static_cast<std::size_t>(link)];
    const Vector axis = paths_.turn(link) * normalized(widened(moved.axis));
    const Real sign = hangs_on(to, link) ? 1 : -1;
    StatedForce found{*place};
    (freedom.turning ? found.couple : found.force) = sign * effort * axis;
    found.at = paths_.place(to, widened(moved.anchor));
    if (!drive->others.empty()) {
      found.only_about = axis;
      found.none_about = turning_beside(link, to, machine_.index.at(joint.from));
    }
    found.size = k * drawn->size + c * std::max(std::abs(drawn->rate), paths_.pace() * drawn->size);
    return found;
  }

  std::optional<StatedForce> of_center(std::size_t body) {
    const std::vector<Action>& actions = machine_.mechanism.actions;
    const auto action = std::ranges::find_if(actions, [&](const Action& one) {
      return one.kind == ActionKind::attraction && one.on == machine_.masses[body].first;
    });
    const std::optional<StatedAttraction> pull = stated_attraction(paths_, machine_, data_, body);
    if (action == actions.end() || !pull) return std::nullopt;
    StatedForce found{static_cast<std::size_t>(action - actions.begin())};
    found.force = pull->force;
    found.couple = pull->couple;
    found.at = pull->at;
    found.couple_size = pull->couple_size;
    return found;
  }

  int link_of(int coordinate) const {
    const auto moves = [&](const solve::CheckLink& link) {
      return link.velocity == coordinate &&
             (link.type == JointType::revolute || link.type == JointType::prismatic || link.type == JointType::screw);
    };
    const auto link = std::ranges::find_if(machine_.links, moves);
    return static_cast<int>(link - machine_.links.begin());
  }
  // The axes of the other freedoms of a joint that turn; none where they leave no couple about the axis of this one
  // alone.
  std::vector<Vector> turning_beside(int link, int to, int from) const {
    const bool outwards = hangs_on(to, link);
    const int end = outwards ? from : to;
    std::vector<Vector> axes;
    for (int i = outwards ? to : from; i >= 0 && i != end; i = machine_.links[static_cast<std::size_t>(i)].parent) {
      const solve::CheckLink& other = machine_.links[static_cast<std::size_t>(i)];
      if (i != link && other.type == JointType::revolute)
        axes.push_back(paths_.turn(i) * normalized(widened(other.axis)));
    }
    const Vector own = paths_.turn(link) * normalized(widened(machine_.links[static_cast<std::size_t>(link)].axis));
    constexpr Real in_one_plane = 1e-6L;  // sine and volume of axes that are nearly so
    const Vector across = axes.size() == 2 ? cross(axes[0], axes[1]) : Vector::zero();
    const Real room = axes.size() == 1   ? norm(cross(own, axes[0]))
                      : axes.size() == 2 ? std::abs(dot(own, across))
                                         : Real(0);
    return room > in_one_plane ? axes : std::vector<Vector>();
  }
  bool hangs_on(int body, int link) const {
    for (int i = body; i >= 0; i = machine_.links[static_cast<std::size_t>(i)].parent)
      if (i == link) return true;
    return false;
  }

  const solve::ParticlePaths& paths_;
  const Machine& machine_;
  DataScope<double>& data_;
  const std::vector<double>& v_;
  const std::optional<std::vector<std::string>>& loads_;
  const StatedSprings springs_;
  std::vector<StatedForce> found_;
};

}  // namespace

std::vector<StatedForce> stated_forces(const solve::ParticlePaths& paths, const Machine& machine,
                                       DataScope<double>& data, const std::vector<double>& v,
                                       const std::optional<std::vector<std::string>>& loads) {
  return StatedForces(paths, machine, data, v, loads).all();
}

// Of belts and chains, as a part of the largest tension: how far the work is from zero that their sides do against
// their initial tension, each pulled out by as much as it is long; and what the slackest side of a chain pulls, round
// wheels on one body.
double SolvedInstant::belt_misfit() const {
  double worst = 0;
  for (const Belt& belt : situation_.belts) {
    double work = 0, length = 0, most = 0, least = std::numeric_limits<double>::infinity();
    const double initial = belt.tension ? data_->number(*belt.tension, dimensions::force) : 0;
    for (std::size_t i = 0; i < machine_.mechanism.actions.size(); ++i) {
      const auto part =
          std::ranges::find(machine_.mechanism.components, static_cast<int>(i), &Component<double>::action);
      if (machine_.mechanism.actions[i].name != belt.name || part == machine_.mechanism.components.end() || !part->span)
        continue;
      const Vector3<double> way = mechanism_state_->position(*part->toward) - mechanism_state_->position(part->at);
      const double tension = dot(solve::action_wrench(*mechanism_state_, unknowns_, i).force, normalized(way));
      work += (tension - initial) * norm(way);
      length += norm(way);
      most = std::max(most, std::abs(tension));
      least = std::min(least, tension);
    }
    if (!(most > 0)) continue;
    if (belt.tension) worst = std::max(worst, std::abs(work) / (length * most));
    std::set<std::string> carriers;
    for (const CordWheel& wheel : belt.over)
      for (const Joint& joint : situation_.joints)
        if (joint.to == wheel.name) carriers.insert(joint.from);
    if (belt.chain && carriers.size() == 1) worst = std::max(worst, std::abs(least) / most);
  }
  return worst;
}

solve::ParticlePaths paths_of(const solve::MechanismState& state, const Machine& machine, double reach) {
  std::vector<solve::ParticlePaths::Body> bodies;
  for (const auto& [link, mass] : machine.masses) bodies.push_back({link, &mass.particles});
  return {machine.links, std::move(bodies), state.state().q, state.state().v, state.accelerations(), reach};
}

StatedForce drawn_force(const solve::MechanismState& state, const Machine& machine, DataScope<double>& data, int body,
                        const std::optional<Expression>& at, int axes, const Vector3<double>& drawn) {
  const solve::ParticlePaths paths = paths_of(state, machine, 0);
  StatedForce found;
  found.force = paths.turn(axes) * widened(drawn);
  found.at = paths.place(body, at ? widened(data.place(*at))
                                  : StatedMotion(paths, machine, data, state.state().v, body).drawn_center(body));
  return found;
}

// The check with particles takes the forces as the laws tell them: it sees no load that was read with the wrong sign.
double misfit_of_laws(const solve::MechanismState& state, const Machine& machine, DataScope<double>& data,
                      const std::optional<std::vector<std::string>>& loads, double unit, double force) {
  const Mechanism<double>& mechanism = machine.mechanism;
  const solve::ParticlePaths paths = paths_of(state, machine, mechanism.attractions.empty() ? 0 : unit);
  // What cancels leaves rounding of its terms, of which other forces and those that turn the motion round in its own
  // time give the size: less of them than this is not seen.
  constexpr Real unseen = 1e-4L;
  const Real length = std::max(Real(unit), paths.length());
  Real beside = force;
  for (int i = 0; i < mechanism.tree.body_count(); ++i)
    beside = std::max(beside, mechanism.tree.body(i).inertia.mass *
                                  (norm(widened(mechanism.tree.gravity())) + length * paths.pace() * paths.pace()));
  double worst = 0;
  const auto compare = [&](const Vector& off, Real size) {
    if (const Real misfit = norm(off); misfit != 0) worst = std::max(worst, static_cast<double>(misfit / size));
  };
  for (const StatedForce& one : stated_forces(paths, machine, data, state.state().v, loads)) {
    // Of a body that a center pulls about its own mass center.
    const int body = mechanism.actions[one.action].on;
    const Vector3<double> about =
        one.couple_size ? body_mass_center(mechanism.tree, state.workspace(), body) : Vector3<double>::zero();
    const SpatialForce<double> known = state.known_wrench(static_cast<int>(one.action), about);
    const Vector arm = one.couple_size ? Vector::zero() : one.at;
    const Vector moment = widened(known.moment) - cross(arm, widened(known.force));
    const Real force_size = norm(widened(known.force)) + norm(one.force) + one.size + unseen * beside,
               moment_size = norm(widened(known.moment)) + norm(one.couple) + one.size + length * force_size;
    if (one.only_about) {
      compare(dot(moment - one.couple, *one.only_about) * *one.only_about, moment_size);
      for (const Vector& other : one.none_about) compare(dot(moment, other) * other, moment_size);
      continue;
    }
    compare(widened(known.force) - one.force, force_size);
    if (one.couple_size) {
      // Its arms from the origin of the body are known to twenty units in the last place.
      const Real arms =
          norm(widened(mechanism.tree.body(body).inertia.first_moment)) / mechanism.tree.body(body).inertia.mass;
      constexpr Real rounding = 20 * std::numeric_limits<double>::epsilon() / 1e-8L;
      compare(moment - one.couple, *one.couple_size + rounding * arms * norm(one.force));
      continue;
    }
    compare(moment - one.couple, moment_size);
  }
  return worst;
}

// Springs that are free where all rests, dampers there and a center that pulls what is symmetric about its way exert
// nothing: near a steady motion their laws count all the same.
double misfit_of_laws_beside(const solve::MechanismState& state, const Machine& machine, DataScope<double>& data,
                             const std::optional<std::vector<std::string>>& loads, double unit, double pace) {
  const Model<double>& tree = machine.mechanism.tree;
  std::vector<double> q = state.state().q, v = state.state().v, moved(v.size());
  for (std::size_t k = 0; k < v.size(); ++k) {
    // A little, and each coordinate by another part.
    const double size = solve::coordinate_turns(tree, static_cast<int>(k)) ? 1 : unit, place = static_cast<double>(k);
    moved[k] = 0.1 * size * std::cos(1 + 2 * place);
    v[k] += 0.1 * size * pace * std::cos(2 + 3 * place);
  }
  integrate_position<double>(tree, q, moved, 1);
  Machine moved_machine = machine;
  moved_machine.q = q;
  solve::MechanismState there(moved_machine.mechanism);
  there.set_positions(q);
  there.set_velocities(v);
  return misfit_of_laws(there, moved_machine, data, loads, unit, 0);
}

std::optional<double> SolvedInstant::law_misfit() const {
  const Mechanism<double>& mechanism = machine_.mechanism;
  bool any_law = false;
  for_each_law(mechanism, [&](const auto&) { any_law = true; });
  const auto stated = [](const Freedom& freedom) { return freedom.effort || freedom.stiffness || freedom.damping; };
  if (!any_law && situation_.belts.empty() && std::ranges::none_of(situation_.joints, [&](const Joint& joint) {
        return std::ranges::any_of(joint.freedoms, stated);
      }))
    return std::nullopt;
  const std::size_t stage = built_stage_.value_or(0);
  const auto acting = stage < situation_.stages.size() ? situation_.stages[stage].loads : std::nullopt;
  const double worst = misfit_of_laws(*mechanism_state_, machine_, *data_, acting, scales_.length,
                                      largest_force(*mechanism_state_, unknowns_));
  return std::max(worst, belt_misfit());
}

}  // namespace poinsot::problem
