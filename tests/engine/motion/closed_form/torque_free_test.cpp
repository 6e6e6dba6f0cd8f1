// Motion free of moments against fifty-digit arithmetic, Taylor series, elementary closed forms and its own laws.
#include "poinsot/engine/motion/closed_form/torque_free.h"

#include <gtest/gtest.h>

#include "engine/motion/closed_form/closed_form_support.h"
#include "engine/motion/closed_form/gyro_taylor.h"
#include "engine/motion/closed_form/torque_free_oracle.h"
#include "poinsot/engine/math/algebra/rotation.h"
#include "poinsot/engine/motion/closed_form/free_precession.h"

namespace poinsot {
namespace torque_free_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

template <class To, class From>
Vector3<To> converted(const Vector3<From>& v) {
  return {To(v.x), To(v.y), To(v.z)};
}
template <class To, class From>
Quaternion<To> converted(const Quaternion<From>& q) {
  return {To(q.w), To(q.x), To(q.y), To(q.z)};
}

// A body, its motion, and a time.
struct Sample {
  Vector3<double> moments;
  Quaternion<double> attitude;
  Vector3<double> w;
  double t;
};

double phase(const Sample& s) { return norm(s.w) * std::fabs(s.t); }

struct Misfit {
  double attitude, angular_velocity;  // the latter relative
  double largest() const { return angular_velocity <= attitude ? attitude : angular_velocity; }
};
Misfit misfit(const TorqueFreeMotion::State& state, const OracleState& exact) {
  const Vector3<Digits50> difference = converted<Digits50>(state.angular_velocity) - exact.angular_velocity;
  return {static_cast<double>(attitude_distance(state.attitude, exact.attitude)),
          static_cast<double>(norm(difference) / norm(exact.angular_velocity))};
}
OracleState exact_state(const Sample& s) {
  return torque_free_oracle(converted<Digits50>(s.moments), converted<Digits50>(s.attitude), converted<Digits50>(s.w),
                            Digits50(s.t));
}
TorqueFreeMotion motion_of(const Sample& s) { return {s.moments, s.attitude, s.w}; }

// How much the result moves when moments, angular velocity and time move by half a unit in the last place each: what no
// program working on doubles can be held to.
double conditioning(const Sample& s, const OracleState& exact) {
  const Digits50 relative("1e-22");
  double sum = 0;
  for (std::size_t i = 0; i < 7; ++i) {
    Vector3<Digits50> I = converted<Digits50>(s.moments), w = converted<Digits50>(s.w);
    Digits50 t = s.t;
    (i < 3 ? I[i] : i < 6 ? w[i - 3] : t) *= 1 + relative;
    const OracleState moved = torque_free_oracle(I, converted<Digits50>(s.attitude), w, t);
    const Digits50 change =
        attitude_distance(moved.attitude, exact.attitude) +
        norm(Vector3<Digits50>(moved.angular_velocity - exact.angular_velocity)) / norm(exact.angular_velocity);
    sum += static_cast<double>(change / relative) * epsilon / 2;
  }
  return sum;
}

TEST(TorqueFreeOracle, agrees_with_taylor_series_in_fifty_digits) {
  RandomMotion random(1);
  for (int i = 0; i < 6; ++i) {
    const Sample s{random.moments(), random.attitude(), random.vector(), random.uniform(-4, 4)};
    const Vector3<Digits50> I = converted<Digits50>(s.moments), w = converted<Digits50>(s.w);
    const Quaternion<Digits50> q = normalized(converted<Digits50>(s.attitude));
    GyroTaylor<Digits50> taylor({I.x, I.y, I.z}, {0, 0, 0}, 45, Digits50("1e-38"));
    const auto end = taylor.advance({{w.x, w.y, w.z}, {q.w, q.x, q.y, q.z}}, Digits50(s.t));
    const OracleState exact = exact_state(s);
    EXPECT_LT(attitude_distance(exact.attitude, Quaternion<Digits50>{end.q[0], end.q[1], end.q[2], end.q[3]}),
              Digits50("1e-34"));
    EXPECT_LT(norm(Vector3<Digits50>(exact.angular_velocity - Vector3<Digits50>{end.w[0], end.w[1], end.w[2]})),
              Digits50("1e-34"));
  }
}

TEST(TorqueFreeMotion, of_ten_thousand_bodies_is_exact_to_a_few_last_places_up_to_100_rad) {
  RandomMotion random(2);
  double worst = 0, sum = 0;
  constexpr int count = 10000 / closed_form_thinning;
  for (int i = 0; i < count; ++i) {
    Sample s{random.moments(), random.attitude(), random.vector(), 0};
    s.t = random.uniform(-100, 100) / norm(s.w);
    const double found = misfit(motion_of(s).at(s.t), exact_state(s)).largest();
    raise(worst, found);
    sum += found;
  }
  // 1e-13 is asked for; bodies so near the separatrix that the data's rounding counts are among them.
  EXPECT_LT(worst, 2e-15);
  EXPECT_LT(sum / count, 3e-16);
  EXPECT_GT(sum / count, 2e-17);
}

// Bodies whose spin is close to the separatrix by 1e-1 to 1e-16.
TEST(TorqueFreeMotion, near_the_separatrix_is_as_exact_as_the_data) {
  RandomMotion random(3);
  double worst = 0, smallest = 1;
  for (int i = 0; i < 320 / closed_form_thinning; ++i) {
    Sample s{random.moments(), random.attitude(), random.vector(), 0};
    std::array<double, 3> I{s.moments.x, s.moments.y, s.moments.z};
    std::sort(I.begin(), I.end());
    s.moments = {I[0], I[1], I[2]};
    // I1 (I2 - I1) w1^2 = I3 (I3 - I2) w3^2
    s.w.x = s.w.z * std::sqrt(I[2] * (I[2] - I[1]) / (I[0] * (I[1] - I[0])));
    s.w.x *= 1 + std::pow(10, -random.uniform(1, 16)) * (i % 2 == 0 ? 1 : -1);
    s.t = random.uniform(-100, 100) / norm(s.w);
    const TorqueFreeMotion motion = motion_of(s);
    const long double complement = motion.polhode().solution().parameter.complement;
    if (complement == 0) continue;
    smallest = std::min(smallest, static_cast<double>(complement));
    const OracleState exact = exact_state(s);
    raise(worst, misfit(motion.at(s.t), exact).largest() / (epsilon + conditioning(s, exact)));
  }
  EXPECT_LT(smallest, closed_form_thinning == 1 ? 1e-14 : 1e-6);
  EXPECT_LT(worst, 4);
}

// Moments that differ by 1e-3 to 1e-15, and spins that are as close to a principal axis.
TEST(TorqueFreeMotion, near_axisymmetry_and_principal_axes_is_as_exact_as_the_data) {
  RandomMotion random(4);
  double worst = 0;
  for (int i = 0; i < 320 / closed_form_thinning; ++i) {
    Sample s{random.moments(), random.attitude(), random.vector(), 0};
    const double close = std::pow(10, -random.uniform(3, 15));
    const std::size_t axis = static_cast<std::size_t>(i % 3);
    if (i % 2 == 0) {
      s.moments[axis] = s.moments[(axis + 1) % 3] * (1 + close);
      if (s.moments[axis] == s.moments[(axis + 1) % 3]) continue;
    }
    if (i % 4 != 0) {
      s.w[(axis + 1) % 3] *= close;
      if (i % 8 < 4) s.w[(axis + 2) % 3] *= close;
    }
    s.t = random.uniform(-100, 100) / norm(s.w);
    const OracleState exact = exact_state(s);
    raise(worst, misfit(motion_of(s).at(s.t), exact).largest() / (epsilon + conditioning(s, exact)));
  }
  EXPECT_LT(worst, 4);
}

TEST(TorqueFreeMotion, of_slender_and_flat_bodies_is_exact) {
  RandomMotion random(5);
  for (int i = 0; i < 60 / std::min(closed_form_thinning, 6); ++i) {
    const double thin = std::pow(10, -random.uniform(2, 6));
    const Vector3<double> rod{thin, 1, 1 + 0.5 * thin}, plate{0.4, 0.6, 1 - thin};
    Sample s{i % 2 == 0 ? rod : plate, random.attitude(), random.vector(), 0};
    s.t = random.uniform(-100, 100) / norm(s.w);
    const OracleState exact = exact_state(s);
    EXPECT_LT(misfit(motion_of(s).at(s.t), exact).largest(), 4 * (epsilon + conditioning(s, exact)));
  }
}

TEST(TorqueFreeMotion, keeps_its_phase_for_a_million_radians) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "long double has no more digits than double";
  RandomMotion random(6);
  for (int i = 0; i < 40 / std::min(closed_form_thinning, 4); ++i) {
    Sample s{random.moments(), random.attitude(), random.vector(), 0};
    s.t = random.uniform(-1e6, 1e6) / norm(s.w);
    // The rates are right to some units of a long double.
    EXPECT_LT(misfit(motion_of(s).at(s.t), exact_state(s)).attitude, 2e-15 + 1e-18 * phase(s));
  }
}

