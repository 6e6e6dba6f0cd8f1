#include "problem/unknowns/asked_value.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/solve/stability/spectrum_check.h"
#include "problem/instant/contact_state_search.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/unknowns/uncertain_event.h"
#include "problem/unknowns/unknown_search.h"
#include "problem/witness/particle_witness.h"

namespace poinsot::problem {
namespace {

// The times at which what is asked for happens.
std::vector<double> asked_times(Sample& sample, const Ask& ask) {
  const auto [situation_index, condition] = situated(sample.statement(), ask.when->condition);
  const Situation& situation = sample.statement().situations[situation_index];
  DataScope<double> data(situation, sample.settings()[situation_index]);
  const double from = ask.when->from ? data.number(*ask.when->from, dimensions::time) : 0;
  const std::optional<double> to =
      ask.when->to ? std::optional(data.number(*ask.when->to, dimensions::time)) : std::nullopt;
  if (to && !(*to > from))
    fail(situation.file, ask.when->to->mark(), "the span ends before it begins", "write from: 0 s, to: 4 s");
  std::vector<double> found = sample.motion(situation_index).times(condition, ask.axes, from, to);
  if (ask.when->first && found.size() > 1) found = {found.front()};
  if (ask.when->first && found.empty())
    throw NotHappeningError(situation.file, condition.mark(),
                            "'" + to_string(condition) + "' does not happen in this span",
                            "check the condition, or let the span last longer", INFINITY);
  return found;
}

// A table row by row: the value that the row stands for decides the time or the datum at which the columns are asked.
class AskedTable {
 public:
  AskedTable(Sample& sample, const Ask& ask)
      : sample_(sample),
        ask_(ask),
        table_(*ask.table),
        first_(sample.home_of(ask)),
        situation_(sample.statement().situations[first_.situation]) {}

  Value<double> value() {
    const Run run = runs_over();
    const std::vector<double> rows = row_values();
    // Zeros say nothing of their dimension.
    if (run == Run::coordinate) {
      const bool turning = sample_.instant(first_).machine().coordinate(table_.over)->turning;
      dimension_ = turning ? dimensions::angle : dimensions::length;
    }
    if (run == Run::time && std::any_of(rows.begin(), rows.end(), [](double time) { return time < 0; }))
      fail(situation_.file, table_.values.mark(), "the motion begins at 0 s: there is no time before it");
    if (run == Run::time && !rows.empty()) latest_row_ = std::ranges::max(rows);
    // Each row at another datum is a problem of its own. A fault in some of them shows in others, so that of many rows
    // the first, the last and some between are confirmed.
    constexpr std::size_t most_confirmed = 24;
    const std::size_t stride = 1 + rows.size() / most_confirmed;
    std::exception_ptr first_failure;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::size_t before = values_.size();
      try {
        if (shows_over(table_)) add_cell(table_.over, Value<double>::of_number(rows[i], dimension_));
        if (run == Run::datum)
          add_row_over_datum(rows[i], sample_.writes_told() && (i % stride == 0 || i + 1 == rows.size()));
        else
          add_row_of_motion(run, rows[i]);
        end_row();
      } catch (const StatementError& error) {
        if (!first_failure) first_failure = std::current_exception();
        values_.resize(before);
        row_names_.clear();
        leave_out(rows[i], error.diagnostics().front());
      }
    }
    if (!names_ && first_failure) no_row_has_an_answer(first_failure, rows);
    for (const auto& [reason, left_out] : left_out_) sample_.note_row(ask_.name, words_of_left_out(left_out, reason));
    Value<double> table = Value<double>::of_list(std::move(values_));
    if (names_) table.text = joined(*names_, "\n");
    return table;
  }

 private:
  enum class Run { time, coordinate, datum };

  Run runs_over() {
    const Machine& machine = sample_.instant(first_).machine();
    std::vector<std::string> known = settable_names(situation_);
    if (table_.over == "time") return Run::time;
    if (machine.coordinate(table_.over)) return Run::coordinate;
    if (std::ranges::find(known, table_.over) != known.end()) return Run::datum;
    known.emplace_back("time");
    for (const NamedCoordinate& c : machine.coordinates)
      if (!c.name.empty()) known.push_back(c.name);
    fail(situation_.file, table_.over_mark, "'" + table_.over + "' is neither time, nor a coordinate or datum",
         did_you_mean(table_.over, known));
  }

