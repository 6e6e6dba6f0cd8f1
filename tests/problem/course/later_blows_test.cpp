// Blows at rough contacts and blows that come later, as problems state them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace later_blows_test {

const std::string ball =
    "title: t\npoints: {C: [0, 1 m, 0], G: [0, 1.1 m, 0], O: [0, 0, 0]}\n"
    "bodies: {ball: {sphere: {center: G, radius: 0.1 m}, mass: 2 kg}}\ngravity: -y\n";
constexpr double g = 9.80665;
const double fall = std::sqrt(2 / g);

std::string bounces(const std::string& contact, const std::string& rest) {
  return ball + "contacts: {floor: {of: ball, at: C, normal: y, open: true, surface: O" + contact + "}}\n" + rest;
}

TEST(LaterBlows, BounceWithTheRestitutionUntilTheyEnd) {
  for (const double e : {0.3, 0.6, 0.9}) {
    const SolvedText solved(bounces(", restitution: " + std::to_string(e),
                                    "instants: {start: rest}\nask: {end: end_of_bouncing(floor), "
                                    "v: velocity(ball).y @ 0.5 s, stays: position(ball).y @ 20 s}\n"));
    EXPECT_NEAR(solved.number("end"), fall * (1 + e) / (1 - e), 1e-8) << e;
    EXPECT_NEAR(solved.number("stays"), 0.1, 1e-9);
    EXPECT_NEAR(solved.number("v"), e * g * fall - g * (0.5 - fall), 1e-9);
  }
}

// Down a smooth slope the motion across it is that on a floor with g cos b, and along it a fall with g sin b. Late
// flights are next to nothing beside the way down: the contact is held before they drown in its rounding.
TEST(LaterBlows, DownASlopeEndAsOnAFloor) {
  for (const double e : {0.7, 0.8, 0.85, 0.9, 0.95})
    for (const double degrees : {5, 30, 60, 80}) {
      const double b = degrees * std::numbers::pi / 180, end = fall * (1 + e) / (1 - e);
      const SolvedText solved("title: t\nplane: [x, y]\ngiven: {b: " + std::to_string(degrees) +
                              " deg}\npoints: {C: [0, 1 m], O: [0, 0]}\ndirections: {out: [sin(b), cos(b)]}\n"
                              "bodies: {ball: {particle: C, mass: 1 kg}}\ngravity: -y\n"
                              "contacts: {slope: {of: ball, at: C, normal: out, open: true, surface: O, restitution: " +
                              std::to_string(e) +
                              "}}\ninstants: {start: rest}\n"
                              "ask: {end: end_of_bouncing(slope), x: position(ball).x @ 20 s}\n");
      EXPECT_NEAR(solved.number("end"), end, 1e-7 * end) << e << ", " << degrees;
      const double x = (g * std::sin(b) * 200 - std::sin(b)) * std::cos(b);
      EXPECT_NEAR(solved.number("x"), x, 1e-8 * x) << e << ", " << degrees;
    }
}

// At the instant of a blow what was just before it is told, whatever way the time of the blow is rounded.
TEST(LaterBlows, AreNotOverAtTheirInstant) {
  for (int n = 1; n <= 24; ++n) {
    const std::string T = std::to_string(n) + "/2 s";
    const SolvedText solved("title: t\ngiven: {T: " + T + ", T2: T + 1 us" +
                            "}\npoints: {C: [0, g*T^2/2, 0], O: [0, 0, 0]}\nbodies: {ball: {particle: C, mass: 2 kg}}\n"
                            "gravity: -y\ncontacts: {floor: {of: ball, at: C, normal: y, open: true, surface: O, "
                            "restitution: 0.8}}\ninstants: {start: rest}\n"
                            "ask: {before: velocity(ball).y @ T, after: velocity(ball).y @ T2}\n");
    EXPECT_NEAR(solved.number("before"), -g * n / 2, 1e-9 * n) << T;
    EXPECT_NEAR(solved.number("after"), 0.8 * g * n / 2 - g * 1e-6, 1e-9 * n) << T;
  }
}