// Reference values to 25 digits, computed once by Taylor series.
TEST(TorqueFreeMotion, meets_the_reference_at_100_s) {
  const TorqueFreeMotion motion({1, 2, 3}, Quaternion<double>::identity(), {0.1, 5, 0.1});
  const auto [q, w] = motion.at(100);
  const Quaternion<double> expected{-0.0169736334790839982435844, 0.763707356474878484809854,
                                    0.00348801869715182540305308, 0.645329995551298481317482};
  // The data 0.1 is rounded: the phase of some 500 rad near the separatrix moves by 1e-15.
  EXPECT_LT(attitude_distance(q, expected), 4e-15);
  EXPECT_NEAR(w.x, 0.146653502117685105038131, 2e-14);
  EXPECT_NEAR(w.y, -4.99884914258438270490925, 2e-14);
  EXPECT_NEAR(w.z, 0.117625464481380999969001, 2e-14);
}

TEST(TorqueFreeMotion, starts_as_given) {
  RandomMotion random(7);
  for (int i = 0; i < 1000; ++i) {
    const Sample s{random.moments(), random.attitude(), random.vector(), 0};
    const auto state = motion_of(s).at(0);
    EXPECT_LT(attitude_distance(state.attitude, normalized(s.attitude)), 1e-15);
    EXPECT_LT(norm(state.angular_velocity - s.w), 2e-15 * norm(s.w));
  }
}

