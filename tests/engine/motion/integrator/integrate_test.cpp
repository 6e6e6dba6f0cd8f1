// Integration against closed forms: orders, dense output, constraints, unit quaternions, limits and failures.
#include "poinsot/engine/motion/integrator/integrate.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/motion/integrator/motion_examples.h"
#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/model/builder.h"

namespace poinsot {
namespace integrate_test {

using Numbers = std::vector<double>;

// The pendulum with w = 1 from rest at q0, by Jacobi's functions: sin(q/2) = k cd(t), k = sin(q0/2).
double pendulum_angle(double q0, double t) {
  const double k = std::sin(0.5 * q0);
  return 2.0 * std::asin(k * boost::math::jacobi_cd(k, t));
}

IntegrationOptions with_tolerance(double tolerance) {
  IntegrationOptions options;
  options.tolerance = tolerance;
  return options;
}

double pendulum_error(const IntegrationOptions& options, double end, IntegrationResult* out = nullptr) {
  const IntegrationResult result = integrate(pendulum(1.0), 0.0, Numbers{2.0}, Numbers{0.0}, end, options);
  EXPECT_EQ(result.ending, Ending::reached_end);
  EXPECT_EQ(result.time, end);
  if (out) *out = result;
  return std::fabs(result.q[0] - pendulum_angle(2.0, end));
}

TEST(Integrate, follows_the_closed_form_of_the_pendulum_at_every_tolerance) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const double error = pendulum_error(with_tolerance(tolerance), 20.0);
    EXPECT_LT(error, 20.0 * tolerance) << tolerance;
  }
  EXPECT_GT(pendulum_error(with_tolerance(1e-4), 20.0), 1e-8);
}

TEST(Integrate, the_explicit_method_has_order_eight) {
  // Equal steps: the tolerance asks for nothing.
  const auto error = [](double h) {
    IntegrationOptions options = with_tolerance(0.5);
    options.first_step = options.largest_step = h;
    const MotionEquations equations = oscillator(1.0);
    const IntegrationResult result = integrate(equations, 0.0, Numbers{1.0}, Numbers{0.0}, 8.0, options);
    EXPECT_EQ(result.statistics.steps, std::lround(8.0 / h));
    return std::hypot(result.q[0] - std::cos(8.0), result.v[0] + std::sin(8.0));
  };
  const double order = std::log2(error(0.5) / error(0.25));
  EXPECT_GT(order, 7.7);
  EXPECT_LT(order, 8.6);
}

TEST(Integrate, dense_output_has_order_seven_and_joins_the_steps) {
  const auto error = [](double h) {
    IntegrationOptions options = with_tolerance(0.5);
    options.first_step = options.largest_step = h;
    const Trajectory path = integrate(oscillator(1.0), 0.0, Numbers{1.0}, Numbers{0.0}, 4.0, options).trajectory;
    double largest = 0.0;
    // The error within the step that a local solution would have: against the circle through the step's start.
    for (std::size_t i = 0; i < path.step_count(); ++i) {
      const StepView step = path.step(i);
      const State<double> start = path.state(step.start);
      for (int k = 1; k < 20; ++k) {
        const double s = 0.05 * k * step.length;
        const double exact = start.q[0] * std::cos(s) + start.v[0] * std::sin(s);
        largest = std::max(largest, std::fabs(path.state(step.start + s).q[0] - exact));
      }
    }
    return largest;
  };
  const double order = std::log2(error(0.5) / error(0.25));
  EXPECT_GT(order, 7.6);  // local order: one more
  EXPECT_LT(order, 8.6);

  const Trajectory path = integrate(pendulum(1.0), 0.0, Numbers{2.0}, Numbers{0.0}, 20.0).trajectory;
  EXPECT_EQ(path.start_time(), 0.0);
  EXPECT_EQ(path.end_time(), 20.0);
  Numbers left(2);
  Numbers right(2);
  for (std::size_t i = 0; i + 1 < path.step_count(); ++i) {
    path.step(i).evaluate(path.step(i).end, left);
    path.step(i + 1).evaluate(path.step(i + 1).start, right);
    EXPECT_NEAR(left[0], right[0], 1e-15);
    EXPECT_NEAR(left[1], right[1], 1e-15);
  }
}