// A pendulum comes back to a stop at its lowest place after half a swing, however weak the blow: the blows never end,
// but all that is far out lies at the beginning.
TEST(LaterBlows, OnAPendulumAtItsLowestPlaceNeverEnd) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0], A: [0, -1 m, 0]}\nbodies: {bar: {rod: [O, A], mass: 2 kg}}\n"
      "joints: {pin: {revolute: z, at: O, to: bar, angle: q}}\n"
      "contacts: {stop: {of: bar, corner: A, normal: x, open: true, restitution: 0.5}}\ngravity: -y\n"
      "instants: {start: {q: 40 deg, q': 0}}\n"
      "ask: {end: end_of_bouncing(stop), most: max(q), fastest: min(q'), back: max(q')}\n");
  EXPECT_NE(solved.reason("end").find("bouncing on 'stop' has not ended"), std::string::npos) << solved.reason("end");
  const double angle = 40 * std::numbers::pi / 180, speed = std::sqrt(3 * g * (1 - std::cos(angle)));
  EXPECT_NEAR(solved.number("most"), angle, 1e-9);
  EXPECT_NEAR(solved.number("fastest"), -speed, 1e-8);
  EXPECT_NEAR(solved.number("back"), speed / 2, 1e-8);
}

// A bob on a string of no mass reaches the wall just at its lowest place, where nothing pushes it back to it: it comes
// back by itself all the same, and is followed until nothing is to be seen of it.
TEST(LaterBlows, AtALowestPlaceEndWhereNothingIsToBeSeen) {
  const SolvedText solved(
      "title: t\nplane: [x, y]\npoints: {O: [0, 0], P: [0, -1 m]}\nbodies: {bob: {particle: P, mass: 1 kg}}\n"
      "joints: {pin: {revolute: z, at: O, to: bob, angle: q}}\n"
      "contacts: {wall: {of: bob, at: P, normal: x, open: true, restitution: 0.6}}\ngravity: -y\n"
      "instants: {start: {q: 40 deg, q': 0}}\nask: {most: max(q), late: q @ 100 s}\n");
  EXPECT_NEAR(solved.number("most"), 40 * std::numbers::pi / 180, 1e-9);
  EXPECT_NEAR(solved.number("late"), 0, 1e-7);
}

// What leaves next to nothing slowly still leaves where nothing presses it back.
TEST(LaterBlows, LeaveWhatNothingPressesBackFlying) {
  const std::string ball =
      "title: t\npoints: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: 1 kg}}\ngravity: none\n"
      "instants: {start: {velocity(b): [1 m/s, 0, 0]}}\n";
  const SolvedText one(
      ball +
      "contacts: {w: {of: b, at: O, surface: [1 m, 0, 0], normal: -x, open: true, restitution: 1e-9}}\n"
      "ask: {x: position(b).x @ 1e6 s, v: velocity(b).x @ 3 s}\n");
  EXPECT_NEAR(one.number("x"), 1 - 1e-9 * (1e6 - 1), 1e-12);
  EXPECT_NEAR(one.number("v"), -1e-9, 1e-18);
  // Between two walls it takes twice as long each time: from one to the other 2^k s after the k-th blow.
  const SolvedText two(
      ball +
      "contacts:\n  w: {of: b, at: O, surface: [1 m, 0, 0], normal: -x, open: true, restitution: 0.5}\n"
      "  o: {of: b, at: O, surface: [0, 0, 0], normal: x, open: true, restitution: 0.5}\n"
      "ask: {v: velocity(b).x @ 1000 s}\n");
  EXPECT_NEAR(two.number("v"), -std::ldexp(1, -9), 1e-12);
}

