// What a contact with dry friction does at an instant.
//
// The body `on` comes apart from `from` along the normal n and slips across it. With the push N and the friction F on
// `on`, and with the coefficients m0 at rest and m while it slides (Coulomb):
//   it sticks:  no slip and none to come,    N >= 0, |F| <= m0 N;
//   it slides:  a slip along d, or one that begins along d,  N >= 0, F = -m N d;
//   it parts:   N = 0, F = 0, and the surfaces move apart.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/solve/instant/equations.h"
#include "problem/machine/machine.h"

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

// By the velocities of a state, or by its accelerations, which stand in the bias of a constraint's row.
template <class Base>
RoughMotion<Base> rough_motion(const solve::MechanismStateOf<Base>& state, const RoughContactOf<Base>& contact,
                               bool accelerations) {
  const std::vector<Base>& values = accelerations ? state.accelerations() : state.state().v;
  RoughMotion<Base> motion{Base(0), {Base(0), Base(0), Base(0)}, 0};
  if (contact.coordinate >= 0) {
    const Base& rate = values[static_cast<std::size_t>(contact.coordinate)];
    motion.size = std::abs(plain(rate));
    motion.slip = rate * state.direction(contact.motions[1].along);
    return motion;
  }
  for (std::size_t i = 0; i < contact.motions.size(); ++i) {
    VelocityConstraint<Base> way = contact.motions[i];
    way.at = place_of(state.mechanism(), contact);
    const solve::ConstraintRow<Base> row = solve::constraint_row(state, way);
    Base sum(0);
    for (std::size_t k = 0; k < row.coefficients.size(); ++k) {
      const Base term = row.coefficients[k] * values[k];
      motion.size = std::max(motion.size, std::abs(plain(term)));
      sum += term;
    }
    if (accelerations) sum = row.bias;
    motion.size = std::max(motion.size, std::abs(plain(sum)));
    if (i == 0)
      motion.apart = sum;
    else
      motion.slip += sum * state.direction(contact.motions[i].along);
  }
  return motion;
}

// The force of a contact on `on`, in its part along the normal and that across it; of friction in a joint its couple or
// force, beside a push of one.
template <class Base>
struct RoughForce {
  Base push{};
  Vector3<Base> friction{};
};

template <class Base>
RoughForce<Base> rough_force(const solve::MechanismStateOf<Base>& state, const std::vector<Base>& unknowns,
                             const RoughContactOf<Base>& contact) {
  const SpatialForce<Base> wrench = solve::action_wrench(state, unknowns, static_cast<std::size_t>(contact.action));
  if (contact.coordinate >= 0) {
    const Vector3<Base> axis = state.direction(contact.motions[1].along);
    return {Base(1), dot(contact.turning ? wrench.moment : wrench.force, axis) * axis};
  }
  const Vector3<Base> n = state.direction(contact.normal);
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
template <class Base>
bool stays_in_state(const solve::MechanismStateOf<Base>& state, const std::vector<Base>& unknowns,
                    const RoughContactOf<Base>& contact, double force_size) {
  // Of the forces and motions that meet in a contact: the rounding of equations of a few dozen terms, and what is left
  // of a limit to which an unknown was sought.
  constexpr double rounding = 1e-9;
  // Between the direction in which it was taken to slide and that in which it does, where that was sought.
  constexpr double same_direction = 1e-8;
  const RoughForce<Base> force = rough_force(state, unknowns, contact);
  if (contact.grip == Grip::sticks)
    return norm(plain(force.friction)) <=
           (1 + rounding) * plain(contact.resting) * plain(force.push) + rounding * force_size;
  const RoughMotion<Base> now = rough_motion(state, contact, false), then = rough_motion(state, contact, true);
  if (contact.grip == Grip::parts)
    return std::abs(plain(now.apart)) > rounding * now.size ? plain(now.apart) > 0
                                                            : plain(then.apart) > rounding * then.size;
  if (contact.grip != Grip::slides || !contact.slip) return false;
  // What is at rest begins to slip where its slip grows. One that turns has a direction as long as there is any of it.
  const bool slips = norm(plain(now.slip)) > (contact.turns ? 0 : rounding * now.size);
  const Vector3<double> slip = plain(slips ? now.slip : then.slip);
  if (!(norm(slip) > (!slips ? rounding * then.size : contact.turns ? 0 : rounding * now.size))) return false;
  return norm(normalized(slip) - plain(state.direction(*contact.slip))) <= same_direction;
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
