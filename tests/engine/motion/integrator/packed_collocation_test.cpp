// Collocation with its stages evaluated together: against closed forms and other methods, where it is chosen, where it
// gives way.
#include <gtest/gtest.h>

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

#include "engine/dynamics/random_trees.h"
#include "engine/motion/integrator/motion_examples.h"
#include "poinsot/engine/motion/integrator/integrate.h"

namespace poinsot {
namespace packed_collocation_test {

using Numbers = std::vector<double>;

// Equations that evaluate eight instants one after the other.
MotionEquations with_eight_instants(MotionEquations equations) {
  const auto each = [](auto function, std::size_t nq, std::size_t nv, std::size_t count) {
    return [=](std::span<const double> t, std::span<const double> q, std::span<const double> v, std::span<double> out) {
      Numbers own_q(nq), own_v(nv), own(count);
      for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t k = 0; k < nq; ++k) own_q[k] = q[8 * k + i];
        for (std::size_t k = 0; k < nv; ++k) own_v[k] = v[8 * k + i];
        function(t[i], own_q, own_v, own);
        for (std::size_t k = 0; k < count; ++k) out[8 * k + i] = own[k];
      }
    };
  };
  const auto nq = static_cast<std::size_t>(equations.position_size);
  const auto nv = static_cast<std::size_t>(equations.velocity_size);
  equations.accelerations_at_eight = each(equations.accelerations, nq, nv, nv);
  if (equations.position_rate) equations.position_rate_at_eight = each(equations.position_rate, nq, nv, nq);
  return equations;
}

IntegrationOptions unwatched(double tolerance, IntegrationMethod method = IntegrationMethod::automatic) {
  IntegrationOptions options;
  options.tolerance = tolerance;
  options.method = method;
  options.store = false;
  return options;
}

// The pendulum with w = 1 from rest at q0: sin(q/2) = k cd(t), k = sin(q0/2).
double pendulum_angle(double q0, double t) {
  const double k = std::sin(0.5 * q0);
  return 2.0 * std::asin(k * boost::math::jacobi_cd(k, t));
}

bool names_collocation(const IntegrationResult& result) {
  return result.method.find("collocation") != std::string::npos;
}

TEST(PackedCollocation, FollowsTheClosedFormOfThePendulumAtEveryTolerance) {
  const MotionEquations equations = with_eight_instants(pendulum(1.0));
  for (const double end : {20.0, -20.0}) {
    std::int64_t last_evaluations = 0;
    for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13}) {
      const IntegrationResult result = integrate(equations, 0.0, Numbers{2.0}, Numbers{0.0}, end, unwatched(tolerance));
      ASSERT_EQ(result.ending, Ending::reached_end);
      EXPECT_TRUE(names_collocation(result)) << result.method;
      EXPECT_EQ(result.time, end);
      EXPECT_LT(std::fabs(result.q[0] - pendulum_angle(2.0, end)), 20.0 * tolerance + 1e-14) << tolerance;
      EXPECT_GT(result.statistics.evaluations, last_evaluations);
      last_evaluations = result.statistics.evaluations;
    }
  }
}

TEST(PackedCollocation, GivesStatesWithinItsSteps) {
  const MotionEquations equations = with_eight_instants(pendulum(1.0));
  IntegrationOptions options = unwatched(1e-10, IntegrationMethod::collocation);
  options.store = true;
  const IntegrationResult result = integrate(equations, 0.0, Numbers{2.0}, Numbers{0.0}, 20.0, options);
  // Few long steps.
  EXPECT_LT(result.trajectory.step_count(), 60U);
  for (double t = 0.0; t < 20.0; t += 0.137)
    EXPECT_NEAR(result.trajectory.state(t).q[0], pendulum_angle(2.0, t), 1e-8) << t;
}

