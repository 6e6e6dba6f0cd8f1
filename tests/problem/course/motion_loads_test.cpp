// Loads that depend on the motion: instants and motions against closed forms, and what no load can depend on.
#include <fmt/format.h>

#include <numbers>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace motion_loads_test {

constexpr double g = 9.81;

std::string particle(const std::string& loads, const std::string& velocity, const std::string& asks) {
  return "title: t\npoints: {O: [0, 0, 0]}\nbodies: {ball: {particle: O, mass: 2 kg}}\n"
         "gravity: [0, -9.81 m/s^2, 0]\nloads: {" +
         loads + "}\ninstants: {start: {velocity(ball): [" + velocity + "]}}\nask: {" + asks + "}\n";
}
const std::string square_drag = "drag: {force: '-0.3 kg/m * norm(velocity(ball))*velocity(ball)', body: ball}";

double energy_kept(const SolvedText& solved) { return solved.solved().solutions.at(0).checks.at("energy_drift"); }

// v = v_t tanh(g t/v_t), y = v_t^2/g ln cosh(g t/v_t), v_t^2 = m g/c.
TEST(MotionLoads, ABallFallsInAir) {
  const SolvedText solved(particle(square_drag, "0, 0, 0",
                                   "a: acceleration(ball), v: velocity(ball).y @ 1.5 s, y: center(ball).y @ 1.5 s, "
                                   "D: load(drag) @ 1.5 s, P: power @ 1.5 s"
                                   "}\ndefine: {power: dot(load(drag) with velocity(ball))"));
  const double terminal = std::sqrt(2 * g / 0.3), v = terminal * std::tanh(g * 1.5 / terminal);
  EXPECT_NEAR(solved.vector("a").y, -g, 1e-12);
  EXPECT_NEAR(solved.number("v"), -v, 1e-9 * v);
  EXPECT_NEAR(solved.number("y"), -terminal * terminal / g * std::log(std::cosh(g * 1.5 / terminal)), 1e-8);
  EXPECT_NEAR(solved.vector("D").y, 0.3 * v * v, 1e-8);
  EXPECT_NEAR(solved.number("P"), -0.3 * v * v * v, 1e-7);
  EXPECT_LT(energy_kept(solved), 1e-9);
}

// In still air across the pull of gravity nothing but drag acts: v = v0/(1 + c v0 t/m), x = m/c ln(1 + c v0 t/m).
TEST(MotionLoads, ASledCoasts) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {sled: {particle: O, mass: 2 kg}}\n"
      "joints: {rail: {prismatic: x, at: O, to: sled, displacement: s, force: -0.3 kg/m * abs(s') * s'}}\n"
      "gravity: none\ninstants: {start: {s: 0, s': 5 m/s}}\n"
      "ask: {a: s'', F: drive(rail), v: s' @ 4 s, x: s @ 4 s}\n");
  EXPECT_NEAR(solved.number("a"), -0.3 * 25 / 2, 1e-12);
  EXPECT_NEAR(solved.vector("F").x, -0.3 * 25, 1e-12);
  EXPECT_NEAR(solved.number("v"), 5 / (1 + 0.3 * 5 * 4 / 2), 1e-9);
  EXPECT_NEAR(solved.number("x"), 2 / 0.3 * std::log(1 + 0.3 * 5 * 4 / 2), 1e-8);
  EXPECT_LT(energy_kept(solved), 1e-9);
}

// m v^2/2 = P t.
TEST(MotionLoads, AWheelIsDrivenByConstantPower) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0]}\n"
      "bodies: {wheel: {disk: {center: O, normal: z, radius: 0.2 m}, mass: 6 kg}}\n"
      "joints: {axle: {revolute: z, at: O, to: wheel, angle: turn, couple: 300 W / turn'}}\n"
      "gravity: none\ninstants: {start: {turn: 0, turn': 4 rad/s}}\n"
      "ask: {alpha: turn'', M: drive(axle), w: turn' @ 3 s, P: \"rate(kinetic_energy(wheel)) @ 3 s\"}\n");
  const double I = 6 * 0.04 / 2;
  EXPECT_NEAR(solved.number("alpha"), 300 / 4.0 / I, 1e-9);
  EXPECT_NEAR(solved.vector("M").z, 75, 1e-10);
  EXPECT_NEAR(solved.number("w"), std::sqrt(16 + 2 * 300 * 3 / I), 1e-7);
  EXPECT_NEAR(solved.number("P"), 300, 1e-6);
}

