// What is said of unknowns: their roots, that they are open, or what is in the way.
#include "problem/unknowns/unknown_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "poinsot/engine/work/work.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace unknown_search_test {

SolvedStatement solved(const std::string& text) { return solve_statement(read_statement(text, "test.yaml"), {}); }

double number(const SolvedStatement& solution, std::size_t ask = 0, std::size_t root = 0) {
  return solution.solutions.at(root).asks.at(ask).value.number;
}

std::string all_warnings(const SolvedStatement& solution) {
  std::string text;
  for (const std::string& warning : solution.warnings) text += warning + "\n";
  return text;
}

void expect_open(const SolvedAsk& ask) {
  EXPECT_EQ(ask.state, AskState::undetermined);
  EXPECT_NE(ask.reason.find("open"), std::string::npos) << ask.reason;
}

// A rod held level by its end and let swing up: Q = m L^2/3 alpha + m g L/2. The acceleration is a condition on the
// couple that is stated beside it.
TEST(UnknownSearch, AnAccelerationBesideACoupleFindsIt) {
  const SolvedStatement solution = solved(R"(given: {m: 2 kg, L: 1.5 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies: {arm: {rod: [O, A], mass: m}}
joints: {pin: {revolute: z, at: O, to: arm, couple: Q, accel: 3 rad/s^2}}
find: {Q: N*m}
gravity: -y
instants: {now: rest}
ask: {Q: Q, alpha: angular_acceleration(arm).z}
)");
  ASSERT_EQ(solution.solutions.size(), 1U);
  EXPECT_NEAR(number(solution), 2 * 1.5 * 1.5 / 3 * 3 + 2 * 9.80665 * 1.5 / 2, 1e-9);
  EXPECT_NEAR(number(solution, 1), 3, 1e-12);
}

// The unit is a million times a million times the value.
TEST(UnknownSearch, ARangeSetsTheSize) {
  const SolvedStatement solution = solved(R"(title: a linear unknown whose unit is of another order
gravity: none
points: {O: [0, 0, 0]}
bodies:
  cart: {particle: O, mass: 2 kg}
joints:
  rail: {prismatic: x, at: O, to: cart, rate: 1.3 m/s, damping: c, force: 10 N}
find: {c: kN*s/mm}
where: [0 kN*s/mm < c < 0.00001 kN*s/mm]
instants:
  now: {acceleration(cart).x: 3.7 m/s^2}
ask: {c: c}
)");
  ASSERT_EQ(solution.solutions.size(), 1U) << all_warnings(solution);
  EXPECT_NEAR(number(solution), 2, 1e-12);
}

// A radius changes the size of the mechanism, but says nothing of the momentum of another body.
TEST(UnknownSearch, AnUnknownOfTheForcesIsNoneOfTheVelocities) {
  const SolvedStatement solution = solved(R"(title: a mass from a momentum, a radius and gravity from forces
gravity: [0, -G, 0]
points: {O: [0, 0, 0], C: [0, 2 m, 0]}
bodies:
  slider: {particle: O, mass: m}
  wheel: {rod: [C, [r, 2 m, 0]], mass: 4 kg}
joints:
  rail: {prismatic: x, at: O, to: slider, rate: 2 m/s}
  axle: {revolute: z, at: C, to: wheel, rate: 0, couple: 1 N*m}
find: {m: kg, r: m, G: m/s^2}
instants:
  now: {angular_momentum(slider about C).z: 6 kg*m^2/s, velocity(slider).x: 2 m/s, force(axle on wheel).y: 6.666666666666667 N, angular_acceleration(wheel).z: -7.407407407407407 rad/s^2}
ask: {m: m, r: r, G: G}
)");
  bool met = false;
  for (std::size_t k = 0; k < solution.solutions.size(); ++k) {
    EXPECT_NEAR(number(solution, 0, k), 1.5, 1e-9);
    met = met || (std::abs(number(solution, 1, k) - 0.9) < 1e-7 && std::abs(number(solution, 2, k) - 5) < 1e-6);
  }
  EXPECT_TRUE(met) << all_warnings(solution);
}

