#include "problem/course/energy_balance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "poinsot/engine/dynamics/action_forces.h"
#include "poinsot/engine/dynamics/momentum.h"

namespace poinsot::problem {
namespace {

// Gauss's rule of three points on [0, 1].
constexpr std::array<double, 3> place{0.112701665379258311482073460022, 0.5, 0.887298334620741688517926539978};
constexpr std::array<double, 3> weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
// Of each step: steps resolve the motion, and the power of a load may bend more than that.
constexpr int parts_of_step = 8;

class Account {
 public:
  explicit Account(const Mechanism<double>& mechanism) : mechanism_(mechanism), workspace_(mechanism.tree) {}

  struct Energies {
    double kinetic = 0, potential = 0;
  };
  Energies energies(const State<double>& state) {
    update_velocities(mechanism_.tree, workspace_, state);
    return {kinetic_energy(mechanism_.tree, workspace_),
            potential_energy(mechanism_.tree, workspace_) + stored_energy(mechanism_, workspace_, state)};
  }
  double power(const State<double>& state) {
    update_velocities(mechanism_.tree, workspace_, state);
    return unstored_power(mechanism_, workspace_, state);
  }

 private:
  const Mechanism<double>& mechanism_;
  Workspace<double> workspace_;
};

}  // namespace

std::optional<double> energy_misfit(const Mechanism<double>& mechanism, const Trajectory& way, double size,
                                    const std::function<double(const State<double>&)>& more) {
  if (way.empty()) return std::nullopt;
  Account account(mechanism);
  const Account::Energies first = account.energies(way.state(way.start_time()));
  double work = 0, largest = 0;
  for (std::size_t i = 0; i < way.step_count(); ++i) {
    const StepView step = way.step(i);
    const double length = (step.end - step.start) / parts_of_step;
    for (int part = 0; part < parts_of_step; ++part)
      for (std::size_t k = 0; k < place.size(); ++k) {
        const State<double> there = way.state(step.start + (part + place[k]) * length);
        work += weight[k] * length * (account.power(there) + (more ? more(there) : 0));
      }
    const Account::Energies now = account.energies(way.state(step.end));
    const double gained = now.kinetic - first.kinetic + now.potential - first.potential;
    size = std::max({size, first.kinetic, now.kinetic, std::abs(now.potential - first.potential), std::abs(work)});
    largest = std::max(largest, std::abs(gained - work));
  }
  return size > 0 ? std::optional(largest / size) : std::nullopt;
}

}  // namespace poinsot::problem
