// When smooth contacts touch and part and cords are taut, motions of bodies whose flight is open, and the energy of
// what comes to rest, against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace motion_holds_test {

constexpr double g = 9.80665;

std::string dropped(double restitution, double floor, const std::string& asks) {
  const std::string y = std::to_string(floor), e = std::to_string(restitution);
  return "title: t\npoints: {C: [0, '" + y + " m + 0.5 m', 0], O: [0, " + y +
         " m, 0]}\nbodies: {ball: {particle: C, mass: 2 kg}}\n"
         "contacts: {floor: {of: ball, at: C, normal: y, open: true, surface: O, restitution: " +
         e + "}}\ngravity: -y\ninstants: {start: rest, lands: {first_time: touching(floor)}}\nask: {" + asks + "}\n";
}

// A motion that another question has followed to its end before has the same times.
TEST(MotionHolds, AreFoundInAMotionThatIsOverBefore) {
  const SolvedText solved(
      "title: t\npoints: {C: [0, 1 m, 0], O: [0, 0, 0]}\nbodies: {ball: {particle: C, mass: 1 kg}}\n"
      "contacts: {floor: {of: ball, at: C, normal: y, open: true, surface: O, restitution: 0.5}}\n"
      "gravity: -y\nstages: {run: {lasts: 0.6 s}}\ninstants: {run.start: rest, lands: {first_time: "
      "touching(floor)}}\nask: {last: center(ball).y @ run.end, t: time @ lands}\n");
  EXPECT_NEAR(solved.number("t"), std::sqrt(2 / g), 1e-9);
}

// The energy of the last bounces is nothing beside that of the first, also where the floor is the level of no energy.
TEST(MotionHolds, BounceAfterBounceIsTouchingAndParting) {
  const double fall = std::sqrt(2 * 0.5 / g);
  for (const double e : {0.1, 0.5, 0.8})
    for (const double floor : {0.0, 3.0}) {
      const SolvedText solved(dropped(e, floor,
                                      "ends: end_of_bouncing(floor), first: {first_time: touching(floor)}, "
                                      "apart: {times: parting(floor), from: 0.1 s, to: 0.5 s}, t: time @ lands"));
      EXPECT_NEAR(solved.number("ends"), (1 + e) / (1 - e) * fall, 1e-8);
      EXPECT_NEAR(solved.number("first"), fall, 1e-9);
      EXPECT_NEAR(solved.number("t"), fall, 1e-9);
      // It is apart from the start of the span, and parts again in each blow.
      EXPECT_GE(solved.found("apart").value.items.size(), 2U);
      EXPECT_NEAR(solved.found("apart").value.items.at(0).number, 0.1, 1e-9);
      EXPECT_NEAR(solved.found("apart").value.items.at(1).number, fall, 1e-9);
    }
}

TEST(MotionHolds, ABallRestsWithoutRebound) {
  const SolvedText solved(dropped(
      0, 0, "t: {times: touching(floor), from: 0 s, to: 2 s}, apart: {times: parting(floor), from: 0.1 s, to: 2 s}"));
  EXPECT_EQ(solved.found("apart").value.items.size(), 1U);  // the start of the span
  ASSERT_EQ(solved.found("t").value.items.size(), 1U);
  EXPECT_NEAR(solved.found("t").value.items.at(0).number, std::sqrt(1 / g), 1e-9);
}

// A ladder leaves its wall at two thirds of the height from which it slides.
TEST(MotionHolds, ALadderLeavesItsWall) {
  const SolvedText solved(
      "title: t\nplane: [x, y]\ngiven: {b: 25 deg}\npoints: {A: '[0, 2 m * cos(b)]', B: '[2 m * sin(b), 0]'}\n"
      "bodies: {rod: {rod: [A, B], mass: 3 kg}}\n"
      "contacts: {wall: {of: rod, at: A, normal: x}, floor: {of: rod, at: B, normal: y}}\ngravity: -y\n"
      "instants: {start: rest, leaves: {first_time: parting(wall)}}\n"
      "ask: {h: position(A of rod).y @ leaves, N: force(floor on rod).y @ leaves, at_once: {first_time: "
      "touching(wall)}}\n");
  EXPECT_NEAR(solved.number("h"), 4 * std::cos(25 * M_PI / 180) / 3, 1e-8);
  EXPECT_EQ(solved.number("at_once"), 0);
}

