// Roots that a search could lose: for a sign that nobody stated, for tolerances measured by something else, for work.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace lost_roots_test {

SolvedStatement solved(const std::string& text) { return solve_statement(read_statement(text, "test.yaml"), {}); }

std::string warnings_of(const SolvedStatement& solution) {
  std::string all;
  for (const std::string& warning : solution.warnings) all += warning + "\n";
  return all;
}

std::string particle_along(double angle, const std::string& fact) {
  return "given: {a: " + std::to_string(angle) +
         " rad}\nfind: {c: m}\npoints: {O: [0, 0, 0], A: '[c*cos(a) + 1 m, c*sin(a), 0]'}\n"
         "bodies: {b: {particle: A, mass: 2 kg}}\ngravity: none\nfacts: {" +
         fact + "}\nask: {c: c}\n";
}

// c cos(a) + 1 = x: where c must be negative it is.
TEST(LengthsOfDoubtfulSign, TheOnlyRootIsFoundWhateverItsSign) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> draw(-3, 3);
  int negative = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const double a = std::round(1e3 * draw(random)) / 1e3, x = std::round(1e3 * draw(random)) / 1e3;
    const double c = (x - 1) / std::cos(a);
    if (std::abs(std::cos(a)) < 0.05 || std::abs(c) < 1e-3) continue;
    const SolvedStatement solution = solved(particle_along(a, "center(b).x: " + std::to_string(x) + " m"));
    ASSERT_EQ(solution.solutions.size(), 1u) << a << " " << x << warnings_of(solution);
    EXPECT_NEAR(solution.solutions[0].asks[0].value.number, c, 1e-9 * std::abs(c));
    negative += c < 0;
  }
  EXPECT_GT(negative, 5);
}

// (c cos(a) + 1)^2 + (c sin(a))^2 = 1.5: a root on either side. The negative one is told, and given where it is asked.
TEST(LengthsOfDoubtfulSign, ARootOfTheOtherSignIsTold) {
  const std::string fact = "moment_of_inertia(b about z at O): 3 kg*m^2";
  const SolvedStatement solution = solved(particle_along(0.5, fact));
  ASSERT_EQ(solution.solutions.size(), 1u);
  const double c = std::cos(0.5), root = std::sqrt(c * c + 0.5);
  EXPECT_NEAR(solution.solutions[0].asks[0].value.number, root - c, 1e-9);
  EXPECT_NE(warnings_of(solution).find("all conditions hold with c = -2.005 m"), std::string::npos)
      << warnings_of(solution);
  const SolvedStatement both = solved(particle_along(0.5, fact) + "where: [c > -10 m]\n");
  ASSERT_EQ(both.solutions.size(), 2u);
  EXPECT_NEAR(both.solutions[0].asks[0].value.number, -root - c, 1e-9);
}

// Of two places that mirror one another the length is the positive one, and nothing more is said.
TEST(LengthsOfDoubtfulSign, ATwinIsNotTold) {
  const SolvedStatement solution = solved(
      "find: {c: m}\npoints: {O: [0, 0, 0], A: '[c*cos(20 deg), c*sin(20 deg), 0]'}\n"
      "bodies: {b: {particle: A, mass: 2 kg}}\ngravity: none\n"
      "facts: {moment_of_inertia(b about z at O): 8 kg*m^2}\nask: {c: c}\n");
  ASSERT_EQ(solution.solutions.size(), 1u);
  EXPECT_NEAR(solution.solutions[0].asks[0].value.number, 2, 1e-9);
  EXPECT_EQ(warnings_of(solution), "");
}

