// What particles tell of the motion that a body goes on with under no moment about its mass center.
#pragma once

#include <optional>

#include "engine/solve/instant/particle_paths.h"
#include "problem/quantities/told_quantity.h"

namespace poinsot::problem {

// What should have been told, and the size of its terms.
struct Witness {
  solve::ParticlePaths::Vector value = solve::ParticlePaths::Vector::zero();
  solve::ParticlePaths::Real size = 0;
};

// sums: of the body about its mass center, which are the told place. Nothing where particles do not tell.
std::optional<Witness> free_motion_of(const ToldQuantity& told, const solve::ParticlePaths::Sums& sums,
                                      const solve::ParticlePaths::Vector& angular_velocity);

}  // namespace poinsot::problem
