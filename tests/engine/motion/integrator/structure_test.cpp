// The structure-preserving and the stiff methods: order, reversibility, invariants, bounded energy, agreement.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/motion/integrator/motion_examples.h"
#include "poinsot/engine/motion/integrator/integrate.h"

namespace poinsot {
namespace structure_test {

using Numbers = std::vector<double>;

IntegrationOptions equal_steps(double h) {
  IntegrationOptions options;
  options.method = IntegrationMethod::structure_preserving;
  options.fixed_step = h;
  return options;
}

TEST(GaussCollocation, has_order_sixteen) {
  // The change of the pendulum's energy within steps that are short against the period of 7.4 s.
  const auto error = [](double h) {
    const IntegrationResult result = integrate(pendulum(1.0), 0.0, Numbers{2.0}, Numbers{0.0}, 40.0, equal_steps(h));
    EXPECT_EQ(result.statistics.steps, std::lround(40.0 / h));
    return result.drift[0].largest;
  };
  const double order = std::log2(error(1.25) / error(0.625));
  EXPECT_GT(order, 14.0);
  EXPECT_LT(order, 18.0);
}

TEST(GaussCollocation, keeps_quadratic_invariants_whatever_the_step) {
  // The energy of the oscillator, quaternions of unit length and the energy of a heavy body are quadratic.
  IntegrationResult result = integrate(oscillator(1.0), 0.0, Numbers{1.0}, Numbers{0.0}, 500.0, equal_steps(2.5));
  EXPECT_GT(std::fabs(result.q[0] - std::cos(500.0)), 1e-11);
  EXPECT_LT(result.drift[0].largest, 2e-14);

  MotionEquations equations = fixed_point_body({1.0, 2.0, 3.0}, 4.0);
  equations.quaternions.clear();  // nobody takes them to unit length again
  result = integrate(equations, 0.0, Numbers{0.6, 0.0, 0.8, 0.0}, Numbers{0.3, 2.0, -1.0}, 100.0, equal_steps(0.5));
  ASSERT_EQ(result.ending, Ending::reached_end);
  double norm = 0.0;
  for (const double c : result.q) norm += c * c;
  EXPECT_NEAR(norm, 1.0, 1e-13);
  EXPECT_LT(result.drift[0].largest, 1e-12);
}

TEST(GaussCollocation, energy_of_the_pendulum_stays_within_bounds) {
  // In steps of a quarter of the period: the error of the energy is that of one step, and does not grow.
  const auto drift = [](double end) {
    const IntegrationResult result = integrate(pendulum(1.0), 0.0, Numbers{2.0}, Numbers{0.0}, end, equal_steps(2.0));
    EXPECT_EQ(result.ending, Ending::reached_end);
    return result.drift[0].largest;
  };
  const double early = drift(200.0);
  const double late = drift(20'000.0);
  EXPECT_GT(early, 1e-9);
  EXPECT_LT(late, 1.3 * early);
}

TEST(GaussCollocation, rounding_does_not_add_up) {
  const IntegrationResult result =
      integrate(pendulum(1.0), 0.0, Numbers{2.0}, Numbers{0.0}, 40'000.0, equal_steps(0.4));
  EXPECT_EQ(result.statistics.steps, 100'000);
  EXPECT_LT(result.drift[0].largest, 3e-14);
}

TEST(GaussCollocation, goes_back_the_way_it_came) {
  const MotionEquations equations = fixed_point_body({1.0, 2.0, 3.0}, 4.0);
  const Numbers q{1.0, 0.0, 0.0, 0.0};
  const Numbers v{0.3, 2.0, -1.0};
  const IntegrationResult there = integrate(equations, 0.0, q, v, 20.0, equal_steps(0.5));
  const IntegrationResult back = integrate(equations, 20.0, there.q, there.v, 0.0, equal_steps(0.5));
  // Far nearer than the steps are exact.
  const IntegrationResult finer = integrate(equations, 0.0, q, v, 20.0, equal_steps(0.1));
  EXPECT_GT(std::fabs(there.q[1] - finer.q[1]), 1e-9);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(back.q[i], q[i], 1e-10);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(back.v[i], v[i], 1e-10);
}

TEST(GaussCollocation, chooses_its_step_by_the_tolerance_and_gives_states_between) {
  for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
    IntegrationOptions options = equal_steps(0.0);
    options.tolerance = tolerance;
    const IntegrationResult result = integrate(oscillator(1.0), 0.0, Numbers{1.0}, Numbers{0.0}, 50.0, options);
    EXPECT_LT(std::fabs(result.q[0] - std::cos(50.0)), 50.0 * tolerance);
    EXPECT_LT(result.statistics.steps, 40);
    for (double t = 0.0; t < 50.0; t += 0.83)
      EXPECT_NEAR(result.trajectory.state(t).q[0], std::cos(t), 50.0 * tolerance);
  }
}

TEST(GaussCollocation, finds_events) {
  Event event;
  event.value = [](double, std::span<const double> q, std::span<const double>) { return q[0]; };
  event.terminal = true;
  const std::vector<Event> events{event};
  const IntegrationResult result =
      integrate(oscillator(1.0), 0.0, Numbers{1.0}, Numbers{0.0}, 50.0, equal_steps(1.0), events);
  ASSERT_EQ(result.ending, Ending::terminal_event);
  EXPECT_NEAR(result.time, 0.5 * std::numbers::pi, 1e-13);
}

TEST(GaussCollocation, a_step_too_long_to_solve_is_reported) {
  const IntegrationResult result =
      integrate(oscillator(1000.0), 0.0, Numbers{1.0}, Numbers{0.0}, 50.0, equal_steps(1.0));
  EXPECT_EQ(result.ending, Ending::no_convergence);
  EXPECT_NE(describe(result).find("could not be solved"), std::string::npos);
}

// Robertson's kinetics would do; a mass on a stiff damper is mechanics: q'' = -k (q - sin t) - c v.
MotionEquations stiff_damper() {
  MotionEquations equations;
  equations.position_size = equations.velocity_size = 1;
  equations.accelerations = [](double t, std::span<const double> q, std::span<const double> v, std::span<double> a) {
    a[0] = -1e6 * (q[0] - std::sin(t)) - 1e5 * (v[0] - std::cos(t)) - std::sin(t);
  };
  return equations;
}

TEST(StiffMethod, follows_a_stiff_motion_in_few_steps) {
  IntegrationOptions options;
  options.method = IntegrationMethod::stiff;
  options.tolerance = 1e-8;
  // q = sin t solves it; from elsewhere the motion falls onto it within a millisecond.
  const IntegrationResult result = integrate(stiff_damper(), 0.0, Numbers{0.0}, Numbers{2.0}, 20.0, options);
  if (!has_stiff_solver()) {
    EXPECT_EQ(result.ending, Ending::no_stiff_solver);
    EXPECT_NE(describe(result).find("SUNDIALS"), std::string::npos);
    return;
  }
  ASSERT_EQ(result.ending, Ending::reached_end);
  EXPECT_LT(result.statistics.evaluations, 20'000);
  for (double t = 2.0; t <= 20.0; t += 0.77) {
    EXPECT_NEAR(result.trajectory.state(t).q[0], std::sin(t) + 1e-5 * std::exp(-10.0 * t), 1e-6);
    EXPECT_NEAR(result.trajectory.state(t).v[0], std::cos(t), 1e-5);
  }
}

TEST(StiffMethod, agrees_with_the_explicit_method_on_constrained_motion) {
  if (!has_stiff_solver()) return;
  const Numbers q{std::sin(2.0), std::cos(2.0)};
  IntegrationOptions options;
  options.tolerance = 1e-9;
  const IntegrationResult exact = integrate(pendulum_on_circle(1.0), 0.0, q, Numbers{0.0, 0.0}, 10.0, options);
  options.method = IntegrationMethod::stiff;
  const IntegrationResult result = integrate(pendulum_on_circle(1.0), 0.0, q, Numbers{0.0, 0.0}, 10.0, options);
  ASSERT_EQ(result.ending, Ending::reached_end);
  EXPECT_NEAR(result.q[0], exact.q[0], 1e-6);
  EXPECT_NEAR(result.q[1], exact.q[1], 1e-6);
  EXPECT_NEAR(std::hypot(result.q[0], result.q[1]), 1.0, 1e-14);
}

TEST(StiffMethod, failures_are_those_of_the_equations) {
  if (!has_stiff_solver()) return;
  IntegrationOptions options;
  options.method = IntegrationMethod::stiff;
  MotionEquations equations = oscillator(1.0);
  equations.accelerations = [](double t, std::span<const double>, std::span<const double>, std::span<double> a) {
    a[0] = t > 0.7 ? std::nan("") : 1.0;
  };
  const IntegrationResult result = integrate(equations, 0.0, Numbers{0.0}, Numbers{0.0}, 2.0, options);
  EXPECT_EQ(result.ending, Ending::not_finite);
  EXPECT_NEAR(result.time, 0.7, 1e-3);
  equations.accelerations = [](double t, std::span<const double>, std::span<const double>, std::span<double>) {
    if (t > 0.1) throw std::runtime_error("no such state");
  };
  EXPECT_THROW(integrate(equations, 0.0, Numbers{0.0}, Numbers{0.0}, 2.0, options), std::runtime_error);
}

}  // namespace structure_test
}  // namespace poinsot
