// Values of letters all over six decades, of both signs where they may have them, angles all round.
#pragma once

#include <cstddef>
#include <vector>

#include "poinsot/engine/math/formula/formula.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {

// Points that fill the space of the letters evenly however many are taken: the additive recurrence with the inverse
// powers of the root of x^(d+1) = x + 1, in the logarithms of the letters. The same letters, in whatever order a file
// names them, have the same points.
class LetterScan {
 public:
  // base: the values around which the letters are spread, each by a thousand times either way.
  LetterScan(std::vector<Letter> letters, LetterValues base);

  LetterValues point(std::size_t index) const;
  // The same within half a decade of the base, where moments of inertia still are those of a body.
  LetterValues near(std::size_t index) const;

 private:
  std::vector<Letter> letters_;  // by name
  LetterValues base_;
  std::vector<double> steps_;  // of the recurrence, one for each letter
};

}  // namespace poinsot::problem
