#include "problem/answers/motion_checks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/situated.h"

namespace poinsot::problem {
namespace {

constexpr double seen_error = 5e-7;  // errors beyond this show in the six digits of an answer

// The error of a motion in the units of the problem.
std::string words_of(const MotionError& error, const Situation& situation) {
  std::string words;
  const auto add = [&](double size, const Dimension& dimension) {
    if (size <= 0) return;
    const Unit unit = situation.habits.unit_for(dimension);
    words += (words.empty() ? "" : " and ") + with_digits(size / unit.factor, 1) + " " + unit.text;
  };
  add(error.angle, dimensions::angle);
  add(error.length, dimensions::length);
  return "the motion is sensitive: its coordinates may be off by " + words;
}

}  // namespace

std::map<std::string, std::string> check_motions(Sample& sample, const std::function<void(const SolvedInstant&)>& look,
                                                 Solution& result) {
  const auto keep = [&](const char* name, double value) {
    auto [entry, fresh] = result.checks.emplace(name, value);
    const bool more = fresh || value > entry->second;
    if (more) entry->second = value;
    return more;
  };
  std::map<std::string, std::string> doubts;
  const auto doubt = [&](const char* name, const std::optional<MotionDoubt>& found) {
    if (found && keep(name, found->value)) doubts[name] = found->words;
  };
  std::map<std::size_t, double> latest;
  for (const auto& [home, instant] : sample.instants())
    if (home.time) latest[home.situation] = std::max(latest[home.situation], *home.time);
  for (const auto& [situation, motion] : sample.motions()) {
    if (const auto drift = motion->energy_drift()) keep("energy_drift", *drift);
    if (const auto misfit = motion->blow_misfit()) keep("impulse", *misfit);
    if (const auto misfit = motion->rough_blow_misfit()) keep("blow", *misfit);
    doubt("course", motion->course_misfit(look));
    doubt("scan", motion->scan_misfit());
    const double at_times = std::max(motion->values_until(), latest[situation]);
    std::optional<MotionError> error = motion->error(std::max(at_times, motion->extremes_until()));
    if (error && error->relative > motion_tolerance && motion->extremes_until() > at_times) {
      // The size of an extreme may be certain although its time is not.
      const double apart = motion->extremes_error();
      if (apart > motion_tolerance) {
        error->relative = apart;
      } else {
        result.notes.push_back("the motion is sensitive: when it comes to the extremes found is not certain");
        error = at_times > 0 ? motion->error(at_times) : std::nullopt;
      }
    }
    if (!error) continue;
    if (error->relative > seen_error && error->relative <= motion_tolerance)
      result.notes.push_back(words_of(*error, motion->situation()));
    keep("motion_error", error->relative);
  }
  return doubts;
}

std::optional<std::string> uncertain_event(Sample& sample, const Ask& ask, const Value<double>& told) {
  const Statement& statement = sample.statement();
  const auto is_uncertain = [&](std::size_t situation, const Expression& condition, double time) {
    const Comparison* comparison = condition.as<Comparison>();
    if (!comparison || !(time > 0)) return false;
    Course& motion = sample.motion(situation);
    const std::optional<MotionError> error = motion.error(time);
    if (!error) return false;
    constexpr double of_time = 1e-3;
    const auto is_within = [&](const Expression& left, const Expression& right, double at) {
      const Value<double> a = motion.value(at, left, {}), b = motion.value(at, right, {});
      if (!a.is_number() || !b.is_number()) return false;
      const auto size = [&] {
        return std::max({size_of(a), size_of(b), sample.instant_at(situation, 0).natural_size(a.dimension)});
      };
      const double off = a.dimension == dimensions::angle    ? error->angle
                         : a.dimension == dimensions::length ? error->length
                                                             : error->relative * size();
      return std::abs(a.number - b.number) < off;
    };
    try {
      for (std::size_t k = 0; k + 1 < comparison->operands.size(); ++k) {
        const Expression &left = comparison->operands[k], &right = comparison->operands[k + 1];
        if (is_within(left, right, time) && is_within(left, right, time * (1 - of_time)) &&
            is_within(left, right, time * (1 + of_time)))
          return true;
      }
    } catch (const StatementError&) {
      // A motion that ends there cannot be looked at a little later.
    }
    return false;
  };
  try {
    if (ask.when) {
      const auto [situation, condition] = situated(statement, ask.when->condition);
      for (const Value<double>& time : told.is_list() ? told.items : std::vector{told})
        if (is_uncertain(situation, condition, time.number)) return to_string(condition);
    }
    std::set<std::string> names;
    for (const Expression& asked : ask.of) collect_instants(asked, names);
    for (std::size_t i = 0; i < statement.situations.size(); ++i)
      for (const Instant& instant : statement.situations[i].instants)
        if (instant.found_when && names.contains(instant.name) &&
            is_uncertain(i, *instant.found_when, sample.motion(i).times(*instant.found_when, {}, 0, {}).front()))
          return to_string(*instant.found_when);
  } catch (const StatementError&) {
    // What does not happen is told otherwise.
  }
  return std::nullopt;
}

}  // namespace poinsot::problem
