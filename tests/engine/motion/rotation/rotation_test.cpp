// The rotation of one rigid body against 25-digit references, the general integrator and conservation.
#include "poinsot/engine/motion/rotation/rotation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "engine/motion/rotation/rotation_collocation.h"
#include "engine/motion/rotation/rotation_splitting.h"
#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot {
namespace rotation_test {

using Numbers = std::vector<double>;
constexpr Quaternion<double> at_rest{1.0, 0.0, 0.0, 0.0};

// Angle between attitudes, rad.
double apart(std::span<const double> q, const std::array<double, 4>& exact) {
  double dot = 0.0;
  for (std::size_t i = 0; i < 4; ++i) dot += q[i] * exact[i];
  double square = 0.0;
  for (std::size_t i = 0; i < 4; ++i) square += std::pow((dot < 0.0 ? -q[i] : q[i]) - exact[i], 2);
  return 4.0 * std::asin(std::min(1.0, 0.5 * std::sqrt(square)));
}

RotatingBody free_body(Vector3<double> moments) {
  RotatingBody body;
  body.inertia = SymmetricMatrix3<double>::diagonal(moments.x, moments.y, moments.z);
  return body;
}

// The heavy top of Bruels and Cardona: 15 kg at 1 m along y.
RotatingBody top(double Ixx) {
  RotatingBody body = free_body({Ixx, 0.46875, 15.234375});
  body.first_moment = {0.0, 15.0, 0.0};
  body.gravity = {0.0, 0.0, -9.81};
  return body;
}
const Vector3<double> top_spin{0.0, 150.0, -4.61538};

IntegrationOptions with_tolerance(double tolerance, IntegrationMethod method = IntegrationMethod::automatic) {
  IntegrationOptions options;
  options.tolerance = tolerance;
  options.method = method;
  return options;
}

// References by Taylor series of degree 40 in 40-digit arithmetic.
const std::array<double, 4> free_at_100{-0.0169736334790839982435844, 0.763707356474878484809854,
                                        0.00348801869715182540305308, 0.645329995551298481317482};
const std::array<double, 4> top_at_2{0.122947135041533467104252, -0.491079892550027014699045,
                                     0.350430030343620961839020, -0.787986887550485669324174};
const std::array<double, 4> top_at_10{0.716619525740420071959180, -0.623436191172728756583058,
                                      -0.0566395013845272216640416, 0.307531685760229194087554};
const std::array<double, 4> triaxial_at_2{0.129774690806640853663107, -0.483590588814031831991393,
                                          0.355647226632329804426100, -0.789185480242300833061324};
const std::array<double, 4> triaxial_at_10{0.7128488049060005398178, -0.6184314785516854295330,
                                           -0.003530662589963704367367, 0.3307213662619015851158};

TEST(Rotation, follows_the_references_at_every_tolerance) {
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12, 1e-14}) {
    const IntegrationOptions options = with_tolerance(tolerance);
    // Near the separatrix errors grow a thousandfold.
    IntegrationResult r = integrate_rotation(free_body({1.0, 2.0, 3.0}), 0.0, at_rest, {0.1, 5.0, 0.1}, 100.0, options);
    EXPECT_LT(apart(r.q, free_at_100), 1e4 * tolerance + 3e-11) << tolerance;
    r = integrate_rotation(top(15.234375), 0.0, at_rest, top_spin, 2.0, options);
    EXPECT_LT(apart(r.q, top_at_2), 10.0 * tolerance + 2e-12) << tolerance;
    EXPECT_LT(r.statistics.steps, 60);
    r = integrate_rotation(top(15.3), 0.0, at_rest, top_spin, 2.0, options);
    EXPECT_LT(apart(r.q, triaxial_at_2), 200.0 * tolerance + 3e-12) << tolerance;
    EXPECT_LT(r.statistics.steps, 250);
  }
  const IntegrationOptions options = with_tolerance(1e-13);
  EXPECT_LT(apart(integrate_rotation(top(15.234375), 0.0, at_rest, top_spin, 10.0, options).q, top_at_10), 2e-11);
  EXPECT_LT(apart(integrate_rotation(top(15.3), 0.0, at_rest, top_spin, 10.0, options).q, triaxial_at_10), 2e-11);
}

