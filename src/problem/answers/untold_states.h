// States of contacts with friction that open letters may reach beyond those that an answer tells.
#pragma once

#include <string>
#include <vector>

#include "problem/machine/data.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// What is to be said of them. told: the combinations of the solutions. The letters are drawn far and wide: angles all
// round, and both signs where a letter may have them.
std::vector<std::string> untold_states(const Statement& statement, const Settings& settings,
                                       const std::vector<std::vector<ContactState>>& told);

}  // namespace poinsot::problem
