// Whether a claim holds at one point.
#pragma once

#include <optional>
#include <utility>

#include "problem/claims/claim_points.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {

struct Verdict {
  bool holds = true;
  bool close = false;                              // so near the edge that rounding might decide
  bool exact = false;                              // and it was decided without rounding
  std::optional<std::pair<double, double>> sides;  // of what does not hold
  std::optional<double> difference;                // of these, where it was decided exactly and rounding hides it
  Dimension dimension;

  // Takes in one more comparison. natural: the size that the sides naturally have.
  void judge(double left, double right, Relation relation, double natural, const Dimension& of);
  // The same where it is known exactly whether it holds.
  void refute(double left, double right, const Dimension& of);
};

// What stands before an `@ before` in claims made after a blow.
using ClaimElsewhere = SolvedInstant::Elsewhere;

// Takes in comparisons, and truth values such as stable(plate), of a solved instant. It is close where the linearised
// equations do not decide stability.
void judge_numbers(Verdict& verdict, const Situation& situation, SolvedInstant& instant,
                   const ClaimElsewhere& elsewhere, const Expression& expression,
                   const std::optional<Expression>& axes);

}  // namespace poinsot::problem
