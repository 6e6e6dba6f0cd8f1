// Forward dynamics: the accelerations of the coordinates under stated joint forces, by the articulated-body algorithm
// (articulated_body.h). Every coordinate is taken as free, whatever its mode; hybrid_dynamics.h minds the modes.
#pragma once

#include <span>

#include "poinsot/engine/dynamics/articulated_body.h"

namespace poinsot {

// force, acceleration: one number per velocity coordinate. external: one wrench per body, on the body's axes about the
// body's origin (N m, N), or empty for none. Not finite if a coordinate moves massless bodies only, or turns a slender
// rod about its own line (for numbers and packs of them).
// Errors: std::invalid_argument if a size is wrong.
template <class Scalar>
void forward_dynamics(const Model<Scalar>& model, Workspace<Scalar>& workspace, const State<Scalar>& state,
                      std::span<const Scalar> force, std::span<Scalar> acceleration,
                      std::span<const SpatialForce<Scalar>> external = {}) {
  detail::require_size("forward_dynamics", "q", state.q.size(), model.position_size());
  detail::require_size("forward_dynamics", "v", state.v.size(), model.velocity_size());
  detail::require_size("forward_dynamics", "force", force.size(), model.velocity_size());
  detail::require_size("forward_dynamics", "acceleration", acceleration.size(), model.velocity_size());
  if (!external.empty()) {
    detail::require_size("forward_dynamics", "external", external.size(), model.body_count());
  }
  detail::articulated_outwards<false>(model, workspace, state, static_cast<const Scalar*>(nullptr));
  detail::subtract_external(model, workspace, external);
  detail::articulated_inwards<false, true>(model, workspace, force.data());
  detail::articulated_back<false>(model, workspace, acceleration.data(), static_cast<Scalar*>(nullptr));
}

}  // namespace poinsot
