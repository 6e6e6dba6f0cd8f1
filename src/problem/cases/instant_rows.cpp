#include "problem/cases/instant_rows.h"

#include <algorithm>
#include <cmath>

#include "problem/answers/answer_checks.h"
#include "problem/course/course.h"
#include "problem/language/diagnostic.h"
#include "problem/quantities/quantity_functions.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/asked_value.h"
#include "problem/unknowns/unknown_search.h"

namespace poinsot::problem {
namespace {

bool asks_an_instant(const Ask& ask) {
  return !ask.of.empty() && !ask.extremum && !ask.table && !ask.when && !ask.is_list &&
         std::ranges::none_of(ask.of, asks_motion_feature);
}

// Whether everything at the instants that were solved is determined and physical.
bool nothing_is_open(Sample& sample) {
  if (!sample.motions().empty()) return false;
  return std::ranges::all_of(sample.instants(), [](const auto& entry) {
    const SolvedInstant& instant = *entry.second;
    return !instant.uses_any() && instant.velocities().open.empty() &&
           !(instant.after_blow() && !instant.blow().open.empty()) &&
           !(instant.forces_solved() && (!instant.motion().open.empty() || !instant.one_sided_faults().empty()));
  });
}

// Adds the numbers of a value, with those that are rounding as zero; false if it has none.
bool add_numbers(const Value<double>& value, double size, std::vector<double>& numbers) {
  // Of the natural size of the answer: where terms of that size cancel, this much is left of them.
  constexpr double rounding = 1e-15;
  const auto add = [&](double number) {
    numbers.push_back(std::fabs(number) <= rounding * size ? 0.0 : number);
    return std::isfinite(number);
  };
  if (value.is_number()) return add(value.number);
  if (!value.is_vector()) return false;
  bool finite = true;
  for (std::size_t k = 0; k < 3; ++k) finite = add(value.vector[k]) && finite;
  return finite;
}

double size_in(Sample& sample, const Ask& ask, const Value<double>& value) {
  return std::max(size_of(value), sample.instant_of(ask).natural_size(dimension_of(value)));
}

constexpr double on_earth = 10;  // m/s^2, where nothing accelerates

bool leaves_gravity_open(const Statement& statement) {
  return std::ranges::any_of(statement.situations, [](const Situation& s) { return !s.gravity; });
}

// Whether gravity of which nothing is said changes none of the values. It is varied by the size of what accelerates the
// machine: beside a larger one the rest would drown in rounding.
bool are_the_same_under_gravity(const Statement& statement, const AllSettings& settings, Sample& sample,
                                const std::vector<Value<double>>& values) {
  constexpr double same_answer = 1e-9;  // of its size, as for the variations of a full solution
  double size = 0;
  for (const auto& [home, instant] : sample.instants())
    size = std::max(size, instant->natural_size(dimensions::acceleration));
  Sample varied(statement, settings, {.seed = 12, .gravity = size > 0 ? size : on_earth});
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Ask& ask = statement.asks[i];
    const Value<double> other = asked_value(varied, ask);
    if (!same(values[i], other, same_answer * size_in(sample, ask, values[i]))) return false;
  }
  return true;
}

}  // namespace

bool asks_instants_alone(const Statement& statement) { return std::ranges::all_of(statement.asks, asks_an_instant); }

bool needs_instants_alone(const Statement& statement) {
  return std::ranges::all_of(statement.situations,
                             [](const Situation& situation) {
                               return situation.find.empty() && situation.choose.empty() && !has_later_facts(situation);
                             }) &&
         asks_instants_alone(statement);
}

std::optional<std::vector<double>> instant_numbers(const Statement& statement, const AllSettings& settings) {
  try {
    Sample sample(statement, settings, OpenChoice{});
    std::vector<Value<double>> values;
    std::vector<double> numbers;
    for (const Ask& ask : statement.asks) {
      values.push_back(asked_value(sample, ask));
      if (!add_numbers(values.back(), size_in(sample, ask, values.back()), numbers)) return std::nullopt;
    }
    if (!nothing_is_open(sample)) return std::nullopt;
    if (leaves_gravity_open(statement) && !are_the_same_under_gravity(statement, settings, sample, values))
      return std::nullopt;
    return numbers;
  } catch (const StatementError&) {
    return std::nullopt;  // A full solution says what is wrong.
  }
}

bool may_be_confirmed(const Statement& statement) {
  return std::ranges::all_of(statement.situations,
                             [](const Situation& situation) {
                               return situation.choose.empty() && situation.neglect.empty() &&
                                      !has_later_facts(situation);
                             }) &&
         asks_instants_alone(statement);
}

std::optional<std::vector<double>> confirmed_numbers(const Statement& statement, const Settings& settings) {
  const OpenChoice all{.seed = 12,
                       .gravity = leaves_gravity_open(statement) ? on_earth : 0,
                       .velocities = true,
                       .forces = true,
                       .direction = OpenChoice::every};
  try {
    AllSettings found(statement.situations.size(), settings);
    const auto finds = [](const Situation& situation) { return !situation.find.empty(); };
    if (std::ranges::any_of(statement.situations, finds)) {
      UnknownSearch search(statement, settings);
      RootsFound roots = search.find(settings, all);
      if (roots.roots.size() != 1 || !roots.open.empty()) return std::nullopt;
      found = std::move(roots.roots.front());
    }
    Sample sample(statement, std::move(found), all);
    sample.write_down_what_is_told();
    Solution solution;
    std::vector<double> numbers;
    for (const Ask& ask : statement.asks) {
      SolvedAsk& solved = solution.asks.emplace_back();
      solved.value = asked_value(sample, ask);
      if (!add_numbers(solved.value, size_in(sample, ask, solved.value), numbers)) return std::nullopt;
    }
    check_answers(statement, sample, {}, solution);
    const auto is_found = [](const SolvedAsk& ask) { return ask.state == AskState::found; };
    const auto holds = [](const auto& entry) {
      return !entry.second->uses_any() && (!entry.second->forces_solved() || entry.second->one_sided_faults().empty());
    };
    if (solution.refused || !std::ranges::all_of(solution.asks, is_found) || !sample.motions().empty() ||
        !std::ranges::all_of(sample.instants(), holds))
      return std::nullopt;
    return numbers;
  } catch (const StatementError&) {
    return std::nullopt;
  }
}

}  // namespace poinsot::problem