TEST(TorqueFreeMotion, conserves_momentum_in_space_and_energy) {
  RandomMotion random(8);
  for (int i = 0; i < 1000; ++i) {
    const Sample s{random.moments(), random.attitude(), random.vector(), random.uniform(-1e5, 1e5)};
    const TorqueFreeMotion motion = motion_of(s);
    const auto [q, w] = motion.at(s.t);
    const Vector3<double> H{s.moments.x * w.x, s.moments.y * w.y, s.moments.z * w.z};
    const Vector3<double> in_space = rotation_matrix(q) * H;
    EXPECT_LT(norm(in_space - motion.angular_momentum()), 4e-15 * norm(H));
    EXPECT_NEAR(0.5 * dot(w, H), motion.kinetic_energy(), 4e-15 * motion.kinetic_energy());
  }
}

// The attitude's rate is the angular velocity, by central differences.
TEST(TorqueFreeMotion, turns_at_its_angular_velocity) {
  RandomMotion random(9);
  for (int i = 0; i < 500; ++i) {
    const Sample s{random.moments(), random.attitude(), random.vector(), random.uniform(-10, 10)};
    const TorqueFreeMotion motion = motion_of(s);
    const double h = 1e-5;
    const Quaternion<double> turn = conjugate(motion.attitude(s.t - h)) * motion.attitude(s.t + h);
    const double sign = turn.w < 0 ? -1 : 1;
    const Vector3<double> w = motion.angular_velocity(s.t);
    EXPECT_LT(norm((sign / h) * vector_part(turn) - w), 1e-8 * (1 + std::pow(norm(w), 3)));
  }
}

