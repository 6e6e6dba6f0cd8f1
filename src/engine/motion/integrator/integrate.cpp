#include "poinsot/engine/motion/integrator/integrate.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "engine/motion/integrator/dormand_prince_853.h"
#include "engine/motion/integrator/event_search.h"
#include "engine/motion/integrator/integration_arguments.h"
#include "engine/motion/integrator/integration_run.h"
#include "engine/motion/integrator/methods.h"
#include "engine/motion/integrator/packed_collocation.h"
#include "poinsot/engine/work/budget.h"
#include "poinsot/engine/work/work.h"

namespace poinsot {

namespace {

constexpr Work of_a_step = 50;  // for each number of the state, beside the accelerations

}  // namespace

Ending IntegrationRun::ending_of(StepOutcome outcome) {
  switch (outcome) {
    case StepOutcome::not_finite:
      return Ending::not_finite;
    case StepOutcome::stiff:
      return Ending::stiff;
    case StepOutcome::no_convergence:
      return Ending::no_convergence;
    case StepOutcome::advanced:
    case StepOutcome::too_small:
      break;
  }
  return Ending::step_too_small;
}

std::string IntegrationRun::words_of(IntegrationMethod method) {
  switch (method) {
    case IntegrationMethod::stiff:
      return "integrated by backward differentiation formulas";
    case IntegrationMethod::structure_preserving:
    case IntegrationMethod::collocation:
      return "integrated by Gauss-Legendre collocation of order 16";
    case IntegrationMethod::automatic:
    case IntegrationMethod::explicit_runge_kutta:
      break;
  }
  return "integrated by Dormand and Prince's method of order 8";
}

std::optional<Ending> IntegrationRun::begin(IntegrationMethod method, double start, std::span<const double> y) {
  if (method_) {
    result_.statistics.rejected += method_->rejected();
    result_.statistics.evaluations += method_->evaluations();
  }
  if (method == IntegrationMethod::automatic && equations_.accelerations_at_eight && !is_watched())
    method = IntegrationMethod::collocation;
  in_use_ = method;
  method_ = make_(method, right_side_, scale_, options_);
  if (!method_) return Ending::no_stiff_solver;
  result_.method += (result_.method.empty() ? "" : ", then ") + words_of(method);
  const StepOutcome outcome = method_->begin(start, y, end_);
  if (outcome != StepOutcome::advanced) return ending_of(outcome);
  result_.trajectory.keep(method_->flow());
  return std::nullopt;
}

void IntegrationRun::note_drift(double t, std::span<const double> y) {
  for (std::size_t i = 0; i < equations_.conserved.size(); ++i) {
    const double value = equations_.conserved[i].value(t, right_side_.q(y), right_side_.v(y));
    if (result_.drift.size() <= i) {
      result_.drift.push_back({equations_.conserved[i].name, value, 0.0, 0.0});
    } else {
      Drift& drift = result_.drift[i];
      drift.end = value - drift.start;
      drift.largest = std::max(drift.largest, std::fabs(drift.end));
    }
  }
}

// The ends of the parts of a step in which an event's value has no corner.
std::vector<double> IntegrationRun::smooth_parts(const Event& event, const StepView& step) {
  std::vector<double> ends{step.start, step.end};
  if (event.corners.empty()) return ends;
  // The polynomials of a step have some eight turns at most.
  constexpr int looks = 16;
  const double sense = step.length > 0.0 ? 1.0 : -1.0;
  std::vector<double> times;
  for (int k = 0; k <= looks; ++k) times.push_back(step.start + (step.end - step.start) * k / looks);
  times.back() = step.end;
  for (const EventCorner& corner : event.corners) {
    const auto value = [&](double t) {
      step.evaluate(t, y_sample_);
      return corner.value(t, right_side_.q(y_sample_), right_side_.v(y_sample_));
    };
    std::vector<double> found = corners_between(value, corner.turns, times);
    // A look at one corner may show another, which lies in a notch.
    times.insert(times.end(), found.begin(), found.end());
    std::ranges::sort(times, {}, [&](double t) { return sense * t; });
    ends.insert(ends.end(), found.begin(), found.end());
  }
  std::ranges::sort(ends, {}, [&](double t) { return sense * t; });
  // What is left between two that are nearly one would be rounding.
  const double no_part = 1e-13 * std::fabs(step.length);
  std::vector<double> apart{step.start};
  for (const double t : ends)
    if (sense * (t - apart.back()) > no_part && sense * (step.end - t) > no_part) apart.push_back(t);
  apart.push_back(step.end);
  return apart;
}

// Appends the hits in the step. True if a terminal one cut it: then step.end is that instant and y_end the state there.
bool IntegrationRun::find_events(StepView& step, std::vector<double>& y_end) {
  struct Found {
    std::size_t event;
    Zero zero;
  };
  std::vector<Found> found;
  const double sense = step.length > 0.0 ? 1.0 : -1.0;
  // How near the start of a step a zero is still that of the start: what leaves zero with the fourth power of the time
  // is there far below the tolerance, as a part of what it comes to in the step.
  const double resolution = 1e-3 * std::pow(options_.tolerance, 0.25) * std::fabs(step.length);
  for (std::size_t i = 0; i < events_.size(); ++i) {
    const Event& event = events_[i];
    const auto value = [&](double t) {
      check_budget();
      step.evaluate(t, y_sample_);
      return event.value(t, right_side_.q(y_sample_), right_side_.v(y_sample_));
    };
    const double touch = event.touching ? options_.tolerance * event.size : 0.0;
    const std::vector<double> parts = smooth_parts(event, step);
    for (std::size_t k = 0; k + 1 < parts.size(); ++k)
      for (const Zero& zero :
           find_zeros({value, parts[k], parts[k + 1], touch, k == 0 && zero_at_start_[i] != 0, resolution})) {
        const bool wanted = zero.direction == 0 || event.crossing == Crossing::any ||
                            (event.crossing == Crossing::rising) == (zero.direction > 0);
        if (wanted) found.push_back({i, zero});
      }
    zero_at_start_[i] = 0;
  }
  std::ranges::stable_sort(found, {}, [&](const Found& f) { return sense * f.zero.time; });
  for (const Found& f : found) {
    const bool terminal = events_[f.event].terminal;
    if (terminal) {
      step.end = f.zero.time;
      method_->state_within(step.end, y_end);
      right_side_.project(step.end, y_end, scale_.allowed());
    }
    if (terminal) {
      y_sample_ = y_end;
    } else {
      step.evaluate(f.zero.time, y_sample_);
      right_side_.project(f.zero.time, y_sample_, scale_.allowed());
    }
    const auto q = right_side_.q(y_sample_);
    const auto v = right_side_.v(y_sample_);
    result_.hits.push_back({f.event, f.zero.time, f.zero.direction, {q.begin(), q.end()}, {v.begin(), v.end()}});
    if (terminal) return true;
  }
  // An event that ends its step exactly at zero starts the next one there.
  for (const Found& f : found) {
    if (f.zero.time == step.end) zero_at_start_[f.event] = 1;
  }
  return false;
}

// What goes on where the method in use does badly, if the choice was left open.
std::optional<IntegrationMethod> IntegrationRun::successor(StepOutcome outcome) const {
  if (options_.method != IntegrationMethod::automatic || outcome == StepOutcome::advanced) return std::nullopt;
  if (in_use_ == IntegrationMethod::collocation) return IntegrationMethod::explicit_runge_kutta;
  if (in_use_ != IntegrationMethod::stiff && outcome == StepOutcome::stiff && has_stiff_solver())
    return IntegrationMethod::stiff;
  return std::nullopt;
}

// Nothing if the integration goes on.
std::optional<Ending> IntegrationRun::one_step() {
  const StepOutcome outcome = method_->advance(step_limit_);
  const std::optional<IntegrationMethod> next = successor(outcome);
  if (outcome == StepOutcome::stiff && options_.method == IntegrationMethod::automatic) {
    // The step that raised the suspicion is good. The next ones are another method's, or go on as they did, to the
    // limits stated.
  } else if (next) {
    // No step was made.
    return begin(*next, result_.time, y_);
  } else if (outcome != StepOutcome::advanced) {
    return ending_of(outcome);
  }
  ++result_.statistics.steps;

  StepView step;
  if (is_watched()) step = method_->last_step();
  bool cut = false;
  if (!events_.empty()) cut = find_events(step, y_);
  if (cut) {
    result_.time = step.end;
  } else {
    result_.time = method_->time();
    if (!method_->minds_itself()) {
      const double change = right_side_.project(result_.time, method_->state(), scale_.allowed());
      // Taking quaternions to unit length again is rounding to every method, or smaller than its error.
      method_->state_changed(equations_.project && change > 0.01);
      std::ranges::copy(method_->state(), y_.begin());
      scale_.update(y_);
    } else if (watches_drift()) {
      std::ranges::copy(method_->state(), y_.begin());
    }
  }
  if (watches_drift()) note_drift(result_.time, y_);
  if (options_.store) result_.trajectory.append(step);
  if (options_.observer && !options_.observer(step)) return Ending::interrupted;
  if (cut) return Ending::terminal_event;
  if (result_.time == end_) return Ending::reached_end;
  if (next) return begin(*next, result_.time, y_);
  return std::nullopt;
}

IntegrationResult IntegrationRun::go(std::span<const double> q, std::span<const double> v) {
  const WorkLimit limit(options_.work);
  y_.assign(q.begin(), q.end());
  y_.insert(y_.end(), v.begin(), v.end());
  y_sample_ = y_;
  scale_.update(y_);
  std::optional<Ending> ending;
  try {
    right_side_.project(result_.time, y_, scale_.allowed());
  } catch (const SingularPose&) {
    ending = Ending::singular_pose;
  }
  scale_.update(y_);
  if (watches_drift()) note_drift(result_.time, y_);
  // A value that is zero at the start up to rounding of the state.
  for (const Event& event : events_) {
    const double value = event.value(result_.time, right_side_.q(y_), right_side_.v(y_));
    zero_at_start_.push_back(std::fabs(value) <= options_.tolerance * event.size);
  }

  if (!ending) ending = begin(options_.method, result_.time, y_);
  if (!ending && result_.time == end_) ending = Ending::reached_end;
  while (!ending) {
    try {
      if (equations_.project) begun_ = {result_.time, 0, y_};
      ending = one_step();
      remember_beginning();
    } catch (const SingularPose&) {
      const double time = method_->time();
      const std::vector<double> y(method_->state().begin(), method_->state().end());
      if (step_over_crossing(ending)) continue;
      result_.time = time;
      y_ = y;
      ending = Ending::singular_pose;
    }
    if (ending) break;
    if (result_.statistics.steps >= options_.most_steps) ending = Ending::step_limit;
    count_work(of_a_step * static_cast<Work>(right_side_.size()));
    progress_.tell((result_.time - start_) / (end_ - start_), static_cast<std::size_t>(result_.statistics.steps));
    if (limit.spent()) ending = Ending::work_limit;
  }
  if (method_) result_.statistics.rejected += method_->rejected();
  result_.ending = *ending;
  result_.statistics.evaluations += right_side_.evaluations() + (method_ ? method_->evaluations() : 0);
  // A method that minds itself has not been asked for its state at every step; an event has given its own.
  if (method_ && method_->minds_itself() && *ending != Ending::terminal_event)
    std::ranges::copy(method_->state(), y_.begin());
  result_.q.assign(y_.begin(), y_.begin() + equations_.position_size);
  result_.v.assign(y_.begin() + equations_.position_size, y_.end());
  return std::move(result_);
}

namespace {

// Integrates once more, sixteen times coarser, and compares at the ends of its steps and within them.
void estimate_error(const MethodMaker& make, const MotionEquations& equations, double start, std::span<const double> q,
                    std::span<const double> v, const IntegrationOptions& options, const IntegrationRun& fine,
                    IntegrationResult& result) {
  const std::size_t nq = q.size();
  const auto apart = [&](std::span<const double> y, std::span<const double> fine_q, std::span<const double> fine_v) {
    double largest = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double exact = i < nq ? fine_q[i] : fine_v[i - nq];
      largest = std::max(largest, std::fabs(y[i] - exact) / fine.size(i));
    }
    return largest;
  };
  IntegrationOptions coarse = options;
  coarse.tolerance = std::min(0.5, 16.0 * options.tolerance);
  if (options.fixed_step > 0.0) coarse.fixed_step = 1.25 * options.fixed_step;
  coarse.store = false;
  coarse.watch_drift = false;
  coarse.estimate_error = false;
  coarse.observer = nullptr;
  std::vector<double> y(nq + v.size());
  if (options.store && !result.trajectory.empty()) {
    coarse.observer = [&](const StepView& step) {
      for (const double part : {0.3, 0.7, 1.0}) {
        const double t = part == 1.0 ? step.end : step.start + part * step.length;
        step.evaluate(t, y);
        const State<double> at = result.trajectory.state(t);
        result.error.largest = std::max(result.error.largest, apart(y, at.q, at.v));
      }
      return true;
    };
  }
  const IntegrationResult other = IntegrationRun(make, equations, coarse, {}, start, result.time).go(q, v);
  result.statistics.evaluations += other.statistics.evaluations;
  const double unknown = std::numeric_limits<double>::infinity();
  const bool arrived = other.ending == Ending::reached_end;
  for (std::size_t i = 0; i < nq; ++i)
    result.error.q.push_back(arrived ? std::fabs(other.q[i] - result.q[i]) : unknown);
  for (std::size_t i = 0; i < v.size(); ++i)
    result.error.v.push_back(arrived ? std::fabs(other.v[i] - result.v[i]) : unknown);
  if (!arrived) {
    result.error.largest = unknown;
    return;
  }
  y.assign(other.q.begin(), other.q.end());
  y.insert(y.end(), other.v.begin(), other.v.end());
  result.error.largest = std::max(result.error.largest, apart(y, result.q, result.v));
}

}  // namespace

