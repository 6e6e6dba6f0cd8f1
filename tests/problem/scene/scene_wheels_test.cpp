// Wheels that belts, cords and teeth go round, posts of the ground, and what is said at them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "problem/scene/illustrated.h"

namespace poinsot {
namespace scene_wheels_test {

using namespace scene_tests;

// Two wheels given by numbers, R and r at the distance L, with a belt.
std::string belt_drive(double R, double r, double L, const std::string& more = "") {
  const auto metres = [](double value) { return std::to_string(value) + " m"; };
  return "title: t\ngiven: {R: " + metres(R) + ", r: " + metres(r) + ", L: " + metres(L) +
         "}\npoints: {A: [0, 0, 0], B: [L, 0, 0]}\nbodies:\n"
         "  big: {mass: 3 kg, center: A, inertia: {axis: z, axial: 9 kg*m^2, transverse: 9 kg*m^2}}\n"
         "  small: {mass: 1 kg, center: B, inertia: {axis: z, axial: 2 kg*m^2, transverse: 2 kg*m^2}}\n"
         "joints:\n  a: {revolute: z, at: A, to: big, couple: 5 N*m}\n  b: {revolute: z, at: B, to: small}\n"
         "belts: {belt: {over: [{big: {radius: R}}, {small: {radius: r}}], tension: 100 N}}\n"
         "gravity: none\ninstants: {now: rest}\nask:\n  T1: tension(belt from big to small)\n  slack: tension(belt "
         "from "
         "small to big)\n" +
         more;
}

double farthest(const scene::Body& body) {
  double most = 0;
  for (const Vector& vertex : body.shapes.at(0).vertices) most = std::max(most, norm(Vector(vertex - body.center)));
  return most;
}

TEST(SceneWheels, a_body_given_by_numbers_is_as_large_as_the_wheel_that_its_belt_goes_round) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> draw(0.05, 0.4);
  for (int round = 0; round < 6; ++round) {
    const double R = draw(random), r = draw(random), L = R + r + draw(random);
    const Document document = illustrated(belt_drive(R, r, L));
    const scene::Scene& scene = scene_of(document);
    for (const auto& [body, radius] : {std::pair{0U, R}, std::pair{1U, r}}) {
      ASSERT_EQ(scene.bodies.at(body).shapes.size(), 1U);
      EXPECT_EQ(scene.bodies[body].shapes[0].kind, "disk");
      EXPECT_NEAR(farthest(scene.bodies[body]), radius, 1e-5);
    }
    // The belt touches both rims.
    ASSERT_EQ(scene.links.size(), 2U);
    for (const scene::Link& link : scene.links)
      for (const scene::Place& place : {link.from, link.to}) {
        const Vector at = on_ground(scene, place);
        EXPECT_LT(std::min(std::abs(norm(at) - R), std::abs(norm(Vector(at - Vector{L, 0, 0})) - r)), 1e-5);
      }
  }
}

// The hub of a reel whose rim alone is stated is a circle that the cord touches; a drum of the radius needs none.
TEST(SceneWheels, what_a_cord_winds_on_is_a_circle_where_no_shape_shows_it) {
  for (const bool shown : {false, true}) {
    const Document document = illustrated(std::string(R"(
title: t
plane: [x, y]
given: {m: 3 kg, k: 0.12 m, R: 0.2 m, r: )") +
                                          (shown ? "0.2 m" : "0.1 m") + R"(}
points: {C: [0, 0], G: [0, R]}
bodies: {reel: {mass: m, center: G, radii_of_gyration: {z: k}, added: {rim: {disk: {center: G, normal: z, radius: R}, mass: 0 kg}}}}
contacts: {floor: {of: reel, at: C, normal: y, no_slip: true}}
cords: {cord: {from: ground, at: [3 m, R - r], to: {reel: {at: G, radius: r, side: -y}}}}
gravity: -y
instants: {now: rest}
ask: {T: tension(cord)}
)");
    const scene::Scene& scene = scene_of(document);
    std::size_t circles = 0;
    for (const scene::Curve& curve : scene.curves) {
      if (curve.kind != scene::CurveKind::pitch_circle) continue;
      ++circles;
      for (const Vector& point : curve.points)
        EXPECT_NEAR(norm(Vector(on_ground(scene, {curve.body, point}) - Vector{0, 0.2, 0})), 0.1, 1e-12);
    }
    EXPECT_EQ(circles, shown ? 0U : 1U);
  }
}

TEST(SceneWheels, sides_of_a_belt_have_the_names_of_the_tensions_that_are_asked_for) {
  const Document document = illustrated(belt_drive(0.2, 0.1, 0.6));
  std::vector<std::string> symbols;
  for (const scene::Link& link : scene_of(document).links) symbols.push_back(link.symbol);
  std::ranges::sort(symbols);
  ASSERT_EQ(symbols.size(), 2U);
  EXPECT_EQ(symbols[0], "T_{1}");
  EXPECT_NE(symbols[1].find("slack"), std::string::npos);
}

TEST(SceneWheels, what_is_cut_free_is_pulled_by_each_side_of_a_belt_with_its_own_tension) {
  const Document document = illustrated(belt_drive(0.2, 0.1, 0.6));
  const scene::Scene& scene = scene_of(document);
  const std::vector<Answer>& answers = document.solutions.at(0).answers;
  std::size_t seen = 0;
  for (const scene::Diagram& diagram : scene.diagrams) {
    if (diagram.kind != scene::DiagramKind::free_body) continue;
    for (const scene::Arrow& arrow : diagram.arrows) {
      if (arrow.name != "belt") continue;
      const bool slack = arrow.symbol.find("slack") != std::string::npos;
      const double tension = std::get<double>(answers.at(slack ? 1 : 0).si.content);
      EXPECT_NEAR(norm(arrow.vector), std::abs(tension), 1e-9 * std::abs(tension)) << arrow.symbol;
      EXPECT_NEAR(arrow.value, tension, 1e-9 * std::abs(tension)) << arrow.symbol;
      ++seen;
    }
  }
  // Two sides pull at each wheel that is cut free.
  EXPECT_GE(seen, 2U);
  EXPECT_EQ(seen % 2, 0U);
}

TEST(SceneWheels, the_sides_of_a_belt_are_where_they_are_at_each_time) {
  const Document document = illustrated(belt_drive(0.2, 0.1, 0.6, "  w: angular_velocity(small).z @ 2 s\n"));
  const scene::Scene& scene = scene_of(document);
  ASSERT_TRUE(scene.motion);
  ASSERT_EQ(scene.motion->links.size(), 2U);
  EXPECT_NE(scene.motion->links[0].link, scene.motion->links[1].link);
  for (const scene::MovingLink& moving : scene.motion->links) {
    const scene::Link& link = scene.links.at(moving.link);
    // The axles stand still, so that the sides do.
    for (const auto& [places, at] : {std::pair{&moving.from, &link.from}, std::pair{&moving.to, &link.to}})
      for (const Vector& place : *places) EXPECT_LT(norm(Vector(place - on_ground(scene, *at))), 1e-6);
  }
}

// How far a cord goes round, right-handed about the axis of the wheel on which it lies.
double angle_of(const scene::Scene& scene, const scene::Wrap& wrap, double* off_tangent = nullptr) {
  const scene::Link &comes = scene.links.at(wrap.comes), &leaves = scene.links.at(wrap.leaves);
  const Vector C = on_ground(scene, wrap.center), from = on_ground(scene, comes.from), to = on_ground(scene, leaves.to);
  const Vector axis =
      wrap.center.body < 0 ? wrap.axis : scene.bodies.at(static_cast<std::size_t>(wrap.center.body)).pose.R * wrap.axis;
  const Vector a = from - C, b = to - C;
  if (off_tangent != nullptr) {
    // It goes on in the direction in which it came, and leaves in that in which it goes on.
    const Vector in = from - on_ground(scene, comes.to), out = on_ground(scene, leaves.from) - to;
    *off_tangent = 0;
    for (const auto& [arm, along] : {std::pair{a, in}, std::pair{b, out}}) {
      const Vector tangent = cross(axis, arm);
      *off_tangent = std::max(*off_tangent, norm(Vector(tangent / norm(tangent) - along / norm(along))));
    }
  }
  const double angle = std::atan2(dot(axis, cross(a, b)), dot(a, b));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

TEST(SceneWheels, a_belt_lies_on_its_wheels_between_its_sides) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> draw(0.05, 0.4);
  for (int round = 0; round < 6; ++round) {
    const double R = draw(random), r = draw(random), L = R + r + draw(random);
    const Document document = illustrated(belt_drive(R, r, L));
    const scene::Scene& scene = scene_of(document);
    ASSERT_EQ(scene.wraps.size(), 2U);
    double sum = 0;
    for (const scene::Wrap& wrap : scene.wraps) {
      double off_tangent = 1;
      const double angle = angle_of(scene, wrap, &off_tangent);
      EXPECT_LT(off_tangent, 1e-5);
      // An open belt touches half of each wheel, more of the larger by twice the lean of its sides.
      const bool big = norm(on_ground(scene, wrap.center)) < 1e-6;
      const double lean = 2 * std::asin((R - r) / L);
      EXPECT_NEAR(angle, std::numbers::pi + (big ? lean : -lean), 1e-4);
      sum += angle;
    }
    EXPECT_NEAR(sum, 2 * std::numbers::pi, 1e-4);
  }
}

TEST(SceneWheels, a_cord_lies_on_the_wheel_that_it_is_led_over_and_on_no_other) {
  const Document document = illustrated(
      "title: t\npoints: {O: [0, 0, 0], A: [-0.2 m, -1 m, 0], B: [0.2 m, -0.5 m, 0]}\nbodies:\n"
      "  wheel: {disk: {center: O, normal: z, radius: 0.2 m}, mass: 3 kg}\n"
      "  light: {particle: A, mass: 2 kg}\n  heavy: {particle: B, mass: 5 kg}\n"
      "joints: {pin: {revolute: z, at: O, to: wheel}}\n"
      "cords: {cord: {from: light, at: A, over: [wheel], to: heavy, end: B}}\n"
      "gravity: -y\ninstants: {now: rest}\nask: {T: tension(cord from light to wheel)}\n");
  const scene::Scene& scene = scene_of(document);
  ASSERT_EQ(scene.wraps.size(), 1U);
  double off_tangent = 1;
  EXPECT_NEAR(angle_of(scene, scene.wraps[0], &off_tangent), std::numbers::pi, 1e-6);
  EXPECT_LT(off_tangent, 1e-6);
}

TEST(SceneWheels, gears_are_disks_that_touch_where_their_teeth_meet_and_a_ring_is_none) {
  const Document document = illustrated(
      "title: t\npoints: {A: [0, 0, 0], P: [0.1 m, 0, 0], B: [0.15 m, 0, 0], Q: [0.2 m, 0, 0]}\nbodies:\n"
      "  sun: {mass: 3 kg, center: A, inertia: {axis: z, axial: 9 kg*m^2, transverse: 9 kg*m^2}}\n"
      "  planet: {mass: 1 kg, center: B, inertia: {axis: z, axial: 2 kg*m^2, transverse: 2 kg*m^2}}\n"
      "  ring: {mass: 1 kg, center: A, inertia: {axis: z, axial: 2 kg*m^2, transverse: 2 kg*m^2}}\n"
      "joints:\n  a: {revolute: z, at: A, to: sun, couple: 5 N*m}\n  b: {revolute: z, at: B, to: planet}\n"
      "  c: {revolute: z, at: A, to: ring}\n"
      "gears: {one: {of: sun, against: planet, at: P}, two: {of: planet, against: ring, at: Q}}\n"
      "gravity: none\ninstants: {now: rest}\nask: {a: angular_acceleration(ring).z}\n");
  const scene::Scene& scene = scene_of(document);
  EXPECT_NEAR(farthest(scene.bodies.at(0)), 0.1, 1e-9);
  EXPECT_NEAR(farthest(scene.bodies.at(1)), 0.05, 1e-9);
  for (const scene::Shape& shape : scene.bodies.at(2).shapes) EXPECT_NE(shape.kind, "disk");
  EXPECT_TRUE(std::ranges::any_of(scene.curves, [](const scene::Curve& curve) {
    return curve.kind == scene::CurveKind::pitch_circle && curve.body == 2;
  }));
}

TEST(SceneWheels, a_post_is_a_circle_of_its_radius_and_tells_its_friction) {
  const Document document = illustrated(
      "title: t\ngiven: {r: 0.2 m, mu: 0.3}\npoints: {O: [0, 0, 0], A: [-r, -1 m, 0], B: [r, -0.5 m, 0]}\n"
      "bodies: {left: {particle: A, mass: 2 kg}, right: {particle: B, mass: 3 kg}}\n"
      "cords: {rope: {from: left, at: A, over: [{O: {radius: r, friction: mu}}], to: right, end: B}}\n"
      "gravity: -y\ninstants: {now: rest}\nask: {T: tension(rope on right)}\n");
  const scene::Scene& scene = scene_of(document);
  const auto post = std::ranges::find(scene.curves, scene::CurveKind::post, &scene::Curve::kind);
  ASSERT_NE(post, scene.curves.end());
  EXPECT_TRUE(post->closed);
  for (const Vector& point : post->points) EXPECT_NEAR(norm(point), 0.2, 1e-9);
  const auto friction = std::ranges::find(scene.dimensions, std::string("mu"), &scene::Dimension::name);
  ASSERT_NE(friction, scene.dimensions.end());
  EXPECT_EQ(friction->text, "mu = 0.3");
  const auto radius = std::ranges::find(scene.dimensions, std::string("r"), &scene::Dimension::name);
  ASSERT_NE(radius, scene.dimensions.end());
  EXPECT_NEAR(norm(Vector(radius->to.at - radius->from.at)), 0.2, 1e-9);
}

TEST(SceneWheels, what_shakes_is_an_arrow_to_and_fro_as_large_as_its_amplitude) {
  const Document document = illustrated(
      "title: t\ngiven: {F: 7 N, w: 3 rad/s}\npoints: {A: [0, 0, 0]}\nbodies: {block: {particle: A, mass: 2 kg}}\n"
      "joints: {rail: {prismatic: x, at: A, to: block, displacement: u, spring: {stiffness: 800 N/m}, damping: 4 "
      "N*s/m}}\n"
      "excitations: {push: {force: F, along: x, body: block, frequency: w}}\ngravity: none\ninstants: {now: rest}\n"
      "ask: {r: response(u to push)}\n");
  const std::vector<scene::Arrow>& arrows = scene_of(document).diagrams.at(0).arrows;
  ASSERT_EQ(arrows.size(), 1U);
  EXPECT_TRUE(arrows[0].swings);
  EXPECT_EQ(arrows[0].quantity, scene::Quantity::force);
  EXPECT_NEAR(norm(Vector(arrows[0].vector - Vector{7, 0, 0})), 0, 1e-12);
}

TEST(SceneWheels, ground_that_is_touched_later_and_a_center_that_pulls_are_told) {
  const Document falls = illustrated(
      "title: t\npoints: {C: [0, 1 m, 0], G: [0, 1.1 m, 0], O: [0, 0, 0]}\n"
      "bodies: {ball: {sphere: {center: G, radius: 0.1 m}, mass: 1 kg}}\n"
      "contacts: {floor: {of: ball, at: C, normal: y, open: true, surface: O, restitution: 0.5}}\n"
      "gravity: -y\ninstants: {start: rest}\nask: {h: position(ball).y @ 0.1 s}\n");
  const auto surface = std::ranges::find(scene_of(falls).curves, scene::CurveKind::surface, &scene::Curve::kind);
  ASSERT_NE(surface, scene_of(falls).curves.end());
  EXPECT_NEAR(norm(surface->points.at(0)), 0, 1e-12);
  EXPECT_NEAR(norm(Vector(surface->points.at(1) - surface->points.at(0) - Vector{0, 1, 0})), 0, 1e-12);
  const Document orbits = illustrated(
      "title: t\npoints: {O: [0, 0, 0], P: [7000 km, 0, 0]}\nbodies: {craft: {particle: P, mass: 1 kg}}\n"
      "gravity: {toward: O, parameter: 398600 km^3/s^2}\ninstants: {start: {velocity(craft): [0, 7.5 km/s, 0]}}\n"
      "ask: {v: norm(velocity(craft)) @ 40000 s}\n");
  const scene::Scene& scene = scene_of(orbits);
  EXPECT_TRUE(std::ranges::any_of(scene.curves,
                                  [](const scene::Curve& curve) { return curve.kind == scene::CurveKind::attractor; }));
  // Some seven times round: the path is followed finely enough to be drawn.
  ASSERT_TRUE(scene.motion);
  const std::vector<std::vector<scene::Pose>>& poses = scene.motion->poses;
  const Vector center = scene.bodies.at(0).center;
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
    const Vector a = poses[k][0].R * center + poses[k][0].p, b = poses[k + 1][0].R * center + poses[k + 1][0].p;
    EXPECT_LT(std::acos(std::clamp(dot(a, b) / (norm(a) * norm(b)), -1.0, 1.0)), 0.4 * std::numbers::pi);
  }
}

}  // namespace scene_wheels_test
}  // namespace poinsot