TEST(TorqueFreeMotion, can_be_taken_up_at_any_time) {
  RandomMotion random(10);
  for (int i = 0; i < 500; ++i) {
    const Sample s{random.moments(), random.attitude(), random.vector(), random.uniform(-5, 5)};
    const TorqueFreeMotion motion = motion_of(s);
    const double later = random.uniform(-5, 5);
    const auto middle = motion.at(s.t);
    const TorqueFreeMotion taken_up(s.moments, middle.attitude, middle.angular_velocity);
    const double complement = static_cast<double>(motion.polhode().solution().parameter.complement);
    EXPECT_LT(attitude_distance(taken_up.attitude(later), motion.attitude(s.t + later)), 1e-13 / std::sqrt(complement));
  }
}

TEST(TorqueFreeMotion, after_a_period_is_turned_about_the_momentum_by_the_precession) {
  RandomMotion random(11);
  for (int i = 0; i < 500; ++i) {
    const Sample s{random.moments(), random.attitude(), random.vector(), random.uniform(-5, 5)};
    const TorqueFreeMotion motion = motion_of(s);
    const double T = motion.period();
    const Vector3<double> direction = normalized(motion.angular_momentum());
    const Quaternion<double> turn = quaternion_exponential(motion.precession_per_period() * direction);
    const double scale = 1e-15 * (10 + norm(s.w) * (T + std::fabs(s.t)));
    const double near = std::sqrt(static_cast<double>(motion.polhode().solution().parameter.complement));
    EXPECT_LT(attitude_distance(turn * motion.attitude(s.t), motion.attitude(s.t + T)), 4 * scale / near);
    EXPECT_LT(norm(motion.angular_velocity(s.t + T) - motion.angular_velocity(s.t)), 4 * scale * norm(s.w) / near);
    EXPECT_NEAR(motion.mean_precession_rate() * T, motion.precession_per_period(),
                1e-14 * motion.precession_per_period());
    // The encircled axis precesses between the rates of rotation about the extreme axes.
    const double H = norm(motion.angular_momentum());
    const double most = std::max({s.moments.x, s.moments.y, s.moments.z});
    const double least = std::min({s.moments.x, s.moments.y, s.moments.z});
    EXPECT_GT(motion.mean_precession_rate(), H / most * (1 - 1e-12));
    EXPECT_LT(motion.mean_precession_rate(), H / least * (1 + 1e-12));
  }
}

// Axes as the data have them: a body described on other axes moves alike.
TEST(TorqueFreeMotion, does_not_depend_on_the_body_axes) {
  RandomMotion random(12);
  for (int i = 0; i < 500; ++i) {
    const Sample s{random.moments(), random.attitude(), random.vector(), random.uniform(-5, 5)};
    const Matrix3<double> P = rotation_matrix(normalized(random.attitude()));  // principal axes on the new body axes
    const Quaternion<double> attitude = normalized(s.attitude) * conjugate(quaternion_of(P));
    const TorqueFreeMotion plain = motion_of(s);
    const TorqueFreeMotion turned(s.moments, P, attitude, P * s.w);
    const SymmetricMatrix3<double> tensor =
        rotated(P, SymmetricMatrix3<double>::diagonal(s.moments.x, s.moments.y, s.moments.z));
    const TorqueFreeMotion of_tensor = TorqueFreeMotion::of_tensor(tensor, attitude, P * s.w);
    const Quaternion<double> expected = plain.attitude(s.t) * conjugate(quaternion_of(P));
    const double near = std::sqrt(static_cast<double>(plain.polhode().solution().parameter.complement));
    const double least = std::min({s.moments.x, s.moments.y, s.moments.z});
    EXPECT_LT(attitude_distance(turned.attitude(s.t), expected), 2e-13 / near);
    EXPECT_LT(attitude_distance(of_tensor.attitude(s.t), expected), 2e-13 / (near * least));
    EXPECT_LT(norm(turned.angular_velocity(s.t) - P * plain.angular_velocity(s.t)), 2e-13 * norm(s.w) / near);
  }
}

