// Records the decisions on signs that lead to a formula.
//
// Some quantities are one formula where something is positive and another where it is negative: the larger of two
// numbers, the acute one of two angles. The branch that holds at the point of decisions is taken (plain()), and the
// sign that decided is recorded. Who needs a formula for all values of the letters can then check these signs.
#pragma once

#include <vector>

#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

// Records the decisions in this thread as long as it exists. A scope within a scope has its own records.
class DecisionScope {
 public:
  DecisionScope();
  ~DecisionScope();
  DecisionScope(const DecisionScope&) = delete;
  DecisionScope& operator=(const DecisionScope&) = delete;

  // Each of these was assumed to have the sign everywhere that it has at the point of decisions. None is a number.
  const std::vector<Formula>& signs() const { return signs_; }
  // Whether a formula was taken for zero because its digits vanish at some points (see Formula).
  bool zeros_by_digits() const { return zeros_by_digits_; }

 private:
  friend void note_sign(const Formula& x);
  friend void note_zero_by_digits();

  std::vector<Formula> signs_;
  bool zeros_by_digits_ = false;
  DecisionScope* outer_;
};

// Records that x is assumed to have the sign everywhere that it has at the point of decisions.
void note_sign(const Formula& x);
void note_zero_by_digits();
// Whether there is a scope.
bool notes_decisions();

// Whether x < 0 at the point of decisions.
template <class Scalar>
bool decided_negative(const Scalar& x) {
  return plain(x) < 0;
}
inline bool decided_negative(const Formula& x) {
  note_sign(x);
  return plain(x) < 0;
}
template <int N, class Base>
bool decided_negative(const Dual<N, Base>& x) {
  return decided_negative(x.value);
}

}  // namespace poinsot