// With friction: 0 what a blow presses is smooth, whether it slides or rests, as it is without the key.
TEST(LaterBlows, PressWhatHasNoFriction) {
  for (const std::string friction : {"", ", friction: 0"}) {
    const SolvedText crate(
        "title: t\nplane: [x, y]\ngiven: {s: 0.4 m, v: 2.2 m/s}\n"
        "points: {A: [0, 0], B: [-s, 0], G: [-s/2, s/2]}\n"
        "bodies: {cube: {rectangle: {center: G, sides: [[s, 0], [0, s]]}, mass: 5 kg}}\n"
        "contacts: {front: {of: cube, corner: A, normal: y" +
        friction + "}, rear: {of: cube, corner: B, normal: y" + friction +
        "}, curb: {of: cube, corner: A, normal: -x, open: true, surface: '[1 m, 0]'}}\ngravity: -y\n"
        "instants: {start: {velocity(cube): [v, 0], angular_velocity(cube): 0}}\n"
        "ask: {w: angular_velocity(cube) @ 0.454546 s}\n");
    EXPECT_NEAR(crate.found("w").value.number, -3 * 2.2 / (4 * 0.4), 2e-4) << friction;
    const SolvedText block(
        "title: t\nplane: [x, y]\n"
        "points: {O: [0, 0], P: [-1 m, 1 m], B: [0, -0.1 m], S: '[-0.1 m/sqrt(2), 0.1 m/sqrt(2)]'}\n"
        "directions: {n: [-1, 1]}\n"
        "bodies: {ball: {particle: P, mass: 1 kg}, block: {disk: {center: O, normal: z, radius: 0.1 m}, mass: 1 kg}}\n"
        "contacts: {floor: {of: block, at: B, normal: y" +
        friction +
        "}, hit: {of: ball, against: block, at: P, normal: n, surface: S, open: true, restitution: 0}}\n"
        "loads: {down: {force: [0, -1 N], at: O, body: block}}\ngravity: none\n"
        "instants: {start: {velocity(ball): [1 m/s, -1 m/s], velocity(block): 0, angular_velocity(block): 0}}\n"
        "ask: {v: velocity(block).x @ 1 s}\n");
    EXPECT_NEAR(block.number("v"), 2.0 / 3, 1e-9) << friction;
  }
}

TEST(LaterBlows, ExtremesOfWhatComesToRest) {
  const SolvedText solved(bounces(", restitution: 0.6",
                                  "instants: {start: rest}\nask: {top: max(center(ball).y), low: min(center(ball).y), "
                                  "up: max(velocity(ball).y), down: min(velocity(ball).y)}\n"));
  EXPECT_NEAR(solved.number("top"), 1.1, 1e-9);
  EXPECT_NEAR(solved.number("low"), 0.1, 1e-9);
  EXPECT_NEAR(solved.number("down"), -g * fall, 1e-7);
  EXPECT_NEAR(solved.number("up"), 0.6 * g * fall, 1e-7);
}

TEST(LaterBlows, WithoutRestitutionTheyHold) {
  const SolvedText solved(
      bounces("", "instants: {start: rest}\nask: {y: position(ball).y @ 2 s, F: force(floor on ball).y @ 2 s}\n"));
  EXPECT_NEAR(solved.number("y"), 0.1, 1e-10);
  EXPECT_NEAR(solved.number("F"), 2 * g, 1e-8);
}

TEST(LaterBlows, ElasticOnesKeepTheEnergy) {
  const SolvedText solved(bounces(", restitution: 1",
                                  "instants: {start: rest}\nask: {T: kinetic_energy(ball) @ 7.3 s, y: position(ball).y "
                                  "@ 7.3 s, y2: position(ball).y @ " +
                                      std::to_string(4 * fall) + " s}\n"));
  EXPECT_NEAR(solved.number("T") + 2 * g * (solved.number("y") - 1.1), 0, 1e-8);
  EXPECT_NEAR(solved.number("y2"), 1.1, 1e-6);
}

TEST(LaterBlows, RefuseWhatIsNotOpen) {
  const std::string start = "instants: {start: rest}\nask: {y: position(ball).y @ 2 s}\n";
  const auto words = [&](const std::string& text) { return failure_of([&] { SolvedText solved(text); }); };
  const std::string lower =
      "title: t\npoints: {C: [0, 1 m, 0], G: [0, 1.1 m, 0], O: [0, 1.5 m, 0]}\n" + ball.substr(ball.find("bodies"));
  EXPECT_NE(words(lower + "contacts: {floor: {of: ball, at: C, normal: y, open: true, surface: O}}\n" + start)
                .find("overlap there"),
            std::string::npos);
  EXPECT_NE(
      words(ball + "contacts: {floor: {of: ball, at: C, normal: y, open: true}}\n" + start).find("pressed together"),
      std::string::npos);
  EXPECT_NE(words(bounces(", restitution: 1.2", start)).find("between 0 and 1"), std::string::npos);
  EXPECT_NE(
      words(ball + "contacts: {floor: {of: ball, at: C, normal: y, surface: O}}\n" + start).find("write open: true"),
      std::string::npos);
  EXPECT_NE(words(bounces(", restitution: 0.5, no_slip: true", start)).find("state friction"), std::string::npos);
}

