#include "problem/unknowns/sample.h"

#include <cmath>
#include <cstdio>

#include "problem/unknowns/unknown_search.h"

namespace poinsot::problem {

SolvedInstant& Sample::instant(const Home& home) {
  if (const auto known = instants_.find(home); known != instants_.end()) return *known->second;
  std::unique_ptr<SolvedInstant> found;
  const Situation& situation = statement_.situations[home.situation];
  const Settings& settings = settings_[home.situation];
  const auto in_motion = [&](auto&& state_in) {
    Course& moving = motion(home.situation);
    const MotionState state = state_in(moving);
    found = std::make_unique<SolvedInstant>(moving.situation(), settings, state, choice_);
  };
  const std::size_t stage = home.instant - (situation.has_blow() && home.instant > 0 ? 1 : 0);
  if (home.ending)
    in_motion([&](Course& moving) { return moving.end_of(home.instant); });
  else if (home.time)
    in_motion([&](Course& moving) { return moving.at(*home.time); });
  else if (stage > 0)
    in_motion([&](Course& moving) { return moving.at(moving.stage_start(stage)); });
  else
    found = std::make_unique<SolvedInstant>(situation, settings, When{0, situation.has_blow() && home.instant == 1},
                                            choice_);
  found->set_motion([this, situation_index = home.situation](const Call& call, const std::optional<Expression>& axes,
                                                             const Mark& mark) {
    return motion(situation_index).feature(call, axes, mark);
  });
  return *(instants_[home] = std::move(found));
}

std::optional<Sample::Home> Sample::resolve_in(std::size_t i, const std::string& name, const Mark& mark,
                                               std::vector<std::string>& known, const std::string& prefix) {
  const Situation& situation = statement_.situations[i];
  if (situation.has_blow()) {
    if (name == "before") return Home{i, 0, std::nullopt};
    if (name == "after") return Home{i, 1, std::nullopt};
    known.push_back(prefix + "before");
    known.push_back(prefix + "after");
  }
  for (std::size_t k = 0; k < situation.stages.size(); ++k) {
    const std::string& stage = situation.stages[k].name;
    if (name == stage || name == stage + ".start") return Home{i, k + (situation.has_blow() ? 1 : 0), std::nullopt};
    if (name == stage + ".end") {
      if (const std::optional<double> end = motion(i).stage_end(k)) return Home{i, k, end, true};
      fail(situation.file, mark, "stage '" + stage + "' has no end", "write lasts: or until:");
    }
    known.push_back(prefix + stage);
  }
  if (!name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) != 0) {
    DataScope<double> data(situation, settings_[i]);
    return Home{i, 0, data.number(parse_expression(name, situation.file, mark), dimensions::time)};
  }
  for (const Instant& instant : situation.instants) {
    if (instant.name != name) {
      if (!situation.has_blow()) known.push_back(prefix + instant.name);
      continue;
    }
    if (instant.found_when)
      return Home{i, 0, motion(i).times(*instant.found_when, std::nullopt, 0, std::nullopt).front()};
    if (!is_later(situation, instant)) return start_of(i);
  }
  if (name == "start") return start_of(i);
  DataScope<double> data(situation, settings_[i]);
  if (data.knows(name)) {
    const Value<double> value = data.value(parse_expression(name, situation.file, mark));
    if (value.is_number() && same_kind(value.dimension, dimensions::time)) return Home{i, 0, value.number};
  }
  return std::nullopt;
}

// An expression that asks for nothing of the model has the same value in every situation.
Situated Sample::situated_in(const Expression& expression, std::size_t otherwise) const {
  if (!asks_model(statement_.situations[otherwise], expression)) return {otherwise, expression};
  return situated(statement_, expression);
}

Sample::Home Sample::home_of(const Ask& ask) {
  if (ask.when) return start_of(situated(statement_, ask.when->condition).situation);
  if (ask.table) {
    const std::vector<std::string> data = settable_names(statement_.situations.front());
    const NamedExpression& front = ask.table->columns.front();
    if (std::ranges::find(data, ask.table->over) != data.end())
      return start_of(home(front.value, front.mark).situation);
    for (const NamedExpression& column : ask.table->columns)
      if (const std::size_t situation_index = situated_in(column.value, 0).situation; situation_index > 0)
        return start_of(situation_index);
    return start_of(0);
  }
  if (ask.extremum) return start_of(situation_of(statement_, ask));
  return home(ask.of.front(), ask.mark);
}

std::vector<double> Sample::times(const Ask& ask) {
  const auto [situation_index, condition] = situated(statement_, ask.when->condition);
  const Situation& situation = statement_.situations[situation_index];
  DataScope<double> data(situation, settings_[situation_index]);
  const double from = ask.when->from ? data.number(*ask.when->from, dimensions::time) : 0;
  const std::optional<double> to =
      ask.when->to ? std::optional(data.number(*ask.when->to, dimensions::time)) : std::nullopt;
  if (to && !(*to > from))
    fail(situation.file, ask.when->to->mark(), "the span ends before it begins", "write from: 0 s, to: 4 s");
  std::vector<double> found = motion(situation_index).times(condition, ask.axes, from, to);
  if (ask.when->first && found.size() > 1) found = {found.front()};
  if (ask.when->first && found.empty())
    fail(situation.file, condition.mark(), "'" + to_string(condition) + "' does not happen in this span");
  return found;
}

