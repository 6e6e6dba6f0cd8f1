// A body that moves by itself: closed forms and the integrator of rotations against the general equations of a
// mechanism, in every description by joints; and what is no such body.
#include "poinsot/engine/motion/mechanism/lone_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "poinsot/engine/math/algebra/rotation.h"
#include "poinsot/engine/model/builder.h"
#include "poinsot/engine/motion/closed_form/symmetric_top.h"
#include "poinsot/engine/motion/mechanism/mechanism_equations.h"

namespace poinsot {
namespace lone_body_test {

using Vector = Vector3<double>;
using Tensor = SymmetricMatrix3<double>;
using Joint = Joint<double>;
using Mass = MassProperties<double>;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()(double from = -1, double to = 1) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  Vector vector(double size = 1) { return {size * (*this)(), size * (*this)(), size * (*this)()}; }
  Matrix3<double> rotation() { return rotation_exponential(vector(2)); }
  SpatialTransform<double> frame() { return {rotation(), vector()}; }

 private:
  std::mt19937_64 engine_;
};

const Mass nothing{0, Vector::zero(), Tensor::zero()};

Mass symmetric_body(Random& random, const Vector& axis, double arm) {
  const double across = random(0.2, 2), along = random(0.05, 1.9) * across;
  const Tensor I = turned(axes_with_z_along(axis), Tensor::diagonal(across, across, along));
  return {random(0.5, 3), arm * axis, I};
}
Mass any_body(Random& random, const Vector& center) {
  const double a = random(0.2, 1), b = random(0.2, 1), c = random(0.2, 1);
  return {random(0.5, 3), center, turned(random.rotation(), Tensor::diagonal(b + c, c + a, a + b))};
}

// Angles whose axes meet, each perpendicular to the next.
int add_angles(ModelBuilder<double>& builder, const std::vector<Vector>& axes, const SpatialTransform<double>& frame,
               const Mass& mass) {
  int parent = ground;
  for (std::size_t k = 0; k < axes.size(); ++k)
    parent =
        builder.add_body("link" + std::to_string(k), parent, Joint::revolute(axes[k]),
                         k == 0 ? frame : SpatialTransform<double>::identity(), k + 1 == axes.size() ? mass : nothing);
  return parent;
}

Mechanism<double> mechanism_of(ModelBuilder<double> builder, const Vector& gravity) {
  Mechanism<double> mechanism;
  builder.set_gravity(gravity);
  mechanism.tree = builder.build();
  mechanism.takes_part.assign(static_cast<std::size_t>(mechanism.tree.body_count()), true);
  mechanism.coordinate_names.assign(static_cast<std::size_t>(mechanism.tree.velocity_size()), "rate");
  return mechanism;
}

State<double> random_state(const Model<double>& tree, Random& random, double fast) {
  State<double> state = neutral_state(tree);
  for (double& v : state.v) v = fast * random();
  for (const Body<double>& body : tree.bodies()) {
    if (body.joint == JointType::revolute) state.q[body.q] = random(0.3, 1.2);
    if (position_size(body.joint) < 4) continue;
    const Quaternion<double> a = quaternion_exponential(random.vector(3));
    double* q = &state.q[body.q];
    q[0] = a.w, q[1] = a.x, q[2] = a.y, q[3] = a.z;
    if (body.joint == JointType::free)
      for (int k = 4; k < 7; ++k) q[k] = random();
  }
  return state;
}

// Follows by both roads and compares on the way. allowed: of the difference, to what the general road attains.
void expect_same(const Mechanism<double>& mechanism, const State<double>& start, double t, const std::string& method,
                 std::vector<int> held = {}, double allowed = 2e-10) {
  MechanismDynamics dynamics(mechanism, held);
  const MotionEquations equations = mechanism_equations(dynamics);
  const auto lone = LoneBody::find(mechanism, held);
  ASSERT_TRUE(lone);
  IntegrationOptions options;
  options.tolerance = 1e-13;
  const auto found = lone->follow(equations, 0.5, start.q, start.v, 0.5 + t, options);
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->complete()) << describe(*found);
  EXPECT_EQ(found->method, method);
  EXPECT_DOUBLE_EQ(found->time, 0.5 + t);
  for (const Drift& drift : found->drift) EXPECT_LT(drift.largest, 1e-11 * (1 + std::abs(drift.start))) << drift.name;
  const IntegrationResult other = integrate(equations, 0.5, start.q, start.v, 0.5 + t, options);
  ASSERT_TRUE(other.complete());
  for (const double part : {0.0, 0.137, 0.5, 0.731, 1.0}) {
    const State<double> a = found->trajectory.state(0.5 + part * t), b = other.trajectory.state(0.5 + part * t);
    double sign = 1;
    if (!equations.quaternions.empty()) {
      const auto k = static_cast<std::size_t>(equations.quaternions.front());
      sign = a.q[k] * b.q[k] + a.q[k + 1] * b.q[k + 1] + a.q[k + 2] * b.q[k + 2] + a.q[k + 3] * b.q[k + 3] < 0 ? -1 : 1;
    }
    for (std::size_t i = 0; i < a.q.size(); ++i) {
      const bool quaternion = !equations.quaternions.empty() && i < 4;
      EXPECT_NEAR(a.q[i], (quaternion ? sign : 1) * b.q[i], allowed * (1 + std::abs(b.q[i]))) << method << " q" << i;
    }
    for (std::size_t i = 0; i < a.v.size(); ++i)
      EXPECT_NEAR(a.v[i], b.v[i], 10 * allowed * (1 + std::abs(b.v[i]))) << method << " v" << i;
  }
}

