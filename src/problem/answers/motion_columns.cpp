#include "problem/answers/motion_columns.h"

#include "poinsot/engine/work/budget.h"
#include "problem/answers/contact_states.h"
#include "problem/answers/read_settings.h"
#include "problem/answers/solve_statement.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"

namespace poinsot::problem {

std::string in_seconds(double time) { return with_digits(time, 17) + " s"; }

SolvedStatement solve_columns(const Statement& statement, const SettingTexts& sets, const MotionColumns& columns,
                              const std::vector<double>& times) {
  const Record& record = columns.record;
  Statement trial = statement;
  trial.expected.clear();
  Ask ask;
  ask.name = ask.text = "record";
  ask.mark = record.mark;
  ask.axes = record.axes;
  ask.table.emplace();
  ask.table->columns = record.columns;
  ask.table->units = record.units;
  ask.table->over = "time";
  ask.table->over_mark = record.mark;
  List values;
  for (const double time : times)
    values.items.push_back(built(Number{time, si_unit(dimensions::time), true, in_seconds(time)}, record.mark));
  ask.table->values = built(std::move(values), record.mark);
  trial.asks = {std::move(ask)};
  SolvedStatement solved = solve_statement(trial, sets);
  check_budget();  // What the end of a budget left open is not without an answer.
  const auto unanswered = [&](const std::string& why) {
    throw UnansweredRecord(statement.file + ": " + columns.words + " has no answer: " + why);
  };
  std::string warnings;
  for (const std::string& warning : solved.warnings) warnings += (warnings.empty() ? "" : "; ") + warning;
  if (solved.solutions.empty()) unanswered("there is no solution" + (warnings.empty() ? "" : ": " + warnings));
  if (solved.solutions.size() > 1)
    unanswered("there are " + std::to_string(solved.solutions.size()) +
               " solutions: tell by where:, or by --set, which one is meant");
  const SolvedAsk& found = solved.solutions.front().asks.front();
  if (found.state != AskState::found) unanswered(found.reason);
  return solved;
}

Settings settled(const Statement& statement, const SettingTexts& sets, const MotionColumns& columns) {
  Settings settings = read_settings(statement, sets);
  const Situation& situation = statement.situations.front();
  std::vector<std::string> letters;
  for (const Letter& letter : situation.letters)
    if (!settings.contains(letter.name)) letters.push_back(letter.name);
  if (!letters.empty())
    throw UnansweredRecord(statement.file + ": " + columns.words + " needs values for " + joined(letters) +
                           ": --set '" + letters.front() + "=...'");
  if (!situation.find.empty() || !situation.choose.empty()) {
    const SolvedStatement solved = solve_columns(statement, sets, columns, {0});
    for (const SolvedUnknown& unknown : solved.solutions.front().unknowns)
      settings.insert_or_assign(unknown.name, unknown.value);
  }
  return settings;
}

Statement in_states_at_start(const Statement& statement, const SettingTexts& sets, const MotionColumns& columns) {
  if (!has_open_contact_states(statement)) return statement;
  return in_contact_states(statement, solve_columns(statement, sets, columns, {0}).solutions.front().contact_states);
}

}  // namespace poinsot::problem
