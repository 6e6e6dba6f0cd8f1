// The verdict on a claim at a single point.
#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "problem/entries/drawn_letters.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {

struct Verdict {
  bool holds = true;
  bool close = false;                              // whether the sides are so close that rounding might decide
  bool at_end = true;                              // whether sides so close are equal to the last digits, as allowed
  bool past_end = false;                           // whether sides so close do not hold as they stand
  bool exact = false;                              // whether it was decided without rounding all the same
  std::optional<std::pair<double, double>> sides;  // of the comparison that does not hold
  std::optional<double> difference;  // the difference of the sides, if it was decided exactly and rounding hides it
  Dimension dimension;
  // How far the comparison that holds most narrowly is from failing, as a part of its sides; not positive where it
  // fails.
  double margin = std::numeric_limits<double>::infinity();
  // Sides that counted as equal, since they differ by no more than is allowed beside the natural size of such numbers.
  struct Alike {
    double left, right, allowed;
    Dimension dimension;
  };
  std::vector<Alike> alike;

  // Adds one comparison of numbers. natural: the natural size of the sides.
  void judge(double left, double right, Relation relation, double natural, const Dimension& of);
  // Adds a comparison that is known exactly not to hold.
  void refute(double left, double right, const Dimension& of);
};

// Whether the numbers have the sides with which formulas refute the claim, to a small part of their difference.
bool found_alike(const Verdict& numbers, const Verdict& formulas);
// Whether the sides with which formulas refute the claim would count as equal among the numbers of this point: a rate
// that follows from the weight is nothing beside those of a spin that is drawn a million times faster.
bool too_fine(const Verdict& numbers, const Verdict& formulas);

// The margin of a single comparison.
double margin_of(double left, double right, Relation relation);

// Whether one of these is an equation. Far from ordinary values the numbers of its sides differ by rounding.
bool states_equality(const std::vector<Expression>& claimed);

// Evaluates `X @ before` in claims about the state after a blow.
using ClaimElsewhere = SolvedInstant::Elsewhere;

// Adds the comparisons of an expression, and truth values such as stable(plate), at a solved instant. The verdict is
// close if the linearised equations do not decide stability.
void judge_numbers(Verdict& verdict, const Situation& situation, SolvedInstant& instant,
                   const ClaimElsewhere& elsewhere, const Expression& expression,
                   const std::optional<Expression>& axes);

}  // namespace poinsot::problem
