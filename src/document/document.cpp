#include "poinsot/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace poinsot {
namespace {

void require_finite(double number, const std::string& place) {
  if (std::isfinite(number)) return;
  throw std::domain_error(
      fmt::format("{} has {} in place of a number", place, std::isnan(number) ? "NaN" : "infinity"));
}

void require_finite(const Datum& datum, const std::string& place) {
  if (const auto* number = std::get_if<double>(&datum.content)) require_finite(*number, place);
  if (const auto* list = std::get_if<std::vector<Datum>>(&datum.content)) {
    for (const Datum& item : *list) require_finite(item, place);
  }
}

void require_value(const Datum& value, const Datum& si, const std::string& place) {
  if (value.empty()) throw std::domain_error(place + " has no value");
  require_finite(value, place);
  require_finite(si, place);
}

void require_value(const Answer& answer) {
  const std::string place = "the answer to '" + answer.name + "'";
  if (answer.columns.empty()) return require_value(answer.value, answer.si, place);
  for (const Column& column : answer.columns) {
    for (const std::vector<double>* numbers : {&column.value, &column.si}) {
      for (double number : *numbers) require_finite(number, place + " (column " + column.name + ")");
    }
  }
}

}  // namespace

bool fully_answered(const Document& document) {
  return !document.solutions.empty() && std::ranges::all_of(document.solutions, [](const Solution& solution) {
    return std::ranges::all_of(solution.answers, [](const Answer& answer) {
      return answer.state == AnswerState::found ||
             (answer.state == AnswerState::needs_letters && !answer.formula.empty());
    });
  });
}

void require_values(const Document& document) {
  for (const Solution& solution : document.solutions) {
    for (const Unknown& unknown : solution.unknowns) {
      if (unknown.value.empty() && !unknown.formula.empty()) continue;
      require_value(unknown.value, unknown.si, "the unknown '" + unknown.name + "'");
    }
    for (const Answer& answer : solution.answers) {
      if (answer.state == AnswerState::found) require_value(answer);
    }
  }
}

}  // namespace poinsot
