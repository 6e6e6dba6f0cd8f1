#include <algorithm>
#include <memory>
#include <stdexcept>

#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/math/algebra/pack.h"
#include "poinsot/engine/motion/integrator/motion_equations.h"

namespace poinsot {

namespace {

using Instants = Pack<8>;

// The tree at eight instants.
struct PackedTree {
  Model<Instants> model;
  Workspace<Instants> workspace{model};
  State<Instants> state = neutral_state(model);
  std::vector<Instants> none = std::vector<Instants>(static_cast<std::size_t>(model.velocity_size()));
  std::vector<Instants> rate =
      std::vector<Instants>(static_cast<std::size_t>(std::max(model.position_size(), model.velocity_size())));

  explicit PackedTree(const Model<double>& tree) : model(convert<Instants>(tree)) {}

  void load(std::span<const double> q, std::span<const double> v) {
    read(q, state.q);
    read(v, state.v);
  }
  static void read(std::span<const double> numbers, std::vector<Instants>& packs) {
    for (std::size_t k = 0; k < packs.size(); ++k)
      packs[k] = Instants(Instants::Lanes(&numbers[Instants::width * k], std::experimental::element_aligned));
  }
  static void write(std::span<const Instants> packs, std::span<double> numbers) {
    for (std::size_t k = 0; k < packs.size(); ++k)
      packs[k].lanes().copy_to(&numbers[Instants::width * k], std::experimental::element_aligned);
  }
};

}  // namespace

MotionEquations tree_equations(const Model<double>& model, const LoadFunction& loads) {
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
  const bool turns_freely = !equations.quaternions.empty();
  if (turns_freely) {
    equations.position_rate = [tree](double, std::span<const double> q, std::span<const double> v,
                                     std::span<double> rate) { position_rate<double>(*tree, q, v, rate); };
  }
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
    const auto packed = std::make_shared<PackedTree>(model);
    if (turns_freely) {
      equations.position_rate_at_eight = [packed](std::span<const double>, std::span<const double> q,
                                                  std::span<const double> v, std::span<double> rate) {
        packed->load(q, v);
        const auto found = std::span(packed->rate).first(packed->state.q.size());
        position_rate<Instants>(packed->model, packed->state.q, packed->state.v, found);
        PackedTree::write(found, rate);
      };
    }
    equations.accelerations_at_eight = [packed](std::span<const double>, std::span<const double> q,
                                                std::span<const double> v, std::span<double> acceleration) {
      packed->load(q, v);
      const auto found = std::span(packed->rate).first(packed->state.v.size());
      forward_dynamics<Instants>(packed->model, packed->workspace, packed->state, packed->none, found);
      PackedTree::write(found, acceleration);
    };
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
