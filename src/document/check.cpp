#include "document/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>
#include <set>

#include "document/datum_text.h"
#include "document/rounding.h"

namespace poinsot::document {
namespace {

using List = std::vector<Datum>;

constexpr int digits = 9;  // in messages: finer than common tolerances
// The size of an expected zero, SI, where nothing else in its unit is larger than what was found in its place: a
// thousandth of what people state in such units. With the usual relative tolerance a zero is one below 1e-9.
constexpr double scale_of_zero = 1e-3;

std::string text_of(const Datum& datum) { return datum_text(datum, "", digits); }

const Datum& si_of(const Answer& answer) { return answer.si.empty() ? answer.value : answer.si; }

double magnitude(const Datum& datum) {
  const auto* number = std::get_if<double>(&datum.content);
  return number == nullptr ? 0 : std::abs(*number);
}

double largest_magnitude(const Datum& datum) {
  double largest = magnitude(datum);
  if (const auto* list = std::get_if<List>(&datum.content))
    for (const Datum& item : *list) largest = std::max(largest, largest_magnitude(item));
  return largest;
}

// Of the answers in this unit, SI.
double largest_in_unit(const Solution& solution, const std::string& unit) {
  double largest = 0;
  for (const Answer& answer : solution.answers) {
    if (answer.unit == unit) largest = std::max(largest, largest_magnitude(si_of(answer)));
    for (const Column& column : answer.columns)
      for (const double number : column.si)
        if (column.unit == unit) largest = std::max(largest, std::abs(number));
  }
  return largest;
}

// Describes the first place at which a datum differs from the expected one.
class Comparison {
 public:
  // solution: that of the answer, in which other answers show how large such a quantity is.
  Comparison(const Expectation& expectation, const Solution& solution, std::string unit)
      : expectation_(expectation), solution_(solution), unit_(std::move(unit)) {}

  std::optional<std::string> difference(const Datum& found, const Datum& expected) const {
    if (const auto* list = std::get_if<List>(&expected.content)) {
      const auto* found_list = std::get_if<List>(&found.content);
      if (found_list == nullptr) return fmt::format("{}, expected the list {}", text_of(found), text_of(expected));
      return list_difference(found, *found_list, expected, *list);
    }
    if (const auto* number = std::get_if<double>(&expected.content)) {
      const auto* found_number = std::get_if<double>(&found.content);
      if (found_number == nullptr) return fmt::format("{}, expected the number {}", text_of(found), text_of(expected));
      const double tolerance = tolerance_at(std::abs(*number), std::abs(*found_number), unit_);
      if (within(*found_number, *number, tolerance)) return std::nullopt;
      return fmt::format("{}, expected {}{}", text_of(found), text_of(expected),
                         distance(*found_number, *number, tolerance));
    }
    if (agrees_exactly(found, expected)) return std::nullopt;
    return fmt::format("{}, expected {}", text_of(found), text_of(expected));
  }

  std::optional<std::string> table_difference(const std::vector<Column>& found) const {
    if (found.size() != expectation_.columns.size()) {
      return fmt::format("{} columns, expected {}", found.size(), expectation_.columns.size());
    }
    for (const auto& [name, expected] : expectation_.columns) {
      const auto same_name = std::ranges::find(found, name, &Column::name);
      if (same_name == found.end())
        return fmt::format("no column '{}': there are {}", name,
                           fmt::join(found | std::views::transform(&Column::name), ", "));
      const Column& column = *same_name;
      if (column.si.size() != expected.size()) {
        return fmt::format("column {} has {} rows, expected {}", column.name, column.si.size(), expected.size());
      }
      double largest = 0, found_largest = 0;
      for (double number : expected) largest = std::max(largest, std::abs(number));
      for (double number : column.si) found_largest = std::max(found_largest, std::abs(number));
      const double tolerance = tolerance_at(largest, found_largest, column.unit);
      for (std::size_t row = 0; row < expected.size(); ++row) {
        if (within(column.si[row], expected[row], tolerance)) continue;
        return fmt::format("column {}, row {}: {}, expected {}{}", column.name, row + 1,
                           rounded(column.si[row], digits), rounded(expected[row], digits),
                           distance(column.si[row], expected[row], tolerance));
      }
    }
    return std::nullopt;
  }

 private:
  // largest, found: of what is expected and of what was found.
  double tolerance_at(double largest, double found, const std::string& unit) const {
    const double others = largest > 0 ? 0 : largest_in_unit(solution_, unit);
    const double scale = largest > 0 ? largest : others > found ? others : scale_of_zero;
    return expectation_.relative_tolerance * scale + expectation_.absolute_tolerance;
  }

  // Returns false for NaN.
  static bool within(double found, double expected, double tolerance) {
    return std::abs(found - expected) <= tolerance;
  }

  static std::string distance(double found, double expected, double tolerance) {
    return fmt::format(" (off by {}, allowed {})", rounded(std::abs(found - expected), 2), rounded(tolerance, 2));
  }

  static bool agrees_exactly(const Datum& found, const Datum& expected) {
    if (const auto* truth = std::get_if<bool>(&expected.content)) {
      const auto* found_truth = std::get_if<bool>(&found.content);
      return found_truth != nullptr && *found_truth == *truth;
    }
    if (const auto* text = std::get_if<std::string>(&expected.content)) {
      const auto* found_text = std::get_if<std::string>(&found.content);
      return found_text != nullptr && *found_text == *text;
    }
    return false;
  }

