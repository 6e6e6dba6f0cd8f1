// What was decided on the way to a formula.
//
// Some quantities are one formula where something is positive and another where it is negative: the larger of two
// numbers, the acute one of two angles. For an Expression the branch is taken that holds at the point of decisions
// (plain()), and what was looked at is noted. Whoever wants a formula for all values of the letters asks what was
// noted.
#pragma once

#include <vector>

#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

// What is decided in this thread while it lives; a scope within a scope keeps its own.
class DecisionScope {
 public:
  DecisionScope();
  ~DecisionScope();
  DecisionScope(const DecisionScope&) = delete;
  DecisionScope& operator=(const DecisionScope&) = delete;

  // Each was taken to have everywhere the sign that it has at the point of decisions; none is a number.
  const std::vector<Formula>& signs() const { return signs_; }
  // Whether a formula was taken for zero because its digits are, at some points (see Expression).
  bool zeros_by_digits() const { return zeros_by_digits_; }

 private:
  friend void note_sign(const Formula& x);
  friend void note_zero_by_digits();

  std::vector<Formula> signs_;
  bool zeros_by_digits_ = false;
  DecisionScope* outer_;
};

// x is taken to have everywhere the sign that it has at the point of decisions.
void note_sign(const Formula& x);
void note_zero_by_digits();
// Whether a scope lives.
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
