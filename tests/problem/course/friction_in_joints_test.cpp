// Friction in joints at instants and along motions, against closed forms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace friction_in_joints_test {

constexpr double g = 9.80665;

std::string arm(double P, const std::string& friction, const std::string& more) {
  return fmt::format(
             "given: {{P: {} N, M: 5 N*m}}\npoints: {{O: [0, 0, 0], A: [0.6 m, 0, 0]}}\nbodies: {{arm: {{rod: [O, A], "
             "mass: 1.2 "
             "kg}}}}\njoints: {{hinge: {{revolute: z, at: O, to: arm, rate: 0, friction: {}}}}}\n"
             "loads: {{lamp: {{force: [0, -P, 0], at: A, body: arm}}}}\ngravity: -y\n",
             P, friction) +
         more;
}

// It holds while the couple of the weights is less than its own, and else takes the one of a hinge that moves.
TEST(FrictionInJoints, AHingeHoldsOrGivesWay) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> load(-10, 20);
  int held = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const double P = load(random), couple = 0.6 * (0.6 * g + P), I = 1.2 * 0.36 / 3;
    const SolvedText solved(arm(P, "{static: 5 N*m, kinetic: 4 N*m}",
                                "ask: {F: friction(hinge on arm), a: angular_acceleration(arm).z, "
                                "s: sticking(hinge), R: reaction(hinge).y, M: drive(hinge).z, C: couple(hinge on arm "
                                "about O).z}\n"));
    const bool holds = std::abs(couple) < 5;
    held += holds;
    const double friction = holds ? couple : std::copysign(4, couple), a = (friction - couple) / I;
    EXPECT_EQ(solved.found("s").value.truth, holds) << P;
    EXPECT_NEAR(solved.vector("F").z, friction, 1e-9) << P;
    EXPECT_NEAR(solved.number("a"), a, 1e-8) << P;
    EXPECT_NEAR(solved.number("R"), 1.2 * (g + a * 0.3) + P, 1e-8) << P;
    // The drive is that alone; what the joint exerts is all of it.
    EXPECT_NEAR(solved.number("M"), 0, 1e-12);
    EXPECT_NEAR(solved.number("C"), friction, 1e-9);
  }
  EXPECT_GT(held, 0);
  EXPECT_LT(held, 8);
}

TEST(FrictionInJoints, LimitsAndUnknownsAreFound) {
  const SolvedText limits(arm(1, "M",
                              "ask: {P: {largest: P, while: sticking(hinge)}, "
                              "M: {smallest: M, while: sticking(hinge)}}\n"));
  EXPECT_NEAR(limits.number("P"), 5 / 0.6 - 0.6 * g, 1e-7);
  EXPECT_NEAR(limits.number("M"), 0.6 * (0.6 * g + 1), 1e-7);
  const SolvedText found(
      "given: {I: 0.5 kg*m^2}\nfind: {M: N*m}\npoints: {O: [0, 0, 0]}\n"
      "bodies: {wheel: {mass: 4 kg, center: O, inertia: {axis: z, axial: I, transverse: I}}}\n"
      "joints: {axle: {revolute: z, at: O, to: wheel, rate: 9 rad/s, friction: M}}\ngravity: none\n"
      "instants: {now: {angular_acceleration(wheel).z: -3 rad/s^2}}\nask: {M: M}\n");
  EXPECT_NEAR(found.number("M"), 1.5, 1e-9);
}

