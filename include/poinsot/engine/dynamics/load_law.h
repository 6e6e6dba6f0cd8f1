// A load: a force or couple of given size and direction, whatever the mechanism does.
#pragma once

#include "poinsot/engine/dynamics/force_law.h"
#include "poinsot/engine/dynamics/place.h"

namespace poinsot {

template <class Scalar>
struct KnownForce {
  int action = 0;
  bool couple = false;
  Place<Scalar> at;          // for a force
  Vector3<Scalar> vector{};  // size and direction on the axes of `axes`
  int axes = ground;

  PlacedForce<Scalar> exerted(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    const Vector3<Scalar> on_ground = direction_on_ground(tree, w, axes, vector);
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
    return {action, couple, to(at), to(vector), axes};
  }
};

}  // namespace poinsot
