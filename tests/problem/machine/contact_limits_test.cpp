// Contacts on surfaces that end, and on straight sides: what is rolled on, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace contact_limits_test {

constexpr double g = 9.80665;

const std::string half_disk =
    "title: t\ngiven: {R: 0.1 m, m: 2 kg}\npoints: {C: [0, 0, 0], O: [0, R, 0], A: [-R, R, 0], B: [R, R, 0]}\n"
    "bodies: {half: {semicircle: {diameter: [A, B], toward: -y}, mass: m}}\n"
    "joints: {pl: {planar: z, at: O, to: half}}\n"
    "contacts: {k: {of: half, at: C, normal: y, no_slip: true}}\ngravity: -y\n";

TEST(ContactLimits, AHalfDiskRocksOnItsArc) {
  const SolvedText solved(half_disk + "instants: {now: rest}\nask: {f: frequencies(half)}\n");
  const double R = 0.1, d = 4 * R / (3 * M_PI), I = R * R / 2 - d * d + (R - d) * (R - d);
  ASSERT_EQ(solved.found("f").value.items.size(), 1U);
  EXPECT_NEAR(solved.found("f").value.items[0].number, std::sqrt(g * d / I), 1e-8);
}

// A body of which the mass center lies d below the center of its circle, rolling at w with no slope: the floor bears
// m (g + w^2 d).
TEST(ContactLimits, TheFloorBearsWhatRollsOverIt) {
  const std::string points =
      "title: t\ngiven: {R: 0.1 m}\npoints: {C: [0, 0, 0], O: [0, R, 0], A: [-R, R, 0], B: [R, R, 0]}\n";
  const std::string rest =
      "contacts: {k: {of: half, at: C, normal: y, no_slip: true}}\nfacts: {angular_velocity(half): [0, 0, 5 rad/s]}\n"
      "gravity: -y\nask: {N: reaction(k).y}\n";
  const auto bears = [&](const std::string& body) {
    return SolvedText(points + "bodies: {half: {" + body + "}}\n" + rest).number("N");
  };
  const double half = 4 * 0.1 / (3 * M_PI), h = M_PI / 6;
  EXPECT_NEAR(bears("sector: {center: O, normal: z, middle: -y, radius: R, angle: 60 deg}, mass: 2 kg"),
              2 * (g + 25 * 2 * 0.1 * std::sin(h) / (3 * h)), 1e-10);
  EXPECT_NEAR(
      bears("parts: {a: {semicircle: {diameter: [A, B], toward: -y}, mass: 1 kg}, b: {rod: [A, B], mass: 1 kg}}"),
      2 * (g + 25 * half / 2), 1e-10);
  EXPECT_NEAR(bears("arc: {diameter: [A, B], toward: -y}, mass: 2 kg"), 2 * (g + 25 * 2 * 0.1 / M_PI), 1e-10);
  EXPECT_NEAR(bears("arc: {center: O, start: A, normal: z, angle: 180 deg}, mass: 2 kg"), 2 * (g + 25 * 2 * 0.1 / M_PI),
              1e-10);
}

TEST(ContactLimits, TheEndOfAnArcIsACorner) {
  // Leaning by 30 deg on the end A of its diameter: I_A = 3/2 m R^2, and the weight turns it.
  const SolvedText solved(
      "title: t\ngiven: {R: 0.1 m, b: 30 deg}\npoints: {A: [0, 0, 0], B: [2*R*sin(b), 2*R*cos(b), 0]}\n"
      "directions: {n: [-cos(b), sin(b), 0]}\n"
      "bodies: {half: {semicircle: {diameter: [A, B], toward: n}, mass: 2 kg}}\n"
      "contacts: {k: {of: half, at: A, normal: y, no_slip: true}}\nfacts: {angular_velocity(half): [0, 0, 5 rad/s]}\n"
      "gravity: -y\nask: {a: acceleration(half), al: angular_acceleration(half).z}\n");
  const double R = 0.1, d = 4 * R / (3 * M_PI), b = M_PI / 6;
  const double x = R * std::sin(b) - d * std::cos(b), y = R * std::cos(b) + d * std::sin(b);
  const double alpha = -g * x / (1.5 * R * R);
  EXPECT_NEAR(solved.number("al"), alpha, 1e-10);
  EXPECT_NEAR(solved.vector("a").x, -alpha * y - 25 * x, 1e-10);
  EXPECT_NEAR(solved.vector("a").y, alpha * x - 25 * y, 1e-10);
}

// Where the end of the arc touches along its radius, the body rolls to one side and turns about the corner to the
// other.
TEST(ContactLimits, AtItsEndAnArcRollsToOneSide) {
  const auto turning = [](const std::string& w) {
    return SolvedText(
        "title: t\ngiven: {R: 0.1 m}\npoints: {A: [0, 0, 0], B: [0, 2*R, 0]}\n"
        "bodies: {half: {semicircle: {diameter: [A, B], toward: x}, mass: 2 kg}}\n"
        "contacts: {k: {of: half, at: A, normal: y, no_slip: true}}\n"
        "facts: {angular_velocity(half): [0, 0, " +
        w + "]}\ngravity: -y\nask: {al: angular_acceleration(half).z}\n");
  };
  // About A, with the center O of the circle going straight: I_A al + m w^2 (A - O) x (G - O) . z = -m g d.
  const double R = 0.1, d = 4 * R / (3 * M_PI);
  EXPECT_NEAR(turning("-5 rad/s").number("al"), (-g * d - 25 * R * d) / (1.5 * R * R), 1e-10);
  EXPECT_NE(turning("5 rad/s").reason("al").find("is beyond the end of the round surface of 'half'"),
            std::string::npos);
}

