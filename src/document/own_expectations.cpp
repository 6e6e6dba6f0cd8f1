#include "document/own_expectations.h"

#include <algorithm>
#include <optional>
#include <set>

#include "document/check.h"
#include "document/statement_document.h"
#include "poinsot/engine/work/budget.h"
#include "problem/answers/contact_states.h"
#include "problem/answers/read_settings.h"
#include "problem/answers/solve_statement.h"
#include "problem/plane/planar_words.h"

namespace poinsot::document {
namespace {

using problem::Value;

// What an answer or a part of it should be, in SI units.
Expectation expectation(const problem::Expected& expected, const problem::Situation& situation,
                        const problem::Settings& settings) {
  Expectation result;
  result.part = expected.part;
  result.relative_tolerance = expected.relative_tolerance;
  for (const problem::NamedExpression& column : expected.columns) {
    problem::DataScope<double> data(situation, settings);
    result.columns.push_back({column.name, {}});
    for (const problem::Expression& item : column.value.as<problem::List>()->items)
      result.columns.back().si.push_back(data.value(item).number);
  }
  if (!expected.columns.empty()) return result;
  if (expected.names) {
    std::vector<Datum> names;
    for (const std::string& name : *expected.names) names.push_back({name});
    result.si = {std::move(names)};
  } else if (expected.holds) {
    result.si = {*expected.holds};
  } else {
    problem::DataScope<double> data(situation, settings);
    const problem::Expression& stated = expected.value ? *expected.value : *expected.formula;
    Value<double> value = data.value(stated);
    // A vector that is calculated in a planar problem has the components that answers have.
    if (!stated.as<problem::List>()) value = told_in_plane(value, situation.plane);
    // A value is in the named unit; a formula has the dimension of its letters.
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

// Describes it if an expectation is for another kind of quantity than the answer.
std::string wrong_kind(const problem::Expected& expected, const problem::Situation& situation,
                       const problem::Settings& settings, const problem::Dimension& answer) {
  std::optional<problem::Dimension> stated;
  if (expected.value && expected.unit) stated = expected.unit->dimension;
  if (expected.formula) stated = dimension_of(problem::DataScope<double>(situation, settings).value(*expected.formula));
  if (!stated || same_kind(*stated, answer)) return "";
  return expected.part + ": expected " + to_string(*stated) + ", but the answer is " + to_string(answer);
}

// Nothing where it is expected that nothing solves it, and no state of the contacts holds.
std::optional<problem::SolvedStatement> solved(const problem::Statement& stated, const problem::ExpectedCase& one,
                                               bool none_expected) try {
  problem::SolvedStatement found = problem::solve_statement(stated, one.sets);
  if (found.ended) throw BudgetEnded{*found.ended};
  return found;
} catch (const problem::NoStateError&) {
  if (none_expected) return std::nullopt;
  throw;
}

}  // namespace

std::vector<std::string> own_shortfalls(const problem::Statement& stated) {
  if (!stated.expects) return {"it has no expect block"};
  std::vector<std::string> failures;
  std::set<std::string> covered;
  for (const problem::ExpectedCase& one : stated.expected) {
    const problem::Settings settings = problem::read_settings(stated, one.sets);
    const problem::Situation& situation = stated.situations.front();
    std::vector<Expectation> expectations;
    for (const problem::Expected& part : one.parts) {
      expectations.push_back(expectation(part, situation, settings));
      covered.insert(part.part);
    }
    const std::optional<problem::SolvedStatement> found = solved(stated, one, expects_no_solution(expectations));
    if (!found) continue;
    const Document document = document_of(stated, *found);
    for (const problem::Expected& part : one.parts) {
      for (std::size_t i = 0; i < stated.asks.size() && !found->solutions.empty(); ++i) {
        const problem::SolvedAsk& ask = found->solutions.front().asks[i];
        if (stated.asks[i].name != part.part || stated.asks[i].table || ask.state != problem::AskState::found) continue;
        const auto answer = dimension_of(ask.value);
        const std::string fault = answer ? wrong_kind(part, situation, settings, *answer) : "";
        if (!fault.empty()) failures.push_back(fault);
      }
    }
    // A case may concern some of the parts; the cases together must concern all.
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

}  // namespace poinsot::document
