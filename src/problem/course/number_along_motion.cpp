#include "problem/course/number_along_motion.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "engine/motion/integrator/event_search.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

constexpr int per_step = 6;  // samples in a step of the integration

}  // namespace

std::size_t NumberSamples::from(double part) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(time, part * time.back()) - time.begin());
}

void NumberAlongMotion::unanswered(const std::string& what, const std::string& hint) const {
  throw UnansweredError(file_, mark_, "'" + words_ + "'" + what, hint);
}

void NumberAlongMotion::never(double until, bool ends) const {
  throw NotHappeningError(file_, mark_, "'" + words_ + "' does not happen up to " + with_digits(until, 4) + " s",
                          "check the condition, or look farther with lasts:", ends ? INFINITY : until);
}

std::size_t NumberAlongMotion::count_of_samples(double from, double to) const {
  return motion_.nodes(from, to).size() * per_step;
}

// Between two samples the number then is as smooth as the motion.
void NumberAlongMotion::add_corners(std::vector<double>& times) const {
  std::vector<double> looks = times;
  for (const CornerInTime& corner : corners_) {
    const std::vector<double> found = corners_between(corner.number, corner.turns, looks);
    looks.insert(looks.end(), found.begin(), found.end());
    std::ranges::sort(looks);
    times.insert(times.end(), found.begin(), found.end());
  }
  std::ranges::sort(times);
  // What is left between two that are nearly one would be rounding.
  constexpr double no_part = 1e-13;
  const double first = times.front(), last = times.back(), none = no_part * (last - first);
  std::vector<double> apart{first};
  for (const double time : times)
    if (time - apart.back() > none && last - time > none) apart.push_back(time);
  apart.push_back(last);
  times = std::move(apart);
}

// Where a number turns soon after something sudden, or soon before, samples as far apart as the steps do not see it: of
// a stone that is thrown up slowly and falls for long, the top. Looks that come nearer and nearer do. sudden, away: two
// samples that follow each other. The times of three looks about the turn, or none.
const std::vector<double>& NumberAlongMotion::turn_beside(double sudden, double away) const {
  const auto [entry, fresh] = turns_.try_emplace({sudden, away});
  if (!fresh) return entry->second;
  constexpr double nearer = 1.0 / 16;
  constexpr int most_looks = 10;        // down to 1e-12 of the way
  constexpr double rounding = 1.5e-14;  // of a number that takes some operations
  constexpr double no_turn = 1e-12;     // of the change between the samples
  const double here = number_(sudden), there = number_(away), sign = there < here ? 1 : -1;
  double most = rounding * std::max(std::abs(here), std::abs(there)) + no_turn * std::abs(there - here), part = 1;
  for (int k = 0; k < most_looks; ++k) {
    part *= nearer;
    const double time = sudden + part * (away - sudden);
    if (time == sudden) break;
    const double beyond = sign * (number_(time) - here);
    if (!(beyond > most)) continue;
    most = beyond;
    entry->second = {sudden + nearer * (time - sudden), time, sudden + std::min(part / nearer, 0.5) * (away - sudden)};
  }
  std::ranges::sort(entry->second);
  return entry->second;
}

void NumberAlongMotion::add_turns(NumberSamples& sampled) const {
  if (sampled.time.size() < 2) return;
  constexpr std::size_t most_breaks = 64;  // bounces come by hundreds, and beside each the bounce itself is the turn
  std::vector<double> times;
  std::size_t looked_at = 0;
  for (const double sudden : motion_.breaks(sampled.time.front(), sampled.time.back())) {
    if (++looked_at > most_breaks) break;
    const auto place = std::ranges::lower_bound(sampled.time, sudden);
    if (place == sampled.time.end() || *place != sudden) continue;
    for (const auto& away : {place + 1, place == sampled.time.begin() ? sampled.time.end() : place - 1})
      if (away != sampled.time.end()) {
        const std::vector<double>& turn = turn_beside(sudden, *away);
        times.insert(times.end(), turn.begin(), turn.end());
      }
  }
  for (const double time : times) {
    const auto place = std::ranges::lower_bound(sampled.time, time);
    if (place != sampled.time.end() && *place == time) continue;
    sampled.value.insert(sampled.value.begin() + (place - sampled.time.begin()), number_(time));
    sampled.time.insert(place, time);
  }
}

NumberSamples NumberAlongMotion::samples(double from, double to) const {
  NumberSamples sampled;
  const std::vector<double> nodes = motion_.nodes(from, to);
  if (nodes.size() * per_step > most_samples) {
    unanswered(" has no answer in the motion up to " + with_digits(to, 4) + " s, and it is too long to go on",
               motion_.end() ? "let it last shorter" : "say how long the motion lasts: stages: {run: {lasts: 10 s}}");
  }
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    for (int k = 0; k < per_step; ++k) sampled.time.push_back(nodes[i] + (nodes[i + 1] - nodes[i]) * k / per_step);
  sampled.time.push_back(nodes.back());
  if (!corners_.empty()) add_corners(sampled.time);
  // The samples of an earlier question are the beginning of those for this one.
  std::size_t known = 0;
  while (known < sampled.time.size() && known < sampled_.time.size() && sampled.time[known] == sampled_.time[known])
    sampled.value.push_back(sampled_.value[known++]);
  for (std::size_t i = known; i < sampled.time.size(); ++i) sampled.value.push_back(number_(sampled.time[i]));
  if (from == 0) sampled_ = sampled;
  add_turns(sampled);
  return sampled;
}

// The extreme at which the slope vanishes: a zero of the rate, or if that is not known, of differences of sixth
// order. Nothing if the slope does not change sign.
std::optional<ExtremeFound> NumberAlongMotion::level_between(double before, double after) const {
  if (!(before < after)) return std::nullopt;
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
ExtremeFound NumberAlongMotion::outermost_between(double before, double after, bool largest) const {
  std::uintmax_t iterations = 100;
  const double half = 0.5 * (after - before), center = 0.5 * (after + before);
  const auto found = boost::math::tools::brent_find_minima(
      [&](double x) { return largest ? -number_(center + half * x) : number_(center + half * x); }, -1.0, 1.0, 50,
      iterations);
  return {largest ? -found.second : found.second, center + half * found.first};
}

double NumberAlongMotion::zero_between(double a, double b, double level) const {
  if (!(a < b)) return a;  // steps may be as short as the last digit of the time
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
  // A number that is rounding changes its sign from one evaluation to the next.
  if ((fa < 0) == (fb < 0)) return std::abs(fa) < std::abs(fb) ? a : b;
  std::uintmax_t iterations = 100;
  const auto bracket =
      boost::math::tools::toms748_solve(f, a, b, fa, fb, boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace poinsot::problem
