// The equations that hold at an instant, and their solution: first the velocities, then accelerations and forces
// together.
//
// Velocities: constraints and stated rates, linear in the velocity coordinates v.
// Accelerations and forces: for every body the external forces are equivalent to m a_G and dH_G/dt (Eqs. 18.1, 18.2,
// d'Alembert's principle), the rates of the constraints vanish, and what is stated about accelerations and forces
// holds. Unknown are the accelerations of all coordinates, the components that supports, contacts and cords carry, and
// the efforts of held drives. All are kept: nothing is eliminated, so that what is open and what contradicts can be
// named.
//
// Scalar: double or Dual<1>. With duals the equations carry how they change with what varies in the mechanism, its pose
// and its velocities; LinearFactors::derivative says how their solution changes.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/model/mechanism.h"
#include "poinsot/engine/solve/instant/mechanism_state.h"
#include "poinsot/engine/solve/linear/linear_system.h"

namespace poinsot::solve {

// Sizes by which equations of different dimensions are compared.
struct Scales {
  double length = 1;  // m
  double mass = 1;    // kg
  double time = 1;    // s
};

// The sizes of a mechanism: extent of its points, largest mass.
template <class Scalar>
Scales natural_scales(const Mechanism<Scalar>& mechanism);

// sum_k coefficients[k] x_k = value, stated by the author of the problem.
template <class Scalar>
struct ConditionOf {
  std::string words;
  std::vector<Scalar> coefficients;
  Scalar value{};
  double scale = 1;  // one natural unit of the quantity
};
using Condition = ConditionOf<double>;

// Unknowns: velocity_size() velocity coordinates.
template <class Scalar>
LinearSystemOf<Scalar> velocity_equations(const MechanismStateOf<Scalar>& moment, const Scales& scales,
                                          const std::vector<ConditionOf<Scalar>>& conditions);

// Unknowns, in this order: velocity_size() accelerations, the mechanism's components, the efforts of all held drives.
struct ForceUnknowns {
  std::size_t accelerations = 0, components = 0, efforts = 0;
  std::vector<std::size_t> drive_of_effort;
  std::size_t size() const { return accelerations + components + efforts; }
};
template <class Scalar>
ForceUnknowns force_unknowns(const Mechanism<Scalar>& mechanism);
template <class Scalar>
LinearSystemOf<Scalar> motion_equations(const MechanismStateOf<Scalar>& moment, const Scales& scales,
                                        const std::vector<ConditionOf<Scalar>>& conditions);

// One constraint on the motion: sum_k coefficients[k] a_k + bias = 0 for the accelerations a of the coordinates, and
// the same without the bias for their velocities.
template <class Scalar>
struct ConstraintRow {
  std::vector<Scalar> coefficients;  // velocity_size() of them
  Scalar bias{};                     // what the velocities bring
};
template <class Scalar>
ConstraintRow<Scalar> constraint_row(const MechanismStateOf<Scalar>& moment,
                                     const VelocityConstraint<Scalar>& constraint);
template <class Scalar>
std::vector<Scalar> constraint_coefficients(const MechanismStateOf<Scalar>& moment,
                                            const VelocityConstraint<Scalar>& constraint);

// Whether a velocity coordinate is an angular velocity.
template <class Scalar>
bool coordinate_turns(const Model<Scalar>& tree, int coordinate);

// Total wrench of one action, about the ground's origin on ground axes, from a solution of the motion equations.
template <class Scalar>
SpatialForce<Scalar> action_wrench(const MechanismStateOf<Scalar>& moment, const std::vector<Scalar>& unknowns,
                                   std::size_t action);

}  // namespace poinsot::solve
