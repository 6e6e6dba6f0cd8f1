// The ends of the values of a datum for which something holds: what ends there.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problem/course/motion_support.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace extremum_test {

constexpr double g = 9.81;

// A sleeping top: I^2 s^2 > 4 J m g c, and moments about its center that a body may have: 2 (J - m c^2) > I.
std::string sleeping_top(double s, const std::string& ask) {
  return "title: t\ngiven: {I: 0.0006 kg*m^2, J: 0.0021 kg*m^2, m: 0.4 kg, c: 2 mm, s: " + std::to_string(s) +
         " rad/s}\npoints: {O: [0, 0, 0], G: [0, 0, c]}\n"
         "bodies: {top: {mass: m, center: G, inertia: {about: O, axis: z, axial: I, transverse: J}}}\n"
         "joints: {tip: {ball: O, to: top}}\ngravity: [0, 0, -9.81 m/s^2]\n"
         "instants: {now: {angular_velocity(top): [0, 0, s]}}\nask: {end: {" +
         ask + ", while: stable(top)}}\n";
}

bool notes(const SolvedText& solved, const std::string& begin) {
  for (const std::string& note : solved.notes())
    if (note.starts_with(begin)) return true;
  return false;
}

// A wedge in space, where the cones of friction are round in many directions that contacts share. All its contacts
// stick up to P = W (tan(a + f) + tan f)/(1 - tan f tan(a + f)) = 1763.14 N, f = atan mu.
TEST(Extremum, AWedgeInSpaceIsDrivenByAsMuchAsInItsPlane) {
  const auto sticks = [](const std::string& push) {
    const SolvedText solved(
        "title: t\ngiven: {W: 2 kN, a: 8 deg, mu: 0.3, P: " + push +
        ", h: 0.4 m}\n"
        "points: {A: [0, h, 0], B: [1 m, 'h - (1 m)*tan(a)', 0], D: [1 m, 1 m, 0], E: [0, 1 m, 0], F: [0, 0, 0],"
        " K: [1 m, 0, 0]}\ndirections: {n: [sin(a), cos(a), 0]}\n"
        "bodies: {block: {polygon: [A, B, D, E], mass: 1 kg}, wedge: {polygon: [A, F, K, B], mass: 1 kg}}\n"
        "contacts: {upper: {of: block, corner: D, normal: -x, friction: mu},"
        " left: {of: block, corner: A, against: wedge, normal: n, friction: mu},"
        " right: {of: block, corner: B, against: wedge, normal: n, friction: mu},"
        " heel: {of: wedge, corner: F, normal: y, friction: mu}, toe: {of: wedge, corner: K, normal: y, friction: "
        "mu}}\n"
        "joints: {one: {planar: z, at: A, to: block}, other: {planar: z, at: A, to: wedge}}\n"
        "loads: {weight: {force: [0, -W, 0], at: [0.5 m, 0.7 m, 0], body: block},"
        " push: {force: [P, 0, 0], at: [0, h/2, 0], body: wedge}}\ngravity: none\ninstants: {now: rest}\n"
        "ask: {s: sticking(toe)}\n");
    return solved.found("s").value.truth;
  };
  EXPECT_TRUE(sticks("1763.1 N"));
  EXPECT_FALSE(sticks("1763.2 N"));
}

TEST(Extremum, WhereStabilityEndsNothingElseIsTold) {
  const SolvedText solved(sleeping_top(20, "largest: c"));
  const double expected = 0.0006 * 0.0006 * 400 / (4 * 0.0021 * 0.4 * g);
  EXPECT_NEAR(solved.number("end"), expected, 1e-10 * expected);
  EXPECT_FALSE(notes(solved, "end:"));
}

// A rod on a turning shaft pulls a level cord while cos(b) > 3 g/(2 L w^2), and again above the level of its pin.
TEST(Extremum, AGapBeforeTheEndIsTold) {
  const double L = 0.6, w = 12;
  const SolvedText solved(
      "title: t\ngiven: {L: 0.6 m, b: 35 deg, w: 12 rad/s}\n"
      "points: {A: [0, 0, 0], B: '[0, L*sin(b), -L*cos(b)]', C: '[0, 0, -L*cos(b)]'}\n"
      "bodies: {shaft: massless, rod: {rod: [A, B], mass: 2 kg}}\n"
      "joints: {s: {revolute: z, at: A, to: shaft, rate: w, accel: 0}, "
      "pin: {revolute: x, at: A, from: shaft, to: rod, rate: 0}}\n"
      "cords: {cord: {from: shaft, at: C, to: rod, end: B}}\ngravity: [0, 0, -9.81 m/s^2]\n"
      "ask: {end: {largest: b, while: taut(cord)}}\n");
  EXPECT_NEAR(solved.number("end"), M_PI, 1e-6);
  EXPECT_TRUE(notes(solved, "end: it holds at 180 deg"));
  const std::string nearer = with_digits(std::acos(3 * g / (2 * L * w * w)) * 180 / M_PI, 8) + " deg";
  bool told = false;
  for (const std::string& note : solved.notes()) told = told || note.find("holds up to " + nearer) != std::string::npos;
  EXPECT_TRUE(told) << nearer;
}

