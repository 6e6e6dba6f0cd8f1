#include "problem/course/motion_witness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "problem/language/diagnostic.h"

namespace poinsot::problem {
namespace {

// Gauss's rule of five points on [-1, 1]; those to the left are their mirror images.
struct GaussPoint {
  double at, weight;
};
constexpr std::array<GaussPoint, 5> gauss{{{-0.906179845938663992797626878299, 0.236926885056189087514264040720},
                                           {-0.538469310105683091036314420700, 0.478628670499366468041291514836},
                                           {0, 0.568888888888888888888888888889},
                                           {0.538469310105683091036314420700, 0.478628670499366468041291514836},
                                           {0.906179845938663992797626878299, 0.236926885056189087514264040720}}};

// The part of its size by which what changes less in a window is measured: the states are followed to some 1e-12 of
// their sizes, and of this part that is 1e-9.
constexpr double measured_by = 1e-3;

}  // namespace

// By turns of the golden section, which no steps of a search fall on.
double spread_evenly(std::size_t k) {
  const double turns = (static_cast<double>(k) + 0.5) * (std::numbers::phi - 1);
  return turns - std::floor(turns);
}

std::vector<std::size_t> spread_order(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, spread_evenly);
  return order;
}

std::optional<double> window_misfit(const std::function<std::optional<WitnessedState>(double)>& state_at, double from,
                                    double to, const NaturalSizes& sizes) {
  const std::optional<WitnessedState> start = state_at(from), end = state_at(to);
  if (!start || !end) return std::nullopt;
  const double half = 0.5 * (to - from);
  const std::size_t positions = start->q.size(), velocities = start->v.size();
  std::vector<double> q_change(positions, 0), v_change(velocities, 0), q_size(positions, 0), v_size(velocities, 0);
  std::vector<bool> known = start->rate_known;
  for (const GaussPoint& point : gauss) {
    const std::optional<WitnessedState> then = state_at(0.5 * (from + to) + half * point.at);
    if (!then) return std::nullopt;
    for (std::size_t k = 0; k < positions; ++k) {
      q_change[k] += half * point.weight * then->q_rate[k];
      q_size[k] += half * point.weight * std::abs(then->q_rate[k]);
    }
    for (std::size_t k = 0; k < velocities; ++k) {
      known[k] = known[k] && then->rate_known[k];
      v_change[k] += half * point.weight * then->v_rate[k];
      v_size[k] += half * point.weight * std::abs(then->v_rate[k]);
    }
  }
  // The fastest that anything moves, or comes to move in the window. What has come nearly to rest is followed to a part
  // of what it was: its own last digits are nothing.
  constexpr double nearly_at_rest = 1e-3;
  double pace = nearly_at_rest * sizes.pace;
  for (std::size_t k = 0; k < velocities; ++k)
    pace = std::max(pace, std::max({std::abs(start->v[k]), std::abs(end->v[k]), v_size[k]}) / sizes.of_v[k]);
  double worst = 0;
  const auto compare = [&](double change, double told, double size) {
    const double misfit = std::abs(change - told);
    if (!std::isfinite(misfit)) worst = std::numeric_limits<double>::infinity();
    if (size > 0) worst = std::max(worst, misfit / size);
  };
  for (std::size_t k = 0; k < positions; ++k)
    compare(end->q[k] - start->q[k], q_change[k],
            q_size[k] + measured_by * std::max(sizes.of_q[k], std::abs(start->q[k])));
  for (std::size_t k = 0; k < velocities; ++k)
    if (known[k]) compare(end->v[k] - start->v[k], v_change[k], v_size[k] + measured_by * pace * sizes.of_v[k]);
  return worst;
}

MotionScan::MotionScan(const std::function<double(double)>& number, double from, double to, std::size_t count)
    : number_(number), from_(from), to_(to) {
  // What happens soon after the start is short beside all the rest.
  constexpr double nearer = 1.0 / 20;
  const std::size_t near_start = std::min<std::size_t>(count / 4, 8);
  double part = 1;
  for (std::size_t k = 0; k < near_start; ++k) time_.push_back(from + (to - from) * (part *= nearer));
  for (std::size_t k = 0; k < count - near_start; ++k) time_.push_back(from + (to - from) * spread_evenly(k));
  std::ranges::sort(time_);
  std::erase_if(time_, [&](double time) {
    const std::optional<double> value = at(time);
    if (value) value_.push_back(*value);
    return !value;
  });
  if (value_.empty()) return;
  const auto [low, high] = std::ranges::minmax(value_);
  low_ = low;
  high_ = high;
  // A number that hardly changes is measured by a part of itself.
  constexpr double of_itself = 1e-3;
  size_ = std::max(high - low, of_itself * std::max(std::abs(high), std::abs(low)));
}

std::optional<double> MotionScan::at(double time) const {
  try {
    const double value = number_(time);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  } catch (const StatementError&) {
    // Where a quantity has no value, as beside the pole of Eulerian angles, nothing is told of it.
    return std::nullopt;
  }
}