  // The values for which there are rows.
  std::vector<double> row_values() {
    std::vector<double> rows;
    constexpr std::size_t most_rows = 10'000;  // nobody reads more, and each costs as much as a problem
    if (const Range* range = table_.values.as<Range>()) {
      const double from = number(range->from), to = number(range->to), by = std::abs(number(range->step));
      if (!(by > 0)) fail(situation_.file, range->step.mark(), "the step of a range is not zero");
      // A range holds as many steps as its decimals say: rounding of the ends and of the step must not take one away.
      const double span = to - from, count = std::floor(std::abs(span) / by * (1 + 1e-12) + 1e-9);
      if (count >= static_cast<double>(most_rows))
        fail(situation_.file, table_.values.mark(), "the table has more than 10 000 rows", "take a larger step");
      for (std::size_t k = 0; k <= static_cast<std::size_t>(count); ++k)
        rows.push_back(from + (span < 0 ? -by : by) * static_cast<double>(k));
      // If the range ends at an extreme of the motion, this end gets a row of its own.
      if (asks_motion_feature(range->to) && std::abs(rows.back() - to) > 1e-9 * by) rows.push_back(to);
    } else {
      for (const Expression& item : table_.values.as<List>()->items) rows.push_back(number(item));
    }
    return rows;
  }

  double number(const Expression& expression) {
    const Situated asked = sample_.situated_in(expression, first_.situation);
    const Value<double> value = sample_.value_in(asked.situation, asked.expression);
    if (!value.is_number()) fail(situation_.file, expression.mark(), "expected a number");
    if (value.number != 0 || !value.bare) dimension_ = value.dimension;
    return value.number;
  }

  void add_row_of_motion(Run run, double row) {
    for (const NamedExpression& column : table_.columns) {
      const auto [situation_index, expression] = sample_.situated_in(column.value, first_.situation);
      Course& motion = sample_.motion(situation_index);
      if (run == Run::time) follow(motion, situation_index, row);
      const double time = run == Run::time ? row : motion.time_of(table_.over_value, row, table_.over_mark);
      require_certain(uncertain_before(situation_index, time), column);
      add(column, motion.value(time, expression, ask_.axes));
    }
  }

  // What cannot be followed to a time cannot be followed to a later one: that is tried once.
  void follow(Course& motion, std::size_t situation, double time) {
    if (const auto failed = not_followed_.find(situation); failed != not_followed_.end() && time >= failed->second.time)
      std::rethrow_exception(failed->second.why);
    try {
      motion.follow(time);
    } catch (const UnansweredError&) {
      not_followed_[situation] = {time, std::current_exception()};
      throw;
    }
  }

  // Adds the columns at another value of a datum, for which the unknowns are found anew.
  void add_row_over_datum(double row, bool confirm) {
    const Statement& statement = sample_.statement();
    const Situation& situation = statement.situations.front();
    AllSettings all = sample_.settings();
    for (Settings& one : all) one[table_.over] = Value<double>::of_number(row, dimension_);
    Settings known = all.front();
    for (const Unknown& unknown : situation.find)
      if (unknown.name != table_.over) known.erase(unknown.name);
    UnknownSearch search(statement, known);
    if (!search.unknowns().empty()) {
      const RootsFound found = search.find(known);
      if (found.roots.size() != 1)
        fail(situation.file, table_.over_mark,
             found.roots.empty() ? "there is no solution at a value of '" + table_.over + "' in this table"
                                 : "there are several solutions at a value of '" + table_.over + "' in this table",
             "narrow the range, or tell by where: which solution is meant");
      all = found.roots.front();
    }
    const std::shared_ptr<const Statement> stated = in_states_at(all);
    Sample there =
        stated ? Sample(stated, std::move(all), sample_.choice()) : Sample(statement, std::move(all), sample_.choice());
    if (confirm) there.write_down_what_is_told();
    for (const NamedExpression& column : table_.columns) {
      add(column, there.value_at(there.home(column.value, column.mark), column.value, ask_.axes));
      require_certain(uncertain_event_in(there, column.value), column);
    }
    refuse_unphysical(there);
    if (confirm &&
        !std::ranges::all_of(there.instants(), [](const auto& item) { return confirmed_by_all_roads(*item.second); }))
      sample_.note_unphysical_row(ask_.name, "independent checks do not confirm the row " + row_words(row));
    if (std::ranges::any_of(table_.columns, [](const auto& column) { return asks_stability(column.value); }))
      confirm_stability(there);
  }