TEST(PackedCollocation, AgreesWithTheExplicitMethodOnRandomTrees) {
  testing::Random random(11);
  int followed = 0;
  for (int i = 0; i < 40; ++i) {
    const Model<double> model = testing::built(testing::random_tree(random));
    const State<double> start = testing::random_state(random, model);
    const MotionEquations equations = tree_equations(model);
    const IntegrationResult packed = integrate(equations, 0.0, start.q, start.v, 0.5, unwatched(1e-11));
    const IntegrationResult one_by_one =
        integrate(equations, 0.0, start.q, start.v, 0.5, unwatched(1e-11, IntegrationMethod::explicit_runge_kutta));
    ASSERT_TRUE(packed.complete() && one_by_one.complete());
    followed += names_collocation(packed) && !names_collocation(one_by_one);
    for (std::size_t k = 0; k < packed.q.size(); ++k)
      EXPECT_NEAR(packed.q[k], one_by_one.q[k], 1e-7) << "tree " << i << ", coordinate " << k;
  }
  EXPECT_EQ(followed, 40);
}

TEST(PackedCollocation, IsNotTakenWhereStatesOnTheWayAreAsked) {
  const MotionEquations equations = with_eight_instants(pendulum(1.0));
  IntegrationOptions options = unwatched(1e-8);
  const auto run = [&](std::span<const Event> events) {
    return integrate(equations, 0.0, Numbers{2.0}, Numbers{0.0}, 5.0, options, events);
  };
  EXPECT_TRUE(names_collocation(run({})));
  Event event;
  event.value = [](double, std::span<const double> q, std::span<const double>) { return q[0]; };
  EXPECT_FALSE(names_collocation(run(std::span(&event, 1))));
  options.observer = [](const StepView&) { return true; };
  EXPECT_FALSE(names_collocation(run({})));
  options.observer = nullptr;
  options.store = true;
  EXPECT_FALSE(names_collocation(run({})));
}

TEST(PackedCollocation, GivesWayToOtherMethodsWhereItDoesBadly) {
  // Stiff: what falls back to the line in 10 us.
  MotionEquations equations = oscillator(1.0);
  equations.conserved.clear();
  equations.accelerations = [](double t, std::span<const double> q, std::span<const double> v, std::span<double> a) {
    a[0] = -1e5 * (v[0] + 1e2 * (q[0] - std::sin(t)));
  };
  const IntegrationResult stiff =
      integrate(with_eight_instants(equations), 0.0, Numbers{0.0}, Numbers{0.0}, 1.0, unwatched(1e-6));
  EXPECT_EQ(stiff.ending, Ending::reached_end);
  EXPECT_NE(stiff.method.find(", then "), std::string::npos) << stiff.method;
  EXPECT_NEAR(stiff.q[0], std::sin(1.0) - 0.01 * std::cos(1.0), 3e-4);

  // A force that jumps: no polynomial has that.
  equations.accelerations = [](double t, std::span<const double>, std::span<const double>, std::span<double> a) {
    a[0] = t < 1.0 / 3.0 ? 1.0 : -1.0;
  };
  const IntegrationResult jump =
      integrate(with_eight_instants(equations), 0.0, Numbers{0.0}, Numbers{0.0}, 1.0, unwatched(1e-9));
  EXPECT_EQ(jump.ending, Ending::reached_end);
  EXPECT_NEAR(jump.v[0], -1.0 / 3.0, 1e-7);

  // No finite accelerations from some time on.
  equations.accelerations = [](double t, std::span<const double>, std::span<const double>, std::span<double> a) {
    a[0] = t > 0.7 ? std::nan("") : 1.0;
  };
  const IntegrationResult end =
      integrate(with_eight_instants(equations), 0.0, Numbers{0.0}, Numbers{0.0}, 1.0, unwatched(1e-9));
  EXPECT_EQ(end.ending, Ending::not_finite);
  EXPECT_NEAR(end.time, 0.7, 1e-6);
}

TEST(PackedCollocation, NeedsAccelerationsAtEightInstants) {
  const auto run = [](const MotionEquations& equations, Numbers q, IntegrationMethod method) {
    integrate(equations, 0.0, q, Numbers{0.0}, 1.0, unwatched(1e-8, method));
  };
  EXPECT_THROW(run(pendulum(1.0), Numbers{1.0}, IntegrationMethod::collocation), std::invalid_argument);
  MotionEquations half = with_eight_instants(pendulum(1.0));
  half.position_rate = [](double, std::span<const double>, std::span<const double> v, std::span<double> rate) {
    rate[0] = v[0];
  };
  EXPECT_THROW(run(half, Numbers{1.0}, IntegrationMethod::automatic), std::invalid_argument);
}

}  // namespace packed_collocation_test
}  // namespace poinsot