// The least spin lies beyond a thousand of the unit that its letter was given.
TEST(Extremum, AnEndFarFromTheUnitIsFound) {
  const double h = 0.1021, r = 0.05024, gravity = 980.665;
  const SolvedText solved(
      "title: t\ngiven: {m: 0.4337 kg, h: 102.1 mm, r: 50.24 mm, g: 980.665 m/s^2}\nletters: {S: rad/s}\n"
      "points: {O: [0, 0, 0], T: [0, 0, h]}\nbodies: {top: {cone: {apex: O, base: T, radius: r}, mass: m}}\n"
      "joints: {tip: {ball: O, to: top}}\n"
      "steady: {frame: ground, spins: {top: {about: 'O->T', rate: S}}}\ngravity: -z\n"
      "ask: {slowest: {smallest: S, while: stable(top)}}\n");
  const double across = 0.6 * (r * r / 4 + h * h), along = 0.3 * r * r;
  const double expected = std::sqrt(4 * gravity * 0.75 * h * across) / along;
  EXPECT_NEAR(solved.number("slowest"), expected, 1e-10 * expected);
}

TEST(Extremum, WhereNoBodyHasSuchMomentsThatIsTold) {
  const SolvedText solved(sleeping_top(80, "largest: c"));
  const double expected = std::sqrt((0.0021 - 0.0003) / 0.4);
  EXPECT_NEAR(solved.number("end"), expected, 1e-6 * expected);
  EXPECT_TRUE(notes(solved, "end: what is stated ends at 67.08")) << solved.notes().size();
}

// A truck in a curve on contacts that carry no force to the side: at any speed that is impossible, and near zero by
// less than rounding.
TEST(Extremum, WhatIsStatedForRestAloneHasNoLargestSpeed) {
  const SolvedText solved(
      "title: t\nletters: {v: m/s}\n"
      "points: {G: [60 m, 1.6 m, 0], A: [59.1 m, 0, 0], B: [60.9 m, 0, 0]}\n"
      "frames: {curve: {turns: y, rate: 'v/(60 m)'}}\n"
      "bodies: {truck: {mass: 4 t, center: G, inertia: {x: 9 t*m^2, y: 9 t*m^2, z: 2 t*m^2}}}\n"
      "contacts: {inner: {of: truck, corner: A, normal: y}, outer: {of: truck, corner: B, normal: y}}\n"
      "steady: {frame: curve}\ngravity: -y\nask: {end: {largest: v, while: touching(inner), unit: km/h}}\n");
  EXPECT_TRUE(solved.reason("end").find("these cannot all hold together: forces on truck along x") != std::string::npos)
      << solved.reason("end");
}

TEST(Extremum, WhatMayBeAsSmallAsOneLikesHasNoLeastValue) {
  const SolvedText solved(sleeping_top(80, "smallest: m"));
  EXPECT_TRUE(solved.reason("end").starts_with("there is no smallest value")) << solved.reason("end");
}

// Ends of stability where two rates meet, against closed forms: at zero or at a frequency, beside rates that vanish
// because the whole may be displaced, and with damping, where rates cross the imaginary axis by themselves.
struct KnownEnd {
  std::string text;
  double end;
};

void expect_end(const KnownEnd& known) {
  const SolvedText solved(known.text);
  EXPECT_NEAR(solved.number("end"), known.end, 1e-10 * known.end) << known.text;
  EXPECT_FALSE(notes(solved, "end:")) << known.text;
}

