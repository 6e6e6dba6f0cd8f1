// Constraints: their rates by numerical differentiation, and joints replaced by constraints.
#include "poinsot/engine/dynamics/constraint.h"

#include <gtest/gtest.h>

#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/momentum.h"

namespace poinsot {
namespace constraint_test {

using testing::Random;
using testing::relative_difference;

template <class Scalar>
Constraint<Scalar> cast(const Constraint<double>& c) {
  return {c.type,
          c.a,
          c.b,
          testing::cast<Scalar>(c.point_a),
          testing::cast<Scalar>(c.point_b),
          testing::cast<Scalar>(c.direction_a),
          testing::cast<Scalar>(c.direction_b),
          Scalar(c.value)};
}

TEST(Constraint, rates_and_jacobians_agree_with_numerical_differentiation) {
  Random random(41);
  for (int trial = 0; trial < 600; ++trial) {
    testing::TreeOptions options;
    options.least_bodies = 2;
    const Model<double> model = testing::built(testing::random_tree(random, options));
    const State<double> state = testing::random_state(random, model);
    const std::vector<double> acceleration = random.numbers(model.velocity_size(), 2.0);
    const int a = random.integer(ground, model.body_count() - 1);
    const int b = random.integer(ground, model.body_count() - 1);
    const Constraint<double> c =
        trial % 3 == 0   ? Constraint<double>::along(a, random.vector(), random.direction(), b, random.vector(), 0.3)
        : trial % 3 == 1 ? Constraint<double>::parallel(a, random.direction(), b, random.direction(), 0.2)
                         : Constraint<double>::distance(a, random.vector(), b, random.vector(), 0.7);
    Workspace<double> workspace(model);
    update_accelerations<double>(model, workspace, state, acceleration);
    const double rate = constraint_rate(model, workspace, c);
    const double second = constraint_acceleration(model, workspace, c);
    std::vector<double> J(model.velocity_size());
    constraint_jacobian<double>(model, workspace, c, J);
    double product = 0.0;
    for (std::size_t k = 0; k < J.size(); ++k) product += J[k] * state.v[k];
    ASSERT_NEAR(product, rate, 1e-11 * (1.0 + std::fabs(rate))) << "trial " << trial;

    const Model<long double> fine = convert<long double>(model);
    Workspace<long double> fine_workspace(fine);
    const Constraint<long double> fine_c = cast<long double>(c);
    const auto at = [&](long double t) {
      State<long double> moved = testing::cast<long double>(state);
      std::vector<long double> mean(state.v.size());
      for (std::size_t k = 0; k < mean.size(); ++k) {
        mean[k] = state.v[k] + 0.5L * acceleration[k] * t;
        moved.v[k] = state.v[k] + acceleration[k] * t;
      }
      integrate_position<long double>(fine, moved.q, mean, t);
      update_velocities(fine, fine_workspace, moved);
    };
    const long double h = 2e-4L;
    const auto error = [&](long double t) {
      at(t);
      return constraint_error(fine, fine_workspace, fine_c);
    };
    const auto first = [&](long double t) {
      at(t);
      return constraint_rate(fine, fine_workspace, fine_c);
    };
    const auto slope = [&](auto f) {
      return static_cast<double>((8.0L * (f(h) - f(-h)) - (f(2.0L * h) - f(-2.0L * h))) / (12.0L * h));
    };
    // Distances near zero have large higher rates: those draws are left to the other trials.
    if (c.type == ConstraintType::distance && constraint_error(model, workspace, c) + c.value < 0.5) continue;
    ASSERT_NEAR(rate, slope(error), 1e-8 * (1.0 + std::fabs(rate))) << "trial " << trial;
    ASSERT_NEAR(second, slope(first), 1e-7 * (1.0 + std::fabs(second))) << "trial " << trial;
  }
}

// Two bodies on a hinge, and the same as two free bodies held together by constraints.
TEST(ConstrainedDynamics, a_hinge_of_constraints_moves_like_a_hinge_and_carries_the_same_force) {
  Random random(42);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3<double> gravity = random.vector(10.0);
    const MassProperties<double> first = random.mass();
    const MassProperties<double> second = random.mass();
    const SpatialTransform<double> place = random.pose();
    const Vector3<double> axis = random.direction();

    ModelBuilder<double> jointed_builder;
    jointed_builder.set_gravity(gravity);
    const int base = jointed_builder.add_body("base", ground, Joint<double>::free(), {}, first);
    jointed_builder.add_body("arm", base, Joint<double>::revolute(axis), place, second);
    const Model<double> jointed = jointed_builder.build();
    const State<double> state = testing::random_state(random, jointed);
    std::vector<double> force = random.numbers(jointed.velocity_size(), 5.0);
    std::vector<double> acceleration(jointed.velocity_size());
    Workspace<double> jointed_workspace(jointed);
    forward_dynamics<double>(jointed, jointed_workspace, state, force, acceleration);
    update_accelerations<double>(jointed, jointed_workspace, state, acceleration);

    ModelBuilder<double> loose_builder;
    loose_builder.set_gravity(gravity);
    loose_builder.add_body("base", ground, Joint<double>::free(), {}, first);
    loose_builder.add_body("arm", ground, Joint<double>::free(), {}, second);
    const Model<double> loose = loose_builder.build();
    State<double> loose_state = neutral_state(loose);
    std::copy(state.q.begin(), state.q.begin() + 7, loose_state.q.begin());
    std::copy(state.v.begin(), state.v.begin() + 6, loose_state.v.begin());
    const SpatialTransform<double> X = body_pose(jointed, jointed_workspace, 1);
    const Quaternion<double> attitude = quaternion_of(X.R);
    const Vector3<double> w = transpose_times(X.R, angular_velocity(jointed_workspace, 1));
    const Vector3<double> v =
        transpose_times(X.R, point_velocity(jointed, jointed_workspace, 1, Vector3<double>::zero()));
    const double position[7] = {attitude.w, attitude.x, attitude.y, attitude.z, X.p.x, X.p.y, X.p.z};
    const double velocity[6] = {w.x, w.y, w.z, v.x, v.y, v.z};
    std::copy(position, position + 7, loose_state.q.begin() + 7);
    std::copy(velocity, velocity + 6, loose_state.v.begin() + 6);

    const std::vector<Constraint<double>> hinge =
        coincident_axes(0, place.p, place.R * axis, 1, Vector3<double>::zero(), axis);
    std::vector<double> loose_force(12, 0.0);
    std::copy(force.begin(), force.begin() + 6, loose_force.begin());
    // The hinge's couple acts on the arm along the axis and on the base against it.
    const Vector3<double> couple_on_arm = force[6] * axis;
    const Vector3<double> couple_on_base = -force[6] * (place.R * axis);
    for (std::size_t i = 0; i < 3; ++i) {
      loose_force[i] += couple_on_base[i];
      loose_force[6 + i] += couple_on_arm[i];
    }
    std::vector<double> loose_acceleration(12);
    std::vector<double> multiplier(hinge.size());
    Workspace<double> workspace(loose);
    ConstraintWorkspace<double> constraint_workspace(loose, static_cast<int>(hinge.size()));
    constrained_dynamics<double>(loose, workspace, constraint_workspace, loose_state, hinge, loose_acceleration,
                                 loose_force, multiplier);
    ASSERT_EQ(constraint_workspace.rank, 5);
    update_accelerations<double>(loose, workspace, loose_state, loose_acceleration);
    for (int i = 0; i < 2; ++i) {
      const Vector3<double> point = random.vector();
      ASSERT_LT(relative_difference(point_acceleration(loose, workspace, i, point),
                                    point_acceleration(jointed, jointed_workspace, i, point)),
                1e-9)
          << "trial " << trial;
      ASSERT_LT(relative_difference(angular_acceleration(workspace, i), angular_acceleration(jointed_workspace, i)),
                1e-9)
          << "trial " << trial;
    }
    // The first three multipliers are the hinge's force on the arm, on the base's axes.
    std::vector<double> back(jointed.velocity_size());
    inverse_dynamics<double>(jointed, jointed_workspace, state, acceleration, back);
    const Vector3<double> on_arm = X.R * joint_wrench(jointed, jointed_workspace, 1).force;
    const Vector3<double> by_multipliers =
        body_rotation(jointed, jointed_workspace, 0) * Vector3<double>{multiplier[0], multiplier[1], multiplier[2]};
    ASSERT_LT(relative_difference(by_multipliers, on_arm), 1e-9) << "trial " << trial;
  }
}

// A parallelogram of three rods hung from the ground in a vertical plane, closed by a full spatial hinge: three of its
// five constraints repeat what the plane demands. The rods' mid-plane motion has one freedom with the closed form
// (I_1 + I_3 + m_2 l^2) theta'' = -g (m_1 l/2 + m_3 l/2 + m_2 l) sin(theta), whatever the speed.
TEST(ConstrainedDynamics, a_parallelogram_with_redundant_constraints_is_a_pendulum) {
  const double g = 9.81;
  const double l = 0.8;
  const double d = 1.3;
  const double m1 = 1.5;
  const double m2 = 2.5;
  const double m3 = 0.7;
  const auto rod = [](double mass, const Vector3<double>& along) {
    const double L2 = norm_squared(along);
    const double I = mass * L2 / 12.0;
    const Vector3<double> n = along / std::sqrt(L2);
    return MassProperties<double>{
        mass, 0.5 * along,
        SymmetricMatrix3<double>{I * (1 - n.x * n.x), I * (1 - n.y * n.y), I * (1 - n.z * n.z), -I * n.x * n.y,
                                 -I * n.y * n.z, -I * n.z * n.x}};
  };
  const Vector3<double> down{0.0, -l, 0.0};
  const Vector3<double> across{d, 0.0, 0.0};
  const Vector3<double> z{0.0, 0.0, 1.0};
  ModelBuilder<double> builder;
  builder.set_gravity({0.0, -g, 0.0});
  const int left = builder.add_body("left", ground, Joint<double>::revolute(z), {}, rod(m1, down));
  const int bar = builder.add_body("bar", left, Joint<double>::revolute(z), SpatialTransform<double>::translation(down),
                                   rod(m2, across));
  const int right = builder.add_body("right", bar, Joint<double>::revolute(z),
                                     SpatialTransform<double>::translation(across), rod(m3, -down));
  const Model<double> model = builder.build();
  const std::vector<Constraint<double>> closure = coincident_axes(ground, across, z, right, -down, z);
  Workspace<double> workspace(model);
  ConstraintWorkspace<double> constraint_workspace(model, static_cast<int>(closure.size()));
  for (const double theta : {-1.0, 0.1, 0.7, 1.2}) {
    const double rate = 3.0;
    const State<double> state{{theta, -theta, theta}, {rate, -rate, rate}};
    std::vector<double> acceleration(3);
    std::vector<double> force(3, 0.0);
    std::vector<double> multiplier(closure.size());
    update_velocities(model, workspace, state);
    for (const Constraint<double>& c : closure) {
      ASSERT_NEAR(constraint_error(model, workspace, c), 0.0, 1e-14);
      ASSERT_NEAR(constraint_rate(model, workspace, c), 0.0, 1e-14);
    }
    constrained_dynamics<double>(model, workspace, constraint_workspace, state, closure, acceleration, force,
                                 multiplier);
    const double inertia = (m1 + m3) * l * l / 3.0 + m2 * l * l;
    const double expected = -g * std::sin(theta) * l * (0.5 * (m1 + m3) + m2) / inertia;
    EXPECT_EQ(constraint_workspace.rank, 2);
    EXPECT_NEAR(acceleration[0], expected, 1e-11);
    EXPECT_NEAR(acceleration[1], -expected, 1e-11);
    EXPECT_NEAR(acceleration[2], expected, 1e-11);
  }
}

// A point mass on a cord of constant length: the cord's tension is m (l w^2 + g cos(theta)), with the sign of a push.
TEST(ConstrainedDynamics, a_cord_pulls_as_a_pendulum_does) {
  const double m = 1.7;
  const double g = 9.81;
  const double l = 1.1;
  const double theta = 0.6;
  const double w = 2.3;
  ModelBuilder<double> builder;
  builder.set_gravity({0.0, 0.0, -g});
  const double I = 0.01;
  builder.add_body("bob", ground, Joint<double>::free(), {},
                   {m, Vector3<double>::zero(), SymmetricMatrix3<double>::diagonal(I, I, I)});
  const Model<double> model = builder.build();
  State<double> state = neutral_state(model);
  state.q[4] = l * std::sin(theta);
  state.q[6] = -l * std::cos(theta);
  state.v[3] = l * w * std::cos(theta);
  state.v[5] = l * w * std::sin(theta);
  const std::vector<Constraint<double>> cord{
      Constraint<double>::distance(ground, Vector3<double>::zero(), 0, Vector3<double>::zero(), l)};
  Workspace<double> workspace(model);
  ConstraintWorkspace<double> constraint_workspace(model, 1);
  std::vector<double> acceleration(6);
  std::vector<double> force(6, 0.0);
  std::vector<double> multiplier(1);
  constrained_dynamics<double>(model, workspace, constraint_workspace, state, cord, acceleration, force, multiplier);
  EXPECT_NEAR(multiplier[0], -m * (l * w * w + g * std::cos(theta)), 1e-12);
  // A stated second rate of the length takes the place of zero.
  const std::vector<double> target{0.25};
  constrained_dynamics<double>(model, workspace, constraint_workspace, state, cord, acceleration, force, multiplier, {},
                               target);
  update_accelerations<double>(model, workspace, state, acceleration);
  EXPECT_NEAR(constraint_acceleration(model, workspace, cord[0]), 0.25, 1e-12);
}

// With some coordinates given: the solution satisfies the equations of motion with the constraint forces, as inverse
// dynamics finds them, and the constraints.
TEST(ConstrainedDynamics, solution_satisfies_motion_and_constraints_with_given_coordinates) {
  Random random(43);
  int constrained = 0, given_only = 0;
  for (int trial = 0; trial < 500; ++trial) {
    testing::TreeOptions options;
    options.least_bodies = 3;
    options.given_coordinates = true;
    const Model<double> model = testing::built(testing::random_tree(random, options));
    const State<double> state = testing::random_state(random, model);
    std::vector<Constraint<double>> constraints;
    const int last = model.body_count() - 1;
    constraints.push_back(
        Constraint<double>::along(ground, random.vector(), random.direction(), last, random.vector()));
    constraints.push_back(Constraint<double>::distance(0, random.vector(), last, random.vector(), 1.0));
    std::vector<double> acceleration = random.numbers(model.velocity_size(), 2.0);
    std::vector<double> force = random.numbers(model.velocity_size(), 2.0);
    const std::vector<double> given_force = force;
    const std::vector<double> given_acceleration = acceleration;
    std::vector<double> multiplier(constraints.size());
    Workspace<double> workspace(model);
    ConstraintWorkspace<double> constraint_workspace(model, static_cast<int>(constraints.size()));
    constrained_dynamics<double>(model, workspace, constraint_workspace, state, constraints, acceleration, force,
                                 multiplier);
    // What the given coordinates leave free decides how many of the constraints can be met, and none is exerted beyond.
    std::size_t acting = 0;
    std::vector<double> row(model.velocity_size());
    update_poses<double>(model, workspace, state.q);
    for (std::size_t i = 0; i < constraints.size(); ++i) {
      constraint_jacobian<double>(model, workspace, constraints[i], row);
      double moved = 0.0;
      for (std::size_t k = 0; k < row.size(); ++k)
        if (model.mode(static_cast<int>(k)) == CoordinateMode::free) moved = std::max(moved, std::fabs(row[k]));
      acting += moved > 1e-9;
      if (moved < 1e-12) {
        ASSERT_EQ(multiplier[i], 0.0) << "trial " << trial;
      }
    }
    ASSERT_LE(constraint_workspace.rank, static_cast<int>(acting)) << "trial " << trial;
    const bool met = constraint_workspace.rank == 2;
    (met ? constrained : given_only) += 1;
    std::vector<double> needed(model.velocity_size());
    inverse_dynamics<double>(model, workspace, state, acceleration, needed);
    update_accelerations<double>(model, workspace, state, acceleration);
    std::vector<double> applied = force;
    double scale = 1.0;
    for (std::size_t i = 0; i < constraints.size(); ++i) {
      std::vector<double> J(model.velocity_size());
      constraint_jacobian<double>(model, workspace, constraints[i], J);
      for (std::size_t k = 0; k < J.size(); ++k) applied[k] += J[k] * multiplier[i];
      scale = std::max(scale, std::fabs(multiplier[i]));
    }
    double largest = 1.0;
    for (const double a : acceleration) largest = std::max(largest, std::fabs(a));
    for (const Constraint<double>& c : constraints) {
      if (!met) continue;
      ASSERT_NEAR(constraint_acceleration(model, workspace, c), 0.0, 1e-8 * largest) << "trial " << trial;
    }
    for (std::size_t k = 0; k < applied.size(); ++k) {
      ASSERT_NEAR(applied[k], needed[k], 1e-8 * std::max(scale, largest)) << "trial " << trial;
      if (model.mode(static_cast<int>(k)) == CoordinateMode::free) {
        ASSERT_EQ(force[k], given_force[k]);
      } else {
        const bool locked = model.mode(static_cast<int>(k)) == CoordinateMode::locked;
        ASSERT_EQ(acceleration[k], locked ? 0.0 : given_acceleration[k]);
      }
    }
  }
  EXPECT_GT(constrained, 250);
  EXPECT_GT(given_only, 20);
}

// A constraint that given coordinates alone obey, or break, exerts nothing.
TEST(ConstrainedDynamics, constraints_on_given_coordinates_get_no_multiplier) {
  Random random(45);
  for (int trial = 0; trial < 300; ++trial) {
    ModelBuilder<double> builder;
    builder.set_gravity(random.vector(10.0));
    const Vector3<double> axis = random.direction(), at = random.vector();
    const int carrier = builder.add_body("carrier", ground, Joint<double>::revolute(random.direction()), random.pose(),
                                         random.mass(), CoordinateMode::prescribed);
    const int arm = builder.add_body("arm", carrier, Joint<double>::revolute(axis),
                                     SpatialTransform<double>::translation(at), random.mass());
    const Model<double> model = builder.build();
    const State<double> state = testing::random_state(random, model);
    // A point on the arm's own axis, and the axis itself, move with the carrier.
    const std::vector<Constraint<double>> constraints{
        Constraint<double>::along(ground, random.vector(), random.direction(), arm, random.uniform(-2.0, 2.0) * axis),
        Constraint<double>::parallel(ground, random.direction(), arm, axis)};
    Workspace<double> workspace(model);
    ConstraintWorkspace<double> constraint_workspace(model, 2);
    std::vector<double> acceleration{random.uniform(-2.0, 2.0), 0.0}, force{0.0, random.uniform(-2.0, 2.0)};
    std::vector<double> expected = acceleration, expected_force = force, multiplier(2);
    hybrid_dynamics<double>(model, workspace, state, expected, expected_force);
    constrained_dynamics<double>(model, workspace, constraint_workspace, state, constraints, acceleration, force,
                                 multiplier);
    EXPECT_EQ(constraint_workspace.rank, 0) << "trial " << trial;
    EXPECT_EQ(multiplier, std::vector<double>(2, 0.0)) << "trial " << trial;
    ASSERT_EQ(acceleration, expected) << "trial " << trial;
    ASSERT_EQ(force, expected_force) << "trial " << trial;
  }
}

// The plane of a linkage may stand anywhere: its hinge at the end of the loop repeats three of its constraints.
TEST(ConstrainedDynamics, turned_planar_loops_move_as_unturned_ones) {
  Random random(46);
  const auto rod = [](double mass, const Vector3<double>& along) {
    return MassProperties<double>{mass, 0.5 * along, (mass / 12.0) * unit_mass_inertia(along)};
  };
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3<double> end{random.uniform(1.5, 2.5), random.uniform(0.3, 0.7), 0.0};
    const auto solved = [&](const Matrix3<double>& R, const Vector3<double>& offset) {
      const auto place = [&](double x, double y) { return R * Vector3<double>{x, y, 0.0}; };
      const Vector3<double> z = R * Vector3<double>{0.0, 0.0, 1.0};
      ModelBuilder<double> builder;
      const int crank = builder.add_body("crank", ground, Joint<double>::revolute(z),
                                         SpatialTransform<double>::translation(offset), rod(1.0, place(0.0, 1.0)));
      const int coupler =
          builder.add_body("coupler", crank, Joint<double>::revolute(z),
                           SpatialTransform<double>::translation(place(0.0, 1.0)), rod(2.0, place(end.x, end.y)));
      const int rocker = builder.add_body("rocker", ground, Joint<double>::revolute(z),
                                          SpatialTransform<double>::translation(offset + place(2.0, 0.0)),
                                          rod(1.5, place(end.x - 2.0, 1.0 + end.y)));
      builder.set_gravity(place(0.0, -9.81));
      const Model<double> model = builder.build();
      const auto hinge =
          coincident_axes<double>(coupler, place(end.x, end.y), z, rocker, place(end.x - 2.0, 1.0 + end.y), z);
      Workspace<double> workspace(model);
      ConstraintWorkspace<double> constraint_workspace(model, static_cast<int>(hinge.size()));
      std::vector<double> acceleration(3), force(3), multiplier(hinge.size());
      constrained_dynamics<double>(model, workspace, constraint_workspace, neutral_state(model), hinge, acceleration,
                                   force, multiplier);
      EXPECT_EQ(constraint_workspace.rank, 2) << "trial " << trial;
      return acceleration;
    };
    const std::vector<double> expected = solved(Matrix3<double>::identity(), Vector3<double>::zero());
    const SpatialTransform<double> turned = random.pose();
    ASSERT_LT(relative_difference(solved(turned.R, turned.p), expected), 1e-9) << "trial " << trial;
  }
}

