// Places from which to look for roots by a local method.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "engine/solve/roots/root_function.h"

namespace poinsot::solve {

// At the part 0 to 1 of a range, in natural sizes: evenly where it is finite, else by so many decades to either side of
// one natural size away from its finite end or from zero.
double place_in_range(const RootRange& range, double part, double decades);

// One or two unknowns: places of a grid where the misfit is smaller than at all neighbours.
std::vector<Eigen::VectorXd> starts_on_grid(RootFunction& function);

// Any number of unknowns: drawn at random; infinite ranges are covered over six decades of the natural size.
std::vector<Eigen::VectorXd> starts_at_random(const RootProblem& problem, std::size_t count);

}  // namespace poinsot::solve
