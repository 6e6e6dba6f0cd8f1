// The motion that follows something sudden: through stages, with particles that stay, with contacts that part.
#include <gtest/gtest.h>

#include <cmath>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace blow_and_motion_test {

constexpr double g = 9.81;

TEST(BlowAndMotion, AfterTheBlowTheStagesFollow) {
  const std::string probe =
      "title: t\npoints: {O: [0, 0, 0], P: [1 m, 0, 0]}\n"
      "bodies: {p: {mass: 50 kg, center: O, inertia: {x: 10 kg*m^2, y: 10 kg*m^2, z: 20 kg*m^2}}}\n"
      "impulses: {kick: {body: p, at: P, value: [0, 8 N*s, 0]}}\n"
      "loads: {jet: {couple: [0, 0, -0.5 N*m], body: p}}\ngravity: none\ninstants: {before: rest}\n"
      "stages: {coast: {lasts: 3 s, loads: []}, brake: {until: angular_velocity(p).z == 0, loads: [jet]}}\n"
      "ask: {w: angular_velocity(p).z @ coast, still: kinetic_energy(p) @ before, J: impulse(kick), "
      "t: {first_time: angular_velocity(p).z == 0}, b: angular_velocity(p).z @ brake, a: angular_acceleration(p).z @ "
      "brake, "
      "x: position(O of p) @ brake.end, v: velocity(p), later: angular_velocity(p).z @ 13 s, "
      "s: angular_velocity(p).z @ start}\n";
  const SolvedText solved(probe);
  EXPECT_NEAR(solved.number("w"), 0.4, 1e-12);
  EXPECT_EQ(solved.number("still"), 0);
  EXPECT_NEAR(solved.vector("J").y, 8, 1e-12);
  EXPECT_NEAR(solved.number("b"), 0.4, 1e-12);
  EXPECT_NEAR(solved.number("s"), 0.4, 1e-12);
  EXPECT_NEAR(solved.number("a"), -0.025, 1e-12);
  EXPECT_NEAR(solved.number("t"), 19, 1e-9);
  EXPECT_NEAR(solved.vector("x").y, 0.16 * 19, 1e-9);
  EXPECT_NEAR(solved.vector("v").y, 0.16, 1e-12);
  EXPECT_NEAR(solved.number("later"), 0.4 - 0.025 * 10, 1e-10);
}

// A rod of 8 kg and 1.2 m hangs at an angle of 30 deg; a particle of 2 kg hits its end at 40 m/s and stays.
const std::string ballistic =
    "title: t\ngiven: {L: 1.2 m, g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
    "bodies: {rod: {rod: [O, P], mass: 8 kg}}\njoints: {pin: {revolute: z, at: O, to: rod, angle: th}}\n"
    "strikes: {bullet: {mass: 2 kg, hits: rod, at: P, velocity: [40 m/s, 0, 0], stays: true}}\n"
    "gravity: -y\ninstants: {before: {th: 30 deg, th': 0}}\n";

TEST(BlowAndMotion, AParticleThatStaysMovesWithTheBody) {
  const SolvedText solved(ballistic +
                          "ask: {w: th', a: th'' @ 0 s, A: reaction(pin) @ 0.1 s, th: th @ 0.1 s, w1: th' @ 0.1 s, "
                          "a1: th'' @ 0.1 s, m: mass(rod) @ 0.1 s, now: th''}\n");
  const double L = 1.2, J = 8 * L * L / 3 + 2 * L * L, S = 8 * L / 2 + 2 * L, start = M_PI / 6;
  const double w = 2 * 40 * std::cos(start) * L / J;
  EXPECT_NEAR(solved.number("w"), w, 1e-12);
  EXPECT_NEAR(solved.number("a"), -S * g * std::sin(start) / J, 1e-12);
  const auto y = integrated(Numbers<2>{start, w}, 0.1, 2000, [&](const Numbers<2>& s) {
    return Numbers<2>{s[1], -S * g * std::sin(s[0]) / J};
  });
  EXPECT_NEAR(solved.number("th"), y[0], 1e-9);
  EXPECT_NEAR(solved.number("w1"), y[1], 1e-9);
  const double a = -S * g * std::sin(y[0]) / J;
  EXPECT_NEAR(solved.number("a1"), a, 1e-9);
  EXPECT_NEAR(solved.number("m"), 10, 1e-12);
  const double along = y[1] * y[1] * S, c = std::cos(y[0]), s = std::sin(y[0]);
  EXPECT_NEAR(solved.vector("A").x, S * a * c - along * s, 1e-7);
  EXPECT_NEAR(solved.vector("A").y, S * a * s + along * c + 10 * g, 1e-7);
  EXPECT_EQ(solved.reason("now"),
            "with the particle of strike 'bullet', which stays, the body moves on as another one than before: ask for "
            "its accelerations and forces in the motion that follows: @ 0 s");
}

