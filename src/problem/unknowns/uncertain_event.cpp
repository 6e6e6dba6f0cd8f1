#include "problem/unknowns/uncertain_event.h"

#include <algorithm>
#include <cmath>

#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/situated.h"

namespace poinsot::problem {
namespace {

bool is_uncertain(Sample& sample, std::size_t situation, const Expression& condition, double time) {
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
}

// What is uncertain of the instant that stands after an @.
std::optional<UncertainEvent> uncertain_instant(Sample& sample, const At& at) {
  const Sample::Home home = sample.resolve(at, at.instant_mark);
  const Situation& situation = sample.statement().situations[home.situation];
  if (situation.has_blow()) return std::nullopt;
  for (const Instant& instant : situation.instants)
    if (home.time && instant.found_when && !at.names.empty() && instant.name == at.names.back() &&
        is_uncertain(sample, home.situation, *instant.found_when, *home.time))
      return UncertainEvent{to_string(*instant.found_when), *home.time};
  if (situation.stages.size() < 2 && !home.ending) return std::nullopt;
  const double time = home.time ? *home.time : sample.motion(home.situation).stage_start(home.instant);
  return uncertain_stage_end(sample, home.situation, time);
}

}  // namespace

std::optional<UncertainEvent> uncertain_event_in(Sample& sample, const Expression& asked) {
  std::optional<UncertainEvent> found;
  if (const At* at = asked.as<At>()) found = uncertain_instant(sample, *at);
  for_each_child(asked, [&](const Expression& child) {
    if (!found) found = uncertain_event_in(sample, child);
  });
  return found;
}

std::optional<UncertainEvent> uncertain_stage_end(Sample& sample, std::size_t situation, double until) {
  const std::vector<Stage>& stages = sample.statement().situations[situation].stages;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const bool found = stages[k].until.has_value();
    // The last stage may have no end, and one that is not reached none that matters.
    if (!found && !stages[k].lasts) return std::nullopt;
    std::optional<double> end;
    try {
      if (sample.motion(situation).stage_start(k) >= until) return std::nullopt;
      end = sample.motion(situation).stage_end(k);
    } catch (const UnansweredError&) {
      // What does not end leads nowhere, and what is asked of the time before does not hang on it.
    }
    if (!end || *end > until) return std::nullopt;
    if (found && is_uncertain(sample, situation, *stages[k].until, *end))
      return UncertainEvent{to_string(*stages[k].until), *end};
  }
  return std::nullopt;
}

std::optional<UncertainEvent> uncertain_event_of(Sample& sample, const Ask& ask, const Value<double>& told) {
  try {
    if (ask.when) {
      const auto [situation, condition] = situated(sample.statement(), ask.when->condition);
      for (const Value<double>& time : told.is_list() ? told.items : std::vector{told}) {
        if (is_uncertain(sample, situation, condition, time.number))
          return UncertainEvent{to_string(condition), time.number};
        if (auto before = uncertain_stage_end(sample, situation, time.number)) return before;
      }
    }
    for (const Expression& asked : ask.of)
      if (auto event = uncertain_event_in(sample, asked)) return event;
  } catch (const StatementError&) {
    // What does not happen is told otherwise.
  }
  return std::nullopt;
}

std::string in_words(const UncertainEvent& event) {
  return "the motion is so sensitive that '" + event.words + "' may happen at quite another time, or never";
}

}  // namespace poinsot::problem
