#include "problem/course/motion_features.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "problem/course/course.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {
namespace {

constexpr int per_step = 6;             // samples in a step of the integration
constexpr double repeats_to = 1e-7;     // relative difference with which a motion that repeats must return
constexpr std::size_t most_rises = 40;  // within one period
constexpr std::size_t most_samples = 2'000'000;
constexpr std::size_t samples_of_wait = 60'000;  // until something must happen in a motion without end
constexpr double long_enough = 500;              // in pace times: a disturbance takes this long to grow

[[noreturn]] void unanswered(const std::string& file, const Mark& mark, const std::string& message,
                             const std::string& hint = "") {
  throw UnansweredError(file, mark, message, hint);
}

}  // namespace

MotionFeatures::Sampled MotionFeatures::samples(double from, double to) const {
  Sampled sampled;
  const std::vector<double> nodes = motion_.nodes(from, to);
  if (nodes.size() * per_step > most_samples) {
    char text[60];
    std::snprintf(text, sizeof text, " up to %.4g s", to);
    unanswered(file_, mark_, "'" + words_ + "' has no answer in the motion" + text + ", and it is too long to go on",
               motion_.end() ? "let it last shorter" : "say how long the motion lasts: stages: {run: {lasts: 10 s}}");
  }
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    for (int k = 0; k < per_step; ++k) sampled.time.push_back(nodes[i] + (nodes[i + 1] - nodes[i]) * k / per_step);
  sampled.time.push_back(nodes.back());
  // The samples of an earlier question are the beginning of those for this one.
  std::size_t known = 0;
  while (known < sampled.time.size() && known < sampled_.time.size() && sampled.time[known] == sampled_.time[known])
    sampled.value.push_back(sampled_.value[known++]);
  for (std::size_t i = known; i < sampled.time.size(); ++i) sampled.value.push_back(number_(sampled.time[i]));
  if (from == 0) sampled_ = sampled;
  return sampled;
}

ExtremeFound MotionFeatures::polished(const Rough& rough, bool largest) const {
  const double sign = largest ? 1 : -1;
  ExtremeFound best{number_(rough.middle), rough.middle};
  const std::optional<ExtremeFound> smooth = level_between(rough.before, rough.after);
  if (smooth && rough.smooth && sign * smooth->value >= sign * best.value) return *smooth;
  // There may be a corner, where loads change or a speed becomes zero; the slope does not vanish there.
  const ExtremeFound corner = outermost_between(rough.before, rough.after, largest);
  if (sign * corner.value > sign * best.value) best = corner;
  const double rounding = 1e-12 * std::abs(best.value);
  return smooth && sign * smooth->value >= sign * best.value - rounding ? *smooth : best;
}

// The extreme at which the slope vanishes: a zero of the rate, or if that is not known, of differences of sixth
// order. Nothing if the slope does not change sign.
std::optional<ExtremeFound> MotionFeatures::level_between(double before, double after) const {
  const double h = 0.05 * (after - before);
  const auto slope = [&](double t) {
    if (rate_) return rate_(t);
    return (45 * (number_(t + h) - number_(t - h)) - 9 * (number_(t + 2 * h) - number_(t - 2 * h)) +
            (number_(t + 3 * h) - number_(t - 3 * h))) /
           (60 * h);
  };
  if (!rate_ && before - 3 * h < 0) return std::nullopt;
  try {
    const double a = slope(before), b = slope(after);
    if ((a < 0) == (b < 0)) return std::nullopt;
    std::uintmax_t iterations = 60;
    const auto bracket = boost::math::tools::toms748_solve(slope, before, after, a, b,
                                                           boost::math::tools::eps_tolerance<double>(50), iterations);
    const double time = 0.5 * (bracket.first + bracket.second);
    return ExtremeFound{number_(time), time};
  } catch (const StatementError&) {
    // A difference would reach beyond the end of the motion.
    return std::nullopt;
  }
}

// The only extreme in a bracket, whether there is a corner or not. It is sought in units of the bracket, so that a
// corner far from time zero is found as precisely as one near it.
ExtremeFound MotionFeatures::outermost_between(double before, double after, bool largest) const {
  std::uintmax_t iterations = 100;
  const double half = 0.5 * (after - before), center = 0.5 * (after + before);
  const auto found = boost::math::tools::brent_find_minima(
      [&](double x) { return largest ? -number_(center + half * x) : number_(center + half * x); }, -1.0, 1.0, 50,
      iterations);
  return {largest ? -found.second : found.second, center + half * found.first};
}

