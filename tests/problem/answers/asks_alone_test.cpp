// A question without an answer leaves the others theirs.
#include <gtest/gtest.h>

#include <cmath>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace asks_alone_test {

TEST(AsksAlone, FrequenciesWhereNothingIsSteady) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0]}\n"
      "bodies: {d: {mass: 3 kg, center: O, inertia: {axis: z, axial: 0.05 kg*m^2, transverse: 0.05 kg*m^2}}}\n"
      "joints: {wire: {revolute: z, at: O, to: d, angle: q, spring: {stiffness: 2 N*m/rad}}}\ngravity: none\n"
      "instants: {start: {q: 30 deg, q': 0}}\nask: {q1: q @ 1 s, f: frequencies(d), s: stable(d)}\n");
  EXPECT_NEAR(solved.number("q1"), M_PI / 6 * std::cos(std::sqrt(40.0)), 1e-9);
  for (const char* name : {"f", "s"})
    EXPECT_NE(solved.reason(name).find("this is no steady motion"), std::string::npos) << solved.reason(name);
}

// A bob beside the axis pulls a satellite that nothing holds to its side: the mass center of both is not on the axis.
TEST(AsksAlone, WhatDoesNotStayIsNamed) {
  const std::string statement =
      "title: t\npoints: {G: [0, 0, 0], A: [0.5 m, 0, 0]}\nframes: {f: {turns: z, rate: 3 rad/s}}\n"
      "bodies: {sat: {mass: 100 kg, center: G, inertia: {x: 10 kg*m^2, y: 10 kg*m^2, z: 14 kg*m^2}}, "
      "bob: {particle: A, mass: 0.2 kg}}\njoints: {tube: {weld: A, from: sat, to: bob}}\ngravity: none\n";
  const SolvedText solved(statement + "steady: {frame: f}\nask: {s: stable(sat)}\n");
  EXPECT_NE(solved.reason("s").find("would change"), std::string::npos) << solved.reason("s");
  EXPECT_NE(solved.reason("s").find("as steady: says"), std::string::npos) << solved.reason("s");
}

// What has no value for these data, as of a body at rest its precession, and an extremum whose condition has none.
TEST(AsksAlone, WhatHasNoValueForTheseData) {
  const SolvedText rests(
      "title: t\npoints: {G: [0, 0, 0]}\nbodies: {b: {mass: 2 kg, center: G, inertia: {x: 1 kg*m^2, y: 1 kg*m^2, z: 2 "
      "kg*m^2}}}\ngravity: none\nfacts: {angular_velocity(b): [0, 0, 0], velocity(b): [3 m/s, 0, 0]}\nask: {p: "
      "precession_axis(b), T: kinetic_energy(b)}\n");
  EXPECT_EQ(rests.number("T"), 9);
  EXPECT_EQ(rests.reason("p"), "'b' does not turn: it has no angular momentum");

  const SolvedText falls(
      "title: t\ngiven: {h: 5 m}\npoints: {O: [0, h, 0]}\nbodies: {b: {particle: O, mass: 1 kg}}\ngravity: -y\n"
      "instants: {start: rest}\nask: {least: {smallest: h, while: 'center(b).y @ 2 s > 0 m'}, later: {smallest: h, "
      "while: 'min(center(b).y) > 0 m'}}\n");
  EXPECT_NEAR(falls.number("least"), 2 * 9.80665, 1e-8);
  EXPECT_NE(falls.reason("later").find("goes on falling"), std::string::npos) << falls.reason("later");
}