TEST(FrictionInJoints, AClutchBringsTwoWheelsTogether) {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> inertia(0.2, 2), rate(-80, 80), couple(2, 30);
  for (int trial = 0; trial < 5; ++trial) {
    const double I = inertia(random), J = inertia(random), n = rate(random), p = rate(random), M = couple(random);
    const double t = std::abs(n - p) / (M * (1 / I + 1 / J)), w = (I * n + J * p) / (I + J);
    const SolvedText solved(fmt::format(
        "given: {{I: {} kg*m^2, J: {} kg*m^2}}\npoints: {{A: [0, 0, 0], B: [1 m, 0, 0]}}\nbodies:\n"
        "  one: {{mass: 1 kg, center: A, inertia: {{axis: x, axial: I, transverse: I}}}}\n"
        "  two: {{mass: 1 kg, center: B, inertia: {{axis: x, axial: J, transverse: J}}}}\n"
        "joints:\n  shaft: {{revolute: x, at: A, to: one, rate: {} rad/s}}\n"
        "  clutch: {{revolute: x, at: A, from: one, to: two, rate: {} rad/s, friction: {} N*m}}\ngravity: none\n"
        "ask: {{t: {{first_time: sticking(clutch)}}, w: angular_velocity(one).x @ {} s, u: angular_velocity(two).x @ "
        "{} "
        "s, E: kinetic_energy(system) @ {} s}}\n",
        I, J, n, p - n, M, 1.5 * t, 1.5 * t, 0.5 * t));
    EXPECT_NEAR(solved.number("t"), t, 1e-9 * t);
    EXPECT_NEAR(solved.number("w"), w, 1e-8 * (1 + std::abs(w)));
    EXPECT_NEAR(solved.number("u"), w, 1e-8 * (1 + std::abs(w)));
    const double half = (n + p) / 2, s = std::copysign(M * 0.5 * t, p - n);
    const double one = n + s / I, two = p - s / J;
    EXPECT_NEAR(solved.number("E"), 0.5 * (I * one * one + J * two * two), 1e-7 * (1 + half * half));
  }
}

// Between its turning points the collar swings about a place that friction has moved by F/k.
TEST(FrictionInJoints, ACollarOnASpringStopsWhereItIsHeld) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> start(-0.4, 0.4), friction(2, 10);
  int moved = 0;
  for (int trial = 0; trial < 6; ++trial) {
    const double s = start(random), F = friction(random), S = 1.2 * F, k = 200;
    double x = s;
    while (k * std::abs(x) > S) x = (x > 0 ? -1 : 1) * (std::abs(x) - 2 * F / k);
    moved += x != s;
    const SolvedText solved(fmt::format(
        "points: {{O: [0, 0, 0]}}\nbodies: {{collar: {{cube: {{center: O, side: 50 mm}}, mass: 2 kg}}}}\n"
        "joints: {{rod: {{prismatic: x, at: O, to: collar, displacement: x1, spring: {{stiffness: 200 N/m}}, "
        "friction: {{static: {} N, kinetic: {} N}}}}}}\ngravity: -y\ninstants: {{start: {{x1: {} m, x1': 0}}}}\n"
        "ask: {{x: x1 @ 12 s, F: friction(rod on collar).x @ 12 s}}\n",
        S, F, s));
    EXPECT_NEAR(solved.number("x"), x, 1e-8) << s << " " << F;
    EXPECT_NEAR(solved.number("F"), k * x, 1e-6) << s << " " << F;
  }
  EXPECT_GT(moved, 2);
}

TEST(FrictionInJoints, LettersTellBothStates) {
  const std::string text =
      "letters: {I: kg*m^2, M: N*m, Q: N*m}\npoints: {O: [0, 0, 0]}\n"
      "bodies: {wheel: {mass: 4 kg, center: O, inertia: {axis: z, axial: I, transverse: I}}}\n"
      "joints: {axle: {revolute: z, at: O, to: wheel, rate: 0, couple: Q, friction: M}}\ngravity: none\n"
      "ask: {a: angular_acceleration(wheel).z}\n";
  const SolvedStatement solved = solve_statement(read_statement(text, "test.yaml"), {});
  ASSERT_GE(solved.solutions.size(), 2U);
  for (const Solution& solution : solved.solutions)
    EXPECT_TRUE(solution.asks.front().formula) << solution.notes.front();
}