std::unique_ptr<StepMethod> make_general_method(IntegrationMethod method, RightSide& right_side,
                                                const ErrorScale& scale, const IntegrationOptions& options) {
  switch (method) {
    case IntegrationMethod::stiff:
      return make_stiff_method(right_side, scale, options.first_step, options.largest_step);
    case IntegrationMethod::collocation:
      return make_packed_collocation(right_side, scale, options.first_step, options.largest_step);
    case IntegrationMethod::structure_preserving:
      return make_gauss_method(right_side, scale, options.fixed_step);
    case IntegrationMethod::automatic:
    case IntegrationMethod::explicit_runge_kutta:
      break;
  }
  return std::make_unique<DormandPrince853>(right_side, scale, options.first_step, options.largest_step);
}

IntegrationResult integrate_by(const MethodMaker& make, const MotionEquations& equations, double start,
                               std::span<const double> q, std::span<const double> v, double end,
                               const IntegrationOptions& options, std::span<const Event> events) {
  check_arguments(equations, start, q, v, end, options, events);
  IntegrationRun run(make, equations, options, events, start, end);
  IntegrationResult result = run.go(q, v);
  if (options.estimate_error) estimate_error(make, equations, start, q, v, options, run, result);
  return result;
}

IntegrationResult integrate(const MotionEquations& equations, double start, std::span<const double> q,
                            std::span<const double> v, double end, const IntegrationOptions& options,
                            std::span<const Event> events) {
  return integrate_by(make_general_method, equations, start, q, v, end, options, events);
}

}  // namespace poinsot
