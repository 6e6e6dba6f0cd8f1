// What presses in a joint whose friction follows from what it carries: of each part (machine.h) the vector V, linear in
// the unknown forces. With the axis e, the place P, the force f and the moment m about P that the joint exerts:
//   across  V = r (f - (f . e) e),   along  V = r (f . e) e,
//   whole   V = r f, of a ball in its socket,
//   end     V = r ((f - (f . e) e)/2 + (m x e)/L), as the forces at the ends P + e L/2 and P - e L/2 add up to those,
//   thread  V = (r' (f . e) + c M) e, with the couple M of the friction itself (machine_friction.cpp).
// The friction is at most m0 (|V1| + |V2| + ...) while the joint holds, and m times that against its rate while it
// moves. Where the joint slips in several ways together, s = s1 e1 + s2 e2 + ... with s_i = r_i v_i of their rates, the
// friction is F = -m (|V1| + ...) s/|s|, and the effort of each way, whose power is that of F, r_i F . e_i.
#pragma once

#include <utility>
#include <vector>

#include "poinsot/engine/solve/instant/equations.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

template <class Base>
Vector3<Base> pressing_of(const PressingPart<Base>& part, const Vector3<Base>& axis, const Vector3<Base>& place,
                          const SpatialForce<Base>& wrench, const Base& friction) {
  using Form = typename PressingPart<Base>::Form;
  if (part.form == Form::whole) return part.lever * wrench.force;
  const Base along = dot(wrench.force, axis);
  if (part.form == Form::thread) return (part.lever * along + part.own * friction) * axis;
  if (part.form == Form::along) return (part.lever * along) * axis;
  const Vector3<Base> across = wrench.force - along * axis;
  if (part.form == Form::across) return part.lever * across;
  const Vector3<Base> moment = wrench.moment - cross(place, wrench.force);
  return part.lever * (Base(0.5) * across + part.over_length * cross(moment, axis));
}

// What a wrench exerts along one way of a joint with friction.
template <class Base>
Base effort_along(const solve::MechanismStateOf<Base>& state, const RubbingWay<Base>& way,
                  const SpatialForce<Base>& wrench) {
  const Drive<Base>& drive = state.mechanism().drives[way.drive];
  return dot(drive.turning ? wrench.moment : wrench.force, state.direction(drive.along));
}

// The effort of one way for a friction of one along the slip.
template <class Base>
Base effort_for_friction(const solve::MechanismStateOf<Base>& state, const RoughContactOf<Base>& contact,
                         const RubbingWay<Base>& way) {
  return way.arm * dot(state.direction(*contact.slip), state.direction(way.along));
}

// Of each part of a contact, for a solution of the motion equations.
template <class Base>
std::vector<Vector3<Base>> pressing_in(const solve::MechanismStateOf<Base>& state, const std::vector<Base>& unknowns,
                                       const RoughContactOf<Base>& contact) {
  std::vector<Vector3<Base>> vectors;
  if (contact.pressing.empty()) return vectors;
  const Vector3<Base> axis = state.direction(contact.motions[1].along), place = state.position(contact.at);
  const SpatialForce<Base> rubbing = solve::action_wrench(state, unknowns, static_cast<std::size_t>(contact.action));
  const Base friction = effort_along(state, contact.ways.front(), rubbing);
  for (const PressingPart<Base>& part : contact.pressing)
    vectors.push_back(pressing_of(
        part, axis, place, solve::action_wrench(state, unknowns, static_cast<std::size_t>(part.action)), friction));
  return vectors;
}

// The condition on the effort M of one way of a joint while it moves, as coefficients of the unknowns of the motion
// equations: M + c m (u1 . V1 + u2 . V2 + ...) = 0, with u = V/|V| as found last and the effort c for a friction of one
// along the slip. As |V| varies by u . dV, solving this again and again is Newton's method for M + c m |V| = 0. If the
// friction is known, or nothing presses, M alone.
template <class Base>
std::vector<Base> friction_by_load(const solve::MechanismStateOf<Base>& state, const RoughContactOf<Base>& contact,
                                   const RubbingWay<Base>& way) {
  const Mechanism<Base>& mechanism = state.mechanism();
  const solve::ForceUnknowns order = solve::force_unknowns(mechanism);
  std::vector<Base> coefficients(order.size(), Base(0));
  const auto unknown_of = [&](std::size_t drive) {
    std::size_t unknown = order.accelerations + order.components;
    for (std::size_t k = 0; order.drive_of_effort[k] != drive; ++k) ++unknown;
    return unknown;
  };
  coefficients[unknown_of(way.drive)] = Base(1);
  if (contact.friction_known) return coefficients;
  const Vector3<Base> axis = state.direction(contact.motions[1].along), place = state.position(contact.at);
  const Base resists = contact.sliding * effort_for_friction(state, contact, way);
  for (const PressingPart<Base>& part : contact.pressing) {
    if (!part.toward) continue;
    const auto add = [&](std::size_t unknown, const SpatialForce<Base>& wrench, const Base& friction) {
      coefficients[unknown] += resists * dot(*part.toward, pressing_of(part, axis, place, wrench, friction));
    };
    for (std::size_t k = 0; k < mechanism.components.size(); ++k)
      if (mechanism.components[k].action == part.action)
        add(order.accelerations + k, state.component_wrench(mechanism.components[k]), Base(0));
    add(unknown_of(contact.ways.front().drive), SpatialForce<Base>{Vector3<Base>::zero(), Vector3<Base>::zero()},
        Base(1));
  }
  return coefficients;
}

// The effort of that way where nothing presses, or where the friction is known.
template <class Base>
Base effort_without_load(const solve::MechanismStateOf<Base>& state, const RoughContactOf<Base>& contact,
                         const RubbingWay<Base>& way) {
  const Base friction = contact.friction_known     ? *contact.friction_known
                        : contact.pressing.empty() ? Base(-contact.sliding)
                                                   : Base(0);
  return friction * effort_for_friction(state, contact, way);
}

}  // namespace poinsot::problem