TEST(Rotation, the_general_integrator_and_the_splitting_agree) {
  const RotatingBody body = top(15.234375);
  const IntegrationResult general = integrate_rotation(body, 0.0, at_rest, top_spin, 2.0,
                                                       with_tolerance(1e-12, IntegrationMethod::explicit_runge_kutta));
  EXPECT_LT(apart(general.q, top_at_2), 1e-10);
  const IntegrationResult split = integrate_rotation(body, 0.0, at_rest, top_spin, 2.0,
                                                     with_tolerance(1e-12, IntegrationMethod::structure_preserving));
  EXPECT_LT(apart(split.q, top_at_2), 1e-10);
  const IntegrationResult rounded = integrate_rotation(top(15.3), 0.0, at_rest, top_spin, 2.0,
                                                       with_tolerance(1e-12, IntegrationMethod::structure_preserving));
  EXPECT_LT(apart(rounded.q, triaxial_at_2), 1e-9);
}

// A random body with a fixed point in a random pose; triaxial, symmetric or spherical, with products of inertia.
struct Sample {
  RotatingBody body;
  Quaternion<double> attitude;
  Vector3<double> w;
};
Sample random_sample(std::mt19937_64& random, int kind) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&](double size) { return size * Vector3<double>{unit(random), unit(random), unit(random)}; };
  Sample sample;
  Vector3<double> moments{1.5 + unit(random), 1.5 + unit(random), 0.0};
  moments.z = 0.3 + 0.6 * (moments.x + moments.y) * std::fabs(unit(random));
  if (kind % 3 == 1) moments.y = moments.x;
  if (kind % 3 == 2) moments.y = moments.z = moments.x;
  sample.body.inertia = turned(rotation_matrix(quaternion_exponential(vector(3.0))),
                               SymmetricMatrix3<double>::diagonal(moments.x, moments.y, moments.z));
  if (kind % 2 == 0) {
    sample.body.first_moment = vector(1.0);
    sample.body.gravity = vector(5.0);
  }
  sample.attitude = quaternion_exponential(vector(3.0));
  sample.w = vector(kind % 5 == 0 ? 30.0 : 3.0);
  return sample;
}

TEST(Rotation, random_bodies_move_as_by_the_general_integrator) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 300; ++i) {
    const Sample s = random_sample(random, i);
    const double end = i % 7 == 0 ? -2.0 : 3.0;
    const IntegrationResult fast = integrate_rotation(s.body, 0.0, s.attitude, s.w, end, with_tolerance(1e-11));
    const IntegrationResult slow =
        integrate(rotation_equations(s.body), 0.0, Numbers{s.attitude.w, s.attitude.x, s.attitude.y, s.attitude.z},
                  Numbers{s.w.x, s.w.y, s.w.z}, end, with_tolerance(1e-12));
    ASSERT_EQ(fast.ending, Ending::reached_end) << i;
    ASSERT_EQ(slow.ending, Ending::reached_end) << i;
    const double size = 1.0 + norm(s.w);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(fast.q[k], slow.q[k], 1e-8 * size) << i;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(fast.v[k], slow.v[k], 1e-8 * size * size) << i;
    for (const Drift& drift : fast.drift) EXPECT_LT(drift.largest, 1e-8 * size * size) << drift.name;
    // Between the steps as well.
    for (const double part : {0.123, 0.517, 0.871}) {
      const State<double> a = fast.trajectory.state(part * end);
      const State<double> b = slow.trajectory.state(part * end);
      for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(a.q[k], b.q[k], 1e-8 * size) << i;
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a.v[k], b.v[k], 1e-8 * size * size) << i;
    }
  }
}