TEST(Extremum, EndsOfStabilityAreKnownToTenDigits) {
  // I^2 s^2 = 4 J m g c with the moments of sleeping_top about its tip.
  expect_end({sleeping_top(20, "smallest: s"), std::sqrt(4 * 0.0021 * 0.4 * g * 0.002) / 0.0006});
  // A plate on a turning clevis: w^2 = 3 g/(2 h).
  const double h = 0.24;
  expect_end(
      {"title: t\ngiven: {w: 2 rad/s}\ngravity: [0, -9.81 m/s^2, 0]\npoints: {O: [0, 0, 0], P: [0, -0.12 m, 0]}\n"
       "bodies: {clevis: massless, plate: {rectangle: {center: P, sides: [[0, 0, 0.1 m], [0, 0.24 m, 0]]}, mass: "
       "any}}\njoints:\n  shaft: {revolute: y, at: O, to: clevis, rate: w, accel: 0}\n"
       "  hinge: {revolute: z, at: O, from: clevis, to: plate}\nsteady: {frame: clevis}\n"
       "ask: {end: {largest: w, while: stable(plate)}}\n",
       std::sqrt(3 * g / (2 * h))});
}

// Disks and hoops on a floor, with moments k m r^2 across the axis and twice that about it: rolling straight on,
// s^2 = g/(2 r (1 + 2 k)), and spinning on the spot about the upright diameter, p^2 = g/(r (1 + k)) (E. J. Routh, The
// Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, chapter V).
TEST(Extremum, RollingAndSpinningDisksAndHoops) {
  const double r = 0.3;
  const auto text = [](const std::string& shape, const std::string& turn, const std::string& roll) {
    return "title: t\ngiven: {s: 20 rad/s}\ngravity: [0, -9.81 m/s^2, 0]\npoints: {C: [0, 0, 0], G: [0, 0.3 m, 0]}\n"
           "bodies: {disk: {" +
           shape +
           ": {center: G, normal: z, radius: 0.3 m}, mass: 2 kg}}\n"
           "contacts: {floor: {of: disk, at: C, normal: y, no_slip: true}}\n"
           "frames: {figure: {rides_on: center(disk), turns: y, rate: " +
           turn + "}}\nsteady: {frame: figure, spins: {disk: {about: z, rate: " + roll +
           "}}}\nask: {end: {smallest: s, while: stable(disk)}}\n";
  };
  expect_end({text("disk", "0 rad/s", "s"), std::sqrt(g / (3 * r))});
  expect_end({text("ring", "0 rad/s", "s"), std::sqrt(g / (4 * r))});
  expect_end({text("disk", "s", "0 rad/s"), std::sqrt(4 * g / (5 * r))});
  expect_end({text("ring", "s", "0 rad/s"), std::sqrt(2 * g / (3 * r))});
}

// A crate on a drum is stable while its mass center is less than a radius above the top: h/2 < R. With R = 0.5 m that
// is one of the values that are tried, at which the linearised equations do not decide.
TEST(Extremum, StabilityMayEndAtAValueThatIsTried) {
  for (const double R : {0.5, 0.05, 5.0, 0.37}) {
    const SolvedText solved("title: t\ngiven: {R: " + std::to_string(R) +
                            " m, m: 3 kg}\nletters: {h: m}\n"
                            "points: {O: [0, 0, 0], T: [0, R, 0], G: [0, R + h/2, 0]}\nbodies:\n"
                            "  drum: {cylinder: {center: O, axis: z, radius: R, length: 2 m}, mass: 0 kg}\n"
                            "  crate: {box: {center: G, sides: [2 m * x, h*y, 1 m * z]}, mass: m}\n"
                            "joints: {stand: {weld: O, to: drum}, keep: {planar: z, at: G, to: crate}}\n"
                            "contacts: {top: {of: crate, against: drum, at: T, normal: y, no_slip: true}}\n"
                            "gravity: -y\ninstants: {now: rest}\nask: {most: {largest: h, while: stable(crate)}}\n");
    EXPECT_NEAR(solved.number("most"), 2 * R, 1e-10 * R) << R;
  }
}

// A faster top stays upright: that its rates become too unlike to be told apart is no end.
TEST(Extremum, WhatRoundingHidesIsNoEnd) {
  const SolvedText solved(sleeping_top(300, "largest: s"));
  EXPECT_NE(solved.reason("end").find("no largest value was found"), std::string::npos) << solved.reason("end");
}

