// The polhode's kinds, extremes and herpolhode against the motion sampled along it and against textbook formulas.
#include "poinsot/engine/motion/closed_form/polhode.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "engine/motion/closed_form/closed_form_support.h"
#include "poinsot/engine/motion/closed_form/torque_free.h"

namespace poinsot {
namespace polhode_test {

const Matrix3<double> same = Matrix3<double>::identity();

TEST(Polhode, encircles_the_axis_that_momentum_and_energy_tell) {
  RandomMotion random(1);
  int counts[2] = {0, 0};
  for (int i = 0; i < 1000; ++i) {
    const Vector3<double> I = random.moments(), w = random.vector();
    const Polhode polhode(I, same, w);
    std::array<double, 3> order{I.x, I.y, I.z};
    std::sort(order.begin(), order.end());
    const Vector3<double> L{I.x * w.x, I.y * w.y, I.z * w.z};
    const bool largest = dot(L, L) > order[1] * dot(L, w);
    ++counts[largest];
    EXPECT_EQ(polhode.kind(), largest ? PolhodeKind::about_largest : PolhodeKind::about_smallest);
    EXPECT_EQ(polhode.sense(), largest ? PrecessionSense::retrograde : PrecessionSense::direct);
    EXPECT_NEAR(polhode.angular_momentum(), norm(L), 1e-15 * norm(L));
    EXPECT_NEAR(polhode.kinetic_energy(), dot(L, w) / 2, 1e-15 * dot(L, w));
    EXPECT_NEAR(polhode.invariable_plane_distance(), dot(L, w) / norm(L), 1e-14 * norm(w));
  }
  EXPECT_GT(counts[0], 100);
  EXPECT_GT(counts[1], 100);
}

TEST(Polhode, is_a_point_about_principal_axes_of_spheres_and_at_rest) {
  for (const Vector3<double>& w : {Vector3<double>{2, 0, 0}, {0, -1, 0}, {0, 0, 3}, {0, 0, 0}}) {
    const Polhode polhode({1, 2, 3}, same, w);
    EXPECT_EQ(polhode.kind(), PolhodeKind::point);
    EXPECT_EQ(polhode.sense(), PrecessionSense::none);
    EXPECT_EQ(polhode.period(), 0);
    EXPECT_EQ(polhode.herpolhode_radii().maximum, 0);
    EXPECT_NEAR(polhode.speed_range().minimum, norm(w), 1e-15);
    EXPECT_NEAR(polhode.speed_range().maximum, norm(w), 1e-15);
  }
  EXPECT_EQ(Polhode({2, 2, 2}, same, {1, 2, 3}).kind(), PolhodeKind::point);
  // Across the axis of symmetry every axis is principal.
  EXPECT_EQ(Polhode({2, 2, 3}, same, {1, 2, 0}).kind(), PolhodeKind::point);
  EXPECT_EQ(Polhode({1, 2, 2}, same, {0, 2, 5}).kind(), PolhodeKind::point);
}

// Ranges hold every sample, and some sample comes close to either end.
TEST(Polhode, ranges_are_those_of_the_motion) {
  RandomMotion random(2);
  for (int i = 0; i < 300 / closed_form_thinning; ++i) {
    const Vector3<double> I = random.moments(), w = random.vector(), d = random.vector();
    const Quaternion<double> q = Quaternion<double>::identity();
    const TorqueFreeMotion motion(I, q, w);
    const Polhode& polhode = motion.polhode();
    const double scale = norm(w) * 3;
    const Range component = polhode.angular_velocity_range(d), nutation = polhode.nutation_range(d);
    const Range speed = polhode.speed_range(), radii = polhode.herpolhode_radii();
    struct Seen {
      double minimum = 1e300, maximum = -1e300;
      void take(double x) {
        minimum = std::min(minimum, x);
        maximum = std::max(maximum, x);
      }
    };
    Seen seen_component, seen_nutation, seen_speed, seen_radius;
    const int samples = 4000;
    for (int k = 0; k < samples; ++k) {
      const Vector3<double> v = motion.angular_velocity(motion.period() * k / samples);
      const Vector3<double> L{I.x * v.x, I.y * v.y, I.z * v.z};
      seen_component.take(dot(v, d));
      seen_nutation.take(std::atan2(norm(cross(L, d)), dot(L, d)));
      seen_speed.take(norm(v));
      seen_radius.take(norm(cross(v, L)) / norm(L));
    }
    const auto expect = [](const Range& range, const Seen& seen, double size, const char* what) {
      EXPECT_GE(seen.minimum, range.minimum - 1e-13 * size) << what;
      EXPECT_LE(seen.maximum, range.maximum + 1e-13 * size) << what;
      // The samples are 1/4000 of a period apart, of a path that is near its extremes for at least 1/10 of it.
      EXPECT_NEAR(seen.minimum, range.minimum, 2e-3 * size) << what;
      EXPECT_NEAR(seen.maximum, range.maximum, 2e-3 * size) << what;
    };
    expect(component, seen_component, scale * norm(d), "component");
    expect(nutation, seen_nutation, 3, "nutation");
    expect(speed, seen_speed, scale, "speed");
    expect(radii, seen_radius, scale, "herpolhode");
  }
}

TEST(Polhode, ranges_on_the_separatrix_include_the_limits) {
  const Polhode polhode({1, 2, 2.25}, same, {0.75, 1.5, 1});
  EXPECT_EQ(polhode.kind(), PolhodeKind::separatrix);
  const double limit = polhode.angular_momentum() / 2;
  const Range y = polhode.angular_velocity_range({0, 1, 0});
  EXPECT_NEAR(y.minimum, -limit, 1e-15);
  EXPECT_NEAR(y.maximum, limit, 1e-15);
  const Range nutation = polhode.nutation_range({0, -1, 0});
  EXPECT_NEAR(nutation.minimum, 0, 1e-15);
  EXPECT_NEAR(nutation.maximum, std::numbers::pi, 1e-15);
  EXPECT_EQ(polhode.herpolhode_radii().minimum, 0);
}

// Small cones keep their digits: spin about z, tilted by 1e-9.
TEST(Polhode, small_angles_are_exact) {
  const Vector3<double> I{1, 2, 3};
  const Polhode polhode(I, same, {1e-9, 0, 1});
  const Range nutation = polhode.nutation_range({0, 0, 1});
  // l_x = I_1 w_x/H at u = 0; at u = K l_y = l_x sqrt(D_13/D_23).
  EXPECT_NEAR(nutation.minimum, 1e-9 / 3, 1e-24);
  EXPECT_NEAR(nutation.maximum, 1e-9 / 3 * 2, 1e-24);
  const Range radii = polhode.herpolhode_radii();
  EXPECT_NEAR(radii.maximum, 1e-9 * (2.0 / 3), 1e-24);  // H l_x D_13
  EXPECT_NEAR(radii.minimum, 1e-9 * (1.0 / 3), 1e-24);  // H l_y D_23
  // The period of small wobbles, with w_z sqrt((I3 - I1)(I3 - I2)/(I1 I2)) = 1 rad/s.
  EXPECT_NEAR(polhode.period(), 2 * std::numbers::pi, 1e-15);
}

TEST(Polhode, axes_only_rename_components) {
  RandomMotion random(3);
  for (int i = 0; i < 100; ++i) {
    const Vector3<double> I = random.moments(), w = random.vector(), d = random.vector();
    const Matrix3<double> P = rotation_matrix(normalized(random.attitude()));
    const Polhode plain(I, same, w), turned(I, P, P * w);
    EXPECT_EQ(plain.kind(), turned.kind());
    const Range a = plain.angular_velocity_range(d), b = turned.angular_velocity_range(P * d);
    EXPECT_NEAR(a.minimum, b.minimum, 1e-12);
    EXPECT_NEAR(a.maximum, b.maximum, 1e-12);
  }
}

}  // namespace polhode_test
}  // namespace poinsot
