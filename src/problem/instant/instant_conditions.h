// Turns what is stated of one instant into linear conditions on the unknowns of its equations.
//
// The scalar is double, Dual<1> to see how conditions vary with one number of the file, or poinsot::Formula.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "poinsot/engine/solve/instant/equations.h"
#include "problem/quantities/quantities.h"

namespace poinsot::problem {

// The size of one natural unit of a dimension.
double natural_unit(const solve::Scales& scales, const Dimension& dimension);

// The difference between a quantity and the value that a fact states for it.
template <class Scalar>
struct Difference {
  Scalar value;
  Dimension dimension;
  Scalar found{};  // the quantity
};

// An instant for which facts are evaluated: the machine in its pose. The objects referred to must outlive it.
template <class Scalar>
struct InstantView {
  const Situation& situation;
  DataScope<Scalar>& data;
  const MachineOf<Scalar>& machine;
  const solve::MechanismStateOf<Scalar>& mechanism_state;
  const solve::Scales& scales;
  Scalar time{};
  // The state before a blow, for facts about the instant after it.
  const solve::MechanismStateOf<Scalar>* before = nullptr;
};

// What states a condition: a fact of an instant, or the instant where everything rests; without an instant a joint or
// a frame, or, without a mark, the steady motion.
struct ConditionSource {
  Mark mark;
  const Instant* instant = nullptr;
  const Fact* fact = nullptr;

  bool is_steady_motion() const { return !instant && mark == Mark{}; }
};

// What is stated of the unknowns of an instant's equations.
template <class Scalar>
struct StatedConditions {
  std::vector<solve::ConditionOf<Scalar>> linear;
  std::vector<ConditionSource> sources;  // of each linear condition
  std::vector<const Fact*> nonlinear;    // these determine no unknowns but must hold for the solution

  void add(solve::ConditionOf<Scalar> condition, const ConditionSource& source) {
    linear.push_back(std::move(condition));
    sources.push_back(source);
  }
};

// Conditions on velocity coordinates: the rates that joints and frames state, rest, facts about velocities, and a
// steady motion.
template <class Scalar>
StatedConditions<Scalar> velocity_conditions(const InstantView<Scalar>& view,
                                             const std::vector<const Instant*>& instants);
// Conditions on the velocities just after a blow and on its impulses, in the order of solve::impulse_unknowns: the
// facts about the instant `after`. The view has the state before the blow.
template <class Scalar>
StatedConditions<Scalar> blow_conditions(const InstantView<Scalar>& view, const solve::BlowOf<Scalar>& blow);
// Conditions on accelerations and forces in the order of solve::force_unknowns: what joints and facts state, and, if
// this instant itself belongs to it, the steady motion. The state must have its velocities.
template <class Scalar>
StatedConditions<Scalar> force_conditions(const InstantView<Scalar>& view, const std::vector<const Instant*>& instants,
                                          bool steady);

// Calls visit(fact, coordinate) for each fact that states where a coordinate of the machine is.
template <class Scalar, class Visit>
void for_each_stated_position(const MachineOf<Scalar>& machine, const std::vector<const Instant*>& instants,
                              const Visit& visit) {
  for (const Instant* instant : instants)
    for (const Fact& fact : instant->facts) {
      const Name* name = fact.quantity.as<Name>();
      if (const NamedCoordinate* stated = name && name->primes == 0 ? machine.coordinate(name->name) : nullptr)
        visit(fact, *stated);
    }
}
// The position that a fact states for a coordinate, rad or m.
template <class Scalar>
Scalar stated_position(DataScope<Scalar>& data, const Fact& fact, const NamedCoordinate& coordinate) {
  return data.number(fact.value, coordinate.turning ? dimensions::angle : dimensions::length);
}

// The misfits of facts about positions, mass centers and mass properties, with their facts.
template <class Scalar>
std::vector<std::pair<const Fact*, Difference<Scalar>>> position_differences(
    const InstantView<Scalar>& view, const std::vector<const Instant*>& instants);
// The differences quantity - value that vanish if the fact holds.
template <class Scalar, class Base>
std::vector<Difference<Scalar>> differences(const Fact& fact, QuantityScope<Scalar, Base>& scope,
                                            const std::string& file);
// Steady motion: rest relative to a frame, with constant spins. Coordinates of bodies that the frame carries do not
// change, except for bodies of revolution that turn about their own axes. Other bodies have the angular velocity of
// the frame plus their spin, and their mass centers move with the frame.
template <class Scalar>
void add_steady(const InstantView<Scalar>& view, bool accelerations, StatedConditions<Scalar>& conditions);

// The linear equations of an instant.
enum class InstantSystem { velocities, blow, motion };
// The scope of quantities in which the unknowns of a system have these values; blow: for the system of a blow. The
// arguments must outlive the scope.
template <class Scalar>
QuantityScope<Scalar> solution_scope(const InstantView<Scalar>& view, InstantSystem system,
                                     const std::vector<Scalar>& unknowns, const solve::BlowOf<Scalar>* blow);

// The particles of strikes that fly freely just before a blow. If `blow` is given, the particles just after it, which
// are those that have passed through a body. before: the state before the blow.
template <class Scalar>
std::vector<FlyingParticle<Scalar>> flying_particles(const Situation& situation, const MachineOf<Scalar>& machine,
                                                     const solve::MechanismStateOf<Scalar>& before,
                                                     const solve::BlowOf<Scalar>* blow);

// The given impulses, impacts and strikes. The view must be of the state before the blow.
template <class Scalar>
solve::BlowOf<Scalar> stated_blow(const InstantView<Scalar>& view);

// Whether a body is a body of revolution about the axis of its own joint, with its mass center on this axis. length:
// a natural length of the machine, m.
template <class Scalar>
bool turns_unseen(const Model<Scalar>& tree, int body, double length);

// Tells that the surfaces of a contact are not known well enough to say how its point moves.
Diagnostic unknown_surface(const Situation& situation, const Machine& machine,
                           const VelocityConstraint<double>& constraint);

}  // namespace poinsot::problem
