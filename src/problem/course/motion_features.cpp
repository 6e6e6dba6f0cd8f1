#include "problem/course/motion_features.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "poinsot/engine/work/work.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

// Change of a constant number, as a part of itself: its error along the motion, 1e-12 for each of a thousand steps.
constexpr double constant_to = 1e-9;
// And of the size that is natural for it: what is zero throughout changes by the rounding of what it is made of.
constexpr double constant_beside = 1e-15;
// Of what has died out there is left what the integration leaves, as a part of what it was.
constexpr double died_out = 1e-9;
constexpr std::size_t least_dead = 12;  // samples, of two steps: in fewer of them a number may just go through zero
constexpr std::size_t most_rises = 40;  // within one period
constexpr std::size_t samples_of_wait = 60'000;  // until something must happen in a motion without end
// In the times that the motion takes to change noticeably: a disturbance takes this long to grow. It grows by 1e7 from
// a nudge in some 16 of its own times, and those are slower than the motion itself by no more than thirty times.
constexpr double long_enough = 500;
constexpr Work most_work_of_extreme = 1'000'000'000;  // in a motion without end that loses nothing

}  // namespace

ExtremeFound MotionFeatures::polished(const Rough& rough, bool largest) const {
  const double sign = largest ? 1 : -1;
  ExtremeFound best{number_(rough.middle), rough.middle};
  const std::optional<ExtremeFound> smooth = number_.level_between(rough.before, rough.after);
  if (smooth && rough.smooth && sign * smooth->value >= sign * best.value) return *smooth;
  // There may be a corner, where loads change or a speed becomes zero; the slope does not vanish there.
  const ExtremeFound corner = number_.outermost_between(rough.before, rough.after, largest);
  if (sign * corner.value > sign * best.value) best = corner;
  const double rounding = 1e-12 * std::abs(best.value);
  return smooth && sign * smooth->value >= sign * best.value - rounding ? *smooth : best;
}

