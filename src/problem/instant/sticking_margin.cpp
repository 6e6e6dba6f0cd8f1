#include "problem/instant/sticking_margin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot::problem {

std::optional<StickingForces> sticking_forces(const SolvedInstant& instant) {
  const Machine& machine = instant.machine();
  const std::size_t first = solve::force_unknowns(machine.mechanism).accelerations;
  const std::vector<Component<double>>& components = machine.mechanism.components;
  StickingForces forces;
  for (std::size_t k = 0; k < components.size(); ++k)
    if (components[k].one_sided) forces.one_sided.push_back(first + k);
  for (const RoughContactOf<double>& contact : machine.rough_contacts) {
    if (contact.grip != Grip::sticks) continue;
    if (contact.of_belt || contact.on_cord() || contact.coordinate >= 0) return std::nullopt;
    std::vector<std::size_t> own;  // the push and what is across it
    for (std::size_t k = 0; k < components.size(); ++k)
      if (components[k].action == contact.action) own.push_back(first + k);
    if (own.size() != 2 && own.size() != 3) return std::nullopt;
    forces.cones.push_back({own[0], own[1], own.size() == 3 ? std::optional(own[2]) : std::nullopt, contact.resting});
  }
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

}  // namespace poinsot::problem
