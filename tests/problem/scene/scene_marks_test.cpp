// What a figure marks: angles that data name, points that matter, views, events.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <tuple>

#include "poinsot/engine/mass/mesh.h"
#include "problem/scene/illustrated.h"

namespace poinsot {
namespace scene_marks_test {

using namespace scene_tests;

TEST(SceneMarks, angles_are_drawn_as_large_as_they_are_wherever_data_make_them) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> draw(5, 85);
  for (int round = 0; round < 8; ++round) {
    const double b = draw(random);
    const std::string askew =
        "title: t\ngiven: {b: " + degrees(b) +
        ", n: 3 rad/s}\npoints: {G: [0, 0, 0]}\ndirections: {across: [cos(b), sin(b), 0]}\n"
        "bodies: {d: {disk: {center: G, normal: across, radius: 1 m}, mass: 1 kg}}\n"
        "joints: {s: {revolute: x, at: G, to: d, rate: n, accel: 0}}\nask: {T: kinetic_energy(d)}\n";
    const std::string rod = "title: t\ngiven: {b: " + degrees(b) +
                            "}\npoints: {O: [0, 0, 0], A: [sin(b)*1 m, -cos(b)*1 m, 0]}\n"
                            "bodies: {r: {rod: [O, A], mass: 1 kg}}\njoints: {p: {revolute: z, at: O, to: r, rate: 1 "
                            "rad/s}}\nask: {T: kinetic_energy(r)}\n";
    const std::string turned =
        "title: t\ngiven: {b: " + degrees(b) +
        "}\npoints: {O: [0, 0, 0], A: [1 m, 0, 0]}\n"
        "bodies: {r: {rod: [O, A], mass: 1 kg}}\njoints: {p: {revolute: z, at: O, to: r, angle: b, "
        "rate: 1 rad/s}}\nask: {T: kinetic_energy(r)}\n";
    const std::string pushed = "title: t\ngiven: {b: " + degrees(b) +
                               ", P: 5 N}\npoints: {O: [0, 0, 0], A: [1 m, 0, 0]}\n"
                               "bodies: {r: {rod: [O, A], mass: 1 kg}}\nloads: {P: {body: r, at: A, force: [P*cos(b), "
                               "P*sin(b), 0]}}\ninstants: {now: rest}\nask: {a: acceleration(r)}\ngravity: none\n";
    const std::string leaning = "title: t\ngiven: {b: " + degrees(b) +
                                "}\npoints: {A: [0, 0, 0]}\ndirections: {down: [0, -cos(b), sin(b)]}\n"
                                "bodies: {r: {rectangle: {center: A + 1 m * down, sides: [1 m * x, 2 m * down]}, mass: "
                                "1 kg}}\njoints: {p: {revolute: y, at: A, to: r, rate: 1 rad/s}}\n"
                                "ask: {T: kinetic_energy(r)}\n";
    const std::string edges =
        "title: t\ngiven: {b: " + degrees(b) +
        "}\npoints: {A: [0, 0, 0]}\ndirections: {down: [0, -cos(b), sin(b)]}\nbodies: {r: {triangle: [A, A + 1 m * "
        "down, A + 1 m * x], mass: 1 kg}}\njoints: {p: {revolute: y, at: A, to: r, rate: 1 rad/s}}\n"
        "ask: {T: kinetic_energy(r)}\n";
    for (const std::string& text : {askew, rod, turned, pushed, leaning, edges}) {
      const Document document = illustrated(text);
      const scene::Dimension* angle = angle_named(scene_of(document), "b");
      ASSERT_NE(angle, nullptr) << text;
      // The text has six decimals of the degrees.
      EXPECT_NEAR(drawn_angle(scene_of(document), *angle), b * std::numbers::pi / 180, 1e-8) << text;
    }
  }
}

TEST(SceneMarks, a_steady_spin_is_an_arrow_along_its_axis_and_its_lean_is_marked) {
  const Document document = illustrated(
      "title: t\ngiven: {b: 35 deg, S: 40 rad/s, I: 0.02 kg*m^2, J: 0.05 kg*m^2}\nfind: {P: rad/s}\npoints: {G: [0, 0, "
      "0]}\ndirections: {u: [sin(b), 0, cos(b)]}\nframes: {figure: {rides_on: center(can), turns: z, rate: P}}\n"
      "bodies: {can: {mass: 2 kg, center: G, inertia: {axis: u, axial: I, transverse: J}}}\n"
      "steady: {frame: figure, spins: {can: {about: u, rate: S}}}\nwhere: [P > 0.1 rad/s]\ngravity: none\nask: {P: "
      "P}\n");
  const scene::Scene& scene = scene_of(document);
  ASSERT_FALSE(scene.diagrams.empty());
  std::size_t spins = 0;
  for (const scene::Arrow& arrow : scene.diagrams.front().arrows) {
    if (arrow.name != "can") continue;
    const double b = 35 * std::numbers::pi / 180;
    EXPECT_EQ(arrow.quantity, scene::Quantity::angular_velocity);
    EXPECT_NEAR(norm(Vector(arrow.vector - 40.0 * Vector{std::sin(b), 0, std::cos(b)})), 0, 1e-12);
    EXPECT_EQ(arrow.text, "S");
    ++spins;
  }
  EXPECT_EQ(spins, 1U);
  const scene::Dimension* lean = angle_named(scene, "b");
  ASSERT_NE(lean, nullptr);
  EXPECT_NEAR(drawn_angle(scene, *lean), 35 * std::numbers::pi / 180, 1e-12);
}

TEST(SceneMarks, an_angle_that_is_equal_by_chance_is_not_marked) {
  const Document document = illustrated(
      "title: t\ngiven: {b: 30 deg, c: 30 deg}\npoints: {O: [0, 0, 0], A: [sin(b)*1 m, -cos(b)*1 m, 0]}\n"
      "bodies: {r: {rod: [O, A], mass: 1 kg}}\njoints: {p: {revolute: z, at: O, to: r, rate: 1 rad/s}}\n"
      "ask: {T: kinetic_energy(r)*sin(c)}\n");
  EXPECT_NE(angle_named(scene_of(document), "b"), nullptr);
  EXPECT_EQ(angle_named(scene_of(document), "c"), nullptr);
}

TEST(SceneMarks, points_that_help_to_say_where_others_are_ride_with_their_body_and_idle_ones_are_left_out) {
  const Document document = illustrated(
      "title: t\ngiven: {b: 40 deg}\npoints: {O: [0, 0, 0], A: [1 m, 0, 0], Q: A + 1 m * z, Far: [9 m, 9 m, 9 m], "
      "Asked: "
      "[2 m, 0, 0]}\nbodies: {r: {wire: [O, Q], mass: 1 kg}}\njoints: {p: {revolute: y, at: O, to: r, angle: b, rate: "
      "1 rad/s}}\nask: {H: angular_momentum(r about Asked)}\n");
  const scene::Scene& scene = scene_of(document);
  std::set<std::string> names;
  for (const scene::Point& point : scene.points) {
    names.insert(point.name);
    if (point.name == "A") {
      EXPECT_EQ(point.place.body, 0);
      EXPECT_NEAR(norm(Vector(on_ground(scene, point.place) - Vector{std::cos(40 * std::numbers::pi / 180), 0,
                                                                     -std::sin(40 * std::numbers::pi / 180)})),
                  0, 1e-12);
    }
  }
  EXPECT_EQ(names, (std::set<std::string>{"O", "A", "Q", "Asked"}));
}

const scene::Dimension* length_named(const scene::Scene& scene, const std::string& name) {
  for (const scene::Dimension& dimension : scene.dimensions)
    if (!dimension.angle && dimension.name == name) return &dimension;
  return nullptr;
}

TEST(SceneMarks, lengths_stand_at_edges_that_have_them_however_they_lie) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> draw(0.3, 2);
  for (int round = 0; round < 6; ++round) {
    const double a = draw(random), b = draw(random);
    const Document document = illustrated(
        "title: t\ngiven: {a: " + std::to_string(a) + " m, b: " + std::to_string(b) +
        " m, c: 2 m, angle: 0.6 rad}\npoints:\n  O: [0, 0, 0]\n  Q: c/2*z\n  R: c/2*z + c*[0.6, 0.8, 0]\n"
        "directions: {down: [0, -cos(angle), sin(angle)]}\n"
        "bodies:\n  p: {rectangle: {center: O + a/2*down, sides: [b*x, a*down]}, mass: 1 kg}\n"
        "  w: {wire: [O, Q, R], mass: 1 kg}\n"
        "joints: {s: {revolute: y, at: O, to: p, rate: 1 rad/s}, t: {revolute: y, at: O, to: w, rate: 1 rad/s}}\n"
        "ask: {T: kinetic_energy(p)}\n");
    const scene::Scene& scene = scene_of(document);
    for (const auto& [name, value] : {std::pair{"a", a}, std::pair{"b", b}, std::pair{"c", 2.0}}) {
      const scene::Dimension* length = length_named(scene, name);
      ASSERT_NE(length, nullptr) << name;
      EXPECT_NEAR(norm(Vector(on_ground(scene, length->to) - on_ground(scene, length->from))), value, 1e-6) << name;
    }
  }
}

