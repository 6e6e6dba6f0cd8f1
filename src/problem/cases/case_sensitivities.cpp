// Derivatives of the answers of many cases by differences of solutions, where no program tells them, and as the second
// road to those that programs tell.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "poinsot/engine/work/budget.h"
#include "problem/cases/cases.h"
#include "problem/cases/instant_rows.h"

namespace poinsot::problem {
namespace {

// The first step, of the size of the datum. Solutions are good to some twelve digits, of which differences over a
// quarter of this leave eight; what three steps leave of the higher derivatives is of the sixth order in it.
constexpr double first_step = 2e-3;
constexpr std::size_t steps = 3;
// A datum that is smaller than this part of its usual value changes by that part.
constexpr double small_part = 1e-3;
// Of its own size and of the size of the answer over that of the datum: how far a derivative may be open.
constexpr double well_known = 1e-6;

double size_of(const VariedDatum& datum, double value, const std::vector<double>& usual, std::size_t place) {
  if (datum.dimension == dimensions::angle) return 1;
  return std::max(std::fabs(value), place < usual.size() ? small_part * std::fabs(usual[place]) : 0);
}

}  // namespace

std::string CompiledCases::answers_at(const std::vector<double>& data, std::vector<double>& numbers) const {
  check_budget();
  Columns one;
  for (const double& value : data) one.emplace_back(&value, 1);
  if (by_instants_)
    if (auto found = instant_numbers(statement_, settings_at(one, 0)); found && found->size() == answers_) {
      numbers = std::move(*found);
      return "";
    }
  // Solutions beside those that are told.
  return solve_row(one, 0, Purpose::compared, numbers);
}

std::string CompiledCases::differences(const Columns& data, std::size_t row, std::size_t datum,
                                       const std::vector<double>& here, Differences& found) const {
  const VariedDatum& varied = data_[datum];
  const double value = data[datum][row], size = size_of(varied, value, usual_, datum);
  if (!(size > 0))
    return fmt::format(
        "it is not known how large changes of '{}' are: it is zero here, and no other size of it is known",
        varied.name);
  std::vector<double> beside;
  for (const std::span<const double>& column : data) beside.push_back(column[row]);
  // Richardson's extrapolation: quotients[i] is over a step of first_step / 2^i.
  std::array<std::vector<double>, steps> quotients, bends;
  for (std::size_t i = 0; i < steps; ++i) {
    const double step = first_step * size / std::ldexp(1.0, static_cast<int>(i));
    std::array<std::vector<double>, 2> ends;
    std::array<double, 2> places{};
    for (std::size_t end = 0; end < 2; ++end) {
      places[end] = beside[datum] = end == 0 ? value - step : value + step;
      if (const std::string reason = answers_at(beside, ends[end]); !reason.empty())
        return fmt::format("where {} is {}: {}", varied.name, setting_text(varied, places[end]), reason);
    }
    for (std::size_t k = 0; k < answers_; ++k) {
      quotients[i].push_back((ends[1][k] - ends[0][k]) / (places[1] - places[0]));
      bends[i].push_back(std::fabs((ends[1][k] - here[k]) - (here[k] - ends[0][k])) / (places[1] - places[0]));
    }
  }
  found = {};
  for (std::size_t k = 0; k < answers_; ++k) {
    const double fourth = (4 * quotients[1][k] - quotients[0][k]) / 3,
                 finer = (4 * quotients[2][k] - quotients[1][k]) / 3;
    found.value.push_back((16 * finer - fourth) / 15);
    found.doubt.push_back(std::fabs(found.value.back() - finer));
    // The slopes on both sides come together as the step shrinks, but for a corner, whose quotients may well agree.
    if (bends[steps - 1][k] > bends[0][k] / 2) found.doubt.back() += bends[steps - 1][k];
  }
  return "";
}

void CompiledCases::add_differences(const Columns& data, SolvedCases& found) const {
  if (by_.empty()) return;
  std::size_t next_reason = 0;
  std::vector<std::pair<std::size_t, std::string>> reasons;
  for (std::size_t row = 0; row < found.roads.size(); ++row) {
    if (next_reason < found.reasons.size() && found.reasons[next_reason].first == row) {
      reasons.push_back(std::move(found.reasons[next_reason++]));
      continue;
    }
    if (!std::isnan(found.columns[answers_][row])) continue;
    std::string missing;
    std::vector<double> here;
    for (std::size_t k = 0; k < answers_; ++k) here.push_back(found.columns[k][row]);
    for (std::size_t i = 0; i < by_.size(); ++i) {
      Differences by;
      std::string reason = differences(data, row, by_[i], here, by);
      for (std::size_t k = 0; k < answers_ && reason.empty(); ++k) {
        const double slope =
            std::max(std::fabs(by.value[k]),
                     std::fabs(found.columns[k][row]) / size_of(data_[by_[i]], data[by_[i]][row], usual_, by_[i]));
        if (!(by.doubt[k] <= well_known * slope))
          reason = fmt::format("differences do not settle on how {} changes", columns_[k].name);
      }
      if (reason.empty())
        for (std::size_t k = 0; k < answers_; ++k) found.columns[(i + 1) * answers_ + k][row] = by.value[k];
      else
        missing += (missing.empty() ? "" : "; ") + fmt::format("by {}: {}", data_[by_[i]].name, reason);
    }
    if (!missing.empty()) reasons.emplace_back(row, std::move(missing));
  }
  found.reasons = std::move(reasons);
}

bool CompiledCases::derivatives_differ(const Columns& data, std::size_t row, const SolvedCases& found) const {
  std::vector<double> here;
  for (std::size_t k = 0; k < answers_; ++k) here.push_back(found.columns[k][row]);
  for (std::size_t i = 0; i < by_.size(); ++i) {
    Differences by;
    // At the edge of what has an answer there are no differences: the answers themselves were compared.
    if (std::isnan(found.columns[(i + 1) * answers_][row]) || !differences(data, row, by_[i], here, by).empty())
      continue;
    const double size = size_of(data_[by_[i]], data[by_[i]][row], usual_, by_[i]);
    for (std::size_t k = 0; k < answers_; ++k) {
      const double told = found.columns[(i + 1) * answers_ + k][row];
      const double slope = std::max(std::fabs(by.value[k]), std::fabs(found.columns[k][row]) / size);
      if (!(std::fabs(told - by.value[k]) <= well_known * slope + 2 * by.doubt[k])) return true;
    }
  }
  return false;
}

}  // namespace poinsot::problem