// Weights at 80, 200 and 320 degrees that balance an eccentricity, down to some pm in a wheel of 0.2 m.
TEST(Choices, TheLeastTotalDoesNotDependOnTheSizeOfWhatIsBalanced) {
  const double s20 = std::sin(20 * M_PI / 180), s80 = std::sin(80 * M_PI / 180), s60 = std::sin(60 * M_PI / 180);
  for (const char* e : {"0.4e-3", "4e-9", "1e-9", "1e-10", "1e-11", "2e-12"}) {
    const SolvedStatement solution = solved(std::string("given: {m: 12 kg, R: 200 mm, e: ") + e + R"( m}
find: {mA: g, mB: g, mC: g}
points: {O: [0, 0, 0], A: '[0, R*cos(80 deg), R*sin(80 deg)]', B: '[0, R*cos(200 deg), R*sin(200 deg)]', C: '[0, R*cos(320 deg), R*sin(320 deg)]'}
bodies:
  wheel: {mass: m, center: [0, e, 0], added: {A: {particle: A, mass: mA}, B: {particle: B, mass: mB}, C: {particle: C, mass: mC}}}
joints: {axle: {revolute: x, at: O, to: wheel}}
choose: {fixed: {of: [A, B, C], least: total}}
instants: {now: {'center(wheel)': [any, 0, 0]}}
ask: {a: mA, b: mB, c: mC}
)");
    ASSERT_EQ(solution.solutions.size(), 1u) << e;
    const double per = 12 * std::stod(e) / (0.2 * s60);
    EXPECT_NEAR(solution.solutions[0].asks[0].value.number, per * s20, 1e-3 * per) << e;
    EXPECT_NEAR(solution.solutions[0].asks[1].value.number, per * s80, 1e-3 * per) << e;
    EXPECT_EQ(solution.solutions[0].asks[2].value.number, 0) << e;
  }
}

// Two of the weights are at one place: what balances the wheel is their sum, and each of them may be any part of it.
TEST(Choices, ATieOfTheLeastTotalLeavesOpenHowItIsShared) {
  const SolvedStatement solution = solved(R"(given: {m: 12 kg, e: 0.4 mm, R: 200 mm}
find: {mA: g, mB: g, mC: g}
points: {O: [0, 0, 0], A: [0, -R, 0], B: [0, -R, 0], C: [0, 0, R]}
bodies:
  wheel: {mass: m, center: [0, e, 0], added: {A: {particle: A, mass: mA}, B: {particle: B, mass: mB}, C: {particle: C, mass: mC}}}
joints: {axle: {revolute: x, at: O, to: wheel}}
choose: {fixed: {of: [A, B, C], least: total}}
instants: {now: {'center(wheel)': [any, 0, 0]}}
ask: {which: fixed, a: mA, c: mC, sum: mA + mB}
)");
  ASSERT_EQ(solution.solutions.size(), 1u);
  const std::vector<SolvedAsk>& asks = solution.solutions[0].asks;
  for (const std::size_t open : {0u, 1u}) {
    EXPECT_EQ(asks[open].state, AskState::undetermined);
    EXPECT_EQ(asks[open].reason, "the conditions leave 'mA', 'mB' open: one more fact is needed");
  }
  EXPECT_EQ(asks[2].value.number, 0);
  EXPECT_EQ(asks[3].state, AskState::found);
  EXPECT_NEAR(asks[3].value.number, 0.024, 1e-12);
  EXPECT_EQ(warnings_of(solution),
            "test.yaml:7:10: the least total under 'fixed' is 24 g, and mA and mB can make it up in more than one way: "
            "their shares are open\n");
}

