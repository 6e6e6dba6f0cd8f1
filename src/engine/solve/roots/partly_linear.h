// Root problems whose equations are linear in some unknowns: these are eliminated, and few unknowns are left.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "engine/solve/roots/root_function.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {

struct PartlyLinearRoots {
  std::vector<Eigen::VectorXd> places;  // near roots, in natural sizes, for all unknowns
  bool complete = false;                // whether the ranges hold no other roots, as far as `reach`
  double reach = 0;
};

// If all unknowns but one or two enter linearly for fixed values of these, they are eliminated by Cramer's rule,
// which leaves a search for one or two unknowns. Returns nothing where the equations are not of this kind or leave
// the roots open. most: as for find_roots.
std::optional<PartlyLinearRoots> partly_linear_roots(RootFunction& function, Work most);

}  // namespace poinsot::solve
