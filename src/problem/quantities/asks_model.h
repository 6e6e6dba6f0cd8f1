// Whether the value of an expression rests on the model.
#pragma once

#include "problem/entries/statement.h"

namespace poinsot::problem {

// Whether an expression asks for anything of the model: a quantity, a coordinate or an unknown, possibly by a name
// under define:. What stands before an @ is looked at only if `into_at`.
bool asks_model(const Situation& situation, const Expression& expression, bool into_at = true);

// Whether it asks for an energy, of which the unit is the joule.
bool asks_energy(const Expression& expression);

}  // namespace poinsot::problem