  std::optional<std::string> list_difference(const Datum& found, const List& found_list, const Datum& expected,
                                             const List& expected_list) const {
    const std::string both = fmt::format("{}, expected {}", text_of(found), text_of(expected));
    if (found_list.size() != expected_list.size()) return both;
    if (const std::optional<std::multiset<std::string>> names = texts_of(expected_list)) {
      return texts_of(found_list) == names ? std::nullopt : std::optional(both);
    }
    double largest = 0;
    for (const Datum& item : expected_list) largest = std::max(largest, magnitude(item));
    const double tolerance = tolerance_at(largest, largest_magnitude(found), unit_);
    for (std::size_t i = 0; i < expected_list.size(); ++i) {
      const auto* number = std::get_if<double>(&expected_list[i].content);
      const auto* found_number = std::get_if<double>(&found_list[i].content);
      if (number != nullptr && found_number != nullptr) {
        if (within(*found_number, *number, tolerance)) continue;
        return both + distance(*found_number, *number, tolerance);
      }
      if (difference(found_list[i], expected_list[i])) return both;
    }
    return std::nullopt;
  }

  // The texts of a list that consists of texts only.
  static std::optional<std::multiset<std::string>> texts_of(const List& list) {
    std::multiset<std::string> texts;
    for (const Datum& item : list) {
      const auto* text = std::get_if<std::string>(&item.content);
      if (text == nullptr) return std::nullopt;
      texts.insert(*text);
    }
    return texts;
  }

  const Expectation& expectation_;
  const Solution& solution_;
  std::string unit_;
};

const Answer* find_answer(const Solution& solution, const std::string& name) {
  const auto found = std::ranges::find(solution.answers, name, &Answer::name);
  return found == solution.answers.end() ? nullptr : &*found;
}

// If there is nothing to compare, the reason.
std::optional<std::string> missing(const Answer* answer) {
  if (answer == nullptr) return "the file does not ask for it";
  switch (answer->state) {
    case AnswerState::found:
      return std::nullopt;
    case AnswerState::needs_letters:
      return fmt::format("needs values for {}", fmt::join(answer->letters, ", "));
    case AnswerState::undetermined:
      return "not determined: " + answer->reason;
    case AnswerState::refused:
      return "refused: " + answer->reason;
  }
  return std::nullopt;
}

std::optional<std::string> answer_shortfall(const Solution& solution, const Expectation& expectation) {
  const Answer* answer = find_answer(solution, expectation.part);
  if (std::optional<std::string> why = missing(answer)) return why;
  const Comparison comparison(expectation, solution, answer->unit);
  if (!expectation.columns.empty()) return comparison.table_difference(answer->columns);
  if (!answer->columns.empty()) return fmt::format("a table, expected {}", text_of(expectation.si));
  // A single name may be given as such or as a list of one.
  const auto* names = std::get_if<List>(&expectation.si.content);
  if (names != nullptr && names->size() == 1 && std::holds_alternative<std::string>(si_of(*answer).content))
    return comparison.difference(si_of(*answer), names->front());
  return comparison.difference(si_of(*answer), expectation.si);
}

// Compares the numbers found in all solutions with those expected, both in ascending order, each relative to its own
// magnitude.
std::optional<std::string> root_shortfall(const Document& document, const Expectation& expectation) {
  List roots;
  for (const Solution& solution : document.solutions) {
    const Answer* answer = find_answer(solution, expectation.part);
    if (std::optional<std::string> why = missing(answer)) return why;
    roots.push_back(si_of(*answer));
  }
  Datum expected = expectation.si;
  auto* expected_roots = std::get_if<List>(&expected.content);
  if (expected_roots == nullptr) return "the expected roots must be a list, not " + text_of(expected);
  const auto number_of = [](const Datum& datum) {
    const auto* number = std::get_if<double>(&datum.content);
    return number == nullptr ? 0 : *number;
  };
  std::ranges::sort(roots, {}, number_of);
  std::ranges::sort(*expected_roots, {}, number_of);
  if (roots.size() != expected_roots->size()) {
    return fmt::format("roots {}, expected {}", text_of(Datum{roots}), text_of(expected));
  }
  const Solution& first = document.solutions.front();
  const Comparison comparison(expectation, first, find_answer(first, expectation.part)->unit);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (const auto why = comparison.difference(roots[i], (*expected_roots)[i])) return "root " + *why;
  }
  return std::nullopt;
}

}  // namespace

bool expects_no_solution(const std::vector<Expectation>& expectations) {
  return !expectations.empty() && std::ranges::all_of(expectations, [](const Expectation& expectation) {
    const auto* roots = std::get_if<List>(&expectation.si.content);
    return expectation.roots && roots != nullptr && roots->empty();
  });
}

std::vector<std::string> shortfalls(const Document& document, const std::vector<Expectation>& expectations) {
  std::vector<std::string> lines;
  if (document.solutions.empty()) {
    if (!expects_no_solution(expectations)) lines.push_back("no solution");
    return lines;
  }
  for (const Expectation& expectation : expectations) {
    if (expectation.roots) {
      if (const auto why = root_shortfall(document, expectation)) lines.push_back(expectation.part + ": " + *why);
      continue;
    }
    for (std::size_t i = 0; i < document.solutions.size(); ++i) {
      const auto why = answer_shortfall(document.solutions[i], expectation);
      if (!why) continue;
      const std::string where = document.solutions.size() > 1 ? fmt::format(" (solution {})", i + 1) : "";
      lines.push_back(fmt::format("{}{}: {}", expectation.part, where, *why));
    }
  }
  for (const Answer& answer : document.solutions.front().answers) {
    if (std::ranges::find(expectations, answer.name, &Expectation::part) == expectations.end()) {
      lines.push_back(answer.name + ": no answer is expected");
    }
  }
  return lines;
}

}  // namespace poinsot::document