TEST(LoneBody, of_free_bodies_tumbles_along_a_parabola) {
  Random random(1);
  for (int i = 0; i < 12; ++i) {
    ModelBuilder<double> builder;
    const int body =
        builder.add_body("body", ground, Joint{JointType::free}, random.frame(), any_body(random, random.vector()));
    builder.add_body("rider", body, Joint::weld(), random.frame(), any_body(random, random.vector()));
    const auto mechanism = mechanism_of(builder, random.vector(9));
    expect_same(mechanism, random_state(mechanism.tree, random, 3), 2, "closed form: torque-free motion");
  }
}

TEST(LoneBody, held_at_its_mass_center_or_without_weight_is_free_of_torque) {
  Random random(2);
  for (int i = 0; i < 12; ++i) {
    const bool weightless = i % 2 == 0;
    const Vector gravity = weightless ? Vector::zero() : random.vector(9);
    const Vector center = weightless ? random.vector() : Vector::zero();
    ModelBuilder<double> ball;
    ball.add_body("body", ground, Joint{JointType::ball}, random.frame(), any_body(random, center));
    const auto on_ball = mechanism_of(ball, gravity);
    expect_same(on_ball, random_state(on_ball.tree, random, 3), 2, "closed form: torque-free motion");

    ModelBuilder<double> gimbals;
    const Matrix3<double> R = random.rotation();
    add_angles(gimbals, {R.column(0), R.column(1), R.column(2)}, random.frame(), any_body(random, center));
    const auto in_gimbals = mechanism_of(gimbals, gravity);
    expect_same(in_gimbals, random_state(in_gimbals.tree, random, 2), 2, "closed form: torque-free motion", {}, 1e-9);
  }
}

TEST(LoneBody, symmetric_about_the_line_to_its_fixed_point_is_a_top) {
  Random random(3);
  for (int i = 0; i < 12; ++i) {
    const Vector gravity = random.vector(9);
    const Matrix3<double> R = random.rotation();
    ModelBuilder<double> ball;
    ball.add_body("body", ground, Joint{JointType::ball}, random.frame(),
                  symmetric_body(random, R.column(0), random(-1, 1)));
    const auto on_ball = mechanism_of(ball, gravity);
    expect_same(on_ball, random_state(on_ball.tree, random, 4), 2, "closed form: symmetric top");

    ModelBuilder<double> euler;
    const Vector up = -normalized(gravity);
    const Matrix3<double> E = axes_with_z_along(up);
    add_angles(euler, {E.column(2), E.column(0), E.column(2)}, SpatialTransform<double>::identity(),
               symmetric_body(random, E.column(2), random(0.2, 1)));
    const auto by_euler = mechanism_of(euler, gravity);
    State<double> start = random_state(by_euler.tree, random, 1);
    start.v[2] += 40;
    expect_same(by_euler, start, 2, "closed form: symmetric top", {}, 1e-9);
  }
}

