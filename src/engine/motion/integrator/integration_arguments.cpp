#include "engine/motion/integrator/integration_arguments.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace poinsot {

namespace {

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(std::string("integrate: ") + message);
}

bool all_finite(std::span<const double> numbers) {
  return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

bool positive_sizes(const std::vector<double>& sizes, int expected) {
  return sizes.empty() || (sizes.size() == static_cast<std::size_t>(expected) &&
                           std::ranges::all_of(sizes, [](double x) { return x > 0.0 && std::isfinite(x); }));
}

}  // namespace

void check_arguments(const MotionEquations& equations, double start, std::span<const double> q,
                     std::span<const double> v, double end, const IntegrationOptions& options,
                     std::span<const Event> events) {
  require(equations.position_size >= 0 && equations.velocity_size >= 0, "a size of the equations is negative");
  require(q.size() == static_cast<std::size_t>(equations.position_size), "q has not position_size entries");
  require(v.size() == static_cast<std::size_t>(equations.velocity_size), "v has not velocity_size entries");
  require(static_cast<bool>(equations.accelerations), "the equations give no accelerations");
  require(equations.position_rate || equations.position_size == equations.velocity_size,
          "without position_rate there must be as many velocities as coordinates");
  require(!equations.accelerations_at_eight || !equations.position_rate || equations.position_rate_at_eight,
          "accelerations at eight instants need position rates at eight instants too");
  require(positive_sizes(equations.position_sizes, equations.position_size),
          "position_sizes must be empty or positive numbers, one per coordinate");
  require(positive_sizes(equations.velocity_sizes, equations.velocity_size),
          "velocity_sizes must be empty or positive numbers, one per velocity");
  require(std::ranges::all_of(equations.quaternions,
                              [&](int first) { return first >= 0 && first + 4 <= equations.position_size; }),
          "a quaternion lies outside the coordinates");
  require(options.method != IntegrationMethod::collocation || equations.accelerations_at_eight,
          "collocation needs the accelerations at eight instants");
  require(std::isfinite(start) && std::isfinite(end), "the times must be finite");
  require(all_finite(q) && all_finite(v), "the state at the start is not finite");
  require(options.tolerance > 0.0 && options.tolerance < 1.0, "the tolerance must lie between 0 and 1");
  require(options.first_step >= 0.0 && options.largest_step >= 0.0 && options.fixed_step >= 0.0,
          "steps must not be negative");
  require(options.most_steps > 0 && options.work > 0, "the limits must be positive");
  require(std::ranges::all_of(events, [](const Event& event) { return event.value && event.size > 0.0; }),
          "an event needs a value and a positive size");
}

}  // namespace poinsot