// A mass in a frame that turns, on springs k and 4 k, is unstable from sqrt(k/m) = 10 rad/s to twice as fast.
std::string mass_in_a_frame(const std::string& given, const std::string& ask) {
  return "title: t\ngiven: {m: 2 kg, k: 200 N/m, w: " + given +
         "}\npoints: {O: [0, 0, 0]}\nframes: {f: {turns: z, rate: w}}\n"
         "bodies: {arm: massless, p: {particle: O, mass: m}}\njoints:\n"
         "  shaft: {revolute: z, at: O, to: arm, rate: w, accel: 0}\n"
         "  guide: {planar: z, at: O, from: arm, to: p, freedoms: {slide1: {displacement: u, spring: {stiffness: k}},"
         " slide2: {displacement: v, spring: {stiffness: 4*k}}, turn: {angle: 0 deg, rate: 0, accel: 0}}}\n"
         "steady: {frame: f}\ngravity: none\nask: {end: {" +
         ask + ", while: stable(p)}}\n";
}

TEST(Extremum, GapsAreToldFromTheValueOnThatTheDatumHas) {
  const std::string bounds = "where: [1 rad/s < w < 30 rad/s]\n";
  const auto told = [](const std::string& text, const std::vector<std::pair<std::string, std::string>>& sets = {}) {
    const SolvedText solved(text, sets);
    std::string all = solved.ask("end").reason;
    for (const std::string& note : solved.notes()) all += "\n" + note;
    return all;
  };
  const auto has = [](const std::string& all, const std::string& part) { return all.find(part) != std::string::npos; };
  const std::string up = mass_in_a_frame("3 rad/s", "largest: w"), down = mass_in_a_frame("25 rad/s", "smallest: w");
  EXPECT_TRUE(has(told(bounds + up), "20 rad/s it does not hold: from smaller values")) << told(bounds + up);
  EXPECT_TRUE(has(told(bounds + down), "between 20 rad/s and")) << told(bounds + down);
  // Without bounds the search ends far away, and the gap near the start is told all the same.
  EXPECT_TRUE(has(told(up), "20 rad/s it does not hold: from smaller values")) << told(up);
  // A value in the gap.
  const std::string within = bounds + mass_in_a_frame("15 rad/s", "largest: w");
  EXPECT_TRUE(has(told(within, {{"w", "3 rad/s"}}), "20 rad/s it does not hold: from smaller values"));
  EXPECT_TRUE(has(told(within), "it does not hold at 15 rad/s, the value of 'w', but from 20 rad/s up"))
      << told(within);
}

// Three logs: the one on top holds the others apart as long as mu >= tan 15 deg where they touch. What those below do
// on the floor is found at each value.
TEST(Extremum, LogsHoldWhileTheyStickToEachOther) {
  const SolvedText solved(
      "title: t\nplane: [x, y]\ngiven: {r: 0.1 m, m: 10 kg}\nletters: {k: 1}\n"
      "points: {A: [-r, r], B: [r, r], C: '[0, r + r*sqrt(3)]', P: [-r, 0], Q: [r, 0], U: (A + C)/2, W: (B + C)/2}\n"
      "bodies: {a: {disk: {center: A, normal: z, radius: r}, mass: m}, b: {disk: {center: B, normal: z, radius: r}, "
      "mass: m}, c: {disk: {center: C, normal: z, radius: r}, mass: m}}\n"
      "contacts: {pa: {of: a, at: P, normal: y, friction: 0.5}, pb: {of: b, at: Q, normal: y, friction: 0.5},"
      " ca: {of: c, against: a, at: U, normal: A->C, friction: k},"
      " cb: {of: c, against: b, at: W, normal: B->C, friction: k}}\n"
      "gravity: -y\ninstants: {now: rest}\nask: {least: {smallest: k, while: [sticking(ca), sticking(cb)]}}\n");
  const double expected = std::tan(std::numbers::pi / 12);
  EXPECT_NEAR(solved.number("least"), expected, 1e-6 * expected);
}

// s = d cos(w t) is negative at 1 s by intervals of k for ever: the largest k is none of their ends.
TEST(Extremum, WhatHoldsByIntervalsForEverHasNoLargestValue) {
  const SolvedText solved(
      "title: t\ngiven: {k: 30 N/m, d: 0.1 m}\npoints: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: 1 kg}}\n"
      "joints: {rail: {prismatic: x, at: O, to: b, displacement: s, spring: {stiffness: k}}}\ngravity: none\n"
      "instants: {start: {s: d, s': 0}}\n"
      "ask: {low: {smallest: k, while: 's @ 1 s < 0 m'}, high: {largest: k, while: 's @ 1 s < 0 m'}}\n");
  EXPECT_NEAR(solved.number("low"), std::pow(std::numbers::pi / 2, 2), 1e-9);
  EXPECT_EQ(solved.reason("high").find("it holds by intervals"), 0U) << solved.reason("high");
}

}  // namespace extremum_test
}  // namespace poinsot::problem
