// What dimensions tell of a product of powers of letters: with as many letters of independent dimensions as there are
// units that nothing fixes, their exponents follow from those of all others.
#pragma once

#include <vector>

#include "problem/formulas/scaling_trials.h"

namespace poinsot::problem {

class LetterDimensions {
 public:
  // units: those that nothing in the problem fixes.
  LetterDimensions(const std::vector<Letter>& letters, const std::vector<Units>& units);

  // The indices of the letters of independent dimensions, the first of them that there are.
  const std::vector<std::size_t>& pivots() const { return pivots_; }
  bool is_pivot(std::size_t letter) const;
  // The exponents with which the pivots form a dimension in these units. Throws NoFormula if there are none.
  std::vector<double> exponents(const Dimension& dimension) const;

 private:
  const std::vector<Letter> letters_;
  const std::vector<Units> units_;
  std::vector<std::size_t> pivots_;
};

}  // namespace poinsot::problem