std::vector<MotionFeatures::Rough> MotionFeatures::rough_extremes(const Sampled& sampled, bool largest) const {
  std::vector<Rough> found;
  const double sign = largest ? 1 : -1;
  const auto bend_at = [&](std::size_t i) {
    const double x1 = sampled.time[i - 1] - sampled.time[i], x2 = sampled.time[i + 1] - sampled.time[i];
    return sign * ((sampled.value[i + 1] - sampled.value[i]) / x2 - (sampled.value[i - 1] - sampled.value[i]) / x1) /
           (x2 - x1);
  };
  for (std::size_t i = 1; i + 1 < sampled.value.size(); ++i) {
    const double before = sign * sampled.value[i - 1], here = sign * sampled.value[i],
                 after = sign * sampled.value[i + 1];
    if (!(here >= before && here > after)) continue;
    // The value at the vertex of the parabola through three samples.
    const double x1 = sampled.time[i - 1] - sampled.time[i];
    const double bend = bend_at(i), slope = (before - here) / x1 - bend * x1;
    const double more = bend < 0 ? -slope * slope / (4 * bend) : 0;
    const double drop = here - std::min(before, after);
    // The curvature is similar at neighbouring samples if the function is smooth. At a corner the value may go as far
    // as the sides lead.
    const bool smooth = (i < 2 || 2 * std::abs(bend_at(i - 1) - bend) < std::abs(bend)) &&
                        (i + 2 >= sampled.value.size() || 2 * std::abs(bend_at(i + 1) - bend) < std::abs(bend));
    found.push_back({sampled.time[i - 1], sampled.time[i], sampled.time[i + 1], sign * (here + more),
                     0.1 * std::abs(more) + (smooth ? 0.01 : 1) * drop, smooth});
  }
  return found;
}

std::vector<ExtremeFound> MotionFeatures::extremes(const Sampled& sampled, bool largest) const {
  std::vector<ExtremeFound> found;
  for (const Rough& rough : rough_extremes(sampled, largest)) found.push_back(polished(rough, largest));
  return found;
}

// The outermost extreme, if its value occurs again. It is found among the extremes that may be as far out.
std::optional<ExtremeFound> MotionFeatures::met_twice(const Sampled& sampled, bool largest, double range) const {
  const double sign = largest ? 1 : -1;
  std::vector<Rough> rough = rough_extremes(sampled, largest);
  std::stable_sort(rough.begin(), rough.end(),
                   [&](const Rough& a, const Rough& b) { return sign * a.estimate > sign * b.estimate; });
  std::vector<ExtremeFound> found;
  double outermost = -INFINITY;
  for (const Rough& one : rough) {
    const auto same = [&](const ExtremeFound& extreme) {
      return std::abs(extreme.value - sign * outermost) <= repeats_to * range;
    };
    const bool twice = std::count_if(found.begin(), found.end(), same) >= 2;
    // Once two agree, only an extreme that clearly lies farther out is of interest.
    const double far = sign * one.estimate, same_as = repeats_to * range;
    if (twice && far - one.doubt <= outermost + same_as) break;
    if (far + one.doubt < outermost - same_as) continue;
    found.push_back(polished(one, largest));
    outermost = std::max(outermost, sign * found.back().value);
  }
  std::optional<ExtremeFound> first;
  int count = 0;
  for (const ExtremeFound& extreme : found) {
    if (std::abs(extreme.value - sign * outermost) > repeats_to * range) continue;
    ++count;
    if (!first || extreme.time < first->time) first = extreme;
  }
  return count >= 2 ? first : std::nullopt;
}

// The largest or smallest value of a motion with an end, including both ends.
ExtremeFound MotionFeatures::outermost(const Sampled& sampled, bool largest) const {
  const double sign = largest ? 1 : -1;
  ExtremeFound best{sampled.value.front(), sampled.time.front()};
  for (std::size_t i = 0; i < sampled.value.size(); ++i)
    if (sign * sampled.value[i] > sign * best.value) best = {sampled.value[i], sampled.time[i]};
  const double highest = sign * best.value;
  for (const Rough& rough : rough_extremes(sampled, largest)) {
    if (sign * rough.estimate + rough.doubt < highest) continue;
    const ExtremeFound one = polished(rough, largest);
    if (sign * one.value > sign * best.value + 1e-12 * std::abs(best.value)) best = one;
  }
  return best;
}

