// What is known of a force that contacts or cords share: the range of its values.
#pragma once

#include <string>

#include "problem/results/solution.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// "as none of them pulls, it lies between 0 and 49 N", in the unit of the answer; empty where nothing bounds it.
std::string range_in_words(const Ask& ask, const SolvedAsk& solved, Sample& sample);

}  // namespace poinsot::problem
