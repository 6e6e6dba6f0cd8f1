// Energies and momentum of a mechanism, and what the equations of motion fail to say.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/motion/mechanism/mechanism_parts.h"
#include "poinsot/engine/dynamics/action_forces.h"

namespace poinsot {

double MechanismDynamics::kinetic_energy(std::span<const double> q, std::span<const double> v) {
  parts_->load(q, v);
  update_velocities(parts_->mechanism.tree, parts_->workspace, parts_->state);
  return poinsot::kinetic_energy(parts_->mechanism.tree, parts_->workspace);
}

double MechanismDynamics::potential_energy(std::span<const double> q) {
  Parts& p = *parts_;
  p.load_positions(q);
  update_poses<double>(p.mechanism.tree, p.workspace, p.state.q);
  return poinsot::potential_energy(p.mechanism.tree, p.workspace) + stored_energy(p.mechanism, p.workspace, p.state);
}

Momentum<double> MechanismDynamics::momentum(std::span<const double> q, std::span<const double> v,
                                             const Vector3<double>& about) {
  parts_->load(q, v);
  update_velocities(parts_->mechanism.tree, parts_->workspace, parts_->state);
  return poinsot::momentum(parts_->mechanism.tree, parts_->workspace, about);
}

double MechanismDynamics::power() {
  Parts& p = *parts_;
  update_velocities(p.mechanism.tree, p.workspace, p.state);
  double power = unstored_power(p.mechanism, p.workspace, p.state);
  for (const int k : p.held) power += p.held_force[k] * p.state.v[k];
  return power;
}

double MechanismDynamics::constraint_misfit() {
  Parts& p = *parts_;
  if (p.by_tree) return 0;
  update_accelerations<double>(p.mechanism.tree, p.workspace, p.state, p.acceleration);
  p.find_axes();
  double misfit = 0, largest = 0;
  for (const int i : p.acting_rows) {
    p.find_row(i);
    const double unit = p.unit_of(i);
    misfit = std::max(misfit, std::abs(p.row_bias[i]) / unit);
    // With the accelerations in it, the bias is J dv/dt + b.
    for (int k = 0; k < p.n; ++k) largest = std::max(largest, std::abs(p.row[i * p.n + k] * p.acceleration[k]) / unit);
  }
  // Beside the accelerations that turn up: those of the velocities, and those that the forces alone would give.
  for (const BodyMotion<double>& motion : p.workspace.motion) largest = std::max(largest, norm_squared(motion.w));
  for (std::size_t f = 0; f < p.free.size(); ++f) {
    const int k = p.free[f];
    largest = std::max(largest,
                       p.scale[f] * p.scale[f] * std::abs(p.known[k] - p.bias_force[k]) / (p.turns[k] ? 1 : p.length));
  }
  const double relative = largest > 0 ? misfit / largest : 0;
  return std::max(relative, p.force_misfit);
}

std::vector<OpenCoordinate> MechanismDynamics::open_coordinates(std::span<const double> q) {
  Parts& p = *parts_;
  p.load_positions(q);
  std::fill(p.state.v.begin(), p.state.v.end(), 0.0);
  std::vector<double> none(static_cast<std::size_t>(p.n), 0.0);
  p.find_under_constraints(none);
  // Without unknown forces the equations for what the constraints leave free stand alone.
  if (!p.forces_unknown) {
    const std::vector<int> columns = std::exchange(p.acting_columns, {});
    p.find_with_unknown_forces();
    p.acting_columns = columns;
    p.acting_columns.reserve(p.links.size());
  }
  const std::size_t rank = static_cast<std::size_t>(p.qr.rank()), left = p.free.size() - rank;
  constexpr double takes_part = 1e-9;  // of a direction of length one: what is less takes no part in it
  std::vector<OpenCoordinate> found;
  std::vector<double> direction(p.free.size()), solved(p.free.size() + p.links.size());
  for (int k = p.force_qr.rank(); k < p.force_qr.columns(); ++k) {
    std::fill(direction.begin(), direction.end(), 0.0);
    for (int i = 0; i < p.force_qr.rank(); ++i) solved[i] = p.force_qr.R(i, k);
    p.force_qr.solve_upper(solved.data());
    bool force_enters = false;
    const auto set = [&](int at, double value) {
      const auto place = static_cast<std::size_t>(p.force_qr.chosen(at));
      if (place < left)
        direction[rank + place] = value;
      else
        force_enters = force_enters || std::abs(value) > takes_part;
    };
    for (int i = 0; i < p.force_qr.rank(); ++i) set(i, -solved[i]);
    set(k, 1);
    p.qr.apply(direction.data());
    for (std::size_t f = 0; f < p.free.size(); ++f) {
      if (!(std::abs(direction[f]) > takes_part)) continue;
      const int coordinate = p.free[f];
      const auto same = [&](const OpenCoordinate& open) { return open.coordinate == coordinate; };
      if (std::none_of(found.begin(), found.end(), same)) found.push_back({coordinate, !force_enters});
    }
  }
  std::sort(found.begin(), found.end(),
            [](const OpenCoordinate& a, const OpenCoordinate& b) { return a.coordinate < b.coordinate; });
  return found;
}

}  // namespace poinsot
