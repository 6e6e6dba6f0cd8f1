// Checks of the motions of a statement: how far each may be off, and second roads to it and to what is told of it.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "problem/results/solution.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// Relative error allowed for a motion; the measured error is some sixteen times the actual one.
inline constexpr double motion_tolerance = 1e-5;

// Adds the checks of all motions and notes on those that are sensitive. look: checks an instant of a motion. Returns,
// by the name of a check, what speaks most against a motion.
std::map<std::string, std::string> check_motions(Sample& sample, const std::function<void(const SolvedInstant&)>& look,
                                                 Solution& result);

}  // namespace poinsot::problem