TEST(Rotation, further_torques_act) {
  // Gravity gradient and damping, whose torque depends on time, attitude and angular velocity.
  RotatingBody body = free_body({1.0, 1.3, 1.9});
  const SymmetricMatrix3<double> inertia = body.inertia;
  body.torque = [inertia](double t, const Quaternion<double>& attitude, const Vector3<double>& w) {
    const Matrix3<double> R = rotation_matrix(attitude);
    const Vector3<double> down{std::sin(0.3 * t), 0.0, -std::cos(0.3 * t)};
    const Vector3<double> d = transpose_times(R, down);
    return 0.4 * (R * cross(d, inertia * d)) - 0.05 * (R * w);
  };
  const Quaternion<double> attitude = quaternion_exponential(Vector3<double>{0.3, -0.2, 0.5});
  const Vector3<double> w{0.2, 3.0, 0.4};
  const IntegrationResult fast = integrate_rotation(body, 1.0, attitude, w, 15.0, with_tolerance(1e-11));
  const IntegrationResult slow =
      integrate(rotation_equations(body), 1.0, Numbers{attitude.w, attitude.x, attitude.y, attitude.z},
                Numbers{w.x, w.y, w.z}, 15.0, with_tolerance(1e-12));
  ASSERT_EQ(fast.ending, Ending::reached_end);
  EXPECT_TRUE(fast.drift.empty());
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(fast.q[k], slow.q[k], 1e-9);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(fast.v[k], slow.v[k], 1e-9);
}

TEST(Rotation, a_body_at_rest_starts_to_fall_and_one_without_torque_stays) {
  const IntegrationResult still = integrate_rotation(free_body({1.0, 2.0, 3.0}), 0.0, at_rest, {}, 5.0);
  EXPECT_EQ(still.v, (Numbers{0.0, 0.0, 0.0}));
  EXPECT_EQ(still.q, (Numbers{1.0, 0.0, 0.0, 0.0}));
  // A pendulum about x: the quarter period from pi/2 is K(1/sqrt 2) sqrt(I/(m g l)).
  RotatingBody rod = free_body({2.0, 0.01, 2.0});
  rod.first_moment = {0.0, 1.0, 0.0};
  rod.gravity = {0.0, 0.0, -8.0};
  Event lowest;
  lowest.value = [](double, std::span<const double> q, std::span<const double>) {
    const Quaternion<double> attitude{q[0], q[1], q[2], q[3]};
    return (rotation_matrix(attitude) * Vector3<double>{0.0, 1.0, 0.0}).y;
  };
  lowest.terminal = true;
  const std::vector<Event> events{lowest};
  const IntegrationResult fall = integrate_rotation(rod, 0.0, at_rest, {}, 5.0, with_tolerance(1e-12), events);
  ASSERT_EQ(fall.ending, Ending::terminal_event);
  EXPECT_NEAR(fall.time, 1.8540746773013719 * 0.5, 1e-11);
}

TEST(Rotation, events_of_a_fast_body_are_all_found) {
  // A body that spins at 40 rad/s about a fixed axis: its mark passes every half turn.
  Event mark;
  mark.value = [](double, std::span<const double> q, std::span<const double>) {
    return rotation_matrix(Quaternion<double>{q[0], q[1], q[2], q[3]}).row0.x;
  };
  const std::vector<Event> events{mark};
  const IntegrationResult r =
      integrate_rotation(free_body({1.0, 1.0, 1.7}), 0.0, at_rest, {0.0, 0.0, 40.0}, 3.0, {}, events);
  ASSERT_EQ(r.hits.size(), 38U);
  for (std::size_t k = 0; k < r.hits.size(); ++k)
    EXPECT_NEAR(r.hits[k].time, (static_cast<double>(k) + 0.5) * 3.14159265358979323846 / 40.0, 1e-13);
}

