// Sizes |x| that are decided where the sign of x is not known.
//
// The size of cos(b) is cos(b) for some angles and -cos(b) for others, and is written abs(cos(b)): true for all of
// them, but a length that is r cos(b) on one road and r |cos(b)| on another then differs from itself. Who looks at one
// pose only, in which the sign is known by numbers, takes the size that it has there.
#pragma once

#include <functional>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

// As long as it exists in this thread, and unless it is told not to, roots and sizes of x whose sign is not known are
// taken with the sign at the point of decisions (plain()), which is recorded (formula_decision.h).
class DecidedSizesScope {
 public:
  explicit DecidedSizesScope(bool decided = true);
  ~DecidedSizesScope();
  DecidedSizesScope(const DecidedSizesScope&) = delete;
  DecidedSizesScope& operator=(const DecidedSizesScope&) = delete;

 private:
  bool outer_;
};

// x with the signs in it that are known by their arguments: 1, -1, or 0 of one that stays.
Formula with_known_signs(const Formula& x, const std::function<int(const Formula& argument)>& sign_of);

}  // namespace poinsot