  // What is uncertain of the stages that end before a time. It is sought once for the rows up to the latest.
  std::optional<UncertainEvent> uncertain_before(std::size_t situation, double time) {
    const auto known = ends_.find(situation);
    if (known == ends_.end() || known->second.until < time) {
      const double until = std::max(time, latest_row_);
      ends_[situation] = {until, uncertain_stage_end(sample_, situation, until)};
    }
    const std::optional<UncertainEvent>& event = ends_[situation].uncertain;
    return event && event->time <= time ? event : std::nullopt;
  }
  void require_certain(const std::optional<UncertainEvent>& event, const NamedExpression& column) const {
    if (event) throw UnansweredError(situation_.file, column.mark, in_words(*event));
  }

  // The statement with its contacts with friction in the states in which they are at these values; none if no contact
  // has friction.
  std::shared_ptr<const Statement> in_states_at(const AllSettings& all) const {
    const Statement& statement = sample_.statement();
    if (std::ranges::none_of(statement.situations, &Situation::has_friction)) return nullptr;
    auto found = std::make_shared<Statement>(statement);
    for (std::size_t i = 0; i < found->situations.size(); ++i) {
      Situation& situation = found->situations[i];
      // In a steady motion they stick, which is looked at in each row.
      if (!situation.has_friction() || situation.steady) continue;
      const HeldStates held = states_that_hold(with_states_open(situation), i, all[i], false);
      if (!held.doubts.empty() || held.all.size() != 1)
        throw UnansweredError(situation.file, ask_.mark,
                              !held.doubts.empty()
                                  ? "which states of the contacts hold is not known: " + held.doubts.front()
                              : held.all.empty() ? "no state of the contacts with friction holds"
                                                 : "several states of the contacts with friction hold",
                              "narrow the range");
      put_in_states(situation, i, held.all.front());
    }
    return found;
  }

  void add(const NamedExpression& column, const Value<double>& value) {
    if (value.is_list() && std::ranges::all_of(value.items, &Value<double>::is_number)) {
      // The parts of a record have names, those of a list numbers.
      for (std::size_t i = 0; i < value.items.size(); ++i) {
        const std::string& part = value.items[i].text;
        add_number(column, column.name + "_" + (part.empty() ? std::to_string(i + 1) : part), value.items[i]);
      }
      return;
    }
    if (!value.is_number())
      fail(situation_.file, column.mark, "column '" + column.name + "' is no number",
           value.is_list() ? "ask for an element of it, [1]" : "ask for a component such as .x, or norm(...)");
    add_number(column, column.name, value);
  }
  void add_number(const NamedExpression& column, const std::string& name, Value<double> value) {
    if (std::ranges::find(row_names_, name) != row_names_.end())
      fail(situation_.file, column.mark, "two columns of the table are called '" + name + "'", "rename one of them");
    add_cell(name, std::move(value));
  }
  void add_cell(const std::string& name, Value<double> value) {
    row_names_.push_back(name);
    values_.push_back(std::move(value));
  }

  // Each row has the columns of the first.
  void end_row() {
    const std::vector<std::string> names = std::exchange(row_names_, {});
    if (!names_) names_ = names;
    if (names == *names_) return;
    throw UnansweredError(situation_.file, ask_.mark, "a list has more or fewer items than in the first row",
                          "ask for one of them, as in frequencies(disk)[1], or narrow the range");
  }