// Both ends of a level rod meet the floor at once: Newton's law at both lets it rebound level, as a ball would.
TEST(LaterBlows, AtOnceAreTakenTogether) {
  const std::string rod =
      "title: t\npoints: {A: [-1 m, 1 m, 0], B: [1 m, 1 m, 0], O: [0, 0, 0]}\n"
      "bodies: {rod: {rod: [A, B], mass: 2 kg}}\ngravity: -y\ninstants: {start: rest}\n";
  const auto with = [&](const std::string& e) {
    return rod + "contacts: {a: {of: rod, at: A, normal: y, open: true, surface: O, restitution: " + e +
           "}, b: {of: rod, at: B, normal: y, open: true, surface: O, restitution: " + e +
           "}}\nask: {y: position(rod).y @ 2 s, top: position(rod).y @ 0.7 s, w: angular_velocity(rod).z @ 0.7 s}\n";
  };
  const SolvedText plastic(with("0"));
  EXPECT_NEAR(plastic.number("y"), 0, 1e-9);
  const SolvedText bounces(with("0.5"));
  const double falls = std::sqrt(2 / g), later = 0.7 - falls;
  EXPECT_NEAR(bounces.number("top"), 0.5 * g * falls * later - g * later * later / 2, 1e-9);
  EXPECT_NEAR(bounces.number("w"), 0, 1e-9);
  EXPECT_NEAR(bounces.number("y"), 0, 1e-9);
  EXPECT_EQ(std::ranges::count_if(
                bounces.notes(),
                [](const std::string& note) { return note.find("have them together") != std::string::npos; }),
            1);
  EXPECT_NE(SolvedText(with("0.5, friction: 0.2")).reason("y").find("at the same time"), std::string::npos);
}

// Where the order makes no difference nothing is assumed, with friction neither: two blocks that are struck apart.
TEST(LaterBlows, AtOnceButApartNeedNoRule) {
  const SolvedText solved(
      "title: t\ngiven: {u: 2 m/s, w: 3 m/s}\npoints: {G: [-0.4 m, 0.6 m, 0], O: [0, 0, 0], C: [3 m, 0.6 m, 0]}\n"
      "bodies: {ball: {particle: G, mass: 2 kg}, other: {particle: C, mass: 1 kg}}\ngravity: none\n"
      "contacts: {floor: {of: ball, at: G, normal: y, open: true, surface: O, restitution: 0.8}, "
      "wall: {of: ball, at: G, normal: -x, open: true, surface: O, restitution: 0.5}, "
      "under: {of: other, at: C, normal: y, open: true, surface: O, restitution: 0.3, friction: 0.1}}\n"
      "instants: {start: {velocity(ball): [u, -w, 0], velocity(other): [u, -w, 0]}}\n"
      "ask: {v: velocity(ball) @ 0.5 s, w: velocity(other) @ 0.5 s}\n");
  EXPECT_NEAR(solved.vector("v").x, -1, 1e-12);
  EXPECT_NEAR(solved.vector("v").y, 2.4, 1e-12);
  EXPECT_NEAR(solved.vector("w").x, 2 - 0.1 * 1.3 * 3, 1e-12);
  EXPECT_NEAR(solved.vector("w").y, 0.9, 1e-12);
  for (const std::string& note : solved.notes()) EXPECT_EQ(note.find("have them together"), std::string::npos) << note;
}

