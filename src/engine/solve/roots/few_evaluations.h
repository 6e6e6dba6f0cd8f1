// Starting places for roots of equations that take long to evaluate.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "engine/solve/roots/root_function.h"

namespace poinsot::solve {

// Places near which a root is likely. With one unknown the equations are evaluated at some 30 places across the
// range, which lie closer together near finite ends and, where the range is infinite, near the natural size. Changes
// of sign are narrowed down, and the places of the lowest misfits are added. With more unknowns the places of the
// lowest misfits among some random ones are taken.
std::vector<Eigen::VectorXd> starts_from_few_evaluations(RootFunction& function);

}  // namespace poinsot::solve