TEST(SceneMarks, radii_may_be_drawn_in_any_direction_across_an_axis) {
  const Document document = illustrated(
      "title: t\ngiven: {r: 0.3 m, R: 0.7 m, h: 0.2 m}\npoints: {A: [0, 0, 0], B: [2 m, 0, 0], C: [4 m, 0, 0]}\n"
      "bodies:\n  s: {sphere: {center: A, radius: r}, mass: 1 kg}\n"
      "  d: {disk: {center: B, normal: x, radius: R}, mass: 1 kg}\n"
      "  h: {hemisphere: {center: C, toward: x, radius: h}, mass: 1 kg}\n"
      "gravity: -z\ninstants: {now: rest}\nask: {T: kinetic_energy(s)}\n");
  const scene::Scene& scene = scene_of(document);
  for (const auto& [name, value, axis] :
       {std::tuple{"r", 0.3, Vector{0, 0, 1}}, std::tuple{"R", 0.7, Vector{1, 0, 0}}, std::tuple{"h", 0.2, Vector{}}}) {
    const scene::Dimension* radius = length_named(scene, name);
    ASSERT_NE(radius, nullptr) << name;
    const Vector arm = on_ground(scene, radius->to) - on_ground(scene, radius->from);
    EXPECT_NEAR(norm(arm), value, 1e-12) << name;
    EXPECT_NEAR(norm(Vector(radius->axis - axis)), 0, 1e-12) << name;
    EXPECT_NEAR(dot(arm, axis), 0, 1e-12) << name;
  }
}