// Between walls at an angle the ball's whole velocity is turned round; with unlike restitutions each normal's part is.
TEST(LaterBlows, InAGrooveEachSideHasItsRestitution) {
  const double b = 0.6, v = std::sqrt(2 * g * 0.7);
  const auto after = [&](const std::string& left, const std::string& right) {
    return SolvedText(
               "title: t\ngiven: {b: 0.6 rad, r: 0.05 m, h: 0.7 m}\npoints: {G: [0, h + r/cos(b), 0], P: G - r*left, "
               "Q: G - r*right, O: [0, 0, 0]}\ndirections: {left: [sin(b), cos(b), 0], right: [-sin(b), cos(b), 0]}\n"
               "bodies: {ball: {sphere: {center: G, radius: r}, mass: 1 kg}}\ngravity: -y\ninstants: {start: rest}\n"
               "contacts: {a: {of: ball, at: P, normal: left, open: true, surface: O, restitution: " +
               left + "}, b: {of: ball, at: Q, normal: right, open: true, surface: O, restitution: " + right +
               "}}\nask: {v: velocity(ball) @ 0.3779 s, t: {first_time: touching(a)}}\n")
        .vector("v");
  };
  const double since = 0.3779 - v / g;
  const Vector3<double> same = after("0.75", "0.75"), unlike = after("0.9", "0.4");
  EXPECT_NEAR(same.x, 0, 1e-9);
  EXPECT_NEAR(same.y, 0.75 * v - g * since, 1e-8);
  // n . v' = e v cos b with each normal.
  EXPECT_NEAR(unlike.x, (0.9 - 0.4) * v * std::cos(b) / (2 * std::sin(b)), 1e-8);
  EXPECT_NEAR(unlike.y, (0.9 + 0.4) * v / 2 - g * since, 1e-8);
}

TEST(RoughBlows, OfASpinningBallAgreeWithClosedForms) {
  const std::string thrown =
      "title: t\npoints: {C: [0, 0, 0], G: [0, 0.1 m, 0]}\nbodies: {ball: {sphere: {center: G, radius: 0.1 m}, mass: 2 "
      "kg}}\n"
      "gravity: none\ninstants: {before: {velocity(ball): [3 m/s, -2 m/s, 0], angular_velocity(ball): [0, 0, 10 "
      "rad/s]}}\n"
      "ask: {v: velocity(ball), w: angular_velocity(ball).z, J: impulse(floor on ball)}\n";
  const auto with = [&](const std::string& mu) {
    return thrown + "impacts: {floor: {of: ball, at: C, pushes: y, restitution: 0.5, friction: " + mu + "}}\n";
  };
  const SolvedText slides(with("0.2"));
  EXPECT_NEAR(slides.vector("v").x, 3 - 0.2 * 3, 1e-12);
  EXPECT_NEAR(slides.vector("v").y, 1, 1e-12);
  EXPECT_NEAR(slides.vector("J").x, -0.2 * 6, 1e-12);
  const SolvedText grips(with("0.9"));
  EXPECT_NEAR(grips.vector("v").x, (5 * 3 - 2 * 0.1 * 10) / 7, 1e-12);
  EXPECT_NEAR(grips.number("w"), -grips.vector("v").x / 0.1, 1e-11);
  const auto refused = failure_of([&] { SolvedText solved(with("m")); });
  EXPECT_FALSE(refused.empty());
}

// In letters the ball's velocity after the blow is a formula while the floor's friction lasts to the end of the slip or
// not, and says what must hold for it.
TEST(RoughBlows, InLettersAreToldWhereTheySlipToTheEndOrTheBallGrips) {
  const SolvedText solved(
      "title: t\nletters: {m: kg, r: m, v: m/s, u: m/s, w: rad/s, e: '1', mu: '1', k: '1'}\n"
      "assume: [2*(v + r*w) > 7*mu*(1 + e)*u, 2*(v + r*w) < 7*k*(1 + e)*u]\n"
      "points: {C: [0, 0, 0], G: [0, r, 0]}\nbodies: {ball: {sphere: {center: G, radius: r}, mass: m}}\n"
      "gravity: none\ninstants: {before: {velocity(ball): [v, -u, 0], angular_velocity(ball): [0, 0, w]}}\n"
      "situations:\n  slips: {impacts: {floor: {of: ball, at: C, pushes: y, restitution: e, friction: mu}}}\n"
      "  grips: {impacts: {floor: {of: ball, at: C, pushes: y, restitution: e, friction: k}}}\n"
      "ask: {slips: velocity(ball).x @ slips, grips: velocity(ball).x @ grips, spin: angular_velocity(ball).z @ slips, "
      "J: impulse(floor on ball).x @ grips}\n");
  const auto at = [&](const char* name) {
    const SolvedAsk& ask = solved.ask(name);
    EXPECT_TRUE(ask.formula) << name << ": " << ask.no_formula;
    return ask.formula
               ? value_at(
                     ask.formula->number,
                     {{"m", 0.6}, {"r", 0.1}, {"v", 3.0}, {"u", 2.0}, {"w", 8.0}, {"e", 0.6}, {"mu", 0.1}, {"k", 0.8}})
               : NAN;
  };
  EXPECT_NEAR(at("slips"), 3 - 0.1 * 1.6 * 2, 1e-12);
  EXPECT_NEAR(at("grips"), (5 * 3 - 2 * 0.1 * 8) / 7, 1e-12);
  EXPECT_NEAR(at("spin"), 8 - 5 * 0.1 * 1.6 * 2 / (2 * 0.1), 1e-12);
  EXPECT_NEAR(at("J"), 0.6 * ((5 * 3 - 2 * 0.1 * 8) / 7.0 - 3), 1e-12);
}

