#include "problem/machine/gimbal_lock.h"

#include <algorithm>
#include <array>

#include "poinsot/engine/solve/instant/mechanism_state.h"

namespace poinsot::problem {

std::optional<std::string> gimbal_lock(const Machine& machine, const std::vector<double>& q, double sine) {
  const Mechanism<double>& mechanism = machine.mechanism;
  const auto has_others = [](const Drive<double>& drive) { return drive.turning && drive.others.size() == 2; };
  if (std::ranges::none_of(mechanism.drives, has_others)) return std::nullopt;
  solve::MechanismState state(mechanism);
  state.set_positions(q);
  const auto parallel = [&](const Direction<double>& a, const Direction<double>& b) {
    return norm(cross(state.direction(a), state.direction(b))) <= sine;
  };
  const auto name_of = [&](const Drive<double>& drive) {
    const auto named = std::ranges::find(machine.coordinates, drive.position, &NamedCoordinate::position);
    return named != machine.coordinates.end() && !named->name.empty() ? "'" + named->name + "'" : std::string();
  };
  for (const Drive<double>& drive : mechanism.drives) {
    if (!has_others(drive)) continue;
    const std::string& joint = mechanism.actions[static_cast<std::size_t>(drive.action)].joint;
    for (const Drive<double>& other : mechanism.drives) {
      if (&other <= &drive || !has_others(other)) continue;
      if (mechanism.actions[static_cast<std::size_t>(other.action)].joint != joint) continue;
      if (!parallel(drive.along, other.along)) continue;
      const std::string one = name_of(drive), another = name_of(other);
      const bool named = !one.empty() && !another.empty();
      return (named ? "the angles " + one + " and " + another : std::string("two of the angles")) + " of joint '" +
             joint + "' turn about the same line (gimbal lock)";
    }
  }
  return std::nullopt;
}

}  // namespace poinsot::problem
