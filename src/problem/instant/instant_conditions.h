// What a statement says of one instant, as linear conditions for the unknowns of its equations.
//
// Scalar: double; Dual<1> to know how the conditions vary with one number of the statement; poinsot::Formula to have
// them as formulas.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "poinsot/engine/solve/instant/equations.h"
#include "problem/quantities/quantities.h"

namespace poinsot::problem {

// The size of one natural unit of a dimension.
double natural_unit(const solve::Scales& scales, const Dimension& dimension);

// By how much a quantity differs from what a fact says.
template <class Scalar>
struct Difference {
  Scalar value;
  Dimension dimension;
};

// An instant on which facts are laid: the machine in its pose. What the references name must outlive it.
template <class Scalar>
struct InstantView {
  const Situation& situation;
  DataScope<Scalar>& data;
  const MachineOf<Scalar>& machine;
  const solve::MechanismStateOf<Scalar>& moment;
  const solve::Scales& scales;
  Scalar time{};
  const solve::MechanismStateOf<Scalar>* before = nullptr;  // a blow, for facts about the instant after it
};

// What facts say of the unknowns of an instant's equations.
template <class Scalar>
struct FactConditions {
  std::vector<solve::ConditionOf<Scalar>> linear;
  std::vector<const Fact*> nonlinear;  // they fix no unknown, but must hold of the solution
};

// For the velocity coordinates: rates that joints and frames state.
template <class Scalar>
std::vector<solve::ConditionOf<Scalar>> rate_conditions(const InstantView<Scalar>& view);
// For the velocity coordinates: rest, and facts about velocities. blow: where the instants are those after one, for the
// velocities and impulses in the order of solve::impulse_unknowns.
template <class Scalar>
FactConditions<Scalar> velocity_facts(const InstantView<Scalar>& view, const std::vector<const Instant*>& instants,
                                      const solve::BlowOf<Scalar>* blow = nullptr);
// For accelerations and forces, in the order of solve::force_unknowns: what joints state and facts say. The moment has
// its velocities.
template <class Scalar>
FactConditions<Scalar> force_facts(const InstantView<Scalar>& view, const std::vector<const Instant*>& instants);
// What facts about positions, mass centers and mass properties leave open, fact by fact.
template <class Scalar>
std::vector<std::pair<const Fact*, Difference<Scalar>>> position_differences(
    const InstantView<Scalar>& view, const std::vector<const Instant*>& instants);
// The differences quantity - value that a fact demands to vanish.
template <class Scalar, class Base>
std::vector<Difference<Scalar>> differences(const Fact& fact, QuantityScope<Scalar, Base>& scope,
                                            const std::string& file);
// Rest relative to a frame with constant spins: the coordinates of bodies that hang on it do not change, but those of
// bodies of revolution about their own axes; other bodies have the frame's angular velocity and their spin, and their
// mass centers go with it.
template <class Scalar>
void add_steady(const InstantView<Scalar>& view, std::vector<solve::ConditionOf<Scalar>>& conditions,
                bool accelerations);

// The linear equations of an instant.
enum class InstantSystem { velocities, blow, motion };
// What quantities are where the unknowns of a system have these values; blow: for that of a blow. The arguments must
// outlive the scope.
template <class Scalar>
QuantityScope<Scalar> solution_scope(const InstantView<Scalar>& view, InstantSystem system,
                                     const std::vector<Scalar>& unknowns, const solve::BlowOf<Scalar>* blow);

// The particles of strikes that fly by themselves just before a blow (moment: before it), and just after it those that
// have gone through a body. blow: nothing before it.
template <class Scalar>
std::vector<FlyingParticle<Scalar>> flying_particles(const Situation& situation, const MachineOf<Scalar>& machine,
                                                     const solve::MechanismStateOf<Scalar>& before,
                                                     const solve::BlowOf<Scalar>* blow);

// What is given of a blow; the moment is that before it.
template <class Scalar>
solve::BlowOf<Scalar> stated_blow(const InstantView<Scalar>& view);

// Whether a body is one of revolution about the axis of its own joint, its mass center on it. length: of the machine,
// m.
template <class Scalar>
bool turns_unseen(const Model<Scalar>& tree, int body, double length);

}  // namespace poinsot::problem
