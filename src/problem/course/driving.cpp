#include "problem/course/driving.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <set>

#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"

namespace poinsot::problem {
namespace {

constexpr double no_time = 1e-13;  // of a time: some hundred units in its last place
// Of a span, how far inside its ends it is looked at: at a corner itself either side's value may come.
constexpr double just_inside = 1e-9;
constexpr int most_halvings = 20;            // of the time between two samples
constexpr std::size_t most_looks = 100'000;  // samples in one part of the motion
constexpr double bend = 0.02;          // change of slope allowed between two samples, as a part of a function's range
constexpr double steps_of_looks = 8;   // samples in each step of the integration
constexpr double parts_of_pace = 100;  // length of a part, in times in which the motion changes noticeably
constexpr double most_parts = 16;      // number of parts if the motion lasts a stated time
constexpr const char* corner_functions[] = {"abs", "norm", "unit", "direction", "sqrt", "angle", "acute_angle"};

}  // namespace

std::vector<Expression> driving_expressions(const Situation& situation,
                                            const std::optional<std::vector<std::string>>& loads) {
  std::vector<Expression> found;
  const auto add = [&](const std::optional<Expression>& expression) {
    if (expression && depends_on_time(situation, *expression)) found.push_back(*expression);
  };
  for_each_stated_law(situation, [&]<StatedLaw Law>(const Law& law) {
    if (!Law::may_follow_time) return;
    if (loads && std::find(loads->begin(), loads->end(), law.name) == loads->end()) return;
    law.for_each_part([&](LawPart, const std::optional<Expression>& part) { add(part); });
  });
  for (const Joint& joint : situation.joints)
    for (const Freedom& freedom : joint.freedoms)
      for (const auto* part : {&freedom.position, &freedom.rate, &freedom.accel, &freedom.effort}) add(*part);
  for (const Frame& frame : situation.frames)
    for (const auto* part : {&frame.rate, &frame.accel, &frame.velocity, &frame.acceleration}) add(*part);
  return found;
}

Driving::Driving(const Situation& situation, const Settings& settings,
                 const std::optional<std::vector<std::string>>& loads, double start, std::optional<double> lasts,
                 double pace_time, std::size_t looks)
    : situation_(situation), data_(situation, settings), start_(start), looks_(looks) {
  for (const Expression& expression : driving_expressions(situation, loads)) collect(expression);
  part_ = parts_of_pace * pace_time;
  if (lasts && *lasts > 0) part_ = std::max(*lasts / most_parts, std::min(*lasts, part_));
}

void Driving::collect(const Expression& expression) {
  driving_.push_back(expression);
  std::vector<std::string> names;
  collect_corners(expression, names);
}

// Collects the places where an expression may have corners, those of its parts first. names: data that are being
// followed.
void Driving::collect_corners(const Expression& expression, std::vector<std::string>& names) {
  if (!depends_on_time(situation_, expression)) return;
  if (const auto* name = expression.as<Name>()) {
    if (std::find(names.begin(), names.end(), name->name) != names.end()) return;
    names.push_back(name->name);
    for (const auto* items : {&situation_.given, &situation_.points, &situation_.directions})
      for (const NamedExpression& item : *items)
        if (item.name == name->name) collect_corners(item.value, names);
    return;
  }
  for_each_child(expression, [&](const Expression& part) { collect_corners(part, names); });
  const auto* call = expression.as<Call>();
  if (!call) return;
  if (call->function == "min" || call->function == "max") {
    std::vector<Expression> items;
    for (const Argument& argument : call->arguments) {
      if (const auto* list = argument.value.as<List>())
        items.insert(items.end(), list->items.begin(), list->items.end());
      else
        items.push_back(argument.value);
    }
    for (std::size_t i = 0; i < items.size(); ++i)
      for (std::size_t k = i + 1; k < items.size(); ++k) corners_.push_back({items[i], items[k]});
  } else if (std::find(std::begin(corner_functions), std::end(corner_functions), call->function) !=
             std::end(corner_functions)) {
    for (const Argument& argument : call->arguments) corners_.push_back({argument.value, {}});
  }
}

// The values of all loads and given motions; NaN for one that has none.
std::vector<double> Driving::values(double time) {
  data_.set_time(time);
  std::vector<double> all;
  const auto add = [&](const Value<double>& value, auto&& self) -> void {
    if (value.is_number()) all.push_back(value.number);
    if (value.is_vector())
      for (std::size_t k = 0; k < 3; ++k) all.push_back(value.vector[k]);
    for (const Value<double>& item : value.items) self(item, self);
  };
  for (const Expression& expression : driving_) try {
      add(data_.value(expression), add);
    } catch (const StatementError&) {
      all.push_back(std::nan(""));
    }
  return all;
}

double Driving::switch_value(const Expression& expression, const Expression& other, double time) {
  data_.set_time(time);
  try {
    const Value<double> value = data_.value(expression);
    // The direction of a vector can change abruptly only where the vector vanishes.
    if (value.is_vector()) {
      std::size_t largest = 0;
      for (std::size_t k = 1; k < 3; ++k)
        if (std::abs(value.vector[k]) > std::abs(value.vector[largest])) largest = k;
      return value.vector[largest];
    }
    if (!value.is_number()) return std::nan("");
    return value.number - (other ? data_.value(other).number : 0);
  } catch (const StatementError&) {
    return std::nan("");
  }
}

// The times at which loads or given motions may have corners, in ascending order.
std::vector<double> Driving::corners(double from, double to) {
  std::set<double> found;
  for (const Corner& corner : corners_) {
    const auto f = [&](double time) { return switch_value(corner.one, corner.other, time); };
    std::vector<double> times;
    times.reserve(looks_ + 1 + found.size());
    for (std::size_t i = 0; i <= looks_; ++i)
      times.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(looks_));
    times.insert(times.end(), found.begin(), found.end());
    std::sort(times.begin(), times.end());
    std::vector<double> value;
    value.reserve(times.size());
    for (const double time : times) value.push_back(f(time));
    const auto meets_between = [&](double a, double b, double fa, double fb) {
      if (!(fa * fb < 0) || !std::isfinite(fa) || !std::isfinite(fb)) return;
      std::uintmax_t iterations = 100;
      const auto bracket =
          boost::math::tools::toms748_solve(f, a, b, fa, fb, boost::math::tools::eps_tolerance<double>(52), iterations);
      found.insert(0.5 * (bracket.first + bracket.second));
    };
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (value[i] == 0 && times[i] > from && times[i] < to) found.insert(times[i]);
      if (i + 1 == times.size()) break;
      meets_between(times[i], times[i + 1], value[i], value[i + 1]);
      // Two expressions may meet for a short time between samples. The extreme of their difference shows that.
      if (i == 0 || !(value[i - 1] * value[i + 1] > 0)) continue;
      const double sign = value[i] > 0 ? 1 : -1;
      if (!(sign * value[i] <= sign * value[i - 1] && sign * value[i] < sign * value[i + 1])) continue;
      std::uintmax_t iterations = 60;
      const auto least = boost::math::tools::brent_find_minima([&](double time) { return sign * f(time); },
                                                               times[i - 1], times[i + 1], 40, iterations);
      if (!(least.second < 0)) continue;
      meets_between(times[i - 1], least.first, value[i - 1], sign * least.second);
      meets_between(least.first, times[i + 1], sign * least.second, value[i + 1]);
    }
  }
  return {found.begin(), found.end()};
}

