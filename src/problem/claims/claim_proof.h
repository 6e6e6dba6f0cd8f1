// Proofs by reduction: formulas that vanish identically, or that have one sign under the assumptions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problem/language/exact_numbers.h"
#include "problem/language/expression.h"

namespace poinsot::problem {

// `left relation right`, both as formulas.
struct FormulaComparison {
  Formula left, right;
  Relation relation = Relation::equal;

  Formula difference() const { return left - right; }
};

// Assumptions worked into the letters themselves: I > J makes I = J + I_J with a positive letter I_J, 0 < b < 90 deg
// makes b = 2 atan(s/(1 + s)), c == m*g makes c = m*g. Assumptions that cannot be worked in are not used in proofs.
// Of several cases (a*x == b*x holds if a = b or x = 0) this is one.
class WorkedCase {
 public:
  Formula apply(const Formula& x) const { return values_.empty() ? x : poinsot::substituted(x, values_); }
  // The values of some letters, in terms of the others and of new ones, letters(), which are positive.
  const std::map<std::string, Formula>& values() const { return values_; }
  const std::vector<std::string>& letters() const { return letters_; }
  // Equations that could not be worked in. If there are any, formulas alone prove and refute nothing.
  const std::vector<Formula>& unsolved() const { return unsolved_; }

  // Whether an assumption allows equality, so that strict inequalities do not follow.
  bool is_weak() const { return weak_; }

  // Whether the comparison holds for all values of the letters in this case.
  bool proves(const FormulaComparison& comparison) const;
  // Whether x has the given sign everywhere, or may vanish.
  bool keeps_sign(const Formula& x, int sign) const;

 private:
  friend class AssumptionWorker;

  std::map<std::string, Formula> values_;
  std::vector<std::string> letters_;
  std::vector<Formula> unsolved_;
  bool weak_ = false;
};

class WorkedAssumptions {
 public:
  // positive: the letters that are declared positive.
  WorkedAssumptions(const std::vector<FormulaComparison>& assumptions, const std::vector<std::string>& positive);

  // If complete(), the cases together comprise all values of the letters that satisfy the assumptions. There are no
  // cases if no values do.
  const std::vector<WorkedCase>& cases() const { return cases_; }
  bool complete() const { return complete_; }

  // Whether the comparison holds for all values of the letters that satisfy the assumptions.
  bool proves(const FormulaComparison& comparison) const;
  bool keeps_sign(const Formula& x, int sign) const;

 private:
  std::vector<WorkedCase> cases_;
  bool complete_ = true;
};

}  // namespace poinsot::problem
