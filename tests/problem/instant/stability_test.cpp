// What is said of the motion near a steady one, against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "case_count.h"
#include "problem/course/motion_support.h"
#include "problem/instant/near_steady.h"

namespace poinsot::problem {
namespace stability_test {

using namespace testing;

constexpr int trials = poinsot::testing::case_count(1000);
constexpr double g = 9.81;

std::string down_z() { return fmt::format("gravity: [0, 0, -{:.17g} m/s^2]\n", g); }
std::string down_y() { return fmt::format("gravity: [0, -{:.17g} m/s^2, 0]\n", g); }

// An oscillation by the square of its frequency; below zero it grows.
void expect_oscillator(const Near& near, double square, const std::string& text) {
  EXPECT_EQ(near.stable, square > 0) << text;
  if (square > 0) {
    EXPECT_EQ(near.growth, 0) << text;
    EXPECT_TRUE(near.swings_at(std::sqrt(square))) << "expected " << std::sqrt(square) << near.list() << text;
  } else {
    EXPECT_NEAR(near.growth, std::sqrt(-square), 1e-6 * std::sqrt(-square)) << text;
  }
}

// z'' J - i I S z' - m g l z = 0 of the small deviation z = x + i y of the axis.
TEST(Stability, SleepingTop) {
  Random random(401);
  for (int trial = 0; trial < trials; ++trial) {
    const Top top(random);
    const double k = top.m * g * top.l, critical = std::sqrt(4 * top.J * k) / top.I,
                 S = critical * (random.chance(0.5) ? random.uniform(0.1, 0.99) : random.uniform(1.01, 4));
    const std::string text = "title: a sleeping top\n" + down_z() + top.text({0, 0, 1}) +
                             fmt::format(
                                 "steady: {{frame: ground, spins: {{top: {{about: O->G, rate: {:.17g} rad/s}}}}}}\n"
                                 "ask: {{s: stable(top), g: growth_rate(top), f: frequencies(top)}}\n",
                                 S);
    const Near near = solved_near(text).front();
    const double square = top.I * S * top.I * S - 4 * top.J * k, root = std::sqrt(std::abs(square)) / (2 * top.J),
                 middle = top.I * S / (2 * top.J);
    EXPECT_EQ(near.stable, square > 0) << text;
    EXPECT_NEAR(near.growth, square > 0 ? 0 : root, 1e-5 * root) << text;
    ASSERT_EQ(near.frequencies.size(), 2U) << text;
    EXPECT_NEAR(near.frequencies[0], square > 0 ? middle - root : middle, 1e-5 * middle) << text;
    EXPECT_NEAR(near.frequencies[1], square > 0 ? middle + root : middle, 1e-5 * middle) << text;
  }
}

// The effective potential of the angle from the vertical: its curvature gives the nutation.
TEST(Stability, TopInSteadyPrecession) {
  Random random(402);
  int slow = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Top top(random);
    const double theta = random.uniform(0.2, 2.9), S = random.uniform(5, 200), s = std::sin(theta), c = std::cos(theta);
    const std::vector<Near> found = solved_near(top.precessing(theta, S, g));
    const std::vector<double> rates = top.precessions(theta, S, g);
    ASSERT_EQ(found.size(), rates.size()) << top.precessing(theta, S, g);
    if (rates.empty()) ++slow;
    for (std::size_t i = 0; i < rates.size(); ++i) {
      const double P = rates[i], b = top.I * (S + P * c);
      EXPECT_NEAR(found[i].unknown, P, 1e-8 * std::abs(P));
      const double curvature =
          b * b / top.J - 3 * b * c * P + top.J * P * P * (s * s + 3 * c * c) - top.m * g * top.l * c;
      EXPECT_EQ(found[i].frequencies.size(), 1U);
      expect_oscillator(found[i], curvature / top.J, top.precessing(theta, S, g));
    }
  }
  EXPECT_GT(slow, 0);
  EXPECT_LT(slow, trials / 2);
}

// About a shaft that turns at a given rate, and about one that is free to change it.
TEST(Stability, ConicalPendulum) {
  Random random(403);
  for (int trial = 0; trial < trials; ++trial) {
    const double L = random.uniform(0.2, 2), b = random.uniform(0.1, 1.4), c = std::cos(b), w = std::sqrt(g / (L * c));
    for (const bool held : {true, false}) {
      const std::string text =
          "title: a conical pendulum\n" + down_y() +
          fmt::format(
              "points: {{O: [0, 0, 0], B: [0, -{0:.17g} m, 0]}}\nbodies: {{clevis: massless, bob: {{particle: B, "
              "mass: 2 kg}}}}\njoints:\n  shaft: {{revolute: y, at: O, to: clevis, rate: {1:.17g} rad/s{2}}}\n"
              "  hinge: {{revolute: z, at: O, from: clevis, to: bob, angle: {3:.17g} rad}}\n"
              "steady: {{frame: clevis}}\nask: {{s: stable(bob), g: growth_rate(bob), f: frequencies(bob)}}\n",
              L, w, held ? ", accel: 0" : "", b);
      expect_oscillator(solved_near(text).front(), w * w * (held ? 1 - c * c : 1 + 3 * c * c), text);
    }
  }
}

TEST(Stability, BobOnACord) {
  Random random(404);
  for (int trial = 0; trial < 20; ++trial) {
    const double L = random.uniform(0.2, 2), b = random.uniform(0.1, 1.4), c = std::cos(b), w = std::sqrt(g / (L * c));
    const std::string text =
        "title: a bob on a cord\n" + down_y() +
        fmt::format(
            "points: {{O: [0, 0, 0], B: [{:.17g} m, {:.17g} m, 0]}}\nbodies: {{bob: {{particle: B, mass: 2 kg}}}}\n"
            "cords: {{cord: {{at: O, to: bob, end: B}}}}\nframes: {{figure: {{turns: y, rate: {:.17g} rad/s}}}}\n"
            "steady: {{frame: figure}}\nask: {{s: stable(bob), g: growth_rate(bob), f: frequencies(bob)}}\n",
            L * std::sin(b), -L * c, w);
    expect_oscillator(solved_near(text).front(), w * w * (1 + 3 * c * c), text);
    if (HasFailure()) return;
  }
}

// A rod or plate that hangs from a turning shaft, and the same where it has swung out.
TEST(Stability, HangingAndInclinedFromATurningClevis) {
  Random random(405);
  for (int trial = 0; trial < trials; ++trial) {
    const double L = random.uniform(0.2, 2), critical = std::sqrt(3 * g / (2 * L)),
                 w = critical * (random.chance(0.5) ? random.uniform(0.2, 0.99) : random.uniform(1.01, 3)),
                 width = random.uniform(0.1, 1);
    // Across the hinge or along it, the width changes nothing.
    const std::string shape =
        random.chance(0.5) ? fmt::format("rod: [O, [0, -{:.17g} m, 0]]", L)
                           : fmt::format(
                                 "rectangle: {{center: [0, -{:.17g} m, 0], sides: [[0, 0, {:.17g} m], [0, {:.17g} "
                                 "m, 0]]}}",
                                 L / 2, width, L);
    for (const bool inclined : {false, true}) {
      const double c = 3 * g / (2 * L * w * w);
      if (inclined && c >= 1) continue;
      const std::string text =
          "title: on a clevis\n" + down_y() + "points: {O: [0, 0, 0]}\nbodies: {clevis: massless, part: {" + shape +
          ", mass: any}}\n" +
          fmt::format(
              "joints:\n  shaft: {{revolute: y, at: O, to: clevis, rate: {:.17g} rad/s, accel: 0}}\n"
              "  hinge: {{revolute: z, at: O, from: clevis, to: part, angle: {:.17g} rad}}\n"
              "steady: {{frame: clevis}}\nask: {{s: stable(part), g: growth_rate(part), f: frequencies(part)}}\n",
              w, inclined ? std::acos(c) : 0.0);
      expect_oscillator(solved_near(text).front(), inclined ? w * w * (1 - c * c) : critical * critical - w * w, text);
    }
  }
}

// Euler's equations near a rotation about a principal axis.
TEST(Stability, FreeBodyAboutItsPrincipalAxes) {
  Random random(406);
  for (int trial = 0; trial < trials; ++trial) {
    const double A = random.uniform(1, 2), B = A * random.uniform(1.05, 1.5),
                 C = std::min(B * random.uniform(1.05, 1.5), 0.99 * (A + B)), w = random.uniform(0.5, 20);
    if (C < 1.02 * B) continue;
    const double moments[] = {A, B, C};
    for (std::size_t k = 0; k < 3; ++k) {
      const double own = moments[k], p = moments[(k + 1) % 3], q = moments[(k + 2) % 3];
      const std::string text = fmt::format(
          "title: a free body\ngravity: none\npoints: {{G: [0, 0, 0]}}\nbodies: {{body: {{mass: 2 kg, center: G, "
          "inertia: {{x: {:.17g} kg*m^2, y: {:.17g} kg*m^2, z: {:.17g} kg*m^2}}}}}}\n"
          "frames: {{figure: {{rides_on: center(body), turns: {}, rate: {:.17g} rad/s}}}}\n"
          "steady: {{frame: figure}}\ninstants: {{now: {{velocity(body): 0}}}}\n"
          "ask: {{s: stable(body), g: growth_rate(body), f: frequencies(body)}}\n",
          A, B, C, "xyz"[k], w);
      expect_oscillator(solved_near(text).front(), w * w * (own - p) * (own - q) / (p * q), text);
    }
  }
}

// A thin disk without slipping: rolling straight, and turning about its upright diameter.
TEST(Stability, RollingDiskAndSpinningCoin) {
  Random random(407);
  for (int trial = 0; trial < trials; ++trial) {
    const double r = random.uniform(0.02, 1), rolling = std::sqrt(g / (3 * r)), spinning = std::sqrt(4 * g / (5 * r)),
                 part = random.chance(0.5) ? random.uniform(0.1, 0.99) : random.uniform(1.01, 4);
    const auto text = [&](double turn, double roll) {
      return "title: a disk on a floor\n" + down_y() +
             fmt::format(
                 "points: {{C: [0, 0, 0], G: [0, {0:.17g} m, 0]}}\nbodies: {{disk: {{disk: {{center: G, normal: z, "
                 "radius: {0:.17g} m}}, mass: 2 kg}}}}\n"
                 "contacts: {{floor: {{of: disk, at: C, normal: y, no_slip: true}}}}\n"
                 "frames: {{figure: {{rides_on: center(disk), turns: y, rate: {1:.17g} rad/s}}}}\n"
                 "steady: {{frame: figure, spins: {{disk: {{about: z, rate: {2:.17g} rad/s}}}}}}\n"
                 "ask: {{s: stable(disk), g: growth_rate(disk), f: frequencies(disk), N: force(floor on disk).y}}\n",
                 r, turn, roll);
    };
    const double roll = part * rolling, turn = part * spinning;
    const Near straight = solved_near(text(0, roll)).front(), coin = solved_near(text(turn, 0)).front();
    EXPECT_NEAR(straight.push, 2 * g, 1e-9) << text(0, roll);
    EXPECT_NEAR(coin.push, 2 * g, 1e-9) << text(turn, 0);
    expect_oscillator(straight, (12 * roll * roll - 4 * g / r) / 5, text(0, roll));
    expect_oscillator(coin, turn * turn - 4 * g / (5 * r), text(turn, 0));
    if (HasFailure()) return;
  }
}

// Two hanging rods: M q'' + D q' + K q = 0, with and without damping and springs.
TEST(Stability, DoublePendulum) {
  Random random(408);
  for (int trial = 0; trial < trials; ++trial) {
    const double a = random.uniform(0.2, 1), b = random.uniform(0.2, 1), m = random.uniform(0.5, 3),
                 n = random.uniform(0.5, 3), k = random.chance(0.5) ? random.uniform(1, 20) : 0,
                 c = random.chance(0.5) ? random.uniform(0.01, 0.3) : 0;
    const std::string text =
        "title: a double pendulum\n" + down_y() +
        fmt::format(
            "points: {{O: [0, 0, 0], A: [0, {:.17g} m, 0], B: [0, {:.17g} m, 0]}}\n"
            "bodies: {{one: {{rod: [O, A], mass: {:.17g} kg}}, two: {{rod: [A, B], mass: {:.17g} kg}}}}\n"
            "joints:\n  top: {{revolute: z, at: O, to: one{}}}\n  middle: {{revolute: z, at: A, from: one, to: "
            "two{}}}\n"
            "instants: {{now: rest}}\nask: {{s: stable(system), g: growth_rate(system), f: frequencies(system)}}\n",
            -a, -a - b, m, n, k > 0 ? fmt::format(", spring: {{stiffness: {:.17g} N*m/rad}}", k) : "",
            c > 0 ? fmt::format(", damping: {:.17g} N*m*s/rad", c) : "");
    // Angles from the vertical.
    Eigen::Matrix2d M, K, D;
    M << m * a * a / 3 + n * a * a, n * a * b / 2, n * a * b / 2, n * b * b / 3;
    K << (m / 2 + n) * g * a + k, 0, 0, n * g * b / 2;
    D << c, -c, -c, c;
    Eigen::Matrix4d state = Eigen::Matrix4d::Zero();
    state.topRightCorner<2, 2>().setIdentity();
    state.bottomLeftCorner<2, 2>() = -M.inverse() * K;
    state.bottomRightCorner<2, 2>() = -M.inverse() * D;
    const Eigen::Vector4cd values = state.eigenvalues();
    const Near near = solved_near(text).front();
    EXPECT_TRUE(near.stable) << text;
    EXPECT_EQ(near.growth, 0) << text;
    std::vector<double> expected;
    for (Eigen::Index i = 0; i < 4; ++i)
      if (values[i].imag() > 1e-6) expected.push_back(values[i].imag());
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(near.frequencies.size(), expected.size()) << text;
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(near.frequencies[i], expected[i], 1e-6 * expected[i]) << text;
  }
}

// J q'' + c q' + (k - m g l cos of the tilt) q = 0: hanging, upright, and damped more than it can swing.
TEST(Stability, PendulumWithATorsionSpringAndABrake) {
  Random random(409);
  for (int trial = 0; trial < trials; ++trial) {
    const double L = random.uniform(0.2, 2), m = random.uniform(0.5, 3), J = m * L * L / 3, k = random.uniform(0, 30),
                 c = random.uniform(0, 5), side = random.chance(0.5) ? 1 : -1, stiffness = k + side * m * g * L / 2;
    const std::string text =
        "title: a pendulum\n" + down_y() +
        fmt::format(
            "points: {{O: [0, 0, 0], A: [0, {:.17g} m, 0]}}\nbodies: {{bar: {{rod: [O, A], mass: {:.17g} kg}}}}\n"
            "joints: {{pin: {{revolute: z, at: O, to: bar, spring: {{stiffness: {:.17g} N*m/rad}}, damping: {:.17g} "
            "N*m*s/rad}}}}\ninstants: {{now: rest}}\n"
            "ask: {{s: stable(bar), g: growth_rate(bar), f: frequencies(bar)}}\n",
            -side * L, m, k, c);
    const Near near = solved_near(text).front();
    const double square = stiffness / J - c * c / (4 * J * J);
    if (std::abs(stiffness) < 1e-3 || std::abs(square) < 1e-3) continue;
    EXPECT_EQ(near.stable, stiffness > 0) << text;
    EXPECT_NEAR(near.growth, stiffness > 0 ? 0 : std::sqrt(-square) - c / (2 * J), 1e-6) << text;
    ASSERT_EQ(near.frequencies.size(), square > 0 ? 1U : 0U) << text;
    if (square > 0) {
      EXPECT_NEAR(near.frequencies[0], std::sqrt(square), 1e-6 * std::sqrt(square)) << text;
    }
  }
}

// Where a frame carries all that is there nothing can deviate.
TEST(Stability, WhatIsCarriedByItsFrameHasNoModes) {
  const SolvedText solved(
      "title: t\npoints: {O: [-1 m, 0, 0], C: [0, 0, 0], D: [1 m, 1 m, 0]}\nbodies: {bar: {rod: [C, D], mass: 2 "
      "kg}}\nframes: {table: {origin: O, turns: z, rate: 2 rad/s}}\njoints: {held: {weld: C, from: table, to: bar}}\n"
      "gravity: -z\nsteady: {frame: table}\nask: {F: force(held on bar), f: frequencies(bar), s: stable(bar)}\n");
  // m w^2 r to the axis, and the weight.
  const Vector3<double> F = solved.vector("F");
  EXPECT_NEAR(F.x, -2 * 4 * 1.5, 1e-12);
  EXPECT_NEAR(F.y, -2 * 4 * 0.5, 1e-12);
  EXPECT_NEAR(F.z, 2 * 9.80665, 1e-12);
  EXPECT_TRUE(solved.found("f").value.items.empty());
  EXPECT_TRUE(solved.found("s").value.truth);
}

}  // namespace stability_test
}  // namespace poinsot::problem
