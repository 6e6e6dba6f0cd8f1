// All roots of equations for one or two unknowns, by polynomials in their place.
#pragma once

#include <vector>

#include "engine/solve/roots/root_function.h"
#include "engine/solve/roots/root_polish.h"

namespace poinsot::solve {

struct ChebyshevRoots {
  RootList roots;
  std::vector<UnresolvedPart> unresolved;  // empty: the roots are all that there are
  std::vector<Eigen::VectorXd> places;     // in the middle of unresolved parts, in natural sizes
  double reach = 0;                        // infinite ranges end at so many natural sizes
  // Unknowns that the equations leave open, and another solution. Along a curve of solutions the search ends.
  std::vector<std::size_t> open_unknowns;
  Eigen::VectorXd alternative;
};

ChebyshevRoots chebyshev_roots(RootFunction& function);

}  // namespace poinsot::solve