std::size_t MotionFeatures::Sampled::from(double part) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(time, part * time.back()) - time.begin());
}

// Whether dampers have brought the motion to rest, so that no later value exceeds the extreme.
bool MotionFeatures::has_settled(const Sampled& sampled, bool largest, const ExtremeFound& best) const {
  if (!motion_.dissipates() || best.time > sampled.time.back() / 8) return false;
  const auto [low, high] = std::ranges::minmax(sampled.value);
  const auto [least, most] =
      std::minmax_element(sampled.value.begin() + static_cast<std::ptrdiff_t>(sampled.from(0.5)), sampled.value.end());
  const double width = *most - *least;
  return width <= 1e-3 * (high - low) && (largest ? best.value - *most : *least - best.value) > 2 * width;
}

// Whether the number grows or falls forever: it has gone farther than any part of the machine reaches, and no springs
// bring it back.
bool MotionFeatures::goes_away(const Sampled& sampled, bool upwards) const {
  const double last = sampled.value.back();
  if (!(natural_size_ > 0) || motion_.has_springs() || std::abs(last - sampled.value.front()) < 1e3 * natural_size_)
    return false;
  const std::size_t away = sampled.from(0.125);
  for (std::size_t i = away; i + 1 < sampled.value.size(); ++i)
    if (!(upwards ? sampled.value[i + 1] > sampled.value[i] : sampled.value[i + 1] < sampled.value[i])) return false;
  // It must not become slower.
  const double first = sampled.value[away], second = sampled.value[sampled.from(0.25)],
               third = sampled.value[sampled.from(0.5)];
  return std::abs(third - second) >= 1.9 * std::abs(second - first) &&
         std::abs(last - third) >= 1.9 * std::abs(third - second);
}

ExtremeFound MotionFeatures::extreme(bool largest) const {
  const std::string ending = "say how long the motion lasts: stages: {run: {lasts: 10 s}}";
  const std::optional<double> end = motion_.end();
  if (end && motion_.nodes(0, *end).size() * per_step <= most_samples) return outermost(samples(0, *end), largest);
  for (double until = 4 * motion_.pace_time(); !motion_.followed_enough(until / 2) && !(end && until > *end);
       until *= 2) {
    const Sampled sampled = samples(0, until);
    const auto [low, high] = std::minmax_element(sampled.value.begin(), sampled.value.end());
    if (*high - *low <= 1e-9 * std::max(std::abs(*high), std::abs(*low))) {
      // The number has been constant so far. A disturbance takes some time to grow.
      if (until > long_enough * motion_.pace_time()) return {sampled.value.front(), 0};
      continue;
    }
    // Both the highest and the lowest value must occur again.
    const std::optional<ExtremeFound> wanted = met_twice(sampled, largest, *high - *low);
    if (wanted && met_twice(sampled, !largest, *high - *low)) return *wanted;
    if (until <= long_enough * motion_.pace_time()) continue;
    if (goes_away(sampled, largest))
      unanswered(file_, mark_,
                 "'" + words_ + "' goes on " + (largest ? "growing" : "falling") + " in an endless motion: it has no " +
                     (largest ? "largest" : "smallest") + " value",
                 ending);
    ExtremeFound best = outermost(sampled, largest);
    if (!has_settled(sampled, largest, best) && !(goes_away(sampled, !largest) && best.time < until / 8)) continue;
    best.settled = until;
    return best;
  }
  unanswered(file_, mark_,
             "'" + words_ + "' does not come back to the same extremes, so that of " +
                 (end ? "so long a" : "an endless") + " motion it has no " + (largest ? "largest" : "smallest") +
                 " value that could be told",
             end ? "let it last shorter" : ending);
}

ExtremeFound MotionFeatures::largest() const { return note(extreme(true)); }
ExtremeFound MotionFeatures::smallest() const { return note(extreme(false)); }