TEST(Integrate, dense_output_keeps_the_tolerance) {
  for (const double tolerance : {1e-5, 1e-8, 1e-11}) {
    const Trajectory path =
        integrate(pendulum(1.0), 0.0, Numbers{2.0}, Numbers{0.0}, 20.0, with_tolerance(tolerance)).trajectory;
    double largest = 0.0;
    for (double t = 0.0; t < 20.0; t += 0.0137) {
      largest = std::max(largest, std::fabs(path.state(t).q[0] - pendulum_angle(2.0, t)));
    }
    EXPECT_LT(largest, 30.0 * tolerance) << tolerance;
  }
}

TEST(Integrate, runs_backwards_to_where_it_came_from) {
  const MotionEquations equations = fixed_point_body({1.0, 2.0, 3.0}, 4.0);
  const Numbers q{1.0, 0.0, 0.0, 0.0};
  const Numbers v{0.3, 2.0, -1.0};
  const IntegrationResult there = integrate(equations, 1.0, q, v, 11.0, with_tolerance(1e-11));
  const IntegrationResult back = integrate(equations, 11.0, there.q, there.v, 1.0, with_tolerance(1e-11));
  ASSERT_EQ(back.ending, Ending::reached_end);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(back.q[i], q[i], 1e-8);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(back.v[i], v[i], 1e-8);
  // And at every instant between.
  for (double t = 1.0; t <= 11.0; t += 0.31) {
    const State<double> forth = there.trajectory.state(t);
    const State<double> again = back.trajectory.state(t);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(forth.q[i], again.q[i], 1e-8);
  }
}

TEST(Integrate, quaternions_stay_of_unit_length_and_drift_is_reported) {
  const MotionEquations equations = fixed_point_body({1.0, 2.0, 3.0}, 4.0);
  for (const IntegrationMethod method :
       {IntegrationMethod::explicit_runge_kutta, IntegrationMethod::structure_preserving}) {
    IntegrationOptions options = with_tolerance(1e-9);
    options.method = method;
    const IntegrationResult result =
        integrate(equations, 0.0, Numbers{0.6, 0.0, 0.8, 0.0}, Numbers{0.3, 2.0, -1.0}, 30.0, options);
    ASSERT_EQ(result.ending, Ending::reached_end);
    for (double t = 0.0; t <= 30.0; t += 0.7) {
      const Numbers q = result.trajectory.state(t).q;
      EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1.0, 1e-15);
    }
    ASSERT_EQ(result.drift.size(), 2U);
    EXPECT_EQ(result.drift[0].name, "energy");
    // T = (1 x 0.09 + 2 x 4 + 3 x 1)/2, height of the mass center 0.36 - 0.64.
    EXPECT_NEAR(result.drift[0].start, 0.5 * (0.09 + 8.0 + 3.0) + 4.0 * (0.36 - 0.64), 1e-14);
    for (const Drift& drift : result.drift) {
      EXPECT_LT(drift.largest, 1e-6) << drift.name;
      EXPECT_GT(drift.largest, 0.0) << drift.name;
      EXPECT_LE(std::fabs(drift.end), drift.largest);
    }
  }
}

TEST(Integrate, constraints_hold_without_drift) {
  const double q0 = 2.0;
  const Numbers q{std::sin(q0), std::cos(q0)};
  for (const double tolerance : {1e-6, 1e-10}) {
    const IntegrationResult result =
        integrate(pendulum_on_circle(1.0), 0.0, q, Numbers{0.0, 0.0}, 200.0, with_tolerance(tolerance));
    ASSERT_EQ(result.ending, Ending::reached_end);
    EXPECT_NEAR(std::hypot(result.q[0], result.q[1]), 1.0, 4e-16);
    EXPECT_NEAR(result.q[0] * result.v[0] + result.q[1] * result.v[1], 0.0, 4e-16);
    EXPECT_NEAR(std::atan2(result.q[0], result.q[1]), pendulum_angle(q0, 200.0), 3e3 * tolerance);
    for (double t = 0.0; t < 200.0; t += 3.7) {
      const State<double> state = result.trajectory.state(t);
      EXPECT_NEAR(std::hypot(state.q[0], state.q[1]), 1.0, 10.0 * tolerance);
    }
  }
}

TEST(Integrate, a_start_off_the_constraints_is_projected) {
  const IntegrationResult result = integrate(pendulum_on_circle(1.0), 0.0, Numbers{0.0, 2.0}, Numbers{0.0, 1.0}, 1.0);
  EXPECT_NEAR(result.q[0], 0.0, 1e-15);
  EXPECT_NEAR(result.q[1], 1.0, 1e-15);
}

