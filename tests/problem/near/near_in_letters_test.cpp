// Frequencies, rates and responses in letters against closed forms at random.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace near_in_letters_test {
namespace {

const Value<Formula>& formula(const SolvedText& solved, const std::string& name) {
  static const Value<Formula> none;
  const SolvedAsk& ask = solved.ask(name);
  EXPECT_TRUE(ask.formula) << name << ": " << ask.no_formula;
  return ask.formula ? *ask.formula : none;
}

std::string cart(const std::string& asks) {
  return "title: t\nletters: {M: kg, m: kg, K: N/m, k: N/m, c: N*s/m, F: N, w: rad/s}\n"
         "points: {A: [0, 0, 0], B: [1 m, 0, 0]}\n"
         "bodies: {one: {particle: A, mass: M}, two: {particle: B, mass: m}}\n"
         "joints:\n  rail: {prismatic: x, at: A, to: one, displacement: s, spring: {stiffness: K}}\n"
         "  slide: {prismatic: x, at: B, from: one, to: two, displacement: u, spring: {stiffness: k}, damping: c}\n"
         "excitations: {push: {force: F, along: x, body: one, frequency: w}}\n"
         "gravity: none\ninstants: {now: rest}\nask: {" +
         asks + "}\n";
}

// Jeffcott's rotor, with its weight across the shaft that an unbalance does not feel, and a force that goes against the
// spin.
TEST(NearInLetters, AnUnbalanceAndAForceThatGoesRound) {
  const SolvedText solved(
      "title: t\nletters: {m: kg, k: N/m, q: N/m, c: N*s/m, U: kg*m, F: N, n: rad/s, w: rad/s}\n"
      "points: {O: [0, 0, 0]}\nbodies:\n  hub: massless\n"
      "  disk: {mass: m, center: O, inertia: {axis: z, axial: 0.2 kg*m^2, transverse: 0.1 kg*m^2}}\n"
      "joints:\n  shaft:\n    planar: z\n    at: O\n    to: hub\n    freedoms:\n"
      "      slide1: {displacement: u, spring: {stiffness: k}, damping: c}\n"
      "      slide2: {displacement: v, spring: {stiffness: q}, damping: c}\n"
      "      turn: {angle: 0 deg, rate: 0, accel: 0}\n"
      "  axle: {revolute: z, at: O, from: hub, to: disk, rate: n, accel: 0}\n"
      "excitations:\n  heavy: {unbalance: U, along: x, body: disk}\n"
      "  back: {force: F, along: x, at: O, turns: -z, body: hub, frequency: w}\n"
      "gravity: none\nsteady: {frame: ground, spins: {disk: {about: z, rate: n}}}\n"
      "ask: {u: response(u to heavy), v: response(v to heavy), back: response(v to back)}\n");
  std::mt19937 random(11);
  std::uniform_real_distribution<double> draw(0.5, 2);
  const std::complex<double> i(0, 1);
  for (int trial = 0; trial < 20; ++trial) {
    const double m = draw(random), k = draw(random), q = draw(random), c = draw(random), U = draw(random),
                 F = draw(random), n = draw(random), w = draw(random);
    const LetterValues at{{"m", m}, {"k", k}, {"q", q}, {"c", c}, {"U", U}, {"F", F}, {"n", n}, {"w", w}};
    const auto near = [&](const std::string& name, const std::complex<double>& swing) {
      const auto& items = formula(solved, name).items;
      ASSERT_EQ(items.size(), 2U);
      EXPECT_NEAR(value_at(items[0].number, at), std::abs(swing), 1e-12 * std::abs(swing)) << name;
      EXPECT_NEAR(std::remainder(value_at(items[1].number, at) - std::arg(swing), 2 * std::acos(-1)), 0, 1e-11) << name;
    };
    near("u", U * n * n / (k - m * n * n + i * c * n));
    near("v", -i * U * n * n / (q - m * n * n + i * c * n));
    near("back", i * F / (q - m * w * w + i * c * w));
  }
}

TEST(NearInLetters, ADampedSwingAndItsResponse) {
  const SolvedText solved(
      "title: t\nletters: {m: kg, k: N/m, c: N*s/m, F: N, w: rad/s}\npoints: {A: [0, 0, 0]}\n"
      "bodies: {one: {particle: A, mass: m}}\n"
      "joints: {rail: {prismatic: x, at: A, to: one, displacement: s, spring: {stiffness: k}, damping: c}}\n"
      "excitations: {push: {force: F, along: x, body: one, frequency: w}}\n"
      "gravity: none\ninstants: {now: rest}\n"
      "ask: {rates: eigenvalues(one), X: response(s to push)}\n");
  std::mt19937 random(3);
  std::uniform_real_distribution<double> draw(0.5, 2);
  int under = 0;
  for (int i = 0; i < 30; ++i) {
    const double m = draw(random), k = draw(random), c = draw(random), F = draw(random), w = draw(random);
    const LetterValues at{{"m", m}, {"k", k}, {"c", c}, {"F", F}, {"w", w}};
    const std::complex<double> X = F / std::complex<double>(k - m * w * w, c * w);
    const auto& response = formula(solved, "X").items;
    ASSERT_EQ(response.size(), 2U);
    EXPECT_NEAR(value_at(response[0].number, at), std::abs(X), 1e-12 * std::abs(X));
    EXPECT_NEAR(value_at(response[1].number, at), std::arg(X), 1e-12);
    const double square = k / m - c * c / (4 * m * m);
    if (square <= 0) continue;
    ++under;
    const auto& rates = formula(solved, "rates").items;
    ASSERT_EQ(rates.size(), 1U);
    EXPECT_NEAR(value_at(rates[0].items[0].number, at), -c / (2 * m), 1e-12);
    EXPECT_NEAR(value_at(rates[0].items[1].number, at), std::sqrt(square), 1e-11);
  }
  EXPECT_GT(under, 10);
}

TEST(NearInLetters, TwoFreedomsThatADamperTies) {
  const SolvedText solved(cart("X: response(center(two).x to push)"));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> draw(0.5, 2);
  for (int i = 0; i < 20; ++i) {
    const double M = draw(random), m = draw(random), K = draw(random), k = draw(random), c = draw(random),
                 F = draw(random), w = draw(random);
    const LetterValues at{{"M", M}, {"m", m}, {"K", K}, {"k", k}, {"c", c}, {"F", F}, {"w", w}};
    // On absolute places: (K + z - M w^2) x - z y = F, (z - m w^2) y = z x with z = k + i c w.
    const std::complex<double> z(k, c * w), x_over_y = (z - m * w * w) / z,
                                            Y = F / ((K + z - M * w * w) * x_over_y - z);
    const auto& response = formula(solved, "X").items;
    ASSERT_EQ(response.size(), 2U);
    EXPECT_NEAR(value_at(response[0].number, at), std::abs(Y), 1e-11 * std::abs(Y));
    EXPECT_NEAR(std::remainder(value_at(response[1].number, at) - std::arg(Y), 2 * M_PI), 0, 1e-11);
  }
}

TEST(NearInLetters, TwoFreedomsAreTheRootsOfAQuadratic) {
  const SolvedText solved(
      "title: t\nletters: {M: kg, m: kg, K: N/m, k: N/m}\npoints: {A: [0, 0, 0], B: [1 m, 0, 0]}\n"
      "bodies: {one: {particle: A, mass: M}, two: {particle: B, mass: m}}\n"
      "joints:\n  rail: {prismatic: x, at: A, to: one, displacement: s, spring: {stiffness: K}}\n"
      "  slide: {prismatic: x, at: B, from: one, to: two, displacement: u, spring: {stiffness: k}}\n"
      "gravity: none\ninstants: {now: rest}\nask: {f: frequencies(system)}\n");
  std::mt19937 random(11);
  std::uniform_real_distribution<double> draw(0.3, 3);
  for (int i = 0; i < 20; ++i) {
    const double M = draw(random), m = draw(random), K = draw(random), k = draw(random);
    const LetterValues at{{"M", M}, {"m", m}, {"K", K}, {"k", k}};
    const auto& f = formula(solved, "f").items;
    ASSERT_EQ(f.size(), 2U);
    for (const auto& one : f) {
      const double square = std::pow(value_at(one.number, at), 2);
      EXPECT_NEAR((K + k - M * square) * (k - m * square), k * k, 1e-10 * (K + k) * (k + m * square));
    }
    EXPECT_LT(value_at(f[0].number, at), value_at(f[1].number, at));
  }
}

// A bob on a ball joint, whose turning about its string is no coordinate by itself and moves nothing.
TEST(NearInLetters, AConicalPendulumOnABallJoint) {
  const SolvedText solved(
      "title: t\nletters: {L: m, b: rad, g: m/s^2}\npoints: {O: [0, 0, 0], P: '[L*sin(b), -L*cos(b), 0]'}\n"
      "frames: {f: {turns: y, rate: sqrt(g/(L*cos(b)))}}\nbodies: {bob: {particle: P, mass: any}}\n"
      "joints: {s: {ball: O, to: bob}}\nsteady: {frame: f}\ngravity: -y\nask: {f: frequencies(bob)}\n");
  std::mt19937 random(12);
  std::uniform_real_distribution<double> draw(0.3, 1.4);
  for (int i = 0; i < 20; ++i) {
    const double L = draw(random), b = draw(random), g = draw(random);
    const auto& f = formula(solved, "f").items;
    ASSERT_EQ(f.size(), 1U);
    const double expected = std::sqrt(g * (1 + 3 * std::pow(std::cos(b), 2)) / (L * std::cos(b)));
    EXPECT_NEAR(value_at(f[0].number, {{"L", L}, {"b", b}, {"g", g}}), expected, 1e-12 * expected);
  }
}

// The rate at which it circles is found: only with its formula the motion is steady.
TEST(NearInLetters, AConicalPendulumWhoseRateIsFound) {
  const SolvedText solved(
      "title: t\nletters: {m: kg, L: m, b: rad}\nfind: {W: rad/s}\nwhere: [W > 0]\nassume: [10 deg < b < 80 deg]\n"
      "points: {O: [0, 0, 0], P: '[L*sin(b), 0, -L*cos(b)]'}\nframes: {f: {turns: z, rate: W}}\n"
      "bodies: {bob: {particle: P, mass: m}}\n"
      "joints: {pin: {universal: [z, y], at: O, to: bob, freedoms: {first: {angle: phi}, second: {angle: th}}}}\n"
      "steady: {frame: f}\ngravity: -z\nask: {f: frequencies(bob), e: '[W, max(frequencies(system))]'}\n");
  std::mt19937 random(13);
  std::uniform_real_distribution<double> draw(0.3, 1.3);
  for (int i = 0; i < 20; ++i) {
    const double L = draw(random), b = draw(random), W = std::sqrt(9.80665 / (L * std::cos(b)));
    const LetterValues at{{"m", 1}, {"L", L}, {"b", b}};
    const auto &f = formula(solved, "f").items, &e = formula(solved, "e").items;
    ASSERT_EQ(f.size(), 1U);
    const double expected = W * std::sqrt(1 + 3 * std::pow(std::cos(b), 2));
    EXPECT_NEAR(value_at(f[0].number, at), expected, 1e-12 * expected);
    ASSERT_EQ(e.size(), 2U);
    EXPECT_NEAR(value_at(e[0].number, at), W, 1e-12 * W);
    EXPECT_NEAR(value_at(e[1].number, at), expected, 1e-12 * expected);
  }
}

// A sleeping top tilts by exp(i p t) with J p^2 - I s p + m g c = 0, here with J = 2 m c^2 = 2 I: it swings where the
// roots are real, and falls as it goes round where they are not.
TEST(NearInLetters, ASleepingTopWhereItStandsAndWhereItFalls) {
  const auto solved_where = [](const std::string& spin) {
    return SolvedText("title: t\nletters: {m: kg, c: m, g: m/s^2, s: rad/s}\nassume: [" + spin +
                      "]\ngiven: {J: 2*m*c^2}\npoints: {O: [0, 0, 0], G: [0, 0, c]}\n"
                      "bodies: {top: {mass: m, center: G, inertia: {about: O, axis: z, axial: J/2, transverse: J}}}\n"
                      "joints: {t: {ball: O, to: top}}\n"
                      "steady: {frame: ground, spins: {top: {about: z, rate: s}}}\n"
                      "gravity: -z\nask: {f: frequencies(top), grows: growth_rate(top)}\n");
  };
  const SolvedText stands = solved_where("s^2 > 8*g/c"), falls = solved_where("s^2 < 8*g/c");
  for (const double s : {6.0, 9.0}) {
    const LetterValues at{{"m", 0.7}, {"c", 0.5}, {"g", 1.3}, {"s", s}};
    const auto& f = formula(stands, "f").items;
    ASSERT_EQ(f.size(), 2U);
    EXPECT_NEAR(value_at(f[0].number, at), (s - std::sqrt(s * s - 8 * 1.3 / 0.5)) / 4, 1e-12);
    EXPECT_NEAR(value_at(f[1].number, at), (s + std::sqrt(s * s - 8 * 1.3 / 0.5)) / 4, 1e-12);
  }
  for (const double s : {1.0, 4.0}) {
    const LetterValues at{{"m", 0.7}, {"c", 0.5}, {"g", 1.3}, {"s", s}};
    const auto& f = formula(falls, "f").items;
    ASSERT_EQ(f.size(), 2U);  // of what grows and of what dies out
    for (const auto& one : f) EXPECT_NEAR(value_at(one.number, at), s / 4, 1e-12);
    EXPECT_NEAR(value_at(formula(falls, "grows").number, at), std::sqrt(8 * 1.3 / 0.5 - s * s) / 4, 1e-12);
  }
}

// A satellite free in space: what its frame rides on says nothing of the mass center, and what is tilted for good only
// goes round in it.
void expect_nutation(const std::string& bodies, const std::string& more, double of_wheel) {
  const SolvedText solved(
      "title: t\nletters: {I: kg*m^2, J: kg*m^2, K: kg*m^2, W: rad/s, n: rad/s}\n"
      "points: {G: [0, 0, 0]}\nbodies:\n" +
      bodies + "frames: {f: {rides_on: center(bus), turns: z, rate: W}}\n" + more +
      "ask: {f: frequencies(bus), e: eigenvalues(system)}\n");
  std::mt19937 random(17);
  std::uniform_real_distribution<double> draw(0.5, 2);
  for (int trial = 0; trial < 20; ++trial) {
    const double I = draw(random), J = draw(random), K = 0.1 * draw(random), W = draw(random), n = 10 * draw(random);
    const LetterValues at{{"I", I}, {"J", J}, {"K", K}, {"W", W}, {"n", n}};
    const double swing = std::abs((I * W + of_wheel * K * (n + W)) / J - W);
    const auto &f = formula(solved, "f").items, &e = formula(solved, "e").items;
    ASSERT_EQ(f.size(), 1U);
    EXPECT_NEAR(value_at(f[0].number, at), swing, 1e-12);
    ASSERT_EQ(e.size(), 1U);
    EXPECT_EQ(value_at(e[0].items[0].number, at), 0);
    EXPECT_NEAR(value_at(e[0].items[1].number, at), swing, 1e-12);
  }
}

TEST(NearInLetters, ASatelliteInAFrameThatRidesOnIt) {
  expect_nutation("  bus: {mass: 3 kg, center: G, inertia: {axis: z, axial: I, transverse: J}}\n",
                  "steady: {frame: f}\ngravity: -x\n", 0);
  expect_nutation(
      "  bus: {mass: 3 kg, center: G, inertia: {axis: z, axial: I, transverse: J - K/2}}\n"
      "  wheel: {mass: 1 kg, center: G, inertia: {axis: z, axial: K, transverse: K/2}}\n",
      "joints: {axle: {revolute: z, at: G, from: bus, to: wheel, rate: n, accel: 0}}\n"
      "steady: {frame: f, spins: {wheel: {about: z, rate: n}}}\ngravity: none\n",
      1);
}

// A rod that hangs on a shaft that turns stands out wherever it does, and a bead on a hoop that turns slowly need not
// stay at the bottom.
TEST(NearInLetters, StabilityForAllLettersAndForSome) {
  const SolvedText stands(
      "title: t\nletters: {L: m, w: rad/s}\nfind: {b: deg}\nwhere: [0 deg < b < 90 deg]\n"
      "points: {O: [0, 0, 0], A: '[L*sin(b), -L*cos(b), 0]'}\nbodies: {shaft: massless, rod: {rod: [O, A], mass: 2 "
      "kg}}\n"
      "joints: {s: {revolute: y, at: O, to: shaft, rate: w, accel: 0}, p: {revolute: z, at: O, from: shaft, to: rod}}\n"
      "gravity: -y\nsteady: {frame: shaft}\nask: {st: stable(rod), word: stability(rod)}\n");
  EXPECT_EQ(stands.ask("st").state, AskState::found) << stands.ask("st").no_formula;
  EXPECT_TRUE(stands.ask("st").value.truth);
  EXPECT_EQ(stands.ask("word").value.text, "stable");
  const SolvedText hangs(
      "title: t\nletters: {R: m, w: rad/s}\npoints: {O: [0, 0, 0], P: [0, 0, -R]}\nframes: {f: {turns: z, rate: w}}\n"
      "bodies: {bead: {particle: P, mass: 1 kg}}\njoints: {hoop: {revolute: y, at: O, from: f, to: bead, angle: t}}\n"
      "steady: {frame: f}\ngravity: -z\nask: {st: stability(bead)}\n");
  EXPECT_EQ(hangs.ask("st").state, AskState::needs_letters);
  EXPECT_EQ(hangs.ask("st").no_formula, "it is not the same for all letters");
}

// Three freedoms that do not fall apart have a cubic, and what has a damper between two freedoms a quartic.
TEST(NearInLetters, WhatHasNoFormulaIsLeftToNumbers) {
  const SolvedText solved(cart("f: frequencies(system)"));
  EXPECT_FALSE(solved.ask("f").formula);
  EXPECT_EQ(solved.ask("f").state, AskState::needs_letters);
}

}  // namespace
}  // namespace near_in_letters_test
}  // namespace poinsot::problem
