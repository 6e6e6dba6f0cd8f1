// What one-sided contacts, cords and friction of a solved instant cannot do.
#include <algorithm>
#include <cmath>
#include <optional>

#include "problem/instant/instant.h"
#include "problem/machine/contact_limits.h"
#include "problem/quantities/cord_grip.h"

namespace poinsot::problem {
namespace {

// The rates of a joint at rest may be rounding, beside which their own size is none.
solve::MechanismState with_joint_at_rest(const solve::MechanismState& state, const RoughContactOf<double>& joint) {
  solve::MechanismState at_rest = state;
  std::vector<double> v = state.state().v;
  for (const RubbingWay<double>& way : joint.ways) v[static_cast<std::size_t>(way.coordinate)] = 0;
  at_rest.set_velocities(v);
  at_rest.set_accelerations(state.accelerations());
  return at_rest;
}

// A normal that points the wrong way asks for a pull where there is a push.
std::string unless_turned(const Situation& situation, const std::string& name) {
  const auto contact = std::ranges::find(situation.contacts, name, &Contact::name);
  if (contact == situation.contacts.end()) return "";
  return ", if its normal points into '" + contact->of + "' as it should";
}

}  // namespace

std::vector<SolvedInstant::OneSidedFault> SolvedInstant::one_sided_faults(double off_line) const {
  std::vector<OneSidedFault> found;
  const Mechanism<double>& mechanism = machine_.mechanism;
  const std::size_t first = solve::force_unknowns(mechanism).accelerations;
  // A force is rounding if it is small beside all other forces on the body that it holds.
  const auto on_body = [&](int body, std::size_t without) {
    if (body == ground) return 0.0;
    double size = mechanism.tree.body(body).inertia.mass * norm(mechanism.tree.gravity());
    for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
      const Action& action = mechanism.actions[i];
      if (i == without || (action.on != body && action.from != body)) continue;
      size = std::max(size, norm(solve::action_wrench(*mechanism_state_, unknowns_, i).force));
    }
    return size;
  };
  // Contacts with friction are in their states with a push that is rounding beside the largest force.
  constexpr double of_largest = 1e-9;
  const double size = machine_.rough_contacts.empty() ? 0 : largest_force(*mechanism_state_, unknowns_);
  const auto is_rough = [&](int action) {
    return std::ranges::any_of(machine_.rough_contacts, [&](const auto& contact) { return contact.action == action; });
  };
  for (std::size_t k = 0; k < mechanism.components.size(); ++k) {
    const Component<double>& component = mechanism.components[k];
    const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
    if (!component.one_sided) continue;
    if (unknowns_[first + k] >= 0) continue;
    if (unknowns_[first + k] >= -of_largest * size && is_rough(component.action)) continue;
    const auto own = static_cast<std::size_t>(component.action);
    const double on = on_body(action.on, own), from = on_body(action.from, own);
    const double beside = on > 0 && from > 0 ? std::min(on, from) : std::max(on, from);
    // A single force on its body is what the motion requires; if nothing moves, it is rounding.
    double mass = scales_.mass;
    for (const int body : {action.on, action.from})
      if (body != ground && mechanism.tree.body(body).inertia.mass > 0)
        mass = std::min(mass, mechanism.tree.body(body).inertia.mass);
    constexpr double of_others = 1e-9, of_natural = 1e-13;
    const double rounding = of_natural * natural_size(dimensions::force) * mass / scales_.mass;
    if (unknowns_[first + k] >= -std::max(of_others * beside, rounding)) continue;
    found.push_back({own, action.kind == ActionKind::cord ? Holding::pulls : Holding::presses});
  }
  for (const int action : machine_.belt_actions) {
    double most = 0, own = tension_of(*mechanism_state_, unknowns_, action);
    for (const int other : machine_.belt_actions)
      most = std::max(most, std::abs(tension_of(*mechanism_state_, unknowns_, other)));
    constexpr double rounding_of_tension = 1e-9;  // of the largest
    if (own < -rounding_of_tension * most) found.push_back({static_cast<std::size_t>(action), Holding::pulls});
  }
  if (machine_.rough_contacts.empty()) return found;
  // A slip that begins is none if it is rounding of what else moves or would move.
  constexpr double begins = 1e-9;
  const double acceleration = natural_size(dimensions::acceleration), speed = natural_size(dimensions::velocity);
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    const bool slips = contact.grip != Grip::slides ||
                       norm(rough_motion(*mechanism_state_, contact, false).slip) > begins * speed ||
                       norm(rough_motion(*mechanism_state_, contact, true).slip) > begins * acceleration;
    // What is at rest but for rounding begins to slip as it is moved, whatever way the rounding points.
    const bool begins_otherwise = !moving_ && contact.grip == Grip::slides && contact.slip &&
                                  !(norm(rough_motion(*mechanism_state_, contact, false).slip) > begins * speed) &&
                                  !(dot(rough_motion(*mechanism_state_, contact, true).slip,
                                        direction_now(*mechanism_state_, contact, *contact.slip)) > 0);
    std::optional<solve::MechanismState> at_rest;
    if (!moving_ && contact.in_joint() && contact.grip == Grip::slides &&
        !(norm(rough_motion(*mechanism_state_, contact, false).slip) > begins * speed))
      at_rest.emplace(with_joint_at_rest(*mechanism_state_, contact));
    if (slips && !begins_otherwise &&
        stays_in_state(at_rest ? *at_rest : *mechanism_state_, unknowns_, contact, size, begins * speed, off_line) &&
        !slips_in_truth(*mechanism_state_, unknowns_, contact, size))
      continue;
    found.push_back({static_cast<std::size_t>(contact.action), contact.grip == Grip::sticks   ? Holding::sticks
                                                               : contact.grip == Grip::slides ? Holding::slides
                                                                                              : Holding::parts});
  }
  return found;
}

std::vector<std::string> SolvedInstant::unphysical(double off_line) const {
  std::vector<std::string> words;
  for (const OneSidedFault& fault : one_sided_faults(off_line)) {
    const std::string& name = machine_.mechanism.actions[fault.action].name;
    switch (fault.broken) {
      case Holding::pulls:
        words.push_back("the " +
                        std::string(std::ranges::find(situation_.belts, name, &Belt::name) == situation_.belts.end()
                                        ? "cord"
                                        : "belt") +
                        " '" + name + "' would have to push: it goes slack");
        break;
      case Holding::presses:
        words.push_back("the contact '" + name + "' would have to pull: it is lost" + unless_turned(situation_, name));
        break;
      case Holding::sticks:
        words.push_back("the contact '" + name + "' would need more friction to stick: it slides");
        break;
      case Holding::slides:
        words.push_back("the contact '" + name + "' would not slide so");
        break;
      case Holding::parts:
        words.push_back("the contact '" + name + "' would not part");
        break;
    }
  }
  return words;
}

}  // namespace poinsot::problem
