// Estimates how far a motion may be from the true one.
#include <algorithm>
#include <cmath>
#include <limits>

#include "problem/course/course.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {

// The other motion has a sixteen times larger tolerance, and samples loads and given motions at other and more times:
// it may see what one of them overlooks.
void Course::follow_less_closely(Course& coarse) const {
  coarse.tolerance_ = 16 * tolerance_;
  coarse.looks_ = 2 * looks_ + 617;
  coarse.most_work_ = most_work_;
}

double Course::extremes_error() {
  double largest = 0;
  const auto compare = [&](Course& motion) {
    for (const AskedExtreme& asked : asked_extremes_) {
      const double other = motion.feature(asked.call, asked.axes, asked.mark).number;
      const double size = std::max(std::abs(asked.value), std::abs(other));
      if (size > 0) largest = std::max(largest, std::abs(other - asked.value) / size);
    }
  };
  try {
    if (in_closed_form_) {
      // A pendulum that just reaches its highest place goes over it with a little more, and back with a little less.
      for (const double by : {std::numeric_limits<double>::epsilon(), -std::numeric_limits<double>::epsilon()}) {
        Course beside(stated_, settings_, choice_, open_flights_);
        beside.most_work_ = most_work_;
        for (double& rate : beside.stages_.front().v) rate *= 1 + by;
        compare(beside);
      }
      return largest;
    }
    Course coarse(stated_, settings_, choice_, open_flights_);
    follow_less_closely(coarse);
    compare(coarse);
  } catch (const StatementError&) {
    return std::numeric_limits<double>::infinity();
  }
  return largest;
}

std::optional<MotionError> Course::error(double until) {
  // The time at which a motion departs after a push is as arbitrary as the push.
  const bool nudged = std::any_of(situation_.instants.begin(), situation_.instants.end(),
                                  [](const Instant& instant) { return !instant.nudged.empty(); });
  if (nudged) return std::nullopt;
  const double length = start_->natural_size(dimensions::length);
  MotionError error;
  // The largest differences from another motion up to a time.
  const auto compare = [&](Course& other) {
    constexpr int instants = 200;  // some ten for each swing of a long motion
    for (int i = 1; i <= instants; ++i) {
      const double time = i == instants ? until : until * i / instants;
      const MotionState a = at(time), b = other.at(time);
      for (const auto& body : start_->machine().mechanism.tree.bodies()) {
        const auto q = static_cast<std::size_t>(body.q);
        const int size = position_size(body.joint);
        double sign = 1;
        if (size > 1) {
          double same = 0;
          for (std::size_t k = q; k < q + 4; ++k) same += a.q[k] * b.q[k];
          if (same < 0) sign = -1;
        }
        for (int k = 0; k < size; ++k) {
          const auto place = q + static_cast<std::size_t>(k);
          const bool turning = k < 4 && body.joint != JointType::prismatic;
          // Twice the difference of two quaternions is an angle.
          const double apart = std::abs(a.q[place] - (k < 4 ? sign : 1) * b.q[place]) * (size > 1 && k < 4 ? 2 : 1);
          double& largest = turning ? error.angle : error.length;
          largest = std::max(largest, apart);
        }
      }
    }
    error.relative = std::max(error.angle, error.length / length);
  };
  if (in_closed_form_) {
    // A closed form has only the rounding of its rates, which grows with time: slowly, but exponentially where the
    // motion comes near an unstable equilibrium, as a pendulum that just reaches its highest place. A motion whose
    // rates are off by that from the start, each another way, shows it.
    constexpr double noticed = 1e-9;  // of the size: beyond what answers are shown to
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    try {
      Course beside(stated_, settings_, choice_, open_flights_);
      beside.most_work_ = most_work_;
      std::vector<double>& rates = beside.stages_.front().v;
      for (std::size_t k = 0; k < rates.size(); ++k) rates[k] *= 1 + (k % 2 == 0 ? rounding : -rounding);
      until = std::min(until, beside.follow(until));
      compare(beside);
    } catch (const StatementError&) {
      // What the motion beside meets on its way, as the end of a stage, this one has not met.
      error = {};
    }
    error.angle = std::max(error.angle, rounding * until / pace_time_);
    error.relative = std::max(error.relative, error.angle);
    return error.relative > noticed ? std::optional(error) : std::nullopt;
  }
  until = std::min(until, reached());
  try {
    Course coarse(stated_, settings_, choice_, open_flights_);
    follow_less_closely(coarse);
    try {
      until = std::min(until, coarse.follow(until));
    } catch (const UnansweredError&) {
      // Both motions can be followed equally far, up to their errors.
      if (coarse.reached() < 0.99 * until) throw;
      until = coarse.reached();
    }
    compare(coarse);
  } catch (const StatementError&) {
    error.relative = std::numeric_limits<double>::infinity();
  }
  return error;
}

}  // namespace poinsot::problem