// A ball in free fall is caught by its cord where it comes to the length that it has had from the start.
TEST(MotionHolds, ACordCatches) {
  const SolvedText solved(
      "title: t\npoints: {A: [0, 0, 0], B: [0, 1 m, 0]}\nbodies: {ball: {particle: B, mass: 1 kg}}\n"
      "cords: {cord: {at: A, to: ball, end: B}}\ngravity: -y\n"
      "instants: {start: {velocity(ball): [0.5 m/s, 0, 0]}}\n"
      "ask: {t: {first_time: taut(cord), from: 0.05 s}, y: center(ball).y @ 0.3 s}\n");
  // x^2 + (1 - g t^2/2)^2 = 1 with x = t/2: t^2/4 - g t^2 + g^2 t^4/4 = 0.
  const double t = std::sqrt(g - 0.25) * 2 / g;
  EXPECT_NEAR(solved.number("t"), t, 1e-8);
  EXPECT_NEAR(solved.number("y"), 1 - g * 0.045, 1e-9);
}

// Thrown anywhere within reach, a bob flies until its cord is taut, loses what would stretch it, and swings on with its
// energy and, without weight, its angular momentum.
TEST(MotionHolds, ASlackCordCatches) {
  std::mt19937 random(11);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  int tried = 0;
  for (int i = 0; i < 12; ++i) {
    const Vector3<double> at{between(-0.5, 0.5), between(-0.5, 0.5), between(-0.5, 0.5)},
        v{between(-2, 2), between(-2, 2), between(-2, 2)};
    const double length = between(1, 1.5);
    // |at + v t| = length.
    const double vv = dot(v, v), av = dot(at, v),
                 t = (-av + std::sqrt(av * av + vv * (length * length - dot(at, at)))) / vv;
    const Vector3<double> n = (1 / length) * (at + t * v), across = v - dot(v, n) * n;
    const SolvedText solved(fmt::format(
        "title: t\npoints: {{A: [0, 0, 0], B: [{} m, {} m, {} m]}}\nbodies: {{ball: {{particle: B, mass: 2 kg}}}}\n"
        "cords: {{cord: {{at: A, to: ball, end: B, length: {} m}}}}\ngravity: none\n"
        "instants: {{start: {{velocity(ball): [{} m/s, {} m/s, {} m/s]}}}}\n"
        "ask: {{t: {{first_time: taut(cord)}}, v: velocity(ball) @ {} s, far: norm(position(ball)) @ {} s, "
        "w: norm(velocity(ball)) @ {} s, T: tension(cord) @ {} s, slack: tension(cord), loose: taut(cord) @ {} s, "
        "holds: taut(cord) @ {} s}}\n",
        at.x, at.y, at.z, length, v.x, v.y, v.z, t * (1 + 1e-9), 2 * t, 2 * t, 2 * t, t / 2, 2 * t));
    EXPECT_NEAR(solved.number("t"), t, 1e-9 * t);
    EXPECT_NEAR(norm(solved.vector("v") - across), 0, 1e-7);
    EXPECT_NEAR(solved.number("far"), length, 1e-9);
    EXPECT_NEAR(solved.number("w"), norm(across), 1e-8);
    EXPECT_NEAR(solved.number("T"), 2 * dot(across, across) / length, 1e-7);
    EXPECT_EQ(solved.number("slack"), 0);
    EXPECT_FALSE(solved.found("loose").value.truth);
    EXPECT_TRUE(solved.found("holds").value.truth);
    ++tried;
  }
  EXPECT_EQ(tried, 12);
}

// The moment of the pull about the particle in the origin is rounding, however the cord lies.
TEST(MotionHolds, ACordBetweenTwoParticlesOneOfThemInTheOrigin) {
  const SolvedText at_rest(
      "title: t\npoints: {A: [0, 0, 0], B: [0.6 m, 0.8 m, 0]}\nbodies: {a: {particle: A, mass: 0.5 kg}, b: {particle: "
      "B, "
      "mass: 0.3 kg}}\ncords: {c: {from: a, at: A, to: b, end: B}}\ngravity: none\n"
      "instants: {start: {velocity(a): [0, 0, 0], velocity(b): [-3.2 m/s, 2.4 m/s, 0]}}\nask: {T: tension(c) @ 1 s}\n");
  EXPECT_NEAR(at_rest.number("T"), 3, 1e-9);
  for (int i = 0; i < 40; ++i) {
    const double b = 0.1 + 0.157 * i;
    const SolvedText solved(fmt::format(
        "title: t\npoints: {{A: [0, 0, 0], B: [{} m, {} m, 0]}}\nbodies: {{a: {{particle: A, mass: 0.5 kg}}, b: "
        "{{particle: "
        "B, mass: 0.3 kg}}}}\ncords: {{c: {{from: a, at: A, to: b, end: B}}}}\ngravity: none\n"
        "instants: {{start: {{velocity(a): [1 m/s, 0.7 m/s, 0], velocity(b): [{} m/s, {} m/s, 0]}}}}\nask: {{T: "
        "tension(c)}}\n",
        std::cos(b), std::sin(b), 1 - 4 * std::sin(b), 0.7 + 4 * std::cos(b)));
    EXPECT_NEAR(solved.number("T"), 0.15 / 0.8 * 16, 1e-9) << b;
  }
}

