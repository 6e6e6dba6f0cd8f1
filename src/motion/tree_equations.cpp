#include <algorithm>
#include <memory>
#include <stdexcept>

#include "poinsot/dynamics/forward_dynamics.h"
#include "poinsot/dynamics/momentum.h"
#include "poinsot/motion/motion_equations.h"

namespace poinsot {

MotionEquations tree_equations(const Model<double>& model, LoadFunction loads) {
  for (int k = 0; k < model.velocity_size(); ++k) {
    if (model.mode(k) != CoordinateMode::free)
      throw std::invalid_argument("tree_equations: velocity coordinate " + std::to_string(k) +
                                  " is not free; such motions need the equations of a mechanism");
  }
  struct Memory {
    Workspace<double> workspace;
    State<double> state;
    std::vector<double> force;
    std::vector<SpatialForce<double>> wrench;
  };
  const auto memory =
      std::make_shared<Memory>(Memory{Workspace<double>(model), neutral_state(model),
                                      std::vector<double>(static_cast<std::size_t>(model.velocity_size())),
                                      std::vector<SpatialForce<double>>(static_cast<std::size_t>(model.body_count()))});
  const Model<double>* const tree = &model;

  MotionEquations equations;
  equations.position_size = model.position_size();
  equations.velocity_size = model.velocity_size();
  for (const Body<double>& body : model.bodies()) {
    if (body.joint == JointType::ball || body.joint == JointType::free) equations.quaternions.push_back(body.q);
  }
  equations.position_rate = [tree](double, std::span<const double> q, std::span<const double> v,
                                   std::span<double> rate) { position_rate<double>(*tree, q, v, rate); };
  equations.accelerations = [tree, memory, loads](double t, std::span<const double> q, std::span<const double> v,
                                                  std::span<double> acceleration) {
    std::copy(q.begin(), q.end(), memory->state.q.begin());
    std::copy(v.begin(), v.end(), memory->state.v.begin());
    if (loads) {
      std::fill(memory->force.begin(), memory->force.end(), 0.0);
      std::fill(memory->wrench.begin(), memory->wrench.end(), SpatialForce<double>{});
      loads(t, q, v, memory->force, memory->wrench);
    }
    forward_dynamics<double>(
        *tree, memory->workspace, memory->state, memory->force, acceleration,
        loads ? std::span<const SpatialForce<double>>(memory->wrench) : std::span<const SpatialForce<double>>());
  };
  if (!loads) {
    equations.conserved.push_back(
        {"energy", [tree, memory](double, std::span<const double> q, std::span<const double> v) {
           std::copy(q.begin(), q.end(), memory->state.q.begin());
           std::copy(v.begin(), v.end(), memory->state.v.begin());
           update_velocities(*tree, memory->workspace, memory->state);
           return kinetic_energy(*tree, memory->workspace) + potential_energy(*tree, memory->workspace);
         }});
  }
  return equations;
}

}  // namespace poinsot