TEST(BlowAndMotion, ASwingTellsTheSpeedOfTheBullet) {
  const std::string text =
      "title: t\ngiven: {L: 1.2 m, g: 9.81 m/s^2}\nfind: {v: m/s}\nwhere: [10 m/s < v < 1000 m/s]\n"
      "points: {O: [0, 0, 0], P: [0, -L, 0]}\nbodies: {rod: {rod: [O, P], mass: 8 kg}}\n"
      "joints: {pin: {revolute: z, at: O, to: rod, angle: th}}\n"
      "strikes: {bullet: {mass: 20 g, hits: rod, at: P, velocity: '[v, 0, 0]', stays: true}}\n"
      "gravity: -y\ninstants: {before: rest, after: {max(th): 20 deg}}\nask: {v: v}\n";
  const double L = 1.2, J = (8.0 / 3 + 0.02) * L * L, S = (4 + 0.02) * L;
  const double w = std::sqrt(2 * S * g * (1 - std::cos(M_PI / 9)) / J);
  EXPECT_NEAR(SolvedText(text).number("v"), J * w / (0.02 * L), 1e-4);
}

TEST(BlowAndMotion, AFreeBodyTurnsAboutTheCommonCenter) {
  // A rod along y of 3 kg and 2 m, at rest, is hit at its end by 1 kg at 8 m/s: the centers are 0.25 m apart.
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0], P: [0, 1 m, 0], N: [0, -1 m, 0]}\nbodies: {rod: {rod: [N, P], mass: 3 kg}}\n"
      "strikes: {clay: {mass: 1 kg, hits: rod, at: P, velocity: [8 m/s, 0, 0], stays: true}}\ngravity: none\n"
      "instants: {before: {velocity(rod): [0, 0, 0], angular_velocity(rod): [0, 0, 0]}}\n"
      "ask: {w: angular_velocity(rod).z, P: position(P of rod) @ 0.5 s, c: center(rod) @ 0.5 s, "
      "T: kinetic_energy(rod) @ 0.5 s}\n");
  const double J = 1 + 3 * 0.0625 + 0.5625, w = -8 * 0.75 / J, turned = w * 0.5;
  EXPECT_NEAR(solved.number("w"), w, 1e-12);
  EXPECT_LT(norm(solved.vector("c") - Vector3<double>{1, 0.25, 0}), 1e-9);
  EXPECT_LT(norm(solved.vector("P") - Vector3<double>{1 - 0.75 * std::sin(turned), 0.25 + 0.75 * std::cos(turned), 0}),
            1e-9);
  EXPECT_NEAR(solved.number("T"), 4 * 4 / 2.0 + J * w * w / 2, 1e-9);
}

TEST(BlowAndMotion, AContactThatTheBlowPartsIsOpenAfterIt) {
  const SolvedText solved(
      "title: t\ngiven: {g: 9.81 m/s^2}\npoints: {O: [0, 0, 0], Q: [0, -0.1 m, 0]}\n"
      "bodies: {ball: {sphere: {center: O, radius: 0.1 m}, mass: 2 kg}}\n"
      "contacts: {floor: {of: ball, at: Q, normal: y}}\nimpulses: {kick: {body: ball, value: [0, 6 N*s, 0]}}\n"
      "gravity: -y\ninstants: {before: rest}\nask: {y: center(ball).y @ 0.2 s, t: touching(floor) @ 0.2 s}\n");
  EXPECT_NEAR(solved.number("y"), 3 * 0.2 - g * 0.02, 1e-9);
  EXPECT_FALSE(solved.found("t").value.truth);
}

}  // namespace blow_and_motion_test
}  // namespace poinsot::problem