// What lies on the floor is lifted by the jerk of a rope that goes taut over a post; what the jerk presses stays.
TEST(MotionHolds, ARopeThatGoesTautLiftsWhatLies) {
  const auto text = [](double M) {
    return fmt::format(
        "title: t\ngiven: {{r: 0.1 m}}\npoints: {{E: [0, 2 m, 0], A: [-r, 1.5 m, 0], B: [r, 0, 0]}}\n"
        "bodies: {{a: {{particle: A, mass: 2 kg}}, b: {{particle: B, mass: {} kg}}}}\ngravity: -y\n"
        "instants: {{start: rest}}\ncontacts: {{floor: {{of: b, at: B, normal: y}}}}\n"
        "cords: {{rope: {{from: a, at: A, over: [{{E: {{radius: r}}}}], to: b, end: B, length: 3 m + pi*r}}}}\n"
        "ask: {{v: velocity(b).y @ {} s, N: force(floor on b).y @ 0.2 s, y: position(b).y @ 0.5 s}}\n",
        M, std::sqrt(1 / g) * (1 + 1e-9));
  };
  for (const double M : {2.5, 5.0}) {
    const SolvedText solved(text(M));
    const double V = 2 * std::sqrt(g) / (2 + M), t = 0.5 - std::sqrt(1 / g), a = (M - 2) * g / (2 + M);
    EXPECT_NEAR(solved.number("N"), M * g, 1e-8);
    EXPECT_NEAR(solved.number("v"), V, 1e-6);
    EXPECT_NEAR(solved.number("y"), V * t - a * t * t / 2, 1e-8) << M;
    EXPECT_TRUE(std::ranges::any_of(solved.notes(), [](const std::string& note) {
      return note.starts_with("the contact 'floor' is lost at 0.3193");
    }));
  }
}

// A cord as long as it is drawn is a cord of which nothing is said; over a post its length counts what lies on that.
TEST(MotionHolds, ACordAsLongAsDrawnIsTaut) {
  const auto text = [](const std::string& more) {
    return "title: t\ngiven: {r: 0.1 m}\npoints: {E: [0, 2 m, 0], A: [-r, 0.5 m, 0], B: [r, 0, 0]}\n"
           "bodies: {a: {particle: A, mass: 2 kg}, b: {particle: B, mass: 3 kg}}\ngravity: -y\ninstants: {start: "
           "rest}\n"
           "cords: {rope: {from: a, at: A, over: [{E: {radius: r}}], to: b, end: B" +
           more + "}}\nask: {a: acceleration(a).y, T: tension(rope on b), y: position(b).y @ 0.4 s}\n";
  };
  const SolvedText stated(text(", length: 3.5 m + pi*r")), drawn(text("")), slack(text(", length: 3.7 m + pi*r"));
  for (const char* name : {"a", "T", "y"}) EXPECT_NEAR(stated.number(name), drawn.number(name), 1e-9) << name;
  EXPECT_NEAR(stated.number("a"), g / 5, 1e-9);
  EXPECT_NEAR(slack.number("a"), -g, 1e-12);
  EXPECT_EQ(slack.number("T"), 0);
  // Both fall until that has taken up what the rope is longer; then the heavier one goes on down.
  const double falls = std::sqrt(0.2 / g), V = g * falls / 5, t = 0.4 - falls;
  EXPECT_NEAR(slack.number("y"), -0.1 - V * t - g / 5 * t * t / 2, 1e-9);
  EXPECT_NE(failure_of_text(text(", length: 3.5 m")).find("cord 'rope' is 3.5 m long and drawn over 3.81416 m"),
            std::string::npos);
}

