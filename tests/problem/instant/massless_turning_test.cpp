// Particles and slender rods: no one has to say how they turn about a line of their own.
#include "problem/instant/massless_turning.h"

#include <gtest/gtest.h>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace massless_turning_test {

constexpr double g = 9.81;

// Where the end of a line of length L from the origin is that moves under gravity -z as a particle would at its end.
Vector3<double> spherical_pendulum(double L, const Vector3<double>& at, const Vector3<double>& v, double time) {
  const auto slopes = [L](const Numbers<6>& y) {
    const double tension = (-g * y[2] + y[3] * y[3] + y[4] * y[4] + y[5] * y[5]) / (L * L);
    return Numbers<6>{y[3], y[4], y[5], -tension * y[0], -tension * y[1], -g - tension * y[2]};
  };
  const auto y = integrated(Numbers<6>{at.x, at.y, at.z, v.x, v.y, v.z}, time, 4000, slopes);
  return {y[0], y[1], y[2]};
}

const std::string pendulum =
    "title: t\ngiven: {g: 9.81 m/s^2, L: 1.3 m}\npoints: {O: [0, 0, 0], B: [0.48 m, 0.36 m, -sqrt(L^2 - 0.36 m^2)]}\n"
    "gravity: -z\ninstants: {start: {velocity(B of bob): [-0.9 m/s, 1.2 m/s, 0]}}\n"
    "ask: {p: position(B of bob) @ 1.7 s, here: velocity(B of bob), T: kinetic_energy(bob)}\n";
const double height = -std::sqrt(1.3 * 1.3 - 0.36);

TEST(MasslessTurning, ParticleOnABallJoint) {
  const SolvedText solved(pendulum + "bodies: {bob: {particle: B, mass: any}}\njoints: {turn: {ball: O, to: bob}}\n");
  const Vector3<double> expected = spherical_pendulum(1.3, {0.48, 0.36, height}, {-0.9, 1.2, 0}, 1.7);
  EXPECT_LT(norm(solved.vector("p") - expected), 1e-9);
}

TEST(MasslessTurning, ParticleOnACordAskedAtTheStartToo) {
  const SolvedText solved(pendulum +
                          "bodies: {bob: {particle: B, mass: 2 kg}}\ncords: {c: {at: O, to: bob, end: B}}\n");
  const Vector3<double> expected = spherical_pendulum(1.3, {0.48, 0.36, height}, {-0.9, 1.2, 0}, 1.7);
  EXPECT_LT(norm(solved.vector("p") - expected), 1e-9);
  EXPECT_NEAR(solved.number("T"), 2.25, 1e-12);
}

TEST(MasslessTurning, RodOnABallJoint) {
  // As a particle at two thirds of its length.
  const SolvedText solved(pendulum + "bodies: {bob: {rod: [O, B], mass: any}}\njoints: {turn: {ball: O, to: bob}}\n");
  const double part = 2.0 / 3;
  const Vector3<double> expected =
      spherical_pendulum(1.3 * part, part * Vector3<double>{0.48, 0.36, height}, {-0.9 * part, 1.2 * part, 0}, 1.7) /
      part;
  EXPECT_LT(norm(solved.vector("p") - expected), 1e-9);
}

TEST(MasslessTurning, RodsOnBallJointsMoveAsOnUniversalJoints) {
  const auto text = [](const std::string& joints) {
    return "title: t\ngiven: {g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], A: [0.3 m, 0.2 m, -0.8 m], B: [0.5 m, -0.1 m, "
           "-1.2 m]}\n"
           "directions: {a: cross(O->A with x), c: cross(A->B with O->A), b: cross(A->B with c)}\n"
           "bodies: {upper: {rod: [O, A], mass: 2 kg}, lower: {rod: [A, B], mass: 1 kg}}\n"
           "gravity: -z\ninstants: {start: {velocity(A of upper): 1 m/s * a, velocity(B of lower): 1 m/s * a + 0.7 m/s "
           "* c}}\n"
           "ask: {A: position(A of upper) @ 1.2 s, B: position(B of lower) @ 1.2 s, T: kinetic_energy(system)}\n"
           "joints: {" +
           joints + "}\n";
  };
  const SolvedText balls(text("top: {ball: O, to: upper}, knee: {ball: A, from: upper, to: lower}"));
  const SolvedText hinges(
      text("top: {universal: [x, a], at: O, to: upper}, "
           "knee: {universal: [c, b], at: A, from: upper, to: lower}"));
  EXPECT_NEAR(balls.number("T"), hinges.number("T"), 1e-12);
  EXPECT_LT(norm(balls.vector("A") - hinges.vector("A")), 1e-8);
  EXPECT_LT(norm(balls.vector("B") - hinges.vector("B")), 1e-8);
}

TEST(MasslessTurning, ParticleThatSlidesOnAPlane) {
  const SolvedText solved(
      "title: t\ngiven: {g: 9.81 m/s^2}\npoints: {B: [1 m, 0, 0]}\nbodies: {p: {particle: B, mass: 1 kg}}\n"
      "joints: {plane: {planar: z, at: B, to: p}}\ngravity: -y\n"
      "instants: {start: {velocity(p): [3 m/s, 4 m/s, 0]}}\nask: {r: center(p) @ 2 s, v: velocity(p) @ 2 s}\n");
  EXPECT_LT(norm(solved.vector("r") - Vector3<double>{7, 8 - 2 * g, 0}), 1e-9);
  EXPECT_LT(norm(solved.vector("v") - Vector3<double>{3, 4 - 2 * g, 0}), 1e-9);
}

