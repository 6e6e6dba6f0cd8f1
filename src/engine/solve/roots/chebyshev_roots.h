// All roots of equations for one or two unknowns, found as zeros of polynomials that approximate the equations.
#pragma once

#include <vector>

#include "engine/solve/roots/root_function.h"
#include "engine/solve/roots/root_polish.h"

namespace poinsot::solve {

struct ChebyshevRoots {
  RootList roots;
  std::vector<UnresolvedPart> unresolved;  // if empty, there are no other roots
  std::vector<Eigen::VectorXd> places;     // the middles of the unresolved parts, in natural sizes
  double reach = 0;                        // infinite ranges are searched as far as this many natural sizes
  // The unknowns that the equations leave open, and another solution. The search ends where a curve of solutions is
  // found.
  std::vector<std::size_t> open_unknowns;
  Eigen::VectorXd alternative;
};

ChebyshevRoots chebyshev_roots(RootFunction& function);

}  // namespace poinsot::solve