TEST(ContactLimits, AMotionEndsWhereTheArcEnds) {
  const SolvedText solved(half_disk +
                          "instants: {start: {angular_velocity(half): [0, 0, 30 rad/s]}}\n"
                          "ask: {before: angular_velocity(half).z @ 0.01 s, after: position(O of half) @ 1 s}\n");
  EXPECT_GT(solved.number("before"), 20);
  EXPECT_NE(solved.reason("after").find("contact 'k' is beyond the end of the round surface of 'half'"),
            std::string::npos)
      << solved.reason("after");
}

TEST(ContactLimits, AHalfSphereEndsAtItsRim) {
  const SolvedText solved(
      "title: t\ngiven: {R: 0.1 m}\npoints: {C: [0, 0, 0], O: [0, R, 0]}\n"
      "bodies: {dome: {hemisphere: {center: O, radius: R, toward: -y}, mass: 2 kg}}\n"
      "contacts: {k: {of: dome, at: C, normal: y, no_slip: true}}\ngravity: -y\n"
      "instants: {start: {angular_velocity(dome): [0, 0, 40 rad/s]}}\nask: {x: position(O of dome) @ 1 s}\n");
  EXPECT_NE(solved.reason("x").find("is beyond the end of the round surface of 'dome'"), std::string::npos)
      << solved.reason("x");
}

const std::string rod_on_peg =
    "title: t\ngiven: {d: 0.3 m}\npoints: {C: [0, 0, 0], G: [d, 0, 0], A: G - 1 m * x, B: G + 1 m * x}\n"
    "bodies: {rod: {rod: [A, B], mass: 3 kg}}\ncontacts: {peg: {of: rod, at: C, normal: y}}\ngravity: -y\n";

// The bottom of a bowl is as far from its rim as can be. On axes askew rounding took it for an end. Rolling from rest
// at the angle b the ball has there v^2 = (10/7) g (R - r) (1 - cos b).
TEST(ContactLimits, TheBottomOfABowlIsNoEnd) {
  const SolvedText solved(
      "title: t\ngiven: {R: 0.4934 m, r: 0.09093 m, b: 27.09 deg}\n"
      "points: {O: [0, 0, 0], C: (R*sin(b))*hx + (-R*cos(b))*hy, G: (1 - r/R)*C}\n"
      "directions: {in: (-sin(b))*hx + (cos(b))*hy, hx: [5/21, 20/21, 4/21], hy: [4/21, '-5/21', 20/21]}\n"
      "bodies: {bowl: {hemisphere_shell: {center: O, toward: '-hy', radius: R}, mass: 0 kg},"
      " ball: {sphere: {center: G, radius: r}, mass: 0.16 kg}}\njoints: {stand: {weld: O, to: bowl}}\n"
      "contacts: {rolls: {of: ball, against: bowl, at: C, normal: in, inside: bowl, no_slip: true}}\n"
      "gravity: '-hy'\ninstants: {now: rest}\nask: {fastest: max(norm(velocity(ball)))}\n");
  EXPECT_NEAR(solved.number("fastest"),
              std::sqrt(10.0 / 7 * g * (0.4934 - 0.09093) * (1 - std::cos(27.09 * M_PI / 180))), 1e-9);
}

TEST(ContactLimits, ARodTurnsOverNoFlatFloor) {
  const SolvedText solved(rod_on_peg +
                          "facts: {velocity(C of rod): [1.5 m/s, 0, 0], angular_velocity(rod): [0, 0, 2 rad/s]}\n"
                          "ask: {N: norm(reaction(peg)), v: velocity(rod)}\n");
  EXPECT_NE(solved.reason("N").find("'rod' is straight where contact 'peg' is"), std::string::npos)
      << solved.reason("N");
  EXPECT_NEAR(solved.vector("v").y, 0.6, 1e-12);
}

TEST(ContactLimits, ARodThatBeginsToTurnHasAReactionButNoMotion) {
  const SolvedText solved(rod_on_peg +
                          "instants: {start: rest}\nask: {N: norm(reaction(peg)), y: position(A of rod).y @ 0.1 s}\n");
  // N (1/m + d^2/I) = g for the point C to have no acceleration down.
  EXPECT_NEAR(solved.number("N"), g / (1.0 / 3 + 0.3 * 0.3 / (3 * 4.0 / 12)), 1e-10);
  EXPECT_NE(solved.reason("y").find("'rod' is straight where contact 'peg' is"), std::string::npos)
      << solved.reason("y");
}

TEST(ContactLimits, ACrateTipsAboutItsEdge) {
  const SolvedText solved(
      "title: t\ngiven: {a: 1 m}\npoints: {C: [a/2, 0, 0], G: [0, a/2, 0]}\n"
      "bodies: {crate: {cube: {center: G, side: a}, mass: 6 kg}}\n"
      "joints: {flat: {planar: z, at: G, to: crate}}\n"
      "contacts: {edge: {of: crate, at: C, normal: y, no_slip: true}}\ngravity: -y\n"
      "facts: {angular_velocity(crate): [0, 0, -1 rad/s]}\nask: {al: angular_acceleration(crate).z}\n");
  // About the edge: I = 2 m a^2/3, the weight turns back with m g a/2.
  EXPECT_NEAR(solved.number("al"), 0.75 * g, 1e-10);
}

}  // namespace contact_limits_test
}  // namespace poinsot::problem