TEST(UnknownSearch, AMassFromThePlaceOfTheMassCenter) {
  const SolvedStatement solution = solved(R"(title: a mass from the place of the mass center
gravity: none
bodies:
  bar: {parts: {one: {particle: [-150 mm, -340 mm, -870 mm], mass: m}, two: {particle: [-500 mm, -710 mm, -1130 mm], mass: 1800 g}}}
joints:
  j: {weld: [-400 mm, -1080 mm, -1350 mm], to: bar}
find: {m: g}
instants: {now: {center(bar).x: -0.31 m}}
ask: {m: m}
)");
  ASSERT_EQ(solution.solutions.size(), 1U) << all_warnings(solution);
  EXPECT_NEAR(number(solution), 2.1375, 1e-9);
}

// Of a sum, other values must make sense too: a negative damping does not.
TEST(UnknownSearch, WhatOnlyASumFixesIsOpen) {
  const SolvedStatement solution = solved(R"(title: two unknowns of which only a sum is fixed
gravity: none
points: {O: [0, 0, 0]}
bodies:
  cart: {particle: O, mass: 2 kg}
joints:
  rail: {prismatic: x, at: O, to: cart, rate: 1 m/s, damping: c, force: F}
find: {c: N*s/m, F: N}
instants: {now: {acceleration(cart).x: 3 m/s^2}}
ask: {c: c, F: F, a: acceleration(cart).x}
)");
  ASSERT_EQ(solution.solutions.size(), 1U) << all_warnings(solution);
  expect_open(solution.solutions[0].asks[0]);
  expect_open(solution.solutions[0].asks[1]);
  EXPECT_EQ(solution.solutions[0].asks[2].state, AskState::found);
  EXPECT_NEAR(number(solution, 2), 3, 1e-9);
}

// m v^2 r along a curve: said once, without arbitrary points of it.
TEST(UnknownSearch, OpenAlongACurveIsSaidOnce) {
  const SolvedStatement solution = solved(R"(title: a moment of momentum fixes the product of rate and squared radius
gravity: none
points: {O: [0, 0, 0]}
bodies:
  bob: {particle: [r, 0, 0], mass: 2 kg}
joints:
  pin: {revolute: z, at: O, to: bob, rate: w}
find: {r: m, w: rad/s}
where: [0.1 m < r < 3 m]
instants: {now: {angular_momentum(bob about O).z: 5 kg*m^2/s}}
ask: {r: r, w: w, H: angular_momentum(bob about O).z}
)");
  ASSERT_EQ(solution.solutions.size(), 1U) << all_warnings(solution);
  expect_open(solution.solutions[0].asks[0]);
  expect_open(solution.solutions[0].asks[1]);
}

TEST(UnknownSearch, WithoutASolutionTheFactsThatClashAreNamedAtTheirPlace) {
  const SolvedStatement solution = solved(R"(title: a force cannot turn the cart aside
gravity: none
points: {O: [0, 0, 0]}
bodies:
  cart: {particle: O, mass: 2 kg}
joints:
  rail: {prismatic: x, at: O, to: cart, rate: 1 m/s, force: F}
find: {F: N}
instants:
  now:
    acceleration(cart).x: 3 m/s^2
    velocity(cart).x: 4 m/s
ask: {F: F}
)");
  EXPECT_TRUE(solution.solutions.empty());
  const std::string text = all_warnings(solution);
  EXPECT_NE(text.find("test.yaml:12:5"), std::string::npos) << text;
  EXPECT_NE(text.find("velocity(cart).x"), std::string::npos) << text;
  EXPECT_EQ(text.find("0 starts"), std::string::npos) << text;
}

