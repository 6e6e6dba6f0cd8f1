// Solids that stand for bodies of which the shape is not stated.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "problem/scene/illustrated.h"

namespace poinsot {
namespace scene_stand_ins_test {

using namespace scene_tests;

// The moments of a uniform solid inside a closed surface, by tetrahedra from the origin.
Vector moments_of_solid(const scene::Shape& shape, const Vector& center, double mass) {
  double volume = 0;
  Vector squares{};
  for (const auto& t : shape.triangles) {
    const Vector a = shape.vertices[t[0]] - center, b = shape.vertices[t[1]] - center,
                 c = shape.vertices[t[2]] - center;
    const double v = dot(a, cross(b, c)) / 6;
    volume += v;
    const Vector sum = a + b + c;
    for (std::size_t k = 0; k < 3; ++k)
      squares[k] += v / 20 * (a[k] * a[k] + b[k] * b[k] + c[k] * c[k] + sum[k] * sum[k]);
  }
  squares = squares * (mass / volume);
  return {squares.y + squares.z, squares.z + squares.x, squares.x + squares.y};
}

TEST(SceneStandIns, solids_stand_for_bodies_whose_inertia_is_known) {
  const Document document = illustrated(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {r: {mass: 2 kg, center: O, inertia: {axis: z, axial: 0.5 kg*m^2, "
      "transverse: 0.5 kg*m^2}}}\njoints: {p: {ball: O, to: r}}\ninstants: {now: rest}\ngravity: none\n"
      "ask: {T: kinetic_energy(r)}\n");
  const scene::Body& body = scene_of(document).bodies.at(0);
  ASSERT_EQ(body.shapes.size(), 1U);
  EXPECT_TRUE(body.shapes[0].stand_in);
  const Vector moments = moments_of_solid(body.shapes[0], body.center, body.mass);
  // A round surface of flat facets lies inside the true one.
  EXPECT_NEAR(moments.z, 0.5, 0.01 * 0.5);
  EXPECT_NEAR(moments.x, 0.5, 0.01 * 0.5);
  EXPECT_NEAR(moments.y, 0.5, 0.01 * 0.5);
}

TEST(SceneStandIns, an_ellipsoid_of_its_moments_stands_for_a_body_of_three_different_ones) {
  const Document document = illustrated(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {r: {mass: 2 kg, center: O, inertia: {x: 3 kg*m^2, y: 4 kg*m^2, z: 5 "
      "kg*m^2, xy: 0, yz: 0, zx: 0}}, s: {sphere: {center: [3 m, 0, 0], radius: 1 m}, mass: 1 kg}}\n"
      "gravity: none\ninstants: {now: rest}\nask: {T: kinetic_energy(r)}\n");
  const scene::Body& body = scene_of(document).bodies.at(0);
  ASSERT_EQ(body.shapes.size(), 1U);
  EXPECT_TRUE(body.shapes[0].stand_in);
  const Vector moments = moments_of_solid(body.shapes[0], body.center, body.mass);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(moments[k], 3.0 + static_cast<double>(k), 0.05);
  EXPECT_FALSE(scene_of(document).bodies.at(1).shapes.at(0).stand_in);
}

// Of bodies about one middle the smallest is drawn, wherever it stands in the file.
TEST(SceneStandIns, of_bodies_within_each_other_the_innermost_is_seen) {
  const std::string table = "table: {mass: 1 kg, center: O, inertia: {axis: z, axial: 3 kg*m^2, transverse: 2 kg*m^2}}";
  const std::string wheel =
      "wheel: {mass: 1 kg, center: O, inertia: {axis: z, axial: 0.1 kg*m^2, transverse: 0.06 kg*m^2}}";
  for (const bool wheel_first : {false, true}) {
    const Document document = illustrated(
        "title: t\npoints: {O: [0, 0, 0]}\nbodies: {" + (wheel_first ? wheel + ", " + table : table + ", " + wheel) +
        "}\njoints: {pivot: {revolute: z, at: O, to: table}, axle: {revolute: z, at: O, from: table, to: wheel}}\n"
        "gravity: none\ninstants: {now: rest}\nask: {T: kinetic_energy(system)}\n");
    for (const scene::Body& body : scene_of(document).bodies)
      EXPECT_EQ(body.shapes.size(), body.name == "wheel" ? 1U : 0U) << body.name;
  }
}

TEST(SceneStandIns, what_stands_for_a_body_leaves_its_bearings_outside) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> draw(0.4, 3);
  for (int round = 0; round < 10; ++round) {
    const std::string reach = std::to_string(draw(random));
    const Document document = illustrated(
        "title: t\npoints: {G: [0, 0, 0], A: [0, 0, " + reach + " m], B: [0, 0, -" + reach +
        " m]}\nbodies: {r: {mass: 2 kg, center: G, radii_of_gyration: {x: 1 m, y: 1.1 m, z: 1.2 m}}}\n"
        "joints: {p: {revolute: z, at: G, to: r, rate: 1 rad/s, accel: 0, supports: {A: [x, y], B: [x, y]}}}\n"
        "gravity: -y\nask: {A: reaction(A)}\n");
    const scene::Body& body = scene_of(document).bodies.at(0);
    ASSERT_EQ(body.shapes.size(), 1U);
    double highest = 0;
    for (const Vector& vertex : body.shapes[0].vertices) highest = std::max(highest, vertex.z);
    EXPECT_LT(highest, std::stod(reach) + 1e-9);
    EXPECT_GT(highest, 0.3);
  }
}

TEST(SceneStandIns, links_of_a_mechanism_keep_their_arms) {
  const Document document = illustrated(
      "title: t\npoints: {O: [0, 0, 0], P: [1 m, 0.2 m, 0], G: [0.5 m, 0, 0], H: [2 m, 0, 0]}\n"
      "bodies: {a: {mass: 2 kg, center: G, inertia: {x: 3 kg*m^2, y: 4 kg*m^2, z: 5 kg*m^2, xy: 0, yz: 0, zx: 0}}, "
      "b: {mass: 2 kg, center: H, inertia: {x: 3 kg*m^2, y: 4 kg*m^2, z: 5 kg*m^2, xy: 0, yz: 0, zx: 0}}}\n"
      "joints: {p: {revolute: z, at: O, to: a}, q: {revolute: z, at: P, from: a, to: b}}\n"
      "gravity: none\ninstants: {now: rest}\nask: {T: kinetic_energy(a)}\n");
  for (const scene::Body& body : scene_of(document).bodies) EXPECT_TRUE(body.shapes.empty()) << body.name;
}

TEST(SceneStandIns, an_open_center_is_drawn_where_the_body_is_held_and_open_moments_as_a_wheel_of_its_points) {
  const Document document = illustrated(
      "title: t\npoints: {C: [0.3 m, 0, 0], A: [0.2 m, 0.5 m, 0], B: [0.4 m, 0, 0.5 m]}\n"
      "bodies: {w: {mass: 2 kg, center: [any, 0.001 m, 0], inertia: {about: C, xy: 0, zx: 0, rest: any}}}\n"
      "joints: {s: {revolute: x, at: C, to: w, rate: 3 rad/s, accel: 0}}\ngravity: none\n"
      "ask: {F: 'force(s on w).y'}\n");
  const scene::Body& body = scene_of(document).bodies.at(0);
  EXPECT_NEAR(norm(Vector(body.center - Vector{0.3, 0.001, 0})), 0, 1e-12);
  ASSERT_EQ(body.shapes.size(), 1U);
  EXPECT_EQ(body.shapes[0].kind, "cylinder");
  for (const Vector& vertex : body.shapes[0].vertices) {
    EXPECT_NEAR(std::abs(vertex.x - 0.3), 0.1, 1e-12);
    EXPECT_LT(std::hypot(vertex.y, vertex.z), 0.5 + 1e-12);
  }
}

TEST(SceneStandIns, a_cone_stands_for_a_top_whose_cylinder_would_swallow_the_tip_on_which_it_stands) {
  const auto stand_in = [](double height) {
    const Document document = illustrated(
        "title: t\npoints: {O: [0, 0, 0], G: [0, 0, " + std::to_string(height) +
        " m]}\nbodies: {top: {mass: 1 kg, center: G, inertia: {axis: z, axial: 0.5 kg*m^2, transverse: 0.35 "
        "kg*m^2}}}\njoints: {tip: {ball: O, to: top}}\ngravity: -z\ninstants: {start: rest}\n"
        "ask: {T: kinetic_energy(top)}\n");
    return scene_of(document).bodies.at(0).shapes.at(0);
  };
  // The cylinder of these moments is 1 m in radius and sqrt(12*0.35 - 3) m = 1.095 m long.
  EXPECT_EQ(stand_in(0.6).kind, "cylinder");
  const scene::Shape cone = stand_in(0.5);
  EXPECT_EQ(cone.kind, "cone");
  const auto [low, high] = std::ranges::minmax(cone.vertices, {}, &Vector::z);
  EXPECT_NEAR(low.z, 0, 1e-12);
  EXPECT_NEAR(high.z, 0.5 / 0.75, 1e-12);
}

TEST(SceneStandIns, what_stands_on_a_corner_has_no_round_solid_for_it) {
  const auto shapes = [](const std::string& place) {
    const Document document = illustrated(
        "title: t\npoints: {A: [0, 0, 0], G: [0, 0, 0.5 m]}\nbodies: {crate: {mass: 5 kg, center: G, inertia: "
        "{axis: y, "
        "axial: 0.4 kg*m^2, transverse: 0.3 kg*m^2}}}\ncontacts: {foot: {of: crate, " +
        place + ": A, normal: z}}\ngravity: -z\ninstants: {now: rest}\nask: {T: kinetic_energy(crate)}\n");
    return scene_of(document).bodies.at(0).shapes.size();
  };
  EXPECT_EQ(shapes("corner"), 0U);
  EXPECT_EQ(shapes("at"), 1U);
}

// A pin that slides beyond the solid of the moments slides in a lever, one within it in a wheel.
TEST(SceneStandIns, a_lever_with_a_slot_beyond_its_solid_is_shown_by_its_arms) {
  const auto shapes = [](const std::string& moment) {
    const Document document = illustrated(
        "title: t\nplane: [x, y]\npoints: {O: [0, 0], Q: [0, 0.3 m], P: [0.05 m, 0.4 m]}\nbodies: {lever: {mass: 1 kg, "
        "center: O, inertia: {z: " +
        moment +
        "}}, crank: massless}\njoints:\n  pivot: {revolute: z, at: O, to: lever}\n  shaft: {revolute: z, at: Q, to: "
        "crank, rate: 5 rad/s, accel: 0}\n  pin: {slot: [O->P, z], at: P, from: lever, to: crank}\ngravity: none\n"
        "ask: {w: angular_velocity(lever)}\n");
    return scene_of(document).bodies.at(0).shapes.size();
  };
  EXPECT_EQ(shapes("0.02 kg*m^2"), 0U);
  EXPECT_EQ(shapes("0.2 kg*m^2"), 1U);
}

}  // namespace scene_stand_ins_test
}  // namespace poinsot
