#include "document/named_constants.h"

#include <algorithm>

namespace poinsot::document {
namespace {

bool belongs_to_number(char c) { return (c >= '0' && c <= '9') || c == '.'; }

// The place of a number in a text from a place on; npos if it does not stand there by itself.
std::size_t place_of(const std::string& digits, const std::string& text, std::size_t from) {
  for (std::size_t at = text.find(digits, from); at != std::string::npos; at = text.find(digits, at + 1)) {
    const std::size_t end = at + digits.size();
    const bool alone = (at == 0 || !belongs_to_number(text[at - 1])) &&
                       (end == text.size() || (!belongs_to_number(text[end]) && text[end] != 'e'));
    if (alone) return at;
  }
  return std::string::npos;
}

template <class Visit>
void for_each_text(Datum& datum, const Visit& visit) {
  if (auto* text = std::get_if<std::string>(&datum.content)) visit(*text);
  if (auto* list = std::get_if<std::vector<Datum>>(&datum.content))
    for (Datum& item : *list) for_each_text(item, visit);
}

// Visits every text of a solution that is, or holds, a formula in numbers of SI units.
template <class Visit>
void for_each_formula(Solution& solution, const Visit& visit) {
  for (Unknown& unknown : solution.unknowns) for_each_text(unknown.formula, visit);
  for (Answer& answer : solution.answers) {
    for_each_text(answer.formula, visit);
    for (FormulaWhere& one : answer.formulas) {
      for_each_text(one.formula, visit);
      for (std::string& words : one.where) visit(words);
    }
  }
  for (std::string& assumption : solution.assumptions) visit(assumption);
  for (Condition& condition : solution.conditions) {
    visit(condition.words);
    visit(condition.formula);
  }
}

}  // namespace

std::vector<Constant> constants_in(const std::vector<Solution>& solutions, const std::vector<Constant>& constants) {
  std::vector<Constant> found;
  for (const Constant& constant : constants) {
    bool stands = false;
    for (Solution solution : solutions)
      for_each_formula(solution, [&](const std::string& text) {
        stands = stands || place_of(constant.digits, text, 0) != std::string::npos;
      });
    if (stands) found.push_back(constant);
  }
  return found;
}

Document with_named_constants(Document document) {
  for (Solution& solution : document.solutions) {
    std::vector<std::string> values;
    for (const Constant& constant : constants_in({solution}, document.constants)) {
      for_each_formula(solution, [&](std::string& text) {
        for (std::size_t at = place_of(constant.digits, text, 0); at != std::string::npos;
             at = place_of(constant.digits, text, at + 1))
          text.replace(at, constant.digits.size(), constant.name);
      });
      values.push_back(constant.name + " = " + constant.digits + " " + constant.unit);
    }
    solution.assumptions.insert(solution.assumptions.begin(), values.begin(), values.end());
  }
  return document;
}

}  // namespace poinsot::document
