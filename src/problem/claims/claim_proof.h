// Proofs by reduction: what vanishes identically, and what has one sign under assumptions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problem/language/exact_numbers.h"
#include "problem/language/expression.h"

namespace poinsot::problem {

// left relation right, as formulas.
struct FormulaComparison {
  Formula left, right;
  Relation relation = Relation::equal;

  Formula difference() const { return left - right; }
};

// What is assumed of letters, worked into the letters themselves: I > J makes I = J + I_J with a positive letter,
// 0 < b < 90 deg makes b = 2 atan(s/(1 + s)), c == m*g makes c = m*g. What cannot be worked in is left out of proofs.
// Of several cases (a*x == b*x: a = b, or x = 0) this is one.
class WorkedCase {
 public:
  Formula apply(const Formula& x) const { return values_.empty() ? x : poinsot::substituted(x, values_); }
  // What some letters are, in the others and in letters() of its own, which are positive.
  const std::map<std::string, Formula>& values() const { return values_; }
  const std::vector<std::string>& letters() const { return letters_; }
  // Equations that could not be worked in: then nothing is proved or refuted by formulas alone.
  const std::vector<Formula>& unsolved() const { return unsolved_; }

  // Whether an assumption allows equality: strict conclusions are not drawn.
  bool is_weak() const { return weak_; }

  // Whether the comparison holds for all values of the letters in this case.
  bool proves(const FormulaComparison& comparison) const;
  // Whether x has everywhere the given sign, or vanishes.
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
  // positive: the letters that are positive by declaration.
  WorkedAssumptions(const std::vector<FormulaComparison>& assumptions, const std::vector<std::string>& positive);

  // Together they hold all values of the letters that satisfy the assumptions, if complete(). None: nothing does.
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
