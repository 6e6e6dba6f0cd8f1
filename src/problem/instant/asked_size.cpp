#include "problem/instant/asked_size.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "poinsot/engine/dynamics/momentum.h"
#include "problem/language/expression_walk.h"

namespace poinsot::problem {
namespace {

// Collects the names in an expression, and those behind its defined names.
void collect_all_names(const Situation& situation, const Expression& expression, std::set<std::string>& names) {
  std::set<std::string> own;
  collect_names(expression, own, true);
  for (const std::string& name : own) {
    if (!names.insert(name).second) continue;
    for (const NamedExpression& item : situation.define)
      if (item.name == name) collect_all_names(situation, item.value, names);
  }
}

// The bodies of an ask by their index in the tree: those it names, and those on which the actions that it names act.
struct AskedBodies {
  std::set<int> named, acted_on;
};

AskedBodies asked_bodies(const Machine& machine, const std::set<std::string>& names) {
  AskedBodies bodies;
  const auto has_mass = [&](int body) { return body >= 0 && machine.mechanism.tree.body(body).inertia.mass > 0; };
  for (const std::string& name : names) {
    if (const auto body = machine.index.find(name); body != machine.index.end()) {
      if (has_mass(body->second)) bodies.named.insert(body->second);
      continue;
    }
    for (const std::size_t i : machine.actions_of(name))
      for (const int body : {machine.mechanism.actions[i].on, machine.mechanism.actions[i].from})
        if (has_mass(body)) bodies.acted_on.insert(body);
    const NamedCoordinate* coordinate = machine.coordinate(name);
    const auto joint = machine.joints.find(coordinate ? coordinate->joint : name);
    if (joint == machine.joints.end()) continue;
    for (const int body : {joint->second.to, joint->second.from})
      if (has_mass(body)) bodies.acted_on.insert(body);
  }
  return bodies;
}

// The size for a single body with mass.
double size_of_body(const solve::MechanismState& placed, const SolvedInstant& instant, int body, const Dimension& d) {
  const Mechanism<double>& mechanism = placed.mechanism();
  const SpatialInertia<double>& inertia = mechanism.tree.body(body).inertia;
  const double mass = inertia.mass, arm = norm(inertia.first_moment) / mass;
  const double square = (inertia.inertia.xx + inertia.inertia.yy + inertia.inertia.zz) / (2 * mass) - arm * arm;
  // The size of a particle is its distance from the origin of its body.
  double length = square > 1e-12 * arm * arm ? std::sqrt(square) : arm;
  if (!(length > 1e-9 * instant.scales().length)) length = instant.scales().length;
  const BodyMotion<double>& motion = placed.workspace().motion[static_cast<std::size_t>(body + 1)];
  double pace = std::max(norm(motion.w), norm(motion.v) / length);
  pace = std::max({pace, std::sqrt(norm(motion.alpha)), std::sqrt(norm(motion.a) / length)});
  pace = std::max(pace, std::sqrt(norm(mechanism.tree.gravity()) / length));
  if (instant.forces_solved())
    for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
      if (mechanism.actions[i].on != body && mechanism.actions[i].from != body) continue;
      const double force = norm(solve::action_wrench(placed, instant.motion().value, i).force);
      pace = std::max(pace, std::sqrt(force / (mass * length)));
    }
  return std::pow(length, d.length / 12.0) * std::pow(mass, d.mass / 12.0) *
         (d.time == 0 ? 1 : std::pow(pace, -d.time / 12.0));
}

}  // namespace

double asked_size(const SolvedInstant& instant, const Situation& situation, const Ask& ask,
                  const Dimension& dimension) {
  if (dimension.time > 0) return 0;
  std::set<std::string> names;
  for (const Expression& expression : ask.of) collect_all_names(situation, expression, names);
  const Machine& machine = instant.machine();
  const AskedBodies bodies = asked_bodies(machine, names);
  if (names.contains("system") || (bodies.named.empty() && bodies.acted_on.empty()))
    return instant.natural_size(dimension);
  const MotionState state = instant.state();
  solve::MechanismState placed(machine.mechanism);
  placed.set_positions(state.q);
  placed.set_velocities(state.v);
  if (instant.forces_solved()) {
    const auto& solved = instant.motion().value;
    placed.set_accelerations({solved.begin(), solved.begin() + machine.mechanism.tree.velocity_size()});
  }
  const bool named = !bodies.named.empty();
  double size = 0;
  for (const int body : named ? bodies.named : bodies.acted_on) {
    const double own = size_of_body(placed, instant, body, dimension);
    size = size == 0 ? own : named ? std::max(size, own) : std::min(size, own);
  }
  // A small body that moves fast does not turn at that rate.
  return std::min(size, instant.natural_size(dimension));
}

}  // namespace poinsot::problem
