#include "problem/answers/asked_size.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "poinsot/engine/dynamics/momentum.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/quantities/asks_model.h"
#include "problem/results/compare_values.h"

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

// The size of a quantity, without regard to how the ask goes on with it.
double size_of_quantity(const SolvedInstant& instant, const Situation& situation, const Expression& expression,
                        const Dimension& dimension) {
  if (dimension.time > 0) return 0;
  std::set<std::string> names;
  collect_all_names(situation, expression, names);
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

class AskedSize {
 public:
  AskedSize(SolvedInstant& instant, const Situation& situation) : instant_(instant), situation_(situation) {}

  double of(const Expression& expression, const Dimension& dimension, int depth = 0) {
    constexpr int deepest = 50;  // of names under define: that lead to others
    if (const Unary* sign = expression.as<Unary>()) return of(sign->operand, dimension, depth);
    if (const At* at = expression.as<At>()) return of(at->expression, dimension, depth);
    if (const Member* part = expression.as<Member>()) return of(part->object, dimension, depth);
    if (const Name* name = expression.as<Name>(); name && name->primes == 0 && depth < deepest)
      for (const NamedExpression& item : situation_.define)
        if (item.name == name->name) return of(item.value, dimension, depth + 1);
    if (const Binary* two = expression.as<Binary>()) {
      const std::optional<Factor> left = datum(two->left), right = datum(two->right);
      const char sign = two->operation;
      if (sign == '+' || sign == '-')
        return std::max(left ? left->size : of(two->left, dimension, depth),
                        right ? right->size : of(two->right, dimension, depth));
      if (sign == '*' && left) return left->size * of(two->right, dimension / left->dimension, depth);
      if (sign == '*' && right) return of(two->left, dimension / right->dimension, depth) * right->size;
      if (sign == '/' && right && right->size > 0)
        return of(two->left, dimension * right->dimension, depth) / right->size;
    }
    return size_of_quantity(instant_, situation_, expression, dimension);
  }

 private:
  struct Factor {
    double size = 0;
    Dimension dimension;
  };
  // What asks nothing of the model and has a value.
  std::optional<Factor> datum(const Expression& expression) {
    if (asks_model(situation_, expression)) return std::nullopt;
    try {
      const Value<double> value = instant_.raw(expression, std::nullopt, nullptr);
      if (value.is_number() || value.is_vector()) return Factor{size_of(value), value.dimension};
    } catch (const StatementError&) {
      // It has a value elsewhere only, as a time of the motion.
    }
    return std::nullopt;
  }

  SolvedInstant& instant_;
  const Situation& situation_;
};

}  // namespace

double asked_size(SolvedInstant& instant, const Situation& situation, const Ask& ask, const Dimension& dimension) {
  double size = 0;
  for (const Expression& expression : ask.of)
    size = std::max(size, AskedSize(instant, situation).of(expression, dimension));
  return size;
}

}  // namespace poinsot::problem
