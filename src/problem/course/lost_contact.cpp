#include "problem/course/lost_contact.h"

#include <algorithm>
#include <vector>

#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/model/state.h"

namespace poinsot::problem {

double opening_acceleration(MechanismDynamics& dynamics, std::size_t constraint, std::span<const double> q,
                            std::span<const double> v, double pace_time) {
  std::vector<double> a(v.size()), rate(q.size());
  dynamics.accelerations(q, v, a);
  position_rate<double>(dynamics.mechanism().tree, q, v, rate);
  // The second derivative of the gap from a central difference of its rate. The error goes with the square of the
  // step, 1e-8 of the natural acceleration, and rounding leaves 1e-15/1e-4.
  const double step = 1e-4 * pace_time;
  const auto gap_rate_after = [&](double time) {
    std::vector<double> then_q(q.begin(), q.end()), then_v(v.begin(), v.end());
    for (std::size_t k = 0; k < then_q.size(); ++k) then_q[k] += time * rate[k];
    for (std::size_t k = 0; k < then_v.size(); ++k) then_v[k] += time * a[k];
    return dynamics.gap_rate(constraint, then_q, then_v);
  };
  return (gap_rate_after(step) - gap_rate_after(-step)) / (2 * step);
}

bool would_press_in(MechanismDynamics& dynamics, std::size_t action, std::span<const double> q,
                    std::span<const double> v, double length, double pace_time) {
  const Mechanism<double>& mechanism = dynamics.mechanism();
  const auto normal = std::ranges::find_if(mechanism.constraints, [&](const VelocityConstraint<double>& constraint) {
    return constraint.action == static_cast<int>(action) && constraint.normal;
  });
  if (normal == mechanism.constraints.end()) return false;
  dynamics.set_acting(static_cast<int>(action), false);
  const double opening =
      opening_acceleration(dynamics, static_cast<std::size_t>(normal - mechanism.constraints.begin()), q, v, pace_time);
  constexpr double opens = 1e-6;  // a hundred times the error
  return opening < -opens * length / (pace_time * pace_time);
}

}  // namespace poinsot::problem