TEST(TorqueFreeMotion, accepts_left_handed_principal_axes) {
  const Matrix3<double> mirrored = Matrix3<double>::from_columns({0, 1, 0}, {1, 0, 0}, {0, 0, 1});
  const TorqueFreeMotion plain({1, 2, 3}, Quaternion<double>::identity(), {0.4, -1, 0.7});
  const TorqueFreeMotion swapped({2, 1, 3}, mirrored, Quaternion<double>::identity(), {0.4, -1, 0.7});
  EXPECT_LT(attitude_distance(plain.attitude(3), swapped.attitude(3)), 1e-15);
}

// The elementary motion of a symmetric body, for any order of the axes.
TEST(TorqueFreeMotion, of_axisymmetric_bodies_is_steady_precession) {
  RandomMotion random(13);
  for (int i = 0; i < 1000; ++i) {
    const std::size_t axis = static_cast<std::size_t>(i % 3);
    Vector3<double> moments;
    const double transverse = random.uniform(0.2, 1), axial = random.uniform(0.1, 2 * transverse);
    moments[axis] = axial;
    moments[(axis + 1) % 3] = moments[(axis + 2) % 3] = transverse;
    const Vector3<double> w = random.vector();
    const TorqueFreeMotion motion(moments, random.attitude(), w);
    const double t = random.uniform(-20, 20);
    // Turned by H t/I' about H in space, then by the spin about the axis in the body.
    const FreePrecession p =
        free_precession(axial, transverse, w[axis], std::hypot(w[(axis + 1) % 3], w[(axis + 2) % 3]));
    const Vector3<double> H = motion.angular_momentum();
    const Quaternion<double> expected = quaternion_exponential((t / transverse) * H) * motion.attitude(0) *
                                        quaternion_exponential(p.spin_rate * t * Vector3<double>::unit(axis));
    EXPECT_LT(attitude_distance(motion.attitude(t), expected), 1e-15 * (10 + norm(w) * std::fabs(t) * 4 / axial));
    EXPECT_NEAR(motion.mean_precession_rate(), p.precession_rate, 1e-14 * p.precession_rate);
    EXPECT_NEAR(motion.period(), std::fabs(2 * std::numbers::pi / p.spin_rate), 1e-13 * motion.period());
    EXPECT_EQ(motion.polhode().sense(), p.sense);
  }
}

TEST(TorqueFreeMotion, about_principal_axes_and_of_spheres_is_rotation) {
  RandomMotion random(14);
  for (int i = 0; i < 300; ++i) {
    Vector3<double> w{}, moments = random.moments();
    if (i % 6 < 3) {
      w[static_cast<std::size_t>(i % 3)] = random.normal();  // the intermediate axis too
    } else if (i % 6 < 5) {
      w = random.vector();
      moments = {0.7, 0.7, 0.7};
    }
    const Quaternion<double> q0 = normalized(random.attitude());
    const TorqueFreeMotion motion(moments, q0, w);
    const double t = random.uniform(-100, 100);
    EXPECT_LT(attitude_distance(motion.attitude(t), q0 * quaternion_exponential(t * w)),
              1e-15 * (4 + norm(w) * std::fabs(t)));
    EXPECT_EQ(norm(motion.angular_velocity(t) - w), 0);
    EXPECT_EQ(motion.polhode().kind(), PolhodeKind::point);
    EXPECT_EQ(motion.period(), 0);
    EXPECT_EQ(motion.precession_per_period(), 0);
  }
}

// On turned axes the products of the data's rounding must not set the body tumbling.
TEST(TorqueFreeMotion, about_the_intermediate_axis_on_turned_axes_stays_there) {
  RandomMotion random(15);
  for (int i = 0; i < 100; ++i) {
    const Matrix3<double> P = rotation_matrix(normalized(random.attitude()));
    const Vector3<double> w = 3.0 * P.column(1);
    const TorqueFreeMotion motion({1, 2, 3}, P, Quaternion<double>::identity(), w);
    EXPECT_EQ(motion.polhode().kind(), PolhodeKind::point);
    EXPECT_LT(norm(motion.angular_velocity(1000) - w), 1e-14);
  }
}