TEST(ConstrainedDynamics, without_constraints_is_hybrid_dynamics_and_wrong_sizes_are_refused) {
  Random random(44);
  const Model<double> model = testing::built(testing::random_tree(random));
  const State<double> state = testing::random_state(random, model);
  const int n = model.velocity_size();
  std::vector<double> force = random.numbers(n, 2.0);
  std::vector<double> acceleration(n);
  std::vector<double> expected(n);
  Workspace<double> workspace(model);
  forward_dynamics<double>(model, workspace, state, force, expected);
  ConstraintWorkspace<double> none(model, 0);
  constrained_dynamics<double>(model, workspace, none, state, {}, acceleration, force, {});
  EXPECT_EQ(relative_difference(acceleration, expected), 0.0);
  const std::vector<Constraint<double>> one{
      Constraint<double>::along(ground, random.vector(), random.direction(), 0, random.vector())};
  std::vector<double> multiplier(1);
  ConstraintWorkspace<double> space(model, 1);
  const auto solve = [&](ConstraintWorkspace<double>& w, std::span<double> m, std::span<const double> target) {
    constrained_dynamics<double>(model, workspace, w, state, one, acceleration, force, m, {}, target);
  };
  EXPECT_THROW(solve(none, multiplier, {}), std::invalid_argument);
  EXPECT_THROW(solve(space, {}, {}), std::invalid_argument);
  EXPECT_THROW(solve(space, multiplier, std::vector<double>(2)), std::invalid_argument);
}

}  // namespace constraint_test
}  // namespace poinsot