TEST(AsksAlone, TheEnergyOfATurningWhoseFlightIsNotStated) {
  const SolvedText solved(
      "title: t\npoints: {G: [0, 0, 0]}\n"
      "bodies: {b: {mass: 5 kg, center: G, inertia: {x: 2 kg*m^2, y: 3 kg*m^2, z: 4 kg*m^2}}}\ngravity: none\n"
      "facts: {angular_velocity(b): [1 rad/s, 2 rad/s, 0]}\n"
      "ask: {T: kinetic_energy(b), own: kinetic_energy(b about center(b))}\n");
  EXPECT_NE(solved.reason("T").find("kinetic_energy(b about center(b)) is that of its turning alone"),
            std::string::npos)
      << solved.reason("T");
  EXPECT_NEAR(solved.number("own"), 7, 1e-12);
}

// Two hinges on one line share the force along it: nothing says how, also where only a table along the motion asks.
TEST(AsksAlone, SharedForcesInATable) {
  for (const char* of : {"reaction(A).z", "reaction(B).z + 0 * 1 N * theta"}) {
    const SolvedText solved(
        "title: t\npoints: {A: [0, 0, 0], P: [1 m, 0, 0], B: [0, 0, 1 m]}\nbodies: {bar: {rod: [A, P], mass: 2 kg}}\n"
        "joints: {pin: {revolute: A->B, at: A, to: bar, angle: theta, supports: {A: [x, y, z], B: [x, y, z]}}}\n"
        "gravity: -y\ninstants: {start: {theta: 0, theta': 0}}\n"
        "ask: {t: {table: {r: " +
        std::string(of) + "}, over: {time: [0, 1 s]}}}\n");
    EXPECT_NE(solved.reason("t").find("share the same load"), std::string::npos) << solved.reason("t");
  }
}

// Thrown so that the cord goes slack, at the angle where v^2/L falls to the weight's part; then it catches and goes
// slack again and again.
TEST(AsksAlone, TheFirstTimeOfWhatHappensWithoutEnd) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0], B: [0, -0.5 m, 0]}\nbodies: {bob: {particle: B, mass: 0.3 kg}}\n"
      "cords: {c: {at: O, to: bob, end: B}}\ngravity: -y\ninstants: {start: {velocity(bob): [3.6 m/s, 0, 0]}}\n"
      "ask: {t: {first_time: tension(c) < 1e-9 N}, T0: tension(c) @ start, hi: max(center(bob).y)}\n");
  const double g = 9.80665, L = 0.5, v2 = 3.6 * 3.6;
  EXPECT_NEAR(solved.number("T0"), 0.3 * (g + v2 / L), 1e-9);
  // v^2 = v0^2 - 2 g L (1 - cos a) and v^2 = -g L cos a at the end: the time by the integral of L da / v.
  const double end = std::acos((2 * g * L - v2) / (3 * g * L));
  constexpr int steps = 2000;
  double time = 0;
  for (int i = 0; i <= steps; ++i) {
    const double v = std::sqrt(v2 - 2 * g * L * (1 - std::cos(end * i / steps)));
    time += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * L / v * end / steps / 3;
  }
  EXPECT_NEAR(solved.number("t"), time, 1e-8);
  EXPECT_NE(solved.reason("hi").find("give way and catch again without end"), std::string::npos) << solved.reason("hi");
  EXPECT_LT(solved.notes().size(), 20U);
}

// A wall that is not reached at the letters that are drawn, beside when and where the block stops.
TEST(AsksAlone, AnInstantThatDoesNotComeAtTheLettersDrawn) {
  const SolvedText solved(
      "title: t\nletters: {v: m/s, mu: 1, d: m, m: kg}\npoints: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: m}}\n"
      "contacts: {floor: {of: b, at: O, normal: y, friction: mu}}\ngravity: -y\n"
      "instants: {start: {velocity(b): [v, 0, 0]}, there: {first_time: position(b).x == d}, stops: {first_time: "
      "sticking(floor)}}\nask: {t: time @ there, T: time @ stops, X: position(b).x @ stops}\n");
  EXPECT_NE(solved.reason("t").find("does not happen up to"), std::string::npos) << solved.reason("t");
  for (const char* name : {"T", "X"}) EXPECT_TRUE(solved.ask(name).formula) << name << solved.ask(name).no_formula;
}