TEST(Integrate, natural_sizes_set_the_error_allowed) {
  // Two oscillators, one of them a thousand times smaller: with its own size it is followed as closely.
  MotionEquations equations;
  equations.position_size = equations.velocity_size = 2;
  equations.accelerations = [](double, std::span<const double> q, std::span<const double>, std::span<double> a) {
    a[0] = -q[0];
    a[1] = -100.0 * q[1];
  };
  const auto error = [&](Numbers sizes) {
    equations.position_sizes = sizes;
    equations.velocity_sizes = {sizes[0], 10.0 * sizes[1]};
    const IntegrationResult result =
        integrate(equations, 0.0, Numbers{1.0, 1e-3}, Numbers{0.0, 0.0}, 10.0, with_tolerance(1e-7));
    return std::fabs(result.q[1] - 1e-3 * std::cos(100.0)) / 1e-3;
  };
  EXPECT_LT(error({1.0, 1e-3}), 1e-5);
  EXPECT_GT(error({1.0, 1.0}), 1e-5);
}

TEST(Integrate, the_error_estimate_bounds_the_error) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> amplitude(0.3, 2.8);
  int bounded = 0;
  double loosest = 0.0;
  for (int i = 0; i < 200; ++i) {
    IntegrationOptions options = with_tolerance(std::pow(10.0, -4.0 - i % 7));
    options.estimate_error = true;
    const double q0 = amplitude(random);
    const IntegrationResult result = integrate(pendulum(1.0), 0.0, Numbers{q0}, Numbers{0.0}, 15.0, options);
    double largest = 0.0;
    for (double t = 0.0; t <= 15.0; t += 0.1)
      largest = std::max(largest, std::fabs(result.trajectory.state(t).q[0] - pendulum_angle(q0, t)));
    if (largest <= result.error.largest) ++bounded;
    loosest = std::max(loosest, result.error.largest / largest);
    EXPECT_GE(result.error.largest, result.error.q[0]);
  }
  EXPECT_GE(bounded, 190);
  EXPECT_LT(loosest, 300.0);
}

TEST(Integrate, limits_end_it_and_say_so) {
  const MotionEquations equations = pendulum(1.0);
  IntegrationOptions options;
  options.most_steps = 10;
  const IntegrationResult few = integrate(equations, 0.0, Numbers{1.0}, Numbers{0.0}, 100.0, options);
  EXPECT_EQ(few.ending, Ending::step_limit);
  EXPECT_EQ(few.statistics.steps, 10);
  EXPECT_EQ(few.time, few.trajectory.end_time());
  EXPECT_NEAR(few.q[0], pendulum_angle(1.0, few.time), 1e-9);
  EXPECT_NE(describe(few).find("the limit of 10 steps"), std::string::npos) << describe(few);

  options = {};
  options.work = 1;
  EXPECT_EQ(integrate(equations, 0.0, Numbers{1.0}, Numbers{0.0}, 100.0, options).ending, Ending::work_limit);

  options = {};
  int calls = 0;
  options.observer = [&](const StepView& step) {
    Numbers y(2);
    step.evaluate(step.end, y);
    EXPECT_NEAR(y[0], pendulum_angle(1.0, step.end), 1e-9);
    return ++calls < 4;
  };
  const IntegrationResult stopped = integrate(equations, 0.0, Numbers{1.0}, Numbers{0.0}, 100.0, options);
  EXPECT_EQ(stopped.ending, Ending::interrupted);
  EXPECT_EQ(stopped.statistics.steps, 4);
  EXPECT_EQ(stopped.trajectory.step_count(), 4U);
}

TEST(Integrate, no_time_is_no_motion) {
  const IntegrationResult result = integrate(pendulum(1.0), 2.0, Numbers{1.0}, Numbers{0.5}, 2.0);
  EXPECT_EQ(result.ending, Ending::reached_end);
  EXPECT_EQ(result.q, Numbers{1.0});
  EXPECT_EQ(result.v, Numbers{0.5});
  EXPECT_EQ(result.time, 2.0);
  EXPECT_EQ(result.statistics.steps, 0);
  EXPECT_THROW(result.trajectory.state(2.0), std::out_of_range);
}

