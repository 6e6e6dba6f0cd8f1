#include "problem/cases/cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "poinsot/engine/work/budget.h"
#include "problem/answers/letter_draws.h"
#include "problem/answers/read_settings.h"
#include "problem/answers/solve_statement.h"
#include "problem/cases/instant_rows.h"
#include "problem/course/course.h"
#include "problem/language/diagnostic.h"
#include "problem/quantities/asks_model.h"
#include "problem/unknowns/asked_value.h"
#include "problem/unknowns/unknown_search.h"

namespace poinsot::problem {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// How many cases there are to each that is checked in full.
constexpr std::uint64_t cases_to_a_check = 1000;
// Cases that go by a program before the next: their columns stay near the processor while they are made and written.
constexpr std::size_t cases_at_once = 4096;
// Of the size of an answer: the formulas of other roots and other regimes differ by far more. Where the terms of a
// formula cancel, rounding leaves less than a part in 1e9 of what its answer is at other cases.
constexpr double same_answer = 1e-7, cancelled = 1e-9;

// The numbers of an answer; nothing if it has none.
std::vector<double> numbers_of(const SolvedAsk& ask) { return numbers_in(ask.value); }

// Of each number of a value; nothing if it has none.
template <class Scalar>
std::vector<Dimension> dimensions_in(const Value<Scalar>& value) {
  std::vector<Dimension> found(numbers_in(value).size(), value.dimension);
  for (std::size_t k = 0; value.is_list() && k < found.size(); ++k) found[k] = value.items[k].dimension;
  return found;
}

// A reason without the places in the file that it names: what is wrong in a row is no fault of a line there.
std::string without_place(std::string reason, const std::string& file) {
  const auto digits_from = [&](std::size_t at) {
    return std::min(reason.find_first_not_of("0123456789", at), reason.size());
  };
  for (std::size_t at = reason.find(file + ":"); !file.empty() && at != std::string::npos;
       at = reason.find(file + ":", at)) {
    const std::size_t line = at + file.size() + 1, colon = digits_from(line), column = colon + 1;
    const bool has_line = colon > line && reason.compare(colon, 1, ":") == 0;
    const std::size_t end = has_line ? digits_from(column) : column;
    if (!has_line || end == column || reason.compare(end, 2, ": ") != 0) {
      ++at;
      continue;
    }
    constexpr std::string_view severity = "error: ";
    const std::size_t text = end + 2;
    reason.erase(at, text - at + (reason.compare(text, severity.size(), severity) == 0 ? severity.size() : 0));
  }
  return reason;
}

std::string reason_of(const SolvedAsk& ask) {
  switch (ask.state) {
    case AskState::found:
      return numbers_of(ask).empty() ? "it has no number here" : "";
    case AskState::needs_letters:
      return fmt::format("the letters {} have no value", fmt::join(ask.letters, ", "));
    case AskState::undetermined:
    case AskState::refused:
      return ask.reason;
  }
  return "";
}

// Whether dry friction leaves it to each case what state it is in: a whole solution finds that.
bool has_states_to_find(const Statement& statement) {
  return std::ranges::any_of(statement.situations, [](const Situation& situation) {
    return situation.has_friction() ||
           std::ranges::any_of(situation.contacts, [](const Contact& one) { return one.friction.has_value(); }) ||
           std::ranges::any_of(situation.gears, [](const Gear& one) { return one.friction.has_value(); }) ||
           std::ranges::any_of(situation.impacts, [](const Impact& one) { return one.friction.has_value(); });
  });
}

}  // namespace

CompiledCases::CompiledCases(const Statement& statement, CasesAsked asked)
    : statement_(with_questions(statement, asked.asks)),
      sets_(std::move(asked.sets)),
      data_(varied_data(statement, asked.over)),
      first_(std::move(asked.first)),
      usual_(asked.usual.empty() ? first_ : std::move(asked.usual)) {
  find_places(asked.sensitivities);
  if (statement_.asks.empty()) fail(statement_.file, Mark{1, 1}, "the file asks nothing", "write ask: {T: ...}");
  const bool rough = has_states_to_find(statement_);
  if (rough)
    no_formulas_ = "what sticks or slides, or which flank carries, may differ from case to case";
  else if (asked.with_formulas)
    find_formulas();
  else
    no_formulas_ = "they are not wanted";
  settings_ = read_settings(statement_, sets_);
  all_have_values_ = no_letters_left() && !rough;
  by_instants_ = needs_instants_alone(statement_) && all_have_values_;
  find_roots();
  if (!columns_.empty()) {
    if (!formulas_) make_program();
    return;
  }
  // Letters were not tried, or made no sense: the first case shows what there is, or what is wrong.
  if (first_.size() != data_.size())
    throw std::invalid_argument(
        fmt::format("CompiledCases: the first case has {} values for {} data", first_.size(), data_.size()));
  formulas_.reset();
  std::vector<std::span<const double>> one;
  for (const double& value : first_) one.emplace_back(&value, 1);
  const SolvedStatement solved = solved_in_full(one, 0, Purpose::told);
  if (solved.ended) throw BudgetEnded{*solved.ended};
  if (solved.solutions.empty())
    fail(statement_.file, Mark{1, 1}, "the first case has no solution",
         solved.warnings.empty() ? "" : solved.warnings.front());
  take_shape(solved.solutions.front());
  if (columns_.empty()) refuse_shapeless(solved.solutions.front());
  make_program();
}

