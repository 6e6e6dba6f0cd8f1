// Friction in joints that follows from what they carry, at instants and along motions, against closed forms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace joint_bearings_test {

constexpr double g = 9.80665;

// A wheel on a shaft with two cords, one straight down and one at an angle b: which pull P raises the load W follows
// from the circle of friction, c R = P a - W a with R^2 = P^2 + W^2 + 2 P W cos b.
TEST(JointBearings, TheReactionOfAJournalIsTangentToTheCircleOfFriction) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> angle(-1.4, 1.4), coefficient(0.05, 0.5), load(100, 900);
  for (int trial = 0; trial < 4; ++trial) {
    const double b = angle(random), mu = coefficient(random), W = load(random), a = 0.12, c = mu * 0.03;
    const double m = a * a - c * c, h = a * a + c * c * std::cos(b);
    const double raises = W * (h + std::sqrt(h * h - m * m)) / m, lets_down = W * (h - std::sqrt(h * h - m * m)) / m;
    const SolvedText solved(fmt::format(
        "given: {{P: {} N, W: {} N, b: {} rad, a: 0.12 m}}\npoints: {{O: [0, 0, 0], A: [-0.12 m, 0, 0], B: [a*cos(b), "
        "a*sin(b), 0]}}\nbodies: {{wheel: {{mass: 1 kg, center: O, inertia: {{axis: z, axial: 0.01 kg*m^2, "
        "transverse: 0.01 kg*m^2}}}}}}\njoints: {{shaft: {{revolute: z, at: O, to: wheel, rate: 0, friction: "
        "{{coefficient: {}, radius: 30 mm}}}}}}\nloads:\n  load: {{force: [0, -W, 0], at: A, body: wheel}}\n"
        "  pull: {{force: [P*sin(b), -P*cos(b), 0], at: B, body: wheel}}\ngravity: none\n"
        "ask: {{most: {{largest: P, while: sticking(shaft)}}, least: {{smallest: P, while: sticking(shaft)}}}}\n",
        W, W, b, mu));
    EXPECT_NEAR(solved.number("most"), raises, 1e-6 * raises);
    EXPECT_NEAR(solved.number("least"), lets_down, 1e-6 * lets_down);
  }
}

// A rod that falls on its journal: I a = -m g l cos q - s M, M = c R, R the force that m a_G needs beside the weight.
TEST(JointBearings, ARodTurnsAgainstTheFrictionOfItsOwnReaction) {
  std::mt19937 random(32);
  std::uniform_real_distribution<double> angle(-1, 1), speed(-9, 9), coefficient(0.1, 0.6);
  for (int trial = 0; trial < 6; ++trial) {
    const double q = angle(random), w = speed(random), c = 0.02 * coefficient(random), m = 2, l = 0.5;
    const double I = m * l * l * 4 / 3, s = w > 0 ? 1 : -1;
    double M = 0;  // by substitution, which the small radius lets converge
    for (int k = 0; k < 200; ++k) {
      const double a = (-m * g * l * std::cos(q) - s * M) / I;
      M = c * m *
          std::hypot(-a * l * std::sin(q) - w * w * l * std::cos(q), a * l * std::cos(q) - w * w * l * std::sin(q) + g);
    }
    const SolvedText solved(fmt::format(
        "given: {{q: {} rad, l: 0.5 m}}\npoints: {{O: [0, 0, 0], A: [2*l*cos(q), 2*l*sin(q), 0]}}\n"
        "bodies: {{rod: {{rod: [O, A], mass: 2 kg}}}}\njoints: {{pin: {{revolute: z, at: O, to: rod, rate: {} rad/s, "
        "friction: {{coefficient: {}, radius: 20 mm}}}}}}\ngravity: -y\n"
        "ask: {{M: friction(pin on rod).z, a: angular_acceleration(rod).z, R: norm(reaction(pin)), s: sliding(pin)}}\n",
        q, w, c / 0.02));
    EXPECT_TRUE(solved.found("s").value.truth);
    EXPECT_NEAR(solved.number("M"), -s * M, 1e-9);
    EXPECT_NEAR(solved.number("R"), M / c, 1e-7);
    EXPECT_NEAR(solved.number("a"), (-m * g * l * std::cos(q) - s * M) / I, 1e-8);
  }
}

