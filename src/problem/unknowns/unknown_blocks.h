// Splits the unknowns into blocks that can be found one after the other.
#pragma once

#include <string>
#include <vector>

#include "problem/unknowns/unknown_equations.h"

namespace poinsot::problem {

// The groups of conditions, in an order in which each brings as few new unknowns as possible. Each block has as many
// independent conditions as unknowns. What has too few conditions forms the last block.
std::vector<UnknownSystem> blocks_of(UnknownEquations& equations);

// Some unknowns and the conditions on them, in words.
struct SystemPart {
  std::vector<std::string> unknowns, conditions;
  // Numbers that are sought, conditions that are stated, and how many of these are independent.
  std::size_t numbers = 0, equations = 0, independent = 0;
};
// "a, b: 2 unknowns, but one independent condition on them: mass(bar) at 'now'"
std::string shortage_in_words(const SystemPart& part);
// "a, b: 2 unknowns in 3 conditions: mass(bar) at 'now'; ..."
std::string surplus_in_words(const SystemPart& part);

// The number of values that are sought, of conditions that depend on them, and of independent ones among these, at
// some values of the unknowns. If no values make sense all three are equal.
struct Balance {
  std::size_t unknowns = 0, conditions = 0, independent = 0;
  SystemPart short_of;  // unknowns that can change together, to first order without any effect on the conditions
  SystemPart surplus;   // conditions of which at least one follows from the others or contradicts them
};
Balance balance_of(UnknownEquations& equations);

}  // namespace poinsot::problem
