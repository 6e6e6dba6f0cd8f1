#include "problem/claims/claim_verdict.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/evaluate_support.h"

namespace poinsot::problem {
namespace {

// Difference up to which two sides count as equal, as a part of the larger one or of the natural size of such numbers.
// Rates and forces of an instant are good to some 1e-12 of that, in long chains a hundred times less: with a tenth of
// this, true equalities would be refuted. With ten times as much, points at which a claim fails would be passed over
// that the numbers can tell.
constexpr double equal_tolerance = 1e-9;

}  // namespace

bool found_alike(const Verdict& numbers, const Verdict& formulas) {
  // Of the difference: sides are good to 1e-9 of themselves, so that differences down to a thousandth of them are told.
  constexpr double same = 1e-6;
  if (!numbers.holds || formulas.holds || !formulas.sides) return false;
  const auto& of_formulas = *formulas.sides;
  const double apart = same * std::abs(of_formulas.first - of_formulas.second);
  return std::ranges::any_of(numbers.alike, [&](const Verdict::Alike& sides) {
    return std::abs(sides.left - of_formulas.first) <= apart && std::abs(sides.right - of_formulas.second) <= apart;
  });
}

bool too_fine(const Verdict& numbers, const Verdict& formulas) {
  if (!numbers.holds || numbers.close || formulas.holds || !formulas.sides) return false;
  const double apart = std::abs(formulas.sides->first - formulas.sides->second);
  return std::ranges::any_of(numbers.alike, [&](const Verdict::Alike& sides) {
    return sides.dimension == formulas.dimension && apart <= sides.allowed;
  });
}

double margin_of(double left, double right, Relation relation) {
  const double size = std::max(std::abs(left), std::abs(right));
  const double rise = size > 0 ? (right - left) / size : 0;
  switch (relation) {
    case Relation::equal:
      return equal_tolerance - std::abs(rise);
    case Relation::less:
    case Relation::less_equal:
      return rise;
    case Relation::greater:
    case Relation::greater_equal:
      break;
  }
  return -rise;
}

bool states_equality(const std::vector<Expression>& claimed) {
  return std::ranges::any_of(claimed, [](const Expression& expression) {
    const Comparison* comparison = expression.as<Comparison>();
    return comparison && std::ranges::find(comparison->relations, Relation::equal) != comparison->relations.end();
  });
}

void Verdict::judge(double left, double right, Relation relation, double natural, const Dimension& of) {
  const double size = std::max({std::abs(left), std::abs(right), natural});
  const double allowed = equal_tolerance * size;
  const bool equal = std::abs(left - right) <= allowed;
  if (relation != Relation::equal || !equal) margin = std::min(margin, margin_of(left, right, relation));
  if (equal) alike.push_back({left, right, allowed, of});
  bool holds_here = false;
  switch (relation) {
    case Relation::equal:
      holds_here = equal;
      break;
    case Relation::less:
    case Relation::less_equal:
      holds_here = left < right;
      break;
    case Relation::greater:
    case Relation::greater_equal:
      holds_here = left > right;
      break;
  }
  if (relation != Relation::equal && equal) {
    close = true;
    past_end = past_end || (!holds_here && left != right);
    constexpr double last_digits = 4e-15;  // some ten roundings of the sides
    const bool allowed_there = relation == Relation::less_equal || relation == Relation::greater_equal;
    at_end =
        at_end && allowed_there && std::abs(left - right) <= last_digits * std::max(std::abs(left), std::abs(right));
  } else if (!holds_here) {
    refute(left, right, of);
  }
}

void Verdict::refute(double left, double right, const Dimension& of) {
  if (!holds) return;
  holds = false;
  sides = {left, right};
  dimension = of;
}

void judge_numbers(Verdict& verdict, const Situation& situation, SolvedInstant& instant,
                   const ClaimElsewhere& elsewhere, const Expression& expression,
                   const std::optional<Expression>& axes) {
  const auto value = [&](const Expression& part) { return instant.raw(part, axes, elsewhere); };
  const Comparison* comparison = expression.as<Comparison>();
  if (!comparison) {
    const Value<double> truth = value(expression);
    if (!truth.is_boolean())
      fail(situation.file, expression.mark(), "'" + to_string(expression) + "' claims nothing",
           "compare it with something");
    const Call* call = expression.as<Call>();
    if (!truth.truth && call && call->function == "stable" &&
        value(with_function(*call, expression, "stability")).text != "unstable") {
      verdict.close = true;
      verdict.at_end = false;
    } else {
      verdict.holds = verdict.holds && truth.truth;
    }
    return;
  }
  std::vector<Value<double>> sides;
  for (const Expression& operand : comparison->operands) sides.push_back(as_vector(value(operand)));
  for (std::size_t i = 0; i < comparison->relations.size(); ++i) {
    const Value<double>&left = sides[i], &right = sides[i + 1];
    const bool zero = (left.is_vector() && right.is_number() && right.bare && right.number == 0) ||
                      (right.is_vector() && left.is_number() && left.bare && left.number == 0);
    if (i == 0 && !zero) value(expression);
    const Dimension dimension = left.bare ? right.dimension : left.dimension;
    const double natural = instant.natural_size(dimension);
    if (!left.is_vector() && !right.is_vector()) {
      verdict.judge(left.number, right.number, comparison->relations[i], natural, dimension);
      continue;
    }
    const double size = std::max({natural, norm(left.vector), norm(right.vector)});
    for (std::size_t k = 0; k < 3; ++k)
      verdict.judge(left.vector[k], right.vector[k], comparison->relations[i], size, dimension);
  }
}

}  // namespace poinsot::problem
