// Whether there is such a machine at all: a restitution above one, moments of inertia that no body has, a wheel without
// radius. Formulas and recorded equations have numbers for these too, and no case of them is solved.
//
// What a machine must keep to are inequalities, each of which hardly ever turns around as one datum grows. So where
// machines with the least and the largest value of each datum exist, in all combinations, those of all cases between
// do, and only else each case is looked at.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "poinsot/engine/work/budget.h"
#include "problem/answers/letter_draws.h"
#include "problem/cases/cases.h"
#include "problem/entries/drawn_letters.h"
#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"
#include "problem/machine/data.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {
namespace {

// Combinations double with each datum; from this many data on one at a time is at its other end.
constexpr std::size_t most_combined = 6;

std::vector<std::vector<double>> corners_of(const std::vector<double>& least, const std::vector<double>& largest) {
  std::vector<std::vector<double>> corners;
  const std::size_t count = least.size();
  if (count <= most_combined) {
    for (std::size_t which = 0; which < (std::size_t{1} << count); ++which) {
      corners.push_back(least);
      for (std::size_t k = 0; k < count; ++k)
        if ((which >> k & 1) != 0) corners.back()[k] = largest[k];
    }
    return corners;
  }
  corners = {least, largest};
  for (std::size_t k = 0; k < count; ++k) {
    corners.push_back(least);
    corners.back()[k] = largest[k];
    corners.push_back(largest);
    corners.back()[k] = least[k];
  }
  return corners;
}

// The least and the largest number of a column; numbers that are none count for nothing. Four at a time, for each waits
// for the one before.
std::pair<double, double> ends_of(std::span<const double> column) {
  constexpr double far = std::numeric_limits<double>::infinity();
  double low[4] = {far, far, far, far}, high[4] = {-far, -far, -far, -far};
  std::size_t row = 0;
  for (; row + 4 <= column.size(); row += 4)
    for (std::size_t k = 0; k < 4; ++k) {
      const double x = column[row + k];
      low[k] = x < low[k] ? x : low[k];
      high[k] = x > high[k] ? x : high[k];
    }
  for (; row < column.size(); ++row) {
    low[0] = std::fmin(low[0], column[row]);
    high[0] = std::fmax(high[0], column[row]);
  }
  return {*std::ranges::min_element(low), *std::ranges::max_element(high)};
}

// The same of those cases that have answers.
std::pair<double, double> ends_of(std::span<const double> column, const std::vector<CaseRoad>& roads) {
  constexpr double far = std::numeric_limits<double>::infinity();
  std::pair<double, double> ends{far, -far};
  for (std::size_t row = 0; row < column.size(); ++row) {
    if (roads[row] == CaseRoad::in_full) continue;
    ends.first = std::fmin(ends.first, column[row]);
    ends.second = std::fmax(ends.second, column[row]);
  }
  return ends;
}

}  // namespace

// Unknowns stand at their values in the first case: of a machine that hangs on them something can be told there at
// least.
void CompiledCases::find_roots() {
  roots_ = AllSettings(statement_.situations.size());
  const auto finds = [](const Situation& situation) { return !situation.find.empty(); };
  if (std::ranges::none_of(statement_.situations, finds) || first_.size() != data_.size() || !all_have_values_) return;
  std::vector<std::span<const double>> one;
  for (const double& value : first_) one.emplace_back(&value, 1);
  try {
    const SolvedStatement solved = solved_in_full(one, 0, Purpose::compared);
    if (solved.ended) throw BudgetEnded{*solved.ended};
    if (solved.solutions.size() == 1)
      for (std::size_t i = 0; i < roots_.size(); ++i)
        for (const SolvedUnknown& unknown : solved.solutions.front().unknowns)
          if (unknown.is_of(i)) roots_[i][unknown.own_name] = unknown.value;
  } catch (const StatementError&) {
    // Then they stand at one unit.
  }
  existence_is_told_ = exists(first_);
}

bool CompiledCases::exists(const std::vector<double>& values) const {
  Settings settings = settings_;
  for (const Letter& letter : open_letters(statement_, settings_))
    settings.try_emplace(letter.name, Value<double>::of_number(letter.unit.factor, letter.unit.dimension));
  for (std::size_t k = 0; k < data_.size(); ++k)
    settings[data_[k].name] = Value<double>::of_number(values[k], data_[k].dimension);
  for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
    const Situation& situation = statement_.situations[i];
    Settings own = settings;
    for (const auto& [name, value] : roots_[i]) own.try_emplace(name, value);
    for (const Unknown& unknown : situation.find) {
      const double unit = unknown.unit.factor;
      own.try_emplace(unknown.name, value_of_unknown(unknown, {unit, unit, unit}, situation.plane));
    }
    // Beside unknowns that are those of another case what is stated of the instant need not hold. What is lenient with
    // such trials is with masses, too: so the machine is made by itself as well.
    OpenChoice choice;
    choice.trial = !situation.find.empty();
    try {
      if (choice.trial) {
        DataScope<double> data(situation, own);
        DataScope<TimeJet> timed(situation, own, time_jet(0.0));
        const AnyValue one = [](const Dimension&) { return 1.0; };
        build_machine(situation, data, timed, one, MachineOptions{});
      }
      const SolvedInstant instant(situation, own, When{0, situation.has_blow()}, choice);
    } catch (const StatementError&) {
      return false;
    }
  }
  return true;
}

void CompiledCases::leave_out_what_cannot_exist(const Columns& data, SolvedCases& found) const {
  if (data.empty() || !existence_is_told_) return;
  const bool all = std::ranges::find(found.roads, CaseRoad::in_full) == found.roads.end();
  std::pair<std::vector<double>, std::vector<double>> box;
  for (const std::span<const double>& column : data) {
    const auto [least, largest] = all ? ends_of(column) : ends_of(column, found.roads);
    if (!(least <= largest)) return;  // no case has an answer yet
    box.first.push_back(least);
    box.second.push_back(largest);
  }
  {
    const std::scoped_lock lock(known_box_mutex_);
    if (known_box_ == box) return;
  }
  if (std::ranges::all_of(corners_of(box.first, box.second), [&](const auto& corner) { return exists(corner); })) {
    const std::scoped_lock lock(known_box_mutex_);
    known_box_ = std::move(box);
    return;
  }
  // With the unknowns of the first case a machine may be impossible that is none with its own: it is solved in full,
  // which decides.
  std::vector<double> values(data_.size());
  std::vector<std::size_t> impossible;
  for (std::size_t row = 0; row < found.roads.size(); ++row) {
    if (found.roads[row] == CaseRoad::in_full) continue;
    check_budget();
    for (std::size_t k = 0; k < data_.size(); ++k) values[k] = data[k][row];
    if (!exists(values)) impossible.push_back(row);
  }
  for (const std::size_t row : impossible) {
    found.roads[row] = CaseRoad::in_full;
    for (std::vector<double>& column : found.columns) column[row] = std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace poinsot::problem
