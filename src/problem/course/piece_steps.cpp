// A piece of a motion followed step by step, as long as that leads on.
#include <algorithm>
#include <cmath>
#include <utility>

#include "poinsot/engine/work/work.h"
#include "problem/course/motion_piece.h"

namespace poinsot::problem {

IntegrationResult Course::Piece::follow(double end, Work most) {
  IntegrationOptions options;
  options.tolerance = motion_.tolerance_;
  options.most_steps = most_steps;
  options.work = std::max<Work>(most, 1);
  options.largest_step = span_.largest_step;
  // A short flight after a blow must not be stepped over.
  if (now_.flight > 0)
    options.largest_step = options.largest_step > 0 ? std::min(options.largest_step, now_.flight / 4) : now_.flight / 4;
  if (lone_) {
    IntegrationOptions fine = options;
    fine.largest_step = now_.flight > 0 ? std::min(motion_.pace_time_, now_.flight / 4) : motion_.pace_time_;
    if (auto by_itself = lone_->follow(equations_, now_.time, now_.q, now_.v, end, fine, events_)) return *by_itself;
  }
  if (still_) std::ranges::fill(now_.v, 0.0);
  // A motion that trembles about a place that it cannot leave goes on so through all steps there are: where some of
  // them lead nowhere, and ten times all of them would not lead to the end, it is given up there.
  constexpr std::int64_t some = most_steps / 20;
  const double nowhere = 1e-4 * motion_.pace_time_;
  std::int64_t steps = 0;
  double from = now_.time;
  options.observer = [&](const StepView& step) {
    if (++steps % some != 0) return true;
    const double gained = std::abs(step.end - std::exchange(from, step.end));
    return gained > nowhere || std::abs(end - step.end) < 10 * gained * most_steps / some;
  };
  IntegrationResult result = integrate(equations_, now_.time, now_.q, now_.v, end, options, events_);
  if (result.ending == Ending::interrupted) result.ending = Ending::step_limit;
  return result;
}

}  // namespace poinsot::problem
