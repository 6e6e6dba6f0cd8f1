// The heavy symmetric top against Taylor series in long double, its limits with elementary forms, and its own laws.
#include "poinsot/engine/motion/closed_form/symmetric_top.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <numbers>
#include <stdexcept>

#include "engine/motion/closed_form/closed_form_support.h"
#include "engine/motion/closed_form/gyro_taylor.h"
#include "poinsot/engine/motion/closed_form/torque_free.h"

namespace poinsot {
namespace symmetric_top_test {

using Real = long double;
constexpr double pi = std::numbers::pi;

// R_z(phi) R_y(theta) R_z(psi)
template <class Number>
Quaternion<Number> attitude_of(Number phi, Number theta, Number psi) {
  const Number c = std::cos(theta / 2), s = std::sin(theta / 2);
  return {c * std::cos((phi + psi) / 2), -s * std::sin((phi - psi) / 2), s * std::cos((phi - psi) / 2),
          c * std::sin((phi + psi) / 2)};
}
Quaternion<double> attitude_of(const TopState& s) { return attitude_of(s.precession, s.nutation, s.spin); }

// Angular velocity on body axes: Eq. 18.35 turned back by the spin.
template <class Number>
Vector3<Number> body_rates(const TopState& s, Number nutation) {
  const Number x = -s.precession_rate * std::sin(nutation), y = s.nutation_rate;
  const Number c = std::cos(Number(s.spin)), d = std::sin(Number(s.spin));
  return {c * x + d * y, c * y - d * x, Number(s.axial_rate)};
}

GyroState<Real> numerical(const TopParameters& top, const TopState& start, double t) {
  const Real theta = start.nutation == pi ? std::numbers::pi_v<Real> : Real(start.nutation);
  const Quaternion<Real> q = attitude_of<Real>(start.precession, theta, start.spin);
  const Vector3<Real> w = body_rates<Real>(start, theta);
  const Real J = top.transverse_moment;
  GyroTaylor<Real> taylor({J, J, top.axial_moment}, {0, 0, top.gravity_moment}, 22, 1e-19L);
  return taylor.advance({{w.x, w.y, w.z}, {q.w, q.x, q.y, q.z}}, t);
}
Quaternion<Real> attitude_of(const GyroState<Real>& s) { return {s.q[0], s.q[1], s.q[2], s.q[3]}; }

struct Sample {
  TopParameters top;
  TopState start;
};
Sample random_sample(RandomMotion& random) {
  return {{random.uniform(0.2, 1.2), random.uniform(0.01, 1), 3 * random.normal()},
          {random.uniform(0, pi), random.normal(), random.normal(), 2 * random.normal(), random.normal(),
           4 * random.normal()}};
}

// Thousand tops, among them such without weight, starts at rest, on the vertical, from cusps, with tiny rates.
std::vector<Sample> samples() {
  RandomMotion random(1);
  std::vector<Sample> list;
  for (int i = 0; i < 1000 / std::min(closed_form_thinning, 4); ++i) {
    Sample s = random_sample(random);
    TopState& start = s.start;
    if (i % 10 == 0) s.top.gravity_moment = 0;
    if (i % 9 == 1) start.nutation_rate = start.precession_rate = 0;
    if (i % 9 == 2) start.nutation = 0;
    if (i % 9 == 3) start.nutation = pi;
    if (i % 9 == 4) start.nutation_rate = 0;
    if (i % 27 == 5) {
      start.nutation = 0;
      start.nutation_rate = 1e-6;
    }
    if (i % 27 == 14) start.axial_rate = start.precession_rate = 0;
    if (i % 27 == 23) {
      start.nutation_rate *= 1e-5;
      start.precession_rate *= 1e-5;
    }
    list.push_back(s);
  }
  return list;
}

TEST(SymmetricTop, of_a_thousand_samples_agrees_with_taylor_series) {
  RandomMotion random(2);
  double worst = 0, worst_rate = 0, worst_angles = 0;
  for (const Sample& s : samples()) {
    const SymmetricTop motion(s.top, s.start);
    // Past an unstable upright position the series in long double lose what the closed form keeps.
    double t = random.uniform(-6, 14);
    if (s.start.nutation_rate == 1e-6) t = std::copysign(std::min(std::fabs(t), 0.7 * motion.nutation_period()), t);
    const GyroState<Real> exact = numerical(s.top, s.start, t);
    const Quaternion<double> q = motion.attitude(t);
    const Vector3<double> w = motion.angular_velocity(t);
    raise(worst, static_cast<double>(attitude_distance(q, attitude_of(exact))));
    raise(worst, attitude_distance(motion.attitude(0), attitude_of(s.start)));
    const Vector3<Real> difference{w.x - exact.w[0], w.y - exact.w[1], w.z - exact.w[2]};
    raise(worst_rate, static_cast<double>(norm(difference)) / (1 + norm(w)));
    // Eulerian angles are the same attitude; their rounding grows with their turns.
    const TopState state = motion.at(t);
    raise(worst_angles,
          attitude_distance(q, attitude_of(state)) / (4 + std::fabs(state.spin) + std::fabs(state.precession)));
    const Vector3<double> rates = body_rates<double>(state, state.nutation);
    raise(worst_rate, norm(rates - w) / ((1 + norm(w)) * (4 + std::fabs(state.spin))));
  }
  EXPECT_LT(worst, 2e-15);
  EXPECT_GT(worst, 1e-17);
  EXPECT_LT(worst_rate, 4e-15);
  EXPECT_LT(worst_angles, 1e-15);
}

// Starts from near the unstable upright position, over some returns to it: rounding grows by a million million on the
// way, and series need fifty digits to follow.
TEST(SymmetricTop, returning_to_the_unstable_vertical_agrees_with_fifty_digits) {
  using Digits50 = boost::multiprecision::cpp_bin_float_50;
  for (const double axial_rate : {-0.25, 1.5}) {
    const TopParameters top{0.25, 0.5, 3};
    const TopState start{0, 0x1p-20, 0, 0, 0, axial_rate};
    const SymmetricTop motion(top, start);
    const double t = 2.3 * motion.nutation_period();
    GyroTaylor<Digits50> taylor({0.25, 0.25, 0.5}, {0, 0, 3}, 40, Digits50("1e-36"));
    const auto end = taylor.advance({{0, Digits50(0x1p-20), Digits50(axial_rate)}, {1, 0, 0, 0}}, Digits50(t));
    EXPECT_LT(attitude_distance(motion.attitude(t), Quaternion<Digits50>{end.q[0], end.q[1], end.q[2], end.q[3]}),
              Digits50("1e-13"));
  }
}

// The heavy top of Bruels and Cardona, references to 25 digits computed once by Taylor series. Its axis is y of the
// body; x, y, z of the top are z, x, y there.
TEST(SymmetricTop, meets_the_reference_at_2_and_10_s) {
  const double m = 15, g = 9.81, J = 0.234375 + m, I = 0.46875;
  const SymmetricTop motion({J, I, m * g}, {pi / 2, 0, pi / 2, -4.61538, pi, 150});
  const Quaternion<double> rename = quaternion_of(Matrix3<double>{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  const auto on_body = [&](double t) { return motion.attitude(t) * rename; };
  ASSERT_LT(attitude_distance(on_body(0), Quaternion<double>::identity()), 1e-15);
  const Quaternion<double> at2{0.122947135041533467104252, -0.491079892550027014699045, 0.350430030343620961839020,
                               -0.787986887550485669324174};
  const Quaternion<double> at10{0.716619525740420071959180, -0.623436191172728756583058, -0.0566395013845272216640416,
                                0.307531685760229194087554};
  // pi/2 and pi are rounded, and 150 rad/s turn by 1500 rad.
  EXPECT_LT(attitude_distance(on_body(2), at2), 4e-15);
  EXPECT_LT(attitude_distance(on_body(10), at10), 4e-15);
  const Vector3<double> w2 = motion.angular_velocity(2), w10 = motion.angular_velocity(10);
  EXPECT_NEAR(w2.y, 0.122233219497394236787282, 1e-13);
  EXPECT_EQ(w2.z, 150);
  EXPECT_NEAR(w2.x, -5.85562458920545772829141, 1e-13);
  EXPECT_NEAR(w10.y, -2.88406985627560430310689, 1e-13);
  EXPECT_NEAR(w10.x, -5.56041973858561716307866, 1e-13);
}

TEST(SymmetricTop, conserves_energy_and_momenta) {
  RandomMotion random(3);
  for (int i = 0; i < 500; ++i) {
    const auto [top, start] = random_sample(random);
    const SymmetricTop motion(top, start);
    const TopState s = motion.at(random.uniform(-1000, 1000));
    const double sine = std::sin(s.nutation), x = std::cos(s.nutation), p = s.precession_rate * sine;
    const double J = top.transverse_moment, I = top.axial_moment;
    const double kinetic = 0.5 * (J * (s.nutation_rate * s.nutation_rate + p * p) + I * s.axial_rate * s.axial_rate);
    const double size = kinetic + std::fabs(top.gravity_moment) + J * (1 + std::fabs(s.precession_rate));
    EXPECT_NEAR(kinetic + top.gravity_moment * x, motion.energy(), 1e-13 * size * (1 + std::fabs(p)));
    EXPECT_NEAR(J * p * sine + I * s.axial_rate * x, motion.vertical_momentum(), 1e-13 * size);
    EXPECT_EQ(motion.axial_momentum(), I * s.axial_rate);
  }
}

TEST(SymmetricTop, period_and_angles_per_period_are_those_of_the_motion) {
  for (const Sample& s : samples()) {
    const SymmetricTop motion(s.top, s.start);
    const double T = motion.nutation_period(), t = 0.3;
    if (!std::isfinite(T) || motion.curve() == TopCurve::steady || motion.curve() == TopCurve::planar) continue;
    const bool through_vertical = motion.nutation_range().minimum == 0 || motion.nutation_range().maximum == pi;
    const TopState now = motion.at(t), later = motion.at(t + T);
    const double scale = 1e-13 * (1 + T) * (1 + norm(motion.angular_velocity(t)));
    EXPECT_NEAR(later.nutation, now.nutation, 10 * scale);
    EXPECT_NEAR(later.nutation_rate, now.nutation_rate, 100 * scale);
    if (through_vertical) continue;  // phi jumps by pi there
    EXPECT_NEAR(later.precession - now.precession, motion.precession_per_period(), 100 * scale);
    EXPECT_NEAR(later.spin - now.spin, motion.spin_per_period(), 100 * scale);
  }
}

// Unwrapped angles are the integrals of their rates (Gauss-Legendre over small steps).
TEST(SymmetricTop, angles_are_integrals_of_their_rates) {
  RandomMotion random(4);
  for (int i = 0; i < 100; ++i) {
    const auto [top, start] = random_sample(random);
    const SymmetricTop motion(top, start);
    const Range range = motion.nutation_range();
    if (range.minimum < 0.05 || range.maximum > pi - 0.05) continue;  // fast turns near the vertical
    const double end = 5;
    const int steps = 4000;
    double phi = 0, theta = 0;
    for (int k = 0; k < steps; ++k) {
      const double h = end / steps, middle = (k + 0.5) * h, d = h * 0.5 * std::sqrt(0.6);
      const TopState a = motion.at(middle - d), b = motion.at(middle), c = motion.at(middle + d);
      phi += h / 18 * (5 * a.precession_rate + 8 * b.precession_rate + 5 * c.precession_rate);
      theta += h / 18 * (5 * a.nutation_rate + 8 * b.nutation_rate + 5 * c.nutation_rate);
    }
    EXPECT_NEAR(motion.at(end).precession - start.precession, phi, 1e-9 * (1 + std::fabs(phi)));
    EXPECT_NEAR(motion.at(end).nutation - start.nutation, theta, 1e-9);
  }
}

TEST(SymmetricTop, nutates_within_its_range_and_reaches_both_ends) {
  for (const Sample& s : samples()) {
    const SymmetricTop motion(s.top, s.start);
    const Range range = motion.nutation_range();
    const double T = motion.nutation_period();
    for (int k = 0; k < 20; ++k) {
      const double theta = motion.at(0.37 * k).nutation;
      EXPECT_GE(theta, range.minimum - 1e-14);
      EXPECT_LE(theta, range.maximum + 1e-14);
    }
    if (!std::isfinite(T) || motion.curve() == TopCurve::steady) continue;
    for (const double end : {range.minimum, range.maximum}) {
      const auto times = motion.times_at_nutation(end, 0, 1.5 * T);
      ASSERT_GE(times.size(), 1U);
      EXPECT_LE(times.size(), 2U);
      for (const double t : times) {
        EXPECT_NEAR(motion.at(t).nutation, end, 1e-12 * (1 + norm(motion.angular_velocity(t))));
        if (end > 1e-6 && end < pi - 1e-6) {
          EXPECT_NEAR(motion.at(t).nutation_rate, 0, 1e-5);  // theta itself is rounded
        }
      }
    }
  }
}

TEST(SymmetricTop, finds_all_times_at_an_angle) {
  RandomMotion random(5);
  for (int i = 0; i < 300; ++i) {
    const auto [top, start] = random_sample(random);
    const SymmetricTop motion(top, start);
    const Range range = motion.nutation_range();
    const double theta = random.uniform(range.minimum, range.maximum);
    const double T = motion.nutation_period(), from = random.uniform(-3 * T, 0), to = from + 5 * T;
    const auto times = motion.times_at_nutation(theta, from, to);
    // Twice in every period.
    EXPECT_EQ(times.size(), 10U);
    for (std::size_t k = 0; k < times.size(); ++k) {
      EXPECT_NEAR(motion.at(times[k]).nutation, theta, 1e-12 * (1 + 3 * T) * (1 + norm(motion.angular_velocity(0))));
      if (k > 0) {
        EXPECT_LT(times[k - 1], times[k]);
      }
    }
    EXPECT_TRUE(motion.times_at_nutation(range.minimum * 0.99 - 1e-3, from, to).empty());
    EXPECT_TRUE(motion.times_at_nutation(range.maximum + 1e-3 * (pi - range.maximum) + 1e-3, from, to).empty());
    EXPECT_TRUE(motion.times_at_nutation(theta, 1, 0).empty());
  }
}

TEST(SymmetricTop, without_weight_is_free_precession) {
  RandomMotion random(6);
  for (int i = 0; i < 300; ++i) {
    Sample s = random_sample(random);
    s.top.gravity_moment = 0;
    const SymmetricTop motion(s.top, s.start);
    const double J = s.top.transverse_moment;
    const TorqueFreeMotion free({J, J, s.top.axial_moment}, attitude_of(s.start), motion.angular_velocity(0));
    const double t = random.uniform(-50, 50);
    EXPECT_LT(attitude_distance(motion.attitude(t), free.attitude(t)),
              1e-15 * (10 + std::fabs(t) * (5 + norm(motion.angular_velocity(0)) * J / s.top.axial_moment)));
  }
}

// A top turned over has the weight's moment reversed.
TEST(SymmetricTop, hanging_is_standing_turned_over) {
  RandomMotion random(7);
  for (int i = 0; i < 300; ++i) {
    const auto [top, start] = random_sample(random);
    const SymmetricTop motion(top, start);
    const TopParameters over{top.transverse_moment, top.axial_moment, -top.gravity_moment};
    const SymmetricTop turned(over, {pi - start.nutation, -start.nutation_rate, start.precession + pi,
                                     start.precession_rate, -start.spin - pi, -start.axial_rate});
    const double t = random.uniform(-5, 5);
    EXPECT_LT(attitude_distance(turned.attitude(t) * Quaternion<double>{0, 0, 1, 0}, motion.attitude(t)), 1e-11);
    EXPECT_NEAR(turned.nutation_range().minimum, pi - motion.nutation_range().maximum, 1e-14);
  }
}

// The pendulum published as a multibody benchmark: 1 m, released from the horizontal.
TEST(SymmetricTop, without_spin_is_the_planar_pendulum) {
  const double g = 9.81;
  const SymmetricTop motion({1, 0, g}, {pi / 2, 0, pi, 0, 0, 0});
  EXPECT_EQ(motion.curve(), TopCurve::planar);
  // theta comes back to pi/2 on the other side after half a swing.
  EXPECT_NEAR(2 * motion.nutation_period(), 2.36784194757623745, 1e-15);
  const Matrix3<double> R = rotation_matrix(motion.attitude(10));
  EXPECT_NEAR(R.column(2).x, -0.27508746257611686, 1e-14);
  EXPECT_NEAR(R.column(2).z, -0.961419205099125064, 1e-14);
  EXPECT_NEAR(R.column(2).y, 0, 1e-15);
  // Rates are finite and of the right size at the lowest point, where theta turns back at pi.
  const double quarter = motion.nutation_period() / 2;
  EXPECT_NEAR(norm(motion.angular_velocity(quarter)), std::sqrt(2 * g), 1e-14);
  EXPECT_NEAR(motion.nutation_range().maximum, pi, 0);
}

TEST(SymmetricTop, without_spin_is_the_spherical_pendulum) {
  RandomMotion random(8);
  for (int i = 0; i < 100; ++i) {
    auto [top, start] = random_sample(random);
    start.axial_rate = 0;
    const GyroState<Real> exact = numerical(top, start, 4);
    top.axial_moment = 0;  // without spin it does not matter
    EXPECT_LT(attitude_distance(SymmetricTop(top, start).attitude(4), attitude_of(exact)), 2e-15);
  }
}

// From hanging at rest with just the speed that brings the pendulum up: theta = pi - 2 gd(t).
TEST(SymmetricTop, asymptotic_pendulum_is_elementary) {
  const SymmetricTop motion({1, 0, 1}, {pi, -2, 0, 0, 0, 0});
  EXPECT_TRUE(motion.asymptotic());
  EXPECT_EQ(motion.nutation_period(), std::numeric_limits<double>::infinity());
  for (const double t : {-3.0, -0.2, 0.1, 1.0, 5.0, 20.0}) {
    const TopState s = motion.at(t);
    EXPECT_NEAR(s.nutation, 2 * std::atan2(1, std::sinh(std::fabs(t))), 1e-15);
    EXPECT_NEAR(std::fabs(s.nutation_rate), 2 / std::cosh(t), 1e-15);
  }
  EXPECT_LT(motion.at(500).nutation, 1e-100);
  const auto times = motion.times_at_nutation(pi / 2, -10, 10);
  ASSERT_EQ(times.size(), 2U);
  EXPECT_NEAR(times[1], std::asinh(1.0), 1e-15);
  EXPECT_EQ(times[0], -times[1]);
}

// A slow top that just reaches the upright position stays near it for long.
TEST(SymmetricTop, near_asymptotic_motion_is_exact) {
  RandomMotion random(9);
  for (int i = 0; i < 100; ++i) {
    const double J = random.uniform(0.5, 1), I = random.uniform(0.1, 0.5), weight = random.uniform(0.5, 2);
    const double kappa = 2 * weight / J, b = random.uniform(-0.7, 0.7) * std::sqrt(2 * kappa), w_z = b * J / I;
    // d = 0 and epsilon = kappa at a random angle, then a little off.
    const double theta = random.uniform(0.2, 1), h = 1 - std::cos(theta), k = 1 + std::cos(theta);
    const double rate_square = kappa * h - b * b * h / k;
    if (rate_square < 0) continue;
    const double off = i % 4 == 0 ? 0 : std::pow(10, -random.uniform(2, 15));
    const TopParameters top{J, I, weight};
    const TopState start{theta, -std::sqrt(rate_square) * (1 + off), 0, b / k, 0, w_z};
    const SymmetricTop motion(top, start);
    for (const double t : {-3.0, 2.0, 4.0}) {
      EXPECT_LT(static_cast<double>(attitude_distance(motion.attitude(t), attitude_of(numerical(top, start, t)))),
                4e-15);
    }
  }
}

TEST(SymmetricTop, steady_positions_are_steady) {
  // Sleeping, hanging, at rest without weight.
  const SymmetricTop sleeping({1, 0.5, 1}, {0, 0, 0.4, 0, 0.3, 7});
  EXPECT_EQ(sleeping.curve(), TopCurve::steady);
  EXPECT_LT(attitude_distance(sleeping.attitude(3), attitude_of(0.0, 0.0, 0.7 + 21.0)), 2e-15);
  EXPECT_EQ(norm(sleeping.angular_velocity(3) - Vector3<double>{0, 0, 7}), 0);
  // Vanishing nutations: b^2 - 2 kappa.
  EXPECT_NEAR(sleeping.nutation_period(), 2 * pi / std::sqrt(3.5 * 3.5 - 4), 1e-15);
  EXPECT_EQ(SymmetricTop({1, 0.5, 1}, {0, 0, 0, 0, 0, 3}).nutation_period(), std::numeric_limits<double>::infinity());
  const SymmetricTop hanging({1, 0.5, 1}, {pi, 0, 0, 0, 0, 2});
  EXPECT_EQ(hanging.curve(), TopCurve::steady);
  EXPECT_NEAR(hanging.nutation_period(), 2 * pi / std::sqrt(1 + 4), 1e-15);
  // Exactly balanced: (I w_z - I' p cos(theta)) p = m g c at theta = pi/2 needs p = 0.5 for I w_z = 6, m g c = 3.
  const SymmetricTop level({2, 1, 3}, {pi / 2, 0, 0.1, 0.5, 0.2, 6});
  EXPECT_EQ(level.curve(), TopCurve::steady);
  EXPECT_NEAR(level.mean_precession_rate(), 0.5, 1e-15);
  EXPECT_NEAR(level.mean_spin_rate(), 6, 1e-15);
  const TopState later = level.at(4);
  EXPECT_NEAR(later.nutation, pi / 2, 1e-15);
  EXPECT_NEAR(later.precession, 0.1 + 2, 1e-14);
  EXPECT_NEAR(later.spin, 0.2 + 24, 1e-13);
}

TEST(SymmetricTop, curves_of_the_axis_have_their_kinds) {
  // Released from rest with spin: cusps. Pushed forward: waves. Pushed back: loops.
  const TopParameters top{1, 0.5, 2};
  EXPECT_EQ(SymmetricTop(top, {0.7, 0, 0, 0, 0, 12}).curve(), TopCurve::cusped);
  EXPECT_EQ(SymmetricTop(top, {0.7, 0, 0, 0.1, 0, 12}).curve(), TopCurve::waved);
  EXPECT_EQ(SymmetricTop(top, {0.7, 0, 0, -0.1, 0, 12}).curve(), TopCurve::looped);
  EXPECT_EQ(SymmetricTop(top, {0.7, 0.3, 0, 0, 0, 0}).curve(), TopCurve::planar);
  // The same seen from later on the way.
  for (const double push : {0.0, 0.1, -0.1}) {
    const SymmetricTop motion(top, {0.7, 0, 0, push, 0, 12});
    EXPECT_EQ(SymmetricTop(top, motion.at(0.9)).curve(), motion.curve());
    const double sign = motion.at(0).precession_rate * motion.at(motion.nutation_period() / 2).precession_rate;
    EXPECT_EQ(motion.curve(), sign > 0 ? TopCurve::waved : sign < 0 ? TopCurve::looped : TopCurve::cusped);
  }
}

// Small nutations of a fast top: amplitude, frequency and mean precession of the textbook approximation, whose relative
// error is of the order of kappa/b^2.
TEST(SymmetricTop, small_nutations_keep_their_digits) {
  const TopParameters top{1, 0.5, 2};
  for (const double w_z : {2e4, 2e6, 2e8}) {
    const SymmetricTop motion(top, {1, 0, 0, 0, 0, w_z});
    const double b = w_z / 2, kappa = 4;
    EXPECT_NEAR(motion.nutation_range().maximum - 1, kappa * std::sin(1) / (b * b),
                4 * kappa / (b * b) * kappa / b + 3e-16);
    EXPECT_NEAR(motion.nutation_period() * b / (2 * pi), 1, 4 * kappa / (b * b) + 1e-15);
    EXPECT_NEAR(motion.mean_precession_rate() * b, 2, 8 * kappa / (b * b) + 1e-14);  // m g c/(I w_z)
    const double t = 40.123;
    EXPECT_NEAR(motion.at(t).precession, motion.mean_precession_rate() * t, 2 * kappa / (b * b) + 1e-14);
  }
}

TEST(SymmetricTop, is_continuous_through_the_vertical) {
  // A top that misses the vertical by 1e-3 to 1e-12 does what one through it does.
  const TopParameters top{1, 0.5, 2};
  const SymmetricTop through(top, {0, 3, 0, 0, 0, 2});
  for (const double miss : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const SymmetricTop past(top, {miss, 3, 0, 0, 0, 2});
    for (const double t : {-2.0, 0.5, 3.0, 7.0}) {
      EXPECT_LT(attitude_distance(past.attitude(t), through.attitude(t)), 50 * miss + 1e-14);
      EXPECT_LT(norm(past.angular_velocity(t) - through.angular_velocity(t)), 200 * miss + 1e-14);
    }
  }
}

TEST(SymmetricTop, refuses_what_is_no_top) {
  const auto message = [](const TopParameters& top, const TopState& start) -> std::string {
    try {
      const SymmetricTop motion(top, start);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  const TopState start{1, 0, 0, 0, 0, 1};
  EXPECT_EQ(message({0, 1, 1}, start),
            "SymmetricTop: the transverse moment of inertia is 0; it must be positive and finite");
  EXPECT_EQ(message({1, -1, 1}, start),
            "SymmetricTop: the axial moment of inertia is -1; it must be finite and not negative");
  EXPECT_EQ(message({1, 1, INFINITY}, start),
            "SymmetricTop: the moment of the weight, m g c, is inf; it must be finite");
  EXPECT_EQ(message({1, 1, 1}, {3.5}), "SymmetricTop: the angle of nutation is 3.5; it must lie between 0 and pi");
  EXPECT_EQ(message({1, 1, 1}, {1, NAN}), "SymmetricTop: the rate of nutation is nan; it must be finite");
  const SymmetricTop motion({1, 1, 1}, {1, 1, 0, 0, 0, 1});
  EXPECT_THROW(motion.times_at_nutation(1, 0, 1e12), std::invalid_argument);
}

}  // namespace symmetric_top_test
}  // namespace poinsot
