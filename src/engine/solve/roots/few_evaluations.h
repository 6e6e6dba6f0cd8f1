// Roots of equations of which an evaluation takes long.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "engine/solve/roots/root_function.h"

namespace poinsot::solve {

// Places from which a root is near. One unknown: the equations are evaluated at some 30 places across the range, closer
// together near its finite ends and the natural size where it is infinite; changes of sign are narrowed down, and the
// lowest misfits beside them. More unknowns: the lowest of some random places.
std::vector<Eigen::VectorXd> starts_from_few_evaluations(RootFunction& function);

}  // namespace poinsot::solve
