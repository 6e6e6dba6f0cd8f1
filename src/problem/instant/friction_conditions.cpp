#include "problem/instant/friction_conditions.h"

#include <algorithm>
#include <initializer_list>

#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

std::vector<StateCondition> state_conditions(const solve::MechanismStateOf<Formula>& state,
                                             const std::vector<Formula>& unknowns,
                                             const std::vector<RoughContactOf<Formula>>& contacts) {
  std::vector<StateCondition> conditions;
  for (const RoughContactOf<Formula>& contact : contacts) {
    const auto add = [&](Holding holding, const Formula& positive) {
      if (seen_sign(positive).sign <= 0) conditions.push_back({contact.name, holding, positive});
    };
    const bool on_cord = contact.on_cord();
    if (const Formula less =
            on_cord ? contact.friction_at_rest - contact.friction_in_slip : contact.resting - contact.sliding;
        !less.is_zero())
      add(Holding::slides, less);
    const RoughMotion<Formula> now = rough_motion(state, contact, false), then = rough_motion(state, contact, true);
    if (contact.grip == Grip::parts) {
      add(Holding::parts, then.apart);
      continue;
    }
    if (on_cord) {
      const Formula before = tension_of(state, unknowns, contact.action),
                    behind = tension_of(state, unknowns, contact.behind);
      if (contact.grip == Grip::sticks) {
        const Formula ratio = capstan_of(state, contact).value();
        add(Holding::sticks, ratio * behind - before);
        add(Holding::sticks, ratio * before - behind);
        continue;
      }
      add(Holding::pulls, before);
    }
    const RoughForce<Formula> force = rough_force(state, unknowns, contact);
    if (contact.pressing.empty() && !on_cord) {
      add(Holding::presses, force.push);
    } else if (contact.grip == Grip::slides) {
      const std::vector<Vector3<Formula>> pressing = pressing_in(state, unknowns, contact);
      for (std::size_t i = 0; i < pressing.size(); ++i)
        if (contact.pressing[i].toward) add(Holding::presses, dot(pressing[i], *contact.pressing[i].toward));
    }
    if (contact.grip == Grip::sticks) {
      std::vector<Formula> parts;
      const auto add_part = [&](const Direction<Formula>& along) {
        if (const Formula part = dot(force.friction, state.direction(along)); !part.is_zero()) parts.push_back(part);
      };
      if (contact.in_joint())
        for (const RubbingWay<Formula>& way : contact.ways) add_part(way.along);
      else
        for (std::size_t k = 1; k < 3; ++k) add_part(contact.motions[k].along);
      const Formula limit = contact.resting * force.push;
      if (parts.size() == 1) {
        for (const int sign : {1, -1})
          if (seen_sign(Formula(sign) * parts.front()).sign <= 0)
            add(Holding::sticks, limit + Formula(sign) * parts.front());
      } else if (!parts.empty()) {
        Formula left = limit * limit;
        for (const Formula& part : parts) left -= part * part;
        add(Holding::sticks, left);
      }
      continue;
    }
    const bool slips = std::ranges::any_of(std::initializer_list<Formula>{now.slip.x, now.slip.y, now.slip.z},
                                           [](const Formula& part) { return !part.is_zero(); });
    const Vector3<Formula> slip = slips ? now.slip : then.slip, along = state.direction(*contact.slip);
    const Vector3<Formula> off = cross(slip, along);
    for (const Formula& part : {off.x, off.y, off.z})
      if (!part.is_zero())
        throw NoFormula(std::string("the direction in which ") + (contact.in_joint() ? "joint '" : "contact '") +
                        contact.name + "' slides changes with the letters");
    add(Holding::slides, dot(slip, along));
  }
  return conditions;
}

StateCondition leaving_condition(const solve::MechanismStateOf<Formula>& resting, const std::vector<Formula>& unknowns,
                                 const RoughContactOf<Formula>& contact, const Vector3<Formula>& along) {
  const RoughForce<Formula> force = rough_force(resting, unknowns, contact);
  const Formula limit = contact.resting * force.push, against = dot(force.friction, along);
  const Vector3<Formula> across = force.friction - against * along;
  const bool on_line = across.x.is_zero() && across.y.is_zero() && across.z.is_zero();
  return {contact.name, Holding::slides,
          on_line ? -against - limit : dot(force.friction, force.friction) - limit * limit};
}

}  // namespace poinsot::problem
