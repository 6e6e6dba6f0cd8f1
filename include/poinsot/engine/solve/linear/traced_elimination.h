// Linear equations whose coefficients are traced (traced.h), solved once for a family of systems: the elimination is
// recorded, with the pivots that the sample needs, and what tells of another system whether they do for it too.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "poinsot/engine/math/trace/traced.h"

namespace poinsot::solve {

struct TracedEquation {
  std::map<std::size_t, Traced> coefficients;
  Traced right_side;
};

struct TracedSolution {
  std::vector<Traced> value;
  std::vector<Traced> sound;       // each positive where the pivots are large enough to divide by
  std::vector<Traced> remainders;  // what must vanish if the equations that are left over hold
};

// open: gives the values of unknowns that nothing determines. Throws std::domain_error where the sample is a special
// case, in which fewer unknowns are determined than near it.
TracedSolution eliminated(std::vector<TracedEquation> equations, std::size_t unknowns,
                          const std::function<Traced(std::size_t unknown)>& open);

}  // namespace poinsot::solve
