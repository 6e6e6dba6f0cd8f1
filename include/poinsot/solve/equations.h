// The equations that hold at an instant, and their solution: first the velocities, then accelerations and forces
// together.
//
// Velocities: constraints and stated rates, linear in the velocity coordinates v.
// Accelerations and forces: for every body the external forces are equivalent to m a_G and dH_G/dt (Eqs. 18.1, 18.2,
// d'Alembert's principle), the rates of the constraints vanish, and what is stated about accelerations and forces
// holds. Unknown are the accelerations of all coordinates, the components that supports, contacts and cords carry, and
// the efforts of held drives. All are kept: nothing is eliminated, so that what is open and what contradicts can be
// named.
#pragma once

#include <string>
#include <vector>

#include "poinsot/dynamics/momentum.h"
#include "poinsot/model/mechanism.h"
#include "poinsot/solve/linear_system.h"

namespace poinsot::solve {

// Sizes by which equations of different dimensions are compared.
struct Scales {
  double length = 1;  // m
  double mass = 1;    // kg
  double time = 1;    // s
};

// The sizes of a mechanism: extent of its points, largest mass.
Scales natural_scales(const Mechanism<double>& mechanism);

// sum_k coefficients[k] x_k = value, stated by the author of the problem.
struct Condition {
  std::string words;
  std::vector<double> coefficients;
  double value = 0;
  double scale = 1;  // one natural unit of the quantity
};

// A mechanism in a pose with velocities: what follows from them.
class Moment {
 public:
  // mechanism must outlive the moment.
  explicit Moment(const Mechanism<double>& mechanism);

  // Places the bodies; velocities and accelerations become zero.
  void set_positions(const std::vector<double>& q);
  void set_velocities(const std::vector<double>& v);
  void set_accelerations(const std::vector<double>& a);

  const Mechanism<double>& mechanism() const { return mechanism_; }
  const Workspace<double>& workspace() const { return workspace_; }
  const State<double>& state() const { return state_; }
  const std::vector<double>& accelerations() const { return accelerations_; }

  Vector3<double> position(const Place<double>& place) const;
  Vector3<double> velocity(const Place<double>& place) const;
  Vector3<double> direction(const Direction<double>& direction) const;
  Vector3<double> on_ground_axes(int axes, const Vector3<double>& vector) const;

  // About the ground's origin, on ground axes.
  SpatialForce<double> component_wrench(const Component<double>& component) const;  // of size one
  SpatialForce<double> drive_wrench(const Drive<double>& drive) const;              // of effort one
  SpatialForce<double> known_wrench(const KnownForce<double>& force) const;
  SpatialForce<double> spring_wrench(const SpringLaw<double>& spring) const;
  // The part of a drive's effort that is known: what is stated, its spring and its damping.
  double known_effort(const Drive<double>& drive) const;

 private:
  const Mechanism<double>& mechanism_;
  Workspace<double> workspace_;
  State<double> state_;
  std::vector<double> accelerations_;
};

// Unknowns: velocity_size() velocity coordinates.
LinearSolution solve_velocities(const Moment& moment, const Scales& scales, const std::vector<Condition>& conditions,
                                LinearSystem* equations = nullptr);

// Unknowns, in this order: velocity_size() accelerations, the mechanism's components, the efforts of all held drives.
struct ForceUnknowns {
  std::size_t accelerations = 0, components = 0, efforts = 0;
  std::vector<std::size_t> drive_of_effort;
  std::size_t size() const { return accelerations + components + efforts; }
};
ForceUnknowns force_unknowns(const Mechanism<double>& mechanism);
LinearSolution solve_motion(const Moment& moment, const Scales& scales, const std::vector<Condition>& conditions,
                            LinearSystem* equations = nullptr);

// Coefficients of the velocity coordinates in one constraint.
std::vector<double> constraint_coefficients(const Moment& moment, const VelocityConstraint<double>& constraint);

// Whether a velocity coordinate is an angular velocity.
bool coordinate_turns(const Model<double>& tree, int coordinate);

// Total wrench of one action, about the ground's origin on ground axes, from a solution of solve_motion.
SpatialForce<double> action_wrench(const Moment& moment, const std::vector<double>& unknowns, std::size_t action);

}  // namespace poinsot::solve
