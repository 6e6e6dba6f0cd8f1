// A load: a force or couple of given size and direction, whatever the mechanism does, or one that follows from its
// motion.
#pragma once

#include <memory>

#include "poinsot/engine/dynamics/force_law.h"
#include "poinsot/engine/dynamics/motion_expression.h"
#include "poinsot/engine/dynamics/place.h"

namespace poinsot {

template <class Scalar>
struct KnownForce {
  int action = 0;
  bool couple = false;
  Place<Scalar> at;          // for a force
  Vector3<Scalar> vector{};  // size and direction on the axes of `axes`
  int axes = ground;
  // Where it follows from the motion: it then stands in the place of `vector`.
  std::shared_ptr<const MotionExpression<Scalar>> by_motion{};

  // Its size and direction now, on the axes of `axes`. After update_velocities.
  Vector3<Scalar> now(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    return by_motion ? by_motion->value(tree, w) : vector;
  }
  PlacedForce<Scalar> exerted(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    const Vector3<Scalar> on_ground = direction_on_ground(tree, w, axes, now(tree, w));
    const Vector3<Scalar> none = Vector3<Scalar>::zero();
    const Vector3<Scalar> P = point_position(tree, w, at.body, at.point);
    return couple ? PlacedForce<Scalar>{P, none, on_ground} : PlacedForce<Scalar>{P, on_ground, none};
  }
  // It keeps no account of its energy: where it comes from is outside the mechanism.
  Scalar stored_energy(const Model<Scalar>&, const Workspace<Scalar>&) const { return Scalar(0); }
  Scalar unstored_power(const Model<Scalar>& tree, const Workspace<Scalar>& w, int on, int from) const {
    return power_between(w, on, from, exerted(tree, w));
  }
  bool feeds() const { return true; }
  bool drains() const { return false; }
  bool stores() const { return false; }

  template <class Target, class Convert>
  KnownForce<Target> converted(const Convert& to) const {
    KnownForce<Target> force{action, couple, to(at), to(vector), axes};
    if (by_motion)
      force.by_motion = std::make_shared<const MotionExpression<Target>>(by_motion->template converted<Target>(to));
    return force;
  }
};

}  // namespace poinsot