// A shaft in two bearings, as supports, and the same with its length: each bearing takes its part by the lever.
TEST(JointBearings, TwoBearingsTakeTheirPartsOfTheLoad) {
  const double W = 300, x = 0.7, L = 0.4, mu = 0.2, r = 0.015, m = 3;
  for (const bool supports : {true, false}) {
    const SolvedText solved(
        "points: {O: [0, 0, 0], A: [0, 0, -0.2 m], B: [0, 0, 0.2 m], C: [0, 0, 0.7 m]}\n"
        "bodies: {shaft: {mass: 3 kg, center: O, inertia: {axis: z, axial: 0.01 kg*m^2, transverse: 0.2 kg*m^2}}}\n"
        "joints: {run: {revolute: z, at: O, to: shaft, angle: q, rate: 40 rad/s, friction: {coefficient: 0.2, radius: "
        "15 mm" +
        std::string(supports ? "}, supports: {A: [x, y, z], B: [x, y]}" : ", length: 0.4 m}") +
        "}}\nloads: {load: {force: [0, -300 N, 0], at: C, body: shaft}}\ngravity: -y\n"
        "ask: {M: friction(run on shaft).z, q: q @ 0.1 s, t: {first_time: sticking(run)}}\n");
    const double at_B = (W * (x + L / 2) + m * g * L / 2) / L, at_A = W + m * g - at_B;
    const double M = mu * r * (std::abs(at_A) + at_B);
    EXPECT_NEAR(solved.number("M"), -M, 1e-9);
    EXPECT_NEAR(solved.number("q"), 40 * 0.1 - M / 0.01 * 0.005, 1e-8);
    EXPECT_NEAR(solved.number("t"), 40 * 0.01 / M, 1e-9);
  }
}

// By the textbooks' angle of friction, with the flanks inclined: T = W r tan(lambda + phi), tan phi = mu / cos b_n.
TEST(JointBearings, AScrewTakesTheCoupleOfItsCone) {
  std::mt19937 random(33);
  std::uniform_real_distribution<double> lead(0.002, 0.06), coefficient(0.05, 0.3), flank(0, 60);
  for (int trial = 0; trial < 4; ++trial) {
    const double h = lead(random) / (2 * std::numbers::pi), r = 0.02, mu = coefficient(random), W = 5000,
                 full = flank(random) * std::numbers::pi / 180, lambda = std::atan(h / r),
                 normal = std::atan(std::cos(lambda) * std::tan(full / 2)), phi = std::atan(mu / std::cos(normal));
    const auto text = [&](double rate, double couple) {
      return fmt::format(
          "given: {{C: {} N*m}}\npoints: {{O: [0, 0, 0]}}\nbodies: {{load: {{mass: 1 kg, center: O, inertia: {{axis: "
          "y, "
          "axial: 1 kg*m^2, transverse: 1 kg*m^2}}}}}}\njoints: {{jack: {{screw: y, at: O, to: load, pitch: {} m/rev, "
          "rate: {} rad/s, couple: C, friction: {{coefficient: {}, radius: 20 mm, thread_angle: {} rad}}}}}}\n"
          "loads: {{weight: {{force: [0, -5000 N, 0], at: O, body: load}}}}\ngravity: none\n",
          couple, h * 2 * std::numbers::pi, rate, mu, full);
    };
    const double raises = W * r * std::tan(lambda + phi), lets_down = W * r * std::tan(lambda - phi);
    const SolvedText limits(text(0, (raises + lets_down) / 2) + "ask: {most: {largest: C, while: sticking(jack)}}\n");
    EXPECT_NEAR(limits.number("most"), raises, 1e-6 * raises);
    // With the couple that it takes it goes on without acceleration, either way.
    const SolvedText up(text(3, raises) + "ask: {a: angular_acceleration(load).y}\n");
    EXPECT_NEAR(up.number("a"), 0, 1e-9 * raises);
    const SolvedText down(text(-3, lets_down) + "ask: {a: angular_acceleration(load).y, s: sticking(jack)}\n");
    EXPECT_NEAR(down.number("a"), 0, 1e-9 * raises);
    EXPECT_FALSE(down.found("s").value.truth);
    // At rest without a couple it holds just where phi exceeds lambda.
    const SolvedText free(text(0, 0) + "ask: {s: sticking(jack)}\n");
    EXPECT_EQ(free.found("s").value.truth, phi > lambda);
  }
}