TEST(LoneBody, without_inertia_about_its_arm_is_a_spherical_pendulum) {
  Random random(4);
  for (int i = 0; i < 12; ++i) {
    const Vector gravity{0, 0, -9.81};
    const Matrix3<double> R = random.rotation();
    const double length = random(0.3, 1.5);
    const Mass rod{1.3, length * R.column(2), 0.1 * turned(R, Tensor::diagonal(1, 1, 0))};
    ModelBuilder<double> fork;
    add_angles(fork, {R.column(0), R.column(1)}, random.frame(),
               i % 2 ? rod : Mass{1.3, length * R.column(2), Tensor::zero()});
    const auto mechanism = mechanism_of(fork, gravity);
    expect_same(mechanism, random_state(mechanism.tree, random, 1), 2, "closed form: spherical pendulum", {}, 1e-9);

    // The same on a ball joint, its spin held.
    ModelBuilder<double> ball;
    ball.add_body("body", ground, Joint{JointType::ball}, random.frame(),
                  Mass{1.3, Vector{0, 0, length}, Tensor::diagonal(0.1, 0.1, 0)});
    const auto on_ball = mechanism_of(ball, gravity);
    State<double> start = random_state(on_ball.tree, random, 1);
    start.v[2] = 0;
    expect_same(on_ball, start, 2, "closed form: spherical pendulum", {2});
  }
}

TEST(LoneBody, about_an_axis_swings_turns_over_or_turns_evenly) {
  Random random(5);
  for (int i = 0; i < 30; ++i) {
    ModelBuilder<double> builder;
    builder.add_body("body", ground, Joint::revolute(random.vector()), random.frame(),
                     any_body(random, random.vector()));
    const auto mechanism = mechanism_of(builder, random.vector(9));
    State<double> start = random_state(mechanism.tree, random, i % 3 == 0 ? 12 : 2);
    start.q[0] = random(-10, 10);
    expect_same(mechanism, start, 5, "closed form: pendulum", {}, 1e-9);
  }
  ModelBuilder<double> rotor;
  rotor.add_body("body", ground, Joint::revolute({0, 0, 1}), SpatialTransform<double>::identity(),
                 any_body(random, {0, 0, 1}));
  const auto level = mechanism_of(rotor, {0, 9.81, 0});
  expect_same(level, {{0.3}, {7.0}}, 5, "closed form: uniform rotation");
}

// Released exactly at the bottom, and exactly upright with a push.
TEST(LoneBody, swings_from_the_vertical_in_both_senses) {
  ModelBuilder<double> builder;
  builder.add_body("body", ground, Joint::revolute({1, 0, 0}), SpatialTransform<double>::identity(),
                   Mass{2, {0, 0, -0.5}, Tensor::diagonal(0.1, 0.1, 0.1)});
  const auto mechanism = mechanism_of(builder, {0, 0, -9.81});
  for (const double angle : {0.0, std::numbers::pi, -std::numbers::pi})
    for (const double rate : {-9.0, -3.0, 3.0, 9.0})
      expect_same(mechanism, {{angle}, {rate}}, 3, "closed form: pendulum", {}, 1e-9);
}

TEST(LoneBody, of_any_shape_with_a_fixed_point_is_integrated_as_a_rotation) {
  Random random(6);
  for (int i = 0; i < 8; ++i) {
    ModelBuilder<double> ball;
    ball.add_body("body", ground, Joint{JointType::ball}, random.frame(), any_body(random, random.vector()));
    const auto on_ball = mechanism_of(ball, random.vector(9));
    expect_same(on_ball, random_state(on_ball.tree, random, 3), 1, "integrated about the free motion of the body", {},
                1e-9);
    ModelBuilder<double> gimbals;
    const Matrix3<double> R = random.rotation();
    add_angles(gimbals, {R.column(0), R.column(1), R.column(2)}, random.frame(), any_body(random, random.vector()));
    const auto in_gimbals = mechanism_of(gimbals, random.vector(5));
    State<double> start = random_state(in_gimbals.tree, random, 1);
    start.v[2] += 20;
    expect_same(in_gimbals, start, 1, "integrated about the free motion of the body", {}, 1e-8);
  }
}

TEST(LoneBody, finds_events_on_the_way) {
  ModelBuilder<double> builder;
  builder.add_body("body", ground, Joint{JointType::free}, SpatialTransform<double>::identity(),
                   Mass{2, {0, 0, 0}, Tensor::diagonal(1, 2, 3)});
  const auto mechanism = mechanism_of(builder, {0, 0, -10});
  MechanismDynamics dynamics(mechanism);
  const MotionEquations equations = mechanism_equations(dynamics);
  State<double> start = neutral_state(mechanism.tree);
  start.v = {0, 0, 3, 1, 0, 20};
  Event lands;
  lands.name = "lands";
  lands.terminal = true;
  lands.value = [](double, std::span<const double> q, std::span<const double>) { return q[6]; };
  const auto result = LoneBody::find(mechanism)->follow(equations, 0, start.q, start.v, 100, {}, {&lands, 1});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->ending, Ending::terminal_event);
  EXPECT_NEAR(result->time, 4, 1e-14);
  EXPECT_NEAR(result->q[4], 4, 1e-13);
}

