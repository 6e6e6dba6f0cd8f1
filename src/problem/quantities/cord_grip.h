// Whether friction holds a cord on its wheel, by the tensions themselves. Where one may be many times the other,
// Coulomb's law of their sum and difference (engine/dynamics/capstan.h) tells it less sharply, as its coefficient is
// close to one.
#pragma once

#include <algorithm>

#include "problem/quantities/rough_contact.h"

namespace poinsot::problem {

// Whether a cord that is taken to stick is pulled beyond what its friction holds. force_size: the largest force.
template <class Base>
bool slips_in_truth(const solve::MechanismStateOf<Base>& state, const std::vector<Base>& unknowns,
                    const RoughContactOf<Base>& contact, double force_size) {
  if (!contact.on_cord() || contact.grip != Grip::sticks) return false;
  const std::optional<Base> ratio = capstan_of(state, contact);
  if (!ratio) return false;
  const double before = plain(tension_of(state, unknowns, contact.action)),
               behind = plain(tension_of(state, unknowns, contact.behind));
  // Of the larger tension, as of the limit of any contact; and of other forces, beside which both may be none.
  constexpr double rounding = 1e-9, none = 1e-12;
  const double more = std::max(before, behind), less = std::min(before, behind);
  return more - plain(*ratio) * less > rounding * more + none * force_size;
}

}  // namespace poinsot::problem
