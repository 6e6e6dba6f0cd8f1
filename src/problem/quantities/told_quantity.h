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
    velocity,              // of the point of `body` that is at `place`, relative to `from`
    acceleration,          // the same
    angular_velocity,      // relative to `from`
    angular_acceleration,  //
    mass,
    momentum,
    angular_momentum,       // about `place`
    kinetic_energy,         //
    kinetic_energy_within,  // of the motion about the mass center
    height_energy,          // the potential energy in gravity
    moment_of_inertia,      // about the axis through `place` along `first`
    product_of_inertia,     // sum m (r . first) (r . second), r from `place`
    force,                  // on `body`, of the actions
    couple,                 // the same, with the moment of the forces about `place`
    impulse,                // as a force, in a blow
    impulsive_couple,
  };
  Kind kind = Kind::center;
  int body = 0, from = -1;
  std::vector<std::size_t> actions{};
  Vector3<double> place{}, first{}, second{};  // on ground axes, as everything here
  Vector3<double> value{};                     // a number is its x
  std::string words{};                         // the function that told it
};

}  // namespace poinsot::problem
