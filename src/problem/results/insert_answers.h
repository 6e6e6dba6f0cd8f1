// Answers that were found by themselves, put among others.
#pragma once

#include <cstddef>
#include <vector>

#include "problem/results/solution.h"

namespace poinsot::problem {

// Puts more answers among those of a solution. places: of each of them among all, ascending.
void insert_answers(Solution& solution, const std::vector<std::size_t>& places, const Solution& more);

}  // namespace poinsot::problem
