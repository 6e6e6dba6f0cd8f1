// Cords over wheels, gears and edges against closed forms at random, near equilibria, and what is refused of them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "problem/course/motion_support.h"
#include "problem/language/failure.h"

namespace poinsot::problem {
namespace transmissions_test {

constexpr double g = 9.80665;

std::string in(double value, const std::string& unit) { return std::to_string(value) + " " + unit; }

// The accelerations of both blocks and the tensions of Atwood's machine, whatever the places of the blocks below their
// sides of the wheel and the sense in which its axis is stated.
TEST(Transmissions, AtwoodsMachineAtRandom) {
  std::mt19937 random(61);
  std::uniform_real_distribution<double> part(0.2, 3);
  for (int i = 0; i < 20; ++i) {
    const double m = std::round(part(random) * 1e3) / 1e3, M = std::round(part(random) * 1e3) / 1e3,
                 P = std::round(part(random) * 1e3) / 1e3, r = 0.25, a = (M - m) * g / (M + m + P / 2);
    const SolvedText solved(
        "title: t\ngiven: {m: " + in(m, "kg") + ", M: " + in(M, "kg") + ", P: " + in(P, "kg") +
        ", r: 0.25 m}\npoints: {O: [0, 0, 0], A: [-r, -" + in(part(random), "m") + ", 0], B: [r, -" +
        in(part(random), "m") +
        ", 0]}\nbodies: {a: {particle: A, mass: m}, b: {particle: B, mass: M}, w: {disk: {center: O, "
        "normal: z, radius: r}, mass: P}}\njoints: {axle: {revolute: " +
        (i % 2 ? "z" : "-z") +
        ", at: O, to: w}}\ncords: {rope: {from: a, at: A, over: [w], to: b, end: B}}\ngravity: -y\n"
        "instants: {now: rest}\nask: {a: acceleration(a).y, T: tension(rope on a), S: tension(rope on "
        "b), w: angular_acceleration(w).z}\n");
    EXPECT_NEAR(solved.number("a"), a, 1e-9);
    EXPECT_NEAR(solved.number("T"), m * (g + a), 1e-9);
    EXPECT_NEAR(solved.number("S"), M * (g - a), 1e-9);
    EXPECT_NEAR(solved.number("w"), -a / r, 1e-9);
  }
}

// A planet between a sun that is welded to the ground, by itself or with what it stands on, and a ring that is driven.
TEST(Transmissions, AGearMayBeWeldedToWhatHoldsIt) {
  const double a = 0.04, b = 0.025, R = a + 2 * b, arm = R / (2 * (a + b)), planet = arm * (a + b) / b;
  const double inertia = 8e-3 + arm * arm * (2e-3 + 0.3 * (a + b) * (a + b)) + planet * planet * 1e-4;
  for (const char* stands : {"js: {weld: O, to: sun}", "jb: {weld: O, to: base}, js: {weld: O, from: base, to: sun}"}) {
    const SolvedText solved(
        "title: t\nplane: [x, y]\npoints: {O: [0, 0], C: [65 mm, 0], P: [40 mm, 0], R: [90 mm, 0]}\n"
        "bodies: {base: massless, sun: {mass: 1 kg, center: O, inertia: {z: 1e-3 kg*m^2}},"
        " ring: {mass: 2 kg, center: O, inertia: {z: 8e-3 kg*m^2}},"
        " arm: {mass: 1 kg, center: O, inertia: {z: 2e-3 kg*m^2}},"
        " planet: {mass: 0.3 kg, center: C, inertia: {z: 1e-4 kg*m^2}}}\n"
        "joints: {" +
        std::string(stands) +
        ", jr: {revolute: z, at: O, to: ring, rate: 4 rad/s, couple: 8 N*m}, ja: {revolute: z, at: O, to: arm},"
        " jp: {revolute: z, at: C, from: arm, to: planet}}\n"
        "gears: {in: {of: planet, against: sun, at: P}, out: {of: planet, against: ring, at: R}}\ngravity: none\n"
        "ask: {arm: angular_velocity(arm), planet: angular_velocity(planet), alpha: angular_acceleration(ring)}\n");
    EXPECT_NEAR(solved.number("arm"), 4 * arm, 1e-12);
    EXPECT_NEAR(solved.number("planet"), 4 * planet, 1e-12);
    EXPECT_NEAR(solved.number("alpha"), 8 / inertia, 1e-9);
  }
}

// Three gears in a ring lock one another: all rests, and each wheel takes its part of the couple M by its teeth. With
// equal radii r the forces of the teeth satisfy F + H = M/r, F = G, G = H but for their senses.
TEST(Transmissions, GearsThatLockOneAnotherRest) {
  const SolvedText solved(
      "title: t\ngiven: {r: 0.2 m}\npoints: {A: [0, 0, 0], B: [2*r, 0, 0], C: [r, r*sqrt(3), 0], P: [r, 0, 0],"
      " Q: [r/2, r*sqrt(3)/2, 0], R: [3*r/2, r*sqrt(3)/2, 0]}\n"
      "bodies: {a: {disk: {center: A, normal: z, radius: r}, mass: 2 kg}, b: {disk: {center: B, normal: z, radius: r},"
      " mass: 2 kg}, c: {disk: {center: C, normal: z, radius: r}, mass: 2 kg}}\n"
      "joints: {ja: {revolute: z, at: A, to: a, angle: q}, jb: {revolute: z, at: B, to: b},"
      " jc: {revolute: z, at: C, to: c}}\n"
      "gears: {m: {of: a, against: b, at: P}, n: {of: b, against: c, at: R}, o: {of: c, against: a, at: Q}}\n"
      "loads: {M: {couple: 3 N*m, about: z, body: a}}\ngravity: none\ninstants: {now: rest}\n"
      "ask: {w: angular_acceleration(b).z, F: norm(force(m on a)), G: norm(force(n on b)), later: q @ 1 s}\n");
  EXPECT_NEAR(solved.number("w"), 0, 1e-12);
  EXPECT_NEAR(solved.number("F"), 3 / 0.2 / 2, 1e-9);
  EXPECT_NEAR(solved.number("G"), 3 / 0.2 / 2, 1e-9);
  EXPECT_NEAR(solved.number("later"), 0, 1e-12);
}

// Two equal blocks on a cord over a wheel, one of them on a spring: w^2 = k/(2 m + I/r^2).
TEST(Transmissions, BlocksOnASpringSwingWithTheWheelThatTheyTurn) {
  const auto frequency = [](const std::string& over) {
    const SolvedText solved(
        "title: t\ngiven: {m: 2 kg, I: 0.05 kg*m^2, r: 0.1 m, k: 300 N/m}\n"
        "points: {O: [0, 0, 0], A: [-r, -1 m, 0], B: [r, -1 m, 0], F: [-r, -2 m, 0]}\n"
        "bodies: {a: {particle: A, mass: m}, b: {particle: B, mass: m},"
        " w: {mass: m, center: O, inertia: {axis: z, axial: I, transverse: I}}}\n"
        "joints: {axle: {revolute: z, at: O, to: w}, one: {prismatic: y, at: A, to: a}, other: {prismatic: y, at: B, "
        "to: b}}\n"
        "cords: {rope: {from: a, at: A, over: [" +
        over +
        "], to: b, end: B}}\n"
        "springs: {s: {at: F, to: a, end: A, stiffness: k, free_length: 1 m}}\n"
        "gravity: -y\ninstants: {now: rest}\nask: {f: frequencies(a)}\n");
    return solved.found("f").value.items.at(0).number;
  };
  EXPECT_NEAR(frequency("{w: {radius: r}}"), std::sqrt(300 / (4 + 0.05 / 0.01)), 1e-7);
  EXPECT_NEAR(frequency("{w: {radius: r, smooth: true}}"), std::sqrt(300.0 / 4), 1e-7);
}

// A planet between sun and ring, with a stated arm and sun: Willis's formula.
TEST(Transmissions, EpicyclicTrainsTurnByWillissFormula) {
  std::mt19937 random(62);
  std::uniform_real_distribution<double> part(0.5, 3);
  for (int i = 0; i < 20; ++i) {
    const double a = std::round(part(random) * 1e3) / 1e3, b = std::round(part(random) * 1e3) / 1e3, arm = part(random),
                 sun = -part(random);
    const SolvedText solved(
        "title: t\ngiven: {a: " + in(a, "m") + ", b: " + in(b, "m") +
        "}\npoints: {O: [0, 0, 0], C: [a + b, 0, 0], P: [a, 0, 0], R: [a + 2*b, 0, 0]}\n"
        "bodies: {sun: {disk: {center: O, normal: z, radius: a}, mass: 1 kg}, arm: {rod: [O, C], mass: 1 kg},"
        " planet: {disk: {center: C, normal: z, radius: b}, mass: 1 kg}, ring: {ring: {center: O, normal: z, radius: a "
        "+ "
        "2*b}, mass: 1 kg}}\n"
        "joints: {s: {revolute: z, at: O, to: sun, rate: " +
        in(sun, "rad/s") + "}, pivot: {revolute: z, at: O, to: arm, rate: " + in(arm, "rad/s") +
        "}, pin: {revolute: z, at: C, from: arm, to: planet}, r: {revolute: z, at: O, to: ring}}\n"
        "gears: {inner: {of: planet, against: sun, at: P}, outer: {of: ring, against: planet, at: R}}\n"
        "gravity: none\nask: {planet: angular_velocity(planet).z, ring: angular_velocity(ring).z}\n");
    EXPECT_NEAR(solved.number("planet"), arm - (std::stod(std::to_string(sun)) - arm) * a / b, 1e-5);
    EXPECT_NEAR(solved.number("ring"), arm - (std::stod(std::to_string(sun)) - arm) * a / (a + 2 * b), 1e-5);
  }
}

struct Refusal {
  const char* name;
  const char* text;
  const char* part;
};

class Refused : public ::testing::TestWithParam<Refusal> {};

TEST_P(Refused, SaysWhatIsWrong) {
  const std::string points =
      "title: t\npoints: {O: [0, 0, 0], A: [-1 m, -1 m, 0], B: [1 m, -1 m, 0], D: [0, -1 m, 0], E: [0, -2 m, 0], Z: [1 "
      "m, "
      "-1 m, 1 m]}\n";
  try {
    const SolvedText solved(points + GetParam().text + "gravity: -y\ninstants: {now: rest}\nask: {a: mass(b)}\n");
    FAIL() << "not refused";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().part), std::string::npos) << error.what();
  }
}