// A charge goes round in a circle of radius m v/(q B) in the time 2 pi m/(q B), and its energy stays.
TEST(MotionLoads, AChargeGoesRoundInAMagneticField) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {grain: {particle: O, mass: 2 g}}\ngravity: none\n"
      "loads: {field: {force: '0.01 kg/s * cross(velocity(grain) with z)', body: grain}}\n"
      "instants: {start: {velocity(grain): [3 m/s, 0, 1 m/s]}}\n"
      "ask: {a: acceleration(grain), x: center(grain) @ 0.3 s, T: period(velocity(grain).x), "
      "v: norm(velocity(grain)) @ 0.7 s}\n");
  const double w = 0.01 / 0.002, r = 3 / w;
  EXPECT_NEAR(solved.vector("a").y, -3 * w, 1e-12);
  const Vector3<double> x = solved.vector("x");
  EXPECT_NEAR(x.x, r * std::sin(0.3 * w), 1e-9);
  EXPECT_NEAR(x.y, -r * (1 - std::cos(0.3 * w)), 1e-9);
  EXPECT_NEAR(x.z, 0.3, 1e-9);
  EXPECT_NEAR(solved.number("T"), 2 * std::numbers::pi / w, 1e-8);
  EXPECT_NEAR(solved.number("v"), std::sqrt(10), 1e-9);
}

// A couple on a body at a joint acts in reverse on what carries it: as a damper stated at the joint does.
TEST(MotionLoads, ACoupleAtAJointActsOnBothBodies) {
  const std::string wheels =
      "title: t\npoints: {A: [0, 0, 0]}\nbodies:\n"
      "  pump: {mass: 4 kg, center: A, inertia: {axis: x, axial: 0.02 kg*m^2, transverse: 0.03 kg*m^2}}\n"
      "  wheel: {mass: 6 kg, center: A, inertia: {axis: x, axial: 0.05 kg*m^2, transverse: 0.06 kg*m^2}}\n"
      "gravity: none\njoints:\n  left: {revolute: x, at: A, to: pump, rate: 5 rad/s}\n"
      "  shaft: {revolute: x, at: A, from: pump, to: wheel, angle: b, rate: -8 rad/s, ";
  const std::string asks =
      "ask: {pump: angular_velocity(pump).x @ 0.1 s, wheel: angular_velocity(wheel).x @ 0.1 s, M: drive(shaft), "
      "alpha: angular_acceleration(pump).x}\n";
  const SolvedText damper(wheels + "damping: 0.3 N*m*s/rad}\n" + asks);
  const SolvedText load(wheels + "couple: -0.3 N*m*s/rad * b'}\n" + asks);
  const SolvedText loads(wheels.substr(0, wheels.size() - 2) +
                         "}\nloads:\n"
                         "  forth: {couple: '-0.3 N*m*s/rad * angular_velocity(wheel relative to pump)', body: wheel}\n"
                         "  back: {couple: 0.3 N*m*s/rad * b', about: axis(shaft), body: pump}\n" +
                         asks);
  for (const char* ask : {"pump", "wheel", "alpha"}) {
    EXPECT_NEAR(load.number(ask), damper.number(ask), 1e-9) << ask;
    EXPECT_NEAR(loads.number(ask), damper.number(ask), 1e-9) << ask;
  }
  EXPECT_NEAR(load.vector("M").x, damper.vector("M").x, 1e-12);
}

// A force that follows the place: an ellipse about the middle, with its period. A cube law: energy gives the top speed.
TEST(MotionLoads, ForcesFollowThePlace) {
  const SolvedText ellipse(
      "title: t\npoints: {P: [0.4 m, 0, 0]}\nbodies: {ball: {particle: P, mass: 2 kg}}\ngravity: none\n"
      "loads: {pull: {force: '-50 N/m * center(ball)', body: ball}}\n"
      "instants: {start: {velocity(ball): [0, 1 m/s, 0]}}\n"
      "ask: {x: center(ball) @ 0.9 s, T: period(center(ball).x)}\n");
  EXPECT_NEAR(ellipse.vector("x").x, 0.4 * std::cos(4.5), 1e-9);
  EXPECT_NEAR(ellipse.vector("x").y, 0.2 * std::sin(4.5), 1e-9);
  EXPECT_NEAR(ellipse.number("T"), 2 * std::numbers::pi / 5, 1e-9);
  const SolvedText cube(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {cart: {particle: O, mass: 2 kg}}\ngravity: none\n"
      "joints: {rail: {prismatic: x, at: O, to: cart, displacement: s}}\n"
      "loads: {spring: {force: -300 N/m^3 * s^3, along: x, body: cart}}\n"
      "instants: {start: {s: 0.4 m, s': 0}}\nask: {v: max(s')}\n");
  EXPECT_NEAR(cube.number("v"), 0.16 * std::sqrt(150 / 2.0), 1e-9);
  EXPECT_LT(energy_kept(cube), 1e-9);
}

