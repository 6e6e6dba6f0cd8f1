// A pin in a slot, against the same guide composed of other joints: a massless block that slides, and a hinge on it.
#include <cmath>
#include <numbers>

#include "problem/course/motion_support.h"
#include "problem/machine/data.h"

namespace poinsot::problem {
namespace slot_test {

const std::string hanging =
    "title: t\ngiven: {m: 3 kg, L: 0.6 m, b: 25 deg}\n"
    "points: {P: [0.1 m, 0.2 m, 0.05 m], Q: [0.5 m, -0.3 m, 0.3 m]}\n"
    "directions: {u: [cos(b), sin(b), 0.2], k: [0.1, -0.3, 1]}\n"
    "gravity: [2 m/s^2, -9 m/s^2, 1.5 m/s^2]\n"
    "ask: {a: acceleration(bar), alpha: angular_acceleration(bar), F: force(pin on bar), M: couple(pin on bar about "
    "P), "
    "later: position(Q of bar) @ 0.4 s, turned: angular_velocity(bar) @ 0.4 s}\n";

// The bar hangs by the pin (hangs), or what slides hangs on the bar, so that the tree grows through the joint
// backwards.
std::string bodies(bool hangs, const std::string& more) {
  const std::string bar = "  bar: {rod: [P, Q], mass: m}\n",
                    rail = "  rail: {sphere: {center: P, radius: 0.1 m}, mass: m}\n";
  return "bodies:\n" + bar + (hangs ? "" : rail) + more;
}
const char* asked[] = {"a", "alpha", "F", "M", "later", "turned"};

void expect_same(const SolvedText& one, const SolvedText& other) {
  for (const char* ask : asked) {
    const Vector3<double> expected = other.vector(ask);
    EXPECT_GT(norm(expected), 1e-3) << ask;
    EXPECT_LT(norm(one.vector(ask) - expected), 1e-8 * norm(expected)) << ask;
  }
}

TEST(Slot, CarriesWhatABlockOnARailWithAHingeDoes) {
  const std::string slide = "displacement: s, rate: 0.7 m/s, force: 5 N, spring: {stiffness: 30 N/m}, damping: 2 N*s/m";
  const std::string turn = "angle: phi, rate: -2 rad/s, couple: 1 N*m";
  const SolvedText pinned(hanging + bodies(true, "") +
                          "joints:\n  pin: {slot: [u, k], at: P, to: bar, freedoms: {slide: {" + slide + "}, turn: {" +
                          turn + "}}}\n");
  const SolvedText composed(hanging + bodies(true, "  block: massless\n") +
                            "joints:\n  rail: {prismatic: u, at: P, to: block, " + slide +
                            "}\n  pin: {revolute: k, at: P, from: block, to: bar, " + turn + "}\n");
  expect_same(pinned, composed);
}

TEST(Slot, HoldsTheBodyThatHasTheSlotAsWell) {
  const std::string hinge = "  hinge: {revolute: z, at: Q, to: bar, rate: 1 rad/s}\n";
  const std::string slide = "displacement: s, rate: 0.7 m/s, damping: 2 N*s/m", turn = "angle: phi, rate: -2 rad/s";
  const SolvedText pinned(hanging + bodies(false, "") + "joints:\n" + hinge +
                          "  pin: {slot: [u, k], at: P, from: rail, to: bar, freedoms: {slide: {" + slide +
                          "}, turn: {" + turn + "}}}\n");
  const SolvedText composed(hanging + bodies(false, "  block: massless\n") + "joints:\n" + hinge +
                            "  guide: {prismatic: u, at: P, from: rail, to: block, " + slide +
                            "}\n  pin: {revolute: k, at: P, from: block, to: bar, " + turn + "}\n");
  expect_same(pinned, composed);
}

// A crank whose pin drives a slotted arm: what the arm does is seen from the ends of the line between the pins.
TEST(Slot, ClosesALoop) {
  const std::string quick_return =
      "title: t\ngiven: {r: 0.1 m, h: 0.25 m, n: 6 rad/s, b: 70 deg}\n"
      "points: {O: [0, h, 0], A: [0, 0, 0], P: [r*cos(b), h + r*sin(b), 0], E: 2*P}\n"
      "bodies:\n  crank: {rod: [O, P], mass: 1 kg}\n  arm: {rod: [A, E], mass: 4 kg}\n"
      "gravity: -y\n"
      "ask: {turned: phi @ 0.5 s, rate: phi', alpha: phi'', Fx: force(pin on arm).x, Fy: force(pin on arm).y}\n";
  const std::string hinges =
      "joints:\n  shaft: {revolute: z, at: O, to: crank, rate: n, accel: 0}\n"
      "  hinge: {revolute: z, at: A, to: arm, angle: phi}\n";
  const SolvedText pinned(quick_return + hinges + "  pin: {slot: [A->P, z], at: P, from: arm, to: crank}\n");
  const double r = 0.1, h = 0.25, n = 6, b = 70 * std::numbers::pi / 180;
  const auto inclination = [&](double t) { return std::atan2(h + r * std::sin(b + n * t), r * std::cos(b + n * t)); };
  EXPECT_NEAR(pinned.number("turned"), inclination(0.5) - inclination(0), 1e-9);
  // dphi/dt = n (r^2 + r h sin b)/AP^2, from the velocity of the pin across the arm.
  const double distance = r * r + h * h + 2 * r * h * std::sin(b);
  EXPECT_NEAR(pinned.number("rate"), n * (r * r + r * h * std::sin(b)) / distance, 1e-12);
  EXPECT_NEAR(pinned.number("alpha"), n * n * r * h * std::cos(b) * (h * h - r * r) / (distance * distance), 1e-10);
  // The slot pushes across itself.
  const double phi = inclination(0), Fx = pinned.number("Fx"), Fy = pinned.number("Fy");
  EXPECT_NEAR(Fx * std::cos(phi) + Fy * std::sin(phi), 0, 1e-10);
  const double arm = std::sqrt(distance), inertia = 4 * (4 * distance) / 3;
  const double weight = 4 * standard_gravity * std::cos(phi) * arm;
  EXPECT_NEAR((Fy * std::cos(phi) - Fx * std::sin(phi)) * arm, inertia * pinned.number("alpha") + weight, 1e-8);
}

}  // namespace slot_test
}  // namespace poinsot::problem
