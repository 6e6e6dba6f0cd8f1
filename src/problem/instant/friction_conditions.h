// What must be positive, in letters, for contacts with friction to stay in their states.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/math/formula/formula.h"
#include "problem/quantities/rough_contact.h"

namespace poinsot::problem {

struct StateCondition {
  std::string contact;
  Holding holding = Holding::presses;
  Formula positive;
};

// All of them, with those that hold for all letters left out, of a state with accelerations and its unknowns. Throws
// NoFormula (language/exact_numbers.h) where a contact slides in a direction that changes with the letters.
std::vector<StateCondition> state_conditions(const solve::MechanismStateOf<Formula>& state,
                                             const std::vector<Formula>& unknowns,
                                             const std::vector<RoughContactOf<Formula>>& contacts);

// What must be positive for a contact not to stay at rest: beyond its limit in the state in which it rests, with the
// unknowns of that. along: the direction in which it would begin to slide.
StateCondition leaving_condition(const solve::MechanismStateOf<Formula>& resting, const std::vector<Formula>& unknowns,
                                 const RoughContactOf<Formula>& contact, const Vector3<Formula>& along);

}  // namespace poinsot::problem