TEST(MotionHolds, WhatACordThatIsSlackMayNotBe) {
  const auto failure = [](const std::string& cord, const std::string& joints = "") {
    return failure_of_text(
        "title: t\npoints: {C: [0, 1 m, 0], A: [-0.1 m, 0, 0], B: [0.1 m, 0, 0]}\n"
        "bodies: {wheel: {disk: {center: C, normal: z, radius: 0.1 m}, mass: 1 kg}, b: {particle: B, mass: 1 kg}}\n"
        "joints: {axle: {revolute: z, at: C, to: wheel" +
        joints + "}}\ngravity: -y\ninstants: {start: rest}\ncords: {rope: {" + cord +
        "}}\nask: {a: acceleration(b).y}\n");
  };
  EXPECT_NE(failure("at: A, over: [wheel], to: b, end: B, length: 3 m").find("turns 'wheel' and states its length"),
            std::string::npos);
  EXPECT_NE(failure("at: A, over: [{wheel: {friction: 0.2}}], to: b, end: B, length: 3 m")
                .find("has friction on 'wheel' and states its length"),
            std::string::npos);
  EXPECT_NE(failure("from: {wheel: {side: +x}}, to: b, end: B, length: 3 m").find("is of no one length"),
            std::string::npos);
  EXPECT_NE(failure("holds: b, at: B, pulls: +y, length: 3 m").find("states both holds and length"), std::string::npos);
}

TEST(MotionHolds, WhatIsNotThereIsNamed) {
  EXPECT_NE(failure_of_text(dropped(0.5, 0, "t: {first_time: touching(flor)}")).find("did you mean 'floor'"),
            std::string::npos);
  EXPECT_NE(failure_of_text(dropped(0.5, 0, "t: {first_time: sticking(floor)}")).find("with friction"),
            std::string::npos);
}

// The turning of a plate with moments J, J, 2 J goes round about its angular momentum, wherever it flies.
TEST(MotionHolds, TheTurningOfWhatFliesFreeNeedsNoFlight) {
  const SolvedText solved(
      "title: t\npoints: {G: [0, 0, 0], A: [0.1 m, 0, 0]}\n"
      "bodies: {plate: {rectangle: {center: G, sides: [0.3 m * x, 0.3 m * y]}, mass: 2 kg}}\n"
      "facts: {angular_velocity(plate): [5 rad/s, 0, 5 rad/s]}\ngravity: -z\n"
      "ask: {w: angular_velocity(plate) @ 0.7 s, v: velocity(plate) @ 0.7 s, p: position(A of plate) @ 0.001 s,\n"
      "  r: position(A of plate) @ 0.7 s - center(plate) @ 0.7 s, T: kinetic_energy(plate) @ 0.7 s}\n");
  const double turned = std::sqrt(5) * 5 * 0.7;
  const Vector3<double> w = solved.vector("w");
  EXPECT_NEAR(w.x, 3 + 2 * std::cos(turned), 1e-9);
  EXPECT_NEAR(w.y, std::sqrt(5) * std::sin(turned), 1e-9);
  EXPECT_NEAR(w.z, 6 - std::cos(turned), 1e-9);
  EXPECT_NEAR(norm(solved.vector("r")), 0.1, 1e-9);
  for (const char* open : {"v", "p", "T"})
    EXPECT_NE(solved.reason(open).find("velocity of plate along"), std::string::npos) << solved.reason(open);
}

// A cord that catches lifts what lies on a floor: m v = (m + M) u, and then as in Atwood's machine.
TEST(MotionHolds, ACordThatCatchesLiftsAWeightOffItsFloor) {
  const double g = 9.80665, v = 4.905, back = 2 * v / g, t = 1.4 - back, u = v / 3, a = g / 3;
  for (const char* floor : {"normal: y", "normal: y, restitution: 0.3"}) {
    const SolvedText solved(
        "given: {m: 1 kg, M: 2 kg, v: 4.905 m/s}\npoints: {O: [0, 9 m, 0], A: [-1 m, 3 m, 0], B: [1 m, 0, 0]}\n"
        "bodies: {light: {particle: A, mass: m}, heavy: {particle: B, mass: M}}\n"
        "cords: {rope: {from: light, at: A, over: [{O: {radius: 1 m}}], to: heavy, end: B}}\n"
        "contacts: {floor: {of: heavy, at: B, " +
        std::string(floor) +
        "}}\nimpulses: {toss: {body: light, value: [0, m*v, 0]}}\ngravity: -y\ninstants: {before: rest}\n"
        "ask: {u: velocity(heavy).y @ 1.4 s, y: center(heavy).y @ 1.4 s, l: center(light).y @ 1.4 s}\n");
    EXPECT_NEAR(solved.number("u"), u - a * t, 1e-9) << floor;
    EXPECT_NEAR(solved.number("y"), u * t - a * t * t / 2, 1e-9) << floor;
    EXPECT_NEAR(solved.number("l"), 3 - u * t + a * t * t / 2, 1e-9) << floor;
  }
}

