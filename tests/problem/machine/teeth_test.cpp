// Teeth that lean and rise, against statics and geometry at random: the arm of the base circle, the thread of a helix,
// the ratio of threads; and what no flank changes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "problem/course/motion_support.h"
#include "problem/language/failure.h"

namespace poinsot::problem {
namespace teeth_test {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

std::string in(double value, const std::string& unit) { return std::to_string(value) + " " + unit; }

// Six digits, as they stand in the text.
double rounded(double x) { return std::stod(std::to_string(x)); }

// Two gears on parallel or crossed shafts, the first driven by a couple M; against what the second drives.
std::string pair(const std::string& given, const std::string& second_axis, const std::string& teeth,
                 const std::string& asks) {
  return "title: t\ngiven: {" + given +
         "}\npoints: {O: [0, 0, 0], P: [0, a, 0], Q: [0, a + b, 0]}\n"
         "bodies: {one: {mass: 1 kg, center: O, inertia: {axis: z, axial: 0.02 kg*m^2, transverse: 0.03 kg*m^2}}, "
         "other: {mass: 1 kg, center: Q, inertia: {axis: " +
         second_axis +
         ", axial: 0.05 kg*m^2, transverse: 0.03 kg*m^2}}}\n"
         "joints: {s: {revolute: z, at: O, to: one, couple: M}, t: {revolute: " +
         second_axis +
         ", at: Q, to: other}}\n"
         "gears: {m: {of: one, against: other, at: P, " +
         teeth + "}}\ngravity: none\ninstants: {now: rest}\nask: {f: force(m on one), " + asks + "}\n";
}

TEST(Teeth, AForceTouchesTheBaseCirclesAndPartsTheWheels) {
  std::mt19937 random(71);
  std::uniform_real_distribution<double> part(0.2, 2), angle(5, 35);
  for (int i = 0; i < 20; ++i) {
    const double a = rounded(part(random)), b = rounded((i % 3 == 0 ? -1 : 1) * part(random)),
                 M = rounded((i % 2 ? 1 : -1) * part(random)), phi = rounded(angle(random));
    if (std::abs(a + b) < 0.1) continue;
    const std::string given =
        "a: " + in(a, "m") + ", b: " + in(b, "m") + ", M: " + in(M, "N*m") + ", phi: " + in(phi, "deg");
    const std::string asks =
        "w: angular_acceleration(one).z, r: radial_force(m on other), t: tangential_force(m on other), "
        "x: axial_force(m on other), shaft: force(t on other)";
    const SolvedText leaning(pair(given, "z", "pressure_angle: phi", asks)), straight(pair(given, "z", "", asks));
    const Vector3<double> f = leaning.vector("f");
    // The arm about each axis is that of its base circle: O at 0, Q at a + b.
    EXPECT_NEAR(std::abs(a * f.x), norm(f) * std::abs(a) * std::cos(phi * degree), 1e-9 * norm(f));
    EXPECT_NEAR(std::abs(f.y), norm(f) * std::sin(phi * degree), 1e-9 * norm(f));
    // A ring (negative b: the second gear lies about the first, or the first about it) is pushed outward.
    const bool one_is_ring = b < 0 && a > -b;
    EXPECT_GT(one_is_ring ? f.y : -f.y, 0) << a << " " << b;
    // Nothing moves otherwise than with straight teeth, and the three parts are the force.
    EXPECT_NEAR(leaning.number("w"), straight.number("w"), 1e-12 * std::abs(straight.number("w")));
    EXPECT_NEAR(leaning.vector("f").x, straight.vector("f").x, 1e-12 * norm(f));
    EXPECT_NEAR(norm(leaning.vector("r") + leaning.vector("t") + leaning.vector("x") + f), 0, 1e-12 * norm(f));
    EXPECT_NEAR(norm(leaning.vector("shaft") - f), 0, 1e-9 * norm(f));
  }
}

TEST(Teeth, OfAHelixTheForceStandsAcrossItsThread) {
  std::mt19937 random(72);
  std::uniform_real_distribution<double> part(0.2, 2), angle(5, 40);
  for (int i = 0; i < 20; ++i) {
    const double a = rounded(part(random)), b = rounded(part(random)), M = rounded((i % 2 ? 1 : -1) * part(random)),
                 phi = rounded(angle(random)), psi = rounded(angle(random));
    const bool right = i % 4 < 2, normal = i % 3 == 0;
    const std::string given = "a: " + in(a, "m") + ", b: " + in(b, "m") + ", M: " + in(M, "N*m") +
                              ", phi: " + in(phi, "deg") + ", psi: " + in(psi, "deg");
    const std::string angles = std::string(normal ? "normal_" : "") + "pressure_angle: phi, ";
    const std::string hand = right ? "right" : "left", asks = "w: angular_acceleration(one).z";
    const SolvedText helical(pair(given, "z", angles + "helix_angle: psi, hand: " + hand, asks));
    const SolvedText by_lead(pair(given, "z", angles + "lead: 2*pi*a/tan(psi), hand: " + hand, asks));
    const SolvedText two_rows(pair(given, "z", angles + "helix_angle: psi, hand: both", asks));
    const Vector3<double> f = helical.vector("f");
    // The thread through P, by two of its points: the shaft turned a little while a point goes up it.
    const double small = 1e-5, turn = (right ? 1 : -1) * small * std::tan(psi * degree) / a;
    const Vector3<double> thread{-a * std::sin(turn), a * std::cos(turn) - a, small};
    EXPECT_NEAR(dot(f, normalized(thread)), 0, 1e-4 * norm(f));
    EXPECT_LT(f.y, 0);
    if (normal)
      EXPECT_NEAR(-f.y, norm(f) * std::sin(phi * degree), 1e-9 * norm(f));
    else
      EXPECT_NEAR(-f.y, std::abs(f.x) * std::tan(phi * degree), 1e-9 * norm(f));
    EXPECT_NEAR(norm(by_lead.vector("f") - f), 0, 1e-9 * norm(f));
    const Vector3<double> rows = two_rows.vector("f");
    EXPECT_NEAR(norm(rows - Vector3<double>{f.x, f.y, 0}), 0, 1e-9 * norm(f));
    EXPECT_NEAR(helical.number("w"), two_rows.number("w"), 1e-9 * std::abs(two_rows.number("w")));
  }
}

// The wheel of a worm goes on by one lead in a turn: by energy, with the ratio k = lead/(2 pi b).
TEST(Teeth, AWormMovesItsWheelByItsLead) {
  std::mt19937 random(73);
  std::uniform_real_distribution<double> part(0.2, 2);
  for (int i = 0; i < 20; ++i) {
    const double a = rounded(part(random)), b = rounded(part(random)), M = rounded(part(random)),
                 L = rounded(part(random));
    const bool right = i % 2 == 0;
    const SolvedText solved(
        pair("a: " + in(a, "m") + ", b: " + in(b, "m") + ", M: " + in(M, "N*m") + ", L: " + in(L, "m"), "x",
             std::string("normal_pressure_angle: 20 deg, lead: L, hand: ") + (right ? "right" : "left"),
             "w: angular_acceleration(one).z, v: angular_acceleration(other).x"));
    const double k = L / (2 * pi * b), w = M / (0.02 + 0.05 * k * k);
    EXPECT_NEAR(solved.number("w"), w, 1e-9 * w);
    // A right-handed thread seen from its side, P above it, goes backward where it turns forward: the teeth of the
    // wheel, which stand above, move along -z, and the wheel, above them, about +x.
    EXPECT_NEAR(solved.number("v"), (right ? 1 : -1) * k * w, 1e-9 * w);
    // The normal of smooth teeth has the normal pressure angle.
    const Vector3<double> f = solved.vector("f");
    EXPECT_NEAR(-f.y, norm(f) * std::sin(20 * degree), 1e-9 * norm(f));
  }
}

// Two meshes of equal wheels back to back, over a countershaft: both wheels on the one axis turn as if welded.
TEST(Teeth, EqualWheelsBackToBackAreAWeld) {
  const auto train = [](const std::string& joints) {
    return "title: t\ngiven: {a: 40 mm, b: 70 mm, M: 3 N*m}\n"
           "points: {O: [0, 0, 0], P: [a, 0, 0], Q: [a + b, 0, 0], U: [0, 0, 0.2 m], V: [a, 0, 0.2 m]}\n"
           "bodies: {one: {mass: 1 kg, center: O, inertia: {axis: z, axial: 0.02 kg*m^2, transverse: 1 kg*m^2}}, "
           "same: {mass: 1 kg, center: U, inertia: {axis: z, axial: 0.05 kg*m^2, transverse: 1 kg*m^2}}, "
           "counter: {mass: 1 kg, center: Q, inertia: {axis: z, axial: 0.03 kg*m^2, transverse: 1 kg*m^2}}}\n"
           "joints: {s: {revolute: z, at: O, to: one, couple: M}, c: {revolute: z, at: Q, to: counter}, " +
           joints + "gravity: none\ninstants: {now: rest}\nask: {w: angular_acceleration(same).z}\n";
  };
  const SolvedText meshed(train(
      "t: {revolute: z, at: U, to: same}}\ngears: {m: {of: one, against: counter, at: P, pressure_angle: 20 deg}, "
      "n: {of: counter, against: same, at: V, normal_pressure_angle: 25 deg, helix_angle: 20 deg, hand: left}}\n")),
      welded(train("t: {weld: O, from: one, to: same}}\ngears: {m: {of: one, against: counter, at: P}}\n"));
  EXPECT_NEAR(meshed.number("w"), welded.number("w"), 1e-12 * welded.number("w"));
  EXPECT_NEAR(welded.number("w"), 3 / (0.07 + 0.03 * 16 / 49), 1e-9);
}

TEST(Teeth, OfAWormRubAgainstTheirSlip) {
  std::mt19937 random(74);
  std::uniform_real_distribution<double> part(0.2, 2), coefficient(0.01, 0.2);
  for (int i = 0; i < 20; ++i) {
    const double a = rounded(part(random)), b = rounded(part(random)), L = rounded(2 + part(random)),
                 mu = rounded(coefficient(random)), load = rounded((i % 2 ? 1 : -1) * part(random));
    const int sense = i % 4 < 2 ? 1 : -1;
    const std::string text =
        "title: t\ngiven: {a: " + in(a, "m") + ", b: " + in(b, "m") + ", L: " + in(L, "m") +
        ", mu: " + std::to_string(mu) + ", Q: " + in(load, "N*m") +
        "}\npoints: {O: [0, 0, 0], P: [0, a, 0], C: [0, a + b, 0]}\n"
        "bodies: {one: {mass: 1 kg, center: O, inertia: {axis: z, axial: 0.02 kg*m^2, transverse: 1 kg*m^2}}, other: "
        "{mass: 1 kg, center: C, inertia: {axis: x, axial: 0.05 kg*m^2, transverse: 1 kg*m^2}}}\n"
        "joints: {s: {revolute: z, at: O, to: one, rate: " +
        std::to_string(sense) +
        " rad/s, accel: 0}, t: {revolute: x, at: C, to: other, couple: Q}}\n"
        "gears: {m: {of: one, against: other, at: P, normal_pressure_angle: 20 deg, lead: L, hand: right, friction: "
        "mu}}\ngravity: none\ninstants: {now: {}}\nask: {d: drive(s).z, f: force(m on one)}\n";
    const SolvedText solved(text);
    // The wedge of the thread: the friction angle adds to the lead angle where the worm works against the load. For a
    // right hand the wheel turns about +x where the worm does about +z.
    const double lead_angle = std::atan(L / (2 * pi * a)), friction_angle = std::atan(mu / std::cos(20 * degree));
    const bool against = load * sense < 0;
    const double M = -load / b * a * std::tan(lead_angle + (against ? 1 : -1) * friction_angle);
    EXPECT_NEAR(solved.number("d"), M, 1e-9 * std::abs(load)) << text;
    EXPECT_LT(solved.vector("f").y, 0);
  }
}

const char* const three_planets =
    "title: t\ngiven: {a: 40 mm, b: 20 mm, M: 3 N*m}\n"
    "points: {O: [0, 0, 0], C: [a + b, 0, 0], P: [a, 0, 0], R: [a + 2*b, 0, 0], D: [0, a + b, 0], S: [0, a, 0], T: [0, "
    "a + 2*b, 0]}\n"
    "bodies: {sun: {disk: {center: O, normal: z, radius: a}, mass: 1 kg}, arm: {rod: [O, C], mass: 1 kg}, "
    "p: {disk: {center: C, normal: z, radius: b}, mass: 1 kg}, q: {disk: {center: D, normal: z, radius: b}, mass: 1 "
    "kg}}\n"
    "joints: {s: {revolute: z, at: O, to: sun, couple: M}, pivot: {revolute: z, at: O, to: arm}, "
    "cp: {revolute: z, at: C, from: arm, to: p}, cq: {revolute: z, at: D, from: arm, to: q}}\n"
    "gears: {m: {of: p, against: sun, at: P, pressure_angle: 20 deg}, n: {of: p, against: ground, at: R, "
    "pressure_angle: 20 deg}, k: {of: q, against: sun, at: S, pressure_angle: 20 deg}, l: {of: q, against: ground, at: "
    "T, pressure_angle: 20 deg}}\n"
    "gravity: none\ninstants: {now: rest}\nask: {w: angular_acceleration(sun).z, f: radial_force(m on sun).x, shaft: "
    "force(s on sun).x}\n";

TEST(Teeth, PlanetsThatShareALoadMoveAsOneAndDoNotTellHowTheyArePushed) {
  const SolvedText solved(three_planets);
  // By energy: sun I = 0.8e-3, both planets with (a + b) n and the spin k = -a/(2 b) of the sun, arm m L^2/3.
  const double n = 0.04 / 0.12, I = 0.5 * 0.0016 + n * n * (0.0036 / 3 + 2 * 0.0036) + 2 * 0.5 * 0.0004 * 1.0;
  EXPECT_NEAR(solved.number("w"), 3 / I, 1e-6 * 3 / I);
  EXPECT_FALSE(solved.reason("f").empty());
  EXPECT_FALSE(solved.reason("shaft").empty());
}

TEST(Teeth, TellWhatIsMissing) {
  const std::string given = "a: 1 m, b: 2 m, M: 3 N*m";
  const auto refused = [&](const std::string& axis, const std::string& teeth) {
    return failure_of_text(pair(given, axis, teeth, "w: mass(one)"));
  };
  const auto says = [](const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  says(refused("z", "pressure_angle: 20 deg, normal_pressure_angle: 20 deg"), "states both");
  says(refused("z", "helix_angle: 20 deg"), "on which side its teeth rise");
  says(refused("z", "hand: right"), "straight and have no hand");
  says(refused("z", "helix_angle: 20 deg, hand: up"), "no hand 'up'");
  says(refused("z", "lead: 1 m, hand: both"), "a worm is right- or left-handed");
  says(refused("z", "helix_angle: -20 deg, hand: left"), "not between 0 and 90 deg");
  says(refused("z", "pressure_angle: -20 deg"), "not between 0 and 90 deg");
  says(refused("z", "pressure_angle: 2 m"), "angle");
  says(refused("x", "normal_pressure_angle: 20 deg"), "move along different directions");
  says(refused("x", "pressure_angle: 20 deg, lead: 1 m, hand: left"), "state normal_pressure_angle");
}

}  // namespace teeth_test
}  // namespace poinsot::problem