// A pin lets the point that is struck move along the push alone: no friction arises across it.
TEST(RoughBlows, OfADoorOnItsPinHaveNoFriction) {
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0], B: [0, -0.9 m, 0], S: [0, -0.6 m, 0]}\n"
      "bodies: {door: {rod: [O, B], mass: 3 kg}}\njoints: {pin: {revolute: z, at: O, to: door}}\n"
      "impacts: {stop: {of: door, at: S, pushes: -x, restitution: 0.7, friction: 0.3}}\ngravity: none\n"
      "instants: {before: {angular_velocity(door): [0, 0, 4 rad/s]}}\n"
      "ask: {w: norm(velocity(B of door)), J: impulse(stop on door), P: norm(impulse(pin on door))}\n");
  EXPECT_NEAR(solved.number("w"), 0.9 * 0.7 * 4, 1e-10);
  EXPECT_NEAR(solved.vector("J").x, -3 * 0.9 * 0.9 / 3 * 1.7 * 4 / 0.6, 1e-9);
  EXPECT_NEAR(solved.vector("J").y, 0, 1e-12);
  EXPECT_NEAR(solved.number("P"), 0, 1e-9);  // at two thirds of the length, the center of percussion
}

TEST(RoughBlows, FindTheFrictionFromWhatIsStated) {
  const SolvedText solved(
      "title: t\npoints: {C: [0, 0, 0], G: [0, 0.1 m, 0]}\nbodies: {ball: {sphere: {center: G, radius: 0.1 m}, mass: 2 "
      "kg}}\n"
      "gravity: none\nfind: {mu: '1'}\nimpacts: {floor: {of: ball, at: C, pushes: y, restitution: 0.5, friction: mu}}\n"
      "instants: {before: {velocity(ball): [3 m/s, -2 m/s, 0], angular_velocity(ball): [0, 0, 0]}, after: "
      "{velocity(ball).x: 2.4 m/s}}\n"
      "ask: {mu: mu}\n");
  EXPECT_NEAR(solved.number("mu"), 0.2, 1e-9);
}

TEST(RoughBlows, AreRefusedBesideOthers) {
  const std::string two =
      "title: t\npoints: {A: [0, 0, 0], B: [1 m, 0, 0]}\nbodies: {rod: {rod: [A, B], mass: 2 kg}}\ngravity: none\n"
      "instants: {before: {velocity(rod): [0, -1 m/s, 0], angular_velocity(rod): [0, 0, 0]}}\nask: {v: "
      "velocity(rod)}\n";
  const auto words = [&](const std::string& impacts) { return failure_of([&] { SolvedText solved(two + impacts); }); };
  EXPECT_NE(words("impacts: {a: {of: rod, at: A, pushes: y, friction: 0.2}, b: {of: rod, at: B, pushes: y}}\n")
                .find("it matters which is first"),
            std::string::npos);
  EXPECT_NE(words("letters: {mu: '1'}\nimpacts: {a: {of: rod, at: A, pushes: y, friction: mu}}\nclaim: {c: mu > 0}\n")
                .find("claims are not decided"),
            std::string::npos);
  EXPECT_NE(
      words("impacts: {a: {of: rod, at: A, pushes: y, friction: 0.2, hypothesis: newton}}\n").find("no restitution"),
      std::string::npos);
  EXPECT_NE(words("impacts: {a: {of: rod, at: A, pushes: y, friction: -0.2}}\n").find("is negative"),
            std::string::npos);
  EXPECT_NE(words("impacts: {a: {of: rod, at: A, pushes: y, friction: 0.2, restitution: 0.5, hypothesis: hertz}}\n")
                .find("no hypothesis"),
            std::string::npos);
}

}  // namespace later_blows_test
}  // namespace poinsot::problem
