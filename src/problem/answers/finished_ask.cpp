#include "problem/answers/finished_ask.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "problem/answers/asked_size.h"
#include "problem/language/diagnostic.h"
#include "problem/language/evaluate_support.h"
#include "problem/language/expression_walk.h"
#include "problem/plane/planar_words.h"
#include "problem/quantities/asks_model.h"
#include "problem/quantities/describe.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/asked_value.h"

namespace poinsot::problem {
namespace {

const Unit* unknown_unit(const Situation& situation, const std::string& name) {
  for (const Unknown& unknown : situation.find)
    if (unknown.name == name) return &unknown.unit;
  return nullptr;
}

bool dimension_is_text(const Value<double>& value) {
  return value.is_list() && !value.items.empty() && value.items.front().is_text();
}

SolvedAsk finished_extremum(const Statement& statement, const Ask& ask, const Value<double>* value,
                            const AskValues& asked) {
  const Situation& situation = statement.situations[situation_of(statement, ask)];
  SolvedAsk solved;
  solved.words = describe(ask, situation, false);
  if (!value) {
    solved.state = AskState::refused;
    solved.reason = asked.no_extremum.at(ask.name);
    return solved;
  }
  solved.value = *value;
  if (ask.unit && !same_kind(ask.unit->dimension, value->dimension))
    fail(situation.file, ask.mark,
         "'" + ask.extremum->name + "' is " + to_string(value->dimension) + ", but " + ask.unit->text +
             " is a unit of " + to_string(ask.unit->dimension),
         "ask for it in a unit such as " + situation.habits.unit_for(value->dimension).text);
  solved.unit = ask.unit ? *ask.unit : situation.habits.unit_for(value->dimension);
  return solved;
}

// Phases are read in degrees, whatever units the data have.
Unit unit_of_column(const Situation& situation, bool is_phase, const Dimension& dimension, bool energy) {
  if (is_phase && dimension == dimensions::angle) return parse_unit("deg");
  return situation.habits.unit_for(dimension, energy);
}

// The column of a name, or the list that has it among its columns, name_2.
const NamedExpression& stated_column(const Table& table, const std::string& name, std::size_t columns) {
  for (const NamedExpression& column : table.columns) {
    if (column.name == name) return column;
    for (std::size_t k = 1; k <= columns; ++k)
      if (column.name + "_" + std::to_string(k) == name) return column;
    for (const char* part : {"_amplitude", "_phase"})
      if (column.name + part == name) return column;
  }
  return table.columns.front();
}

// The first unit of the dimension that is written in an expression.
const Unit* written_unit(const Expression& expression, const Dimension& dimension) {
  const Number* number = expression.as<Number>();
  if (number && number->has_unit && same_kind(number->unit.dimension, dimension)) return &number->unit;
  const Unit* found = nullptr;
  for_each_child(expression, [&](const Expression& child) {
    if (!found) found = written_unit(child, dimension);
  });
  return found;
}

// What a table runs over: the first of so many columns.
SolvedColumn column_over(const Situation& situation, const Table& table, const Value<double>& value,
                         std::size_t columns) {
  SolvedColumn column;
  column.name = table.over;
  for (std::size_t row = 0; row < value.items.size(); row += columns) column.values.push_back(value.items[row].number);
  const Dimension dimension = value.items.empty() ? dimensions::none : value.items.front().dimension;
  const Unit* written = written_unit(table.values, dimension);
  column.unit = written ? *written : situation.habits.unit_for(dimension);
  return column;
}

SolvedAsk finished_table(const Statement& statement, const Ask& ask, const Value<double>& value) {
  const Situation& situation = statement.situations.front();
  SolvedAsk solved;
  solved.words = describe(ask, situation, false);
  std::vector<std::string> names;
  std::istringstream lines(value.text);
  for (std::string line; std::getline(lines, line);) names.push_back(line);
  const std::size_t count = names.size();
  if (shows_over(*ask.table)) solved.over = column_over(situation, *ask.table, value, count);
  for (std::size_t c = solved.over ? 1 : 0; c < count; ++c) {
    const NamedExpression& stated = stated_column(*ask.table, names[c], count);
    SolvedColumn column;
    column.name = names[c];
    std::optional<Dimension> dimension;
    for (std::size_t row = c; row < value.items.size(); row += count) {
      column.values.push_back(value.items[row].number);
      if (!dimension || dimension == dimensions::none) dimension = value.items[row].dimension;
    }
    const auto unit = ask.table->units.find(stated.name);
    if (unit != ask.table->units.end()) {
      if (dimension && !same_kind(unit->second.dimension, *dimension))
        fail(situation.file, stated.mark,
             "column '" + stated.name + "' is " + to_string(*dimension) + ", but " + unit->second.text +
                 " is a unit of " + to_string(unit->second.dimension));
      column.unit = unit->second;
    } else {
      column.unit = unit_of_column(situation, column.name == stated.name + "_phase",
                                   dimension.value_or(dimensions::none), asks_energy(stated.value));
    }
    solved.columns.push_back(std::move(column));
  }
  solved.value = value;
  return solved;
}

bool has_records(const Value<double>& value) {
  return is_record(value) || std::ranges::any_of(value.items, has_records);
}

// Modes are shown as a table with a row for each, as are the responses of components.
SolvedAsk finished_modes(const Ask& ask, const Value<double>& value, const Situation& situation) {
  std::vector<Value<double>> rows = is_record(value) ? std::vector<Value<double>>{value} : value.items;
  const bool modes = rows.front().items.front().text == "growth_rate";
  if (ask.is_list)
    fail(situation.file, ask.mark, std::string(modes ? "modes()" : "response()") + " stand in a list with nothing else",
         modes ? "ask for them by themselves" : "ask for parts: response(x to push).amplitude");
  if (ask.unit)
    fail(situation.file, ask.mark,
         std::string(modes ? "modes are" : "a response is") + " told in several units: no one unit is for all of them",
         "ask for parts of them, " + std::string(modes ? "modes(disk)[1].frequency" : "response(x to push).amplitude"));
  SolvedAsk solved;
  solved.words = describe(ask, situation, false);
  solved.value = value;
  if (!modes && !is_record(value) && rows.size() == 3) {
    solved.component_names.assign(situation.axes.begin(), situation.axes.end());
    // Across the plane of a problem nothing is told.
    if (situation.plane) {
      const auto across = static_cast<std::ptrdiff_t>(situation.plane->normal());
      rows.erase(rows.begin() + across);
      solved.value.items.erase(solved.value.items.begin() + across);
      solved.component_names.erase(solved.component_names.begin() + across);
    }
  }
  for (std::size_t c = 0; c < rows.front().items.size(); ++c) {
    SolvedColumn column;
    column.name = rows.front().items[c].text;
    for (const Value<double>& row : rows) column.values.push_back(row.items[c].number);
    const Dimension& dimension = rows.front().items[c].dimension;
    // A shape is told by the ratio of its parts, which the units of radian and metre leave as it is.
    const bool amplitude = c > 2 && (c - 3) % 2 == 0;
    column.unit = amplitude ? si_unit(dimension) : unit_of_column(situation, column.name == "phase", dimension, false);
    solved.columns.push_back(std::move(column));
  }
  return solved;
}

// Whether any number is so small that it may be rounding.
bool has_small_numbers(const Value<double>& value, double size) {
  const auto small = [&](double x) { return x != 0 && std::abs(x) < size; };
  if (value.is_number()) return small(value.number);
  if (value.is_vector()) return small(value.vector.x) || small(value.vector.y) || small(value.vector.z);
  return std::any_of(value.items.begin(), value.items.end(),
                     [&](const Value<double>& item) { return has_small_numbers(item, size); });
}

// The two axes of the plane, if these are the components on them of one vector, as planar_statement.h asks for it.
std::vector<std::string> axes_of_components(const Ask& ask, const Situation& situation) {
  if (!situation.plane || ask.of.size() != 2) return {};
  std::vector<std::string> axes;
  std::set<std::string> vectors;
  for (const Expression& one : ask.of) {
    const At* at = one.as<At>();
    const Member* component = (at ? at->expression : one).as<Member>();
    if (!component) return {};
    axes.push_back(component->name);
    vectors.insert(to_string(component->object) + "@" + (at ? at->instant : ""));
  }
  const bool both = axes == std::vector{situation.axes[component_axes(*situation.plane)[0]],
                                        situation.axes[component_axes(*situation.plane)[1]]};
  return both && vectors.size() == 1 ? axes : std::vector<std::string>{};
}

// Whether it asks when a named instant is, as time @ landing does.
bool tells_time(const Expression& expression) {
  if (const At* at = expression.as<At>(); at && !at->names.empty()) {
    std::set<std::string> names;
    collect_names(at->expression, names, true);
    if (names.contains("time")) return true;
  }
  return any_child(expression, tells_time);
}

// Of a number that is the small difference of large ones, that few of its digits are known. Empty if as many are known
// as are shown.
std::string few_digits(const Ask& ask, const Value<double>& value, RoundedValues& rounded) {
  constexpr double shown = 1e-5;  // six digits
  if (!value.is_number() || value.number == 0) return "";
  const double part = rounded.spread(ask, value) / std::abs(value.number);
  if (!(part > shown)) return "";
  const int known = std::max(1, static_cast<int>(-std::log10(part)));
  return "'" + ask.name + "' is the small difference of large numbers: of its digits " + std::to_string(known) +
         (known == 1 ? " is" : " are") + " known";
}

FinishedAsk finished_value(const Ask& ask, const Value<double>& value, Sample& sample, RoundedValues& rounded) {
  FinishedAsk result;
  SolvedAsk& solved = result.solved;
  const Situation& situation = sample.situation_at(ask);
  if (!ask.when && std::none_of(ask.of.begin(), ask.of.end(),
                                [&](const Expression& e) { return asks_model(situation, e) || tells_time(e); }))
    fail(situation.file, ask.mark, "'" + ask.name + "' asks nothing of the model: it is a formula of the data",
         "ask for a quantity, such as angular_momentum(BODY about POINT)");
  if (has_records(value)) return {finished_modes(ask, value, situation)};
  solved.value = value;
  const Dimension dimension = dimension_of(value);
  SolvedInstant& instant = sample.instant_of(ask);
  result.natural_size = asked_size(instant, situation, ask, dimension);
  const double size = std::max({size_of(value), instant.natural_size(dimension), result.natural_size});
  // What a motion has led to is no better than the motion was followed.
  const bool moved = !sample.motions().empty();
  const double noise = moved ? noise_of_motion : noise_of_instant;
  if (has_small_numbers(value, noise * size)) {
    drop_noise(solved.value, size, result.natural_size, moved ? std::vector<Value<double>>{} : rounded.of(ask), noise);
    if (!moved) result.note = few_digits(ask, solved.value, rounded);
  }
  for (const Value<double>& item : value.items)
    if (!same_kind(dimension_of(item), dimension))
      fail(situation.file, ask.mark,
           "the items of this list are of different kinds: " + to_string(dimension) + " and " +
               to_string(dimension_of(item)),
           "ask them one by one");
  if (ask.unit) {
    if (!same_kind(ask.unit->dimension, dimension))
      fail(situation.file, ask.mark,
           "the answer is " + to_string(dimension) + ", but " + ask.unit->text + " is a unit of " +
               to_string(ask.unit->dimension),
           "ask for it in a unit such as " + situation.habits.unit_for(dimension).text);
    solved.unit = *ask.unit;
  } else if (const Name* name = ask.of.size() == 1 ? ask.of.front().as<Name>() : nullptr;
             name && unknown_unit(situation, name->name)) {
    solved.unit = *unknown_unit(situation, name->name);
  } else if (!value.is_boolean() && !value.is_text() && !dimension_is_text(value)) {
    solved.unit = situation.habits.unit_for(dimension, std::all_of(ask.of.begin(), ask.of.end(), asks_energy));
  }
  solved.words = describe(ask, situation, has_vector(value));
  if (has_vector(value))
    solved.component_names.assign(situation.axes.begin(), situation.axes.end());
  else
    solved.component_names = axes_of_components(ask, situation);
  return result;
}

}  // namespace

FinishedAsk finished_ask(const Statement& statement, std::size_t index, const AskValues& asked, Sample& sample,
                         RoundedValues& rounded) {
  const Ask& ask = statement.asks[index];
  if (const auto missing = asked.unanswered.find(ask.name); missing != asked.unanswered.end()) {
    const Diagnostic& why = missing->second;
    FinishedAsk result;
    result.solved.state = AskState::undetermined;
    result.solved.reason = why.message + (why.hint.empty() ? "" : ": " + why.hint);
    result.solved.words = describe(ask, statement.situations.front(), false);
    return result;
  }
  const std::optional<WatchedValue>& value = asked.values[index];
  if (ask.extremum) return {finished_extremum(statement, ask, value ? &value->answer : nullptr, asked)};
  if (ask.table) return {finished_table(statement, ask, value->answer)};
  return finished_value(ask, value->answer, sample, rounded);
}

}  // namespace poinsot::problem
