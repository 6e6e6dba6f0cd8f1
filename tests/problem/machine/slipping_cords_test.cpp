// Cords with friction, belts and chains against closed forms at random, and what is refused of them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "problem/course/motion_support.h"
#include "problem/language/failure.h"

namespace poinsot::problem {
namespace slipping_cords_test {

constexpr double g = 9.80665, pi = std::numbers::pi;

std::string in(double value, const std::string& unit) { return std::to_string(value) + " " + unit; }
double rounded(double value) { return std::round(value * 1e3) / 1e3; }

// Two blocks over a post: at rest while neither weight is more than e^(mu pi) times the other; else the heavy one sinks
// with that ratio of the tensions.
TEST(SlippingCords, BlocksOverAPostAtRandom) {
  std::mt19937 random(71);
  std::uniform_real_distribution<double> part(0.3, 3);
  int held = 0, slipped = 0;
  for (int i = 0; i < 16; ++i) {
    const double m = rounded(part(random)), M = rounded(part(random)), mu = rounded(0.2 * part(random));
    const double R = std::exp(mu * pi);
    const bool slips = M > R * m || m > R * M;
    const double a = M > R * m   ? g * (M - R * m) / (M + R * m)
                     : m > R * M ? -g * (m - R * M) / (m + R * M)
                                 : 0;  // of the block m, upward
    (slips ? slipped : held)++;
    const SolvedText solved(
        "title: t\ngiven: {m: " + in(m, "kg") + ", M: " + in(M, "kg") + ", mu: " + std::to_string(mu) +
        "}\npoints: {O: [0, 0, 0], A: [-0.1 m, -1 m, 0], B: [0.1 m, -2 m, 0]}\n"
        "bodies: {a: {particle: A, mass: m}, b: {particle: B, mass: M}}\n"
        "cords: {rope: {from: a, at: A, over: [{O: {radius: 0.1 m, friction: mu}}], to: b, end: B}}\n"
        "gravity: -y\ninstants: {now: rest}\n"
        "ask: {a: acceleration(a).y, T: tension(rope from a to O), S: tension(rope from O to b), "
        "v: velocity(b).y @ 0.1 s}\n");
    EXPECT_NEAR(solved.number("a"), a, 1e-9);
    EXPECT_NEAR(solved.number("T"), m * (g + a), 1e-8);
    EXPECT_NEAR(solved.number("S"), M * (g - a), 1e-8);
    EXPECT_NEAR(solved.number("v"), -0.1 * a, 1e-8);
  }
  EXPECT_GT(held, 2);
  EXPECT_GT(slipped, 2);
}

// A cord through a rough ring to the end of an arm: its angle there, and with it the ratio of its tensions, is that of
// the pose in which the arm stands.
TEST(SlippingCords, TheAngleFollowsThePose) {
  for (const double angle : {0.0, 0.3, -0.4}) {
    const SolvedText solved(
        "title: t\npoints: {O: [0, 0, 0], A: [-1 m, 0, 0], B: [1 m, -1 m, 0], C: [1 m, -2 m, 0]}\n"
        "bodies: {a: {particle: A, mass: 1 kg}, arm: {rod: [C, B], mass: 1 kg}}\n"
        "joints: {turns: {revolute: z, at: C, to: arm, angle: th}, slides: {prismatic: x, at: A, to: a}}\n"
        "cords: {rope: {from: a, at: A, over: [{O: {friction: 0.3}}], to: arm, end: B}}\n"
        "loads: {pull: {force: [50 N, 0, 0], at: B, body: arm}}\ngravity: none\n"
        "facts: {th: " +
        std::to_string(angle) +
        " rad, velocity(a): [0, 0, 0]}\nask: {T: tension(rope on a), S: tension(rope on arm), v: norm(velocity(B of "
        "arm))}\n");
    const double x = 1 - std::sin(angle), y = -2 + std::cos(angle);
    EXPECT_NEAR(solved.number("S") / solved.number("T"), std::exp(0.3 * std::acos(x / std::hypot(x, y))), 1e-9);
    EXPECT_NEAR(solved.number("v"), 0, 1e-12);
  }
}

// What a belt carries follows from its initial tension, whatever the radii and the distance; crossed or open.
TEST(SlippingCords, BeltsAtRandom) {
  std::mt19937 random(72);
  std::uniform_real_distribution<double> part(0.3, 1);
  for (int i = 0; i < 12; ++i) {
    const double r = rounded(0.2 * part(random)), R = rounded(0.2 * part(random)), M = rounded(4 * part(random)),
                 T0 = 200, I = rounded(0.1 * part(random)), J = rounded(part(random));
    const bool crossed = i % 2;
    const double al = M / (I + J * r * r / (R * R)), difference = J * al * r / (R * R);
    const SolvedText solved(
        "title: t\ngiven: {T0: 200 N, M: " + in(M, "N*m") + "}\npoints: {A: [0, 0, 0], B: [1 m, 0, 0]}\nbodies:\n" +
        "  a: {mass: 1 kg, center: A, inertia: {axis: z, axial: " + in(I, "kg*m^2") + ", transverse: " +
        in(I, "kg*m^2") + "}}\n  b: {mass: 1 kg, center: B, inertia: {axis: z, axial: " + in(J, "kg*m^2") +
        ", transverse: " + in(J, "kg*m^2") +
        "}}\njoints: {one: {revolute: z, at: A, to: a, couple: M}, other: {revolute: z, at: B, to: b}}\n"
        "belts: {belt: {over: [{a: {radius: " +
        in(r, "m") + ", friction: 0.4}}, {b: {radius: " + in(R, "m") + "}}], tension: T0" +
        (crossed ? ", crossed: true" : "") +
        "}}\ngravity: none\ninstants: {now: rest}\n"
        "ask: {al: angular_acceleration(a).z, be: angular_acceleration(b).z, tight: tension(belt from b to a), slack: "
        "tension(belt from a to b), bearing: force(one on a).x, w: angular_velocity(b).z @ 0.5 s, most: {largest: M, "
        "while: sticking(belt)}}\n");
    const double be = (crossed ? -1 : 1) * al * r / R;
    EXPECT_NEAR(solved.number("al"), al, 1e-8);
    EXPECT_NEAR(solved.number("be"), be, 1e-8);
    EXPECT_NEAR(solved.number("w"), be / 2, 1e-8);
    EXPECT_NEAR(solved.number("tight"), T0 + difference / 2, 1e-8);
    EXPECT_NEAR(solved.number("slack"), T0 - difference / 2, 1e-8);
    const double h = crossed ? r + R : R - r, along = std::sqrt(1 - h * h);
    EXPECT_NEAR(solved.number("bearing"), -2 * T0 * along, 1e-8);
    const double beta = pi + (crossed ? 2 : -2) * std::asin(h);
    EXPECT_NEAR(solved.number("most") * difference / M, 2 * T0 * std::tanh(0.4 * beta / 2), 2e-3);
  }
}

std::string with(const std::string& cords) {
  return "title: t\npoints: {O: [0, 0, 0], C: [1 m, 0, 0], A: [-0.1 m, -1 m, 0], B: [0.1 m, -1 m, 0]}\n"
         "bodies: {a: {particle: A, mass: 1 kg}, b: {particle: B, mass: 2 kg}, w: {disk: {center: O, normal: z, "
         "radius: 0.1 m}, mass: 1 kg}, v: {disk: {center: C, normal: z, radius: 0.2 m}, mass: 1 kg}}\n"
         "joints: {axle: {revolute: z, at: O, to: w}, other: {revolute: z, at: C, to: v, couple: 50 N*m}}\n" +
         cords + "\ngravity: -y\ninstants: {now: rest}\nask: {a: acceleration(a).y}\n";
}

TEST(SlippingCords, MistakesAreTold) {
  for (const auto& [cords, words] : std::initializer_list<std::pair<std::string, std::string>>{
           {"cords: {rope: {from: a, at: A, over: [{O: {radius: 0.1 m, friction: 0.2, turns: 2.25}}], to: b, end: B}}",
            "goes round 'O' by 2.25 turns, and as drawn by 0.5"},
           {"cords: {rope: {from: a, at: A, over: [{O: {radius: 0.1 m, friction: -0.2}}], to: b, end: B}}",
            "has a negative coefficient of friction"},
           {"cords: {rope: {from: a, at: A, over: [{w: {smooth: true, friction: 0.2}}], to: b, end: B}}",
            "is smooth and has friction"},
           {"cords: {rope: {from: a, at: A, over: [{w: {turns: 2}}], to: b, end: B}}",
            "matters for its friction alone"},
           {"belts: {belt: {over: [w]}}", "goes round one wheel only"},
           {"belts: {belt: {over: [w, {ground: {at: A, radius: 0.1 m}}]}}", "turns fewer than two wheels"},
           {"belts: {belt: {over: [{w: {friction: 0.1}}, v], tension: 20 N}}", "slips: its friction does not hold"},
           {"chains: {chain: {over: [{w: {friction: 0.1}}, v]}}", "a chain does not slip"}}) {
    EXPECT_NE(failure_of([&, text = with(cords)] { const SolvedText solved(text); }).find(words), std::string::npos)
        << words;
  }
}

// Some turns round a post, and a pull under an angle that is a letter: Euler's law in letters.
TEST(SlippingCords, LimitsHaveFormulasInLetters) {
  std::mt19937 random(75);
  std::uniform_real_distribution<double> part(0.3, 1.2);
  for (const double turns : {0.5, 1.5, 2.5}) {
    const SolvedText solved(
        "title: t\nletters: {W: N, P: N, mu: 1, r: m, h: m}\npoints: {O: [0, 0, 0], A: [-r, -h, 0], B: [r, -h, 0]}\n"
        "bodies: {a: {particle: A, mass: 1 kg}, b: {particle: B, mass: 1 kg}}\n"
        "cords: {rope: {from: a, at: A, over: [{O: {radius: r, friction: mu, turns: " +
        std::to_string(turns) +
        "}}], to: b, end: B}}\n"
        "loads: {one: {force: [0, -W, 0], at: A, body: a}, two: {force: [0, -P, 0], at: B, body: b}}\n"
        "gravity: none\ninstants: {now: rest}\n"
        "ask: {least: {smallest: P, while: sticking(rope)}, most: {largest: P, while: sticking(rope)}}\n");
    for (const auto& [name, sign] : {std::pair{"least", -1}, std::pair{"most", 1}}) {
      ASSERT_TRUE(solved.ask(name).formula) << name << ": " << solved.ask(name).no_formula;
      for (int i = 0; i < 3; ++i) {
        const double W = part(random), mu = part(random);
        EXPECT_NEAR(value_at(solved.ask(name).formula->number, {{"W", W}, {"mu", mu}}) / W,
                    std::exp(sign * 2 * pi * turns * mu), 1e-11 * std::exp(2 * pi * turns * mu));
      }
    }
  }
  const SolvedText pulled(
      "title: t\nletters: {Q: N, mu: 1, r: m, h: m, b: rad, I: kg*m^2, w: rad/s}\n"
      "points: {O: [0, 0, 0], A: [-r, -h, 0], B: '[r*sin(b), r*cos(b), 0] + h*[cos(b), -sin(b), 0]'}\n"
      "bodies: {drum: {mass: 1 kg, center: O, inertia: {axis: z, axial: I, transverse: I}}, "
      "grip: {particle: B, mass: 1 kg}}\n"
      "joints: {axle: {revolute: z, at: O, to: drum, rate: w}}\n"
      "cords: {band: {from: ground, at: A, over: [{drum: {radius: r, friction: mu, side: -x}}], to: grip, end: B}}\n"
      "loads: {pull: {force: 'Q*[cos(b), -sin(b), 0]', at: B, body: grip}}\n"
      "gravity: none\nfacts: {velocity(grip): [0, 0, 0]}\n"
      "ask: {T: tension(band from ground to drum)}\n");
  ASSERT_TRUE(pulled.ask("T").formula) << pulled.ask("T").no_formula;
  for (const double b : {0.2, 0.7, 1.3})
    EXPECT_NEAR(value_at(pulled.ask("T").formula->number, {{"Q", 3}, {"mu", 0.4}, {"b", b}}),
                3 * std::exp(-0.4 * (pi / 2 + b)), 1e-12);
}

}  // namespace slipping_cords_test
}  // namespace poinsot::problem