// Facts about the motion are followed from a few starts, wherever the range ends.
TEST(UnknownSearch, AStartFromWhatComesLater) {
  const SolvedStatement solution = solved(R"(title: how fast a cart must start to reach a place
gravity: none
points: {O: [0, 0, 0]}
bodies:
  cart: {particle: O, mass: 2 kg}
joints:
  rail: {prismatic: x, at: O, to: cart, displacement: s, damping: 3 N*s/m, force: 0}
find: {v0: m/s}
where: [v0 > 0 m/s]
instants:
  start: {s: 0, s': v0}
  2 s: {s: 4 m}
ask: {v0: v0}
)");
  ASSERT_EQ(solution.solutions.size(), 1U) << all_warnings(solution);
  EXPECT_NEAR(number(solution), 4 * 1.5 / (1 - std::exp(-3.0)), 1e-7);
  EXPECT_NE(all_warnings(solution).find("found from a few motions"), std::string::npos) << all_warnings(solution);
}

// Seven unknowns and facts that no values satisfy.
const char* const hopeless = R"(title: facts that no masses and springs satisfy
gravity: -y
points: {O: [0, 0, 0], A: [a, b, 0], B: [c, -b, 0.3 m]}
bodies:
  one: {parts: {p: {particle: A, mass: m}, q: {particle: B, mass: n}}}
joints:
  pin: {revolute: [1, 2, 3], at: O, to: one, rate: w, couple: T}
find: {a: m, b: m, c: m, m: kg, n: kg, w: rad/s, T: N*m}
instants:
  now:
    velocity(one): [1 m/s, 2 m/s, 5 m/s]
    mass(one): 3 kg
    angular_momentum(one about O): [1 kg*m^2/s, -1 kg*m^2/s, 2 kg*m^2/s]
    acceleration(one): [1 m/s^2, 7 m/s^2, 3 m/s^2]
    force(pin on one): [100 N, 0, 7 N]
ask: {T: T}
)";

TEST(UnknownSearch, AHopelessSystemEndsWithWhatWasTried) {
  std::string message;
  try {
    const SolvedStatement solution = solved(hopeless);
    EXPECT_TRUE(solution.solutions.empty());
    message = all_warnings(solution);
  } catch (const StatementError& error) {
    message = error.what();
  }
  EXPECT_NE(message.find("no values of"), std::string::npos) << message;
}

TEST(UnknownSearch, ASearchEndsWhenItsWorkIsDoneAndSaysSo) {
  for (const Work most : {8'000'000, 30'000'000}) {
    const Statement statement = read_statement(hopeless, "test.yaml");
    const Work begin = work_done();
    UnknownSearch search(statement, {}, most);
    const RootsFound found = search.find({});
    EXPECT_TRUE(found.roots.empty());
    EXPECT_LT(work_done() - begin, 2 * most + 2'000'000) << "ends soon after its work";
    ASSERT_FALSE(found.warnings.empty());
    EXPECT_NE(found.warnings.back().find("searched from "), std::string::npos) << found.warnings.back();
    EXPECT_NE(found.warnings.back().find("ended before it was done"), std::string::npos) << found.warnings.back();
    EXPECT_EQ(found.warnings.back().find("no values of"), std::string::npos) << found.warnings.back();
  }
}

// The work is that of a whole search: choices that come too late are counted.
TEST(UnknownSearch, ChoicesThatWereNotTriedInTimeAreCounted) {
  const Statement statement = read_statement(R"(title: jets, too many to try in no time
find: {t1: s, t2: s, t3: s, t4: s}
gravity: none
points: {G: [0, 0, 0], P: [1 m, 0, 0]}
bodies: {probe: {mass: 200 kg, center: G, inertia: {axis: z, axial: 40 kg*m^2, transverse: 60 kg*m^2}}}
impulses:
  a: {body: probe, at: P, force: [0, 5 N, 0], lasts: t1}
  b: {body: probe, at: P, force: [0, -5 N, 0], lasts: t2}
  c: {body: probe, at: P, force: [5 N, 0, 0], lasts: t3}
  d: {body: probe, at: G, force: [0, 0, 5 N], lasts: t4}
choose: {fired: {of: [a, b, c, d], exactly: 2}}
instants:
  before: {angular_velocity(probe): [0, 0, 0.3 rad/s], velocity(probe): 0}
  after: {angular_velocity(probe): 0}
ask: {which: fired}
)",
                                             "test.yaml");
  UnknownSearch search(statement, {}, 300'000);
  std::string said;
  for (const std::string& warning : search.find({}).warnings) said += warning + "\n";
  EXPECT_NE(said.find("test.yaml:11:10: the time was over when "), std::string::npos) << said;
  EXPECT_NE(said.find(" of 6 choices under 'fired' had been tried"), std::string::npos) << said;
}

