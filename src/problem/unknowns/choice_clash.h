// Explains why no choice of non-negative amounts satisfies the conditions (`choose:`).
#pragma once

#include <set>
#include <string>
#include <vector>

#include "problem/unknowns/unknown_equations.h"

namespace poinsot::problem {

// The conditions that no choice can satisfy together, if the conditions are linear in the unknowns.
struct ChoiceClash {
  bool told = false;  // false if the conditions are not linear
  // Those that clash even if all amounts may be used; empty if more amounts would satisfy them.
  std::vector<std::string> conditions;
  bool by_sign = false;               // whether negative amounts would satisfy them
  std::vector<std::size_t> would_do;  // otherwise the smallest set of amounts that satisfies them
};

// unknowns_of: for each amount the unknowns that it depends on. All other unknowns are free in any case.
ChoiceClash choice_clash(UnknownEquations& equations, const std::vector<std::set<std::string>>& unknowns_of);

}  // namespace poinsot::problem
