// The motion through stages that follow one another.
#include <algorithm>
#include <boost/numeric/odeint.hpp>

#include "statement/instant.h"
#include "statement/reader.h"

namespace poinsot::statement {

// The motion from the first stage's start to the start of stage `count`.
void SolvedInstant::run_stages(std::size_t count) {
  build(0, problem_.stages[0].loads);
  const auto instants = instants_at(0);
  for (std::size_t k = 1; k < problem_.stages.size(); ++k) instants_at(k);
  set_positions(instants);
  solve_velocities(instants, std::nullopt);
  if (!velocities_.open.empty() && count > 0)
    fail(problem_.file, problem_.stages[0].mark,
         "the motion at the start of stage '" + problem_.stages[0].name +
             "' is not fixed: " + velocity_equations_.name(velocities_.share.front().front()) + " is unknown",
         "state it under instants: {" + problem_.stages[0].name + ".start: {...}}");
  const auto n_q = machine_.q.size();
  for (std::size_t stage = 0; stage < count; ++stage) {
    const Stage& now = problem_.stages[stage];
    if (!now.lasts)
      fail(problem_.file, now.mark, "stage '" + now.name + "' does not say how long it lasts", "write lasts: 2 s");
    const double duration = data_->number(*now.lasts, dimensions::time);
    if (!(duration >= 0)) fail(problem_.file, now.lasts->mark(), "a stage lasts no negative time");
    // Coordinates and velocities together; a controlled method of order eight.
    std::vector<double> y = machine_.q;
    y.insert(y.end(), v_.begin(), v_.end());
    const double start = time_;
    const auto derivative = [&](const std::vector<double>& state, std::vector<double>& rate, double time) {
      const std::vector<double> q(state.begin(), state.begin() + static_cast<std::ptrdiff_t>(n_q));
      const std::vector<double> v(state.begin() + static_cast<std::ptrdiff_t>(n_q), state.end());
      rate.resize(state.size());
      position_rate<double>(machine_.mechanism.tree, q, v, std::span<double>(rate.data(), n_q));
      const std::vector<double> a = accelerations_at(time, q, v, stage);
      std::copy(a.begin(), a.end(), rate.begin() + static_cast<std::ptrdiff_t>(n_q));
    };
    namespace odeint = boost::numeric::odeint;
    auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<std::vector<double>>>(1e-12, 1e-12);
    if (duration > 0) {
      constexpr int most_steps = 100'000;
      int steps = 0;
      odeint::integrate_adaptive(
          stepper, derivative, y, start, start + duration, duration / 100, [&](const std::vector<double>&, double) {
            if (++steps > most_steps)
              fail(problem_.file, now.mark, "stage '" + now.name + "' needs more than 100 000 steps",
                   "let it last shorter");
          });
    }
    build(start + duration, problem_.stages[stage + 1].loads);
    machine_.q.assign(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(n_q));
    moment_->set_positions(machine_.q);
    solve_velocities({}, std::vector<double>(y.begin() + static_cast<std::ptrdiff_t>(n_q), y.end()));
  }
}

std::vector<double> SolvedInstant::accelerations_at(double time, const std::vector<double>& q,
                                                    const std::vector<double>& v, std::size_t stage) {
  build(time, problem_.stages[stage].loads);
  machine_.q = q;
  v_ = v;
  moment_->set_positions(q);
  moment_->set_velocities(v);
  solve_forces();
  for (std::size_t k = 0; k < v.size(); ++k)
    if (!motion_->determined(k))
      fail(problem_.file, problem_.stages[stage].mark,
           "the motion in stage '" + problem_.stages[stage].name + "' is not determined: the " +
               motion_equations_.name(k) + " is open");
  return moment_->accelerations();
}

}  // namespace poinsot::statement
