#include "problem/unknowns/situated.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/quantities/asks_model.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {
namespace {

// Removes `@ situation` from an expression and records the situations named there.
class SituationsTakenOff {
 public:
  explicit SituationsTakenOff(const Statement& statement) : statement_(statement) {}

  Expression operator()(const Expression& expression) {
    if (const At* at = expression.as<At>())
      if (const std::optional<std::size_t> situation = named(at->instant)) {
        if (found_ && *found_ != *situation)
          fail(statement_.file, at->instant_mark,
               "'@ " + at->instant + "' is another situation than '@ " + statement_.situations[*found_].name +
                   "': times are asked of the motion of one",
               "ask for each by itself");
        found_ = situation;
        return (*this)(at->expression);
      }
    return transformed(expression, [this](const Expression& part) { return (*this)(part); });
  }
  const std::optional<std::size_t>& found() const { return found_; }

 private:
  std::optional<std::size_t> named(const std::string& name) const {
    for (std::size_t i = 0; i < statement_.situations.size(); ++i)
      if (statement_.situations[i].name == name) return i;
    return std::nullopt;
  }

  const Statement& statement_;
  std::optional<std::size_t> found_;
};

bool names(const Expression& expression, const std::string& situation) {
  const At* at = expression.as<At>();
  return (at && !at->names.empty() && at->names.front() == situation) ||
         any_child(expression, [&](const Expression& part) { return names(part, situation); });
}

}  // namespace

bool names_situation(const Ask& ask, const std::string& situation) {
  std::vector<Expression> asked = ask.of;
  if (ask.when) asked.push_back(ask.when->condition);
  if (ask.table)
    for (const NamedExpression& column : ask.table->columns) asked.push_back(column.value);
  return std::ranges::any_of(asked, [&](const Expression& expression) { return names(expression, situation); });
}

Situated situated(const Statement& statement, const Expression& expression) {
  if (statement.situations.size() == 1) return {0, expression};
  SituationsTakenOff taken_off(statement);
  Situated result{0, taken_off(expression)};
  if (taken_off.found() && !asks_model(statement.situations.front(), expression, false)) {
    result.situation = *taken_off.found();
    return result;
  }
  const std::string names = joined(names_of(statement.situations));
  const std::string& one = statement.situations[taken_off.found().value_or(0)].name;
  fail(statement.file, beginning(expression), "in which situation is '" + to_string(expression) + "' asked?",
       "write @ " + one + " behind each quantity, as in theta @ " + one + " (the situations are " + names + ")");
}

Statement for_questions(const Statement& statement) {
  Statement result = statement;
  std::erase_if(result.situations, [&](const Situation& situation) {
    const bool claimed = std::any_of(statement.claims.begin(), statement.claims.end(),
                                     [&](const Claim& claim) { return claim.situation == situation.name; });
    return claimed && !situation.name.empty() &&
           std::none_of(statement.asks.begin(), statement.asks.end(), [&](const Ask& ask) {
             return ask.table || ask.when || (ask.extremum && ask.extremum->situation == situation.name) ||
                    names_situation(ask, situation.name);
           });
  });
  return result.situations.empty() ? statement : result;
}

}  // namespace poinsot::problem
