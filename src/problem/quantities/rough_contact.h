// What a contact with dry friction does at an instant.
//
// The body `on` comes apart from `from` along the normal n and slips across it. With the push N and the friction F on
// `on`, and with the coefficients m0 at rest and m while it slides (Coulomb):
//   it sticks:  no slip and none to come,    N >= 0, |F| <= m0 N;
//   it slides:  a slip along d, or one that begins along d,  N >= 0, F = -m N d;
//   it parts:   N = 0, F = 0, and the surfaces move apart.
// Friction in a joint is alike, with its couple or force for F and with N of one, or as its bearing has it
// (joint_pressing.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

#include "poinsot/engine/dynamics/capstan.h"
#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "poinsot/engine/solve/instant/equations.h"
#include "problem/machine/machine.h"
#include "problem/quantities/joint_pressing.h"

namespace poinsot::problem {

// What a cord, a contact or the state of a contact with friction is taken to do.
enum class Holding { pulls, presses, sticks, slides, parts };

// How fast a contact comes apart and slips, or the rates of that, and the size of the terms of either.
template <class Base>
struct RoughMotion {
  Base apart{};
  Vector3<Base> slip{};  // of `on` over `from`, on ground axes
  double size = 0;
};

// The direction of the force of a contact that slides, n - m d, of which the size is the push.
template <class Base>
Vector3<Base> along_sliding_force(const RoughContactOf<Base>& contact) {
  return contact.normal.vector - contact.sliding * contact.slip->vector;
}

// Where the bodies touch in this pose. What rolls touches elsewhere than as drawn; its forces are moved with it.
template <class Base>
const Place<Base>& place_of(const Mechanism<Base>& mechanism, const RoughContactOf<Base>& contact) {
  for (const Component<Base>& component : mechanism.components)
    if (component.action == contact.action) return component.at;
  return contact.motions.front().at;
}

// A direction of the contact as drawn, on ground axes where it is now: on curved surfaces it turns with their normal.
template <class Base>
Vector3<Base> direction_now(const solve::MechanismStateOf<Base>& state, const RoughContactOf<Base>& contact,
                            const Direction<Base>& drawn) {
  const VelocityConstraint<Base>& way = contact.motions.front();
  if (way.kind != VelocityConstraintKind::touching) return state.direction(drawn);
  const Model<Base>& tree = state.mechanism().tree;
  const Workspace<Base>& w = state.workspace();
  return detail::with_normal(tree, w, way, detail::touching_now(tree, w, way).normal, state.direction(drawn));
}

// The tension of a straight part of a cord or belt: of its components together.
template <class Base>
Base tension_of(const solve::MechanismStateOf<Base>& state, const std::vector<Base>& unknowns, int action) {
  const std::size_t first = solve::force_unknowns(state.mechanism()).accelerations;
  Base tension(0);
  for (std::size_t k = 0; k < state.mechanism().components.size(); ++k)
    if (state.mechanism().components[k].action == action) tension += unknowns[first + k];
  return tension;
}

// The straight part of a cord that an action is; null if the cord does not act.
template <class Base>
const CordSpan<Base>* span_of(const Mechanism<Base>& mechanism, int action) {
  for (const Component<Base>& component : mechanism.components)
    if (component.action == action && component.span) return &*component.span;
  return nullptr;
}

// The angle of a cord round its wheel or post in this pose; nothing of other contacts.
template <class Base>
std::optional<Base> angle_round(const solve::MechanismStateOf<Base>& state, const RoughContactOf<Base>& contact) {
  const Mechanism<Base>& mechanism = state.mechanism();
  const CordSpan<Base>* before = contact.on_cord() ? span_of(mechanism, contact.action) : nullptr;
  const CordSpan<Base>* behind = contact.on_cord() ? span_of(mechanism, contact.behind) : nullptr;
  if (!before || !behind) return std::nullopt;
  const Workspace<Base>& w = state.workspace();
  return Base(contact.wrap + wrap_change(mechanism.tree, w, *behind, line_of(mechanism.tree, w, *before).along,
                                         line_of(mechanism.tree, w, *behind).along));
}

// How many times the other one a tension of a cord may be that does not slip, by the angle of this pose; nothing of
// other contacts.
template <class Base>
std::optional<Base> capstan_of(const solve::MechanismStateOf<Base>& state, const RoughContactOf<Base>& contact) {
  const std::optional<Base> angle = angle_round(state, contact);
  if (!angle) return std::nullopt;
  return capstan_ratio(Base(contact.friction_at_rest * *angle));
}

// The coefficient of friction at rest, or of a cord that of Coulomb's law for the sum of its tensions.
template <class Base>
Base resting_of(const solve::MechanismStateOf<Base>& state, const RoughContactOf<Base>& contact) {
  const std::optional<Base> ratio = capstan_of(state, contact);
  return ratio ? capstan_coefficient(*ratio) : contact.resting;
}

// Along one way of a contact, by the velocities of a state, or by its accelerations, which stand in the bias of the
// constraint's row. size grows to that of its largest term, beside which the rest is rounding.
template <class Base>
Base rate_along(const solve::MechanismStateOf<Base>& state, const VelocityConstraint<Base>& way, bool accelerations,
                double& size) {
  const std::vector<Base>& values = accelerations ? state.accelerations() : state.state().v;
  const solve::ConstraintRow<Base> row = solve::constraint_row(state, way);
  Base sum(0);
  for (std::size_t k = 0; k < row.coefficients.size(); ++k) {
    const Base term = row.coefficients[k] * values[k];
    size = std::max(size, std::abs(plain(term)));
    sum += term;
  }
  if (accelerations) sum = row.bias;
  size = std::max(size, std::abs(plain(sum)));
  return sum;
}

// By the velocities of a state, or by its accelerations.
template <class Base>
RoughMotion<Base> rough_motion(const solve::MechanismStateOf<Base>& state, const RoughContactOf<Base>& contact,
                               bool accelerations) {
  const std::vector<Base>& values = accelerations ? state.accelerations() : state.state().v;
  RoughMotion<Base> motion{Base(0), {Base(0), Base(0), Base(0)}, 0};
  if (contact.in_joint()) {
    for (const RubbingWay<Base>& way : contact.ways) {
      const Base rate = way.arm * values[static_cast<std::size_t>(way.coordinate)];
      motion.size = std::max(motion.size, std::abs(plain(rate)));
      motion.slip += rate * state.direction(way.along);
    }
    return motion;
  }
  if (contact.on_cord()) {
    if (contact.motions[1].spans.empty()) return motion;  // a belt that does not slip
    motion.slip = rate_along(state, contact.motions[1], accelerations, motion.size) * contact.motions[1].along.vector;
    return motion;
  }
  for (std::size_t i = 0; i < contact.motions.size(); ++i) {
    VelocityConstraint<Base> way = contact.motions[i];
    way.at = place_of(state.mechanism(), contact);
    const Base rate = rate_along(state, way, accelerations, motion.size);
    if (i == 0)
      motion.apart = rate;
    else
      motion.slip += rate * direction_now(state, contact, contact.motions[i].along);
  }
  return motion;
}

// |V|; where it lies along an axis without a root, so that formulas stay short.
template <class Base>
Base size_along_axis(const Vector3<Base>& V) {
  if constexpr (std::is_same_v<Base, Formula>) {
    const Formula* only = nullptr;
    int parts = 0;
    for (const Formula* part : {&V.x, &V.y, &V.z})
      if (!part->is_zero()) only = part, ++parts;
    if (parts == 0) return Formula(0);
    if (const int sign = parts == 1 ? seen_sign(*only).sign : 0; sign != 0) return Formula(sign) * *only;
  }
  using std::sqrt;
  return sqrt(dot(V, V));
}

// The force of a contact on `on`, in its part along the normal and that across it; of friction in a joint its couple or
// force, beside a push of one or, where it follows from a coefficient, what presses in all.
template <class Base>
struct RoughForce {
  Base push{};
  Vector3<Base> friction{};
};

template <class Base>
RoughForce<Base> rough_force(const solve::MechanismStateOf<Base>& state, const std::vector<Base>& unknowns,
                             const RoughContactOf<Base>& contact) {
  if (contact.on_cord()) {
    const Base before = tension_of(state, unknowns, contact.action),
               behind = tension_of(state, unknowns, contact.behind);
    return {before + behind, (before - behind) * contact.motions[1].along.vector};
  }
  const SpatialForce<Base> wrench = solve::action_wrench(state, unknowns, static_cast<std::size_t>(contact.action));
  if (contact.in_joint()) {
    Base push(1);
    if (!contact.pressing.empty()) {
      push = Base(0);
      for (const Vector3<Base>& V : pressing_in(state, unknowns, contact)) push += size_along_axis(V);
    }
    Vector3<Base> friction = Vector3<Base>::zero();
    for (const RubbingWay<Base>& way : contact.ways)
      friction += effort_along(state, way, wrench) / way.arm * state.direction(way.along);
    return {push, friction};
  }
  const Vector3<Base> n = direction_now(state, contact, contact.normal);
  const Vector3<Base>& force = wrench.force;
  const Base push = dot(force, n);
  return {push, force - push * n};
}

// The size of the largest force of a mechanism, beside which others are rounding.
template <class Base>
double largest_force(const solve::MechanismStateOf<Base>& state, const std::vector<Base>& unknowns) {
  double size = 0;
  for (std::size_t i = 0; i < state.mechanism().actions.size(); ++i)
    size = std::max(size, norm(plain(solve::action_wrench(state, unknowns, i).force)));
  return size;
}

// Whether a contact that neither pulls nor pushes the wrong way stays in its state. force_size: the largest force.
// slow: with less than this speed it does not come apart, but for rounding. off_line: how fast it may slip across the
// line that was taken for it.
template <class Base>
bool stays_in_state(const solve::MechanismStateOf<Base>& state, const std::vector<Base>& unknowns,
                    const RoughContactOf<Base>& contact, double force_size, double slow = 0, double off_line = 0) {
  // Of the forces and motions that meet in a contact: the rounding of equations of a few dozen terms, and what is left
  // of a limit to which an unknown was sought.
  constexpr double rounding = 1e-9;
  // Between the direction in which it was taken to slide and that in which it does, where that was sought.
  constexpr double same_direction = 1e-8;
  const RoughForce<Base> force = rough_force(state, unknowns, contact);
  // What presses in a joint has the levers of its bearing.
  if (!contact.pressing.empty()) {
    double lever = 0;
    for (const PressingPart<Base>& part : contact.pressing) lever = std::max(lever, plain(part.lever));
    force_size *= lever;
  }
  if (contact.grip == Grip::sticks)
    return norm(plain(force.friction)) <=
           (1 + rounding) * plain(resting_of(state, contact)) * plain(force.push) + rounding * force_size;
  const RoughMotion<Base> now = rough_motion(state, contact, false), then = rough_motion(state, contact, true);
  if (contact.grip == Grip::parts)
    return std::abs(plain(now.apart)) > std::max(rounding * now.size, slow) ? plain(now.apart) > 0
                                                                            : plain(then.apart) > rounding * then.size;
  if (contact.grip != Grip::slides || !contact.slip) return false;
  // A bearing of no radius rubs with nothing but rounding.
  if (const double law = plain(contact.sliding) * plain(force.push);
      contact.found_with_reactions() && force_size > 0 &&
      std::abs(norm(plain(force.friction)) - law) > rounding * (law + force_size))
    return false;
  // What is at rest begins to slip where its slip grows. One that turns has a direction as long as there is any of it.
  const bool slips = norm(plain(now.slip)) > (contact.turns ? 0 : rounding * now.size);
  const Vector3<double> slip = plain(slips ? now.slip : then.slip);
  if (!(norm(slip) > (!slips ? rounding * then.size : contact.turns ? 0 : rounding * now.size))) return false;
  const double allowed = slips && !contact.turns
                             ? std::max(same_direction, std::max(off_line, contact.off_line) / norm(slip))
                             : same_direction;
  return norm(normalized(slip) - plain(direction_now(state, contact, *contact.slip))) <= allowed;
}

// Whether all of them do, and press as far as they touch.
template <class Base>
bool all_stay_in_state(const solve::MechanismStateOf<Base>& state, const std::vector<Base>& unknowns,
                       const std::vector<RoughContactOf<Base>>& contacts) {
  constexpr double rounding = 1e-9;  // of the largest force
  const double size = largest_force(state, unknowns);
  return std::ranges::all_of(contacts, [&](const RoughContactOf<Base>& contact) {
    return plain(rough_force(state, unknowns, contact).push) >= -rounding * size &&
           stays_in_state(state, unknowns, contact, size);
  });
}

}  // namespace poinsot::problem
