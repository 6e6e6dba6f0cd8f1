#include "statement/answer_checks.h"

#include <algorithm>
#include <map>

namespace poinsot::statement {
namespace {

constexpr double check_tolerance = 1e-8;   // residual on the road of particles, relative
constexpr double motion_tolerance = 1e-5;  // error of a motion, relative; as measured some sixteen times what it is

std::string stability_words(const solve::Linearisation& near) {
  char text[60];
  switch (solve::stability(near)) {
    case solve::Stability::unstable:
      std::snprintf(text, sizeof text, "unstable: a disturbance grows as exp(%.4g t/s)", solve::growth_rate(near));
      return text;
    case solve::Stability::undecided:
      return "neither stable nor unstable by the linearised equations, which do not decide it";
    case solve::Stability::stable:
      break;
  }
  std::string words;
  for (double frequency : solve::frequencies(near)) {
    std::snprintf(text, sizeof text, "%.4g", frequency);
    words += (words.empty() ? "" : ", ") + std::string(text);
  }
  return words.empty() ? "stable" : "stable: disturbed, it swings at " + words + " rad/s";
}

}  // namespace

void refuse_unphysical(const Statement& statement, Sample& sample, Solution& result) {
  for (std::size_t i = 0; i < statement.asks.size(); ++i) {
    const Ask& ask = statement.asks[i];
    if (ask.extremum || ask.table || ask.when || result.asks[i].value.is_boolean()) continue;
    if (result.asks[i].state != AskState::found) continue;
    SolvedInstant& instant = sample.instant_of(ask);
    const Problem& problem = sample.problem_of(ask);
    const bool needs_forces = std::any_of(
        ask.of.begin(), ask.of.end(), [&](const Expression& e) { return level_of(problem, e, true) == Level::force; });
    if (!needs_forces || !instant.forces_solved() || result.asks[i].state != AskState::found) continue;
    for (const std::string& reason : instant.unphysical()) {
      result.asks[i].state = AskState::refused;
      result.asks[i].reason = reason;
    }
  }
}

void check_answers(Sample& sample, const std::vector<std::unique_ptr<Sample>>& extremal, Solution& result) {
  std::map<std::size_t, double> latest;
  for (const auto& [home, instant] : sample.instants())
    if (home.time) latest[home.situation] = std::max(latest[home.situation], *home.time);
  // Some instants of each motion.
  for (const auto& [situation, motion] : sample.motions())
    for (const double part : {0.31, 0.67, 1.0}) sample.instant_at(situation, part * motion->reached()).solve_forces();
  std::vector<SolvedInstant*> instants;
  for (const auto& [key, instant] : sample.instants()) instants.push_back(instant.get());
  for (const std::unique_ptr<Sample>& other : extremal)
    for (const auto& [key, instant] : other->instants()) instants.push_back(instant.get());
  for (SolvedInstant* instant : instants) {
    const SolvedInstant::Residuals residuals = instant->check();
    const solve::CheckResult& residual = residuals.particles;
    const auto keep = [&](const char* name, double value) {
      auto [entry, fresh] = result.checks.emplace(name, value);
      if (!fresh) entry->second = std::max(entry->second, value);
    };
    keep("momentum", residual.momentum);
    keep("energy", residual.energy);
    if (instant->forces_solved()) keep("newton_euler", residual.newton_euler);
    if (instant->after_blow()) keep("impulse", residuals.impulse);
  }
  for (const auto& [situation, motion] : sample.motions())
    if (const auto drift = motion->energy_drift()) {
      auto [entry, fresh] = result.checks.emplace("energy_drift", *drift);
      if (!fresh) entry->second = std::max(entry->second, *drift);
    }
  for (const auto& [situation, motion] : sample.motions()) {
    const double at_times = std::max(motion->values_until(), latest[situation]);
    std::optional<MotionError> error = motion->error(std::max(at_times, motion->extremes_until()));
    if (error && error->relative > motion_tolerance && motion->extremes_until() > at_times) {
      // How far an extreme goes does not depend on when it comes.
      result.notes.push_back("the motion is sensitive: when it comes to the extremes found is not certain");
      error = at_times > 0 ? motion->error(at_times) : std::nullopt;
    }
    if (!error) continue;
    auto [entry, fresh] = result.checks.emplace("motion_error", error->relative);
    if (!fresh) entry->second = std::max(entry->second, error->relative);
  }
  for (const auto& [name, residual] : result.checks) {
    const bool of_motion = name == "motion_error";
    if (residual <= (of_motion ? motion_tolerance : check_tolerance)) continue;
    for (SolvedAsk& ask : result.asks) {
      if (ask.state != AskState::found) continue;
      ask.state = AskState::refused;
      if (of_motion) {
        char text[120];
        std::snprintf(text, sizeof text,
                      "the motion is so sensitive that it may be off by %.1g of its size: let it last shorter",
                      residual);
        ask.reason = text;
        continue;
      }
      ask.reason = "the independent check with particles does not confirm it (" + name + " off by " +
                   std::to_string(residual) + ")";
    }
  }
}

void add_notes(const Statement& statement, const Sample& sample, Solution& result) {
  for (const auto& [home, instant] : sample.instants()) {
    const Situation& situation = statement.situations[home.situation];
    if (!situation.problem.steady || home.time || home.instant > 0) continue;
    try {
      result.notes.push_back("the steady motion" + (situation.name.empty() ? "" : " @ " + situation.name) + " is " +
                             stability_words(instant->linearisation(situation.problem.steady->mark)));
    } catch (const StatementError&) {
      // The statement does not say enough of what holds the motion: stability is not told.
    }
  }
  for (const auto& [situation, motion] : sample.motions()) {
    result.notes.insert(result.notes.end(), motion->happenings().begin(), motion->happenings().end());
    const std::string& name = statement.situations[situation].name;
    for (const std::string& method : motion->methods())
      result.notes.push_back("the motion" + (name.empty() ? "" : " @ " + name) + ": " + method);
  }
}

}  // namespace poinsot::statement