double MotionFeatures::zero_between(double a, double b, double level) const {
  const auto f = [&](double t) { return number_(t) - level; };
  const double fa = f(a), fb = f(b);
  if (fa == 0) return a;
  if (fb == 0) {
    // The number may be zero from some time on, as the force of a contact that was lost.
    double inside = a, outside = b;
    for (int i = 0; i < 60 && inside < outside; ++i) {
      const double middle = 0.5 * (inside + outside);
      if (middle == inside || middle == outside) break;
      (f(middle) == 0 ? outside : inside) = middle;
    }
    return outside;
  }
  std::uintmax_t iterations = 100;
  const auto bracket =
      boost::math::tools::toms748_solve(f, a, b, fa, fb, boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

double MotionFeatures::period() const {
  const ExtremeFound highest = largest(), lowest = smallest();
  const double high = highest.value, low = lowest.value;
  if (highest.settled > 0 || lowest.settled > 0)
    unanswered(file_, mark_, "'" + words_ + "' does not repeat: it has no period");
  if (!(high > low)) unanswered(file_, mark_, "'" + words_ + "' does not change: it has no period");
  const double level = 0.5 * (high + low);
  const std::optional<double> end = motion_.end();
  for (double until = 8 * motion_.pace_time();; until *= 2) {
    if (end) until = std::min(until, *end);
    const Sampled sampled = samples(0, until);
    std::vector<double> rising;
    for (std::size_t i = 0; i + 1 < sampled.value.size(); ++i)
      if (sampled.value[i] < level && sampled.value[i + 1] >= level)
        rising.push_back(zero_between(sampled.time[i], sampled.time[i + 1], level));
    // Finds after how many rises the motion repeats.
    for (std::size_t k = 1; k <= most_rises && 2 * k + 1 <= rising.size(); ++k) {
      const double period = rising[k] - rising[0];
      bool repeats = true;
      for (std::size_t i = 0; i + k < rising.size() && repeats; ++i)
        repeats = std::abs(rising[i + k] - rising[i] - period) <= repeats_to * period;
      const int places = 12 * static_cast<int>(k);
      for (int i = 1; i < places && repeats; ++i) {
        const double time = rising[0] + period * i / places;
        repeats = std::abs(number_(time) - number_(time + period)) <= 10 * repeats_to * (high - low);
      }
      if (!repeats) continue;
      note({0, rising[k]});
      return period;
    }
    if (end && until >= *end)
      unanswered(file_, mark_, "'" + words_ + "' does not repeat: it has no period",
                 "let the motion last for at least two periods");
    if (motion_.followed_enough(until / 2)) {
      char text[60];
      std::snprintf(text, sizeof text, "' does not repeat up to %.4g s", until);
      unanswered(file_, mark_, "'" + words_ + text + ": no period was found");
    }
  }
}

// The extreme between a sample and the next one that is nearer to zero than both, if it may reach zero.
std::optional<ExtremeFound> MotionFeatures::nearest_to_zero(const Sampled& sampled, std::size_t at) const {
  const double sign = sampled.value[at] > 0 ? 1 : -1;
  const std::size_t last = sampled.value.size() - 1;
  const auto value = [&](std::size_t i) { return sign * sampled.value[i]; };
  const double a = value(at), b = value(at + 1);
  // The samples must approach zero towards the interval from both sides. At the ends of the motion nothing is known
  // beyond.
  const bool falls = at == 0 || value(at - 1) > a, rises = at + 1 == last || value(at + 2) > b;
  if (!falls || !rises) return std::nullopt;
  // Whether smooth or with a corner, the number changes no more than it did between the samples.
  double drop = std::abs(a - b);
  if (at > 0) drop = std::max(drop, value(at - 1) - a);
  if (at + 1 < last) drop = std::max(drop, value(at + 2) - b);
  if (std::min(a, b) > 2 * drop) return std::nullopt;
  ExtremeFound near = outermost_between(sampled.time[at], sampled.time[at + 1], sign < 0);
  // A zero of the slope is found more precisely.
  if (sign * near.value > 0)
    if (const auto level = level_between(sampled.time[at], sampled.time[at + 1]))
      if (sign * level->value < sign * near.value) near = *level;
  return near;
}

std::vector<double> MotionFeatures::zeros(double from, std::optional<double> to, int sense) const {
  std::vector<double> found;
  const std::optional<double> last = to ? to : motion_.end();
  double begun = from, until = to ? *to : from + 4 * motion_.pace_time();
  std::size_t waited = 0;
  for (;; until = from + 2 * (until - from)) {
    if (last) until = std::min(until, *last);
    // If a motion cannot be followed further, what happens before is known nevertheless.
    std::optional<UnansweredError> stopped;
    const Sampled sampled = [&] {
      try {
        return samples(begun, until);
      } catch (const UnansweredError& error) {
        if (to || !(motion_.reached() > begun && motion_.reached() < until)) throw;
        stopped = error;
        until = motion_.reached();
        return samples(begun, until);
      }
    }();
    double size = 0;
    for (double value : sampled.value) size = std::max(size, std::abs(value));
    const auto start_counts = [&] {
      const double value = sampled.value.front();
      return sense == 0 ? std::abs(value) <= 1e-12 * size : sense * value > 1e-12 * size;
    };
    if (begun == from && start_counts()) found.push_back(from);
    for (std::size_t i = 0; i + 1 < sampled.value.size(); ++i) {
      const double a = sampled.value[i], b = sampled.value[i + 1];
      if (i == 0 && begun == from && std::abs(a) <= 1e-12 * size) continue;
      const bool rises = a < 0 && b >= 0, falls = a > 0 && b <= 0;
      if ((sense >= 0 && rises) || (sense <= 0 && falls))
        found.push_back(zero_between(sampled.time[i], sampled.time[i + 1], 0));
      // Between two samples of one sign the number may reach zero and return. The extreme between them shows that.
      if (rises || falls || a == 0 || b == 0) continue;
      const std::optional<ExtremeFound> near = nearest_to_zero(sampled, i);
      if (!near) continue;
      if (std::abs(near->value) <= 1e-10 * size) {
        if (sense == 0) found.push_back(near->time);
      } else if (near->value * a < 0) {
        // The number changes its sign and changes back.
        if (sense != (a > 0 ? 1 : -1)) found.push_back(zero_between(sampled.time[i], near->time, 0));
        if (sense != (a > 0 ? -1 : 1)) found.push_back(zero_between(near->time, sampled.time[i + 1], 0));
      }
    }
    // The event that ends the motion happens at its end, even if rounding leaves a small value there.
    const double at_end = sampled.value.back(), sign = sampled.value.front() > 0 ? 1 : -1;
    if ((stopped || (last && until >= *last)) && found.empty() && sense * sign <= 0 && std::abs(at_end) <= 1e-11 * size)
      found.push_back(until);
    std::sort(found.begin(), found.end());
    if (!found.empty()) note({0, to ? found.back() : found.front()});
    if (to) return found;
    if (!found.empty()) return {found.front()};
    if (stopped) throw UnansweredError(*stopped);
    waited += sampled.value.size();
    if ((last && until >= *last) || motion_.followed_enough(until) || (!last && waited > samples_of_wait)) break;
    begun = until;
  }
  char text[60];
  std::snprintf(text, sizeof text, " up to %.4g s", until);
  unanswered(file_, mark_, "'" + words_ + "' does not happen" + text,
             "check the condition, or look farther with lasts:");
}

std::vector<double> MotionFeatures::times_of_extreme(bool largest, double from, std::optional<double> to) const {
  const ExtremeFound best = extreme(largest);
  const double until = to ? *to : std::max(best.time * (1 + 1e-9), from) + 2 * motion_.pace_time();
  const Sampled sampled = samples(from, motion_.end() ? std::min(until, *motion_.end()) : until);
  const auto [low, high] = std::minmax_element(sampled.value.begin(), sampled.value.end());
  std::vector<double> found;
  if (std::abs(sampled.value.front() - best.value) <= repeats_to * (*high - *low)) found.push_back(from);
  for (const ExtremeFound& one : extremes(sampled, largest))
    if (std::abs(one.value - best.value) <= repeats_to * (*high - *low) && one.time > from) found.push_back(one.time);
  if (found.empty()) found.push_back(best.time);
  note({0, to ? found.back() : found.front()});
  if (!to) return {found.front()};
  return found;
}

}  // namespace poinsot::problem