// A disk on a hinge of a free shaft, let go level with a spin n: its lowest pose by energy and momentum,
//   J t'^2 + (J s^2 + I c^2) p^2 = ..., (J s^2 + I c^2) p = J n   with s = sin(t), c = cos(t).
// Nothing but n > 0 is said of where to look.
TEST(LaterFacts, ARateIsFoundFromAnExtremeWithoutARange) {
  const double r = 0.18, d = 0.36, g = 9.81, I = r * r / 2, J = r * r / 4 + d * d;  // by mass; J about the hinge
  for (const double degrees : {20.0, 30.0, 45.0, 60.0}) {
    const double t = degrees * M_PI / 180, s = std::sin(t), c = std::cos(t), K = J * s * s + I * c * c;
    // J n^2 / 2 + g d c = (J n)^2 / (2 K)
    const double n = std::sqrt(2 * g * d * c / (J * J / K - J));
    for (const char* where : {"n > 0", "n > 0.5 rad/s", "0 rad/s < n < 1000 rad/s"}) {
      const SolvedStatement solution = solved(std::string(R"(find: {n: rad/s}
axes: [X, Y, Z]
given: {g: 9.81 m/s^2}
gravity: -Z
points: {A: [0, 0, 0], G: [0, 0, -0.36 m]}
bodies: {shaft: massless, disk: {disk: {center: G, normal: Z, radius: 0.18 m}, mass: any}}
joints:
  bearing: {revolute: Z, at: A, to: shaft, angle: phi}
  clevis: {revolute: -Y, at: A, from: shaft, to: disk, angle: theta}
instants:
  start: {phi: 0, theta: 90 deg, theta': 0, phi': n, min(theta): )") +
                                              std::to_string(degrees) + " deg}\nwhere: [" + where + "]\nask: {n: n}\n");
      ASSERT_EQ(solution.solutions.size(), 1u) << degrees << where << warnings_of(solution);
      ASSERT_EQ(solution.solutions[0].asks[0].state, AskState::found) << degrees << where;
      EXPECT_NEAR(solution.solutions[0].asks[0].value.number, n, 1e-7 * n) << degrees << where;
    }
  }
}

// Roots of one or two unknowns have been looked for by a second road.
TEST(RootsCheck, IsNamedAmongTheChecks) {
  const SolvedStatement solution = solved(particle_along(0.5, "center(b).x: 3 m"));
  ASSERT_EQ(solution.solutions.size(), 1u);
  ASSERT_TRUE(solution.solutions[0].checks.contains("roots"));
  EXPECT_LT(solution.solutions[0].checks.at("roots"), 1e-9);
}

// A momentum that is to vanish while the rate is stated: the coefficient of the rate vanishes at the root, and beside
// it the two facts contradict one another, however near it is.
TEST(VanishingMomenta, TheRootIsFoundAlthoughFactsClashBesideIt) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> draw(0.5, 5);
  const auto drawn = [&] { return std::round(1e3 * draw(random)) / 1e3; };
  for (int trial = 0; trial < 40; ++trial) {
    const double m = drawn(), M = drawn(), a = drawn() * std::pow(10, trial % 3), n = drawn();
    const auto text = [](double x) { return std::to_string(x); };
    const SolvedStatement pair = solved("find: {s: m}\npoints: {O: [0, 0, 0], P: [0, " + text(a) +
                                        " m, 0], Q: [0, -s, 0]}\nbodies: {r: {parts: {p: "
                                        "{particle: P, mass: " +
                                        text(m) + " kg}, q: {particle: Q, mass: " + text(M) +
                                        " kg}}}}\njoints: {j: {revolute: "
                                        "z, at: O, to: r, rate: " +
                                        text(n) +
                                        " rad/s, accel: 0}}\ngravity: none\ninstants: {now: {momentum(r): [0, 0, "
                                        "0]}}\nask: {s: s}\n");
    ASSERT_EQ(pair.solutions.size(), 1u) << trial << warnings_of(pair);
    EXPECT_NEAR(pair.solutions[0].asks[0].value.number, m * a / M, 1e-9 * m * a / M);
  }
}

std::string turned_plate(double A, double B, double P) {
  return "find: {d: rad}\nwhere: [-90 deg < d < 90 deg]\npoints: {O: [0, 0, 0]}\ndirections: {u: '[cos(d), sin(d), "
         "0]', "
         "v: '[-sin(d), cos(d), 0]'}\nbodies: {b: {mass: 2 kg, center: O, inertia: {x: " +
         std::to_string(A) + " kg*m^2, y: " + std::to_string(B) + " kg*m^2, z: " + std::to_string(A + B) +
         " kg*m^2, xy: " + std::to_string(P) +
         " kg*m^2, yz: 0, zx: 0}}}\njoints: {s: {revolute: u, at: O, to: b, rate: 10 rad/s, accel: 0}}\n"
         "gravity: none\ninstants: {now: {'component(angular_momentum(b about O) along v)': 0}}\nask: {d: d}\n";
}

