// The equations that hold at an instant: first those for the velocities, then those for accelerations and forces
// together.
//
// Velocities: constraints and stated rates, which are linear in the velocity coordinates v.
// Accelerations and forces: for every body the external forces are equivalent to m a_G and dH_G/dt (Eqs. 18.1, 18.2,
// d'Alembert's principle), the rates of the constraints vanish, and what is stated about accelerations and forces
// holds. Unknown are the accelerations of all coordinates, the components that supports, contacts and cords carry,
// and the efforts of held drives. None is eliminated, so that open unknowns and contradictions can be named.
//
// The scalar is double, Dual<1> or Formula. With dual numbers the equations carry their derivatives by what varies in
// the mechanism, its pose and its velocities; LinearFactors::derivative gives those of the solution.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/solve/instant/mechanism_state.h"
#include "poinsot/engine/solve/linear/linear_system.h"

namespace poinsot::solve {

// The units in which equations of different dimensions are compared.
struct Scales {
  double length = 1;       // m
  double mass = 1;         // kg
  double time = 1;         // s
  bool has_length = true;  // whether the figure has one: that of particles in one place is taken as 1 m
};

// The natural units of a mechanism: the extent of its points, its largest mass, and the time that belongs to its
// weight.
template <class Scalar>
Scales natural_scales(const Mechanism<Scalar>& mechanism);

// A stated condition: sum_k coefficients[k] x_k = value.
template <class Scalar>
struct ConditionOf {
  std::string words;
  std::vector<Scalar> coefficients;
  Scalar value{};
  double scale = 1;  // one natural unit of the quantity
};
using Condition = ConditionOf<double>;

// The equations for the velocity_size() velocity coordinates. The state must have its positions.
template <class Scalar>
LinearSystemOf<Scalar> velocity_equations(const MechanismStateOf<Scalar>& state, const Scales& scales,
                                          const std::vector<ConditionOf<Scalar>>& conditions);

// The order of the unknowns: velocity_size() accelerations (rad/s^2, m/s^2), the mechanism's components (N, N m), the
// efforts of all held drives.
struct ForceUnknowns {
  std::size_t accelerations = 0, components = 0, efforts = 0;
  std::vector<std::size_t> drive_of_effort;
  std::size_t size() const { return accelerations + components + efforts; }
};
template <class Scalar>
ForceUnknowns force_unknowns(const Mechanism<Scalar>& mechanism);
template <class Scalar>
LinearSystemOf<Scalar> motion_equations(const MechanismStateOf<Scalar>& state, const Scales& scales,
                                        const std::vector<ConditionOf<Scalar>>& conditions);

// A constraint on the motion: sum_k coefficients[k] a_k + bias = 0 for the accelerations a of the coordinates, and
// the same without bias for their velocities.
template <class Scalar>
struct ConstraintRow {
  std::vector<Scalar> coefficients;  // velocity_size() of them
  Scalar bias{};                     // the part that depends on the velocities
};
template <class Scalar>
ConstraintRow<Scalar> constraint_row(const MechanismStateOf<Scalar>& state,
                                     const VelocityConstraint<Scalar>& constraint);
template <class Scalar>
std::vector<Scalar> constraint_coefficients(const MechanismStateOf<Scalar>& state,
                                            const VelocityConstraint<Scalar>& constraint);

// Whether a velocity coordinate is an angular velocity.
template <class Scalar>
bool coordinate_turns(const Model<Scalar>& tree, int coordinate);

// The total wrench of one action on body `on`, on ground axes about a point, the ground's origin if none is named (N,
// N m). unknowns: a solution of the motion equations.
template <class Scalar>
SpatialForce<Scalar> action_wrench(const MechanismStateOf<Scalar>& state, const std::vector<Scalar>& unknowns,
                                   std::size_t action, const Vector3<Scalar>& about = Vector3<Scalar>::zero());

}  // namespace poinsot::solve
