// The forces that the actions of a Mechanism exert on body `on`, and reversed on body `from`, in a pose with
// velocities.
#pragma once

#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/model/mechanism.h"

namespace poinsot {

// The force (N) or couple (N m) of a component of size one. After update_poses.
template <class Scalar>
PlacedForce<Scalar> component_force(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                    const Component<Scalar>& component) {
  const Vector3<Scalar> P = point_position(tree, w, component.at.body, component.at.point);
  const Vector3<Scalar> none = Vector3<Scalar>::zero();
  if (component.toward)
    return {P, normalized(point_position(tree, w, component.toward->body, component.toward->point) - P), none};
  const Vector3<Scalar> d = direction_on_ground(tree, w, component.along.body, component.along.vector);
  if (component.couple) return {P, none, d};
  return {P, d, component.couple_per_force * d};
}

// The force or couple of a load. After update_poses.
template <class Scalar>
PlacedForce<Scalar> known_force(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                const KnownForce<Scalar>& force) {
  const Vector3<Scalar> vector = direction_on_ground(tree, w, force.axes, force.vector);
  const Vector3<Scalar> none = Vector3<Scalar>::zero();
  const Vector3<Scalar> P = point_position(tree, w, force.at.body, force.at.point);
  return force.couple ? PlacedForce<Scalar>{P, none, vector} : PlacedForce<Scalar>{P, vector, none};
}

// The pull of a spring with its damper on body `on`, along the line to its other end (N). elastic_energy is that of
// the spring.
template <class Scalar>
struct SpringPull {
  PlacedForce<Scalar> force{};
  Scalar length{};          // m
  Scalar lengthening{};     // m/s
  Scalar elastic_energy{};  // J
};

// The pull of a spring at the present velocities. After update_velocities.
template <class Scalar>
SpringPull<Scalar> spring_pull(const Model<Scalar>& tree, const Workspace<Scalar>& w, const SpringLaw<Scalar>& spring) {
  SpringPull<Scalar> pull;
  const Vector3<Scalar> P = point_position(tree, w, spring.at.body, spring.at.point);
  const Vector3<Scalar> span = point_position(tree, w, spring.toward.body, spring.toward.point) - P;
  pull.length = norm(span);
  if constexpr (requires { plain(spring.free_length); }) {
    // Such a spring pulls in proportion to its span, also if the ends meet and the span has no direction.
    if (vanishes(spring.free_length) && vanishes(spring.damping)) {
      pull.elastic_energy = Scalar(0.5) * spring.stiffness * norm_squared(span);
      pull.force = {P, spring.stiffness * span, Vector3<Scalar>::zero()};
      return pull;
    }
  }
  const Vector3<Scalar> u = span / pull.length;
  pull.lengthening = dot(u, point_velocity(tree, w, spring.toward.body, spring.toward.point) -
                                point_velocity(tree, w, spring.at.body, spring.at.point));
  const Scalar stretch = pull.length - spring.free_length;
  pull.elastic_energy = Scalar(0.5) * spring.stiffness * stretch * stretch;
  pull.force = {P, (spring.stiffness * stretch + spring.damping * pull.lengthening) * u, Vector3<Scalar>::zero()};
  return pull;
}

}  // namespace poinsot