TEST(FrictionInJoints, MistakesAreTold) {
  const auto hinge = [](const std::string& joint, const std::string& more) {
    return failure_of_text(
        "points: {O: [0, 0, 0], A: [1 m, 0, 0]}\nbodies: {arm: {rod: [O, A], mass: 1 kg}}\njoints: {hinge: {" + joint +
        ", to: arm}}\ngravity: -y\n" + more + "ask: {a: angular_acceleration(arm)}\n");
  };
  const auto says = [](const std::string& failure, const std::string& words) {
    EXPECT_NE(failure.find(words), std::string::npos) << failure;
  };
  says(hinge("revolute: z, at: O, rate: 1 rad/s, accel: 0, friction: 2 N*m", ""), "rate:, accel: and friction");
  says(hinge("weld: O, friction: 2 N*m", ""), "which does not move: it has no friction");
  says(hinge("ball: O, angles: [a: z, b: y, c: x], friction: 2 N*m", ""), "a ball with angles in an order");
  says(hinge("ball: O, friction: {coefficient: 0.2}", ""), "no radius at which it acts");
  says(hinge("ball: O, friction: 2 N", ""), "a force");
  says(hinge("planar: z, at: O, friction: {coefficient: 0.2, radius: 2 mm}", ""), "is a planar and has no radius");
  says(hinge("universal: [x, y], at: O, friction: 2 N*m", ""), "friction is a couple or force in each of its freedoms");
  says(hinge("cylindrical: z, at: O, friction: 2 N*m", ""), "a couple and a force of their own are stated");
  says(hinge(
           "cylindrical: z, at: O, friction: {coefficient: 0.2, radius: 2 mm}, freedoms: {slide: {rate: 0, friction: 2 "
           "N}}",
           ""),
       "friction against all its motion");
  says(hinge("cylindrical: z, at: O, freedoms: {slide: {rate: 0, friction: {coefficient: 0.2}}}", ""),
       "rubs against its whole slip");
  says(hinge("planar: z, at: O, freedoms: {slide1: {rate: 0, friction: 2 N}}", ""), "one of two slides in a plane");
  says(hinge("ball: O, angles: [a: z, b: y, c: x], freedoms: {a: {rate: 0, friction: 2 N*m}}", ""),
       "against its turning about whatever axis");
  says(hinge("revolute: z, at: O, rate: 0, friction: 0.3", ""), "states a pure number as its friction");
  says(hinge("revolute: z, at: O, rate: 0, friction: -2 N*m", ""), "joint 'hinge' has a negative friction");
}

// A body that a couple begins to turn against the couple of its socket, by Euler's equation: I a = C - M a/|a|.
TEST(FrictionInJoints, ABallBeginsToTurnAboutAnyAxis) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> part(-3, 3);
  int moved = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const Vector3<double> C{part(random), part(random), part(random)};
    const SolvedText solved(
        fmt::format("points: {{O: [0, 0, 0]}}\nbodies: {{block: {{box: {{center: O, sides: [[0.5 m, 0, 0], [0, 0.3 m, "
                    "0], [0, 0, 0.2 "
                    "m]]}}, mass: 24 kg}}}}\njoints: {{socket: {{ball: O, to: block, friction: {{static: 2.2 N*m, "
                    "kinetic: 2 N*m}}}}}}\n"
                    "loads: {{turn: {{couple: [{:.17g} N*m, {:.17g} N*m, {:.17g} N*m], body: block}}}}\ngravity: none\n"
                    "instants: {{now: rest}}\nask: {{a: angular_acceleration(block), K: friction(socket on block), s: "
                    "sticking(socket)}}\n",
                    C.x, C.y, C.z));
    const Vector3<double> a = solved.vector("a"), K = solved.vector("K");
    EXPECT_EQ(solved.found("s").value.truth, norm(C) <= 2.2) << norm(C);
    if (norm(C) <= 2.2) {
      EXPECT_NEAR(norm(K + C), 0, 1e-9);
      continue;
    }
    ++moved;
    const Vector3<double> rate{2 * (0.09 + 0.04) * a.x, 2 * (0.25 + 0.04) * a.y, 2 * (0.25 + 0.09) * a.z};
    EXPECT_NEAR(norm(rate - C + (2 / norm(a)) * a), 0, 1e-8);
    EXPECT_NEAR(norm(K + (2 / norm(a)) * a), 0, 1e-8);
  }
  EXPECT_GT(moved, 3);
}

