#include "poinsot/engine/motion/mechanism/mechanism_equations.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "poinsot/engine/dynamics/action_forces.h"
#include "poinsot/engine/model/state.h"

namespace poinsot {
namespace {

bool keeps_its_energy(const MechanismDynamics& dynamics) {
  const Mechanism<double>& mechanism = dynamics.mechanism();
  return dynamics.held_coordinates().empty() && !laws_feed(mechanism) && !laws_drain(mechanism);
}

}  // namespace

MotionEquations mechanism_equations(MechanismDynamics& dynamics, GivenInTime given) {
  const Model<double>& tree = dynamics.mechanism().tree;
  // A state with what is given in it.
  struct Memory {
    MechanismDynamics& dynamics;
    GivenInTime given;
    State<double> state;

    void take(double t, std::span<const double> q, std::span<const double> v) {
      std::copy(q.begin(), q.end(), state.q.begin());
      std::copy(v.begin(), v.end(), state.v.begin());
      if (given) given(t, dynamics, state.q, state.v);
    }
  };
  const auto memory = std::make_shared<Memory>(Memory{dynamics, std::move(given), neutral_state(tree)});

  MotionEquations equations;
  equations.position_size = tree.position_size();
  equations.velocity_size = tree.velocity_size();
  equations.position_sizes.assign(static_cast<std::size_t>(tree.position_size()), 1.0);
  for (const Body<double>& body : tree.bodies()) {
    const bool attitude = body.joint == JointType::ball || body.joint == JointType::free;
    if (attitude) equations.quaternions.push_back(body.q);
    if (body.joint == JointType::prismatic) equations.position_sizes[body.q] = dynamics.natural_length();
    if (body.joint == JointType::free)
      std::fill_n(equations.position_sizes.begin() + body.q + 4, 3, dynamics.natural_length());
  }
  equations.position_rate = [memory](double t, std::span<const double> q, std::span<const double> v,
                                     std::span<double> rate) {
    memory->take(t, q, v);
    position_rate<double>(memory->dynamics.mechanism().tree, memory->state.q, memory->state.v, rate);
  };
  equations.accelerations = [memory](double t, std::span<const double> q, std::span<const double> v,
                                     std::span<double> acceleration) {
    memory->take(t, q, v);
    memory->dynamics.accelerations(memory->state.q, memory->state.v, acceleration);
  };
  equations.project = [memory](double t, std::span<double> q, std::span<double> v) {
    if (memory->given) memory->given(t, memory->dynamics, q, v);
    memory->dynamics.hold(q, v);
  };
  if (keeps_its_energy(dynamics) && !memory->given) {
    equations.conserved.push_back({"energy", [memory](double, std::span<const double> q, std::span<const double> v) {
                                     return memory->dynamics.kinetic_energy(q, v) +
                                            memory->dynamics.potential_energy(q);
                                   }});
  }
  return equations;
}

}  // namespace poinsot