TEST(Rotation, the_estimate_bounds_the_error) {
  IntegrationOptions options = with_tolerance(1e-9);
  options.estimate_error = true;
  const IntegrationResult r = integrate_rotation(top(15.3), 0.0, at_rest, top_spin, 2.0, options);
  const double error = apart(r.q, triaxial_at_2);
  EXPECT_GT(2.0 * r.error.largest, error);
  EXPECT_LT(r.error.largest, 1e-5);
}

TEST(Rotation, inertia_that_is_none_is_refused) {
  EXPECT_THROW(rotation_equations(free_body({1.0, 0.0, 1.0})), std::invalid_argument);
  EXPECT_THROW(rotation_equations(free_body({1.0, -2.0, 1.0})), std::invalid_argument);
  EXPECT_THROW(rotation_equations(free_body({1.0, NAN, 1.0})), std::invalid_argument);
  RotatingBody body = free_body({1.0, 2.0, 2.0});
  body.first_moment.x = INFINITY;
  EXPECT_THROW(integrate_rotation(body, 0.0, at_rest, {}, 1.0), std::invalid_argument);
}

TEST(Rotation, a_torque_that_is_not_finite_ends_it) {
  RotatingBody body = free_body({1.0, 2.0, 2.5});
  body.torque = [](double t, const Quaternion<double>&, const Vector3<double>&) {
    return Vector3<double>{t > 0.5 ? std::nan("") : 0.1, 0.0, 0.0};
  };
  const IntegrationResult r = integrate_rotation(body, 0.0, at_rest, {1.0, 0.0, 0.0}, 1.0);
  EXPECT_EQ(r.ending, Ending::not_finite);
  EXPECT_NEAR(r.time, 0.5, 5e-3);  // the last stage stands before the end of a step
}

double energy(const PrincipalBody& body, const RotationState& state) {
  const Matrix3<double> R = rotation_matrix(state.attitude);
  const Vector3<double> m = transpose_times(R, state.momentum);
  return 0.5 * (m.x * m.x / body.moments.x + m.y * m.y / body.moments.y + m.z * m.z / body.moments.z) -
         dot(R * body.weight_arm, body.down);
}

RotationState top_start(const PrincipalBody& body) {
  const std::array<double, 7> y{1.0, 0.0, 0.0, 0.0, top_spin.x, top_spin.y, top_spin.z};
  return read_rotation(body, y.data());
}

TEST(RotationSplitting, has_order_eight_for_symmetric_and_other_bodies) {
  std::mt19937_64 random(9);
  for (int i = 0; i < 6; ++i) {
    const Sample s = random_sample(random, 2 * i);
    const RotatingBody given = s.body;
    const PrincipalBody body(given);
    const RotationSplitting splitting(body);
    const std::array<double, 7> y{s.attitude.w, s.attitude.x, s.attitude.y, s.attitude.z,
                                  0.3 * s.w.x,  0.3 * s.w.y,  0.3 * s.w.z};
    const RotationState start = read_rotation(body, y.data());
    const auto at = [&](int steps) {
      RotationState state = start;
      for (int k = 0; k < steps; ++k) splitting.step(state, 0.1 * k, 1.0 / steps);
      return state;
    };
    const int coarse = norm(s.w) > 10.0 ? 24 : 6;
    const RotationState exact = at(8 * coarse);
    const double a = norm(at(coarse).momentum - exact.momentum);
    const double b = norm(at(2 * coarse).momentum - exact.momentum);
    if (b < 1e-13) continue;
    EXPECT_GT(std::log2(a / b), 7.0) << i;
    EXPECT_LT(std::log2(a / b), 10.5) << i;
  }
}