// A rod that whirls on a ball presses it by its weight and by its own motion, and loses what the socket takes.
TEST(FrictionInJoints, ABallRubsByAllThatItCarries) {
  const SolvedText solved(
      "given: {m: 2 kg, L: 0.6 m, mu: 0.3, r: 15 mm, w: [2 rad/s, 1 rad/s, 3 rad/s]}\npoints: {O: [0, 0, 0], A: [L, 0, "
      "0]}\nbodies: {bar: {cylinder: {center: A/2, axis: x, radius: 20 mm, length: L}, mass: m}}\n"
      "joints: {socket: {ball: O, to: bar, friction: {coefficient: mu, radius: r}}}\ngravity: -y\n"
      "facts: {angular_velocity(bar): w}\ndefine: {E: kinetic_energy(bar) + potential_energy(bar)}\n"
      "ask: {K: friction(socket on bar), R: force(socket on bar), w: angular_velocity(bar), P: \"E'\", "
      "later: friction(socket on bar) @ 0.7 s, then: force(socket on bar) @ 0.7 s, turns: angular_velocity(bar) @ 0.7 "
      "s}\n");
  const auto law = [&](const char* friction, const char* force, const char* turning) {
    const Vector3<double> K = solved.vector(friction), w = solved.vector(turning);
    EXPECT_NEAR(norm(K + (0.3 * 0.015 * norm(solved.vector(force)) / norm(w)) * w), 0, 1e-8) << friction;
  };
  law("K", "R", "w");
  law("later", "then", "turns");
  EXPECT_NEAR(solved.number("P"), dot(solved.vector("K"), solved.vector("w")), 1e-9);
}

// What slides in a plane in letters, along a line that the statement names.
TEST(FrictionInJoints, APlateSlidesInLetters) {
  const std::string text =
      "letters: {m: kg, mu: 1, P: N}\npoints: {O: [0, 0, 0]}\nbodies: {plate: {disk: {center: O, normal: y, radius: "
      "0.1 "
      "m}, mass: m}}\njoints: {guide: {planar: y, at: O, to: plate, friction: {coefficient: mu}}}\n"
      "loads: {pull: {force: [P, 0, 0], at: O, body: plate}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {a: acceleration(plate).x, F: friction(guide on plate).x}\n";
  const SolvedStatement solved = solve_statement(read_statement(text, "test.yaml"), {});
  ASSERT_EQ(solved.solutions.size(), 2U);
  for (const Solution& solution : solved.solutions)
    EXPECT_TRUE(solution.asks.front().formula) << solution.notes.front();
}

// Each of several freedoms is held or rubs by itself, whatever the others do.
TEST(FrictionInJoints, OfOneOfSeveralFreedoms) {
  const SolvedText solved(
      "given: {m: 2 kg, F: 12 N, M: 0.03 N*m, w: 30 rad/s, I: 0.002 kg*m^2}\npoints: {O: [0, 0, 0]}\n"
      "bodies: {collar: {mass: m, center: O, inertia: {axis: y, axial: I, transverse: I}}}\n"
      "joints: {post: {cylindrical: y, at: O, to: collar, freedoms: {slide: {displacement: s, rate: 0, friction: 2*F}, "
      "turn: {angle: q, rate: w, friction: M}}}}\ngravity: -y\n"
      "ask: {held: sticking(slide of post), F: friction(slide of post on collar), al: q'', "
      "t: {first_time: sticking(turn of post)}, turned: q @ 10 s, s: s @ 10 s}\n");
  EXPECT_TRUE(solved.ask("held").value.truth);
  EXPECT_NEAR(solved.ask("F").value.vector.y, 2 * 9.80665, 1e-9);
  EXPECT_NEAR(solved.ask("al").value.number, -0.03 / 0.002, 1e-9);
  EXPECT_NEAR(solved.ask("t").value.number, 30 * 0.002 / 0.03, 1e-9);
  EXPECT_NEAR(solved.ask("turned").value.number, 0.002 * 900 / (2 * 0.03), 1e-8);
  EXPECT_NEAR(solved.ask("s").value.number, 0, 1e-12);
}

