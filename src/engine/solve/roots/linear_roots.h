// Recognises root problems whose equations are linear by their values, and solves them at once.
#pragma once

#include <optional>

#include "engine/solve/roots/root_function.h"

namespace poinsot::solve {

// A place well inside all ranges.
Eigen::VectorXd middle_of_ranges(const RootProblem& problem);

// Returns nothing if the equations are not linear.
std::optional<Roots> linear_roots(RootFunction& function);

}  // namespace poinsot::solve