// A couple on what has no inertia, that begins later.
TEST(MasslessTurning, ParticleThatACoupleTurns) {
  const std::string text =
      "title: t\npoints: {B: [1 m, 0, 0]}\nbodies: {p: {particle: B, mass: 1 kg}}\n"
      "joints: {plane: {planar: z, at: B, to: p}}\ngravity: none\nloads: {c: {couple: [0, 0, 2 N*m], body: p}}\n"
      "stages: {free: {lasts: 1 s, loads: []}, turned: {lasts: 1 s, loads: [c]}}\n"
      "instants: {start: {velocity(p): [3 m/s, 4 m/s, 0]}}\n"
      "ask: {early: center(p) @ 0.5 s, late: center(p) @ 2 s}\n";
  EXPECT_NE(failure_of_text(text).find("a couple acts on the rate of joint 'plane', turn, which moves no mass"),
            std::string::npos)
      << failure_of_text(text);
}

const std::string rod =
    "title: t\ngiven: {g: 9.81 m/s^2}\npoints: {A: [0, 0, 0], B: [0, 0, 1 m]}\n"
    "joints: {pin: {ball: A, to: bar, angles: [phi: z, theta: x, psi: z]}}\ngravity: -z\n";

// As a body of next to no moment about the line does.
TEST(MasslessTurning, TheSpinOfARodThatIsStatedStays) {
  const std::string rest =
      "instants: {start: {theta: 30 deg, phi: 0 deg, psi: 0 deg, theta': 1 rad/s, phi': 2 rad/s, psi': 5 rad/s}}\n"
      "ask: {psi: psi @ 1 s, phi: phi @ 1 s, w: {of: angular_velocity(bar) @ 1 s, axes: bar}}\n";
  const SolvedText slender(rod + "bodies: {bar: {rod: [A, B], mass: 1 kg}}\n" + rest);
  const SolvedText thin(rod +
                        "bodies: {bar: {mass: 1 kg, center: B/2, inertia: {about: A, x: 1/3 kg*m^2, y: 1/3 kg*m^2, z: "
                        "1e-10 kg*m^2}}}\n" +
                        rest);
  EXPECT_NEAR(slender.vector("w").z, 5 + 2 * std::cos(std::acos(-1.0) / 6), 1e-12);
  EXPECT_NEAR(slender.number("psi"), thin.number("psi"), 1e-7);
  EXPECT_NEAR(slender.number("phi"), thin.number("phi"), 1e-7);
}

TEST(MasslessTurning, TheSpinOfARodThatIsNotStatedIsOpenAlongAMotionToo) {
  const SolvedText solved(
      rod +
      "bodies: {bar: {rod: [A, B], mass: 1 kg}}\n"
      "instants: {start: {theta: 30 deg, phi: 0 deg, psi: 0 deg, theta': 1 rad/s, phi': 2 rad/s}}\n"
      "ask: {psi: psi @ 1 s, w: angular_velocity(bar) @ 1 s, phi: phi @ 1 s, B: position(B of bar) @ "
      "1 s}\n");
  const std::string reason = "nothing fixes the rate of 'psi' at joint 'pin', psi: state it under joints: or instants:";
  EXPECT_EQ(solved.reason("psi"), reason);
  EXPECT_TRUE(solved.reason("w").starts_with(reason));
  EXPECT_EQ(solved.ask("phi").state, AskState::found);
  EXPECT_EQ(solved.ask("B").state, AskState::found);
}

// A blow on its line says nothing of a rod's spin; what moves mass is known all the same.
TEST(MasslessTurning, TheSpinOfARodAfterABlowIsOpen) {
  const std::string text =
      "title: t\npoints: {A: [0, 0, 0], B: [0.3 m, 0.5 m, -1 m]}\nbodies: {bar: {rod: [A, B], mass: 1 kg}}\n"
      "impulses: {p: {value: [1 N*s, 0, 0], at: B, body: bar}}\ngravity: none\n"
      "instants: {before: {velocity(bar): 0, angular_velocity(bar): [0.3 rad/s, 0.5 rad/s, -1 rad/s]}}\n";
  for (const char* ask : {"ask: {v: velocity(bar) @ 1 s, w: angular_velocity(bar) @ 1 s}\n",
                          "ask: {v: velocity(bar), w: angular_velocity(bar) @ 1 s, here: angular_velocity(bar)}\n"}) {
    const SolvedText solved(text + ask);
    EXPECT_LT(norm(solved.vector("v") - Vector3<double>{1, 0, 0}), 1e-9);
    EXPECT_EQ(solved.reason("w"), "the blow does not fix all velocities after it");
  }
}

TEST(MasslessTurning, WhatMovesMassStillHasToBeStated) {
  const std::string bodies =
      "bodies: {bob: {sphere: {center: B, radius: 10 cm}, mass: 2 kg}}\njoints: {turn: {ball: O, to: bob}}\n";
  const SolvedText solved(pendulum + bodies);
  EXPECT_EQ(solved.reason("p"),
            "the motion is not fixed at its start: angular velocity of bob at turn along z is unknown: state it under "
            "instants: {start: {...}}");
  EXPECT_NEAR(solved.vector("here").x, -0.9, 1e-12);
}

}  // namespace massless_turning_test
}  // namespace poinsot::problem
