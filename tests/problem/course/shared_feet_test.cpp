// Bodies that rest on several rough feet under loads that change: when no share of the load holds them any more.
#include <fmt/format.h>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace {
namespace shared_feet_test {

constexpr double g = 9.80665;
constexpr double m = 20, b = 0.8, H = 1.2;

// A crate on two corners that is pushed at a height.
std::string crate(double height, const std::string& left, const std::string& right, const std::string& push,
                  const std::string& rest) {
  return fmt::format(
      "plane: [x, y]\npoints: {{A: [0, 0], B: [0.8 m, 0], Q: [0, {} m]}}\n"
      "bodies: {{crate: {{box: {{center: [0.4 m, 0.6 m, 0], sides: [0.8 m * x, 1.2 m * y, 0.5 m * z]}}, mass: 20 "
      "kg}}}}\n"
      "contacts:\n  l: {{of: crate, at: A, normal: y, friction: {}}}\n  r: {{of: crate, at: B, normal: y, friction: "
      "{}}}\n"
      "loads: {{push: {{force: '[{}, 0]', at: Q, body: crate}}}}\ngravity: -y\n{}",
      height, left, right, push, rest);
}
const std::string from_rest = "instants: {start: rest}\n";

// With the friction c0 + c1 P under the push P = k t from the time begins on.
struct Slide {
  double k, c0, c1, begins;
  double speed(double t) const { return (k * (1 - c1) * (t * t - begins * begins) / 2 - c0 * (t - begins)) / m; }
};

TEST(SharedFeet, OfOneRoughnessGiveWayTogether) {
  const SolvedText solved(crate(0.3, "0.4", "0.4", "30 N/s * time",
                                from_rest + "ask: {t: {first_time: sliding(l)}, u: {first_time: sliding(r)}, "
                                            "v: velocity(crate).x @ 4 s, w: angular_velocity(crate) @ 4 s}\n"));
  const double begins = 0.4 * m * g / 30;
  EXPECT_NEAR(solved.number("t"), begins, 1e-7);
  EXPECT_NEAR(solved.number("u"), begins, 1e-7);
  EXPECT_NEAR(solved.number("v"), (Slide{30, 0.4 * m * g, 0, begins}.speed(4)), 1e-7);
  EXPECT_NEAR(solved.number("w"), 0, 1e-10);
}

// F = u N1 + w N2 with N2 - N1 = (2/b) (P (h - H/2) + F H/2), by moments about the mass center.
TEST(SharedFeet, OfTwoRoughnessesShareByTheirPushes) {
  constexpr double u = 0.4, w = 0.25, h = 0.5, k = 30, d = (w - u) / 2, s = (u + w) * m * g / 2;
  constexpr double c0 = s / (1 - d * H / b), c1 = 2 * d / b * (h - H / 2) / (1 - d * H / b);
  const SolvedText solved(crate(h, "0.4", "0.25", "30 N/s * time",
                                from_rest + "ask: {t: {first_time: sliding(l)}, v: velocity(crate).x @ 4 s}\n"));
  const double begins = s / (k * (1 - 2 * d * h / b));
  EXPECT_NEAR(solved.number("t"), begins, 1e-7);
  EXPECT_NEAR(solved.number("v"), (Slide{k, c0, c1, begins}.speed(4)), 1e-7);
}

TEST(SharedFeet, FallToTheFrictionOfSlidingAtOnce) {
  const std::string both = "{static: 0.5, kinetic: 0.3}";
  const SolvedText solved(crate(0.3, both, both, "40 N/s * time",
                                from_rest + "ask: {t: {first_time: sliding(l)}, v: velocity(crate).x @ 4 s}\n"));
  const double begins = 0.5 * m * g / 40;
  EXPECT_NEAR(solved.number("t"), begins, 1e-7);
  EXPECT_NEAR(solved.number("v"), (Slide{40, 0.3 * m * g, 0, begins}.speed(4)), 1e-6);
}

TEST(SharedFeet, TipOverWhereThePushIsHigh) {
  const SolvedText solved(crate(1.2, "0.8", "0.8", "30 N/s * time",
                                from_rest + "ask: {t: {first_time: parting(l)}, stays: sticking(r) @ 2.3 s, "
                                            "w: angular_velocity(crate) @ 2.3 s}\n"));
  EXPECT_NEAR(solved.number("t"), m * g * b / (2 * 1.2 * 30), 1e-7);
  EXPECT_TRUE(solved.found("stays").value.truth);
  EXPECT_LT(solved.number("w"), 0);
}

TEST(SharedFeet, ComeToRestAndAreMovedTheOtherWay) {
  const SolvedText solved(crate(0.3, "0.4", "0.4", "-20 N/s * time",
                                "instants: {start: {velocity(crate): [2 m/s, 0], angular_velocity(crate): 0}}\n"
                                "ask: {rests: {first_time: sticking(l)}, t: {first_time: sliding(l), from: 1 s}, "
                                "x: position(crate).x @ 3.5 s}\n"));
  // m x'' = -u m g - k t until it rests.
  const double k = 20, u = 0.4, a = k / (2 * m), rests = (-u * g + std::sqrt(u * u * g * g + 8 * a)) / (2 * a);
  EXPECT_NEAR(solved.number("rests"), rests, 1e-8);
  EXPECT_NEAR(solved.number("t"), u * m * g / k, 1e-7);
  EXPECT_NEAR(solved.number("x"), 0.4 + 2 * rests - u * g * rests * rests / 2 - k * rests * rests * rests / (6 * m),
              1e-7);
}

// A spring whose far end is driven.
TEST(SharedFeet, AreMovedByWhatMovesBesideThem) {
  const SolvedText solved(
      "plane: [x, y]\ngiven: {k: 400 N/m, v: 0.2 m/s}\npoints: {A: [0, 0], B: [0.8 m, 0], Q: [0.8 m, 0.2 m], P: [2 m, "
      "0.2 m]}\n"
      "bodies:\n  crate: {box: {center: [0.4 m, 0.6 m, 0], sides: [0.8 m * x, 1.2 m * y, 0.5 m * z]}, mass: 20 kg}\n"
      "  hook: {particle: P, mass: 1 kg}\njoints: {rail: {prismatic: x, to: hook, rate: v, accel: 0}}\n"
      "contacts:\n  l: {of: crate, at: A, normal: y, friction: 0.4}\n  r: {of: crate, at: B, normal: y, friction: "
      "0.4}\n"
      "springs: {tow: {from: crate, at: Q, to: hook, end: P, stiffness: k, free_length: 1.2 m}}\ngravity: -y\n"
      "instants: {start: {velocity(crate): [0, 0], angular_velocity(crate): 0}}\n"
      "ask: {t: {first_time: sliding(l)}, stays: position(crate).x @ 0.5 s}\n");
  EXPECT_NEAR(solved.number("t"), 0.4 * m * g / (400 * 0.2), 1e-7);
  EXPECT_NEAR(solved.number("stays"), 0.4, 1e-12);
}

}  // namespace shared_feet_test
}  // namespace
}  // namespace poinsot::problem
