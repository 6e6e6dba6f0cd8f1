#include "problem/instant/sticking_margin.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problem/quantities/rough_contact.h"

namespace poinsot::problem {

std::optional<StickingForces> sticking_forces(const SolvedInstant& instant) {
  const Machine& machine = instant.machine();
  for (const RoughContactOf<double>& contact : machine.rough_contacts)
    if (contact.grip == Grip::sticks && (contact.of_belt || contact.on_cord() || contact.in_joint()))
      return std::nullopt;
  const std::size_t first = solve::force_unknowns(machine.mechanism).accelerations;
  StickingForces forces{instant.one_sided_unknowns(first), instant.friction_cones(first)};
  if (forces.cones.empty()) return std::nullopt;
  return forces;
}

std::optional<double> sticking_margin(const SolvedInstant& instant) {
  if (!instant.forces_solved()) return std::nullopt;
  const std::optional<StickingForces> forces = sticking_forces(instant);
  if (!forces) return std::nullopt;
  const std::vector<double>& value = instant.motion().value;
  double margin = std::numeric_limits<double>::infinity(), size = 0;
  for (const FrictionCone& cone : forces->cones) {
    const double friction = std::hypot(value[cone.first], cone.second ? value[*cone.second] : 0);
    size = std::max({size, std::abs(value[cone.push]), friction});
    margin = std::min(margin, cone.coefficient * value[cone.push] - friction);
  }
  if (!(size > 0)) return std::nullopt;
  return margin / size;
}

std::optional<double> SolvedInstant::least_margin_at_rest() const {
  if (!forces_solved()) return std::nullopt;
  std::optional<double> least;
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    if (contact.grip != Grip::sticks) continue;
    const RoughForce<double> force = rough_force(*mechanism_state_, motion_->value, contact);
    const double carried = resting_of(*mechanism_state_, contact) * force.push, asked = norm(force.friction);
    const double size = std::max(std::abs(carried), asked);
    const double margin = size > 0 ? (carried - asked) / size : 0;
    least = std::min(least.value_or(margin), margin);
  }
  return least;
}

}  // namespace poinsot::problem
