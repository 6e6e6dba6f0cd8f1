// Linear equations over formulas, solved exactly for letters in general position.
#pragma once

#include <functional>
#include <vector>

#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/solve/linear/linear_system.h"

namespace poinsot::solve {

struct ExactSolution {
  std::vector<Formula> value;       // one solution; unknowns that nothing fixes are as asked for
  std::vector<bool> determined;     // of each unknown: whether the equations fix it
  std::vector<Formula> remainders;  // what is left of equations when all unknowns are eliminated: each must vanish
};

// By Gauss's elimination on sparse rows, every pivot certain to be no zero; the next pivot is the one that fills in
// least with the fewest terms. A pivot that vanishes for special values of the letters is taken to be none there.
// Throws ExpressionTooLarge.
// open: the values of unknowns that nothing fixes, by index; zero when left out.
ExactSolution solve_exactly(const LinearSystemOf<Formula>& system,
                            const std::function<Formula(std::size_t)>& open = {});

}  // namespace poinsot::solve
