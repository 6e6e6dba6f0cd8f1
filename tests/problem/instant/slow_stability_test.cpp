// Slow growth and slow swings beside a fast rotor, against closed forms.
#include <gtest/gtest.h>

#include "problem/instant/near_steady.h"

namespace poinsot::problem {
namespace slow_stability_test {

using namespace testing;

double of_any_size(Random& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

// A pendulum with a wheel at its end on an axle along the hinge: the wheel's spin changes nothing.
TEST(SlowStability, PendulumWithAFlywheel) {
  Random random(431);
  for (int trial = 0; trial < 200; ++trial) {
    // Beyond all wheels, rounding of their centers pulls as much as the weights do.
    const bool extreme = trial % 4 == 0;
    const double L = of_any_size(random, 0.1, extreme ? 100 : 10), w = of_any_size(random, 1, extreme ? 1e7 : 1e4),
                 g = of_any_size(random, extreme ? 1e-2 : 1, 10), m = random.uniform(0.5, 2),
                 M = random.uniform(0.5, 2);
    const bool upright = random.chance(0.5);
    const std::string text = fmt::format(
        "title: a pendulum with a flywheel\npoints: {{O: [0, 0, 0], T: [0, {:.17g} m, 0]}}\nbodies:\n"
        "  rod: {{rod: [O, T], mass: {:.17g} kg}}\n"
        "  wheel: {{disk: {{center: T, normal: z, radius: 0.1 m}}, mass: {:.17g} kg}}\njoints:\n"
        "  pin: {{revolute: z, at: O, to: rod, angle: a}}\n"
        "  axle: {{revolute: z, at: T, from: rod, to: wheel, rate: {:.17g} rad/s}}\n"
        "gravity: [0, -{:.17g} m/s^2, 0]\n"
        "steady: {{frame: ground, spins: {{wheel: {{about: z, rate: {:.17g} rad/s}}}}}}\n"
        "ask: {{s: stable(rod), g: growth_rate(rod), f: frequencies(rod)}}\n",
        upright ? L : -L, m, M, w, g, w);
    const double rate = std::sqrt((m / 2 + M) * g / ((m / 3 + M) * L));
    const Near near = solved_near(text).front();
    if (extreme) {
      EXPECT_FALSE(near.stable && upright) << text;
    } else {
      EXPECT_EQ(near.stable, !upright) << text;
    }
    if (extreme) continue;
    if (upright) {
      EXPECT_NEAR(near.growth, rate, 1e-4 * rate) << text;
    } else {
      EXPECT_EQ(near.growth, 0) << text;
      ASSERT_EQ(near.frequencies.size(), 1U) << text << near.list();
      EXPECT_NEAR(near.frequencies[0], rate, 1e-4 * rate) << text;
    }
    if (HasFailure()) return;
  }
}

// (n C - H)(H - n A) / (A C) is the square of the growth about the axis y of a body that carries a wheel along it, with
// the moment of momentum H.
TEST(SlowStability, SatelliteWithAMomentumWheel) {
  Random random(432);
  int unstable = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const double A = random.uniform(200, 300), C = random.uniform(350, 400),
                 B = random.chance(0.5) ? random.uniform(A + 10, C - 10) : random.uniform(C + 10, A + C - 10),
                 n = of_any_size(random, 1e-5, 1), w = of_any_size(random, 1, 1e4), i = 1e-7 * n * B / w * 1e4;
    const std::string text = fmt::format(
        "title: a satellite with a wheel\npoints: {{G: [0, 0, 0]}}\nbodies:\n"
        "  sat: {{mass: 500 kg, center: G, inertia: {{x: {:.17g} kg*m^2, y: {:.17g} kg*m^2, z: {:.17g} kg*m^2}}}}\n"
        "  wheel: {{mass: 1e-3 kg, center: G, inertia: {{axis: y, axial: {:.17g} kg*m^2, transverse: {:.17g} "
        "kg*m^2}}}}\n"
        "joints: {{axle: {{revolute: y, at: G, from: sat, to: wheel, rate: {:.17g} rad/s, accel: 0}}}}\n"
        "frames: {{turning: {{turns: y, rate: {:.17g} rad/s, rides_on: center(sat)}}}}\ngravity: none\n"
        "steady: {{frame: turning, spins: {{wheel: {{about: y, rate: {:.17g} rad/s}}}}}}\n"
        "ask: {{s: stable(sat), g: growth_rate(sat), f: frequencies(sat)}}\n",
        A, B, C, i, 0.6 * i, w, n, w);
    const double a = A + 0.6 * i, c = C + 0.6 * i, H = (B + i) * n + i * w;
    const double square = (n * c - H) * (H - n * a) / (a * c), rate = std::sqrt(std::abs(square));
    const Near near = solved_near(text).front();
    unstable += square > 0;
    EXPECT_EQ(near.stable, square < 0) << text;
    EXPECT_NEAR(near.growth, square > 0 ? rate : 0, 1e-4 * rate) << text;
    if (square < 0) {
      EXPECT_TRUE(near.swings_at(rate)) << rate << near.list() << text;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(unstable, 50);
}

// At the critical spin two frequencies meet, and nothing computed tells on which side it stands.
TEST(SlowStability, NothingIsSaidAtTheCriticalSpin) {
  Random random(433);
  for (int trial = 0; trial < 50; ++trial) {
    const Top top(random);
    const double S = std::sqrt(4 * top.J * top.m * 9.81 * top.l) / top.I;
    const std::string text = "title: a sleeping top\ngravity: [0, 0, -9.81 m/s^2]\n" + top.text({0, 0, 1}) +
                             fmt::format(
                                 "steady: {{frame: ground, spins: {{top: {{about: O->G, rate: {:.17g} rad/s}}}}}}\n"
                                 "ask: {{s: stability(top)}}\n",
                                 S);
    const Statement statement = read_statement(text, "test.yaml");
    const SolvedAsk ask = solve_statement(statement, {}).solutions.front().asks.front();
    ASSERT_EQ(ask.state, AskState::found) << ask.reason << text;
    EXPECT_EQ(ask.value.text.substr(0, 9), "undecided") << text;
    if (HasFailure()) return;
  }
}

}  // namespace slow_stability_test
}  // namespace poinsot::problem