TEST(SceneMarks, the_inclination_of_a_top_is_marked_at_its_tip) {
  const Document document = illustrated(
      "title: t\ngiven: {theta: 25 deg}\npoints: {O: [0, 0, 0], G: '0.1 m * [sin(theta), 0, cos(theta)]'}\n"
      "bodies: {top: {mass: 1 kg, center: G, inertia: {axis: O->G, axial: 0.01 kg*m^2, transverse: 0.02 kg*m^2}}}\n"
      "joints: {tip: {ball: O, to: top}}\ngravity: -z\ninstants: {start: rest}\nask: {T: kinetic_energy(top)}\n");
  const scene::Dimension* angle = angle_named(scene_of(document), "theta");
  ASSERT_NE(angle, nullptr);
  EXPECT_NEAR(drawn_angle(scene_of(document), *angle), 25 * std::numbers::pi / 180, 1e-12);
  EXPECT_NEAR(norm(Vector(on_ground(scene_of(document), angle->corner))), 0, 1e-12);
}

const char* hung =
    "title: t\npoints: {O: [0, 0, 0], A: [1 m, 0, 0]}\nbodies: {r: {rod: [O, A], mass: 1 kg}}\n"
    "joints: {p: {revolute: y, at: O, to: r}}\ngravity: -z\ninstants: {start: rest}\n"
    "ask: {w: angular_velocity(r) @ 0.5 s}\n";

TEST(SceneMarks, the_figure_of_the_statement_does_not_tell_what_is_to_be_found) {
  const Document hanging =
      Problem::from_file(std::string(POINSOT_SOURCE_DIR) + "/examples/textbook/18.108.yaml").illustrate();
  const scene::Dimension* angle = angle_named(scene_of(hanging), "beta");
  ASSERT_NE(angle, nullptr);
  EXPECT_EQ(angle->text, "beta");
  const Document pushed = illustrated(
      "title: t\ngiven: {m: 3 kg}\nfind: {T: s}\ngravity: none\npoints: {O: [0, 0, 0], A: [2 m, 0, 0]}\n"
      "bodies: {r: {rod: [O, A], mass: m}}\njoints: {p: {revolute: z, at: O, to: r}}\n"
      "impulses: {k: {body: r, at: A, force: [0, 7 N, 0], lasts: T}}\n"
      "instants: {before: rest, after: {angular_velocity(r).z: 1.5 rad/s}}\nask: {T: T}\n");
  const std::vector<scene::Arrow>& arrows = scene_of(pushed).diagrams.front().arrows;
  const auto push = std::ranges::find(arrows, "k", &scene::Arrow::name);
  ASSERT_NE(push, arrows.end());
  EXPECT_EQ(push->quantity, scene::Quantity::force);
  EXPECT_NEAR(push->value, 7, 1e-12);
}

