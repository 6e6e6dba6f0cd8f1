// Each spring as it is stated: from what the file says of its ends, and not from the laws of force,
//
//   V = k (x - x_0)^2 / 2,      dV/dt = k (x - x_0) dx/dt,
//
// x the distance of its ends, the angle between its bodies, or the coordinate of its joint.
#include "problem/witness/spring_witness.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "problem/witness/stated_springs.h"

namespace poinsot::problem {

std::optional<Witness> spring_energy(const ToldQuantity& told, const solve::ParticlePaths& paths,
                                     const Machine& machine, DataScope<double>& data, const std::vector<double>& v) {
  using Real = solve::ParticlePaths::Real;
  const StatedSprings springs(paths, machine, data, v);
  const Situation& situation = data.situation();
  Witness energy, rate;
  const auto add = [&](Real stiffness, const std::optional<DrawnSpring>& drawn) {
    if (!drawn) return false;
    energy.value.x += stiffness * drawn->out * drawn->out / 2;
    energy.size += stiffness * drawn->size * drawn->size / 2;
    rate.value.x += stiffness * drawn->out * drawn->rate;
    rate.size += stiffness * drawn->size * std::max(std::abs(drawn->rate), paths.pace() * drawn->size);
    return true;
  };
  for_each_stated_law(situation, []<class Law>(const Law&) {
    static_assert(
        std::is_same_v<Law, Spring> || std::is_same_v<Law, Load>,
        "add below what the law stores, if it does, as it is stated; answer_checks.cpp says where it is zero");
  });
  for (const Spring& spring : situation.springs)
    if (spring.stiffness && (told.name.empty() || told.name == spring.name) &&
        !add(springs.stiffness(spring), springs.drawn(spring)))
      return std::nullopt;
  for (const Joint& joint : situation.joints)
    for (const Freedom& freedom : joint.freedoms)
      if (freedom.stiffness && (told.name.empty() || told.name == joint.name) &&
          !add(springs.stiffness(freedom), springs.drawn(joint, freedom)))
        return std::nullopt;
  return told.as_rate ? rate : energy;
}

}  // namespace poinsot::problem
