// Starting places for a local search for roots.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "engine/solve/roots/root_function.h"

namespace poinsot::solve {

// The place at a part (0 to 1) of a range, in natural sizes. It is spread evenly where the range is finite. Else it
// covers so many decades to either side of one natural size, measured from the finite end or from zero.
double place_in_range(const RootRange& range, double part, double decades);

// For one or two unknowns: the places of a grid where the misfit is smaller than at all neighbouring places.
std::vector<Eigen::VectorXd> starts_on_grid(RootFunction& function);

// For any number of unknowns: places drawn at random. Infinite ranges are covered over six decades of the natural
// size.
std::vector<Eigen::VectorXd> starts_at_random(const RootProblem& problem, std::size_t count);

}  // namespace poinsot::solve
