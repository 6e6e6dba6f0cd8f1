// Hybrid, forward and inverse dynamics against Newton-Euler equations in redundant coordinates.
#include "poinsot/engine/dynamics/hybrid_dynamics.h"

#include <gtest/gtest.h>

#include "engine/dynamics/newton_euler_oracle.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"

namespace poinsot {
namespace hybrid_dynamics_test {

using testing::OracleResult;
using testing::Random;
using testing::relative_difference;
using testing::StatedTree;

constexpr double tolerance = 1e-10;

struct Case {
  StatedTree tree;
  Model<double> model;
  State<double> state;
  std::vector<double> acceleration;
  std::vector<double> force;
  std::vector<SpatialForce<double>> external;
};

Case random_case(Random& random, bool given_coordinates) {
  testing::TreeOptions options;
  options.given_coordinates = given_coordinates;
  const StatedTree tree = testing::random_tree(random, options);
  Case c{tree, testing::built(tree), {}, {}, {}, {}};
  c.state = testing::random_state(random, c.model);
  c.acceleration = random.numbers(c.model.velocity_size(), 5.0);
  c.force = random.numbers(c.model.velocity_size(), 5.0);
  if (random.chance(0.7)) {
    for (int i = 0; i < c.model.body_count(); ++i) c.external.push_back(random.wrench(5.0));
  }
  return c;
}

TEST(HybridDynamics, agrees_with_newton_euler_in_redundant_coordinates_on_1000_random_trees) {
  Random random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    Case c = random_case(random, true);
    const OracleResult expected =
        testing::oracle_dynamics(c.tree, c.state, c.model.modes(), c.force, c.acceleration, c.external);
    Workspace<double> workspace(c.model);
    hybrid_dynamics<double>(c.model, workspace, c.state, c.acceleration, c.force, c.external);
    ASSERT_LT(relative_difference(c.acceleration, expected.acceleration), tolerance) << "trial " << trial;
    ASSERT_LT(relative_difference(c.force, expected.force), tolerance) << "trial " << trial;
  }
}

TEST(ForwardDynamics, agrees_with_newton_euler_in_redundant_coordinates_on_1000_random_trees) {
  Random random(2);
  for (int trial = 0; trial < 1000; ++trial) {
    Case c = random_case(random, trial % 2 == 0);
    const std::vector<CoordinateMode> all_free(c.model.velocity_size(), CoordinateMode::free);
    const OracleResult expected = testing::oracle_dynamics(c.tree, c.state, all_free, c.force, {}, c.external);
    Workspace<double> workspace(c.model);
    forward_dynamics<double>(c.model, workspace, c.state, c.force, c.acceleration, c.external);
    ASSERT_LT(relative_difference(c.acceleration, expected.acceleration), tolerance) << "trial " << trial;
  }
}

// A rotor in gimbals: how far it has turned does not matter, and what moves it is a small part of I s^2.
TEST(HybridDynamics, the_spin_of_a_fast_rotor_adds_no_rounding) {
  Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3<double> axis = random.direction(), across = normalized(cross(axis, random.direction()));
    const double J = random.uniform(0.5, 2.0), C = J * random.uniform(0.1, 2.0), mass = random.uniform(0.5, 2.0);
    const Vector3<double> center = random.uniform(-0.5, 0.5) * axis;
    const auto along = [&](const Vector3<double>& a, double about, double transverse) {
      return SymmetricMatrix3<double>{transverse + (about - transverse) * a.x * a.x,
                                      transverse + (about - transverse) * a.y * a.y,
                                      transverse + (about - transverse) * a.z * a.z,
                                      (about - transverse) * a.x * a.y,
                                      (about - transverse) * a.y * a.z,
                                      (about - transverse) * a.z * a.x};
    };
    ModelBuilder<double> builder;
    const SpatialTransform<double> here = SpatialTransform<double>::identity();
    const int outer = builder.add_body("outer", ground, Joint<double>::revolute(random.direction()), here, {});
    const int inner = builder.add_body("inner", outer, Joint<double>::revolute(across), here,
                                       {0.3, Vector3<double>::zero(), along(across, 0.01, 0.02)});
    builder.add_body("rotor", inner, Joint<double>::revolute(axis), here, {mass, center, along(axis, C, J)},
                     CoordinateMode::prescribed);
    builder.set_gravity(random.vector(9.0));
    const Model<double> model = builder.build();
    ASSERT_TRUE(model.body(2).axisymmetric);
    Workspace<double> workspace(model);
    const double spin = random.uniform(1e4, 1e5), rate = random.uniform(-0.1, 0.1);
    const auto accelerations = [&](double turned) {
      State<double> state = neutral_state(model);
      state.q = {0.3, 0.7, turned};
      state.v = {rate, -0.4 * rate, spin};
      std::vector<double> acceleration{0, 0, 2.5}, force(3, 0.0);
      hybrid_dynamics<double>(model, workspace, state, acceleration, force);
      return acceleration;
    };
    const std::vector<double> expected = accelerations(0);
    const double size = C * spin * 0.1 / J;
    // On body axes, as inverse dynamics goes, the squares of the spin do not come up.
    State<double> state = neutral_state(model);
    state.q = {0.3, 0.7, 1.3};
    state.v = {rate, -0.4 * rate, spin};
    std::vector<double> force(3);
    inverse_dynamics<double>(model, workspace, state, accelerations(1.3), force);
    for (int k = 0; k < 2; ++k) ASSERT_NEAR(force[k], 0, 1e-12 * C * spin * 0.1) << "trial " << trial;
    for (const double turned : {0.4, 1.1, 2.9, -7.3, 4001.7}) {
      const std::vector<double> found = accelerations(turned);
      for (int k = 0; k < 2; ++k) ASSERT_NEAR(found[k], expected[k], 2e-13 * size) << "trial " << trial;
    }
  }
}