// dv/dt = 1/q^2 towards q = 0, which is reached at a finite time.
MotionEquations collapse() {
  MotionEquations equations;
  equations.position_size = equations.velocity_size = 1;
  equations.accelerations = [](double, std::span<const double> q, std::span<const double>, std::span<double> a) {
    a[0] = -1.0 / (q[0] * q[0]);
  };
  return equations;
}

TEST(Integrate, a_singularity_ends_it_where_it_is) {
  // Free fall from rest at 1: the centre is reached at pi/(2 sqrt 2).
  IntegrationOptions options = with_tolerance(1e-9);
  options.most_steps = 100'000;
  const IntegrationResult result = integrate(collapse(), 0.0, Numbers{1.0}, Numbers{0.0}, 2.0, options);
  EXPECT_EQ(result.ending, Ending::step_too_small);
  EXPECT_NEAR(result.time, std::numbers::pi / std::sqrt(8.0), 1e-6);
  EXPECT_NE(describe(result).find("too small at 1.11"), std::string::npos) << describe(result);
}

TEST(Integrate, equations_without_finite_values_end_it) {
  MotionEquations equations = oscillator(1.0);
  equations.accelerations = [](double t, std::span<const double>, std::span<const double>, std::span<double> a) {
    a[0] = t > 0.7 ? std::nan("") : 1.0;
  };
  const IntegrationResult result = integrate(equations, 0.0, Numbers{0.0}, Numbers{0.0}, 2.0);
  EXPECT_EQ(result.ending, Ending::not_finite);
  EXPECT_NEAR(result.time, 0.7, 1e-9);
  EXPECT_NEAR(result.q[0], 0.5 * 0.49, 1e-9);
  EXPECT_EQ(integrate(equations, 1.0, Numbers{0.0}, Numbers{0.0}, 2.0).ending, Ending::not_finite);
}

TEST(Integrate, exceptions_of_the_equations_pass_through) {
  MotionEquations equations = oscillator(1.0);
  equations.accelerations = [](double, std::span<const double>, std::span<const double>, std::span<double>) {
    throw std::runtime_error("no such state");
  };
  EXPECT_THROW(integrate(equations, 0.0, Numbers{0.0}, Numbers{0.0}, 2.0), std::runtime_error);
}

