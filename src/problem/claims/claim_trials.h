// Points at which the formulas of a claim are tried: letters drawn within what is assumed, and where sides meet.
#pragma once

#include <optional>
#include <vector>

#include "problem/claims/claim_instant.h"
#include "problem/claims/claim_points.h"
#include "problem/claims/claim_verdict.h"

namespace poinsot::problem {

// Letters that stand for positive numbers.
bool is_positive(const Letter& letter);

class ClaimTrials {
 public:
  // letters: all that the formulas may have. All must outlive it.
  ClaimTrials(const ClaimInstant& formulas, const WorkedAssumptions& worked, const std::vector<Letter>& letters)
      : formulas_(formulas), worked_(worked), letters_(letters) {}

  // A point of one of the cases, on which what is assumed holds.
  struct Drawn {
    Point point;
    const WorkedCase* of = nullptr;
    Point free;         // the letters of the case that were drawn
    bool edge = false;  // chosen so that sides meet
  };
  std::optional<Drawn> draw(int attempt);
  // Points where the sides of an inequality meet, and on either side of these: one letter moved, the others kept. What
  // an assumption sets apart meets too, where it allows that.
  std::vector<Drawn> at_edges(const Drawn& from, int attempt);

  // What is claimed, at a point.
  Verdict verdict(const Drawn& drawn);

 private:
  // Where the sides of inequalities meet: factors of their differences, in each case.
  struct Edge {
    const WorkedCase* of;
    Formula factor;
  };
  const std::vector<Edge>& edges();
  std::optional<Drawn> completed(const WorkedCase& one, Point free, bool edge = false);
  Verdict compared(const FormulaComparison& comparison, const Drawn& drawn, const Dimension& dimension);

  const ClaimInstant& formulas_;
  const WorkedAssumptions& worked_;
  const std::vector<Letter>& letters_;
  std::optional<std::vector<Edge>> edges_;
  int exact_equalities_ = 0;  // that were looked at
};

}  // namespace poinsot::problem
