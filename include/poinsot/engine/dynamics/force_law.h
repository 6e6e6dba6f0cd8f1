// What a law of force says: the law that a spring, a damper, a load, a torsional spring or the pull of a center obeys.
//
// A law belongs to an action (mechanism.h) and follows from the state of the mechanism alone. It exerts a force and a
// couple on body `on` of its action and the reverse on body `from`. Part of its power may come out of a store, the
// potential V of the law (a spring's elastic energy):
//
//   power of what it exerts = -dV/dt + unstored power.
//
// All who sum forces or energies visit the laws through Mechanism::for_each_law, so that a new law is a file like
// spring_law.h and a list in the mechanism. Laws are small structs in lists of one kind each: nothing is dispatched
// and nothing allocated where forces are summed.
//
// Two forces of known law stand aside. Weights are in the tree, as an acceleration of the ground, which costs nothing
// (inverse_dynamics.h). Drives act on a coordinate and not on two bodies (drive_law.h).
#pragma once

#include <concepts>

#include "poinsot/engine/dynamics/place.h"
#include "poinsot/engine/dynamics/workspace.h"
#include "poinsot/engine/model/model.h"

namespace poinsot {

template <class Law, class Scalar>
concept ForceLaw = requires(const Law& law, const Model<Scalar>& tree, const Workspace<Scalar>& w, int body) {
  // Its action, by the place among those of the mechanism.
  { law.action } -> std::convertible_to<int>;
  // What it exerts on `on`; after update_velocities.
  { law.exerted(tree, w) } -> std::same_as<PlacedForce<Scalar>>;
  // V, J; after update_poses.
  { law.stored_energy(tree, w) } -> std::same_as<Scalar>;
  // W, between `on` and `from`; after update_velocities.
  { law.unstored_power(tree, w, body, body) } -> std::same_as<Scalar>;
  // Whether it may bring energy into the mechanism that no potential accounts for (a load), whether it takes energy
  // out for good (a damper), and whether it has a potential.
  { law.feeds() } -> std::same_as<bool>;
  { law.drains() } -> std::same_as<bool>;
  { law.stores() } -> std::same_as<bool>;
};

// Converts the parts of a law to another scalar, each number as `convert` gives it.
template <class Target, class Convert>
struct LawConverter {
  const Convert& convert;

  template <class Source>
  Target operator()(const Source& x) const {
    return convert(x);
  }
  template <class Source>
  Vector3<Target> operator()(const Vector3<Source>& a) const {
    return detail::converted<Target>(a, convert);
  }
  template <class Source>
  SymmetricMatrix3<Target> operator()(const SymmetricMatrix3<Source>& a) const {
    return detail::converted<Target>(a, convert);
  }
  template <class Source>
  Place<Target> operator()(const Place<Source>& a) const {
    return {a.body, (*this)(a.point)};
  }
  template <class Source>
  Direction<Target> operator()(const Direction<Source>& a) const {
    return {a.body, (*this)(a.vector)};
  }
};

}  // namespace poinsot
