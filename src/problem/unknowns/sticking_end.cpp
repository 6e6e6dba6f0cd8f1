#include "problem/unknowns/sticking_end.h"

#include <algorithm>
#include <cmath>

#include "problem/instant/sticking_margin.h"
#include "problem/unknowns/extremum.h"
#include "problem/witness/beyond_sticking.h"

namespace poinsot::problem {

std::optional<double> sticking_end(const std::function<std::optional<double>(double)>& margin, double inside,
                                   double outside) {
  constexpr double by_rounding = 1e-7;  // of the largest force: above what is allowed where sticking is decided
  const std::optional<double> here = margin(inside);
  if (!here || !(*here < 0) || *here < -by_rounding) return std::nullopt;
  double off = inside, margin_off = *here;
  const double inwards = inside > outside ? std::abs(inside) : -std::abs(inside);
  constexpr double nearest = 1e-10, farthest = 1e-2;  // of the value
  std::optional<double> on, margin_on;
  for (double part = nearest; part <= farthest && !on; part *= 10) {
    const double value = inside + part * inwards;
    margin_on = margin(value);
    if (!margin_on) return std::nullopt;
    if (*margin_on > 0) {
      on = value;
    } else {
      off = value;
      margin_off = *margin_on;
    }
  }
  if (!on) return std::nullopt;
  // Regula falsi, with the half of a margin that stays (the Illinois method).
  double value_on = *on, weight_on = *margin_on;
  constexpr int most = 60;
  constexpr double together = 2e-15;
  for (int i = 0; i < most && std::abs(off - value_on) > together * std::abs(value_on); ++i) {
    const double between = value_on + (off - value_on) * weight_on / (weight_on - margin_off);
    if (between == value_on) break;
    // The end lies there but for the rounding of the margin.
    if (between == off) return off;
    const std::optional<double> found = margin(between);
    if (!found) return std::nullopt;
    if (*found >= 0) {
      value_on = between;
      weight_on = *found;
      margin_off /= 2;
      if (*found == 0) break;
    } else {
      off = between;
      margin_off = *found;
      weight_on /= 2;
    }
  }
  return value_on;
}

std::optional<double> margin_of_sticking(const Sample& sample) {
  std::optional<double> least;
  for (const auto& [home, instant] : sample.instants())
    if (const std::optional<double> margin = sticking_margin(*instant))
      least = std::min(least.value_or(*margin), *margin);
  return least;
}

std::optional<bool> none_shares(const Sample& sample) {
  std::optional<bool> none;
  for (const auto& [home, instant] : sample.instants())
    if (const std::optional<bool> found = sticks_in_no_share(*instant)) none = none.value_or(false) || *found;
  return none;
}

std::optional<double> ExtremumSearch::sticking_ends(double inside, double outside) {
  failed_ = nullptr;
  if (choice_.trial || truth_at(outside) != Truth::fails || !failed_) return std::nullopt;
  const Expression& sticking = *failed_;
  if (const Call* call = sticking.as<Call>(); !call || call->function != "sticking") return std::nullopt;
  if (!seeks_states_ && settings_at(inside, statement_).size() != 1) return std::nullopt;
  for (const Found& found : found_at(inside)) {
    const std::shared_ptr<const Statement>& statement = found.statement;
    if (Sample here(statement, found.settings, choice_); !conditions_hold_in(here)) continue;
    const auto margin = [&](double value) -> std::optional<double> {
      try {
        const std::vector<AllSettings> beside = settings_at(value, *statement);
        if (beside.size() != 1) return std::nullopt;
        Sample there(statement, beside.front(), choice_);
        there.value_in(situation_of(statement_, ask_), sticking);
        return margin_of_sticking(there);
      } catch (const StatementError&) {
        return std::nullopt;
      }
    };
    return sticking_end(margin, inside, outside);
  }
  return std::nullopt;
}

// Whether contacts that stick at an end would do so beyond it as well, by the second road to the laws of friction. What
// a state is found by is not that road, and at an end that lies too near it would be confirmed. Where contacts share a
// load, that one share slides says nothing: then all of them must.
bool ExtremumSearch::sticks_beyond(double end) try {
  if (!situation_.has_friction() || choice_.trial) return false;
  // The farthest is so far beyond that the limit is passed by far more than the rounding to which it is reached.
  constexpr double farthest = 1e-3, clearly = 10, nothing_left = 1e-12;
  const auto friction_off = [](const Sample& sample) {
    double off = 0;
    for (const auto& [home, instant] : sample.instants()) off = std::max(off, instant->check().friction.value_or(0));
    return off;
  };
  for (const Found& found : found_at(end)) {
    const std::shared_ptr<const Statement>& statement = found.statement;
    Sample here(statement, found.settings, choice_);
    if (!conditions_hold_in(here)) continue;
    bool shared = false;
    for (double part = 1e-6; part <= 1.5 * farthest && !shared; part *= 10)
      for (const AllSettings& beside : settings_at(
               end + (ask_.extremum->largest ? part : -part) * (end != 0 ? std::abs(end) : span().scale), *statement)) {
        Sample there(statement, beside, choice_);
        if (conditions_hold_in(there)) continue;
        const Call* failed = failed_->as<Call>();
        if (!failed || failed->function != "sticking") continue;
        if (const std::optional<bool> none = none_shares(there)) {
          if (!*none) return true;
          shared = true;
        } else if (10 * part > 1.5 * farthest && friction_off(there) <= clearly * friction_off(here) + nothing_left) {
          return true;
        }
      }
    return false;
  }
  return false;
} catch (const StatementError&) {
  return false;  // What is stated ends there.
}

}  // namespace poinsot::problem
