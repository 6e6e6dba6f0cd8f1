// The forces that the actions of a Mechanism exert on body `on`, and reversed on body `from`, in a pose with
// velocities; the energy that its laws of force store, and the power that they bring and take.
#pragma once

#include <algorithm>
#include <cstddef>

#include "poinsot/engine/dynamics/mechanism.h"

namespace poinsot {

// The force (N) or couple (N m) of a component of size one. After update_poses.
template <class Scalar>
PlacedForce<Scalar> component_force(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                    const Component<Scalar>& component) {
  if (component.span) return reversed(span_force(tree, w, *component.span));
  const Vector3<Scalar> P = point_position(tree, w, component.at.body, component.at.point);
  const Vector3<Scalar> none = Vector3<Scalar>::zero();
  if (component.toward)
    return {P, normalized(point_position(tree, w, component.toward->body, component.toward->point) - P), none};
  const Vector3<Scalar> d = direction_on_ground(tree, w, component.along.body, component.along.vector);
  if (component.couple) return {P, none, d};
  return {P, d, component.couple_per_force * d};
}

// V of all laws of force and drives, J; the potential of the weights is the tree's own (momentum.h). After update_poses
// at these positions.
template <class Scalar>
Scalar stored_energy(const Mechanism<Scalar>& mechanism, const Workspace<Scalar>& w, const State<Scalar>& state) {
  Scalar energy(0);
  for_each_law(mechanism, [&](const auto& law) { energy += law.stored_energy(mechanism.tree, w); });
  for (const Drive<Scalar>& drive : mechanism.drives) energy += drive.stored_energy(state);
  return energy;
}

// The power of all laws of force and drives that no potential accounts for, W. After update_velocities at this state.
template <class Scalar>
Scalar unstored_power(const Mechanism<Scalar>& mechanism, const Workspace<Scalar>& w, const State<Scalar>& state) {
  Scalar power(0);
  for (const Drive<Scalar>& drive : mechanism.drives) power += drive.unstored_power(state);
  for_each_law(mechanism, [&](const auto& law) {
    const Action& action = mechanism.actions[static_cast<std::size_t>(law.action)];
    power += law.unstored_power(mechanism.tree, w, action.on, action.from);
  });
  return power;
}

namespace detail {

template <class Scalar, class Predicate>
bool any_law(const Mechanism<Scalar>& mechanism, Predicate&& predicate) {
  bool found = std::any_of(mechanism.drives.begin(), mechanism.drives.end(), predicate);
  for_each_law(mechanism, [&](const auto& law) { found = found || predicate(law); });
  return found;
}

}  // namespace detail

// Whether any law or drive may bring energy in from outside, takes energy out for good, or has a potential. A
// mechanism whose laws neither feed nor drain keeps its energy unless motions are given.
template <class Scalar>
bool laws_feed(const Mechanism<Scalar>& mechanism) {
  return detail::any_law(mechanism, [](const auto& law) { return law.feeds(); });
}
template <class Scalar>
bool laws_drain(const Mechanism<Scalar>& mechanism) {
  return detail::any_law(mechanism, [](const auto& law) { return law.drains(); });
}
template <class Scalar>
bool laws_store(const Mechanism<Scalar>& mechanism) {
  return detail::any_law(mechanism, [](const auto& law) { return law.stores(); });
}

}  // namespace poinsot
