// How a motion is followed through a pose where its branches cross.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/motion/integrator/integration_run.h"

namespace poinsot {
namespace {

// A step over a pose where branches cross has it at this part of its length: between 1/3 and 3/5 the method of order 8
// takes no stage, and its dense output none either.
constexpr double without_stage = 0.467;
// The states from which such a step may begin: as many as there are of steps that are not yet short, compared with the
// longest of them.
constexpr std::size_t most_beginnings = 24;
constexpr double not_yet_short = 0.02;

}  // namespace

void IntegrationRun::remember_beginning() {
  if (!equations_.project) return;
  const double length = std::fabs(result_.time - begun_.time);
  double longest = length;
  for (const Beginning& one : beginnings_) longest = std::max(longest, one.length);
  begun_.length = length;
  if (length >= not_yet_short * longest) beginnings_.push_back(begun_);
  if (beginnings_.size() > most_beginnings) beginnings_.pop_front();
}

// Takes back what was found after a state.
void IntegrationRun::go_back_to(const Beginning& beginning) {
  result_.time = beginning.time;
  y_ = beginning.y;
  const auto later = [&](double t) { return std::fabs(t - start_) > std::fabs(beginning.time - start_); };
  std::erase_if(result_.hits, [&](const EventHit& hit) { return later(hit.time); });
  Trajectory before(equations_.position_size, equations_.velocity_size, equations_.quaternions);
  for (std::size_t i = 0; i < result_.trajectory.step_count(); ++i)
    if (const StepView step = result_.trajectory.step(i); !later(step.end)) before.append(step);
  result_.trajectory = std::move(before);
}

// One step from where the motion is now to this time. Nothing if it is none, or ends before.
bool IntegrationRun::step_in_one(double time, std::optional<Ending>& ending) {
  result_.statistics.rejected += method_->rejected();
  result_.statistics.evaluations += method_->evaluations();
  IntegrationOptions options = options_;
  options.first_step = std::fabs(time - result_.time);
  method_ = make_(in_use_, right_side_, scale_, options);
  if (method_->begin(result_.time, y_, end_) != StepOutcome::advanced) return false;
  step_limit_ = time;
  try {
    ending = one_step();
  } catch (const SingularPose&) {
    return false;
  }
  return ending || result_.time == time;
}

// Where constraints lose their independence a motion can go on in several ways, and its accelerations cannot be told
// from those of the other ways: the nearer, the less, so that steps become short and one ends there at last. A moment
// before and after, the motion is known, and it goes through smoothly. So it is followed anew from a state before, with
// a step over the crossing that looks at nothing near it. How good that step is its own estimate tells.
bool IntegrationRun::step_over_crossing(std::optional<Ending>& ending) {
  if (in_use_ != IntegrationMethod::explicit_runge_kutta && in_use_ != IntegrationMethod::automatic) return false;
  const double crossing = method_->time(), sense = end_ > start_ ? 1 : -1;
  bool over = false;
  for (; !over && !beginnings_.empty(); beginnings_.pop_back()) {
    const Beginning& beginning = beginnings_.back();
    for (const double part : {1.0, 0.7, 0.5}) {
      const double length = sense * part * beginning.length, before = crossing - without_stage * length;
      if (over || !(sense * (before - beginning.time) > 0)) continue;
      go_back_to(beginning);
      const double beyond = sense * (before + length - end_) < 0 ? before + length : end_;
      over = step_in_one(before, ending) && (ending || step_in_one(beyond, ending));
    }
  }
  step_limit_ = end_;
  if (over) beginnings_.clear();
  return over;
}

}  // namespace poinsot