TEST(SceneMarks, an_anchor_that_is_far_away_is_cut_off) {
  for (const double h : {0.3, 100.0}) {
    const Document document =
        illustrated("title: t\npoints: {O: [0, 0, 0], A: [0.1 m, 0, 0], C: [0.1 m, -" + std::to_string(h) +
                    " m, 0]}\nbodies: {r: {rod: [O, A], mass: 1 kg}}\njoints: {p: {revolute: z, at: O, to: r}}\n"
                    "springs: {s: {at: C, to: r, end: A, stiffness: 500 N/m, tension: 2 N}}\ngravity: none\n"
                    "instants: {now: rest}\nask: {a: angular_acceleration(r)}\n");
    const scene::Scene& scene = scene_of(document);
    EXPECT_EQ(scene.links.at(0).far, h > 1);
    EXPECT_LT(scene.length, 0.4);
    for (const scene::Point& point : scene.points) EXPECT_LT(norm(on_ground(scene, point.place)), 0.4);
  }
}

TEST(SceneMarks, the_view_of_the_file_is_the_direction_to_the_viewer) {
  EXPECT_FALSE(scene_of(illustrated(hung)).viewer);
  const auto viewer = [](const std::string& words) {
    const Document document = illustrated("view: " + words + "\n" + hung);
    return scene_of(document).viewer.value();
  };
  EXPECT_NEAR(norm(Vector(viewer("top") - Vector{0, 0, 1})), 0, 1e-12);
  EXPECT_NEAR(norm(Vector(viewer("front") - Vector{0, -1, 0})), 0, 1e-12);
  EXPECT_NEAR(norm(Vector(viewer("90,0") - Vector{1, 0, 0})), 0, 1e-12);
  EXPECT_NEAR(norm(Vector(viewer("0,2,0") - Vector{0, 1, 0})), 0, 1e-12);
  try {
    illustrated(std::string("view: fromt\n") + hung);
    FAIL();
  } catch (const StatementError& error) {
    EXPECT_EQ(error.diagnostics().at(0).line, 1);
    EXPECT_NE(std::string(error.what()).find("there is no view 'fromt'"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("AZIMUTH"), std::string::npos);
  }
  try {
    illustrated(std::string("view: [0, 0, 1]\n") + hung);
    FAIL();
  } catch (const StatementError& error) {
    EXPECT_NE(std::string(error.what()).find("without brackets"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("write view: top, view: 40,15 or view: 0,0,1"), std::string::npos);
  }
}

TEST(SceneMarks, arrows_of_a_motion_are_the_rates_of_its_poses) {
  const Document document = illustrated(hung);
  const scene::Motion& motion = scene_of(document).motion.value();
  ASSERT_EQ(motion.arrows.size(), 2U);
  std::size_t compared = 0;
  for (const scene::MovingArrow& arrow : motion.arrows) {
    ASSERT_EQ(arrow.vectors.size(), motion.times.size());
    for (std::size_t k = 1; k + 1 < motion.times.size(); ++k) {
      const double step = motion.times[k + 1] - motion.times[k - 1];
      const auto place = [&](std::size_t i) {
        const scene::Pose& pose = motion.poses[i][0];
        return Vector(pose.R * arrow.at.at + pose.p);
      };
      Vector rate = (place(k + 1) - place(k - 1)) / step;
      if (arrow.quantity == scene::Quantity::angular_velocity) {
        // The axial vector of dR/dt R^T.
        const Matrix3<double> d = motion.poses[k + 1][0].R * transpose(motion.poses[k][0].R) -
                                  motion.poses[k - 1][0].R * transpose(motion.poses[k][0].R);
        rate = Vector{d(2, 1) - d(1, 2), d(0, 2) - d(2, 0), d(1, 0) - d(0, 1)} / (2 * step);
      }
      EXPECT_NEAR(norm(Vector(rate - arrow.vectors[k])), 0, 2e-3 * (1 + norm(rate))) << motion.times[k];
      ++compared;
    }
  }
  EXPECT_GT(compared, 100U);
}

TEST(SceneMarks, cords_that_go_slack_are_events_of_the_motion) {
  const Document document = illustrated(
      "title: t\npoints: {O: [0, 0, 0], A: [1 m, 0, 0]}\nbodies: {b: {particle: A, mass: 1 kg}}\n"
      "cords: {c: {from: ground, at: O, to: b, end: A}}\ngravity: -z\n"
      "instants: {start: {velocity(b): [0, 0, 3.5 m/s]}}\nask: {v: velocity(b) @ 0.9 s}\n");
  const scene::Motion& motion = scene_of(document).motion.value();
  const auto slack = std::find_if(motion.events.begin(), motion.events.end(),
                                  [](const scene::Event& event) { return event.words == "the cord 'c' goes slack"; });
  ASSERT_NE(slack, motion.events.end());
  // v^2 = v0^2 - 2 g z, and the cord pulls no more where v^2 = g z: z = v0^2 / (3 g).
  const double z = 3.5 * 3.5 / (3 * 9.80665);
  double nearest = 1e9, height = 0;
  for (std::size_t k = 0; k < motion.times.size(); ++k)
    if (std::abs(motion.times[k] - slack->time) < nearest) {
      nearest = std::abs(motion.times[k] - slack->time);
      height = (motion.poses[k][0].R * scene_of(document).bodies[0].center + motion.poses[k][0].p).z;
    }
  EXPECT_NEAR(height, z, 0.02);
}

// A heavy wheel turns, but the straight parts of its cord stay where they come to it.
TEST(SceneMarks, cords_do_not_turn_with_the_wheels_that_they_turn) {
  const Document document = illustrated(
      "title: t\ngiven: {r: 0.2 m}\npoints: {O: [0, 0, 0], A: [-r, -1 m, 0], B: [r, -1 m, 0]}\nbodies: {a: {particle: "
      "A, mass: 1 kg}, b: {particle: B, mass: 2 kg}, wheel: {disk: {center: O, normal: z, radius: r}, mass: 1 kg}}\n"
      "joints: {axle: {revolute: z, at: O, to: wheel}}\ncords: {rope: {from: a, at: A, over: [wheel], to: b, end: "
      "B}}\ngravity: -y\ninstants: {start: rest}\nask: {v: velocity(a).y @ 0.3 s}\n");
  const scene::Scene& scene = scene_of(document);
  const scene::Motion& motion = scene.motion.value();
  ASSERT_EQ(motion.links.size(), 2U);
  std::size_t compared = 0;
  for (const scene::MovingLink& moving : motion.links) {
    ASSERT_EQ(scene.links.at(moving.link).name, "rope");
    ASSERT_EQ(moving.from.size(), motion.times.size());
    for (std::size_t k = 0; k < motion.times.size(); ++k) {
      // The one end is at a block, wherever it has come; the other at the wheel's side, to the left or right.
      for (const Vector& end : {moving.from[k], moving.to[k]}) {
        const bool left = end.x < 0;
        EXPECT_NEAR(end.x, left ? -0.2 : 0.2, 1e-9);
        const scene::Pose& block = motion.poses[k][left ? 0 : 1];
        const double height = (block.R * scene.bodies[left ? 0 : 1].center + block.p).y;
        EXPECT_LE(std::min(std::abs(end.y), std::abs(end.y - height)), 1e-9) << motion.times[k];
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 100U);
}

// Bob and weight hang from the ends of a cord through two eyelets: at each time the links end on their bodies.
TEST(SceneMarks, cords_keep_their_ends_on_their_bodies_as_they_move) {
  const Document document = illustrated(
      "title: t\npoints: {E: [0, 0, 0], F: [-2 m, 0, 0], A: [1 m, 0, 0], B: [-2 m, -2 m, 0]}\nbodies: {bob: {particle: "
      "A, "
      "mass: 1 kg}, weight: {particle: B, mass: 3 kg}}\ncords: {rope: {from: bob, at: A, over: [E, F], to: weight, "
      "end: "
      "B}}\ngravity: -y\ninstants: {start: rest}\nask: {v: velocity(weight).y @ 0.3 s}\n");
  const scene::Scene& scene = scene_of(document);
  const scene::Motion& motion = scene.motion.value();
  std::size_t compared = 0;
  for (const scene::MovingLink& moving : motion.links)
    for (std::size_t k = 0; k < motion.times.size(); ++k) {
      const scene::Link& link = scene.links.at(moving.link);
      for (const auto& [place, at] : {std::pair(&link.from, moving.from[k]), std::pair(&link.to, moving.to[k])}) {
        if (place->body < 0) continue;
        const scene::Pose& pose = motion.poses[k][static_cast<std::size_t>(place->body)];
        EXPECT_LE(norm(Vector(pose.R * place->at + pose.p - at)), 1e-9) << motion.times[k];
        ++compared;
      }
    }
  EXPECT_GT(compared, 20U);
}

TEST(SceneMarks, long_cords_are_cut_off_by_the_size_of_the_figure) {
  for (const double size : {0.01, 1.0, 300.0}) {
    const Document document =
        illustrated("title: t\ngiven: {L: " + std::to_string(size) +
                    " m}\npoints: {A: [0, 0, 0], B: [0, 0, -L]}\nbodies: {b: {rod: [A, B], mass: 1 kg}}\n"
                    "cords: {c: {holds: b, at: A, pulls: +z}}\ngravity: -z\n"
                    "instants: {start: rest}\nask: {a: acceleration(b)}\n");
    const scene::Link& cord = scene_of(document).links.at(0);
    EXPECT_TRUE(cord.far);
    const Vector d = on_ground(scene_of(document), cord.to) - on_ground(scene_of(document), cord.from);
    EXPECT_NEAR(d.z, 0.4 * size, 1e-9 * size);
    EXPECT_NEAR(norm(d), d.z, 1e-9 * size);
  }
}

TEST(SceneMarks, a_couple_that_is_small_beside_the_spin_is_drawn_with_what_it_does) {
  const Document document = illustrated(
      "title: t\ngiven: {n: 100 rad/s, p: 1e-6 rad/s}\nfind: {M: {vector: N*m}}\ngravity: none\n"
      "points: {G: [0, 0, 0]}\nbodies: {s: {sphere: {center: G, radius: 1 m}, mass: 1 kg}}\n"
      "loads: {sun: {couple: M, body: s}}\nframes: {f: {rides_on: center(s), turns: z, rate: p}}\n"
      "steady: {frame: f, spins: {s: {about: '[0.6, 0, 0.8]', rate: n}}}\nask: {a: norm(load(sun))}\n");
  std::size_t arrows = 0;
  for (const scene::Diagram& diagram : scene_of(document).diagrams) {
    if (diagram.kind != scene::DiagramKind::free_body && diagram.kind != scene::DiagramKind::kinetic) continue;
    ASSERT_EQ(diagram.arrows.size(), 1U);
    // I p n sin: the precession turns the angular momentum of the spin.
    EXPECT_NEAR(norm(diagram.arrows[0].vector), 0.4 * 1e-6 * 100 * 0.6, 1e-3 * 24e-6);
    ++arrows;
  }
  EXPECT_EQ(arrows, 2U);
}

TEST(SceneMarks, each_situation_has_a_scene) {
  const Document document = illustrated(
      "title: t\npoints: {O: [0, 0, 0], A: [1 m, 0, 0], B: [0, 1 m, 0]}\ngravity: none\nsituations:\n"
      "  long: {bodies: {r: {rod: [O, A], mass: 1 kg}}, joints: {p: {revolute: z, at: O, to: r, rate: 1 rad/s}}}\n"
      "  upright: {bodies: {r: {rod: [O, B], mass: 1 kg}}, joints: {p: {revolute: z, at: O, to: r, rate: 2 rad/s}}}\n"
      "ask: {T: kinetic_energy(r) @ upright, U: kinetic_energy(r) @ long}\n");
  const Solution& solution = document.solutions.at(0);
  EXPECT_EQ(solution.scene->situation, "upright");
  ASSERT_EQ(solution.other_scenes.size(), 1U);
  EXPECT_EQ(solution.other_scenes[0]->situation, "long");
  EXPECT_NEAR(solution.other_scenes[0]->bodies.at(0).center.x, 0.5, 1e-12);
}

}  // namespace scene_marks_test
}  // namespace poinsot