// Adds samples between two others until functions bend little from one to the next.
void Driving::refine(const Look& before, const Look& after, std::vector<double>& least, std::vector<double>& most,
                     std::vector<Look>& found, int depth) {
  const double middle = 0.5 * (before.time + after.time);
  if (depth == 0 || looked_ > most_looks || !(before.time < middle && middle < after.time)) return;
  const Look here{middle, values(middle)};
  ++looked_;
  bool bends = false;
  for (std::size_t k = 0; k < here.value.size() && k < least.size(); ++k) {
    if (!std::isfinite(here.value[k]) || k >= before.value.size() || k >= after.value.size()) continue;
    least[k] = std::min(least[k], here.value[k]);
    most[k] = std::max(most[k], here.value[k]);
    bends = bends || std::abs(here.value[k] - 0.5 * (before.value[k] + after.value[k])) > bend * (most[k] - least[k]);
  }
  if (bends) refine(before, here, least, most, found, depth - 1);
  found.push_back(here);
  if (bends) refine(here, after, least, most, found, depth - 1);
}

// Whether the values are those of polynomials of low degree, for which an integration may take any step.
bool Driving::is_polynomial(const std::vector<Look>& looks, const std::vector<double>& least,
                            const std::vector<double>& most) {
  constexpr std::size_t nodes = 5;
  // Of the range of the values: a hundredth of what a motion is followed to in a thousand steps.
  constexpr double closely = 1e-10;
  const double begin = looks.front().time, length = looks.back().time - begin;
  std::vector<std::size_t> at;
  for (std::size_t n = 0; n < nodes; ++n) at.push_back(n * (looks.size() - 1) / (nodes - 1));
  const bool few = looks.size() < 2 * nodes;
  for (std::size_t j = 0; j < looks.front().value.size(); ++j) {
    const auto all_have_it = [&](const Look& look) { return j < look.value.size() && std::isfinite(look.value[j]); };
    if (!std::all_of(looks.begin(), looks.end(), all_have_it)) return false;
    const auto constant = [&](const Look& look) { return look.value[j] == looks.front().value[j]; };
    if (std::all_of(looks.begin(), looks.end(), constant)) continue;
    if (few) return false;
    // The polynomial is found by Newton's divided differences.
    std::array<double, nodes> place{}, c{};
    for (std::size_t n = 0; n < nodes; ++n) {
      place[n] = (looks[at[n]].time - begin) / length;
      c[n] = looks[at[n]].value[j];
    }
    for (std::size_t k = 1; k < nodes; ++k)
      for (std::size_t n = nodes - 1; n >= k; --n) c[n] = (c[n] - c[n - 1]) / (place[n] - place[n - k]);
    for (const Look& look : looks) {
      double value = c[nodes - 1];
      for (std::size_t n = nodes - 1; n-- > 0;) value = value * ((look.time - begin) / length - place[n]) + c[n];
      if (std::abs(value - look.value[j]) > closely * (most[j] - least[j])) return false;
    }
  }
  return true;
}