// Several families of solutions, in each of which other unknowns are open.
TEST(UnknownSearch, FamiliesOfSolutionsAreAllListed) {
  const SolvedStatement solution = solved(R"(title: two of three masses share what balances the third
find: {mA: g, mB: g, mC: g, q: deg}
gravity: none
points: {O: [0, 0, 0], A: '[-0.3 m, 0.12 m * cos(q), 0.12 m * sin(q)]', B: [0.3 m, -0.12 m, 0], C: '[-0.3 m, -0.12 m * cos(q), 0.12 m * sin(q)]'}
bodies:
  rotor: {mass: 12 kg, center: [0, 0.4 mm, 0], inertia: {about: O, xy: 0.01 kg*m^2, zx: 0, rest: any}, added: {A: {particle: A, mass: mA}, B: {particle: B, mass: mB}, C: {particle: C, mass: mC}}}
joints: {axle: {revolute: x, at: O, to: rotor, rate: 3000 rpm, accel: 0}}
facts: {force(axle on rotor): 0, couple(axle on rotor about O): 0}
ask: {mA: mA, mB: mB, q: q}
)");
  ASSERT_GE(solution.solutions.size(), 2U) << all_warnings(solution);
  expect_open(solution.solutions[0].asks[0]);
  EXPECT_NE(all_warnings(solution).find("force(axle on rotor) at 'facts'"), std::string::npos)
      << all_warnings(solution);
}

// The part of the statement that says too much, by its unknowns and facts; what is well determined is not blamed.
TEST(UnknownSearch, WhatIsOverdeterminedIsNamed) {
  const SolvedStatement solution = solved(R"(title: two unknowns, three facts about them, and one that is another's
gravity: none
points: {A: [0, 0, 0], B: [1.2 m, 0, 0], C: [3 m, 0, 0]}
bodies: {bar: {rod: [A, B], mass: m}, bob: {particle: C, mass: n}}
joints:
  pin: {revolute: z, at: A, to: bar, rate: w}
  rail: {prismatic: y, at: C, to: bob, rate: 2 m/s}
find: {m: kg, w: rad/s, n: kg}
facts: {angular_momentum(bar about A).z: 5 kg*m^2/s, kinetic_energy(bar): 10 J, velocity(B of bar).y: 3 m/s, momentum(bob).y: 6 kg*m/s}
ask: {m: m, w: w}
)");
  EXPECT_TRUE(solution.solutions.empty());
  const std::string said = all_warnings(solution);
  EXPECT_NE(said.find("m, w: 2 unknowns in 3 conditions: "), std::string::npos) << said;
}

// What a clash of a choice is made of.
TEST(UnknownSearch, AChoiceThatCannotBeMadeNamesTheFactsThatClash) {
  const auto said = [](const std::string& choice, const std::string& after) {
    return all_warnings(
        solved("title: jets\nfind: {t1: s, t2: s, t3: s, t4: s}\ngravity: none\n"
               "points: {G: [0, 0, 0], P: [1 m, 0, 0], Q: [-1 m, 0, 0]}\n"
               "bodies: {probe: {mass: 200 kg, center: G, inertia: {axis: z, axial: 40 kg*m^2, "
               "transverse: 60 kg*m^2}}}\nimpulses:\n"
               "  a: {body: probe, at: P, force: [0, 5 N, 0], lasts: t1}\n"
               "  b: {body: probe, at: Q, force: [0, -5 N, 0], lasts: t2}\n"
               "  c: {body: probe, at: G, force: [5 N, 0, 0], lasts: t3}\n"
               "  d: {body: probe, at: G, force: [-5 N, 0, 0], lasts: t4}\n"
               "choose: {fired: {of: [a, b, c, d], " +
               choice + "}}\ninstants:\n  before: {velocity(probe): 0, angular_velocity(probe): 0}\n  after: {" +
               after + "}\nask: {which: fired}\n"));
  };
  // a and b turn it one way only, c and d do not turn it.
  const std::string wrong_way = said("exactly: 2", "angular_velocity(probe).z: -0.1 rad/s, velocity(probe).x: 0.1 m/s");
  EXPECT_NE(wrong_way.find("even all of them together cannot satisfy angular_velocity(probe).z at 'after'; negative"),
            std::string::npos)
      << wrong_way;
  EXPECT_EQ(wrong_way.find("velocity(probe).x"), std::string::npos) << wrong_way;
  // Nothing pushes along z at all.
  const std::string nothing = said("least: total", "velocity(probe): [0, 0, 0.1 m/s]");
  EXPECT_NE(nothing.find("cannot satisfy velocity(probe) at 'after'"), std::string::npos) << nothing;
  EXPECT_EQ(nothing.find("negative values could"), std::string::npos) << nothing;
  // A turn without a push takes both a and b.
  const std::string few = said("exactly: 1", "angular_velocity(probe).z: 0.1 rad/s, velocity(probe): 0");
  EXPECT_NE(few.find("2 would do: a, b"), std::string::npos) << few;
}