// Components on the axes of the body: a wing that resists across its plane alone.
TEST(MotionLoads, ComponentsOnTheAxesOfABody) {
  const SolvedText solved(
      "title: t\ngiven: {b: 40 deg}\npoints: {O: [0, 0, 0]}\n"
      "bodies: {wing: {box: {center: O, sides: [0.4 m * x, 0.02 m * y, 1 m * z]}, mass: 3 kg}}\ngravity: none\n"
      "joints: {hinge: {planar: z, at: O, to: wing, freedoms: {turn: {angle: b, rate: 0}, slide1: {rate: 6 m/s}, "
      "slide2: {rate: 1 m/s}}}}\n"
      "loads: {lift: {force: '[0, -4 kg/m * velocity(wing).y * abs(velocity(wing).y), 0]', body: wing, axes: wing}}\n"
      "ask: {F: load(lift), a: acceleration(wing)}\n");
  const double b = 40 * std::numbers::pi / 180, across = -6 * std::sin(b) + std::cos(b);
  const double size = -4 * across * std::abs(across);
  EXPECT_NEAR(solved.vector("F").x, -size * std::sin(b), 1e-12);
  EXPECT_NEAR(solved.vector("F").y, size * std::cos(b), 1e-12);
  EXPECT_NEAR(solved.vector("a").x, -size * std::sin(b) / 3, 1e-12);
}

// min, max and the inverse functions act on what the motion brings, not on what they were at the start.
TEST(MotionLoads, FunctionsFollowTheMotion) {
  const std::string cart =
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {cart: {particle: O, mass: 2 kg}}\ngravity: none\n"
      "joints: {rail: {prismatic: x, at: O, to: cart, displacement: s}}\n"
      "instants: {start: {s: -0.3 m, s': 2 m/s}}\n";
  // A buffer that is met at s = 0: m v^2 = k s^2, and back it comes as fast.
  const SolvedText buffer(cart +
                          "loads: {buffer: {force: -800 N/m * max(s with 0), along: x, body: cart}}\n"
                          "ask: {most: max(s), back: s' @ 1 s}\n");
  EXPECT_NEAR(buffer.number("most"), 2 * std::sqrt(2 / 800.0), 1e-7);
  EXPECT_NEAR(buffer.number("back"), -2, 1e-7);
  const SolvedText functions(
      cart +
      "loads: {a: {force: 7 N * asin(s/(1 m)) + 1 N * acos(s/(1 m)) + 2 N * atan(s/(1 m)) + 3 N * tan(s/(1 m)*(1 "
      "rad)), along: "
      "x, "
      "body: cart}, b: {force: min(s' with 5 m/s)*(1 kg/s) + 2 N * sqrt(s'/(1 m/s)), along: x, body: cart}, "
      "c: {force: 1 N * acute_angle(velocity(cart) to -x) + 1 N * atan2(s to -s'*(1 s)), along: x, body: cart}}\n"
      "ask: {a: load(a).x, b: load(b).x, c: load(c).x}\n");
  EXPECT_NEAR(functions.number("a"), 7 * std::asin(-0.3) + std::acos(-0.3) + 2 * std::atan(-0.3) + 3 * std::tan(-0.3),
              1e-12);
  EXPECT_NEAR(functions.number("b"), 2 + 2 * std::sqrt(2), 1e-12);
  EXPECT_NEAR(functions.number("c"), std::atan2(-0.3, -2), 1e-12);
}

