// Loops, cords and contacts of MechanismDynamics: gaps, redundancy, the way back onto the constraints.
#include <gtest/gtest.h>

#include <numbers>

#include "engine/motion/mechanism/random_mechanisms.h"
#include "engine/motion/mechanism/sample_mechanisms.h"
#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"

namespace poinsot {
namespace mechanism_constraints_test {

using testing::accelerations_of;
using testing::FourBar;
using testing::largest_of;
using testing::later;
using testing::MechanismMaker;
using testing::Random;
using testing::random_closed_state;
using testing::random_mechanism;
using testing::rod;
using Vector = Vector3<double>;
using std::numbers::pi;

constexpr double g = 9.81;
const Joint<double> about_z = Joint<double>::revolute({0, 0, 1});

TEST(MechanismConstraints, GapsChangeWithTheirRates) {
  Random random(23);
  int cases = 0;
  for (int i = 0; cases < 500 && i < 3000; ++i) {
    MechanismDynamics dynamics(random_mechanism(random));
    auto state = random_closed_state(random, dynamics, 0.5);
    if (!state || dynamics.mechanism().constraints.empty()) continue;
    // Any motion, away from where all is closed.
    state->v = random.numbers(static_cast<int>(state->v.size()), 1);
    const std::vector<double> none(state->v.size(), 0.0);
    const double t = 1e-5;
    const State<double> before = later(dynamics, *state, none, -t), after = later(dynamics, *state, none, t);
    for (std::size_t c = 0; c < dynamics.mechanism().constraints.size(); ++c) {
      if (!binds_positions(dynamics.mechanism().constraints[c])) continue;
      ++cases;
      EXPECT_NEAR((dynamics.gap(c, after.q) - dynamics.gap(c, before.q)) / (2 * t),
                  dynamics.gap_rate(c, state->q, state->v), 1e-7)
          << "mechanism " << i << ", constraint " << c;
    }
  }
  EXPECT_GE(cases, 500);
}

TEST(MechanismConstraints, RedundantConstraintsOfALoopAreFoundAndChangeNothing) {
  for (const double angle : {0.0, 0.4}) {
    FourBar four_bar;
    four_bar.R = rotation_about(normalized(Vector{1, 2, 3}), angle);
    MechanismDynamics redundant(four_bar.mechanism());
    EXPECT_EQ(redundant.redundant_constraints().size(), 3U);
    four_bar.hinge = false;
    MechanismDynamics plain(four_bar.mechanism());
    EXPECT_EQ(plain.redundant_constraints().size(), 1U);
    State<double> state = neutral_state(plain.mechanism().tree);
    state.v = {3, 0, 0};
    plain.project(state.q, state.v);
    const std::vector<double> a = accelerations_of(plain, state), b = accelerations_of(redundant, state);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-11 * largest_of(a));
  }
}

TEST(MechanismConstraints, ALinkageDrawnInASingularPoseKeepsItsConstraints) {
  // All bars on one line.
  FourBar four_bar;
  four_bar.a = 0.3, four_bar.b = 1.0, four_bar.c = 0.5, four_bar.d = 0.8;
  four_bar.crank_angle = 0;
  MechanismDynamics dynamics(four_bar.mechanism());
  EXPECT_EQ(dynamics.redundant_constraints().size(), 3U);
}

// One step of the classical method of order four, then back onto the constraints.
void step(MechanismDynamics& dynamics, State<double>& state, double t) {
  const Model<double>& tree = dynamics.mechanism().tree;
  const std::size_t n_q = state.q.size(), n_v = state.v.size();
  State<double> sum{std::vector<double>(n_q, 0.0), std::vector<double>(n_v, 0.0)}, stage = state;
  std::vector<double> rate(n_q), a(n_v);
  for (const auto& [ahead, weight] :
       {std::pair{0.5, 1.0}, std::pair{0.5, 2.0}, std::pair{1.0, 2.0}, std::pair{0.0, 1.0}}) {
    position_rate<double>(tree, stage.q, stage.v, rate);
    dynamics.accelerations(stage.q, stage.v, a);
    for (std::size_t k = 0; k < n_q; ++k) {
      sum.q[k] += weight / 6 * rate[k];
      stage.q[k] = state.q[k] + ahead * t * rate[k];
    }
    for (std::size_t k = 0; k < n_v; ++k) {
      sum.v[k] += weight / 6 * a[k];
      stage.v[k] = state.v[k] + ahead * t * a[k];
    }
  }
  for (std::size_t k = 0; k < n_q; ++k) state.q[k] += t * sum.q[k];
  for (std::size_t k = 0; k < n_v; ++k) state.v[k] += t * sum.v[k];
  dynamics.project(state.q, state.v);
}

TEST(MechanismConstraints, ALoopStaysClosedAndKeepsItsEnergyOverTurns) {
  for (const double coupler_mass : {1.5, 0.0}) {
    FourBar four_bar;
    four_bar.R = rotation_about(normalized(Vector{1, 2, 3}), 0.4);
    four_bar.coupler_mass = coupler_mass;
    MechanismDynamics dynamics(four_bar.mechanism());
    State<double> state = neutral_state(dynamics.mechanism().tree);
    state.v = {60, 0, 0};
    dynamics.project(state.q, state.v);
    EXPECT_TRUE(dynamics.open_coordinates(state.q).empty());
    const auto energy = [&] { return dynamics.kinetic_energy(state.q, state.v) + dynamics.potential_energy(state.q); };
    const double start = energy();
    double largest_turn = 0;
    for (int i = 0; i < 6000; ++i) {
      step(dynamics, state, 2.5e-4);
      // The hinge that closes the loop: rocker against coupler.
      largest_turn = std::max(largest_turn, std::abs(state.q[2] - state.q[0] - state.q[1]));
      ASSERT_LT(dynamics.largest_gap(state.q), 1e-13);
      ASSERT_LT(dynamics.largest_rate(state.q, state.v), 1e-12);
    }
    EXPECT_GT(std::abs(state.q[0]), 2 * pi);
    EXPECT_GT(largest_turn, 0.5);
    EXPECT_NEAR(energy(), start, 1e-7 * std::abs(start));
  }
}

TEST(MechanismConstraints, PositionsAreFoundAlsoWhereAHingeHasTurnedFar) {
  // A crank and a rod whose end turns on a slider by any angle.
  Random random(5);
  MechanismMaker maker;
  const int crank = maker.add_body(ground, about_z, Vector::zero(), rod(1, 0.3));
  const int coupler = maker.add_body(crank, about_z, {0.3, 0, 0}, rod(1, 0.2));
  const int carriage = maker.add_body(ground, Joint<double>::prismatic({1, 0, 0}), {0.5, 0, 0}, rod(1, 0.1));
  const int slider = maker.add_body(carriage, Joint<double>::prismatic({0, 1, 0}), Vector::zero(), rod(1, 0.1));
  maker.finish_tree(Vector::zero());
  maker.close_loop(coupler, slider, {0.5, 0, 0}, Vector{0, 0, 1});
  MechanismDynamics dynamics(maker.mechanism);
  for (int i = 0; i < 200; ++i) {
    const double q1 = random.uniform(-3, 3), q2 = random.uniform(-3, 3);
    const Vector end{0.3 * std::cos(q1) + 0.2 * std::cos(q1 + q2), 0.3 * std::sin(q1) + 0.2 * std::sin(q1 + q2), 0};
    std::vector<double> q{q1, q2, end.x - 0.5, end.y};
    for (double& entry : q) entry += random.uniform(-0.05, 0.05);
    std::vector<double> v = random.numbers(4, 1);
    EXPECT_LT(dynamics.project(q, v), 1e-15);
    EXPECT_LT(dynamics.largest_rate(q, v), 1e-14);
  }
}

TEST(MechanismConstraints, ACordPullsUntilItIsSlack) {
  MechanismMaker maker;
  const double m = 2, l = 0.5;
  const int bob = maker.add_body(ground, Joint<double>::free(), {l, 0, 0},
                                 {m, Vector::zero(), SymmetricMatrix3<double>::diagonal(1e-3, 1e-3, 1e-3)});
  maker.finish_tree({0, -g, 0});
  maker.add_cord(bob, ground, {l, 0, 0}, Vector::zero());
  MechanismDynamics dynamics(maker.mechanism);
  const int cord = dynamics.mechanism().constraints[0].action;
  State<double> state = neutral_state(dynamics.mechanism().tree);
  state.v[4] = 1.5;  // across the cord
  const std::vector<double> taut = accelerations_of(dynamics, state);
  EXPECT_NEAR(dynamics.component_force(0), m * 1.5 * 1.5 / l, 1e-12);
  EXPECT_NEAR(taut[3], -1.5 * 1.5 / l, 1e-12);
  EXPECT_NEAR(taut[4], -g, 1e-12);
  dynamics.set_acting(cord, false);
  EXPECT_FALSE(dynamics.is_acting(cord));
  const std::vector<double> slack = accelerations_of(dynamics, state);
  EXPECT_NEAR(slack[3], 0, 1e-12);
  EXPECT_NEAR(slack[4], -g, 1e-12);
  EXPECT_EQ(dynamics.component_force(0), 0);
  state.q[4] = -0.2;
  EXPECT_NEAR(dynamics.gap(0, state.q), -0.2, 1e-15);
  state.v[3] = 0.7;
  EXPECT_NEAR(dynamics.gap_rate(0, state.q, state.v), 0.7, 1e-15);
  dynamics.set_acting(cord, true);
  dynamics.project(state.q, state.v);
  EXPECT_NEAR(dynamics.gap(0, state.q), 0, 1e-15);
  EXPECT_NEAR(dynamics.gap_rate(0, state.q, state.v), 0, 1e-15);
}

TEST(MechanismConstraints, AMasslessRodActsAsACordThatMayPush) {
  Random random(8);
  for (int i = 0; i < 100; ++i) {
    const MassProperties<double> mass = random.mass();
    const Vector at = random.vector(), start = random.vector(), gravity = random.vector(10);
    MechanismMaker with_rod, with_cord;
    with_rod.add_body(ground, Joint<double>::free(), Vector::zero(), mass);
    const int link = with_rod.add_body(ground, Joint<double>::free(), random.vector(), massless<double>());
    with_rod.finish_tree(gravity);
    with_rod.close_loop(link, 0, at, std::nullopt);
    with_rod.close_loop(link, ground, start, std::nullopt);
    with_cord.add_body(ground, Joint<double>::free(), Vector::zero(), mass);
    with_cord.finish_tree(gravity);
    with_cord.add_cord(0, ground, at, start);
    MechanismDynamics rod_dynamics(with_rod.mechanism), cord_dynamics(with_cord.mechanism);
    State<double> cord_state = neutral_state(cord_dynamics.mechanism().tree);
    cord_state.v = random.numbers(6, 1);
    cord_dynamics.project(cord_state.q, cord_state.v);
    State<double> rod_state = neutral_state(rod_dynamics.mechanism().tree);
    // The rod takes part in the changes, if little: its rates follow in a few rounds.
    for (int round = 0; round < 10; ++round) {
      std::copy(cord_state.v.begin(), cord_state.v.end(), rod_state.v.begin());
      rod_dynamics.project(rod_state.q, rod_state.v);
    }
    for (std::size_t k = 0; k < 6; ++k) ASSERT_NEAR(rod_state.v[k], cord_state.v[k], 1e-12);
    const std::vector<double> a = accelerations_of(rod_dynamics, rod_state);
    const std::vector<double> b = accelerations_of(cord_dynamics, cord_state);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(a[k], b[k], 1e-9 * (1 + largest_of(b)));
    // Nothing but the rod's turning about its own line is open.
    const std::vector<OpenCoordinate> open = rod_dynamics.open_coordinates(rod_state.q);
    EXPECT_FALSE(open.empty());
    for (const OpenCoordinate& coordinate : open) {
      EXPECT_GE(coordinate.coordinate, 6);
      EXPECT_TRUE(coordinate.without_inertia);
    }
  }
}

TEST(MechanismConstraints, AMechanismWithoutFreedomStandsStill) {
  // Two arms on parallel axes, joined by a hinge on a third: a frame.
  MechanismMaker maker;
  const int a = maker.add_body(ground, about_z, Vector::zero(), rod(1, 0.3));
  const int b = maker.add_body(ground, about_z, {0.5, 0, 0}, rod(1, 0.3));
  maker.finish_tree({1, -g, 0});
  maker.close_loop(a, b, {0.3, 0.2, 0}, Vector{0, 0, 1});
  MechanismDynamics dynamics(maker.mechanism);
  EXPECT_EQ(dynamics.redundant_constraints().size(), 3U);
  State<double> state{{0, 0}, {1, -1}};
  EXPECT_LT(dynamics.project(state.q, state.v), 1e-15);
  EXPECT_LT(largest_of(state.v), 1e-15);
  EXPECT_LT(largest_of(accelerations_of(dynamics, state)), 1e-13);
  EXPECT_LT(dynamics.constraint_misfit(), 1e-12);
  EXPECT_TRUE(dynamics.open_coordinates(state.q).empty());
}

TEST(MechanismConstraints, WithEveryCoordinateHeldOnlyEffortsAreLeft) {
  MechanismMaker maker;
  maker.add_body(ground, about_z, Vector::zero(), rod(2, 0.6));
  maker.finish_tree({0, -g, 0});
  maker.mechanism.drives[0].held = true;
  MechanismDynamics dynamics(maker.mechanism);
  EXPECT_EQ(accelerations_of(dynamics, {{0}, {0}})[0], 0);
  EXPECT_NEAR(dynamics.held_effort(0), 2 * g * 0.3, 1e-13);
  EXPECT_TRUE(dynamics.open_coordinates(std::vector<double>{0}).empty());
}

TEST(MechanismConstraints, GivenMotionsThatContradictALoopAreNoticed) {
  FourBar four_bar;
  Mechanism<double> mechanism = four_bar.mechanism();
  mechanism.drives[0].held = mechanism.drives[2].held = true;
  MechanismDynamics dynamics(mechanism);
  State<double> state = neutral_state(dynamics.mechanism().tree);
  dynamics.set_held_acceleration(0, 1);
  dynamics.set_held_acceleration(2, -5);
  accelerations_of(dynamics, state);
  EXPECT_GT(dynamics.constraint_misfit(), 1e-3);
}

}  // namespace mechanism_constraints_test
}  // namespace poinsot