// A shaft along a principal axis of a plate: tan 2d = 2 P/(B - A). Of a plate whose axes are all alike any will do.
TEST(VanishingMomenta, PrincipalAxesAreFound) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> moment(1, 5), product(-0.9, 0.9);
  const auto rounded = [](double x) { return std::round(1e3 * x) / 1e3; };
  for (int trial = 0; trial < 20; ++trial) {
    const double A = rounded(moment(random)), B = rounded(moment(random)), P = rounded(product(random));
    const SolvedStatement found = solved(turned_plate(A, B, P));
    ASSERT_EQ(found.solutions.size(), 2u) << A << " " << B << " " << P << warnings_of(found);
    for (const Solution& solution : found.solutions) {
      const double d = solution.asks[0].value.number;
      EXPECT_NEAR((A - B) * std::sin(2 * d) + 2 * P * std::cos(2 * d), 0, 1e-9);
    }
  }
  const SolvedStatement alike = solved(turned_plate(3, 3, 0));
  ASSERT_EQ(alike.solutions.size(), 1u) << warnings_of(alike);
  EXPECT_EQ(alike.solutions[0].asks[0].state, AskState::undetermined);
}

// A top that precesses steadily, by p I s = m g c for the slow root and a fast one: the smaller root of a quadratic.
// b: how far it leans, s: its spin.
std::string steady_top(const std::string& b, const std::string& s, const std::string& range = "") {
  return "given: {m: 0.5 kg, c: 0.1 m, I: 0.002 kg*m^2, J: 0.007 kg*m^2, b: " + b + ", s: " + s + R"(}
find: {p: rad/s}
points: {O: [0, 0, 0], G: 'c*[sin(b), 0, cos(b)]'}
frames: {figure: {turns: z, rate: p}}
bodies: {top: {mass: m, center: G, inertia: {about: O, axis: O->G, axial: I, transverse: J}}}
joints: {tip: {ball: O, to: top}}
steady: {frame: figure, spins: {top: {about: O->G, rate: s}}}
gravity: -z
)" + range +
         "ask: {p: p}\n";
}

double slow_precession(double b, double s) {
  const double weight = 0.5 * 9.80665 * 0.1, spin = 0.002 * s;
  return 2 * weight / (spin + std::sqrt(spin * spin - 4 * 0.005 * std::cos(b) * weight));
}

// The slow precession is lost among the last digits of the spin: as many digits as are known are told.
TEST(SmallRoots, ARootAmongTheLastDigitsOfLargeTermsIsToldToBeOff) {
  const double third = std::acos(0.5);
  for (const auto& [spin, s, told] : {std::tuple{"1e7 rad/s", 1e7, "may be off by up to 0.01 of itself"},
                                      std::tuple{"1e8 rad/s", 1e8, "may be off by up to 0.1 of itself"}}) {
    const SolvedStatement solution = solved(steady_top("60 deg", spin));
    ASSERT_EQ(solution.solutions.size(), 2u) << warnings_of(solution);
    const double right = slow_precession(third, s), found = solution.solutions[0].asks[0].value.number;
    EXPECT_GT(std::abs(found - right), 1e-6 * right);
    EXPECT_LT(std::abs(found - right), 0.1 * right);
    EXPECT_NE(warnings_of(solution).find(told), std::string::npos) << warnings_of(solution);
  }
  const SolvedStatement known = solved(steady_top("60 deg", "1e4 rad/s"));
  ASSERT_EQ(known.solutions.size(), 2u);
  EXPECT_NEAR(known.solutions[0].asks[0].value.number / slow_precession(third, 1e4), 1, 1e-6);
  EXPECT_EQ(warnings_of(known).find("of itself"), std::string::npos) << warnings_of(known);
}

// In a range so narrow all values are one beside the spin: then none of them is an answer.
TEST(SmallRoots, AnUnknownThatIsOpenInANarrowRangeIsNotAnswered) {
  const SolvedStatement solution = solved(steady_top("60 deg", "1e8 rad/s", "where: [1e-9 rad/s < p < 1e-3 rad/s]\n"));
  EXPECT_TRUE(!solution.solutions.empty() || !solution.warnings.empty());
  for (const Solution& one : solution.solutions)
    if (one.asks[0].state == AskState::found) {
      EXPECT_NEAR(one.asks[0].value.number / slow_precession(std::acos(0.5), 1e8), 1, 0.1) << warnings_of(solution);
    }
}

