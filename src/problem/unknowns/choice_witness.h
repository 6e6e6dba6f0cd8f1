// The second road to what is chosen: linear programs over all amounts at once, which know nothing of the order in which
// choices are tried.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problem/unknowns/unknown_equations.h"

namespace poinsot::problem {

// What was found of a choice: the values of the slots of the equations, for each solution.
struct ChoicesFound {
  std::vector<std::vector<double>> solutions{};
  std::optional<int> exactly{};  // how many amounts may be chosen; nothing where their total is to be the least
};

// What contradicts it, in words; nothing if nothing does, or where the conditions are not linear. amounts: for each
// thing that may be chosen the slots of its unknowns, none of which is negative.
std::optional<std::string> choice_doubt(UnknownEquations& equations,
                                        const std::vector<std::vector<std::size_t>>& amounts,
                                        const ChoicesFound& found);

// The same for any conditions on so many numbers, none of which is negative: what is left of each condition at some
// numbers, and nothing where they make no sense.
using AmountConditions = std::function<std::optional<std::vector<double>>(const std::vector<double>&)>;
std::optional<std::string> choice_doubt(const AmountConditions& conditions, std::size_t count,
                                        const std::vector<std::vector<std::size_t>>& amounts,
                                        const ChoicesFound& found);

}  // namespace poinsot::problem