TEST(InverseDynamics, agrees_with_newton_euler_in_redundant_coordinates_on_1000_random_trees) {
  Random random(3);
  for (int trial = 0; trial < 1000; ++trial) {
    Case c = random_case(random, false);
    const std::vector<CoordinateMode> given(c.model.velocity_size(), CoordinateMode::prescribed);
    const OracleResult expected = testing::oracle_dynamics(c.tree, c.state, given, {}, c.acceleration, c.external);
    Workspace<double> workspace(c.model);
    inverse_dynamics<double>(c.model, workspace, c.state, c.acceleration, c.force, c.external);
    ASSERT_LT(relative_difference(c.force, expected.force), tolerance) << "trial " << trial;
    // The joints' reactions, on body axes about the bodies' origins, and their sum on the ground.
    Eigen::Vector3d ground_force = Eigen::Vector3d::Zero();
    Eigen::Vector3d ground_moment = Eigen::Vector3d::Zero();
    double scale = 1.0;
    for (int i = 0; i < c.model.body_count(); ++i) {
      const testing::OracleBody& body = expected.bodies[static_cast<std::size_t>(i)];
      const SpatialForce<double> wrench = joint_wrench(c.model, workspace, i);
      scale = std::max({scale, body.n.norm(), body.f.norm()});
      ASSERT_LT((body.R * testing::eigen(wrench.moment) - body.n).norm() / scale, tolerance) << "trial " << trial;
      ASSERT_LT((body.R * testing::eigen(wrench.force) - body.f).norm() / scale, tolerance) << "trial " << trial;
      if (c.tree.bodies[static_cast<std::size_t>(i)].parent == ground) {
        ground_force += body.f;
        ground_moment += body.n + body.p.cross(body.f);
      }
    }
    const SpatialForce<double> sum = ground_wrench(workspace);
    ASSERT_LT((testing::eigen(sum.force) - ground_force).norm() / scale, tolerance) << "trial " << trial;
    ASSERT_LT((testing::eigen(sum.moment) - ground_moment).norm() / scale, tolerance) << "trial " << trial;
  }
}

TEST(HybridDynamics, returns_from_inverse_dynamics_to_the_same_accelerations) {
  Random random(4);
  for (int trial = 0; trial < 1000; ++trial) {
    Case c = random_case(random, true);
    Workspace<double> workspace(c.model);
    inverse_dynamics<double>(c.model, workspace, c.state, c.acceleration, c.force, c.external);
    std::vector<double> forward(c.acceleration.size());
    forward_dynamics<double>(c.model, workspace, c.state, c.force, forward, c.external);
    ASSERT_LT(relative_difference(forward, c.acceleration), tolerance) << "trial " << trial;
  }
}

TEST(HybridDynamics, response_is_the_change_of_the_solution) {
  Random random(5);
  for (int trial = 0; trial < 300; ++trial) {
    Case c = random_case(random, true);
    Workspace<double> workspace(c.model);
    const std::vector<double> push = random.numbers(c.model.velocity_size(), 3.0);
    std::vector<double> pushed_acceleration = c.acceleration;
    std::vector<double> pushed_force = c.force;
    for (std::size_t k = 0; k < push.size(); ++k) pushed_force[k] += push[k];
    hybrid_dynamics<double>(c.model, workspace, c.state, pushed_acceleration, pushed_force, c.external);
    hybrid_dynamics<double>(c.model, workspace, c.state, c.acceleration, c.force, c.external);
    std::vector<double> change(push.size());
    std::vector<double> found = push;
    hybrid_response<double>(c.model, workspace, change, found);
    for (std::size_t k = 0; k < push.size(); ++k) {
      c.acceleration[k] += change[k];
      c.force[k] += found[k];
    }
    ASSERT_LT(relative_difference(c.acceleration, pushed_acceleration), tolerance) << "trial " << trial;
    ASSERT_LT(relative_difference(c.force, pushed_force), tolerance) << "trial " << trial;
  }
}

TEST(HybridDynamics, refuses_lists_of_the_wrong_size) {
  Random random(6);
  testing::TreeOptions options;
  options.least_bodies = 3;
  const Model<double> model = testing::built(testing::random_tree(random, options));
  Workspace<double> workspace(model);
  const State<double> state = neutral_state(model);
  std::vector<double> right(model.velocity_size());
  std::vector<double> wrong(model.velocity_size() + 1);
  const std::vector<SpatialForce<double>> external(model.body_count() + 1);
  State<double> long_state = state;
  long_state.q.push_back(0.0);
  EXPECT_THROW(hybrid_dynamics<double>(model, workspace, state, wrong, right), std::invalid_argument);
  EXPECT_THROW(hybrid_dynamics<double>(model, workspace, state, right, wrong), std::invalid_argument);
  EXPECT_THROW(hybrid_dynamics<double>(model, workspace, long_state, right, right), std::invalid_argument);
  EXPECT_THROW(hybrid_dynamics<double>(model, workspace, state, right, right, external), std::invalid_argument);
  EXPECT_THROW(forward_dynamics<double>(model, workspace, state, wrong, right), std::invalid_argument);
  EXPECT_THROW(inverse_dynamics<double>(model, workspace, state, wrong, right), std::invalid_argument);
  EXPECT_THROW(hybrid_response<double>(model, workspace, wrong, right), std::invalid_argument);
  try {
    inverse_dynamics<double>(model, workspace, state, right, wrong);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "inverse_dynamics: force has " + std::to_string(wrong.size()) +
                                             " entries, the model needs " + std::to_string(right.size()));
  }
}

}  // namespace hybrid_dynamics_test
}  // namespace poinsot