TEST(TorqueFreeMotion, crosses_the_separatrix_and_axisymmetry_without_a_jump) {
  // I1 (I2 - I1) w1^2 = I3 (I3 - I2) w3^2 exactly: w1 : w3 = 3 : 4.
  const Vector3<double> moments{1, 2, 2.25};
  const Quaternion<double> q{0.3, -0.5, 0.4, 0.2};
  const TorqueFreeMotion exact(moments, q, {0.75, 1.5, 1});
  EXPECT_EQ(exact.polhode().kind(), PolhodeKind::separatrix);
  EXPECT_EQ(exact.period(), std::numeric_limits<double>::infinity());
  for (const double side : {-1.0, 1.0}) {
    for (const double distance : {1e-16, 1e-14, 1e-12, 1e-10}) {
      const TorqueFreeMotion near(moments, q, {0.75 * (1 + side * distance), 1.5, 1});
      for (const double t : {-4.0, -1.0, 2.0, 5.0}) {
        // Neighbouring motions part as exp(rate |t|).
        EXPECT_LT(attitude_distance(near.attitude(t), exact.attitude(t)),
                  1e-15 + 20 * distance * std::exp(std::fabs(t)));
      }
    }
  }
  for (const double side : {-1.0, 1.0}) {
    const TorqueFreeMotion round({2, 2, 3}, q, {0.4, 0.5, 1});
    const TorqueFreeMotion nearly({2, 2 * (1 + side * 1e-13), 3}, q, {0.4, 0.5, 1});
    EXPECT_LT(attitude_distance(nearly.attitude(10), round.attitude(10)), 1e-11);
  }
}

TEST(TorqueFreeMotion, on_the_separatrix_follows_the_equations_and_ends_about_the_intermediate_axis) {
  const TorqueFreeMotion motion({1, 2, 2.25}, Quaternion<double>::identity(), {0.75, 1.5, 1});
  GyroTaylor<long double> taylor({1, 2, 2.25L}, {0, 0, 0}, 22, 1e-19L);
  const auto end = taylor.advance({{0.75L, 1.5L, 1}, {1, 0, 0, 0}}, 6);
  EXPECT_LT(attitude_distance(motion.attitude(6), Quaternion<long double>{end.q[0], end.q[1], end.q[2], end.q[3]}),
            1e-15);
  const double late = norm(motion.angular_momentum()) / 2;
  for (const double t : {-1e3, 1e3, 1e5}) {
    const Vector3<double> w = motion.angular_velocity(t);
    EXPECT_NEAR(std::fabs(w.y), late, 1e-14);
    EXPECT_NEAR(std::hypot(w.x, w.z), 0, 1e-14);
  }
  EXPECT_NEAR(motion.mean_precession_rate(), late, 1e-15);
  EXPECT_EQ(motion.precession_per_period(), std::numeric_limits<double>::infinity());
}

TEST(TorqueFreeMotion, refuses_what_is_no_body_or_attitude) {
  const Quaternion<double> q = Quaternion<double>::identity();
  const Vector3<double> w{1, 2, 3};
  const auto message = [&](const Vector3<double>& moments, const Quaternion<double>& attitude,
                           const Vector3<double>& velocity) -> std::string {
    try {
      const TorqueFreeMotion motion(moments, attitude, velocity);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message({1, 0, 2}, q, w), "Polhode: principal moment 2 is 0 kg m^2; it must be positive and finite");
  EXPECT_EQ(message({1, 1, nan}, q, w), "Polhode: principal moment 3 is nan kg m^2; it must be positive and finite");
  EXPECT_EQ(message({1, 1, 2}, q, {1, nan, 1}), "Polhode: component 2 of the angular velocity is not finite");
  EXPECT_EQ(message({1, 1, 2}, {0, 0, 0, 0}, w),
            "TorqueFreeMotion: the attitude is no rotation: its length is zero or not finite");
}

}  // namespace torque_free_test
}  // namespace poinsot
