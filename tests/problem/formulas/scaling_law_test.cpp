// Formulas of answers that are found by following a motion: letters that scale out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "case_count.h"
#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/course/motion_support.h"
#include "problem/formulas/law_shape.h"

namespace poinsot::problem {
namespace scaling_law_test {

using std::numbers::pi;
using Sets = std::vector<std::pair<std::string, std::string>>;

const std::string figure =
    "title: t\npoints: {O: [0, 0, 0], P: [0, -a, 0]}\nbodies: {rod: {rod: [O, P], mass: m}}\n"
    "joints: {pin: {revolute: z, at: O, to: rod, angle: th}}\ngravity: -y\n";
const std::string pendulum = figure + "letters: {a: m, m: kg, g: m/s^2}\ninstants: {start: {th: 40 deg, th': 0}}\n";

std::string formula(const SolvedText& solved, const std::string& name) {
  const SolvedAsk& ask = solved.ask(name);
  return ask.formula ? text(ask.formula->number) : "none: " + ask.no_formula;
}

// What stands in a formula before its letters.
double leading_number(const std::string& formula) { return std::stod(formula); }

TEST(ScalingLaw, APendulumOfAnyLengthMassAndGravity) {
  const SolvedText solved(pendulum +
                          "ask: {T: period(th), w: max(th'), F: max(norm(reaction(pin))), K: max(kinetic_energy(rod)), "
                          "t: {first_time: th == 0}}\n");
  // T = 4 K(sin b/2) sqrt(2 a/(3 g)) and energy from b to the lowest point.
  const double b = 40 * pi / 180, fall = 1 - std::cos(b);
  const double period = 4 * std::comp_ellint_1(std::sin(b / 2)) * std::sqrt(2.0 / 3);
  const auto expect = [&](const std::string& name, double number, const std::string& letters) {
    const std::string found = formula(solved, name);
    ASSERT_TRUE(found.ends_with(letters)) << found;
    const std::string digits = found.substr(0, found.size() - letters.size());
    EXPECT_NEAR(std::stod(digits), number, 1e-11 * number) << found;
  };
  expect("T", period, "*sqrt(a/g)");
  expect("t", period / 4, "*sqrt(a/g)");
  expect("w", std::sqrt(3 * fall), "*sqrt(g/a)");
  expect("F", 1 + 1.5 * fall, "*m*g");
  expect("K", fall / 2, "*m*g*a");
  ASSERT_FALSE(solved.notes().empty());
  EXPECT_EQ(solved.notes().front(), "T, w, F, K and t by dimensional analysis, with numbers of 12 digits");
}

TEST(ScalingLaw, WhatFollowsAnAngle) {
  const SolvedText solved(figure +
                          "letters: {a: m, m: kg, g: m/s^2, b: rad}\ninstants: {start: {th: b, th': 0}}\n"
                          "ask: {T: period(th), w: max(th'), F: max(reaction(pin).y), M: max(th), K: "
                          "max(kinetic_energy(rod))}\n");
  EXPECT_EQ(formula(solved, "M"), "b");
  EXPECT_EQ(formula(solved, "F"), "m*g*(5 - 3*cos(b))/2");
  EXPECT_EQ(formula(solved, "K"), "m*g*a*sin(b/2)^2");
  EXPECT_EQ(formula(solved, "w"), "sin(b/2)*sqrt(6*g/a)");
  EXPECT_EQ(formula(solved, "T"), "none: it depends on b, but as no product of powers, sines and cosines of it");
}

// The push of the pin is least where cos th = cos(b)/3 as long as b is no more than a right angle, then at the start.
TEST(ScalingLaw, AnAngleMayBeBeyondARightAngle) {
  const std::string dropped = figure +
                              "letters: {a: m, m: kg, g: m/s^2, b: rad}\ninstants: {start: {th: b, th': 0}}\n" +
                              "ask: {low: min(reaction(pin).y), high: max(reaction(pin).y), w: max(th')}\n";
  const SolvedText solved(dropped);
  EXPECT_EQ(formula(solved, "low"),
            "none: the formula found holds for some values of the letters only, not at b = 1.75 rad");
  EXPECT_EQ(formula(solved, "high"), "m*g*(5 - 3*cos(b))/2");
  const std::vector<std::string>& assumed = solved.solved().solutions.at(0).assumptions;
  EXPECT_EQ(assumed, std::vector<std::string>{"b is not negative"});
  const SolvedText stated(dropped + "assume: [0 < b, b < 90 deg]\n");
  EXPECT_EQ(formula(stated, "low"), "m*g*(3*cos(b)^2 + 1)/4");
  EXPECT_TRUE(stated.solved().solutions.at(0).assumptions.empty());
}

// From beyond a right angle the bob falls freely until its cord catches it, again and again: nothing is told of that.
TEST(ScalingLaw, AnAngleThatCouldNotBeTriedIsNamed) {
  const SolvedText solved(
      "title: t\nletters: {L: m, m: kg, b: rad}\npoints: {O: [0, 0, 0], B: 'L*[sin(b), -cos(b), 0]'}\n"
      "bodies: {bob: {particle: B, mass: m}}\ncords: {c: {at: O, to: bob, end: B}}\ngravity: -y\n"
      "instants: {start: rest}\nask: {T: max(tension(c)), v: max(norm(velocity(bob)))}\n");
  EXPECT_EQ(formula(solved, "T"), "9.80665*m*(3 - 2*cos(b))");
  ASSERT_TRUE(solved.ask("v").formula);
  EXPECT_NEAR(value_at(solved.ask("v").formula->number, {{"L", 4}, {"b", pi / 3}}), 2 * std::sqrt(9.80665), 1e-10);
  const std::vector<std::string>& assumed = solved.solved().solutions.at(0).assumptions;
  for (const char* words : {"b is such that there is an answer: none was found at 1.75 rad, -2 rad",
                            "b is none of these, which could not be tried: 2.3 rad, 2.9 rad"})
    EXPECT_NE(std::ranges::find(assumed, words), assumed.end()) << words;
}

// Beyond some letters nothing swings, and what grows does so elsewhere only.
TEST(ScalingLaw, FrequenciesHoldWhereWhatIsUnderTheirRootIsPositive) {
  const SolvedText solved(
      "title: t\nletters: {m: kg, L: m, k: N/m, g: m/s^2}\npoints: {O: [0, 0, 0], P: [0, L, 0], W: [L, L, 0]}\n"
      "bodies: {bob: {particle: P, mass: m}}\njoints: {pin: {revolute: z, at: O, to: bob}}\n"
      "springs: {s: {from: ground, at: W, to: bob, end: P, stiffness: k, free_length: L}}\ngravity: -y\n"
      "instants: {now: rest}\nask: {f: frequencies(bob)}\n");
  const SolvedAsk& f = solved.ask("f");
  ASSERT_TRUE(f.formula) << f.no_formula;
  ASSERT_EQ(f.formula->items.size(), 1U);
  for (const auto& [m, L, k, g] : {std::array{1.0, 2.0, 30.0, 9.0}, {3.0, 0.5, 100.0, 2.0}})
    EXPECT_NEAR(value_at(f.formula->items[0].number, {{"m", m}, {"L", L}, {"k", k}, {"g", g}}),
                std::sqrt(k / m - g / L), 1e-8);
}

// How far a pendulum swings has a formula by its cosine, the slope of a fall by its tangent.
TEST(ScalingLaw, AnglesFollowFromTheirCosinesAndTangents) {
  const SolvedText struck(
      "title: t\nletters: {m: kg, M: kg, L: m, v: m/s, g: m/s^2}\npoints: {O: [0, 0, 0], A: [0, -L, 0]}\n"
      "bodies: {rod: {rod: [O, A], mass: M}}\njoints: {pin: {revolute: z, at: O, to: rod, angle: q}}\n"
      "strikes: {bullet: {mass: m, hits: rod, at: A, velocity: [v, 0, 0], stays: true}}\ngravity: -y\n"
      "instants: {before: rest}\nask: {top: max(q)}\n");
  const SolvedAsk& top = struck.ask("top");
  ASSERT_TRUE(top.formula) << top.no_formula;
  const double m = 0.2, M = 3, L = 1.5, v = 8, g = 9.81;
  const double cosine = 1 - m * m * v * v / (2 * (M / 3 + m) * (M / 2 + m) * g * L);
  EXPECT_NEAR(value_at(top.formula->number, {{"m", m}, {"M", M}, {"L", L}, {"v", v}, {"g", g}}), std::acos(cosine),
              1e-8);
  const SolvedText thrown(
      "title: t\nletters: {m: kg, h: m, v: m/s, g: m/s^2}\npoints: {P: [0, h, 0]}\n"
      "bodies: {a: {particle: P, mass: m}}\ngravity: -y\n"
      "instants: {start: {'velocity(a)': '[v, 0, 0]'}, hit: {first_time: position(a).y == 0 m}}\n"
      "ask: {an: angle(velocity(a) to x) @ hit}\n");
  const SolvedAsk& an = thrown.ask("an");
  ASSERT_TRUE(an.formula) << an.no_formula;
  EXPECT_NEAR(value_at(an.formula->number, {{"h", 2}, {"v", 3}, {"g", 9.81}}), std::atan2(std::sqrt(2 * 9.81 * 2), 3),
              1e-8);
}

TEST(ScalingLaw, GroupsThatAreNoPowerAreNamed) {
  const std::string weighted =
      "title: t\nletters: {a: m, c: m, m: kg, M: kg}\npoints: {O: [0, 0, 0], P: [0, -a, 0], Q: [c, -a, 0]}\n"
      "bodies: {bob: {parts: {rod: {rod: [O, P], mass: m}, ball: {particle: Q, mass: M}}}}\n"
      "joints: {pin: {revolute: z, at: O, to: bob, angle: th}}\ngravity: -y\n"
      "instants: {start: {th: 40 deg, th': 0}}\nask: {T: period(th)}\n";
  EXPECT_EQ(formula(SolvedText(weighted), "T"), "none: it depends on c/a, and not as a power of it");
  EXPECT_EQ(formula(SolvedText(weighted, {{"c", "0.2 m"}}), "T"), "none: it depends on a, and not as a power of it");
  EXPECT_EQ(formula(SolvedText(weighted, {{"a", "1 m"}, {"c", "0.2 m"}}), "T"),
            "none: it depends on M/m, and not as a power of it");
}

TEST(ScalingLaw, WhereGravityIsANumberLengthsAndTimesScaleTogether) {
  const std::string stated = figure + "letters: {a: m, m: kg}\ninstants: {start: {th: 40 deg, th': 0}}\n";
  const std::string found = formula(SolvedText(stated + "ask: {T: period(th)}\n"), "T");
  EXPECT_TRUE(found.ends_with("*sqrt(a)")) << found;
  const double number = 4 * std::comp_ellint_1(std::sin(20 * pi / 180)) * std::sqrt(2.0 / 3 / 9.80665);
  EXPECT_NEAR(leading_number(found), number, 1e-11);
}

TEST(ScalingLaw, APowerOfAGroupIsFoundByTrial) {
  // Let go where the spring is slack, a weight falls by 2 m g/k.
  const std::string spring =
      "title: t\nletters: {m: kg, k: N/m, g: m/s^2, u: m/s}\npoints: {O: [0, 0, 0]}\n"
      "bodies: {weight: {particle: O, mass: m}}\n"
      "joints: {rail: {prismatic: y, at: O, to: weight, displacement: s, spring: {stiffness: k, free_displacement: "
      "0}}}\n";
  const SolvedText let_go(spring + "gravity: -y\ninstants: {start: {s: 0, s': 0}}\nask: {d: min(s), T: period(s)}\n");
  EXPECT_EQ(formula(let_go, "d"), "-2*m*g/k");
  EXPECT_EQ(formula(let_go, "T"), "2*pi*sqrt(m/k)");
  // Thrown too, it rises until m u^2/2 = m g s + k s^2/2.
  const SolvedText thrown(spring + "gravity: -y\ninstants: {start: {s: 0, s': u}}\nask: {d: max(s)}\n");
  EXPECT_EQ(formula(thrown, "d"), "(sqrt((m*g^2 + k*u^2)*m) - m*g)/k");
  const SolvedText level(spring + "gravity: none\ninstants: {start: {s: 0, s': u}}\nask: {d: max(s)}\n");
  EXPECT_EQ(formula(level, "d"), "u*sqrt(m/k)");
}

TEST(ScalingLaw, APlateHungFromTwoCords) {
  const SolvedText solved(
      "title: t\nletters: {b: m, m: kg, g: m/s^2}\n"
      "points: {A: [-b, 0, 0], B: [b, 0, 0], C: [-b, 3*b, 0], D: [b, 3*b, 0], G: [0, -b, 0]}\n"
      "bodies: {plate: {rectangle: {center: G, sides: [2*b*x, 2*b*y]}, mass: m}}\n"
      "joints: {plane: {planar: z, at: G, to: plate}}\n"
      "cords: {left: {from: ground, at: C, to: plate, end: A}, right: {from: ground, at: D, to: plate, end: B}}\n"
      "gravity: -y\ninstants: {start: {velocity(A of plate): ['sqrt(g*b)', 0, 0], angular_velocity(plate): [0, 0, "
      "0]}}\n"
      "ask: {T: max(tension(left) + tension(right)), rise: max(center(plate).y)}\n");
  // v^2/(3 b) more than the weight at the lowest point, and v^2/(2 g) up.
  ASSERT_TRUE(solved.ask("T").formula);
  EXPECT_NEAR(value_at(solved.ask("T").formula->number, {{"m", 1}, {"g", 1}}), 4.0 / 3, 1e-9);
  EXPECT_EQ(formula(solved, "rise"), "-b/2");
}

TEST(ScalingLaw, ATopWhoseSpinScales) {
  const SolvedText solved(
      "title: t\nletters: {a: m, m: kg, g: m/s^2}\npoints: {O: [0, 0, 0], G: [0, 0, a]}\n"
      "bodies: {top: {disk: {center: G, normal: z, radius: a/2}, mass: m}}\n"
      "joints: {tip: {ball: O, to: top, angles: [phi: z, theta: x, psi: z]}}\ngravity: -z\n"
      "instants: {start: {phi: 0, theta: 30 deg, psi: 0, phi': 0, theta': 0, psi': 40*sqrt(g/a)}}\n"
      "ask: {M: max(theta), f: max(phi'), T: period(theta), H: max(kinetic_energy(top))}\n");
  // Released with a still axis: the roots of Eq. 18.40's cubic in cos(theta).
  const double I = 0.125, J = 1 + 0.0625, spin = 40 * I, x0 = std::cos(pi / 6);
  // 1 - x^2 = p (x0 - x)
  const double p = spin * spin / (2 * J), x = p / 2 - std::sqrt(p * p / 4 - p * x0 + 1);
  ASSERT_EQ(solved.ask("M").state, AskState::found);
  EXPECT_NEAR(solved.number("M"), std::acos(x), 1e-10);
  EXPECT_NEAR(spin * (x0 - x) / (J * (1 - x * x)), 2.0 / 5, 1e-12);
  EXPECT_EQ(formula(solved, "f"), "2*sqrt(g/a)/5");
  const std::string energy = formula(solved, "H");
  EXPECT_TRUE(energy.ends_with("*m*g*a")) << energy;
  EXPECT_NEAR(leading_number(energy), I * 40 * 40 / 2 + x0 - x, 1e-9) << energy;
  EXPECT_TRUE(formula(solved, "T").ends_with("*sqrt(a/g)"));
}

TEST(ScalingLaw, UnknownsThatAMotionFixes) {
  const SolvedText solved(
      "title: t\nletters: {T: s, m: kg, g: m/s^2}\nfind: {L: m}\nwhere: [L > 0]\n"
      "points: {O: [0, 0, 0], P: [0, -L, 0]}\nbodies: {bob: {particle: P, mass: m}}\n"
      "joints: {pin: {revolute: z, at: O, to: bob, angle: th}}\ngravity: -y\n"
      "instants: {start: {th: 40 deg, th': 0, period(th): T}}\nask: {L: L, v: max(th')}\n");
  const double full = 4 * std::comp_ellint_1(std::sin(20 * pi / 180));
  const std::string length = formula(solved, "L");
  EXPECT_TRUE(length.ends_with("*g*T^2")) << length;
  EXPECT_NEAR(leading_number(length), 1 / (full * full), 1e-9) << length;
  ASSERT_EQ(solved.solved().solutions.front().unknowns.size(), 1U);
  EXPECT_TRUE(solved.solved().solutions.front().unknowns.front().formula);
}

// Rods and disks on a pin, with a spring or a damper or neither, let go anywhere: each law at other letters is what the
// motion followed there shows.
TEST(ScalingLaw, LawsOfRandomPendulumsHoldAtOtherLetters) {
  std::mt19937_64 random(51);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  constexpr int pendulums = poinsot::testing::case_count(12);
  int laws = 0;
  for (int i = 0; i < pendulums; ++i) {
    const bool twisted = i % 2 == 0;
    const std::string shape = i % 3 == 0   ? "{rod: [O, P], mass: m}"
                              : i % 3 == 1 ? "{disk: {center: P, normal: z, radius: a/3}, mass: m}"
                                           : "{box: {center: P, sides: [a/2*x, a*y, a/5*z]}, mass: m}";
    const std::string stated =
        "title: t\nletters: {a: m, m: kg, g: m/s^2}\npoints: {O: [0, 0, 0], P: [0, -a, 0]}\nbodies: {bob: " + shape +
        "}\njoints: {pin: {revolute: z, at: O, to: bob, angle: th" +
        (twisted ? ", spring: {stiffness: " + std::to_string(uniform(0.1, 2)) + "*m*g*a, free_angle: 0}" : "") +
        "}}\ngravity: -y\ninstants: {start: {th: " + std::to_string(uniform(0.2, 2.5)) +
        " rad, th': 0}}\nask: {T: period(th), w: max(th'), K: max(kinetic_energy(bob)), F: max(norm(reaction(pin)))}\n";
    const SolvedText solved(stated);
    const double a = uniform(0.1, 5), m = uniform(0.1, 9), g = uniform(1, 20);
    const SolvedText there(
        stated,
        {{"a", std::to_string(a) + " m"}, {"m", std::to_string(m) + " kg"}, {"g", std::to_string(g) + " m/s^2"}});
    const auto rounded = [](double x) { return std::stod(std::to_string(x)); };
    const LetterValues letters{{"a", rounded(a)}, {"m", rounded(m)}, {"g", rounded(g)}};
    for (const std::string name : {"T", "w", "K", "F"}) {
      ASSERT_TRUE(solved.ask(name).formula) << stated << name << ": " << solved.ask(name).no_formula;
      const double expected = there.number(name);
      EXPECT_NEAR(value_at(solved.ask(name).formula->number, letters), expected, 1e-9 * expected) << stated << name;
      ++laws;
    }
  }
  EXPECT_EQ(laws, 4 * pendulums);
}

TEST(LawShape, ProductsOfAnAngle) {
  const auto samples = [](auto&& of) {
    AngleSamples all;
    for (const double angle : {0.21, 0.37, 0.52, 0.68, 0.84, 0.99, 1.17, 0.6}) {
      all.angles.push_back(angle);
      all.numbers.push_back(of(angle));
    }
    return all;
  };
  const auto parts = product_of("b", samples([](double b) { return -3 * std::sin(b) * std::sqrt(std::cos(b)); }), 1e-9);
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->size(), 2U);
  EXPECT_EQ(parts->at(0).factor, Factor::cosine);
  EXPECT_EQ(parts->at(0).halves, 1);
  EXPECT_EQ(parts->at(1).factor, Factor::sine);
  EXPECT_EQ(parts->at(1).halves, 2);
  const auto versine = product_of("b", samples([](double b) { return 1 - std::cos(b); }), 1e-9);
  ASSERT_TRUE(versine);
  ASSERT_EQ(versine->size(), 1U);
  EXPECT_EQ(versine->at(0).factor, Factor::half_sine);
  EXPECT_EQ(versine->at(0).halves, 4);
  EXPECT_FALSE(product_of("b", samples([](double b) { return 2 - std::cos(b); }), 1e-9));
  EXPECT_EQ(term_of(samples([](double b) { return 2 - std::cos(b); }), 1e-9), Term::cosine);
  EXPECT_EQ(term_of(samples([](double b) { return pi - b; }), 1e-9), Term::angle);
  EXPECT_FALSE(term_of(samples([](double b) { return std::comp_ellint_1(std::sin(b / 2)); }), 1e-9));
}

TEST(LawShape, NumbersThatPeopleKnow) {
  const auto known = [](double number, double tolerance) {
    const auto found = known_coefficient(number, tolerance);
    return found ? text(*found) : "";
  };
  EXPECT_EQ(known(2 * pi, 1e-12), "2*pi");
  EXPECT_EQ(known(-std::sqrt(2.0 / 3), 1e-12), "-sqrt(6)/3");
  EXPECT_EQ(known(pi * std::sqrt(1.5), 1e-12), "sqrt(6)*pi/2");
  EXPECT_EQ(known(-std::sqrt(105.0) / 16, 1e-12), "-sqrt(105)/16");
  EXPECT_EQ(known(1 / pi, 1e-12), "1/pi");
  EXPECT_EQ(known(9.80665000002, 1e-11), "9.80665");
  EXPECT_EQ(known(0.807320586752, 1e-11), "");
  // With few digits only fractions are told.
  EXPECT_EQ(known(2 * pi, 1e-7), "");
  std::mt19937_64 random(20);
  int taken = 0;
  for (int i = 0; i < 2000; ++i) taken += known(std::uniform_real_distribution<double>(0.1, 10)(random), 1e-11) != "";
  EXPECT_LE(taken, 2);
}

TEST(LawShape, DigitsOfNumbers) {
  EXPECT_EQ(text(rounded(2 * pi, 2 * pi, 7)), "6.283185");
  EXPECT_EQ(text(rounded(-0.99999999999, 1, 8)), "-1");
  // Counted from the first digit of the largest.
  EXPECT_EQ(text(rounded(0.012345, 12.3, 6)), "0.0123");
  EXPECT_TRUE(rounded(1e-9, 1, 8).is_zero());
}

// A puck on a string through a hole, on which a weight hangs, comes nearest where it begins or at the other turning
// point: by m v^2 against M g r, a bound of four letters beyond which, farther off, the string comes to its end.
TEST(ScalingLaw, IsNotToldBeyondABoundCloseBy) {
  const SolvedText solved(
      "title: t\nletters: {m: kg, M: kg, r: m, v: m/s, h: m}\npoints: {O: [0, 0, 0], P: [r, 0, 0], W: [0, 0, -h]}\n"
      "bodies: {puck: {particle: P, mass: m}, weight: {particle: W, mass: M}}\n"
      "contacts: {table: {of: puck, at: P, normal: z}}\njoints: {guide: {prismatic: z, at: W, to: weight}}\n"
      "cords: {string: {from: puck, at: P, over: [O], to: weight, end: W}}\ngravity: -z\n"
      "instants: {start: {velocity(puck): [0, v, 0], velocity(weight): [0, 0, 0]}}\n"
      "ask: {far: max(norm(center(puck)))}\n");
  const SolvedAsk& far = solved.ask("far");
  EXPECT_TRUE(!far.formula || !far.regimes.empty() ||
              std::ranges::any_of(solved.solved().solutions[0].assumptions,
                                  [](const std::string& words) { return words.find("'far'") != std::string::npos; }))
      << formula(solved, "far");
}

}  // namespace scaling_law_test
}  // namespace poinsot::problem