// A couple that is limited has no impulse: after the blow it brakes, J L/Q long.
TEST(FrictionInJoints, TakesNoPartInABlow) {
  const SolvedText solved(
      "given: {m: 2 kg, L: 1 m, J: 3 N*s, Q: 0.5 N*m}\npoints: {O: [0, 0, 0], P: [0, -L, 0]}\n"
      "bodies: {rod: {rod: [O, P], mass: m}}\njoints: {pin: {revolute: z, at: O, to: rod, angle: th, friction: Q}}\n"
      "impulses: {hit: {body: rod, at: P, value: [J, 0, 0]}}\ngravity: none\ninstants: {before: rest}\n"
      "ask: {w: th', stops: {first_time: sticking(pin)}, th: th @ 100 s}\n");
  EXPECT_NEAR(solved.number("w"), 4.5, 1e-10);
  EXPECT_NEAR(solved.number("stops"), 6, 1e-9);
  EXPECT_NEAR(solved.number("th"), 13.5, 1e-8);
}

// An end is looked for in spans that grow by twice: what happens just where one ends is not missed.
TEST(FrictionInJoints, ChangesAtWholeNumbersOfSeconds) {
  for (const double T : {1.0, 2.0, 3.0, 4.0, 8.0}) {
    const SolvedText solved(fmt::format(
        "given: {{I: 1 kg*m^2, c: 1 N*m/s, Q: {0} N*m, n: {1} rad/s}}\npoints: {{O: [0, 0, 0], P: [1 m, 0, 0]}}\n"
        "bodies: {{driven: {{mass: 1 kg, center: O, inertia: {{axis: z, axial: I, transverse: I}}}}, "
        "coasting: {{mass: 1 kg, center: P, inertia: {{axis: z, axial: I, transverse: I}}}}}}\n"
        "joints: {{axle: {{revolute: z, at: O, to: driven, angle: q, rate: 0, couple: c*time, friction: Q}}, "
        "shaft: {{revolute: z, at: P, to: coasting, angle: p, rate: n, friction: Q}}}}\ngravity: none\n"
        "ask: {{t: {{first_time: sliding(axle)}}, w: \"q' @ {2} s\", s: {{first_time: sticking(shaft)}}, p: p @ 20 "
        "s}}\n",
        T, T * (T + 1), T + 3));
    EXPECT_NEAR(solved.number("t"), T, 1e-9) << T;
    EXPECT_NEAR(solved.number("w"), 4.5, 1e-9) << T;
    EXPECT_NEAR(solved.number("s"), T + 1, 1e-9) << T;
    EXPECT_NEAR(solved.number("p"), T * (T + 1) * (T + 1) / 2, 1e-8) << T;
  }
}

// What is held by all of its friction at the start gives way at once to a load that grows, and holds one that does not.
TEST(FrictionInJoints, AtItsLimitFromTheStart) {
  const auto driven = [](const char* couple) {
    return SolvedText(
        fmt::format("given: {{I: 1 kg*m^2, c: 1 N*m/s, Q: 2 N*m}}\npoints: {{O: [0, 0, 0]}}\n"
                    "bodies: {{wheel: {{mass: 1 kg, center: O, inertia: {{axis: z, axial: I, transverse: I}}}}}}\n"
                    "joints: {{axle: {{revolute: z, at: O, to: wheel, angle: q, rate: 0, couple: {}, friction: "
                    "Q}}}}\ngravity: none\n"
                    "ask: {{w: \"q' @ 3 s\"}}\n",
                    couple));
  };
  EXPECT_NEAR(driven("Q + c*time").number("w"), 4.5, 1e-9);
  EXPECT_NEAR(driven("-Q - c*time").number("w"), -4.5, 1e-9);
  EXPECT_NEAR(driven("Q - c*time/2").number("w"), 0, 1e-12);
  EXPECT_NEAR(driven("Q + 0*c*time").number("w"), 0, 1e-12);
}

}  // namespace friction_in_joints_test
}  // namespace poinsot::problem