void CompiledCases::refuse_shapeless(const Solution& first) const {
  for (std::size_t i = 0; i < first.asks.size(); ++i)
    if (const std::string reason = reason_of(first.asks[i]); !reason.empty())
      fail(statement_.file, statement_.asks[i].mark,
           "'" + statement_.asks[i].name + "' has no answer in the first case: " + reason,
           "its form is taken from there: begin with values at which it has one, or leave it out by asks");
  fail(statement_.file, Mark{1, 1}, "nothing has a number in the first case");
}

void CompiledCases::find_places(const std::vector<std::string>& sensitivities) {
  for (const std::string& name : sensitivities) {
    const auto datum = std::ranges::find(data_, name, &VariedDatum::name);
    if (datum == data_.end())
      throw std::invalid_argument("CompiledCases: '" + name + "' is not among the data that differ from case to case");
    by_.push_back(static_cast<std::size_t>(datum - data_.begin()));
  }
}

// At the first case, whose solution must be the only one: what is determined there, whatever is left open, is so by
// the form of the equations.
void CompiledCases::make_program() {
  if (first_.size() != data_.size() || !all_have_values_ || !may_be_confirmed(statement_)) {
    no_program_ = "more than instants is asked about";
    return;
  }
  try {
    Columns one;
    for (const double& value : first_) one.emplace_back(&value, 1);
    const SolvedStatement solved = solved_in_full(one, 0, Purpose::told);
    if (solved.ended) throw BudgetEnded{*solved.ended};
    if (solved.solutions.size() != 1) throw NoFormula(fmt::format("there are {} solutions", solved.solutions.size()));
    AllSettings settings = settings_at(one, 0);
    for (std::size_t i = 0; i < settings.size(); ++i)
      for (const SolvedUnknown& unknown : solved.solutions.front().unknowns)
        if (unknown.is_of(i)) settings[i][unknown.own_name] = unknown.value;
    const Statement opened = with_letters(statement_, data_);
    Sample numbers(opened, settings, OpenChoice{});
    for (std::size_t i = 0; i < opened.asks.size(); ++i) {
      if (const std::string reason = reason_of(solved.solutions.front().asks[i]); !reason.empty())
        throw NoFormula(reason);
      asked_value(numbers, opened.asks[i]);
    }
    const UnknownSearch search(opened, settings_at(one, 0).front());
    program_ = InstantProgram::made({opened, data_, by_, exact_settings(opened, sets_), search.unknowns(), numbers},
                                    no_program_);
  } catch (const StatementError& error) {
    no_program_ = error.diagnostics().front().message;
  } catch (const NoFormula& error) {
    no_program_ = error.what();
  }
}

void CompiledCases::find_formulas() {
  try {
    const SolvedStatement solved = solve_statement(with_letters(statement_, data_), sets_);
    if (solved.ended) throw BudgetEnded{*solved.ended};
    formulas_ = CaseFormulas::made(solved, data_, by_, no_formulas_);
    if (!solved.solutions.empty()) take_shape(solved.solutions.front());
  } catch (const StatementError& error) {
    no_formulas_ = error.diagnostics().front().message;
  }
}