TEST(LoneBody, goes_to_late_times_in_few_steps) {
  ModelBuilder<double> builder;
  builder.add_body("body", ground, Joint{JointType::ball}, SpatialTransform<double>::identity(),
                   Mass{2, {0, 0, 0}, Tensor::diagonal(1, 2, 3)});
  const auto mechanism = mechanism_of(builder, Vector::zero());
  MechanismDynamics dynamics(mechanism);
  State<double> start = neutral_state(mechanism.tree);
  start.v = {0.1, 5, 0.1};
  const auto result = LoneBody::find(mechanism)->follow(mechanism_equations(dynamics), 0, start.q, start.v, 1e9, {});
  ASSERT_TRUE(result && result->complete());
  EXPECT_LT(result->statistics.steps, 200'000);
  EXPECT_LT(result->drift[0].largest, 1e-12 * result->drift[0].start);
}

// Eulerian angles of a top after many turns, against its own formulas for them.
TEST(LoneBody, counts_the_turns_of_angles_up_to_late_times) {
  const double mass = 2, arm = 0.3, at_center = 0.32, axial = 0.2, g = 9.81, late = 3e6;
  const double transverse = at_center + mass * arm * arm;
  ModelBuilder<double> builder;
  add_angles(builder, {{0, 0, 1}, {0, 1, 0}, {0, 0, 1}}, SpatialTransform<double>::identity(),
             Mass{mass, {0, 0, arm}, Tensor::diagonal(at_center, at_center, axial)});
  const auto mechanism = mechanism_of(builder, {0, 0, -g});
  MechanismDynamics dynamics(mechanism);
  const MotionEquations equations = mechanism_equations(dynamics);
  const double rates[][3] = {{0.3, 0.1, 25}, {-1.5, 0.4, 8}, {2, 0, -3}};
  for (const auto& [phi_rate, theta_rate, psi_rate] : rates) {
    const std::vector<double> q{0.2, 0.7, -0.4}, v{phi_rate, theta_rate, psi_rate};
    const auto result = LoneBody::find(mechanism)->follow(equations, 0, q, v, late, {});
    ASSERT_TRUE(result && result->complete());
    EXPECT_LT(result->statistics.steps, 200'000);
    const SymmetricTop top({transverse, axial, mass * g * arm},
                           {q[1], v[1], q[0], v[0], q[2], v[2] + v[0] * std::cos(q[1])});
    for (const double part : {0.137, 0.5, 1.0}) {
      const State<double> found = result->trajectory.state(part * late);
      const TopState expected = top.at(part * late);
      EXPECT_NEAR(found.q[0], expected.precession, 1e-6);
      EXPECT_NEAR(found.q[1], expected.nutation, 1e-6);
      EXPECT_NEAR(found.q[2], expected.spin, 1e-6);
    }
  }
}

TEST(LoneBody, counts_the_turns_of_a_pendulum_up_to_late_times) {
  ModelBuilder<double> builder;
  builder.add_body("bar", ground, Joint::revolute({0, 1, 0}), SpatialTransform<double>::identity(),
                   Mass{1, {0, 0, -0.5}, Tensor::diagonal(1.0 / 12, 1.0 / 12, 0)});
  const auto mechanism = mechanism_of(builder, {0, 0, -9.81});
  MechanismDynamics dynamics(mechanism);
  const double late = 2e6;
  for (const double rate : {1.0, 9.0, -13.0}) {
    const auto result = LoneBody::find(mechanism)->follow(mechanism_equations(dynamics), 0, std::vector<double>{0.3},
                                                          std::vector<double>{rate}, late, {});
    ASSERT_TRUE(result && result->complete());
    EXPECT_LT(result->statistics.steps, 200'000);
    EXPECT_LT(result->drift[0].largest, 1e-8 * std::abs(result->drift[0].start));
    // The period by the mean of 1/rate over a turn, from the energy; a swing stays where it is.
    if (std::abs(rate) < 7) {
      EXPECT_LT(std::abs(result->q[0]), 3.2);
      continue;
    }
    constexpr int samples = 2000;
    double period = 0;
    for (int k = 0; k < samples; ++k) {
      const double angle = 2 * std::numbers::pi * k / samples;
      period += 2 * std::numbers::pi / samples / std::sqrt(rate * rate + 3 * 9.81 * (std::cos(angle) - std::cos(0.3)));
    }
    EXPECT_NEAR(result->q[0] * (rate > 0 ? 1 : -1) / (2 * std::numbers::pi), late / period, 1);
  }
}

// A rod's turning about its own line moves nothing and stays what it was.
TEST(LoneBody, a_rod_keeps_the_spin_that_it_was_given) {
  for (const double g : {0.0, 9.81})
    for (const double axial : {0.0, 1e-9}) {
      ModelBuilder<double> builder;
      add_angles(builder, {{0, 0, 1}, {0, 1, 0}, {0, 0, 1}}, SpatialTransform<double>::identity(),
                 Mass{1, {0, 0, 0.5}, Tensor::diagonal(1.0 / 12, 1.0 / 12, axial)});
      const auto mechanism = mechanism_of(builder, {0, 0, -g});
      MechanismDynamics dynamics(mechanism);
      const std::vector<double> q{0.1, 0.6, 0.2}, v{2, 1, 5};
      const double spin = v[2] + v[0] * std::cos(q[1]);
      const auto result = LoneBody::find(mechanism)->follow(mechanism_equations(dynamics), 0, q, v, 1.5, {});
      ASSERT_TRUE(result && result->complete());
      EXPECT_NEAR(result->v[2] + result->v[0] * std::cos(result->q[1]), spin, 1e-12 * spin);
      // As of a body with next to no such inertia, which the general equations move.
      ModelBuilder<double> thin;
      add_angles(thin, {{0, 0, 1}, {0, 1, 0}, {0, 0, 1}}, SpatialTransform<double>::identity(),
                 Mass{1, {0, 0, 0.5}, Tensor::diagonal(1.0 / 12, 1.0 / 12, 1e-9)});
      const auto body = mechanism_of(thin, {0, 0, -g});
      MechanismDynamics general(body);
      const IntegrationResult other = integrate(mechanism_equations(general), 0, q, v, 1.5);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(result->q[k], other.q[k], 1e-6);
    }
}

TEST(LoneBody, is_none_under_loads_with_others_or_with_axes_that_do_not_meet) {
  Random random(7);
  const auto lone = [&](const std::function<void(ModelBuilder<double>&)>& build) {
    ModelBuilder<double> builder;
    build(builder);
    return LoneBody::find(mechanism_of(builder, {0, 0, -9.81})).has_value();
  };
  const Mass mass = any_body(random, random.vector());
  const auto identity = SpatialTransform<double>::identity();
  EXPECT_TRUE(lone([&](auto& b) { b.add_body("a", ground, Joint{JointType::ball}, identity, mass); }));
  EXPECT_FALSE(lone([&](auto& b) {
    b.add_body("a", ground, Joint{JointType::ball}, identity, mass);
    b.add_body("b", ground, Joint{JointType::ball}, identity, mass);
  }));
  EXPECT_FALSE(lone([&](auto& b) {
    const int a = b.add_body("a", ground, Joint::revolute({0, 0, 1}), identity, mass);
    b.add_body("b", a, Joint::revolute({1, 0, 0}), identity, mass);
  }));
  EXPECT_FALSE(lone([&](auto& b) {
    const int a = b.add_body("a", ground, Joint::revolute({0, 0, 1}), identity, nothing);
    const int c = b.add_body("b", a, Joint::revolute({1, 0, 0}),
                             SpatialTransform<double>{Matrix3<double>::identity(), {0, 0.1, 0}}, nothing);
    b.add_body("c", c, Joint::revolute({0, 0, 1}), identity, mass);
  }));
  // Two axes that hold a body with inertia about the third.
  EXPECT_FALSE(lone([&](auto& b) { add_angles(b, {{0, 0, 1}, {1, 0, 0}}, identity, mass); }));
  // Axes that are not perpendicular.
  EXPECT_FALSE(lone([&](auto& b) { add_angles(b, {{0, 0, 1}, {1, 0, 1}, {0, 1, 0}}, identity, mass); }));

  ModelBuilder<double> builder;
  builder.add_body("a", ground, Joint::revolute({0, 0, 1}), identity, mass);
  Mechanism<double> loaded = mechanism_of(builder, Vector::zero());
  EXPECT_TRUE(LoneBody::find(loaded));
  Drive<double> drive;
  drive.damping = 0.1;
  loaded.drives.push_back(drive);
  EXPECT_FALSE(LoneBody::find(loaded));
  loaded.drives.clear();
  loaded.springs.push_back({});
  EXPECT_FALSE(LoneBody::find(loaded));
  loaded.springs.clear();
  const int held[] = {0};
  EXPECT_FALSE(LoneBody::find(loaded, held));
}

}  // namespace lone_body_test
}  // namespace poinsot
