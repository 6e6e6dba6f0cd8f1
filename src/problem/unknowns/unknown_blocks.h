// Which unknowns can be found before which.
#pragma once

#include <string>
#include <vector>

#include "problem/unknowns/unknown_equations.h"

namespace poinsot::problem {

// The groups of conditions in the order in which as few new unknowns as possible enter, each block with as many
// independent conditions as unknowns. What is short of conditions comes last, in one block.
std::vector<UnknownSystem> blocks_of(UnknownEquations& equations);

// Unknowns and the conditions that speak of them, in words.
struct SystemPart {
  std::vector<std::string> unknowns, conditions;
  std::size_t numbers = 0, equations = 0, independent = 0;  // sought, stated, and independent among these
};
// "a, b: 2 unknowns, but one independent condition on them: mass(bar) at 'now'"
std::string shortage_in_words(const SystemPart& part);
// "a, b: 2 unknowns in 3 conditions: mass(bar) at 'now'; ..."
std::string surplus_in_words(const SystemPart& part);

// How many numbers are sought, how many conditions change with them, and how many of these are independent, at some
// values of the unknowns. All alike where no values make sense.
struct Balance {
  std::size_t unknowns = 0, conditions = 0, independent = 0;
  SystemPart short_of;  // unknowns that can change together without changing any condition to first order
  SystemPart surplus;   // conditions of which at least one follows from the others, or contradicts them
};
Balance balance_of(UnknownEquations& equations);

// "one unknown", "3 unknowns".
std::string counted(std::size_t count, const std::string& what);

}  // namespace poinsot::problem
