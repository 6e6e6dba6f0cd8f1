// Impulse and momentum: the velocities just after a blow, and the impulses of everything that holds the bodies.
//
// A blow lasts no time: positions stay, forces of finite size do nothing, and for every body the momenta before plus
// all impulses on it are equivalent to its momenta after (Eq. 17.4). Joints, contacts and taut cords forbid after the
// blow what they forbade before; an impact reverses the relative velocity at its point, reduced by the coefficient of
// restitution. Unknown are the velocities after and the components of all impulses.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/solve/instant/equations.h"

namespace poinsot::solve {

// A given impulse on a body, about the ground's origin on ground axes.
template <class Scalar>
struct KnownImpulseOf {
  int action = 0;
  int on = ground;
  SpatialForce<Scalar> wrench{};
  // A particle that stays in the body at the place: it takes up its mass times the velocity of the place after.
  Scalar absorbed{};
  Place<Scalar> at;
};
using KnownImpulse = KnownImpulseOf<double>;

// Body `on` strikes body `from` at a place; `push` is the direction of the impulse on `on` and rides with `from`.
template <class Scalar>
struct ImpactOf {
  std::string name;
  int action = 0;
  int on = ground, from = ground;
  Place<Scalar> at;
  Direction<Scalar> push;
  Scalar restitution{};
};
using Impact = ImpactOf<double>;

template <class Scalar>
struct BlowOf {
  std::vector<KnownImpulseOf<Scalar>> impulses;
  std::vector<ImpactOf<Scalar>> impacts;
  std::vector<int> held_coordinates;  // of frames: they move on as stated
};
using Blow = BlowOf<double>;

// Order of the unknowns: velocities after, impulses of the mechanism's components, of held drives, of the impacts.
struct ImpulseUnknowns {
  std::size_t velocities = 0, components = 0, efforts = 0, impacts = 0;
  std::vector<std::size_t> drive_of_effort;
  std::size_t size() const { return velocities + components + efforts + impacts; }
};
template <class Scalar>
ImpulseUnknowns impulse_unknowns(const Mechanism<Scalar>& mechanism, const BlowOf<Scalar>& blow);

// before: poses and velocities just before. acting: for each action of the mechanism, whether it takes part (a slack
// cord does not). conditions: over all unknowns. Scalar: double or Dual<1>.
template <class Scalar>
LinearSystemOf<Scalar> impulse_equations(const MechanismStateOf<Scalar>& before, const Scales& scales,
                                         const BlowOf<Scalar>& blow, const std::vector<ConditionOf<Scalar>>& conditions,
                                         const std::vector<bool>& acting);
LinearSolution solve_impulse(const MechanismState& before, const Scales& scales, const Blow& blow,
                             const std::vector<Condition>& conditions, const std::vector<bool>& acting,
                             LinearSystem* equations = nullptr);

template <class Scalar>
SpatialForce<Scalar> impact_wrench(const MechanismStateOf<Scalar>& moment,
                                   const ImpactOf<Scalar>& impact);  // of size one

// Velocity of `on` relative to `from` along the push; negative while they approach each other.
template <class Scalar>
Scalar approach(const MechanismStateOf<Scalar>& moment, const ImpactOf<Scalar>& impact);

// Total impulse of one action, about the ground's origin on ground axes.
template <class Scalar>
SpatialForce<Scalar> action_impulse(const MechanismStateOf<Scalar>& moment, const BlowOf<Scalar>& blow,
                                    const std::vector<Scalar>& unknowns, std::size_t action);

}  // namespace poinsot::solve
