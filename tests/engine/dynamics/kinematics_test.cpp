// Poses, velocities, accelerations and Jacobians against the oracle's own kinematics and numerical differentiation.
#include "poinsot/engine/dynamics/kinematics.h"

#include <gtest/gtest.h>

#include "engine/dynamics/newton_euler_oracle.h"

namespace poinsot {
namespace kinematics_test {

using testing::Random;
using testing::relative_difference;

// The state after a time t of constant accelerations, in long double: q(t) by one step of the mean velocity would be
// exact only for one-coordinate joints, so the path is q(t) = q0 moved by v t + a t^2/2 on the joint, whose first two
// derivatives at t = 0 are those wanted.
State<long double> moved_state(const Model<long double>& model, const State<double>& state,
                               const std::vector<double>& acceleration, long double t) {
  State<long double> moved = testing::cast<long double>(state);
  std::vector<long double> mean(state.v.size());
  for (std::size_t k = 0; k < mean.size(); ++k) {
    mean[k] = state.v[k] + 0.5L * acceleration[k] * t;
    moved.v[k] = state.v[k] + acceleration[k] * t;
  }
  integrate_position<long double>(model, moved.q, mean, t);
  return moved;
}

// First derivative by central differences of fourth order: error of order h^4 = 1e-14 with the h below.
template <class F>
Vector3<double> derivative(F f) {
  const long double h = 3e-4L;
  const Vector3<long double> d = (8.0L * (f(h) - f(-h)) - (f(2.0L * h) - f(-2.0L * h))) / (12.0L * h);
  return {static_cast<double>(d.x), static_cast<double>(d.y), static_cast<double>(d.z)};
}

TEST(Kinematics, poses_and_velocities_agree_with_the_statement_read_anew) {
  Random random(11);
  for (int trial = 0; trial < 1000; ++trial) {
    const testing::StatedTree tree = testing::random_tree(random);
    const Model<double> model = testing::built(tree);
    const State<double> state = testing::random_state(random, model);
    Workspace<double> workspace(model);
    update_velocities(model, workspace, state);
    const std::vector<testing::OracleBody> expected = testing::oracle_motion(tree, state);
    for (int i = 0; i < model.body_count(); ++i) {
      const testing::OracleBody& body = expected[static_cast<std::size_t>(i)];
      const SpatialTransform<double> X = body_pose(model, workspace, i);
      ASSERT_LT((testing::eigen(X.R) - body.R).norm(), 1e-12);
      ASSERT_LT((testing::eigen(X.p) - body.p).norm(), 1e-12 * (1.0 + body.p.norm()));
      ASSERT_LT((testing::eigen(angular_velocity(workspace, i)) - body.w).norm(), 1e-11 * (1.0 + body.w.norm()));
      const Vector3<double> point = random.vector();
      const Eigen::Vector3d velocity = body.v + body.w.cross(body.R * testing::eigen(point));
      ASSERT_LT((testing::eigen(point_velocity(model, workspace, i, point)) - velocity).norm(),
                1e-11 * (1.0 + velocity.norm()));
      // A force has the same power as its wrench on the body's axes about the body's origin.
      const Vector3<double> force = random.vector();
      const SpatialForce<double> wrench = wrench_of_force(model, workspace, i, point, force);
      const Eigen::Vector3d w_B = body.R.transpose() * body.w, v_B = body.R.transpose() * body.v;
      const double power = testing::eigen(wrench.moment).dot(w_B) + testing::eigen(wrench.force).dot(v_B);
      ASSERT_NEAR(power, testing::eigen(force).dot(velocity), 1e-11 * (1.0 + velocity.norm()));
      const Vector3<double> direction = random.direction();
      const Vector3<double> back =
          direction_on_body(model, workspace, i, direction_on_ground(model, workspace, i, direction));
      ASSERT_LT(relative_difference(back, direction), 1e-13);
    }
  }
}

TEST(Kinematics, rates_agree_with_numerical_differentiation_along_the_motion) {
  Random random(12);
  for (int trial = 0; trial < 200; ++trial) {
    const Model<double> model = testing::built(testing::random_tree(random));
    const State<double> state = testing::random_state(random, model);
    const std::vector<double> acceleration = random.numbers(model.velocity_size(), 3.0);
    Workspace<double> workspace(model);
    update_accelerations<double>(model, workspace, state, acceleration);
    const Model<long double> fine = convert<long double>(model);
    Workspace<long double> fine_workspace(fine);
    const int body = random.integer(0, model.body_count() - 1);
    const Vector3<double> point = random.vector();
    const auto place = [&](long double t) {
      update_velocities(fine, fine_workspace, moved_state(fine, state, acceleration, t));
      return point_position(fine, fine_workspace, body, testing::cast<long double>(point));
    };
    const auto velocity = [&](long double t) {
      update_velocities(fine, fine_workspace, moved_state(fine, state, acceleration, t));
      return point_velocity(fine, fine_workspace, body, testing::cast<long double>(point));
    };
    const auto turning = [&](long double t) {
      update_velocities(fine, fine_workspace, moved_state(fine, state, acceleration, t));
      return angular_velocity(fine_workspace, body);
    };
    // The step error is of the order (rate * h)^4; chained rates reach some tens per second.
    ASSERT_LT(relative_difference(point_velocity(model, workspace, body, point), derivative(place)), 1e-8);
    ASSERT_LT(relative_difference(point_acceleration(model, workspace, body, point), derivative(velocity)), 1e-8);
    ASSERT_LT(relative_difference(angular_acceleration(workspace, body), derivative(turning)), 1e-8);
  }
}

TEST(Kinematics, jacobians_times_velocities_are_the_velocities) {
  Random random(13);
  for (int trial = 0; trial < 300; ++trial) {
    const Model<double> model = testing::built(testing::random_tree(random));
    const State<double> state = testing::random_state(random, model);
    Workspace<double> workspace(model);
    update_velocities(model, workspace, state);
    const int n = model.velocity_size();
    const int body = random.integer(0, model.body_count() - 1);
    const Vector3<double> point = random.vector();
    std::vector<double> J(3 * n, NAN);
    std::vector<double> Jw(3 * n, NAN);
    point_jacobian<double>(model, workspace, body, point, J);
    angular_jacobian<double>(model, workspace, body, Jw);
    Vector3<double> velocity = Vector3<double>::zero();
    Vector3<double> turning = Vector3<double>::zero();
    for (std::size_t i = 0; i < 3; ++i) {
      for (int k = 0; k < n; ++k) {
        velocity[i] += J[static_cast<int>(i) * n + k] * state.v[k];
        turning[i] += Jw[static_cast<int>(i) * n + k] * state.v[k];
      }
    }
    ASSERT_LT(relative_difference(velocity, point_velocity(model, workspace, body, point)), 1e-12);
    ASSERT_LT(relative_difference(turning, angular_velocity(workspace, body)), 1e-12);
  }
}

TEST(Kinematics, the_ground_rests_at_the_origin) {
  Random random(14);
  const Model<double> model = testing::built(testing::random_tree(random));
  Workspace<double> workspace(model);
  update_accelerations<double>(model, workspace, testing::random_state(random, model),
                               random.numbers(model.velocity_size(), 1.0));
  const Vector3<double> point{1.0, 2.0, 3.0};
  EXPECT_EQ(relative_difference(point_position(model, workspace, ground, point), point), 0.0);
  EXPECT_EQ(norm(point_velocity(model, workspace, ground, point)), 0.0);
  EXPECT_EQ(norm(point_acceleration(model, workspace, ground, point)), 0.0);
}

TEST(Kinematics, refuses_lists_of_the_wrong_size) {
  Random random(15);
  const Model<double> model = testing::built(testing::random_tree(random));
  Workspace<double> workspace(model);
  State<double> state = neutral_state(model);
  const std::vector<double> wrong(model.velocity_size() + 1);
  std::vector<double> jacobian(3 * model.velocity_size() + 1);
  EXPECT_THROW(update_accelerations<double>(model, workspace, state, wrong), std::invalid_argument);
  EXPECT_THROW(point_jacobian<double>(model, workspace, 0, Vector3<double>::zero(), jacobian), std::invalid_argument);
  EXPECT_THROW(angular_jacobian<double>(model, workspace, 0, jacobian), std::invalid_argument);
  state.q.push_back(0.0);
  EXPECT_THROW(update_poses<double>(model, workspace, state.q), std::invalid_argument);
  EXPECT_THROW(update_velocities(model, workspace, state), std::invalid_argument);
}

}  // namespace kinematics_test
}  // namespace poinsot