  // What is told of the motion near a steady one has its second road in every row.
  void confirm_stability(const Sample& there) {
    for (const auto& [home, solved] : there.instants()) {
      const double misfit = solved->check().stability.value_or(0);
      if (!(misfit > solve::spectrum_tolerance)) continue;
      throw UnansweredError(situation_.file, ask_.mark,
                            "the motion of its bodies, each by itself, does not confirm it (rates off by " +
                                with_digits(misfit, 2) + " of the pace)");
    }
  }
  // Rows without an answer are left out, and the others stand.
  void leave_out(double row, const Diagnostic& why) {
    const auto known = std::ranges::find(left_out_, why.message, &LeftOut::first);
    if (known != left_out_.end())
      known->second.push_back(row);
    else
      left_out_.emplace_back(why.message, std::vector<double>{row});
  }
  // What is wrong with the question itself, as a column that is no number, is so in every row.
  [[noreturn]] void no_row_has_an_answer(const std::exception_ptr& first, const std::vector<double>& rows) const {
    const auto with_row = [&](const UnansweredError& error) {
      Diagnostic told = error.diagnostics().front();
      const bool alike = left_out_.size() == 1 && rows.size() > 1;
      told.message = (alike ? "in every row: " : "in the row " + row_words(rows.front()) + ": ") + told.message;
      if (told.hint.empty()) told.hint = "let the table run over values that have an answer";
      return told;
    };
    try {
      std::rethrow_exception(first);
    } catch (const NotHappeningError& error) {
      const Diagnostic told = with_row(error);
      throw NotHappeningError(told.file, told.mark, told.message, told.hint, error.until());
    } catch (const UnansweredError& error) {
      throw UnansweredError(with_row(error));
    }
  }
  std::string words_of_left_out(const std::vector<double>& rows, const std::string& reason) const {
    constexpr std::size_t most_named = 4;
    std::vector<std::string> named;
    for (const double row : rows)
      if (named.size() < most_named) named.push_back(row_words(row));
    const std::size_t more = rows.size() - named.size();
    if (more > 0) named.push_back(std::to_string(more) + " more");
    return (rows.size() == 1 ? "the row " : "the rows ") + listed(named) + (rows.size() == 1 ? " has" : " have") +
           " no answer and " + (rows.size() == 1 ? "is" : "are") + " left out: " + reason;
  }
  std::string row_words(double row) const {
    const Unit unit = situation_.habits.unit_for(dimension_);
    return table_.over + " = " + with_digits(row / unit.factor, 6) + (unit.text.empty() ? "" : " " + unit.text);
  }

  void refuse_unphysical(const Sample& there) const {
    for (const auto& [home, solved] : there.instants()) {
      if (!solved->forces_solved()) continue;
      const std::vector<std::string> reasons = solved->unphysical();
      if (!reasons.empty()) throw UnansweredError(situation_.file, ask_.mark, reasons.front(), "narrow the range");
    }
  }

  Sample& sample_;
  const Ask& ask_;
  const Table& table_;
  const Sample::Home first_;  // the instant at which the table begins
  const Situation& situation_;
  Dimension dimension_ = dimensions::time;  // of the values that the table runs over
  std::vector<Value<double>> values_;       // row by row
  std::vector<std::string> row_names_;      // of those in the row that is not ended
  std::optional<std::vector<std::string>> names_;
  struct StageEnds {
    double until = 0;
    std::optional<UncertainEvent> uncertain{};
  };
  std::map<std::size_t, StageEnds> ends_;  // by situation
  double latest_row_ = 0;                  // s, of a table over time
  using LeftOut = std::pair<std::string, std::vector<double>>;
  std::vector<LeftOut> left_out_;  // rows, by the reason
  struct NotFollowed {
    double time;  // s
    std::exception_ptr why;
  };
  std::map<std::size_t, NotFollowed> not_followed_;  // by the situation
};

}  // namespace

bool shows_over(const Table& table) {
  return std::ranges::none_of(table.columns, [&](const NamedExpression& column) {
    return column.name == table.over || to_string(column.value) == table.over;
  });
}

Value<double> asked_value(Sample& sample, const Ask& ask) {
  if (ask.table) return AskedTable(sample, ask).value();
  std::vector<Value<double>> items;
  if (ask.when) {
    for (const double time : asked_times(sample, ask))
      items.push_back(Value<double>::of_number(time, dimensions::time));
    return ask.when->first ? items.front() : Value<double>::of_list(std::move(items));
  }
  for (const Expression& expression : ask.of)
    items.push_back(sample.value_at(sample.home(expression, ask.mark), expression, ask.axes));
  return ask.is_list ? Value<double>::of_list(std::move(items)) : items.front();
}

}  // namespace poinsot::problem