// Unknowns stand in such a load as in any other.
TEST(MotionLoads, UnknownsAreFound) {
  const std::string air =
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {ball: {particle: O, mass: 2 kg}}\ngravity: [0, -9.81 m/s^2, 0]\n"
      "loads: {drag: {force: '-c * norm(velocity(ball)) * velocity(ball)', body: ball}}\n";
  const SolvedText speed(air +
                         "given: {c: 0.3 kg/m}\nfind: {v: m/s}\nwhere: [v > 0]\n"
                         "instants: {now: {velocity(ball): [0, -v, 0], acceleration(ball).y: 0}}\nask: {v: v}\n");
  EXPECT_NEAR(speed.number("v"), std::sqrt(2 * g / 0.3), 1e-9);
  const SolvedText size(air +
                        "find: {c: kg/m}\n"
                        "instants: {now: {velocity(ball): [0, -3 m/s, 0], acceleration(ball).y: -2 m/s^2}}\n"
                        "ask: {c: c}\n");
  EXPECT_NEAR(size.number("c"), 2 * (g - 2) / 9, 1e-9);
}

// A motion that dies out keeps the account of its energy, beside what it began with.
TEST(MotionLoads, AMotionThatDiesOut) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {sled: {particle: O, mass: 2 kg}}\ngravity: none\n"
      "joints: {rail: {prismatic: x, at: O, to: sled, displacement: s, force: -0.3 kg/s * s'}}\n"
      "instants: {start: {s: 0, s': 4 m/s}}\nask: {far: max(s)}\n");
  EXPECT_NEAR(solved.number("far"), 2 * 4 / 0.3, 1e-6);
  EXPECT_LT(energy_kept(solved), 1e-9);
}

// A stage names the loads that act.
TEST(MotionLoads, ActInTheirStage) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {sled: {particle: O, mass: 2 kg}}\ngravity: none\n"
      "joints: {rail: {prismatic: x, at: O, to: sled, displacement: s}}\n"
      "loads: {brake: {force: -0.5 kg/s * velocity(sled), body: sled}}\n"
      "instants: {start: {s: 0, s': 4 m/s}}\n"
      "stages: {free: {lasts: 2 s, loads: []}, braked: {loads: [brake]}}\n"
      "ask: {one: s' @ free.end, two: s' @ 5 s}\n");
  EXPECT_NEAR(solved.number("one"), 4, 1e-12);
  EXPECT_NEAR(solved.number("two"), 4 * std::exp(-0.25 * 3), 1e-9);
}

TEST(MotionLoads, WhatNoLoadCanDependOn) {
  const auto failure = [](const std::string& force) {
    return failure_of_text(
        particle("drag: {force: '" + force + "', body: ball}", "1 m/s, 0, 0", "a: acceleration(ball)"));
  };
  const auto expect = [&](const std::string& force, const std::string& words) {
    const std::string found = failure(force);
    EXPECT_NE(found.find(words), std::string::npos) << force << '\n' << found;
  };
  expect("-0.3 kg * acceleration(ball)",
         "load 'drag' cannot depend on acceleration(...): accelerations and forces follow from the loads");
  expect("-0.3 * load(drag)", "load 'drag' cannot depend on load(...)");
  expect("-0.3 kg/s * velocity(bal)", "there is no body 'bal'");
  expect("-0.3 kg/s * velocty(ball)", "velocity");
  expect("-0.3 kg * velocity(ball)", "expected a force");
  expect("[0, 0, kinetic_energy(ball)/(1 m)]", "load 'drag' cannot depend on kinetic_energy(...)");
  expect("-0.3 kg/s * time/(1 s) * velocity(ball)", "depends on the time and on the motion at once");
  const std::string rest = failure_of_text(
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {car: {particle: O, mass: 2 kg}}\ngravity: none\n"
      "joints: {road: {prismatic: x, at: O, to: car, displacement: s, force: 300 W / s'}}\n"
      "instants: {start: {s: 0, s': 0}}\nask: {a: s''}\n");
  EXPECT_NE(rest.find("'road' has no value in this motion"), std::string::npos) << rest;
}

// The name of a datum is the datum, unless something else in the load follows the motion: then it is not guessed.
TEST(MotionLoads, ADatumThatNamesACoordinate) {
  const std::string failure = failure_of_text(
      "title: t\ngiven: {s: 0.3 m}\npoints: {O: [0, 0, 0]}\nbodies: {cart: {particle: O, mass: 2 kg}}\ngravity: none\n"
      "joints: {rail: {prismatic: x, at: O, to: cart, displacement: s, rate: 1 m/s}}\n"
      "loads: {spring: {force: -300 N/m * s - 2 kg/s * s', along: x, body: cart}}\nask: {a: s''}\n");
  EXPECT_NE(failure.find("'s' is a datum and the name of a coordinate"), std::string::npos) << failure;
}

}  // namespace motion_loads_test
}  // namespace poinsot::problem
