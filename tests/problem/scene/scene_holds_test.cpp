// Where scenes show what holds bodies: bearings on axes, hinges, obstructions, springs of joints, friction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "problem/keys/joint_kinds.h"
#include "problem/scene/illustrated.h"
#include "problem/scene/scene_words.h"

namespace poinsot {
namespace scene_holds_test {

using namespace scene_tests;

std::vector<double> places_along_z(const std::string& joint) {
  const Document document = illustrated(
      "title: t\npoints: {A: [0, 0, -1 m], B: [0, 0, 2 m], C: [0, 0, 0.5 m], E: [0.1 m, 0, 0]}\n"
      "bodies: {r: {box: {center: [0, 0, 0], sides: [1 m * x, 1 m * y, 6 m * z]}, mass: 1 kg}}\njoints: {p: {" +
      joint + ", to: r, rate: 1 rad/s, accel: 0}}\ngravity: none\nask: {T: kinetic_energy(r)}\n");
  std::vector<double> places;
  for (const scene::Symbol& symbol : scene_of(document).symbols)
    places.push_back(on_ground(scene_of(document), symbol.place).z);
  std::ranges::sort(places);
  return places;
}

TEST(SceneHolds, every_kind_of_joint_and_support_has_a_symbol_and_its_parts_in_space) {
  const std::string path = std::string(POINSOT_SOURCE_DIR) + "/web/src/view/symbols.ts";
  std::ostringstream source;
  source << std::ifstream(path).rdbuf();
  const std::string parts = source.str();
  ASSERT_NE(parts.find("rolling_contact: ["), std::string::npos) << path;
  for (const problem::JointKind& kind : problem::joint_kinds())
    EXPECT_TRUE(problem::kind_of_word<scene::SymbolKind>(kind.name)) << kind.name << ": scene.h and scene_words.h";
  for (const problem::SupportKind& kind : problem::support_kinds())
    EXPECT_TRUE(problem::kind_of_word<scene::SymbolKind>(kind.name)) << kind.name << ": scene.h and scene_words.h";
  for (const std::string_view word : problem::words_of(scene::SymbolKind{}))
    EXPECT_NE(parts.find("\n  " + std::string(word) + ": ["), std::string::npos) << word << ": " << path;
}

TEST(SceneHolds, an_axis_between_two_points_holds_its_body_at_both) {
  EXPECT_EQ(places_along_z("revolute: A->B"), (std::vector<double>{-1, 2}));
  EXPECT_EQ(places_along_z("revolute: A->B, at: C"), (std::vector<double>{-1, 2}));
  // A place that is told at one end, beside the axis or beyond it is where the body is held.
  EXPECT_EQ(places_along_z("revolute: A->B, at: B"), (std::vector<double>{2}));
  EXPECT_EQ(places_along_z("revolute: A->B, at: E"), (std::vector<double>{0}));
  EXPECT_EQ(places_along_z("revolute: A->C, at: B"), (std::vector<double>{2}));
  EXPECT_EQ(places_along_z("revolute: z, at: C"), (std::vector<double>{0.5}));
}

TEST(SceneHolds, a_hinge_that_is_told_far_along_its_axis_stands_where_the_axis_is_nearest_to_its_bodies) {
  const auto hinge = [](double told) {
    const Document document = illustrated(
        "title: t\npoints: {R: [0, 0, 0], F: [2 m, 0, 0], B: [0.7 m, 1 m, 0], H: [1.4 m, 0.9 m, 0], S: [1 m, " +
        std::to_string(told) +
        " m, 0]}\nbodies: {a: {mass: 2 kg, center: B, inertia: {x: 3 kg*m^2, y: 4 kg*m^2, z: 5 kg*m^2, xy: 0, yz: 0, "
        "zx: 0}}, b: {mass: 2 kg, center: H, inertia: {x: 3 kg*m^2, y: 4 kg*m^2, z: 5 kg*m^2, xy: 0, yz: 0, zx: 0}}}\n"
        "joints: {rear: {ball: R, to: a}, head: {revolute: y, at: S, from: a, to: b}, front: {ball: F, to: b}}\n"
        "gravity: none\ninstants: {now: rest}\nask: {T: kinetic_energy(a)}\n");
    const scene::Scene& scene = scene_of(document);
    const auto found = std::ranges::find(scene.symbols, std::string("head"), &scene::Symbol::name);
    return on_ground(scene, found->place);
  };
  EXPECT_LT(norm(Vector(hinge(-2) - Vector{1, 0.95, 0})), 1e-9);
  EXPECT_LT(norm(Vector(hinge(3) - Vector{1, 0.95, 0})), 1e-9);
  // What is told near to them stays.
  EXPECT_LT(norm(Vector(hinge(0.8) - Vector{1, 0.8, 0})), 1e-9);
}

TEST(SceneHolds, what_a_body_hits_is_drawn_under_the_point_that_hits) {
  const Document document = illustrated(
      "title: t\npoints: {G: [0, 0, 0], C: [1 m, 0, -0.5 m]}\n"
      "bodies: {plate: {rectangle: {center: G, sides: [2 m * x, 1 m * z]}, mass: 1 kg}}\n"
      "impacts: {stop: {of: plate, against: ground, at: C, pushes: +y, restitution: 0}}\n"
      "instants: {before: {velocity(plate): [0, -2 m/s, 0], angular_velocity(plate): [0, 0, 0]}}\n"
      "ask: {a: angular_velocity(plate)}\n");
  const scene::Scene& scene = scene_of(document);
  ASSERT_EQ(scene.symbols.size(), 1U);
  EXPECT_EQ(scene.symbols[0].kind, scene::SymbolKind::contact);
  EXPECT_LT(norm(Vector(on_ground(scene, scene.symbols[0].place) - Vector{1, 0, -0.5})), 1e-12);
  EXPECT_LT(norm(Vector(scene.symbols[0].axis - Vector{0, 1, 0})), 1e-12);
}

TEST(SceneHolds, springs_and_dampers_of_joints_are_drawn) {
  const auto links = [](const std::string& joint) {
    return scene_of(illustrated("title: t\npoints: {O: [0, 0, 0], G: [0.5 m, 0, 0]}\n"
                                "bodies: {r: {rod: [O, 2*G], mass: 1 kg}}\njoints: {p: {" +
                                joint + "}}\ngravity: none\ninstants: {now: rest}\nask: {T: kinetic_energy(r)}\n"))
        .links;
  };
  const auto slide = links(
      "prismatic: x, at: O, to: r, displacement: s, spring: {stiffness: 3 N/m, free_displacement: 0 m}, "
      "damping: 2 N*s/m");
  ASSERT_EQ(slide.size(), 2U);
  EXPECT_EQ(slide[0].kind, scene::LinkKind::spring);
  EXPECT_EQ(slide[1].kind, scene::LinkKind::damper);
  for (const scene::Link& link : slide) {
    EXPECT_EQ(link.from.body, scene::ground);
    EXPECT_EQ(link.to.body, 0);
    EXPECT_LT(norm(link.to.at), 1e-12);
    EXPECT_GT(std::abs(link.from.at.x), 0.1);
    EXPECT_LT(std::hypot(link.from.at.y, link.from.at.z), 1e-12);
  }
  const auto hinge = links("revolute: z, at: O, to: r, angle: q, spring: {stiffness: 3 N*m/rad, free_angle: 0 rad}");
  ASSERT_EQ(hinge.size(), 1U);
  EXPECT_EQ(hinge[0].kind, scene::LinkKind::torsion);
  EXPECT_TRUE(links("prismatic: x, at: O, to: r, displacement: s").empty());
}

std::vector<std::string> coefficients(const std::string& friction, const std::string& rest = "") {
  const Document document =
      illustrated("title: t\ngiven: {mu: 0.5, k: 0.4" + rest +
                  "}\npoints: {C: [0, 0, 0]}\nbodies: {b: {particle: C, mass: 1 kg}}\n"
                  "contacts: {floor: {of: b, at: C, normal: y, friction: " +
                  friction + "}}\ngravity: -y\ninstants: {now: rest}\nask: {a: acceleration(b).x}\n");
  std::vector<std::string> texts;
  const scene::Scene& scene = scene_of(document);
  for (const scene::Dimension& dimension : scene.dimensions)
    if (norm(Vector(on_ground(scene, dimension.from) - on_ground(scene, dimension.to))) == 0)
      texts.push_back(dimension.text);
  return texts;
}

TEST(SceneHolds, coefficients_of_friction_stand_at_what_is_touched) {
  EXPECT_EQ(coefficients("mu"), (std::vector<std::string>{"mu = 0.5"}));
  EXPECT_EQ(coefficients("{static: mu, kinetic: k}"), (std::vector<std::string>{"mu_s = 0.5, mu_k = 0.4"}));
  EXPECT_EQ(coefficients("k"), (std::vector<std::string>{"mu = 0.4"}));
  EXPECT_EQ(coefficients("mu1", ", mu1: 0.2"), (std::vector<std::string>{"mu1 = 0.2"}));
  EXPECT_EQ(coefficients("{static: mu1, kinetic: mu2}", ", mu1: 0.2, mu2: 0.1"),
            (std::vector<std::string>{"mu1 = 0.2, mu2 = 0.1"}));
  EXPECT_EQ(coefficients("0.3"), (std::vector<std::string>{"mu = 0.3"}));
  EXPECT_EQ(coefficients("mu*k"), (std::vector<std::string>{"mu = mu*k"}));
}

TEST(SceneHolds, an_impulse_that_has_no_symbol_of_its_own_is_a_force_with_its_time) {
  const auto texts = [](const std::string& name, const std::string& size) {
    const Document document = illustrated(
        "title: t\ngiven: {P: 5 N*s, F: 5 N, dt: 1 s}\npoints: {O: [0, 0, 0], A: [1 m, 0, 0]}\n"
        "bodies: {r: {rod: [O, A], mass: 1 kg}}\nimpulses: {" +
        name + ": {body: r, at: A, along: y, " + size +
        "}}\ninstants: {before: rest}\ngravity: none\nask: {w: angular_velocity(r)}\n");
    std::vector<std::string> found;
    for (const scene::Diagram& diagram : scene_of(document).diagrams)
      for (const scene::Arrow& arrow : diagram.arrows)
        if (arrow.quantity == scene::Quantity::impulse) found.push_back(arrow.symbol);
    return found;
  };
  const auto of_force = texts("blow", "force: F, lasts: dt"), named = texts("P", "force: F, lasts: dt");
  ASSERT_GE(of_force.size(), 2U);
  for (const std::string& symbol : of_force) EXPECT_TRUE(symbol.ends_with("\\Delta t")) << symbol;
  for (const std::string& symbol : named) EXPECT_FALSE(symbol.ends_with("\\Delta t")) << symbol;
}

TEST(SceneHolds, a_wall_that_is_met_later_stands_where_it_will_be_met) {
  const auto walls = [](const std::string& surface) {
    const Document document = illustrated(
        "title: t\ngiven: {L: 0.9 m, a: 60 deg}\npoints: {O: [0, 0, 0], B: [0, -L, 0], W: [-0.1 m, -L, 0]}\n"
        "bodies: {rod: {rod: [O, B], mass: 3 kg}}\njoints: {hinge: {revolute: z, at: O, to: rod, angle: th}}\n"
        "contacts: {wall: {of: rod, at: B, normal: x, open: true, restitution: 0.8" +
        surface + "}}\ngravity: -y\ninstants: {start: {th: a, th': 0}}\nask: {first: {first_time: th' > 0}}\n");
    std::vector<scene::Symbol> found;
    for (const scene::Symbol& symbol : scene_of(document).symbols)
      if (symbol.kind == scene::SymbolKind::contact) found.push_back(symbol);
    return found;
  };
  for (const auto& [surface, x] : {std::pair{"", 0.0}, std::pair{", surface: W", -0.1}}) {
    const std::vector<scene::Symbol> found = walls(surface);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].from, scene::ground);
    EXPECT_EQ(found[0].to, scene::ground);
    EXPECT_LT(norm(Vector(found[0].place.at - Vector{x, -0.9, 0})), 1e-12);
    EXPECT_LT(norm(Vector(found[0].axis - Vector{1, 0, 0})), 1e-12);
  }
}

}  // namespace scene_holds_test
}  // namespace poinsot
