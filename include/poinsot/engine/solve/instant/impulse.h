// The principle of impulse and momentum: velocities just after a blow, and the impulses of all that holds the bodies.
//
// A blow takes no time: positions stay, finite forces have no effect, and for every body the momenta before plus all
// impulses on it are equivalent to its momenta after (Eq. 17.4). Joints, contacts and taut cords constrain the
// velocities after the blow as before it. An impact reverses the relative velocity at its point, reduced by the
// coefficient of restitution. Unknown are the velocities after and the components of all impulses.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/solve/instant/equations.h"
#include "poinsot/engine/solve/instant/rough_impact.h"

namespace poinsot::solve {

// A given impulse on a body, on ground axes about the ground's origin (N s, N m s).
template <class Scalar>
struct KnownImpulseOf {
  int action = 0;
  int on = ground;
  SpatialForce<Scalar> wrench{};
  // The mass of a particle that stays in the body at the place (kg). It takes up its mass times the velocity of this
  // place after the blow.
  Scalar absorbed{};
  Place<Scalar> at;
};
using KnownImpulse = KnownImpulseOf<double>;

// Body `on` strikes body `from` at a place. `push` is the direction of the impulse on `on`; it moves with `from`.
template <class Scalar>
struct ImpactOf {
  std::string name;
  int action = 0;
  int on = ground, from = ground;
  Place<Scalar> at;
  Direction<Scalar> push;
  Scalar restitution{};
  std::optional<Scalar> friction{};  // the coefficient of a rough contact
  RestitutionLaw hypothesis = RestitutionLaw::energetic;
  bool is_friction = false;  // an impact of its own, after that with the push
  // What holds instead of Newton's restitution, at most one of these.
  std::optional<Scalar> leaves{};    // the relative velocity along the push after the blow
  std::optional<Scalar> given{};     // the impulse
  std::optional<Scalar> per_push{};  // the impulse for each unit of the impact before this one
};
using Impact = ImpactOf<double>;

template <class Scalar>
struct BlowOf {
  std::vector<KnownImpulseOf<Scalar>> impulses;
  std::vector<ImpactOf<Scalar>> impacts;
  std::vector<int> held_coordinates;  // velocity coordinates of frames, which move on as stated
};
using Blow = BlowOf<double>;

// The order of the unknowns: velocities after, then the impulses of the mechanism's components, of held drives and of
// the impacts.
struct ImpulseUnknowns {
  std::size_t velocities = 0, components = 0, efforts = 0, impacts = 0;
  std::vector<std::size_t> drive_of_effort;
  std::size_t size() const { return velocities + components + efforts + impacts; }
};
template <class Scalar>
ImpulseUnknowns impulse_unknowns(const Mechanism<Scalar>& mechanism, const BlowOf<Scalar>& blow);

// before: the state just before, with its velocities. acting: for each action of the mechanism, whether it acts (a
// slack cord does not). conditions: on all unknowns. The scalar is double, Dual<1> or Formula.
template <class Scalar>
LinearSystemOf<Scalar> impulse_equations(const MechanismStateOf<Scalar>& before, const Scales& scales,
                                         const BlowOf<Scalar>& blow, const std::vector<ConditionOf<Scalar>>& conditions,
                                         const std::vector<bool>& acting);
LinearSolution solve_impulse(const MechanismState& before, const Scales& scales, const Blow& blow,
                             const std::vector<Condition>& conditions, const std::vector<bool>& acting,
                             LinearSystem* equations = nullptr);

template <class Scalar>
SpatialForce<Scalar> impact_wrench(const MechanismStateOf<Scalar>& state,
                                   const ImpactOf<Scalar>& impact);  // of size one

// The velocity of the point of `on` relative to that of `from`, m/s.
template <class Scalar>
Vector3<Scalar> impact_velocity(const MechanismStateOf<Scalar>& state, const ImpactOf<Scalar>& impact);
// The velocity of `on` relative to `from` along the push, m/s; negative while they approach each other.
template <class Scalar>
Scalar approach(const MechanismStateOf<Scalar>& state, const ImpactOf<Scalar>& impact);

// The total impulse of one action on body `on`, on ground axes about the ground's origin (N s, N m s).
template <class Scalar>
SpatialForce<Scalar> action_impulse(const MechanismStateOf<Scalar>& state, const BlowOf<Scalar>& blow,
                                    const std::vector<Scalar>& unknowns, std::size_t action);

}  // namespace poinsot::solve
