#include "document/statement_document.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "document/named_constants.h"
#include "problem/formulas/formula_words.h"
#include "problem/language/unit_table.h"
#include "problem/machine/data.h"
#include "problem/plane/planar_words.h"

namespace poinsot::document {

using problem::formula_words;
using problem::Value;

Datum datum(const Value<double>& value, double factor) {
  if (value.is_number()) return {value.number / factor};
  if (value.is_boolean()) return {value.truth};
  if (value.is_text()) return {value.text};
  std::vector<Datum> items;
  if (value.is_vector())
    for (std::size_t k = 0; k < 3; ++k) items.push_back({value.vector[k] / factor});
  for (const Value<double>& item : value.items) items.push_back(datum(item, factor));
  return {std::move(items)};
}

namespace {

Datum formula_datum(const Value<Formula>& value) {
  if (value.is_number()) return {formula_words(value.number)};
  std::vector<Datum> items;
  if (value.is_vector())
    for (std::size_t k = 0; k < 3; ++k) items.push_back({formula_words(value.vector[k])});
  for (const Value<Formula>& item : value.items) items.push_back(formula_datum(item));
  return {std::move(items)};
}

Answer answer_of(const problem::Claim& stated, const problem::SolvedClaim& solved) {
  Answer answer;
  answer.name = stated.name;
  answer.ask = stated.text;
  answer.reason = solved.reason;
  if (solved.state != problem::AskState::found) {
    answer.state = AnswerState::undetermined;
    return answer;
  }
  answer.value = {solved.holds};
  answer.si = {solved.holds};
  ClaimOutcome outcome;
  outcome.holds = solved.holds;
  if (solved.holds) outcome.how = solved.proved ? "proved" : "sampled";
  for (const auto& letter : solved.counterexample)
    outcome.counterexample.push_back({letter.name, letter.value / letter.unit.factor, letter.unit.text, letter.value});
  if (solved.sides) outcome.sides = {solved.sides->first, solved.sides->second};
  outcome.difference = solved.difference;
  outcome.unit = solved.unit.text;
  outcome.assumptions = solved.assumptions;
  answer.claim = std::move(outcome);
  return answer;
}

Column shown_column(const problem::SolvedColumn& column) {
  Column shown{column.name, column.unit.text, {}, column.values};
  for (const double value : column.values) shown.value.push_back(value / column.unit.factor);
  return shown;
}

Solution solution_of(const problem::Statement& stated, const problem::Solution& solved) {
  Solution solution;
  for (const problem::SolvedUnknown& unknown : solved.unknowns) {
    if (solved.refused) break;
    const auto& plane = stated.situations.front().plane;
    if (unknown.formula) {
      solution.unknowns.push_back(
          {unknown.name, {}, unknown.unit.text, {}, formula_datum(told_in_plane(*unknown.formula, plane))});
      continue;
    }
    const auto value = told_in_plane(unknown.value, plane);
    solution.unknowns.push_back({unknown.name, datum(value, unknown.unit.factor), unknown.unit.text, datum(value, 1)});
  }
  for (std::size_t i = 0; i < stated.asks.size(); ++i) {
    const problem::SolvedAsk& found = solved.asks[i];
    Answer answer;
    answer.name = stated.asks[i].name;
    answer.ask = stated.asks[i].text;
    answer.words = found.words;
    answer.unit = found.unit.text;
    answer.reason = found.reason;
    answer.letters = found.letters;
    answer.component_names = found.component_names;
    switch (found.state) {
      case problem::AskState::found:
        answer.state = AnswerState::found;
        for (const problem::SolvedColumn& column : found.columns) answer.columns.push_back(shown_column(column));
        if (found.over) answer.over = shown_column(*found.over);
        if (!found.columns.empty()) break;
        answer.value = datum(found.value, found.unit.factor);
        answer.si = datum(found.value, 1);
        break;
      case problem::AskState::needs_letters:
        answer.state = AnswerState::needs_letters;
        // Of a table in letters the heads of its columns, whose rows are lists of formulas.
        if (found.formula)
          for (const problem::SolvedColumn& column : found.columns) answer.columns.push_back({column.name, {}, {}, {}});
        break;
      case problem::AskState::undetermined:
        answer.state = AnswerState::undetermined;
        break;
      case problem::AskState::refused:
        answer.state = AnswerState::refused;
        break;
    }
    // An unknown that is asked for has its formula already: a long one takes seconds to write.
    const auto same_unknown = std::ranges::find_if(solved.unknowns, [&](const problem::SolvedUnknown& unknown) {
      return found.formula && unknown.formula && found.formula->is_number() && unknown.formula->is_number() &&
             found.formula->number == unknown.formula->number;
    });
    if (same_unknown != solved.unknowns.end() && !solved.refused)
      answer.formula = solution.unknowns[static_cast<std::size_t>(same_unknown - solved.unknowns.begin())].formula;
    else if (found.formula)
      answer.formula = formula_datum(*found.formula);
    answer.no_formula = found.no_formula;
    for (const problem::RegimeFormula& one : found.regimes)
      answer.formulas.push_back({formula_datum(one.formula), one.where});
    solution.answers.push_back(std::move(answer));
  }
  for (std::size_t i = 0; i < solved.claims.size(); ++i)
    solution.answers.push_back(answer_of(stated.claims[i], solved.claims[i]));
  solution.checks = solved.checks;
  solution.assumptions = solved.assumptions;
  for (const problem::FormulaCondition& condition : solved.conditions)
    solution.conditions.push_back({condition.words, formula_words(condition.positive) + " > 0"});
  // How a motion was followed up to a time, and beyond it, begins in the same way: what tells more is enough.
  for (const std::string& note : solved.notes)
    if (std::ranges::none_of(solved.notes, [&](const std::string& other) { return other.starts_with(note + ", "); }))
      solution.notes.push_back(note);
  return solution;
}

// Standard gravity, unless the statement calls something else g.
std::vector<Constant> constants_of(const problem::Statement& stated) {
  for (const problem::Situation& situation : stated.situations) {
    const std::vector<std::string> names = problem::settable_names(situation);
    if (std::ranges::find(names, "g") != names.end()) return {};
  }
  return {{"g", std::string(problem::standard_gravity_digits), "m/s^2"}};
}

}  // namespace

Document document_of(const problem::Statement& stated, const problem::SolvedStatement& solved) {
  Document document;
  document.file = stated.file;
  document.title = stated.title;
  for (const problem::Letter& letter : solved.open_letters)
    document.open_letters.push_back({letter.name, letter.unit.text});
  for (const problem::Solution& root : solved.solutions) document.solutions.push_back(solution_of(stated, root));
  document.constants = constants_in(document.solutions, constants_of(stated));
  document.warnings = solved.warnings;
  document.ended = solved.ended;
  return document;
}

}  // namespace poinsot::document