// sin b = b: not the mean slope over some range of angles.
TEST(UnknownSearch, WithoutItsSquareAnAngleIsItsSine) {
  const SolvedStatement solution = solved(R"(title: A bob held aside by a force
points: {O: [0, 0, 0], A: [0, -1 m, 0]}
bodies:
  bob: {particle: A, mass: 2 kg}
joints:
  pin: {revolute: z, at: O, to: bob, angle: b, rate: 0 rad/s}
loads:
  push: {body: bob, at: A, force: [3 N, 0, 0]}
gravity: -y
instants:
  now: {angular_acceleration(bob): [0, 0, 0]}
find: {b: rad}
neglect: [b^2]
ask: {b: b}
)");
  ASSERT_EQ(solution.solutions.size(), 1U);
  EXPECT_NEAR(number(solution), 3 / (2 * 9.80665), 1e-14);
}

// Energies of all sizes, the last 10^20 times what is natural.
TEST(UnknownSearch, RootsFarAwayAreFound) {
  for (const double energy : {4.5, 4.5e6, 4.5e12, 4.5e18, 4.5e20}) {
    const SolvedStatement solution = solved(R"(title: A bob that turns
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies:
  bob: {particle: A, mass: 2 kg}
joints:
  pin: {revolute: z, at: O, to: bob, rate: w}
gravity: -y
find: {w: rad/s}
instants:
  now: {kinetic_energy(bob): )" + std::to_string(energy) +
                                            R"( J}
ask: {w: w}
)");
    ASSERT_EQ(solution.solutions.size(), 2U) << energy << all_warnings(solution);
    const double w = std::sqrt(std::stod(std::to_string(energy)));
    EXPECT_NEAR(number(solution, 0, 0), -w, 1e-9 * w);
    EXPECT_NEAR(number(solution, 0, 1), w, 1e-9 * w);
  }
}

TEST(UnknownSearch, ARestitutionThatCannotBeIsTold) {
  const auto puck_leaves_at = [](const std::string& speed) {
    return solved(R"(title: Two pucks
points: {P: [0, 0, 0], Q: [0.1 m, 0, 0]}
bodies:
  a: {particle: P, mass: 2 kg}
  b: {particle: Q, mass: 2 kg}
joints:
  one: {prismatic: x, at: P, to: a}
  two: {prismatic: x, at: Q, to: b}
impacts:
  hit: {of: b, against: a, at: Q, pushes: x, restitution: e}
gravity: none
find: {e: 1}
instants:
  before: {velocity(a).x: 3 m/s, velocity(b).x: 0 m/s}
  after: {velocity(b).x: )" +
                  speed + R"( m/s}
ask: {e: e}
)");
  };
  EXPECT_NEAR(number(puck_leaves_at("2.4")), 0.6, 1e-12);
  EXPECT_NEAR(number(puck_leaves_at("3")), 1, 1e-12);  // elastic, but for rounding
  try {
    puck_leaves_at("3.75");
    ADD_FAILURE() << "the restitution is 1.5";
  } catch (const StatementError& error) {
    EXPECT_NE(std::string(error.what()).find("'hit' is 1.5"), std::string::npos) << error.what();
  }
}

}  // namespace unknown_search_test
}  // namespace poinsot::problem