const std::string table_on_four_feet =
    "given: {m: 10 kg}\npoints: {G: [0, 0.5 m, 0], A: [0.4 m, 0, 0.3 m], B: [0.4 m, 0, -0.3 m], "
    "C: [-0.4 m, 0, -0.3 m], D: [-0.4 m, 0, 0.3 m]}\n"
    "bodies: {table: {mass: m, center: G, inertia: {x: 1 kg*m^2, y: 1 kg*m^2, z: 1 kg*m^2, xy: 0, yz: 0, zx: 0}}}\n"
    "contacts: {a: {of: table, corner: A, normal: y}, b: {of: table, corner: B, normal: y}, "
    "c: {of: table, corner: C, normal: y}, d: {of: table, corner: D, normal: y}}\n"
    "gravity: -y\ninstants: {start: rest}\n";

// Of contacts that share a load none is lost while some share leaves all pressing: not where the table slides, and of
// one that is pushed at its top by a force that grows the rear feet at once, where k t h/2 = m g 0.4 m.
TEST(MotionHolds, FeetThatShareALoadAreNotLostByChance) {
  const SolvedText pushed(table_on_four_feet +
                          "stages: {run: {lasts: 3 s}}\nloads: {push: {force: [20 N, 0, 0], at: G, body: table}}\n"
                          "ask: {x: center(table).x @ 2 s, t: {first_time: parting(d)}, N: normal_force(a) @ 1 s, "
                          "S: normal_force(a) @ 1 s + normal_force(b) @ 1 s}\n");
  EXPECT_NEAR(pushed.number("x"), 4, 1e-9);
  EXPECT_NEAR(pushed.number("S"), 5 * 9.80665, 1e-8);
  EXPECT_NE(pushed.ask("t").state, AskState::found);
  EXPECT_NE(pushed.ask("N").state, AskState::found);
  const SolvedText tipped(table_on_four_feet +
                          "loads: {push: {force: [20 N/s * time, 0, 0], at: [0, 1 m, 0], body: table}}\n"
                          "ask: {c: {first_time: parting(c)}, d: {first_time: parting(d)}, "
                          "w: angular_velocity(table) @ 4.2 s}\n");
  EXPECT_NEAR(tipped.number("c"), 10 * 9.80665 * 0.4 / 10, 1e-7);
  EXPECT_NEAR(tipped.number("d"), 10 * 9.80665 * 0.4 / 10, 1e-7);
  const Vector3<double> w = tipped.ask("w").value.vector;
  EXPECT_LT(w.z, -1e-3);
  EXPECT_NEAR(w.x, 0, 1e-9);
  EXPECT_NEAR(w.y, 0, 1e-9);
}

// A table that is lifted and let down lands on its feet at once: flat, it stands; tilted about z, it goes on turning
// about z alone.
TEST(MotionHolds, FeetThatLandAtOnceAreStruckTogether) {
  const SolvedText flat(table_on_four_feet +
                        "loads: {lift: {force: [0, 200 N - 200 N/s * time, 0], at: G, body: table}}\n"
                        "ask: {y: center(table).y @ 1.4 s, end: center(table).y @ 1.6 s, v: velocity(table) @ 1.6 s, "
                        "w: angular_velocity(table) @ 1.6 s}\n");
  EXPECT_NEAR(flat.number("y"), 0.5 + (20 - 9.80665) / 2 * 1.4 * 1.4 - 10. / 3 * 1.4 * 1.4 * 1.4, 1e-8);
  EXPECT_NEAR(flat.number("end"), 0.5, 1e-9);
  EXPECT_NEAR(norm(flat.ask("v").value.vector), 0, 1e-9);
  EXPECT_NEAR(norm(flat.ask("w").value.vector), 0, 1e-9);
  const SolvedText tilted(table_on_four_feet +
                          "loads: {lift: {force: [0, 200 N - 200 N/s * time, 0], at: G, body: table}, "
                          "turn: {couple: [0, 0, 0.1 N*m], body: table}}\n"
                          "ask: {w: angular_velocity(table) @ 1.6 s, z: center(table).z @ 1.6 s}\n");
  EXPECT_NEAR(tilted.ask("w").value.vector.x, 0, 1e-9);
  EXPECT_NEAR(tilted.ask("w").value.vector.y, 0, 1e-9);
  EXPECT_NEAR(tilted.number("z"), 0, 1e-9);
}

}  // namespace motion_holds_test
}  // namespace poinsot::problem