std::vector<Driving::Span> Driving::spans(double from, double to) {
  std::vector<double> ends = corners(from, to);
  ends.insert(ends.begin(), from);
  ends.push_back(to);
  const double least_span = no_time * (std::abs(from) + std::abs(to));
  // Each stretch between corners is sampled by itself, so that no corner hides behind another.
  std::vector<std::vector<Look>> looks;
  std::vector<double> least, most;
  looked_ = 0;
  std::vector<double> kept{from};
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i] - kept.back() <= least_span) continue;
    const double begin = kept.back(), end = ends[i], inside = just_inside * (end - begin);
    const auto count = std::max<std::size_t>(
        4, static_cast<std::size_t>(std::ceil(static_cast<double>(looks_) * (end - begin) / (to - from))));
    std::vector<Look>& here = looks.emplace_back();
    for (std::size_t k = 0; k <= count; ++k) {
      const double part = static_cast<double>(k) / static_cast<double>(count);
      const double time = begin + inside + (end - begin - 2 * inside) * part;
      here.push_back({time, values(time)});
      least.resize(std::max(least.size(), here.back().value.size()), INFINITY);
      most.resize(least.size(), -INFINITY);
      for (std::size_t j = 0; j < here.back().value.size(); ++j) {
        if (!std::isfinite(here.back().value[j])) continue;
        least[j] = std::min(least[j], here.back().value[j]);
        most[j] = std::max(most[j], here.back().value[j]);
      }
    }
    kept.push_back(end);
  }
  std::vector<Span> spans;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    std::vector<Look> fine{looks[i].front()};
    for (std::size_t k = 0; k + 1 < looks[i].size(); ++k) {
      refine(looks[i][k], looks[i][k + 1], least, most, fine, most_halvings);
      fine.push_back(looks[i][k + 1]);
    }
    // Neighbouring samples of similar density make one span.
    double begin = kept[i], shortest = 0, longest = 0;
    std::size_t first = 0;
    const auto close = [&](double end, std::size_t last) {
      const std::vector<Look> own(fine.begin() + static_cast<std::ptrdiff_t>(first),
                                  fine.begin() + static_cast<std::ptrdiff_t>(last) + 1);
      spans.push_back({begin, end, is_polynomial(own, least, most) ? 0 : steps_of_looks * longest});
      begin = end;
      first = last;
      shortest = longest = 0;
    };
    for (std::size_t k = 0; k + 1 < fine.size(); ++k) {
      const double width = fine[k + 1].time - fine[k].time;
      if (k > 0 && (width < 0.2 * longest || width > 5 * shortest)) close(fine[k].time, k);
      shortest = shortest > 0 ? std::min(shortest, width) : width;
      longest = std::max(longest, width);
    }
    close(kept[i + 1], fine.size() - 1);
  }
  return spans;
}

Driving::Span Driving::span_from(double time) {
  auto part = static_cast<long>(std::floor((time - start_) / part_));
  for (;; ++part) {
    const double from = start_ + static_cast<double>(part) * part_, to = start_ + static_cast<double>(part + 1) * part_;
    auto known = known_.find(part);
    if (known == known_.end()) known = known_.emplace(part, spans(from, to)).first;
    for (const Span& span : known->second)
      if (time < span.end - no_time * std::abs(span.end))
        return {std::max(time, span.begin), span.end, span.largest_step};
  }
}

}  // namespace poinsot::problem
