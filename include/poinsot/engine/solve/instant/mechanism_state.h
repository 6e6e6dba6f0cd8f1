// A mechanism in a pose with velocities and accelerations: the places of its points, and the forces of its actions.
#pragma once

#include <vector>

#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/math/algebra/dual.h"

namespace poinsot::solve {

// The scalar is double, Dual<1> or Formula.
template <class Scalar>
class MechanismStateOf {
 public:
  // The mechanism must outlive the state.
  explicit MechanismStateOf(const Mechanism<Scalar>& mechanism);

  // Places the bodies and sets velocities and accelerations to zero.
  void set_positions(const std::vector<Scalar>& q);
  void set_velocities(const std::vector<Scalar>& v);
  void set_accelerations(const std::vector<Scalar>& a);

  const Mechanism<Scalar>& mechanism() const { return mechanism_; }
  const Workspace<Scalar>& workspace() const { return workspace_; }
  const State<Scalar>& state() const { return state_; }
  const std::vector<Scalar>& accelerations() const { return accelerations_; }

  Vector3<Scalar> position(const Place<Scalar>& place) const;
  Vector3<Scalar> velocity(const Place<Scalar>& place) const;
  Vector3<Scalar> direction(const Direction<Scalar>& direction) const;
  Vector3<Scalar> on_ground_axes(int axes, const Vector3<Scalar>& vector) const;

  // The following wrenches are on ground axes about the ground's origin (N, N m).
  SpatialForce<Scalar> component_wrench(const Component<Scalar>& component) const;  // for a component of size one
  SpatialForce<Scalar> drive_wrench(const Drive<Scalar>& drive) const;              // for an effort of one
  // What the laws of force and the known parts of the drives' efforts exert: each, and of one action together.
  struct KnownForceOf {
    int action = 0;
    PlacedForce<Scalar> force{};
  };
  std::vector<KnownForceOf> known_forces() const;
  SpatialForce<Scalar> known_wrench(int action, const Vector3<Scalar>& about = Vector3<Scalar>::zero()) const;

 private:
  const Mechanism<Scalar>& mechanism_;
  Workspace<Scalar> workspace_;
  State<Scalar> state_;
  std::vector<Scalar> accelerations_;
};
using MechanismState = MechanismStateOf<double>;

extern template class MechanismStateOf<double>;
extern template class MechanismStateOf<Dual<1>>;

}  // namespace poinsot::solve
