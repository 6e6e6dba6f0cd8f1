// Equations that are linear in some of their unknowns: with these eliminated, few unknowns are left.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "engine/solve/roots/root_function.h"

namespace poinsot::solve {

struct PartlyLinearRoots {
  std::vector<Eigen::VectorXd> places;  // near roots, in natural sizes, of all unknowns
  bool complete = false;                // there are no others in the ranges, as far as `reach`
  double reach = 0;
};

// Where all unknowns but one or two enter linearly (for each value of these), the others are eliminated by Cramer's
// rule, and what is left is a search for one or two unknowns. Nothing where the equations are not of this kind, or
// leave the roots open. seconds: as for find_roots.
std::optional<PartlyLinearRoots> partly_linear_roots(RootFunction& function, double seconds);

}  // namespace poinsot::solve
