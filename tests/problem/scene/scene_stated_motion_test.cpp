// What the statement says of how things move and of what grows, and what the equations leave open, as arrows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "poinsot/rendering.h"
#include "problem/scene/illustrated.h"

namespace poinsot {
namespace scene_stated_motion_test {

using namespace scene_tests;

std::vector<scene::Arrow> arrows_of(const Document& document, scene::DiagramKind kind) {
  std::vector<scene::Arrow> arrows;
  for (const scene::Diagram& diagram : scene_of(document).diagrams)
    if (diagram.kind == kind) arrows.insert(arrows.end(), diagram.arrows.begin(), diagram.arrows.end());
  return arrows;
}

const scene::Arrow* named(const std::vector<scene::Arrow>& arrows, const std::string& text) {
  const auto found = std::ranges::find(arrows, text, &scene::Arrow::text);
  return found == arrows.end() ? nullptr : &*found;
}

TEST(SceneStatedMotion, rates_of_coordinates_are_turnings_about_their_axes_as_they_stand) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> draw(0.2, 1.3);
  for (int round = 0; round < 6; ++round) {
    const double f = draw(random), t = draw(random);
    const Document document = illustrated(
        "title: t\ngiven: {p: 2 rad/s, f: " + std::to_string(f) + " rad, t: " + std::to_string(t) +
        " rad}\npoints: {O: [0, 0, 0], G: [0, 0, 1 m]}\nbodies: {top: {cone: {apex: O, base: [0, 0, 1.4 m], radius: "
        "0.4 m}, mass: 1 kg}}\njoints: {tip: {ball: O, to: top, angles: [phi: z, theta: x, psi: O->G]}}\ngravity: -z\n"
        "instants: {start: {phi: f, theta: t, psi: 0, phi': p, theta': 0, psi': 50 rad/s}}\n"
        "ask: {T: kinetic_energy(top) @ start}\n");
    const std::vector<scene::Arrow> arrows = arrows_of(document, scene::DiagramKind::model);
    ASSERT_EQ(arrows.size(), 2U);  // zero is not drawn
    const scene::Arrow *p = named(arrows, "p"), *spin = named(arrows, "psi'");
    ASSERT_TRUE(p != nullptr && spin != nullptr);
    EXPECT_EQ(spin->symbol, "\\boldsymbol{\\dot{\\psi}}");
    EXPECT_NEAR(norm(Vector(p->vector - Vector{0, 0, 2})), 0, 1e-9);
    // The axis of the body after the turns about z and then about the turned x.
    const Vector axis{std::sin(f) * std::sin(t), -std::cos(f) * std::sin(t), std::cos(t)};
    // The text has six decimals of the angles.
    EXPECT_NEAR(norm(Vector(spin->vector - 50.0 * axis)), 0, 1e-4) << f << " " << t;
    EXPECT_TRUE(p->known && !p->open);
  }
}

TEST(SceneStatedMotion, a_sliding_that_is_stated_is_a_velocity_along_its_way) {
  const Document document = illustrated(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {cart: {particle: O, mass: 2 kg}}\njoints: {rail: {prismatic: x, at: "
      "O, "
      "to: cart, displacement: s}}\ngravity: none\ninstants: {start: {s: 0, s': -3 m/s}}\nask: {v: s'}\n");
  const std::vector<scene::Arrow> arrows = arrows_of(document, scene::DiagramKind::model);
  ASSERT_EQ(arrows.size(), 1U);
  EXPECT_EQ(arrows[0].quantity, scene::Quantity::velocity);
  EXPECT_NEAR(norm(Vector(arrows[0].vector - Vector{-3, 0, 0})), 0, 1e-12);
}

TEST(SceneStatedMotion, components_that_are_stated_one_by_one_are_one_velocity) {
  const Document document = illustrated(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {puck: {particle: O, mass: 2 kg}}\ngravity: none\ninstants: {start: "
      "{velocity(puck).x: 3 m/s, velocity(puck).y: 0, velocity(puck).z: -4 m/s}}\nask: {p: momentum(puck)}\n");
  const std::vector<scene::Arrow> arrows = arrows_of(document, scene::DiagramKind::model);
  ASSERT_EQ(arrows.size(), 1U);
  EXPECT_EQ(arrows[0].text, "v_puck");
  EXPECT_NEAR(norm(Vector(arrows[0].vector - Vector{3, 0, -4})), 0, 1e-12);
}

TEST(SceneStatedMotion, a_pivot_that_is_shaken_moves_and_a_frame_that_speeds_up_has_its_acceleration) {
  const Document shaken = illustrated(
      "title: t\ngiven: {A: 0.05 m, w: 9 rad/s}\npoints: {O: [0, 0, 0], P: [0, -1 m, 0]}\nbodies: {slider: massless, "
      "bob: {particle: P, mass: 1 kg}}\njoints: {rail: {prismatic: x, at: O, to: slider, displacement: A*sin(w*time)}, "
      "pin: {revolute: z, at: O, from: slider, to: bob, angle: q}}\ngravity: -y\ninstants: {start: {q: 0, q': 0}}\n"
      "ask: {q: q @ 0.1 s}\n");
  const std::vector<scene::Arrow> moves = arrows_of(shaken, scene::DiagramKind::model);
  ASSERT_EQ(moves.size(), 1U);
  EXPECT_EQ(moves[0].quantity, scene::Quantity::velocity);
  EXPECT_NEAR(norm(Vector(moves[0].vector - Vector{0.45, 0, 0})), 0, 1e-12);

  const Document lift = illustrated(
      "title: t\ngiven: {a: 2 m/s^2}\npoints: {O: [0, 0, 0], P: [0, -1 m, 0]}\nframes: {lift: {velocity: [0, 0, 0], "
      "acceleration: [0, a, 0]}}\nbodies: {bob: {particle: P, mass: 1 kg}}\njoints: {pin: {revolute: z, at: O, from: "
      "lift, to: bob, angle: q}}\ngravity: -y\nsteady: {frame: lift}\nask: {f: 'frequencies(bob)[1]'}\n");
  const std::vector<scene::Arrow> lifts = arrows_of(lift, scene::DiagramKind::model);
  ASSERT_EQ(lifts.size(), 1U);
  EXPECT_EQ(lifts[0].quantity, scene::Quantity::acceleration);
  EXPECT_NEAR(norm(Vector(lifts[0].vector - Vector{0, 2, 0})), 0, 1e-12);
}

TEST(SceneStatedMotion, a_load_that_grows_from_nothing_shows_its_sense) {
  const Document document = illustrated(
      "title: t\ngiven: {K: 40 N/s}\npoints: {C: [0, 0, 0]}\nbodies: {crate: {particle: C, mass: 20 kg}}\nloads: "
      "{push: "
      "{force: [-K*time, 0, 0], at: C, body: crate}}\ngravity: none\ninstants: {start: {velocity(crate): [0, 0, 0]}}\n"
      "ask: {v: velocity(crate).x @ 1 s}\n");
  const std::vector<scene::Arrow> arrows = arrows_of(document, scene::DiagramKind::model);
  ASSERT_EQ(arrows.size(), 1U);
  EXPECT_TRUE(arrows[0].open && arrows[0].known);
  EXPECT_NEAR(norm(Vector(arrows[0].vector - Vector{-1, 0, 0})), 0, 1e-12);
  // There is no number that could be read as its size.
  EXPECT_EQ(to_json(document).find("\"unit\": \"N\""), std::string::npos);
}

TEST(SceneStatedMotion, what_the_equations_leave_open_is_drawn_with_letters_alone) {
  // A ladder at rest between rough walls: one force too many.
  const Document document = illustrated(
      "title: t\ngiven: {L: 4 m, b: 60 deg, m: 10 kg, mu: 0.5}\npoints: {A: [0, 0, 0], B: [-L*cos(b), L*sin(b), 0]}\n"
      "bodies: {ladder: {rod: [A, B], mass: m}}\ncontacts: {floor: {of: ladder, at: A, normal: y, friction: mu}, wall: "
      "{of: ladder, at: B, normal: x, friction: mu}}\ngravity: -y\ninstants: {now: rest}\nask: {N: "
      "normal_force(floor)}\n");
  const std::vector<scene::Arrow> arrows = arrows_of(document, scene::DiagramKind::free_body);
  std::size_t open = 0;
  for (const scene::Arrow& arrow : arrows) {
    if (!arrow.open) continue;
    ++open;
    EXPECT_FALSE(arrow.known);
    EXPECT_NEAR(norm(arrow.vector), 1, 1e-12) << arrow.text;
  }
  EXPECT_EQ(open, 4U);
  const scene::Arrow *floor = named(arrows, "N_floor"), *wall = named(arrows, "N_wall"), *weight = named(arrows, "m g");
  ASSERT_TRUE(floor != nullptr && wall != nullptr && weight != nullptr);
  EXPECT_NEAR(floor->vector.y, 1, 1e-12);
  EXPECT_NEAR(wall->vector.x, 1, 1e-12);
  EXPECT_FALSE(weight->open);
}

TEST(SceneStatedMotion, a_small_letter_of_a_question_is_no_name_of_a_tension) {
  for (const auto& [ask, symbol] : {std::pair{"a", "T"}, std::pair{"S", "S"}, std::pair{"T1", "T_{1}"}}) {
    const Document document = illustrated(
        std::string(
            "title: t\npoints: {A: [0, 1 m, 0], P: [0, 0, 0]}\nbodies: {bob: {particle: P, mass: 1 kg}}\ncords: "
            "{rope: {from: ground, at: A, to: bob, end: P}}\ngravity: -y\ninstants: {now: rest}\nask: {") +
        ask + ": tension(rope)}\n");
    ASSERT_EQ(scene_of(document).links.size(), 1U);
    EXPECT_EQ(scene_of(document).links[0].symbol, symbol);
  }
}

}  // namespace scene_stated_motion_test
}  // namespace poinsot
