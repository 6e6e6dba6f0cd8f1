// Which constraints of contacts forbid slipping.
#pragma once

#include <cstddef>

#include "poinsot/engine/dynamics/mechanism.h"

namespace poinsot::problem {

// Whether a constraint keeps the sides of a contact from slipping, as long as they press: where they part it tells
// nothing.
template <class Scalar>
bool against_slipping(const Mechanism<Scalar>& mechanism, const VelocityConstraint<Scalar>& constraint) {
  return constraint.action >= 0 && !constraint.normal &&
         mechanism.actions[static_cast<std::size_t>(constraint.action)].kind == ActionKind::contact;
}

}  // namespace poinsot::problem
