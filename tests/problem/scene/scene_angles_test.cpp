// Angles of slopes, frames and gimbals, halves of edges, and which way is up.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "problem/scene/illustrated.h"

namespace poinsot {
namespace scene_angles_test {

using namespace scene_tests;

TEST(SceneAngles, the_angle_of_a_slope_is_drawn_inside_of_what_is_touched) {
  for (const double b : {12.0, 25.0, 40.0, 63.0}) {
    const Document document = illustrated(
        "title: t\ngiven: {b: " + degrees(b) +
        "}\npoints: {C: [1 m, 2 m, 0]}\ndirections: {out: [sin(b), cos(b), 0]}\nbodies: {block: {particle: C, mass: 1 "
        "kg}}\ncontacts: {slope: {of: block, at: C, normal: out, friction: 0.2}}\ngravity: -y\ninstants: {now: rest}\n"
        "ask: {a: acceleration(block)}\n");
    const scene::Scene& scene = scene_of(document);
    const scene::Dimension* angle = angle_named(scene, "b");
    ASSERT_NE(angle, nullptr) << b;
    const double rad = b * std::numbers::pi / 180;
    EXPECT_NEAR(drawn_angle(scene, *angle), rad, 1e-6);
    const Vector corner = on_ground(scene, angle->corner), out{std::sin(rad), std::cos(rad), 0};
    EXPECT_LT(norm(Vector(corner - Vector{1, 2, 0})), 1e-9);
    const Vector level = on_ground(scene, angle->from) - corner, slope = on_ground(scene, angle->to) - corner;
    EXPECT_LT(dot(level, out), 0);
    EXPECT_NEAR(dot(slope, out), 0, 1e-6 * norm(slope));
  }
}

TEST(SceneAngles, angles_of_frames_axes_of_inertia_and_gimbals_are_drawn) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> draw(10, 80);
  for (int round = 0; round < 5; ++round) {
    const double b = draw(random);
    const std::string frame =
        "title: t\ngiven: {b: " + degrees(b) +
        "}\npoints: {O: [0, 0, 0]}\nframes: {earth: {origin: O, turns: cos(b)*x + sin(b)*z, rate: "
        "0.1 rad/s}}\nbodies: {r: {sphere: {center: O, radius: 1 m}, mass: 1 kg}}\ngravity: none\n"
        "instants: {now: rest}\nask: {T: kinetic_energy(r)}\n";
    const std::string inertia =
        "title: t\ngiven: {b: " + degrees(b) +
        "}\npoints: {O: [0, 0, 0]}\ndirections: {CD: [cos(b), sin(b), 0]}\nbodies: {r: {mass: 1 kg, center: O, "
        "radii_of_gyration: {axis: CD, axial: 1 m, transverse: 0.8 m}}}\ngravity: none\ninstants: {now: rest}\n"
        "ask: {T: kinetic_energy(r)}\n";
    const std::string gimbal =
        "title: t\ngiven: {b: " + degrees(b) +
        "}\npoints: {O: [0, 0, 0]}\nbodies: {g: massless, r: {mass: 1 kg, center: O, inertia: {axis: x, axial: 1 "
        "kg*m^2, transverse: 2 kg*m^2}}}\njoints: {azimuth: {revolute: z, at: O, to: g, angle: b, rate: 0, accel: 0}, "
        "spin: {revolute: x, at: O, from: g, to: r, rate: 3 rad/s, accel: 0}}\ngravity: none\n"
        "ask: {T: kinetic_energy(r)}\n";
    for (const std::string& text : {frame, inertia, gimbal}) {
      const Document document = illustrated(text);
      const scene::Dimension* angle = angle_named(scene_of(document), "b");
      ASSERT_NE(angle, nullptr) << text;
      EXPECT_NEAR(drawn_angle(scene_of(document), *angle), b * std::numbers::pi / 180, 1e-6) << text;
    }
  }
}

TEST(SceneAngles, half_an_edge_is_a_length_that_a_datum_names) {
  const Document document = illustrated(
      "title: t\ngiven: {a: 0.4 m}\npoints: {G: [0, 0, 0]}\nbodies: {p: {rectangle: {center: G, sides: [2*a*x, "
      "3*a*y]}, "
      "mass: 1 kg}}\ngravity: none\ninstants: {now: rest}\nask: {T: kinetic_energy(p)}\n");
  const scene::Scene& scene = scene_of(document);
  ASSERT_EQ(scene.dimensions.size(), 1U);
  const Vector from = on_ground(scene, scene.dimensions[0].from), to = on_ground(scene, scene.dimensions[0].to);
  EXPECT_NEAR(norm(Vector(to - from)), 0.4, 1e-12);
  EXPECT_NEAR(from.x, 0, 1e-12);
}

TEST(SceneAngles, the_axis_called_up_points_up) {
  const auto up = [](const std::string& axes) {
    return scene_of(illustrated("title: t\n" + axes +
                                "points: {O: [0, 0, 0]}\nbodies: {b: {sphere: {center: O, radius: 1 m}, mass: 1 kg}}\n"
                                "gravity: none\ninstants: {now: rest}\nask: {T: kinetic_energy(b)}\n"))
        .up;
  };
  EXPECT_EQ(up("axes: [N, W, U]\n").z, 1);
  EXPECT_EQ(up("axes: [U, E, N]\n").x, 1);
  EXPECT_EQ(up("").y, 1);
}

}  // namespace scene_angles_test
}  // namespace poinsot