TEST(Integrate, stiffness_is_noticed) {
  MotionEquations equations = oscillator(1.0);
  equations.accelerations = [](double t, std::span<const double> q, std::span<const double> v, std::span<double> a) {
    a[0] = -1e5 * (v[0] + 1e2 * (q[0] - std::sin(t)));
  };
  IntegrationOptions options = with_tolerance(1e-6);
  options.method = IntegrationMethod::explicit_runge_kutta;
  const IntegrationResult result = integrate(equations, 0.0, Numbers{0.0}, Numbers{0.0}, 10.0, options);
  EXPECT_EQ(result.ending, Ending::stiff);
  EXPECT_NE(describe(result).find("stiff"), std::string::npos);

  options.method = IntegrationMethod::automatic;
  const IntegrationResult best = integrate(equations, 0.0, Numbers{0.0}, Numbers{0.0}, 1.0, options);
  EXPECT_EQ(best.ending, Ending::reached_end);
  // q follows sin t with a lag of 10 ms.
  EXPECT_NEAR(best.q[0], std::sin(1.0) - 0.01 * std::cos(1.0), 3e-4);
  if (has_stiff_solver()) {
    EXPECT_LT(best.statistics.evaluations, 20'000);
  }
}

TEST(Integrate, wrong_arguments_are_refused) {
  const MotionEquations good = pendulum(1.0);
  const Numbers one{1.0};
  const Numbers two{1.0, 1.0};
  EXPECT_THROW(integrate(good, 0.0, two, one, 1.0), std::invalid_argument);
  EXPECT_THROW(integrate(good, 0.0, one, two, 1.0), std::invalid_argument);
  EXPECT_THROW(integrate(good, 0.0, Numbers{NAN}, one, 1.0), std::invalid_argument);
  EXPECT_THROW(integrate(good, 0.0, one, one, INFINITY), std::invalid_argument);
  EXPECT_THROW(integrate(good, 0.0, one, one, 1.0, with_tolerance(0.0)), std::invalid_argument);
  MotionEquations bad = good;
  bad.quaternions = {0};
  EXPECT_THROW(integrate(bad, 0.0, one, one, 1.0), std::invalid_argument);
  bad = good;
  bad.position_sizes = {0.0};
  EXPECT_THROW(integrate(bad, 0.0, one, one, 1.0), std::invalid_argument);
  bad = good;
  bad.accelerations = nullptr;
  EXPECT_THROW(integrate(bad, 0.0, one, one, 1.0), std::invalid_argument);
  bad = good;
  bad.position_size = 2;
  EXPECT_THROW(integrate(bad, 0.0, two, one, 1.0), std::invalid_argument);
}

TEST(TreeEquations, a_thrown_body_keeps_its_energy_and_its_center_flies_a_parabola) {
  ModelBuilder<double> builder;
  const Vector3<double> center{0.1, -0.2, 0.3};
  builder.add_body("stone", ground, Joint<double>::free(), SpatialTransform<double>::identity(),
                   MassProperties<double>{2.0, center, SymmetricMatrix3<double>::diagonal(0.2, 0.3, 0.4)});
  builder.set_gravity({0.0, 0.0, -9.81});
  const Model<double> model = builder.build();
  State<double> start = neutral_state(model);
  start.v = {1.0, 5.0, 0.1, 3.0, 0.0, 4.0};
  const MotionEquations equations = tree_equations(model);
  const IntegrationResult result = integrate(equations, 0.0, start.q, start.v, 3.0, with_tolerance(1e-11));
  ASSERT_EQ(result.ending, Ending::reached_end);
  ASSERT_EQ(result.drift.size(), 1U);
  EXPECT_LT(result.drift[0].largest, 1e-8);

  Workspace<double> workspace(model);
  update_velocities(model, workspace, start);
  const Vector3<double> r0 = point_position(model, workspace, 0, center);
  const Vector3<double> v0 = point_velocity(model, workspace, 0, center);
  for (const double t : {0.4, 1.7, 3.0}) {
    const State<double> at = result.trajectory.state(t);
    update_poses<double>(model, workspace, at.q);
    const Vector3<double> r = point_position(model, workspace, 0, center);
    EXPECT_NEAR(r.x, r0.x + v0.x * t, 1e-8);
    EXPECT_NEAR(r.y, r0.y + v0.y * t, 1e-8);
    EXPECT_NEAR(r.z, r0.z + v0.z * t - 0.5 * 9.81 * t * t, 1e-8);
  }
}

TEST(TreeEquations, loads_drive_it) {
  ModelBuilder<double> builder;
  builder.add_body("wheel", ground, Joint<double>::revolute({0.0, 0.0, 1.0}), SpatialTransform<double>::identity(),
                   MassProperties<double>{1.0, {}, SymmetricMatrix3<double>::diagonal(1.0, 1.0, 2.0)});
  builder.set_gravity({0.0, 0.0, 0.0});
  const Model<double> model = builder.build();
  // Couple 2 cos t by the drive and as much by a wrench: alpha = 2 cos t.
  const MotionEquations equations =
      tree_equations(model, [](double t, std::span<const double>, std::span<const double>, std::span<double> force,
                               std::span<SpatialForce<double>> wrench) {
        force[0] = 2.0 * std::cos(t);
        wrench[0].moment.z = 2.0 * std::cos(t);
      });
  EXPECT_TRUE(equations.conserved.empty());
  const IntegrationResult result = integrate(equations, 0.0, Numbers{0.0}, Numbers{0.0}, 2.0);
  EXPECT_NEAR(result.q[0], 2.0 * (1.0 - std::cos(2.0)), 1e-9);
  EXPECT_NEAR(result.v[0], 2.0 * std::sin(2.0), 1e-9);
}

TEST(TreeEquations, a_coordinate_that_is_not_free_is_refused) {
  ModelBuilder<double> builder;
  builder.add_body("wheel", ground, Joint<double>::revolute({0.0, 0.0, 1.0}), SpatialTransform<double>::identity(),
                   MassProperties<double>{1.0, {}, SymmetricMatrix3<double>::diagonal(1.0, 1.0, 2.0)},
                   CoordinateMode::prescribed);
  builder.set_gravity({0.0, 0.0, 0.0});
  const Model<double> model = builder.build();
  EXPECT_THROW(tree_equations(model), std::invalid_argument);
}

}  // namespace integrate_test
}  // namespace poinsot
