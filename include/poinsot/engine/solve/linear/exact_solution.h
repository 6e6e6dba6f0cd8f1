// Linear equations over formulas, solved exactly for letters in general position.
#pragma once

#include <functional>
#include <vector>

#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/solve/linear/linear_system.h"

namespace poinsot::solve {

struct ExactSolution {
  std::vector<Formula> value;       // one solution; `open` gives the unknowns that nothing determines
  std::vector<bool> determined;     // for each unknown, whether the equations determine it
  std::vector<Formula> remainders;  // of equations after all unknowns are eliminated; each must vanish
};

// By Gauss's elimination on sparse rows, every pivot certain to be no zero; the next pivot is the one that fills in
// least with the fewest terms. A pivot that vanishes for special values of the letters is taken to be none there.
// Throws FormulaTooLarge.
// open: the values of unknowns that nothing fixes, by index; zero when left out.
ExactSolution solve_exactly(const LinearSystemOf<Formula>& system,
                            const std::function<Formula(std::size_t)>& open = {});

}  // namespace poinsot::solve