// Adds the columns at another value of a datum, for which the unknowns are found anew.
void Sample::add_row_over_datum(const Ask& ask, const AllSettings& settings, std::vector<Value<double>>& values) {
  const Situation& situation = statement_.situations.front();
  AllSettings all = settings;
  Settings known = settings.front();
  for (const Unknown& unknown : situation.find)
    if (unknown.name != ask.table->over) known.erase(unknown.name);
  UnknownSearch search(statement_, known);
  if (!search.unknowns().empty()) {
    const RootsFound found = search.find(known);
    if (found.roots.size() != 1)
      fail(situation.file, ask.table->over_mark,
           found.roots.empty() ? "there is no solution at a value of '" + ask.table->over + "' in this table"
                               : "there are several solutions at a value of '" + ask.table->over + "' in this table",
           "narrow the range, or tell by where: which solution is meant");
    all = found.roots.front();
  }
  Sample there(statement_, all, choice_);
  for (const NamedExpression& column : ask.table->columns) {
    Value<double> value = there.value_at(there.home(column.value, column.mark), column.value, ask.axes);
    if (!value.is_number())
      fail(situation.file, column.mark, "column '" + column.name + "' is no number",
           "ask for a component such as .x, or norm(...)");
    values.push_back(std::move(value));
  }
  there.note_unphysical(ask, settings.front().at(ask.table->over));
  unphysical_rows_.merge(there.unphysical_rows_);
}

void Sample::note_unphysical(const Ask& ask, const Value<double>& row) {
  for (const auto& [home, solved] : instants_) {
    if (!solved->forces_solved()) continue;
    const std::vector<std::string> reasons = solved->unphysical();
    if (reasons.empty()) continue;
    const Unit unit = statement_.situations[home.situation].habits.unit_for(row.dimension);
    char text[60];
    std::snprintf(text, sizeof text, "%.6g", row.number / unit.factor);
    unphysical_rows_.emplace(ask.name, reasons.front() + ", from the row " + ask.table->over + " = " + text +
                                           (unit.text.empty() ? "" : " " + unit.text) + " on");
  }
}

// Fills the table row by row: the value that the row stands for, and then every column at this value.
std::vector<Value<double>> Sample::table(const Ask& ask) {
  const Table& table = *ask.table;
  const Home first = home_of(ask);
  const Situation& situation = statement_.situations[first.situation];
  SolvedInstant& start = instant(first);
  const NamedCoordinate* coordinate = start.machine().coordinate(table.over);
  const bool over_time = table.over == "time";
  const std::vector<std::string> data_names = settable_names(situation);
  const bool over_datum = std::find(data_names.begin(), data_names.end(), table.over) != data_names.end();
  if (!over_time && !coordinate && !over_datum) {
    std::vector<std::string> known = data_names;
    known.emplace_back("time");
    for (const NamedCoordinate& c : start.machine().coordinates)
      if (!c.name.empty()) known.push_back(c.name);
    fail(situation.file, table.over_mark, "'" + table.over + "' is neither time, nor a coordinate or datum",
         did_you_mean(table.over, known));
  }
  // The values for which there are rows.
  std::vector<double> rows;
  constexpr std::size_t most_rows = 10'000;
  Dimension dimension = dimensions::time;
  const auto number = [&](const Expression& expression) {
    const Situated asked = situated_in(expression, first.situation);
    const Value<double> value = instant(start_of(asked.situation)).ask(asked.expression, std::nullopt, nullptr);
    if (!value.is_number()) fail(situation.file, expression.mark(), "expected a number");
    if (value.number != 0 || !value.bare) dimension = value.dimension;
    return value.number;
  };
  if (const Range* range = table.values.as<Range>()) {
    const double from = number(range->from), to = number(range->to), by = std::abs(number(range->step));
    if (!(by > 0)) fail(situation.file, range->step.mark(), "the step of a range is not zero");
    const double span = to - from, count = std::floor(std::abs(span) / by * (1 + 1e-12) + 1e-9);
    if (count >= static_cast<double>(most_rows))
      fail(situation.file, table.values.mark(), "the table has more than 10 000 rows", "take a larger step");
    for (std::size_t k = 0; k <= static_cast<std::size_t>(count); ++k)
      rows.push_back(from + (span < 0 ? -by : by) * static_cast<double>(k));
    // If the range ends at an extreme of the motion, this end gets a row of its own.
    if (asks_motion_feature(range->to) && std::abs(rows.back() - to) > 1e-9 * by) rows.push_back(to);
  } else {
    for (const Expression& item : table.values.as<List>()->items) rows.push_back(number(item));
  }
  if (over_time && std::any_of(rows.begin(), rows.end(), [](double time) { return time < 0; }))
    fail(situation.file, table.values.mark(), "the motion begins at 0 s: there is no time before it");

  std::vector<Value<double>> values;
  for (double row : rows) {
    if (over_time || coordinate) {
      for (const NamedExpression& column : table.columns) {
        const auto [situation_index, expression] = situated_in(column.value, first.situation);
        const double time = over_time ? row
                                      : motion(situation_index)
                                            .time_of(parse_expression(table.over, situation.file, table.over_mark), row,
                                                     table.over_mark);
        Value<double> value = motion(situation_index).value(time, expression, ask.axes);
        if (!value.is_number())
          fail(situation.file, column.mark, "column '" + column.name + "' is no number",
               "ask for a component such as .x, or norm(...)");
        values.push_back(std::move(value));
      }
    } else {
      AllSettings settings = settings_;
      for (Settings& one : settings) one[table.over] = Value<double>::of_number(row, dimension);
      add_row_over_datum(ask, settings, values);
    }
  }
  return values;
}

}  // namespace poinsot::problem
