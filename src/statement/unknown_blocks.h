// Which unknowns can be found before which.
#pragma once

#include <vector>

#include "statement/unknown_equations.h"

namespace poinsot::statement {

// The groups of conditions in the order in which as few new unknowns as possible enter, each block with as many
// independent conditions as unknowns. What is short of conditions comes last, in one block.
std::vector<UnknownSystem> blocks_of(UnknownEquations& equations);

// How many numbers are sought, how many conditions change with them, and how many of these are independent, at some
// values of the unknowns. All alike where no values make sense.
struct Balance {
  std::size_t unknowns = 0, conditions = 0, independent = 0;
};
Balance balance_of(UnknownEquations& equations);

}  // namespace poinsot::statement
