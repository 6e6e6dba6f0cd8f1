// Adds the masses of particles that are fixed to bodies.
#pragma once

#include <utility>
#include <vector>

#include "poinsot/engine/model/model.h"

namespace poinsot {

template <class Scalar>
struct FixedParticle {
  int body = 0;
  Scalar mass{};            // kg
  Vector3<Scalar> point{};  // in the body frame, m
};

// The same bodies, joints and coordinates, where bodies include the masses of their particles.
template <class Scalar>
Model<Scalar> with_particles(const Model<Scalar>& model, const std::vector<FixedParticle<Scalar>>& particles) {
  std::vector<Body<Scalar>> bodies(model.bodies().begin(), model.bodies().end());
  for (const FixedParticle<Scalar>& particle : particles) {
    Body<Scalar>& body = bodies[static_cast<std::size_t>(particle.body)];
    const Vector3<Scalar> p = body.R_WB * particle.point;
    const Scalar& m = particle.mass;
    body.axisymmetric = false;
    body.inertia += {m, m * p, m * unit_mass_inertia(p)};
    body.second_moment +=
        m * SymmetricMatrix3<Scalar>{p.x * p.x, p.y * p.y, p.z * p.z, p.x * p.y, p.y * p.z, p.z * p.x};
  }
  return {std::move(bodies), model.names(), model.modes(), model.gravity()};
}

}  // namespace poinsot
