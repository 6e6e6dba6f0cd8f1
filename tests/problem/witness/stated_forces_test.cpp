// Loads, springs, dampers and motors as they are stated, against formulas by hand in random poses, and against the laws
// of force in random problem files.
#include "problem/witness/stated_forces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>

#include "problem/course/motion_support.h"
#include "problem/entries/random_problems.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {
namespace stated_forces_test {

using Vector = StatedForce::Vector;
using Real = StatedForce::Real;

// The stated forces of an instant, by the names of their actions.
std::map<std::string, StatedForce> forces_of(const SolvedInstant& instant, DataScope<double>& data) {
  const Machine& machine = instant.machine();
  std::vector<solve::ParticlePaths::Body> bodies;
  for (const auto& [link, mass] : machine.masses) bodies.push_back({link, &mass.particles});
  const std::vector<double> v = instant.state().v, none(v.size(), 0.0);
  const solve::ParticlePaths paths(machine.links, bodies, machine.q, v, none);
  std::map<std::string, StatedForce> found;
  for (const StatedForce& force : stated_forces(paths, machine, data, v, std::nullopt))
    found.emplace(machine.mechanism.actions[force.action].name, force);
  return found;
}

void expect_near(const Vector& found, const Vector& expected, const std::string& words) {
  const double size = 1 + static_cast<double>(norm(expected));
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(static_cast<double>(found[k]), static_cast<double>(expected[k]), 1e-11 * size) << words << ", " << k;
}

std::string swinging(double turn, double rate) {
  return R"(
points: {O: [0, 0, 0], A: [0.5 m, 0, 0], C: [0.5 m, 0.3 m, 0]}
given: {turned: )" +
         std::to_string(turn) + " rad, w: " + std::to_string(rate) + R"( rad/s, n: 3 rad/s}
bodies:
  arm: {rod: [O, A], mass: 2 kg}
  disk: {disk: {center: O, normal: z, radius: 200 mm}, mass: 1 kg}
joints:
  hinge:
    revolute: z
    at: O
    to: arm
    angle: q
    couple: 4 N*m - (2 N*m*s/rad)*q'
    spring: {stiffness: 5 N*m/rad, free_angle: 0.2 rad}
    damping: 0.7 N*m*s/rad
  table: {revolute: z, at: O, to: disk, rate: n}
springs:
  pull: {from: ground, at: C, to: arm, end: A, stiffness: 300 N/m, free_length: 100 mm, damping: 6 N*s/m}
  twist: {from: disk, to: arm, about: z, stiffness: 3 N*m/rad, free_angle: 0.1 rad, damping: 0.4 N*m*s/rad}
loads:
  fixed: {force: 12 N, along: [3, 4, 0], body: arm, at: A}
  riding: {force: [3 N, 4 N, 0], body: arm, at: A, axes: arm}
  weight: {force: [0, 0, 5 N], body: arm}
  drag: {force: -(2 kg/s)*velocity(A of arm), body: arm, at: A}
  square: {force: (2 kg/m)*norm(velocity(A of arm))^2, along: -velocity(A of arm), body: arm, at: A}
  seen: {force: -(2 kg/s)*velocity(A of arm relative to disk), body: arm, at: A}
  brake: {couple: -(2 N*m*s/rad)*angular_velocity(arm relative to disk), body: arm}
  back: {force: -(8 N/m)*(center(arm) - C), body: arm}
gravity: -y
instants: {now: {q: turned, q': w}}
ask: {a: q''}
)";
}

TEST(StatedForces, AreThoseOfFormulasByHand) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-1.2, 1.2);
  for (int i = 0; i < 30; ++i) {
    const std::string text = swinging(part(random), 4 * part(random));
    SCOPED_TRACE(text);
    const Statement statement = read_statement(text, "test.yaml");
    const Settings settings;
    const SolvedInstant instant(statement.situations.front(), settings, When{}, OpenChoice{});
    DataScope<double> data(statement.situations.front(), settings);
    const std::map<std::string, StatedForce> found = forces_of(instant, data);
    ASSERT_EQ(found.size(), 11U);
    const Real q = instant.machine().q.at(0), w = instant.state().v.at(0), turned = q - instant.machine().q.at(1);
    const Vector along{std::cos(q), std::sin(q), 0}, across{-std::sin(q), std::cos(q), 0}, up{0, 0, 1};
    const Vector A = Real(0.5L) * along, v = (w / 2) * across;
    const auto force = [&](const char* name) { return found.at(name).force; };
    const auto couple = [&](const char* name) { return found.at(name).couple; };
    expect_near(force("fixed"), Vector{7.2L, 9.6L, 0}, "fixed");
    expect_near(force("riding"), Real(3) * along + Real(4) * across, "riding");
    expect_near(force("weight"), Vector{0, 0, 5}, "weight");
    expect_near(found.at("weight").at, Real(0.25L) * along, "the mass center");
    expect_near(force("drag"), Real(-2) * v, "drag");
    expect_near(force("square"), (Real(-2) * norm(v)) * v, "square");
    expect_near(force("seen"), Real(-2) * (v - Real(1.5L) * across), "seen");
    expect_near(couple("brake"), (-2 * (w - 3)) * up, "brake");
    expect_near(force("back"), Real(-8) * (Real(0.25L) * along - Vector{0.5L, 0.3L, 0}), "back");
    const Vector span = A - Vector{0.5L, 0.3L, 0};
    const Real length = norm(span), pull = 300 * (length - 0.1L) + 6 * dot(v, span) / length;
    expect_near(force("pull"), (-pull / length) * span, "pull");
    expect_near(found.at("pull").at, A, "the end");
    expect_near(couple("twist"), (-3 * (turned - 0.1L) - 0.4L * (w - 3)) * up, "twist");
    expect_near(couple("hinge"), (4 - 2 * w - 5 * (q - 0.2L) - 0.7L * w) * up, "hinge");
  }
}

