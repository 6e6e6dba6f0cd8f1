// Hybrid dynamics: of each velocity coordinate either the force or the acceleration is known, and the other is found
// (Featherstone, 2008, chapter 9.2; articulated_body.h).
//
// | mode       | given        | found                                |
// |------------|--------------|--------------------------------------|
// | free       | force        | acceleration                         |
// | prescribed | acceleration | force (what a motor must exert)      |
// | locked     | nothing      | force; the acceleration is set to 0  |
#pragma once

#include <span>

#include "poinsot/engine/dynamics/articulated_body.h"

namespace poinsot {

// acceleration, force: one number per velocity coordinate, each entry read or written as the table says. external: one
// wrench per body, on the body's axes about the body's origin (N m, N), or empty for none. Not finite if a free
// coordinate moves massless bodies only. Errors: std::invalid_argument if a size is wrong.
template <class Scalar>
void hybrid_dynamics(const Model<Scalar>& model, Workspace<Scalar>& workspace, const State<Scalar>& state,
                     std::span<Scalar> acceleration, std::span<Scalar> force,
                     std::span<const SpatialForce<Scalar>> external = {}) {
  detail::require_size("hybrid_dynamics", "q", state.q.size(), model.position_size());
  detail::require_size("hybrid_dynamics", "v", state.v.size(), model.velocity_size());
  detail::require_size("hybrid_dynamics", "acceleration", acceleration.size(), model.velocity_size());
  detail::require_size("hybrid_dynamics", "force", force.size(), model.velocity_size());
  if (!external.empty()) {
    detail::require_size("hybrid_dynamics", "external", external.size(), model.body_count());
  }
  for (int k = 0; k < model.velocity_size(); ++k) {
    if (model.mode(k) == CoordinateMode::locked) acceleration[k] = Scalar(0);
  }
  detail::articulated_outwards<true>(model, workspace, state, static_cast<const Scalar*>(acceleration.data()));
  detail::subtract_external(model, workspace, external);
  detail::articulated_inwards<true, true>(model, workspace, static_cast<const Scalar*>(force.data()));
  detail::articulated_back<true>(model, workspace, acceleration.data(), force.data());
}

// After hybrid_dynamics on the same workspace: what a change of the generalised forces changes at the same state. For a
// free coordinate the entry of force is read and that of acceleration written; for a given one the acceleration stays,
// its entry is set to 0, and the entry of force becomes the change of the force found. With impulses in place of forces
// the velocities jump by acceleration. Costs a third of hybrid_dynamics: the inertias are not formed anew.
template <class Scalar>
void hybrid_response(const Model<Scalar>& model, Workspace<Scalar>& workspace, std::span<Scalar> acceleration,
                     std::span<Scalar> force) {
  detail::require_size("hybrid_response", "acceleration", acceleration.size(), model.velocity_size());
  detail::require_size("hybrid_response", "force", force.size(), model.velocity_size());
  for (ArticulatedBody<Scalar>& slot : workspace.articulated) slot.bias = SpatialForce<Scalar>::zero();
  for (int k = 0; k < model.velocity_size(); ++k) {
    if (model.mode(k) != CoordinateMode::free) acceleration[k] = Scalar(0);
  }
  detail::articulated_inwards<true, false>(model, workspace, static_cast<const Scalar*>(force.data()));
  detail::articulated_back<true>(model, workspace, acceleration.data(), force.data());
}

}  // namespace poinsot
