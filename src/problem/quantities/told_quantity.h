// What a scope told of the model, with what it is of: for a second road to it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/vector3.h"

namespace poinsot::problem {

struct ToldQuantity {
  enum class Kind {
    center,
    position,              // of the point of `body` that was drawn at `first`
    direction,             // that rides with `body` and was drawn as `first`
    distance,              // of `place` from the line through `first` along `second`, or from `first` if that is zero
    direction_angle,       // between `first` and `second`
    velocity,              // of the point of `body` that is at `place`, relative to `from`
    acceleration,          // the same
    angular_velocity,      // relative to `from`
    angular_acceleration,  //
    mass,
    weight,
    momentum,
    angular_momentum,       // about `place`
    kinetic_energy,         //
    kinetic_energy_within,  // of the motion about the mass center
    height_energy,          // the potential energy in gravity
    spring_energy,          // of the springs of a name, or of all
    moment_of_inertia,      // about the axis through `place` along `first`
    radius_of_gyration,     // the same
    product_of_inertia,     // sum m (r . first) (r . second), r from `place`
    // Of the motion of a body under no moment about its mass center:
    precession_axis,
    precession_rate,
    precession_sense,  // 1 direct, -1 retrograde
    spin_rate,         // about the axis of revolution in the sense of `first`
    symmetry_axis,
    body_cone,
    space_cone,
    invariable_plane,   // its distance
    poinsot_ellipsoid,  // its semi-axes
    axis_stability,     // of the three principal axes: 1 stable, 0 neutral, -1 unstable
    polhode,            // 1 around the axis of the largest moment, -1 around that of the smallest
    force,              // on `body`, of the actions
    couple,             // the same, with the moment of the forces about `place`
    impulse,            // as a force, in a blow
    impulsive_couple,
    tension,       // the size of a force
    effort,        // the part along `first` of a couple
    normal_force,  // the part along `first` of a force
    friction,      // the part across it
    force_along,   // the part along it, as a vector
  };
  Kind kind = Kind::center;
  int body = 0, from = -1;
  std::vector<std::size_t> actions{};
  Vector3<double> place{}, first{}, second{};  // on ground axes, as everything here
  Vector3<double> value{};                     // a number is its x
  std::string words{};                         // the function that told it
  std::string name{};                          // of springs
  // Whether the rate of this over time was told, not the value, with the rate of the place.
  bool as_rate = false;
  Vector3<double> place_rate{}, value_rate{};
};

}  // namespace poinsot::problem