TEST(StatedForces, AgreeWithTheLawsInRandomProblems) {
  poinsot::testing::Random random(47);
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    testing::RandomOptions options;
    options.planar = random.chance(0.3);
    const testing::ProblemData problem = testing::random_problem(random, options);
    SCOPED_TRACE(problem.text());
    const Statement statement = read_statement(problem.text(), "test.yaml");
    const Settings settings;
    SolvedInstant instant(statement.situations.front(), settings, When{}, OpenChoice{});
    instant.solve_forces();
    const std::optional<double> misfit = instant.check().laws;
    if (!misfit) continue;
    ++checked;
    EXPECT_LT(*misfit, 1e-10);
    if (HasFailure()) break;
  }
  EXPECT_GT(checked, 100);
}

// A motor within gimbals passes on more than its own couple; only that along its axis is stated.
TEST(StatedForces, OfMotorsInGimbalsAreTheirCouples) {
  const SolvedText solved(R"(
points: {O: [0, 0, 0], A: [0.2 m, 0.1 m, 0.3 m]}
bodies: {rotor: {box: {center: A, sides: [0.1 m * x, 0.2 m * y, 0.3 m * z]}, mass: 2 kg}}
joints:
  cross:
    universal: [x, y]
    at: O
    to: rotor
    freedoms:
      first: {angle: 0.3 rad, rate: 2 rad/s, couple: 5 N*m}
      second: {angle: 0.4 rad, rate: 1 rad/s, spring: {stiffness: 4 N*m/rad}, damping: 2 N*m*s/rad}
gravity: -z
ask: {H: angular_acceleration(rotor)}
)");
  EXPECT_EQ(solved.found("H").state, AskState::found);
  const auto& checks = solved.solved().solutions.at(0).checks;
  ASSERT_TRUE(checks.contains("laws"));
  EXPECT_LT(checks.at("laws"), 1e-12);
}

// Of a stage only its own loads act.
TEST(StatedForces, StandInTheirStages) {
  const SolvedText solved(R"(
points: {O: [0, 0, 0]}
bodies: {grain: {particle: O, mass: 2 kg}}
loads:
  push: {force: [6 N, 0, 0], body: grain}
  drag: {force: -(1 kg/s)*velocity(grain), body: grain}
stages:
  first: {lasts: 1 s, loads: [push]}
  second: {lasts: 2 s, loads: [drag]}
gravity: none
instants: {start: rest}
ask: {v: velocity(grain) @ 3 s, a: acceleration(grain) @ second.start}
)");
  EXPECT_NEAR(solved.vector("v").x, 3 * std::exp(-1), 1e-9);
  EXPECT_NEAR(solved.vector("a").x, -1.5, 1e-12);
  EXPECT_LT(solved.solved().solutions.at(0).checks.at("laws"), 1e-9);
}

// A motor on the first of two axes that are not perpendicular: its couple has no part about the second, whatever pose,
// and a motor that passed on what it does not drive is seen.
TEST(StatedForces, MotorsInObliqueGimbalsTurnNothingAboutTheOther) {
  const Statement statement = read_statement(
      "title: t\npoints: {O: [0, 0, 0], G: [0.1 m, 0.2 m, 0]}\ndirections: {n: [cos(50 deg), sin(50 deg), 0]}\nbodies: "
      "{block: {sphere: {center: G, radius: 0.1 m}, mass: 3 kg}}\njoints: {hooke: {universal: [x, n], at: O, to: "
      "block, "
      "freedoms: {first: {couple: 2 N*m, angle: 0.4 rad, rate: 0}, second: {angle: 0.3 rad, rate: 0}}}}\ngravity: "
      "none\nask: {a: angular_acceleration(block)}\n",
      "test.yaml");
  const Situation& situation = statement.situations.front();
  const Settings none;
  SolvedInstant instant(situation, none, When{}, OpenChoice{});
  DataScope<double> data(situation, none);
  const std::map<std::string, StatedForce> forces = forces_of(instant, data);
  const auto motor = std::ranges::find_if(forces, [](const auto& one) { return one.second.only_about.has_value(); });
  ASSERT_NE(motor, forces.end());
  ASSERT_EQ(motor->second.none_about.size(), 1U);
  // The second axis is turned about the first by 0.4.
  const double c = std::cos(50 * std::numbers::pi / 180), s = std::sin(50 * std::numbers::pi / 180);
  const Vector expected{c, s * std::cos(0.4), s * std::sin(0.4)};
  expect_near(motor->second.none_about.front(), expected, "second axis");
}

}  // namespace stated_forces_test
}  // namespace poinsot::problem