constexpr const char* wheel_and_block =
    "bodies: {b: {particle: B, mass: 1 kg}, w: {disk: {center: O, normal: z, radius: 0.3 m}, mass: 1 kg}}\n"
    "joints: {axle: {revolute: z, at: O, to: w}}\n";

const Refusal refusals[] = {
    {"EitherSide",
     "bodies: {b: {particle: E, mass: 1 kg}, w: {disk: {center: O, normal: z, radius: 0.3 m}, mass: 1 kg}}\n"
     "joints: {axle: {revolute: z, at: O, to: w}}\ncords: {c: {at: D, over: [w], to: b, end: E}}\n",
     "may pass 'w' on either side"},
    {"NoWheel",
     "bodies: {b: {particle: B, mass: 1 kg}, w: {box: {center: O, sides: [[1 m, 0, 0], [0, 1 m, 0], [0, 0, 1 m]]}, "
     "mass: 1 "
     "kg}}\ncords: {c: {at: A, over: [w], to: b, end: B}}\n",
     "is no wheel"},
    {"TiedAndWound", "bodies: {b: {particle: B, mass: 1 kg}}\ncords: {c: {at: A, to: {b: {side: +x}}, end: B}}\n",
     "is tied to a point there as well"},
    {"NoCarrier",
     "bodies: {b: {disk: {center: O, normal: z, radius: 1 m}, mass: 1 kg}}\n"
     "gears: {m: {of: b, against: ground, at: A}}\n",
     "has no body that carries"},
    {"OffTheCircle",
     "bodies: {b: {disk: {center: O, normal: z, radius: 1 m}, mass: 1 kg}, w: {disk: {center: B, normal: z, radius: 1 "
     "m}, "
     "mass: 1 kg}}\njoints: {one: {revolute: z, at: O, to: b}, two: {revolute: z, at: B, to: w}}\n"
     "gears: {m: {of: b, against: w, at: D}}\n",
     "move along different directions"},
    {"EdgeOffTheSurface",
     "bodies: {b: {particle: A, mass: 1 kg}}\ncontacts: {c: {of: b, at: A, normal: y, no_slip: [y]}}\n",
     "which is not along the surface"},
};

INSTANTIATE_TEST_SUITE_P(Transmissions, Refused, ::testing::ValuesIn(refusals),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Transmissions, ACordStaysInThePlaneOfItsWheels) {
  EXPECT_THROW(
      SolvedText(std::string("title: t\npoints: {O: [0, 0, 0], A: [-1 m, -1 m, 0], B: [1 m, -1 m, 0], Z: [1 m, -1 m, "
                             "1 m]}\n") +
                 wheel_and_block +
                 "cords: {c: {at: A, over: [w], to: b, end: Z}}\ngravity: -y\ninstants: {now: rest}\nask: {a: "
                 "mass(b)}\n"),
      StatementError);
}

}  // namespace transmissions_test
}  // namespace poinsot::problem
