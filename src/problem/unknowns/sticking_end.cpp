#include "problem/unknowns/sticking_end.h"

#include <algorithm>
#include <cmath>

#include "problem/instant/sticking_margin.h"
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
    if (between == value_on || between == off) break;
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

}  // namespace poinsot::problem