TEST(JointBearings, AGuideCountsItsForceAsAVector) {
  const SolvedText solved(
      "points: {O: [0, 0, 0]}\nbodies: {block: {cube: {center: O, side: 50 mm}, mass: 2 kg}}\n"
      "joints: {slot: {prismatic: x, at: O, to: block, displacement: s, rate: 5 m/s, friction: {coefficient: "
      "{static: 0.4, kinetic: 0.3}}}}\nloads: {side: {force: [0, 0, 12 N], at: O, body: block}}\ngravity: -y\n"
      "ask: {F: friction(slot on block).x, t: {first_time: sticking(slot)}, s: s @ 9 s, E: kinetic_energy(block) @ 0.5 "
      "s}\n");
  const double a = 0.3 * std::hypot(2 * g, 12) / 2;
  EXPECT_NEAR(solved.number("F"), -2 * a, 1e-10);
  EXPECT_NEAR(solved.number("t"), 5 / a, 1e-9);
  EXPECT_NEAR(solved.number("s"), 25 / (2 * a), 1e-8);
  EXPECT_NEAR(solved.number("E"), std::pow(5 - 0.5 * a, 2), 1e-8);
}

// In letters: the friction of a pulley, and the quadratic of a load across a pull.
TEST(JointBearings, LettersTellTheFriction) {
  const std::string text =
      "letters: {W: N, a: m, r: m, mu: 1}\ngiven: {I: 2 kg*m^2, n: 3 rad/s}\npoints: {O: [0, 0, 0], A: [a, 0, 0]}\n"
      "bodies: {wheel: {mass: 1 kg, center: O, inertia: {axis: z, axial: I, transverse: I}}}\n"
      "joints: {axle: {revolute: z, at: O, to: wheel, rate: n, friction: {coefficient: mu, radius: r}}}\n"
      "loads: {load: {force: [0, -W, 0], at: A, body: wheel}}\ngravity: none\nask: {M: friction(axle on wheel).z}\n";
  const SolvedStatement solved = solve_statement(read_statement(text, "test.yaml"), {});
  ASSERT_EQ(solved.solutions.size(), 1U);
  ASSERT_TRUE(solved.solutions.front().asks.front().formula);
}

TEST(JointBearings, MistakesAreTold) {
  const auto text = [](const std::string& joint) {
    return failure_of_text(
        "points: {O: [0, 0, 0], A: [1 m, 0, 0]}\nbodies: {arm: {rod: [O, A], mass: 1 kg}}\njoints: {hinge: {" + joint +
        ", to: arm}}\ngravity: -y\nask: {a: angular_acceleration(arm)}\n");
  };
  const auto says = [](const std::string& failure, const std::string& words) {
    EXPECT_NE(failure.find(words), std::string::npos) << failure;
  };
  says(text("revolute: z, at: O, rate: 0, friction: {coefficient: 0.1}"), "no radius at which it acts");
  says(text("revolute: z, at: O, rate: 0, friction: {radius: 0.1 m}"), "no coefficient of friction");
  says(text("revolute: z, at: O, rate: 0, friction: {coefficient: 0.1, radius: -1 m}"), "a bearing of negative size");
  says(text("revolute: z, at: O, rate: 0, friction: {coefficient: 0.1, thread_angle: 1 rad, radius: 1 m}"),
       "has no thread_angle");
  says(text("prismatic: x, at: O, rate: 0, friction: {coefficient: 0.1, radius: 1 m}"), "a guide needs no radius");
  says(text("prismatic: x, at: O, rate: 0, friction: 0.1"), "states a pure number as its friction");
  says(text("prismatic: x, at: O, rate: 0, friction: {coefficient: 0.1, length: 0 m}"), "a bearing without size");
  says(text("prismatic: x, rate: 0, friction: {coefficient: 0.1, length: 1 m}"), "and not where");
  says(text("screw: x, at: O, rate: 0, pitch: 2 mm/rev, friction: 2 N*m"), "whose friction follows from its thread");
  says(text("screw: x, at: O, rate: 0, pitch: 2 mm/rev, friction: {coefficient: 0.1}"), "no radius of its thread");
  says(text("revolute: z, at: O, rate: 0, friction: {coefficient: 0.1, static: 2, radius: 1 m}"),
       "and static: beside it");
}

}  // namespace joint_bearings_test
}  // namespace poinsot::problem
