// Where conditions hold within a range of values so narrow that a search in steps passes over it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "problem/language/diagnostic.h"
#include "problem/quantities/quantity_functions.h"
#include "problem/unknowns/extremum.h"

namespace poinsot::problem {
namespace {

constexpr double beyond_all = std::numeric_limits<double>::infinity();

// By how much a comparison holds, beside the larger of what is compared: below zero where it fails.
double margin_between(double less, double more) {
  const double size = std::max(std::abs(less), std::abs(more));
  return size > 0 ? (more - less) / size : 0;
}

}  // namespace

std::optional<double> ExtremumSearch::margin_of(const Expression& condition, Sample& sample) {
  const std::size_t home = situation_of(statement_, ask_);
  if (const Comparison* comparison = condition.as<Comparison>()) {
    double least = beyond_all;
    for (std::size_t k = 0; k < comparison->relations.size(); ++k) {
      const Value<double> left = sample.value_in(home, comparison->operands[k]),
                          right = sample.value_in(home, comparison->operands[k + 1]);
      if (!left.is_number() || !right.is_number() || comparison->relations[k] == Relation::equal) return std::nullopt;
      const bool rises = comparison->relations[k] == Relation::less || comparison->relations[k] == Relation::less_equal;
      least = std::min(least,
                       rises ? margin_between(left.number, right.number) : margin_between(right.number, left.number));
    }
    return least;
  }
  const bool holds_here = sample.value_in(home, condition).truth;
  const Call* call = condition.as<Call>();
  if (call && call->function == "sticking") return sample.instant(sample.start_of(home)).least_margin_at_rest();
  if (holds_here) return beyond_all;
  if (call && call->function == "touching")
    return sample.value_in(home, with_function(*call, condition, "normal_force")).number;
  if (call && call->function == "taut") return sample.value_in(home, with_function(*call, condition, "tension")).number;
  if (call && call->function == "stable")
    return -sample.value_in(home, with_function(*call, condition, "growth_rate")).number;
  return std::nullopt;
}

std::optional<double> ExtremumSearch::margin_at(double value) try {
  std::optional<double> most;
  for (const Found& found : found_at(value)) {
    Sample sample(found.statement, found.settings, choice_);
    double least = beyond_all;
    for (const Expression& condition : ask_.extremum->conditions) {
      const std::optional<double> margin = margin_of(condition, sample);
      if (!margin) return std::nullopt;
      least = std::min(least, *margin);
    }
    most = std::max(most.value_or(least), least);
  }
  return most;
} catch (const StatementError&) {
  return std::nullopt;
}

std::optional<double> ExtremumSearch::held_between(const std::vector<double>& grid) {
  const auto margin = [&](double value) { return margin_at(value).value_or(-beyond_all); };
  std::vector<double> margins;
  for (const double value : grid) margins.push_back(margin(value));
  constexpr double golden = 0.6180339887498949;
  for (std::size_t i = grid.size(); i-- > 0;) {
    const std::size_t before = i == 0 ? 0 : i - 1, behind = std::min(i + 1, grid.size() - 1);
    if (!std::isfinite(margins[i]) || margins[before] > margins[i] || margins[behind] > margins[i]) continue;
    // The section by the golden ratio, which needs no slopes: margins have corners where one takes the place of
    // another.
    double from = grid[before], to = grid[behind];
    double first = to - golden * (to - from), second = from + golden * (to - from);
    double at_first = margin(first), at_second = margin(second);
    // What holds on less than this part of its values is an equality. Towards zero that is never reached.
    constexpr double together = 1e-10;
    constexpr int most_steps = 60;
    for (int step = 0; step < most_steps && std::abs(to - from) > together * std::max(std::abs(from), std::abs(to));
         ++step) {
      if (at_first > 0 && holds(first)) return first;
      if (at_second > 0 && holds(second)) return second;
      if (at_first == -beyond_all && at_second == -beyond_all) break;
      if (at_first > at_second) {
        to = second;
        second = first;
        at_second = at_first;
        first = to - golden * (to - from);
        at_first = margin(first);
      } else {
        from = first;
        first = second;
        at_first = at_second;
        second = from + golden * (to - from);
        at_second = margin(second);
      }
    }
  }
  return std::nullopt;
}

}  // namespace poinsot::problem
