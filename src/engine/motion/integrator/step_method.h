// What every method of integration offers to the loop that drives it (integrate.cpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "engine/motion/integrator/right_side.h"
#include "poinsot/engine/motion/integrator/trajectory.h"

namespace poinsot {

enum class StepOutcome { advanced, too_small, not_finite, stiff, no_convergence };

class StepMethod {
 public:
  virtual ~StepMethod() = default;

  // Starts, or starts anew without memory of what was before. limit: where the integration is to end.
  virtual StepOutcome begin(double t, std::span<const double> y, double limit) = 0;
  // Makes one step, no further than limit, that keeps the error within its scale.
  virtual StepOutcome advance(double limit) = 0;
  virtual double time() const = 0;
  // The state at time(). The loop may change it slightly (projection) and then says so: noticeably if the change is
  // no smaller than a small part of the error allowed.
  virtual std::span<double> state() = 0;
  virtual void state_changed(bool noticeably) = 0;
  // Whether the method needs no projection and no scale of errors: the state is then only asked for where it is wanted.
  virtual bool minds_itself() const { return false; }
  // The step just made. Valid until the next one.
  virtual StepView last_step() = 0;
  // A state of the last step's own method at t within it, where that is more accurate than last_step's evaluation.
  virtual void state_within(double t, std::span<double> y) { last_step().evaluate(t, y); }
  virtual std::int64_t rejected() const = 0;
  // Evaluations of the accelerations that the right side has not counted.
  virtual std::int64_t evaluations() const { return 0; }
  // What a trajectory keeps to evaluate steps of the form `flow`.
  virtual std::shared_ptr<const StateFlow> flow() const { return nullptr; }
};

// Where a step is to end.
struct StepEnd {
  double h = 0, time = 0;
  bool at_limit = false;  // the time is the limit itself
  double smallest = 0;    // a step of this size or below does not move the time by more than rounding
};
// A step of size |h|, at most `largest`, from t towards the limit: no further than that, and no tiny last step, but two
// equal ones instead.
inline constexpr double rounding_of_step = 1e-12;  // of a step: times are sums of thousands of them
inline StepEnd step_towards(double limit, double t, double h, double largest) {
  const double left = limit - t;
  StepEnd step;
  step.h = std::copysign(std::min(std::fabs(h), largest), left);
  step.at_limit = std::fabs(step.h) >= std::fabs(left) * (1.0 - rounding_of_step);
  if (!step.at_limit && 2.0 * std::fabs(step.h) > std::fabs(left)) step.h = 0.5 * left;
  step.time = step.at_limit ? limit : t + step.h;
  step.h = step.time - t;
  step.smallest = 8.0 * std::numeric_limits<double>::epsilon() * std::max(std::fabs(t), std::fabs(step.time));
  return step;
}

// Goes from one time to another by steps step(t, h), halved where that cannot make one. Returns whether it arrives.
template <class Step>
bool step_by_halves(double from, double to, const Step& step) {
  constexpr int most_attempts = 60;  // halvings: below that a step does not move the time
  double t = from;
  double h = to - from;
  for (int attempt = 0; t != to && attempt < most_attempts; ++attempt) {
    if (!step(t, h)) {
      h *= 0.5;
      continue;
    }
    t = std::fabs(to - t) <= std::fabs(h) * (1.0 + rounding_of_step) ? to : t + h;
    h = to - t;
  }
  return t == to;
}

// The first step: such that the change by it is small against the change of the change (Hairer, Norsett, Wanner,
// Section II.4). rate: dy/dt at (t, y). order: of the method. Positive.
double first_step(RightSide& right_side, double t, std::span<const double> y, std::span<const double> rate,
                  std::span<const double> scale, double span, int order);

}  // namespace poinsot
