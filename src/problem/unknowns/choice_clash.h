// Why no choice of amounts that are not negative satisfies the conditions (`choose:`).
#pragma once

#include <set>
#include <string>
#include <vector>

#include "problem/unknowns/unknown_equations.h"

namespace poinsot::problem {

// Of conditions that are linear in the unknowns, what stands in the way of every choice.
struct ChoiceClash {
  bool told = false;                    // not of conditions that are not linear
  std::vector<std::string> conditions;  // that clash even if all amounts may take part; none: more amounts would do
  bool by_sign = false;                 // negative values would satisfy them
  std::vector<std::size_t> would_do;    // else: the fewest amounts that do
};

// unknowns_of: of each amount, the unknowns in it; all others may take part in any case.
ChoiceClash choice_clash(UnknownEquations& equations, const std::vector<std::set<std::string>>& unknowns_of);

}  // namespace poinsot::problem
