#include "document/run.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "document/check.h"
#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/answers/solve_statement.h"
#include "problem/entries/keys.h"
#include "problem/explanation/explanation.h"
#include "problem/language/tree.h"

namespace poinsot::document {
namespace {

namespace fs = std::filesystem;
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

Datum formula_datum(const Value<Formula>& value) {
  if (value.is_number()) return {text(value.number)};
  std::vector<Datum> items;
  if (value.is_vector())
    for (std::size_t k = 0; k < 3; ++k) items.push_back({text(value.vector[k])});
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

Solution solution_of(const problem::Statement& stated, const problem::Solution& solved) {
  Solution solution;
  for (const problem::SolvedUnknown& unknown : solved.unknowns) {
    if (unknown.formula)
      solution.unknowns.push_back({unknown.name, {}, unknown.unit.text, {}, formula_datum(*unknown.formula)});
    else
      solution.unknowns.push_back(
          {unknown.name, datum(unknown.value, unknown.unit.factor), unknown.unit.text, datum(unknown.value, 1)});
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
        for (const problem::SolvedColumn& column : found.columns) {
          Column shown{column.name, column.unit.text, {}, column.values};
          for (double value : column.values) shown.value.push_back(value / column.unit.factor);
          answer.columns.push_back(std::move(shown));
        }
        if (!found.columns.empty()) break;
        answer.value = datum(found.value, found.unit.factor);
        answer.si = datum(found.value, 1);
        break;
      case problem::AskState::needs_letters:
        answer.state = AnswerState::needs_letters;
        break;
      case problem::AskState::undetermined:
        answer.state = AnswerState::undetermined;
        break;
      case problem::AskState::refused:
        answer.state = AnswerState::refused;
        break;
    }
    if (found.formula) answer.formula = formula_datum(*found.formula);
    answer.no_formula = found.no_formula;
    solution.answers.push_back(std::move(answer));
  }
  for (std::size_t i = 0; i < solved.claims.size(); ++i)
    solution.answers.push_back(answer_of(stated.claims[i], solved.claims[i]));
  solution.checks = solved.checks;
  solution.assumptions = solved.assumptions;
  for (const problem::FormulaCondition& condition : solved.conditions)
    solution.conditions.push_back({condition.words, text(condition.positive) + " > 0"});
  solution.notes = solved.notes;
  return solution;
}

Document document_of(const problem::Statement& stated, const problem::SolvedStatement& solved) {
  Document document;
  document.file = stated.file;
  document.title = stated.title;
  for (const problem::Letter& letter : solved.open_letters)
    document.open_letters.push_back({letter.name, letter.unit.text});
  for (const problem::Solution& root : solved.solutions) document.solutions.push_back(solution_of(stated, root));
  document.warnings = solved.warnings;
  return document;
}

// What one part should be, in SI.
Expectation expectation(const problem::Expected& expected, const problem::Situation& problem,
                        const problem::Settings& settings) {
  Expectation result;
  result.part = expected.part;
  result.relative_tolerance = expected.relative_tolerance;
  for (const problem::NamedExpression& column : expected.columns) {
    problem::DataScope<double> data(problem, settings);
    result.columns.emplace_back();
    for (const problem::Expression& item : column.value.as<problem::List>()->items)
      result.columns.back().push_back(data.value(item).number);
  }
  if (!expected.columns.empty()) return result;
  if (expected.names) {
    std::vector<Datum> names;
    for (const std::string& name : *expected.names) names.push_back({name});
    result.si = {std::move(names)};
  } else if (expected.holds) {
    result.si = {*expected.holds};
  } else {
    problem::DataScope<double> data(problem, settings);
    const Value<double> value = data.value(expected.value ? *expected.value : *expected.formula);
    // A value stands in the unit named; a formula has the dimension of its letters.
    const double factor = expected.value && expected.unit ? 1 / expected.unit->factor : 1;
    result.si = datum(value, factor);
    result.roots = expected.roots;
    result.absolute_tolerance = expected.absolute_tolerance * (expected.unit ? expected.unit->factor : 1);
  }
  return result;
}

// The dimension of a value, of its first number that is not zero; nothing for texts, truth values and bare zeros.
std::optional<problem::Dimension> dimension_of(const Value<double>& value) {
  if (value.is_number() || value.is_vector()) {
    if (value.bare && value.dimension == problem::dimensions::none) return std::nullopt;
    return value.dimension;
  }
  for (const Value<double>& item : value.items)
    if (const auto found = dimension_of(item)) return found;
  return std::nullopt;
}

// What an expectation says of the kind of quantity, if it is another than the answer's.
std::string wrong_kind(const problem::Expected& expected, const problem::Situation& problem,
                       const problem::Settings& settings, const problem::Dimension& answer) {
  std::optional<problem::Dimension> stated;
  if (expected.value && expected.unit) stated = expected.unit->dimension;
  if (expected.formula) stated = dimension_of(problem::DataScope<double>(problem, settings).value(*expected.formula));
  if (!stated || same_kind(*stated, answer)) return "";
  return expected.part + ": expected " + to_string(*stated) + ", but the answer is " + to_string(answer);
}

std::vector<std::string> check_file(const std::string& path) {
  const problem::Statement stated = problem::read_statement(problem::read_file(path), path);
  if (!stated.expects) return {"it has no expect block"};
  std::vector<std::string> failures;
  std::set<std::string> covered;
  for (const problem::ExpectedCase& one : stated.expected) {
    const problem::SolvedStatement solved = problem::solve_statement(stated, one.sets);
    const Document document = document_of(stated, solved);
    const problem::Settings settings = problem::read_settings(stated, one.sets);
    std::vector<Expectation> expectations;
    for (const problem::Expected& part : one.parts) {
      const problem::Situation& problem = stated.situations.front();
      expectations.push_back(expectation(part, problem, settings));
      covered.insert(part.part);
      for (std::size_t i = 0; i < stated.asks.size() && !solved.solutions.empty(); ++i) {
        const problem::SolvedAsk& ask = solved.solutions.front().asks[i];
        if (stated.asks[i].name != part.part || stated.asks[i].table || ask.state != problem::AskState::found) continue;
        const auto answer = dimension_of(ask.value);
        const std::string fault = answer ? wrong_kind(part, problem, settings, *answer) : "";
        if (!fault.empty()) failures.push_back(fault);
      }
    }
    // A case may look at some of the parts; together the cases must look at all.
    Document seen = document;
    for (Solution& solution : seen.solutions)
      std::erase_if(solution.answers, [&](const Answer& answer) {
        return std::none_of(expectations.begin(), expectations.end(),
                            [&](const Expectation& e) { return e.part == answer.name; });
      });
    for (const std::string& failure : shortfalls(seen, expectations))
      failures.push_back(one.name.empty() ? failure : "case " + one.name + ": " + failure);
  }
  for (const problem::Ask& ask : stated.asks)
    if (!covered.contains(ask.name)) failures.push_back(ask.name + ": the expect block leaves it out");
  for (const problem::Claim& claim : stated.claims)
    if (!covered.contains(claim.name)) failures.push_back(claim.name + ": the expect block leaves it out");
  return failures;
}

}  // namespace

Document run_file(const std::string& path, const RunOptions& options) {
  const problem::Statement stated = problem::read_statement(problem::read_file(path), path);
  const problem::SolvedStatement solved = problem::solve_statement(stated, options.sets, options.explain);
  Document document = document_of(stated, solved);
  for (std::size_t i = 0; options.explain && i < document.solutions.size(); ++i)
    document.solutions[i].explanation = problem::explain(stated, options.sets, solved, i);
  return document;
}

std::vector<CheckResult> check_paths(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      files.push_back(path);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file() && entry.path().extension() == ".yaml") found.push_back(entry.path().string());
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  std::vector<CheckResult> results;
  for (const std::string& file : files) {
    try {
      results.push_back({file, check_file(file)});
    } catch (const problem::StatementError& error) {
      if (!fs::exists(file)) throw;
      results.push_back({file, {error.what()}});
    }
  }
  return results;
}

std::string problem_schema() { return problem::problem_schema(); }

}  // namespace poinsot::document
