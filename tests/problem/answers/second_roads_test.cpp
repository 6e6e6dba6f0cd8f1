// Answers for which particles, springs as stated or a second spectrum stand beside the first road: they have it, and it
// confirms them, at other letters too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "problem/course/motion_support.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {
namespace second_roads_test {

void confirmed(const SolvedText& solved) {
  const auto& checks = solved.solved().solutions.at(0).checks;
  ASSERT_TRUE(checks.contains("quantities"));
  EXPECT_LT(checks.at("quantities"), 1e-11);
}

const std::string sprung = R"(
points: {A: [0, 0, 0], B: [0.5 m, 0, 0], C: [0.5 m, 0.3 m, 0], D: [-0.2 m, 0.4 m, 0]}
given: {k: 300 N/m}
bodies: {arm: {rod: [A, B], mass: 2 kg}}
joints: {hinge: {revolute: z, at: A, to: arm, angle: q, spring: {stiffness: 5 N*m/rad, free_angle: 10 deg}}}
springs:
  one: {from: ground, at: C, to: arm, end: B, stiffness: k, free_length: 100 mm}
  two: {from: ground, at: D, to: arm, end: B, stiffness: 2*k, tension: 20 N}
  twist: {from: ground, to: arm, about: z, stiffness: 3 N*m/rad, free_angle: 5 deg}
gravity: -y
instants: {now: {q: 20 deg, q': 2 rad/s}}
)";

TEST(SecondRoads, EnergiesInSpringsHaveOneEach) {
  const double q = 20 * std::acos(-1) / 180;
  const double turned = 10 * std::acos(-1) / 180, twist = 15 * std::acos(-1) / 180;
  const double end_x = 0.5 * std::cos(q), end_y = 0.5 * std::sin(q);
  const double one = std::hypot(end_x - 0.5, end_y - 0.3) - 0.1;
  const double two = std::hypot(end_x + 0.2, end_y - 0.4) - (std::hypot(0.7, 0.4) - 20.0 / 600);
  const std::pair<const char*, double> energies[] = {{"one", 300 * one * one / 2},
                                                     {"two", 600 * two * two / 2},
                                                     {"twist", 3 * twist * twist / 2},
                                                     {"hinge", 5 * turned * turned / 2}};
  for (const auto& [name, energy] : energies) {
    const SolvedText solved(sprung + "ask: {V: potential_energy(" + name + ")}\n");
    EXPECT_NEAR(solved.number("V"), energy, 1e-12) << name;
    confirmed(solved);
  }
}

TEST(SecondRoads, RatesOfEnergiesAndMomentaHaveOne) {
  const SolvedText solved(sprung +
                          "ask: {V: rate(potential_energy(system)), T: rate(kinetic_energy(arm)), "
                          "H: rate(angular_momentum(arm about B of arm)), P: rate(momentum(arm))}\n");
  EXPECT_NEAR(solved.number("V") + solved.number("T"), 0, 1e-11);
  confirmed(solved);
}

TEST(SecondRoads, DrivesAndTensionsHaveOne) {
  const SolvedText solved(R"(
points: {O: [0, 0, 0], A: [0.4 m, 0, 0], P: [0.6 m, 0.1 m, 0], W: [0, 1 m, 0], C: [0, 2 m, 0]}
bodies:
  arm: {rod: [O, A], mass: 2 kg}
  disk: {disk: {center: A, normal: x, radius: 100 mm}, mass: 3 kg}
  bob: {particle: P, mass: 1 kg}
  hung: {particle: W, mass: 2 kg}
joints:
  column: {revolute: y, at: O, to: arm, rate: 4 rad/s, accel: 1 rad/s^2}
  axle: {revolute: x, at: A, from: arm, to: disk, rate: 20 rad/s, accel: 2 rad/s^2}
  rail: {prismatic: x, at: P, from: arm, to: bob, rate: 2 m/s, accel: 1 m/s^2}
cords: {c: {at: C, to: hung, end: W}}
gravity: -y
instants: {now: {velocity(hung): 0}}
ask: {M: drive(column), Ma: drive(axle), F: drive(rail), T: tension(c)}
)");
  EXPECT_NEAR(solved.vector("Ma").x, 0.03, 1e-14);
  EXPECT_NEAR(solved.vector("F").x, 1 - 16 * 0.6, 1e-12);
  EXPECT_NEAR(solved.number("T"), 2 * 9.80665, 1e-12);
  confirmed(solved);
}

// Each by itself, so that it is the one that is confirmed.
TEST(SecondRoads, PlacesAnglesAndRadiiHaveOneEach) {
  const std::string swung = R"(
points: {O: [0, 0, 0], A: [0.4 m, 0, 0], B: [0.4 m, 0, 0.3 m], P: [0.5 m, 0.6 m, 0.2 m]}
bodies: {plate: {triangle: [O, A, B], mass: 3 kg}}
joints: {hinge: {revolute: O->B, to: plate, angle: 40 deg, rate: 2 rad/s}}
gravity: [0, -9.7 m/s^2, 0]
)";
  for (const char* ask :
       {"A of plate", "position(A of plate)", "axis(hinge)", "distance(A of plate to P)", "distance(P to O->A)",
        "distance(A of plate to axis(hinge))", "direction_angles(position(A of plate))", "weight(plate)",
        "radius_of_gyration(plate about O->A)", "principal_axes(plate about O)", "axis_stability(plate)",
        "rate(position(A of plate))", "{of: position(A of plate), axes: plate}"}) {
    SCOPED_TRACE(ask);
    confirmed(SolvedText(swung + "ask: {a: " + ask + "}\n"));
  }
  const SolvedText solved(swung + "ask: {w: weight(plate), d: distance(A of plate to axis(hinge))}\n");
  EXPECT_NEAR(solved.number("w"), 29.1, 1e-12);
  EXPECT_NEAR(solved.number("d"), 0.4 * 0.3 / 0.5, 1e-14);
}

TEST(SecondRoads, FrictionPushesAndSlipsHaveOneEach) {
  for (const char* ask : {"normal_force(floor)", "friction(floor on crate)", "friction(floor on belt)",
                          "slip_velocity(floor)", "load(pull)"}) {
    SCOPED_TRACE(ask);
    confirmed(SolvedText(std::string(R"(
points: {O: [0, -0.5 m, 0], C: [1 m, 0, 0]}
bodies: {belt: {box: {center: O, sides: [4 m * x, 1 m * y, 2 m * z]}, mass: 4 kg}, crate: {particle: C, mass: 2 kg}}
joints: {rail: {prismatic: x, at: O, to: belt, displacement: s}}
contacts: {floor: {of: crate, against: belt, at: C, normal: y, friction: 0.3}}
loads: {pull: {force: [2 N, -3 N, 1 N], body: crate}}
gravity: -y
instants: {now: {s': 1 m/s, velocity(crate): [3 m/s, 0, 1 m/s]}}
ask: {a: )") + ask + "}\n"));
  }
}

// Rows over a datum are problems of their own, which are confirmed as others are.
TEST(SecondRoads, RowsOfTablesAreConfirmed) {
  const SolvedText solved(R"(
given: {n: 3 rad/s}
points: {O: [0, 0, 0], A: [0.5 m, 0.2 m, 0]}
bodies: {arm: {rod: [O, A], mass: 2 kg}}
joints: {up: {revolute: x, at: O, to: arm, rate: n, accel: 1 rad/s^2}}
gravity: none
ask: {t: {table: {n: n, H: norm(rate(angular_momentum(arm about O)))}, over: {n: '1 rad/s .. 40 rad/s by 1 rad/s'}}}
)");
  ASSERT_EQ(solved.column("t", 1).size(), 40U);
  const double I = 2 * 0.04 / 3, product = 2 * 0.1 / 3;
  for (std::size_t i = 0; i < 40; ++i) {
    const double n = 1 + static_cast<double>(i);
    EXPECT_NEAR(solved.column("t", 1)[i], std::hypot(I, std::hypot(product, product * n * n)), 1e-9);
  }
}

// The particle belongs to the bar from the blow on: its own particles alone would have another momentum.
TEST(SecondRoads, WhatABodyTakesUpBelongsToIt) {
  const SolvedText solved(R"(
gravity: none
points: {O: [0, 0, 0], B: [0.6 m, 0, 0], S: [0.5 m, 0, 0]}
bodies: {bar: {rod: [O, B], mass: 4 kg}}
joints: {hinge: {revolute: z, at: O, to: bar, angle: q}}
strikes: {shot: {mass: 20 g, hits: bar, at: S, velocity: [0, 300 m/s, 0], stays: true}}
instants: {before: {q': 1 rad/s}}
ask: {T: kinetic_energy(bar) @ after, H: angular_momentum(bar about O) @ after}
)");
  const double I = 4 * 0.36 / 3 + 0.02 * 0.25, H = 4 * 0.36 / 3 + 0.02 * 0.5 * 300;
  EXPECT_NEAR(solved.vector("H").z, H, 1e-12);
  EXPECT_NEAR(solved.number("T"), H * H / (2 * I), 1e-11);
  confirmed(solved);
}

// Nothing exists where the forces of two loads cannot balance, and the particles confirm the equations that say so.
TEST(SecondRoads, WhereNothingExistsTheEquationsAreConfirmed) {
  const SolvedStatement solved = solve_statement(read_statement(R"(
find: {n: rad/s}
where: [0 rad/s < n < 5 rad/s]
points: {O: [0, 0, 0], A: [0.3 m, 1 m, 0.2 m]}
bodies: {one: {rod: [O, A], mass: 2 kg}}
joints: {up: {revolute: z, at: O, to: one, angle: a}}
gravity: -y
instants: {now: {a: 20 deg, a': n, norm(reaction(up)): 900 N}}
ask: {n: n}
)",
                                                                "test.yaml"),
                                                 {});
  EXPECT_TRUE(solved.solutions.empty());
  ASSERT_FALSE(solved.warnings.empty());
  EXPECT_EQ(solved.warnings.front().find("do not confirm"), std::string::npos) << solved.warnings.front();
}

// Trial values meet no equations: what these leave over is what the particles need besides.
TEST(SecondRoads, TrialValuesAreHeldAgainstWhatTheyLeaveOver) {
  const Statement statement = read_statement(R"(
points: {O: [0, 0, 0], A: [0.3 m, 1 m, 0.2 m], C: [0.1 m, 0.2 m, 0.3 m]}
bodies: {one: {parts: {a: {rod: [O, A], mass: 2 kg}, b: {sphere: {center: C, radius: 50 mm}, mass: 1 kg}}}}
joints: {up: {revolute: z, at: O, to: one, angle: a}}
gravity: -y
instants: {now: {a: 20 deg, a': 2 rad/s, force(up on one).x: 300 N, acceleration(one).y: 7 m/s^2}}
ask: {n: force(up on one)}
)",
                                             "test.yaml");
  OpenChoice choice;
  choice.trial = choice.particles = true;
  SolvedInstant instant(statement.situations.front(), {}, When{}, choice);
  instant.solve_forces();
  EXPECT_GT(std::abs(*std::ranges::max_element(instant.misfits(), {}, [](double x) { return std::abs(x); })), 0.01);
  EXPECT_LT(instant.check().particles.newton_euler, 1e-11);
}

// Where all stands at one point no arm gives moments a size.
// Two halves of a particle, welded somewhere else: their turning moves no mass and is none.
TEST(SecondRoads, HalvesOfAParticleFallLikeOne) {
  const std::string machine =
      "title: t\ngiven: {r: 200 mm}\npoints: {O: [0, 0, 0], A: [-r, -4 m, 0], B: [r, -0.5 m, 0]}\nbodies:\n"
      "  light: {particle: A, mass: 3 kg}\n  wheel: {disk: {center: O, normal: z, radius: r}, mass: 2 kg}\n";
  const std::string rest = "joints:\n  axle: {revolute: z, at: O, to: wheel}\n";
  const std::string cord =
      "cords: {rope: {from: light, at: A, over: [wheel], to: heavy, end: B}}\ngravity: -y\n"
      "instants: {now: rest}\nask: {y: center(light).y @ 1.7 s}\n";
  const SolvedText whole(machine + "  heavy: {particle: B, mass: 5 kg}\n" + rest + cord);
  const SolvedText halves(machine + "  heavy: {particle: B, mass: 2.5 kg}\n  half: {particle: B, mass: 2.5 kg}\n" +
                          rest + "  seam: {weld: [0, 0, 0], from: heavy, to: half}\n" + cord);
  EXPECT_NEAR(whole.number("y"), -4 + 0.5 * 2 * 9.80665 / 9 * 1.7 * 1.7, 1e-9);
  EXPECT_NEAR(halves.number("y"), whole.number("y"), 1e-9);
}

TEST(SecondRoads, TwoParticlesAtTheOriginAreConfirmed) {
  const SolvedText solved(R"(
points: {C: [0, 0, 0]}
bodies: {one: {particle: C, mass: 10 kg}, other: {particle: C, mass: 5 kg}}
contacts: {floor: {of: one, at: C, normal: y}}
joints: {seam: {weld: C, from: one, to: other}}
gravity: -y
instants: {now: rest}
ask: {N: force(floor on one), W: force(seam on other)}
)");
  EXPECT_NEAR(solved.vector("N").y, 15 * 9.80665, 1e-11);
  EXPECT_NEAR(solved.vector("W").y, 5 * 9.80665, 1e-11);
}

}  // namespace second_roads_test
}  // namespace poinsot::problem