std::vector<MotionFeatures::Rough> MotionFeatures::rough_extremes(const NumberSamples& sampled, bool largest) const {
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

std::vector<ExtremeFound> MotionFeatures::extremes(const NumberSamples& sampled, bool largest) const {
  std::vector<ExtremeFound> found;
  for (const Rough& rough : rough_extremes(sampled, largest)) found.push_back(polished(rough, largest));
  return found;
}

// The outermost extreme, if its value occurs again. It is found among the extremes that may be as far out.
std::optional<ExtremeFound> MotionFeatures::met_twice(const NumberSamples& sampled, bool largest, double range) const {
  const double sign = largest ? 1 : -1, repeats_to = repeated(range);
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
  // What the motion never comes back to, it has at its start.
  const double start = sampled.value.front();
  if (count >= 2 && sign * start > outermost + repeats_to * range) return ExtremeFound{start, sampled.time.front()};
  if (count < 2) return std::nullopt;
  // What it comes back to but for the error of the way there, it has at its start to all digits.
  constexpr double error_of_the_way = 1e-10;
  if (std::abs(first->value - start) <= error_of_the_way * range) first->value = start;
  return first;
}

// The largest or smallest value of a motion with an end, including both ends.
ExtremeFound MotionFeatures::outermost(const NumberSamples& sampled, bool largest) const {
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

// Whether dampers have brought the motion to rest, so that no later value exceeds the extreme.
bool MotionFeatures::has_settled(const NumberSamples& sampled, bool largest, const ExtremeFound& best) const {
  if (!motion_.dissipates() || best.time > sampled.time.back() / 8) return false;
  const auto [low, high] = std::ranges::minmax(sampled.value);
  const auto [least, most] =
      std::minmax_element(sampled.value.begin() + static_cast<std::ptrdiff_t>(sampled.from(0.5)), sampled.value.end());
  const double width = *most - *least;
  return width <= 1e-3 * (high - low) && (largest ? best.value - *most : *least - best.value) > 2 * width;
}

// Whether an endless motion comes ever closer to an extreme and never there, as what falls in air to its last speed:
// what is left falls to a hundredth in equal times, again and again. What arrives takes less and less time for that.
bool MotionFeatures::is_approached(const NumberSamples& sampled, bool largest, double extreme) const {
  if (motion_.may_come_to_rest()) return false;
  const auto [low, high] = std::ranges::minmax(sampled.value);
  const double range = high - low, sign = largest ? 1 : -1;
  const auto left = [&](std::size_t i) { return sign * (extreme - sampled.value[i]); };
  // The last sample that is as far from it as this part of the range.
  const auto last_at = [&](double part) -> std::optional<std::size_t> {
    for (std::size_t i = sampled.value.size(); i-- > 0;)
      if (left(i) > part * range) return i;
    return std::nullopt;
  };
  const auto far = last_at(1e-2), near = last_at(1e-4), nearest = last_at(1e-6);
  if (!far || !near || !nearest || sampled.time[*nearest] > sampled.time.back() / 2) return false;
  for (std::size_t i = *far; i < *nearest; ++i)
    if (!(left(i + 1) < left(i))) return false;
  constexpr double alike = 0.5;
  return sampled.time[*nearest] - sampled.time[*near] > alike * (sampled.time[*near] - sampled.time[*far]);
}

// Whether the number grows or falls forever: it has gone farther than any part of the machine reaches, and no springs
// bring it back.
bool MotionFeatures::goes_away(const NumberSamples& sampled, bool upwards) const {
  const double last = sampled.value.back();
  if (!(number_.natural_size() > 0) || motion_.has_springs() ||
      std::abs(last - sampled.value.front()) < 1e3 * number_.natural_size())
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

// When a motion that cannot be followed until a time ends in the center that pulls it; nothing if it does not.
std::optional<double> MotionFeatures::fall_before(double until) const {
  constexpr int halvings = 40;
  double followed = 0, beyond = until;
  // No nearer than is needed to see it: what is kept is kept less and less closely.
  for (int k = 0; k < halvings && !(followed > 0 && motion_.ends_in_center(followed)); ++k) {
    const double middle = followed + (beyond - followed) / 2;
    try {
      static_cast<void>(motion_.nodes(0, middle));
      followed = middle;
    } catch (const UnansweredError&) {
      beyond = middle;
    }
  }
  return followed > 0 && motion_.ends_in_center(followed) ? std::optional(followed) : std::nullopt;
}

ExtremeFound MotionFeatures::extreme(bool largest) const {
  const std::string ending = "say how long the motion lasts: stages: {run: {lasts: 10 s}}";
  const std::optional<double> end = motion_.end();
  if (end && number_.count_of_samples(0, *end) <= NumberAlongMotion::most_samples)
    return outermost(number_.samples(0, *end), largest);
  bool constant = false;
  const WorkLimit work(most_work_of_extreme);
  for (double until = 4 * motion_.pace_time();
       (constant || !motion_.followed_enough(until / 2)) && !(end && until > *end); until *= 2) {
    std::optional<double> fallen;
    const NumberSamples sampled = [&] {
      try {
        return number_.samples(0, until);
      } catch (const UnansweredError&) {
        fallen = fall_before(until);
        if (!fallen) throw;
        return number_.samples(0, *fallen);
      }
    }();
    if (fallen) {
      ExtremeFound best = outermost(sampled, largest);
      // Of the time, and of the range: what is left of the way is a hundredth.
      constexpr double at_the_end = 1e-2, left_over = 2e-2;
      const auto [least, most] = std::ranges::minmax(sampled.value);
      if (best.time >= (1 - at_the_end) * *fallen ||
          std::abs(best.value - sampled.value.back()) <= left_over * (most - least))
        number_.unanswered(std::string(" goes on ") + (largest ? "growing" : "falling") +
                           " until the motion ends in the center that pulls, at " + with_digits(*fallen, 6) +
                           " s: it has no " + (largest ? "largest" : "smallest") + " value");
      best.fallen = *fallen;
      return best;
    }
    const auto [low, high] = std::minmax_element(sampled.value.begin(), sampled.value.end());
    constant = *high - *low <= std::max(constant_to * std::max(std::abs(*high), std::abs(*low)),
                                        constant_beside * number_.natural_size());
    if (constant) {
      // The number has been constant so far. A disturbance takes some time to grow.
      if (until > long_enough * motion_.pace_time() &&
          (until > long_enough * motion_.turning_time(until) || motion_.followed_by_many_steps(until)))
        return {sampled.value.front(), 0};
      continue;
    }
    // Both the highest and the lowest value must occur again.
    const std::optional<ExtremeFound> wanted = met_twice(sampled, largest, *high - *low);
    // Nor is what rounding leaves of a motion that has died out an extreme beside zero.
    const double rest = motion_.dissipates() ? died_out * (*high - *low) : 0;
    const auto without_rest = [&](ExtremeFound found) {
      if (std::abs(found.value) <= rest) found.value = 0;
      return found;
    };
    const auto told = [&](const ExtremeFound& best) {
      ExtremeFound found = without_rest(best);
      found.approached = !end && is_approached(sampled, largest, best.value);
      return found;
    };
    if (wanted && met_twice(sampled, !largest, *high - *low)) return told(*wanted);
    if (until <= long_enough * motion_.pace_time()) continue;
    if (motion_.rests_at(until)) return told(outermost(sampled, largest));
    if (goes_away(sampled, largest))
      number_.unanswered(std::string(" goes on ") + (largest ? "growing" : "falling") +
                             " in an endless motion: it has no " + (largest ? "largest" : "smallest") + " value",
                         ending);
    ExtremeFound best = without_rest(outermost(sampled, largest));
    if (has_settled(sampled, largest, best) || (goes_away(sampled, !largest) && best.time < until / 8)) {
      best.settled = until;
      return best;
    }
    // What loses nothing repeats soon or hardly ever: what follows the time has to come back together with its load.
    if (work.spent() && !motion_.dissipates())
      number_.unanswered(" does not come back to the same extremes up to " + with_digits(until, 4) +
                             " s, so that of an endless motion it has no " + (largest ? "largest" : "smallest") +
                             " value that could be told",
                         ending);
  }
  number_.unanswered(std::string(" does not come back to the same extremes, so that of ") +
                         (end ? "so long a" : "an endless") + " motion it has no " +
                         (largest ? "largest" : "smallest") + " value that could be told",
                     end ? "let it last shorter" : ending);
}

std::string in_words(const ExtremeFound& found) {
  if (found.fallen > 0)
    return " was told up to " + with_digits(found.fallen, 6) + " s, where the motion ends in the center that pulls";
  if (found.approached) return " is a limit: the motion comes ever closer to it and never there";
  if (found.settled > 0)
    return " was told from " + with_digits(found.settled, 4) + " s of a motion that does not repeat";
  return "";
}

ExtremeFound MotionFeatures::largest() const { return note(extreme(true)); }
ExtremeFound MotionFeatures::smallest() const { return note(extreme(false)); }

double MotionFeatures::period() const {
  const ExtremeFound highest = largest(), lowest = smallest();
  const double high = highest.value, low = lowest.value;
  if (highest.settled > 0 || lowest.settled > 0 || motion_.rests_at(motion_.reached()))
    number_.unanswered(" does not repeat: it has no period");
  if (!(high > low)) number_.unanswered(" does not change: it has no period");
  const double level = 0.5 * (high + low), repeats_to = repeated(high - low);
  const std::optional<double> end = motion_.end();
  for (double until = 8 * motion_.pace_time();; until *= 2) {
    if (end) until = std::min(until, *end);
    const NumberSamples sampled = number_.samples(0, until);
    std::vector<double> rising;
    for (std::size_t i = 0; i + 1 < sampled.value.size(); ++i)
      if (sampled.value[i] < level && sampled.value[i + 1] >= level)
        rising.push_back(number_.zero_between(sampled.time[i], sampled.time[i + 1], level));
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
      number_.unanswered(" does not repeat: it has no period", "let the motion last for at least two periods");
    if (motion_.followed_enough(until / 2)) {
      number_.unanswered(" does not repeat up to " + with_digits(until, 4) + " s: no period was found");
    }
  }
}

// The extreme between a sample and the next one that is nearer to zero than both, if it may reach zero.
std::optional<ExtremeFound> MotionFeatures::nearest_to_zero(const NumberSamples& sampled, std::size_t at) const {
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
  ExtremeFound near = number_.outermost_between(sampled.time[at], sampled.time[at + 1], sign < 0);
  // A zero of the slope is found more precisely.
  if (sign * near.value > 0)
    if (const auto level = number_.level_between(sampled.time[at], sampled.time[at + 1]))
      if (sign * level->value < sign * near.value) near = *level;
  return near;
}

// Whether something happens where a number has come to nothing, from a sample on: it has stopped or broken off, and did
// not die out.
bool MotionFeatures::is_sudden(const NumberSamples& sampled, std::size_t from) const {
  constexpr double near = 1e-6;  // of the time so far
  const double before = sampled.time[from - 1],
               after = sampled.time[from] + near * (sampled.time[from] - sampled.time.front());
  const std::vector<double> breaks = motion_.breaks(sampled.time.front(), sampled.time.back());
  return std::any_of(breaks.begin() + 1, breaks.end() - 1,
                     [&](double time) { return before <= time && time <= after; });
}

std::vector<double> MotionFeatures::zeros(double from, std::optional<double> to, int sense) const {
  std::vector<double> found;
  const std::optional<double> last = to ? to : motion_.end();
  double begun = from, until = to ? *to : from + 4 * motion_.pace_time();
  double largest = 0;  // magnitude so far
  std::size_t waited = 0;
  // Each try to come nearer to where a motion ends halves what is left.
  constexpr int most_shortened = 40;
  int shortened = 0;
  for (;; until = from + 2 * (until - from)) {
    if (last) until = std::min(until, *last);
    // If a motion cannot be followed further, what happens before is known nevertheless.
    std::optional<UnansweredError> stopped;
    const NumberSamples sampled = [&] {
      try {
        return number_.samples(begun, until);
      } catch (const UnansweredError& error) {
        if (to) throw;
        if (motion_.reached() > begun && motion_.reached() < until) {
          stopped = error;
          until = motion_.reached();
          return number_.samples(begun, until);
        }
        // A motion that ends in the center that pulls it has been followed nowhere yet.
        if (motion_.reached() > begun || ++shortened > most_shortened) throw;
        until = begun + (until - begun) / 2;
        return NumberSamples{};
      }
    }();
    if (sampled.value.empty()) {
      // Half as far: the step to the next stretch doubles it.
      until = from + (until - from) / 2;
      continue;
    }
    double size = 0;
    for (double value : sampled.value) size = std::max(size, std::abs(value));
    largest = std::max(largest, size);
    // From here on nothing is left but rounding, whatever signs it may have: the number has only come near to zero, as
    // a speed to that at which drag and weight balance, or what a damper has brought to rest.
    std::size_t alive = sampled.value.size();
    while (alive > 0 && std::abs(sampled.value[alive - 1]) <= died_out * largest) --alive;
    if (sampled.value.size() - alive < least_dead || (alive > 0 && is_sudden(sampled, alive)))
      alive = sampled.value.size();
    const auto start_counts = [&] {
      const double value = sampled.value.front();
      return sense == 0 ? std::abs(value) <= 1e-12 * size : sense * value > 1e-12 * size;
    };
    if (begun == from && start_counts()) found.push_back(from);
    for (std::size_t i = 0; i + 1 < sampled.value.size() && i < alive; ++i) {
      const double a = sampled.value[i], b = sampled.value[i + 1];
      // Where it comes to nothing it does not go through zero.
      if (i + 1 == alive && alive < sampled.value.size()) continue;
      if (i == 0 && begun == from && std::abs(a) <= 1e-12 * size) continue;
      const bool rises = a < 0 && b >= 0, falls = a > 0 && b <= 0;
      if ((sense >= 0 && rises) || (sense <= 0 && falls))
        found.push_back(number_.zero_between(sampled.time[i], sampled.time[i + 1], 0));
      // Between two samples of one sign the number may reach zero and return. The extreme between them shows that.
      if (rises || falls || a == 0 || b == 0) continue;
      const std::optional<ExtremeFound> near = nearest_to_zero(sampled, i);
      if (!near) continue;
      if (std::abs(near->value) <= 1e-10 * size) {
        if (sense == 0) found.push_back(near->time);
      } else if (near->value * a < 0) {
        // The number changes its sign and changes back.
        if (sense != (a > 0 ? 1 : -1)) found.push_back(number_.zero_between(sampled.time[i], near->time, 0));
        if (sense != (a > 0 ? -1 : 1)) found.push_back(number_.zero_between(near->time, sampled.time[i + 1], 0));
      }
    }
    // The event that ends the motion, or the span, happens at its end, even if rounding leaves a small value there. It
    // is approached from the other side.
    const double at_end = sampled.value.back(), none = 1e-11 * size;
    const std::size_t before = sampled.value.size() < 2 ? 0 : sampled.value.size() - 2;
    const double last_side = sampled.value[before] > 0 ? 1 : -1;
    const bool comes_to_zero = std::abs(at_end) <= none && std::abs(sampled.value[before]) > none;
    const bool told = !found.empty() && until - found.back() <= 1e-9 * (until - from);
    if ((stopped || (last && until >= *last)) && comes_to_zero && sense * last_side <= 0 && !told)
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
  number_.never(until, last && until >= *last);
}

std::vector<double> MotionFeatures::times_of_extreme(bool largest, double from, std::optional<double> to) const {
  const ExtremeFound best = extreme(largest);
  const double until = to ? *to : std::max(best.time * (1 + 1e-9), from) + 2 * motion_.pace_time();
  const NumberSamples sampled = number_.samples(from, motion_.end() ? std::min(until, *motion_.end()) : until);
  const auto [low, high] = std::minmax_element(sampled.value.begin(), sampled.value.end());
  const double repeats_to = repeated(*high - *low);
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
