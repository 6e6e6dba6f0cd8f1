#include "statement/claim_proof.h"

#include <algorithm>
#include <cmath>

#include "poinsot/math/expression_sign.h"

namespace poinsot::statement {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

// The value of the letter for which x, linear in it, vanishes: a - x / (dx/da); nothing where x is not linear.
std::optional<Formula> linear_root(const Formula& x, const std::string& letter, poinsot::Sign sign) {
  const Formula slope = derivative(x, letter);
  if (slope.is_zero() || contains(slope.letters(), letter)) return std::nullopt;
  const Formula root = Formula::letter(letter, sign) - x / slope;
  if (contains(root.letters(), letter)) return std::nullopt;
  return root;
}

}  // namespace

WorkedAssumptions::WorkedAssumptions(const std::vector<FormulaComparison>& assumptions,
                                     const std::vector<std::string>& positive) {
  for (const FormulaComparison& assumption : assumptions)
    if (assumption.relation == Relation::equal) work_in_equation(apply(assumption.difference()), positive);
  for (const FormulaComparison& assumption : assumptions) {
    if (assumption.relation == Relation::equal) continue;
    const bool greater = assumption.relation == Relation::greater || assumption.relation == Relation::greater_equal;
    const Formula difference = apply(assumption.difference());
    if (work_in_order(greater ? difference : -difference, positive))
      weak_ = weak_ || assumption.relation == Relation::less_equal || assumption.relation == Relation::greater_equal;
  }
  work_in_angles();
}

Formula WorkedAssumptions::fresh_letter() {
  letters_.push_back("part " + std::to_string(letters_.size() + 1));
  return Formula::letter(letters_.back(), poinsot::Sign::positive);
}

void WorkedAssumptions::set(const std::string& letter, const Formula& value) {
  for (auto& [name, known] : values_) known = poinsot::substituted(known, {{letter, value}});
  values_[letter] = value;
}

void WorkedAssumptions::work_in_equation(const Formula& difference, const std::vector<std::string>& positive) {
  if (difference.is_zero()) return;
  // Letters by which it is solved without a root; first those that stay positive by their look.
  for (const bool certain : {true, false})
    for (const std::string& letter : difference.letters()) {
      const bool is_positive = contains(positive, letter);
      const auto root = linear_root(difference, letter, is_positive ? poinsot::Sign::positive : poinsot::Sign::real);
      if (!root) continue;
      if (certain && is_positive && seen_sign(*root).sign <= 0) continue;
      set(letter, *root);
      return;
    }
  unsolved_.push_back(difference);
}

// difference > 0.
bool WorkedAssumptions::work_in_order(const Formula& difference, const std::vector<std::string>& positive) {
  for (const std::string& letter : difference.letters()) {
    const bool is_positive = contains(positive, letter);
    const Formula slope = derivative(difference, letter);
    const auto bound = linear_root(difference, letter, is_positive ? poinsot::Sign::positive : poinsot::Sign::real);
    if (!bound) continue;
    const SeenSign rising = seen_sign(slope);
    if (!is_positive && bound->is_number()) {
      Range& range = ranges_[letter];
      (rising.sign > 0 ? range.low : range.high) = *bound;
      (rising.sign > 0 ? range.has_low : range.has_high) = true;
      return true;
    }
    if (rising.sign <= 0 || !rising.strict) continue;
    if (is_positive && !bound->is_zero() && seen_sign(*bound).sign <= 0) continue;
    set(letter, *bound + fresh_letter());
    return true;
  }
  return false;
}

// Letters between numbers. From 0 to at most 180 deg: tan(b/2) goes from 0 to a number or without end; other letters
// go from a number up, or between two.
void WorkedAssumptions::work_in_angles() {
  for (const auto& [letter, range] : ranges_) {
    if (!range.has_low) continue;
    if (!range.has_high) {
      set(letter, range.low + fresh_letter());
      continue;
    }
    const Formula s = fresh_letter();
    const Formula part = s / (Formula(1) + s);
    const Formula half = range.high / Formula(2);
    if (range.low.is_zero() && range.high == Formula::pi())
      set(letter, Formula(2) * atan(s));
    else if (range.low.is_zero() && plain(range.high) < 3.1415 && plain(range.high) > 0)
      set(letter, Formula(2) * atan(tan(half) * part));
    else
      set(letter, range.low + (range.high - range.low) * part);
  }
}

bool WorkedAssumptions::proves(const FormulaComparison& comparison) const {
  const Formula difference = apply(comparison.difference());
  if (comparison.relation == Relation::equal) return difference.is_zero();
  const bool greater = comparison.relation == Relation::greater || comparison.relation == Relation::greater_equal;
  const bool strict = comparison.relation == Relation::greater || comparison.relation == Relation::less;
  if (difference.is_zero()) return !strict;
  const SeenSign seen = seen_sign(difference);
  return seen.sign == (greater ? 1 : -1) && (!strict || (seen.strict && !weak_));
}

}  // namespace poinsot::statement
