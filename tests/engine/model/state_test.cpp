// States and the motion of positions.
#include "poinsot/engine/model/state.h"

#include <gtest/gtest.h>

#include <random>

#include "poinsot/engine/model/builder.h"

namespace poinsot {
namespace state_test {

const MassProperties<double> block{2.0, {0.1, 0.2, 0.3}, SymmetricMatrix3<double>::diagonal(1.0, 2.0, 2.5)};

Model<double> all_joints() {
  ModelBuilder<double> builder;
  builder.add_body("free", ground, Joint<double>::free(), {}, block);
  builder.add_body("ball", 0, Joint<double>::ball(), {}, block);
  builder.add_body("hinge", 1, Joint<double>::revolute({1, 0, 0}), {}, block);
  builder.add_body("weld", 2, Joint<double>::weld(), {}, block);
  builder.add_body("slide", 3, Joint<double>::prismatic({1, 0, 0}), {}, block);
  builder.add_body("screw", 4, Joint<double>::screw({1, 0, 0}, 0.1), {}, block);
  return builder.build();
}

TEST(State, neutral_is_the_identity_at_rest) {
  const State<double> state = neutral_state(all_joints());
  ASSERT_EQ(state.q.size(), 14u);
  ASSERT_EQ(state.v.size(), 12u);
  for (std::size_t k = 0; k < 14; ++k) EXPECT_EQ(state.q[k], k == 0 || k == 7 ? 1.0 : 0.0);
  for (const double v : state.v) EXPECT_EQ(v, 0.0);
}

// Constant joint velocities for two spans in turn are those for the whole, there and back is nothing, and the first
// rate is position_rate.
TEST(State, integrated_positions_compose_and_return) {
  const Model<double> model = all_joints();
  std::mt19937_64 engine(9);
  std::uniform_real_distribution<double> uniform(-2.0, 2.0);
  for (int trial = 0; trial < 300; ++trial) {
    State<double> state = neutral_state(model);
    for (double& v : state.v) v = uniform(engine);
    integrate_position<double>(model, state.q, state.v, uniform(engine));  // somewhere
    for (double& v : state.v) v = uniform(engine);
    const std::vector<double> start = state.q;
    std::vector<double> once = start;
    integrate_position<double>(model, once, state.v, 1.0);
    std::vector<double> twice = start;
    integrate_position<double>(model, twice, state.v, 0.3);
    integrate_position<double>(model, twice, state.v, 0.7);
    std::vector<double> back = once;
    integrate_position<double>(model, back, state.v, -1.0);
    for (std::size_t k = 0; k < start.size(); ++k) {
      ASSERT_NEAR(once[k], twice[k], 2e-14);
      ASSERT_NEAR(back[k], start[k], 2e-14);
    }
    std::vector<double> rate(start.size());
    position_rate<double>(model, start, state.v, rate);
    const double h = 1e-3;
    const auto moved = [&](double t) {
      std::vector<double> q = start;
      integrate_position<double>(model, q, state.v, t);
      return q;
    };
    const std::vector<double> p1 = moved(h);
    const std::vector<double> m1 = moved(-h);
    const std::vector<double> p2 = moved(2.0 * h);
    const std::vector<double> m2 = moved(-2.0 * h);
    for (std::size_t k = 0; k < start.size(); ++k) {
      const double slope = (8.0 * (p1[k] - m1[k]) - (p2[k] - m2[k])) / (12.0 * h);
      ASSERT_NEAR(rate[k], slope, 1e-9);
    }
  }
}

// A free body that turns about its z axis while its origin moves along x: the origin runs on a circle.
TEST(State, a_constant_twist_is_a_screw_motion) {
  ModelBuilder<double> builder;
  builder.add_body("free", ground, Joint<double>::free(), {}, block);
  const Model<double> model = builder.build();
  State<double> state = neutral_state(model);
  const double w = 0.8;
  const double v = 1.7;
  state.v = {0.0, 0.0, w, v, 0.0, 0.5};
  for (const double t : {1e-9, 0.1, 2.0, 7.0}) {
    std::vector<double> q = state.q;
    integrate_position<double>(model, q, state.v, t);
    const double radius = v / w;
    EXPECT_NEAR(q[4], radius * std::sin(w * t), 1e-14);
    EXPECT_NEAR(q[5], radius * 2.0 * std::pow(std::sin(w * t / 2.0), 2), 1e-14);
    EXPECT_NEAR(q[6], 0.5 * t, 1e-14);
    EXPECT_NEAR(q[0], std::cos(w * t / 2.0), 1e-15);
    EXPECT_NEAR(q[3], std::sin(w * t / 2.0), 1e-15);
  }
}

TEST(State, refuses_lists_of_the_wrong_size) {
  const Model<double> model = all_joints();
  State<double> state = neutral_state(model);
  std::vector<double> rate(15);
  EXPECT_THROW(position_rate<double>(model, state.q, state.v, rate), std::invalid_argument);
  state.v.push_back(0.0);
  EXPECT_THROW(integrate_position<double>(model, state.q, state.v, 0.1), std::invalid_argument);
}

}  // namespace state_test
}  // namespace poinsot
