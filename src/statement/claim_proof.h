// Proofs by reduction: what vanishes identically, and what has one sign under assumptions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "poinsot/statement/expression.h"
#include "statement/exact_numbers.h"

namespace poinsot::statement {

// left relation right, as formulas.
struct FormulaComparison {
  Formula left, right;
  Relation relation = Relation::equal;

  Formula difference() const { return left - right; }
};

// What is assumed of letters, worked into the letters themselves: I > J makes I = J + I_J with a positive letter,
// 0 < b < 90 deg makes b = 2 atan(s/(1 + s)), c == m*g makes c = m*g. What cannot be worked in is left out of proofs.
class WorkedAssumptions {
 public:
  // positive: the letters that are positive by declaration.
  WorkedAssumptions(const std::vector<FormulaComparison>& assumptions, const std::vector<std::string>& positive);

  Formula apply(const Formula& x) const { return values_.empty() ? x : poinsot::substituted(x, values_); }
  // What some letters are, in the others and in letters() of its own, which are positive.
  const std::map<std::string, Formula>& values() const { return values_; }
  const std::vector<std::string>& letters() const { return letters_; }
  // Equations that could not be worked in: then nothing is proved or refuted by formulas alone.
  const std::vector<Formula>& unsolved() const { return unsolved_; }

  // Whether the comparison holds for all values of the letters that satisfy the assumptions.
  bool proves(const FormulaComparison& comparison) const;

 private:
  void work_in_equation(const Formula& difference, const std::vector<std::string>& positive);
  bool work_in_order(const Formula& difference, const std::vector<std::string>& positive);
  void work_in_angles();
  void set(const std::string& letter, const Formula& value);
  Formula fresh_letter();

  std::map<std::string, Formula> values_;
  std::vector<std::string> letters_;
  std::vector<Formula> unsolved_;
  struct Range {
    Formula low, high;
    bool has_low = false, has_high = false;
  };
  std::map<std::string, Range> ranges_;
  bool weak_ = false;  // an assumption that allows equality: strict conclusions are not drawn
};

}  // namespace poinsot::statement