TEST(RotationSplitting, goes_back_the_way_it_came) {
  const RotatingBody given = top(15.3);
  const PrincipalBody body(given);
  const RotationSplitting splitting(body);
  const RotationState start = top_start(body);
  RotationState state = start;
  for (int k = 0; k < 100; ++k) splitting.step(state, 0.0, 0.05);
  for (int k = 0; k < 100; ++k) splitting.step(state, 0.0, -0.05);
  EXPECT_LT(norm(state.momentum - start.momentum), 1e-8);
  EXPECT_LT(norm(vector_part(conjugate(start.attitude) * state.attitude)), 1e-9);
}

TEST(RotationSplitting, energy_stays_within_bounds_and_vertical_momentum_to_rounding) {
  const RotatingBody given = top(15.234375);
  const PrincipalBody body(given);
  const RotationSplitting splitting(body);
  RotationState state = top_start(body);
  const double start = energy(body, state);
  const double vertical = state.momentum.z;
  const auto largest = [&](int steps) {
    double change = 0.0;
    for (int k = 0; k < steps; ++k) {
      splitting.step(state, 0.0, 0.15);
      change = std::max(change, std::fabs(energy(body, state) - start));
    }
    return change;
  };
  const double early = largest(2'000);
  const double late = largest(20'000);
  EXPECT_GT(early, 1e-6);
  EXPECT_LT(late, 1.3 * early);
  EXPECT_NEAR(state.momentum.z, vertical, 1e-12 * norm(state.momentum));
}

TEST(Rotation, energy_drifts_by_rounding_over_long_runs) {
  IntegrationOptions options = with_tolerance(1e-15, IntegrationMethod::structure_preserving);
  options.store = false;
  options.fixed_step = 0.05;
  const double periods = 30'000.0 * 2.0 * 3.14159265358979 / 150.0;
  IntegrationResult r = integrate_rotation(top(15.234375), 0.0, at_rest, top_spin, periods, options);
  EXPECT_LT(r.drift[0].largest, 1e-12 * r.drift[0].start);
  options.fixed_step = 0.02;
  r = integrate_rotation(top(15.3), 0.0, at_rest, top_spin, periods, options);
  EXPECT_LT(r.drift[0].largest, 1e-12 * r.drift[0].start);
}

// The energy is measured by another function, and no more is turned than what had taken it off.
TEST(PrincipalBody, the_least_turn_restores_an_energy) {
  std::mt19937_64 random(29);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const Sample s = random_sample(random, i);
    const PrincipalBody body(s.body);
    const std::array<double, 7> y{s.attitude.w, s.attitude.x, s.attitude.y, s.attitude.z, s.w.x, s.w.y, s.w.z};
    const RotationState start = read_rotation(body, y.data());
    const double size = body.energy(start);
    EXPECT_NEAR(size, energy(body, start), 1e-12 * (1.0 + std::fabs(size)));
    RotationState off = start;
    const Vector3<double> turn = 1e-5 * Vector3<double>{unit(random), unit(random), unit(random)};
    off.attitude = off.attitude * quaternion_exponential(turn);
    RotationState state = off;
    body.restore_energy(state, size, 1e-3);
    const double before = std::fabs(energy(body, off) - size), after = std::fabs(energy(body, state) - size);
    EXPECT_NEAR(norm_squared(state.attitude), 1.0, 4e-16 * 4);
    EXPECT_EQ(norm(state.momentum - off.momentum), 0.0);
    const auto turned = conjugate(off.attitude) * state.attitude;
    const double angle = 2.0 * norm(Vector3<double>{turned.x, turned.y, turned.z});
    EXPECT_LE(angle, norm(turn) * 1.01) << i;
    // Newton's step: what is left is of second order in the turn.
    if (angle > 0.0) {
      EXPECT_LE(after, 1e-3 * before + 1e-9 * norm(s.w) * norm(start.momentum) + 1e-14) << i;
    }
  }
}

TEST(Rotation, energy_is_kept_at_every_tolerance) {
  std::mt19937_64 random(31);
  for (int i = 0; i < 200; ++i) {
    const Sample s = random_sample(random, i);
    for (const double tolerance : {1e-4, 1e-7}) {
      const IntegrationResult r = integrate_rotation(s.body, 0.0, s.attitude, s.w, 3.0, with_tolerance(tolerance));
      ASSERT_EQ(r.ending, Ending::reached_end) << i;
      // Quadratic in what is taken off at a time, where hardly any turn changes it.
      EXPECT_LT(r.drift[0].largest, 0.02 * tolerance * (1.0 + std::fabs(r.drift[0].start))) << i;
    }
  }
  const IntegrationResult r = integrate_rotation(top(15.3), 0.0, at_rest, top_spin, 2.0, with_tolerance(1e-4));
  EXPECT_LT(r.drift[0].largest, 1e-9 * r.drift[0].start);
  EXPECT_LT(apart(r.q, triaxial_at_2), 1e-4);
}

// Near a rotation about the middle axis next to no turn changes the energy: what rounding takes off it must not be made
// up for by one, which would be seen many times as large after the flip. What steps take off must: it is the time of
// the next flip.
TEST(Rotation, flips_come_at_their_times) {
  const RotatingBody body = free_body({1.0, 2.0, 3.0});
  const double growth = 5.0 * std::sqrt(1.0 / 3.0);
  for (const double off : {1e-3, 1e-4, 1e-5, 3e-6}) {
    const auto end_of = [&](double flips, double tolerance) {
      IntegrationOptions options = with_tolerance(tolerance);
      if (tolerance < 1e-14) options.method = IntegrationMethod::structure_preserving;
      if (tolerance < 1e-14) options.fixed_step = 0.02;
      return integrate_rotation(body, 0.0, at_rest, {5.0 * off, 5.0, 0.0}, flips * std::log(1.0 / off) / growth,
                                options)
          .q;
    };
    const auto error = [&](double flips, double tolerance) {
      const std::vector<double> exact = end_of(flips, 1e-15);
      return apart(end_of(flips, tolerance), {exact[0], exact[1], exact[2], exact[3]});
    };
    EXPECT_LT(error(1.5, 1e-12), 1e-11 + 3e-16 / off) << off;
    EXPECT_LT(error(2.5, 1e-10), 3e-7) << off;
    EXPECT_LT(error(2.5, 1e-6), 1e-5) << off;
  }
}

// No turn changes the energy of a rotation about a principal axis.
TEST(Rotation, a_permanent_rotation_lasts) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3<double> w = 7.0 * Vector3<double>::unit(i);
    const IntegrationResult r =
        integrate_rotation(free_body({1.0, 2.0, 2.5}), 0.0, at_rest, w, 2.0, with_tolerance(1e-6));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(r.v[k], w[k], 1e-13);
    const Quaternion<double> exact = quaternion_exponential(2.0 * w);
    EXPECT_LT(apart(r.q, {exact.w, exact.x, exact.y, exact.z}), 1e-12);
  }
}

TEST(RotationCollocation, has_order_sixteen) {
  const RotatingBody given = top(15.234375);
  const PrincipalBody body(given);
  const auto error = [&](int steps) {
    RotationState state = top_start(body);
    for (int k = 0; k < steps; ++k) {
      const RotationStep step = rotation_step(body, state, 0.0, 2.0 / steps, norm(state.momentum), 1e-18);
      EXPECT_TRUE(step.converged);
      state = step.end;
    }
    std::array<double, 7> y;
    write_rotation(body, state, y.data());
    return apart(std::span<const double>(y).first(4), top_at_2);
  };
  // From 9 steps to 12 a hundredth: longer steps cannot be solved, shorter ones are exact to rounding.
  const double order = std::log(error(9) / error(12)) / std::log(12.0 / 9.0);
  EXPECT_GT(order, 12.0);
  EXPECT_LT(order, 20.0);
  EXPECT_LT(error(16), 2e-13);
}

}  // namespace rotation_test
}  // namespace poinsot