TEST(AsksAlone, ARowInWhichTheStatementMakesNoSense) {
  const std::string falls =
      "title: t\ngiven: {h: 1 m}\npoints: {O: [0, 0, 0], H: [0, h, 0]}\nbodies: {b: {particle: H, mass: 1 kg}}\n"
      "contacts: {floor: {of: b, at: H, surface: O, normal: y, open: true, restitution: 0.5}}\ngravity: -y\n"
      "instants: {start: rest, lands: {first_time: touching(floor)}}\n";
  for (const char* rows : {"[1 m, 0 m]", "[0 m, 1 m]"}) {
    const SolvedText solved(falls + "ask: {one: time @ lands, all: {table: {t: time @ lands}, over: {h: " + rows +
                            "}}}\n");
    EXPECT_NEAR(solved.number("one"), std::sqrt(2 / 9.80665), 1e-9);
    EXPECT_EQ(solved.column("all", 0).size(), 1U);
  }
  EXPECT_THROW(SolvedText(falls + "ask: {all: {table: {t: times @ lands}, over: {h: [1 m, 2 m]}}}\n"), StatementError);
}

TEST(AsksAlone, AnExtremumThatIsNotSoughtBesideFriction) {
  const std::string pulled =
      "title: t\ngiven: {F: 5 N, mu: 0.3, m: 2 kg}\npoints: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: m}}\n"
      "contacts: {floor: {of: b, at: O, normal: y, friction: mu}}\nloads: {pull: {force: '[F, 0, 0]', body: b}}\n"
      "gravity: -y\ninstants: {start: rest}\n";
  const std::string least = "least: {smallest: F, while: 'position(b).x @ 10 s > 1e-9 m'}";
  const SolvedText solved(pulled + "ask: {s: sticking(floor), " + least + ", x: position(b).x @ 10 s}\n");
  EXPECT_TRUE(solved.found("s").value.truth);
  EXPECT_EQ(solved.number("x"), 0);
  EXPECT_EQ(solved.reason("least").find("extrema are not sought where contacts have friction"), 0U);
  EXPECT_THROW(SolvedText(pulled + "ask: {" + least + "}\n"), StatementError);
}

// Of a machine without mass and loads forces and couples are zero, and rounding of them is no fault.
TEST(AsksAlone, TheMotionOfAMachineWithoutMass) {
  const SolvedText solved(
      "title: t\nplane: [x, y]\ngiven: {a: 3 in, h: 8 in}\npoints: {O: [0, 0], Q: [0, -h], P: [0, a]}\n"
      "bodies: {crank: massless, arm: massless}\njoints:\n  j1: {revolute: z, at: O, to: crank, rate: 2 rad/s, accel: "
      "0}\n  j2: {revolute: z, at: Q, to: arm, angle: q}\n  j3: {slot: [y, z], at: P, from: arm, to: crank}\n"
      "gravity: none\nask: {w: q', most: max(q), M: drive(j1)}\n");
  EXPECT_NEAR(solved.number("w"), 2 * 3.0 / 11, 1e-12);
  EXPECT_NEAR(solved.number("most"), std::asin(3.0 / 8), 1e-9);
  EXPECT_NEAR(solved.number("M"), 0, 1e-9);
}

// Data that are made of what is to be found are told like it.
TEST(AsksAlone, DataMadeOfUnknowns) {
  const SolvedText solved(
      "title: t\ngiven: {m: 2 kg, I: m*r^2}\nfind: {r: m}\npoints: {O: [0, 0, 0]}\n"
      "bodies: {hoop: {ring: {center: O, normal: z, radius: r}, mass: m}}\ngravity: none\n"
      "facts: {moment_of_inertia(hoop about x at O): 4 kg*m^2}\nask: {I: I}\n");
  EXPECT_NEAR(solved.number("I"), 8, 1e-9);
}

}  // namespace asks_alone_test
}  // namespace poinsot::problem