void CompiledCases::take_shape(const Solution& solution) {
  columns_.clear();
  sizes_.clear();
  std::vector<Dimension> of_answers;
  for (std::size_t i = 0; i < solution.asks.size(); ++i) {
    const SolvedAsk& ask = solution.asks[i];
    const std::string& name = statement_.asks[i].name;
    const std::vector<Dimension> in_formula = ask.formula ? dimensions_in(*ask.formula) : std::vector<Dimension>();
    const std::vector<Dimension> parts = in_formula.empty() ? dimensions_in(ask.value) : in_formula;
    if (parts.empty() || !ask.columns.empty()) {
      columns_.clear();
      sizes_.clear();
      if (!ask.columns.empty() || ask.value.is_list() || ask.value.is_text() || ask.value.is_boolean())
        fail(statement_.file, statement_.asks[i].mark, "'" + name + "' is no number, no vector and no list of numbers",
             "a study asks for numbers: leave it out by asks");
      return;
    }
    sizes_.push_back(parts.size());
    of_answers.insert(of_answers.end(), parts.begin(), parts.end());
    const bool energy = std::ranges::all_of(statement_.asks[i].of, asks_energy);
    const bool number = in_formula.empty() ? ask.value.is_number() : ask.formula->is_number();
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::string part = k < ask.component_names.size() ? ask.component_names[k] : std::to_string(k + 1);
      columns_.push_back({number ? name : name + "." + part, format_unit(parts[k], energy)});
    }
  }
  answers_ = columns_.size();
  for (const std::size_t by : by_)
    for (std::size_t k = 0; k < answers_; ++k)
      columns_.push_back(
          {columns_[k].name + " by " + data_[by].name, format_unit(of_answers[k] / data_[by].dimension)});
}

SolvedStatement CompiledCases::solved_in_full(const Columns& data, std::size_t row, Purpose purpose) const {
  if (all_have_values_) {
    const Settings settings = settings_in(data, row);
    return purpose == Purpose::told ? solve_questions(statement_, settings) : solve_to_compare(statement_, settings);
  }
  std::vector<std::pair<std::string, std::string>> sets = sets_;
  for (std::size_t k = 0; k < data_.size(); ++k) sets.emplace_back(data_[k].name, setting_text(data_[k], data[k][row]));
  return solve_statement(statement_, sets);
}

std::string CompiledCases::solve_row(const Columns& data, std::size_t row, Purpose purpose,
                                     std::vector<double>& numbers) const {
  numbers.assign(answers_, missing);
  for (std::size_t k = 0; k < data_.size(); ++k)
    if (!std::isfinite(data[k][row])) return "'" + data_[k].name + "' has no value in this case";
  SolvedStatement solved;
  try {
    solved = solved_in_full(data, row, purpose);
  } catch (const StatementError& error) {
    return without_place(error.diagnostics().front().message, statement_.file);
  }
  if (solved.ended) throw BudgetEnded{*solved.ended};
  if (solved.solutions.empty())
    return solved.warnings.empty() ? "there is no solution" : without_place(solved.warnings.front(), statement_.file);
  if (solved.solutions.size() > 1) return fmt::format("there are {} solutions", solved.solutions.size());
  std::string reasons;
  std::size_t at = 0;
  const std::vector<SolvedAsk>& asks = solved.solutions.front().asks;
  for (std::size_t i = 0; i < asks.size(); ++i) {
    const std::size_t size = sizes_[i];
    std::string reason = reason_of(asks[i]);
    const std::vector<double> found = numbers_of(asks[i]);
    if (reason.empty() && found.size() != size) reason = "it has another form than in other cases";
    if (reason.empty())
      std::ranges::copy(found, numbers.begin() + static_cast<std::ptrdiff_t>(at));
    else
      reasons += (reasons.empty() ? "" : "; ") + statement_.asks[i].name + ": " + reason;
    at += size;
  }
  return without_place(std::move(reasons), statement_.file);
}

bool CompiledCases::is_refuted(const Columns& data, std::size_t row, const SolvedCases& found, bool& quickly) const {
  const bool finite = std::ranges::all_of(data, [&](const auto& column) { return std::isfinite(column[row]); });
  // A full solution decides in doubt.
  if (quickly && finite) {
    const auto confirmed = confirmed_numbers(statement_, settings_in(data, row));
    quickly = confirmed && confirmed->size() == answers_ && agree(*confirmed, row, found);
    if (quickly) return derivatives_differ(data, row, found);
  }
  std::vector<double> numbers;
  return !solve_row(data, row, Purpose::compared, numbers).empty() || !agree(numbers, row, found) ||
         derivatives_differ(data, row, found);
}

bool CompiledCases::agree(const std::vector<double>& numbers, std::size_t row, const SolvedCases& found) const {
  // The largest of a column.
  const auto largest = [&](std::size_t column) {
    double size = 0;
    for (std::size_t other = 0; other < found.roads.size(); ++other)
      if (found.roads[other] != CaseRoad::in_full) size = std::max(size, std::fabs(found.columns[column][other]));
    return size;
  };
  std::size_t at = 0;
  for (const std::size_t parts : sizes_) {
    double off = 0, size = 0;
    const std::size_t first = at;
    for (const std::size_t end = at + parts; at < end; ++at) {
      off = std::max(off, std::fabs(found.columns[at][row] - numbers[at]));
      size = std::max(size, std::fabs(numbers[at]));
    }
    if (off <= same_answer * size) continue;
    double usual = 0;
    for (std::size_t k = first; k < at; ++k) usual = std::max(usual, largest(k));
    if (!(off <= same_answer * size + cancelled * usual)) return false;
  }
  return true;
}