ScanMisfit MotionScan::of_extreme(const ExtremeFound& told, bool largest, double natural) const {
  ScanMisfit worst;
  // What is zero throughout is rounding of its terms.
  constexpr double rounding = 1e-14;
  if (std::max({std::abs(low_), std::abs(high_), std::abs(told.value)}) <= rounding * natural) return worst;
  const double size = std::max({size_, told.value - low_, high_ - told.value});
  if (value_.empty() || !(size > 0)) return worst;
  // It is taken at the time that is told with it, and nowhere exceeded.
  if (const std::optional<double> there = at(told.time)) worst = {std::abs(*there - told.value) / size, told.time};
  const double sign = largest ? 1 : -1;
  for (std::size_t i = 0; i < value_.size(); ++i)
    if (const double beyond = sign * (value_[i] - told.value) / size; beyond > worst.value) worst = {beyond, time_[i]};
  return worst;
}

ScanMisfit MotionScan::of_zeros(const std::vector<double>& told, int sense) const {
  ScanMisfit worst;
  if (!(size_ > 0)) return worst;
  // The number is zero at each time that is told, or jumps there from one sign to the other.
  const double beside = 1e-9 * (to_ - from_);
  for (const double time : told) {
    if (time <= from_) continue;
    const std::optional<double> there = at(time), before = at(std::max(from_, time - beside)),
                                after = at(time + beside);
    if (!there || (before && after && (*before < 0) != (*after < 0))) continue;
    // Just after the time of a truth, which is one or minus one, what tells it may be rounding still: how a contact
    // slips that begins to.
    const auto is_truth = [](const std::optional<double>& value) { return value && std::abs(*value) == 1; };
    const auto turns = [&](double part) {
      const std::optional<double> then = at(time + part * (to_ - from_));
      return is_truth(then) && (*before < 0) != (*then < 0);
    };
    constexpr double near = 1e-6, beyond = 1e-4;  // of the time that is looked at
    if (is_truth(there) && is_truth(before) && (turns(near) || turns(beyond))) continue;
    if (const double off = std::abs(*there) / size_; off > worst.value) worst = {off, time};
  }
  // Where it changes its sign between two looks, a time between them is told.
  for (std::size_t i = 0; i + 1 < value_.size(); ++i) {
    const double a = value_[i], b = value_[i + 1];
    const bool rises = a < 0 && b > 0, falls = a > 0 && b < 0;
    if (!((sense >= 0 && rises) || (sense <= 0 && falls))) continue;
    if (std::ranges::any_of(told, [&](double time) { return time >= time_[i] && time <= time_[i + 1]; })) continue;
    if (const double off = std::min(std::abs(a), std::abs(b)) / size_; off > worst.value) worst = {off, time_[i]};
  }
  return worst;
}

std::optional<MotionDoubt> doubt_before_giving_way(const std::vector<HeldStretch>& stretches,
                                                   const std::function<std::optional<MotionDoubt>(double)>& doubt_at) {
  constexpr std::size_t most_given_way = 24;  // that are looked at, the first ones
  constexpr double just_before = 1e-3;        // of the last step
  std::optional<MotionDoubt> worst;
  std::size_t gave_way = 0;
  for (std::size_t i = 0; i + 1 < stretches.size() && gave_way < most_given_way; ++i) {
    const std::vector<bool>&before = stretches[i].acting, &after = stretches[i + 1].acting;
    bool lost = false;
    for (std::size_t k = 0; k < before.size() && k < after.size(); ++k) lost = lost || (before[k] && !after[k]);
    if (!lost || !(stretches[i].last_step > 0)) continue;
    ++gave_way;
    const std::optional<MotionDoubt> doubt = doubt_at(stretches[i].end - just_before * stretches[i].last_step);
    if (doubt && (!worst || doubt->value > worst->value)) worst = doubt;
  }
  return worst;
}

ScanMisfit MotionScan::of_zero() const {
  ScanMisfit worst;
  for (std::size_t i = 0; i < value_.size(); ++i)
    if (const double off = std::abs(value_[i]); off > worst.value) worst = {off, time_[i]};
  return worst;
}

ScanMisfit MotionScan::of_period(double told) const {
  ScanMisfit worst;
  if (!(size_ > 0)) return worst;
  constexpr std::size_t looks = 24;
  constexpr int most_parts = 13;  // the largest prime that is tried
  // What repeats after a part of the period as well as after all of it would have that for its period. Of the size of
  // the number: motions repeat to 1e-7 after some periods, and a part of a period changes them in the first digits.
  constexpr double same = 1e-6;
  for (std::size_t k = 0; k < looks; ++k) {
    const double time = from_ + std::max(0.0, to_ - told - from_) * spread_evenly(k);
    const std::optional<double> now = at(time), then = at(time + told);
    if (!now || !then) continue;
    if (const double off = std::abs(*then - *now) / size_; off > worst.value) worst = {off, time};
  }
  for (const int parts : {2, 3, 5, 7, 11, most_parts}) {
    double apart = 0;
    for (std::size_t k = 0; k < looks && apart <= same; ++k) {
      const double time = from_ + told * spread_evenly(k);
      const std::optional<double> now = at(time), then = at(time + told / parts);
      apart = now && then ? std::max(apart, std::abs(*then - *now) / size_) : 1;
    }
    if (apart <= same) return {1, from_ + told / parts};
  }
  return worst;
}

}  // namespace poinsot::problem
