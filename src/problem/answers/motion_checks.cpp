#include "problem/answers/motion_checks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "problem/language/words.h"

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

}  // namespace poinsot::problem