bool CompiledCases::no_letters_left() const {
  const std::vector<Letter> open = open_letters(statement_, settings_);
  return std::ranges::all_of(open, [&](const Letter& letter) {
    return std::ranges::find(data_, letter.name, &VariedDatum::name) != data_.end();
  });
}

Settings CompiledCases::settings_in(const Columns& data, std::size_t row) const {
  Settings settings = settings_;
  for (std::size_t k = 0; k < data_.size(); ++k)
    settings[data_[k].name] = Value<double>::of_number(data[k][row], data_[k].dimension);
  return settings;
}

AllSettings CompiledCases::settings_at(const Columns& data, std::size_t row) const {
  return AllSettings(statement_.situations.size(), settings_in(data, row));
}

template <class Program>
void CompiledCases::go_by(const Program& program, CaseRoad road, const Columns& data, SolvedCases& found) {
  const std::size_t rows = found.roads.size();
  for (std::size_t first = 0; first < rows; first += cases_at_once) {
    check_budget();
    const std::size_t count = std::min(cases_at_once, rows - first);
    std::vector<const double*> inputs;
    for (const std::span<const double>& column : data) inputs.push_back(column.data() + first);
    std::vector<double*> outputs;
    for (std::vector<double>& column : found.columns) {
      column.resize(first + count);
      outputs.push_back(column.data() + first);
    }
    const std::vector<char> valid = program.evaluate(inputs, count, outputs);
    for (std::size_t row = 0; row < count; ++row)
      if (valid[row])
        found.roads[first + row] = road;
      else
        for (double* const column : outputs) column[row] = missing;
  }
}

void CompiledCases::go_by_instants(const Columns& data, SolvedCases& found) const {
  for (std::size_t row = 0; row < found.roads.size(); ++row) {
    if (found.roads[row] != CaseRoad::in_full) continue;
    check_budget();
    if (std::ranges::any_of(data, [&](const auto& column) { return !std::isfinite(column[row]); })) continue;
    const std::optional<std::vector<double>> numbers = instant_numbers(statement_, settings_at(data, row));
    if (!numbers || numbers->size() != answers_) continue;
    for (std::size_t k = 0; k < answers_; ++k) found.columns[k][row] = (*numbers)[k];
    found.roads[row] = CaseRoad::by_instant;
  }
}

void CompiledCases::check(const Columns& data, std::uint64_t first, SolvedCases& found) const {
  // What is confirmed quickly once is most often so in all rows, and what is not in none.
  bool quickly = all_have_values_ && may_be_confirmed(statement_);
  const std::size_t to_first = (cases_to_a_check - first % cases_to_a_check) % cases_to_a_check;
  for (std::size_t row = to_first; row < found.roads.size(); row += cases_to_a_check) {
    if (found.roads[row] == CaseRoad::in_full) continue;
    ++found.checked;
    if (is_refuted(data, row, found, quickly)) ++found.refuted;
  }
  if (found.refuted == 0) return;
  std::ranges::fill(found.roads, CaseRoad::in_full);
  for (std::vector<double>& column : found.columns) std::ranges::fill(column, missing);
}

void CompiledCases::solve_the_rest(const Columns& data, SolvedCases& found) const {
  std::vector<double> numbers;
  for (std::size_t row = 0; row < found.roads.size(); ++row) {
    if (found.roads[row] != CaseRoad::in_full) continue;
    std::string reason = solve_row(data, row, Purpose::told, numbers);
    for (std::size_t k = 0; k < numbers.size(); ++k) found.columns[k][row] = numbers[k];
    if (!reason.empty()) found.reasons.emplace_back(row, std::move(reason));
  }
}

SolvedCases CompiledCases::solved(const Columns& data, std::uint64_t first) const {
  const std::size_t rows = data.empty() ? 1 : data.front().size();
  SolvedCases found;
  found.columns.resize(columns_.size());
  for (std::vector<double>& column : found.columns) column.reserve(rows);
  found.roads.assign(rows, CaseRoad::in_full);
  if (formulas_)
    go_by(*formulas_, CaseRoad::by_formula, data, found);
  else if (program_)
    go_by(*program_, CaseRoad::by_instant, data, found);
  for (std::vector<double>& column : found.columns) column.resize(rows, missing);
  leave_out_what_cannot_exist(data, found);
  if (by_instants_) go_by_instants(data, found);
  check(data, first, found);
  solve_the_rest(data, found);
  add_differences(data, found);
  return found;
}

}  // namespace poinsot::problem