// The fast precession of a top that leans almost level, I s/((J - I) cos b), is some 10^7 natural rates.
TEST(LargeRoots, ARootFarBeyondNaturalSizesIsFoundBesideAUsualOne) {
  for (const auto& [b, degrees] : {std::tuple{"89.99 deg", 89.99}, std::tuple{"89.999 deg", 89.999},
                                   std::tuple{"89.9999 deg", 89.9999}, std::tuple{"89.99999 deg", 89.99999}}) {
    const SolvedStatement solution = solved(steady_top(b, "200 rad/s"));
    ASSERT_EQ(solution.solutions.size(), 2u) << b << warnings_of(solution);
    const double lean = degrees * std::acos(-1) / 180;
    EXPECT_NEAR(solution.solutions[0].asks[0].value.number / slow_precession(lean, 200), 1, 1e-8) << b;
    const double product = 0.5 * 9.80665 * 0.1 / (0.005 * std::cos(lean));  // of both roots
    EXPECT_NEAR(solution.solutions[1].asks[0].value.number * slow_precession(lean, 200) / product, 1, 1e-6) << b;
  }
}

// Lists are stated as lists: the leg at which a bent wire has no product of inertia.
TEST(ListsOfFacts, OneElementOfAListIsAFact) {
  const auto wire = [](const std::string& fact) {
    return "find: {b: m}\nwhere: [b > 0]\npoints: {O: [0, 0, 0], A: [0.3 m, 0, 0], B: [0.3 m, b, 0], D: [0.6 m, b, 0], "
           "E: "
           "[0.6 m, -0.3 m, 0]}\nbodies: {w: {wire: [O, A, B, D, E], density: 2 kg/m}}\ninstants: {now: {" +
           fact + "}}\nask: {b: b}\n";
  };
  const auto root = [&](const std::string& fact) {
    const SolvedStatement solution = solved(wire(fact));
    EXPECT_EQ(solution.solutions.size(), 1u) << fact << warnings_of(solution);
    return solution.solutions.at(0).asks[0].value.number;
  };
  // The products of its legs: 0.3 b^2/2 + 0.45*0.3 b + 0.6 (b^2 - 0.09)/2 = 0.
  const double expected = (-0.135 + std::sqrt(0.135 * 0.135 + 4 * 0.45 * 0.027)) / 0.9;
  EXPECT_NEAR(root("'products_of_inertia(w about O)': [0, any, any]"), expected, 1e-9);
  EXPECT_NEAR(root("'products_of_inertia(w about O)[1]': 0"), expected, 1e-9);
  for (const char* wrong : {"'products_of_inertia(w about O)': [0, any]", "'products_of_inertia(w about O)': 0"})
    EXPECT_THROW(solved(wire(wrong)), StatementError) << wrong;
}

// An upright top precesses at any rate that is taken from its spin: how it swings, seen from there, hangs on it.
TEST(OpenUnknowns, NothingIsNotedThatHangsOnThem) {
  const SolvedStatement solution = solved(R"(given: {m: 0.4 kg, h: 60 mm, I: 1.8e-4 kg*m^2, J: 2.2e-3 kg*m^2}
find: {P: rad/s}
points: {O: [0, 0, 0], G: [0, 0, h]}
frames: {f: {turns: z, rate: P}}
bodies: {top: {mass: m, center: G, inertia: {about: O, axis: O->G, axial: I, transverse: J}}}
joints: {tip: {ball: O, to: top}}
steady: {frame: f, spins: {top: {about: O->G, rate: 8000 rpm}}}
gravity: -z
ask: {P: P}
)");
  ASSERT_EQ(solution.solutions.size(), 1u);
  EXPECT_EQ(solution.solutions[0].asks[0].reason, "the conditions leave 'P' open: one more fact is needed");
  EXPECT_TRUE(solution.solutions[0].notes.empty()) << solution.solutions[0].notes.front();
}

}  // namespace lost_roots_test
}  // namespace poinsot::problem
