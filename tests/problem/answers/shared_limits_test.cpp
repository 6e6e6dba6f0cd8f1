// Limits of sticking where several contacts share what they carry, in a plane and in space.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace shared_limits_test {

constexpr double g = 9.80665;

double limit(const std::string& text) {
  const SolvedStatement solved = solve_statement(read_statement(text, "test.yaml"), {});
  const SolvedAsk& ask = solved.solutions.at(0).asks.at(0);
  EXPECT_EQ(ask.state, AskState::found) << ask.reason;
  return ask.value.number;
}

// The wedge of examples/mechanisms/wedge-under-a-block.yaml in space: each contact has a cone, and what holds the
// bodies in their plane shares what goes across it.
std::string wedge(bool in_space, const char* under_the_left, double a, double h, double W) {
  const std::string z = in_space ? ", 0" : "";
  return std::string(in_space ? "" : "plane: [x, y]\n") +
         fmt::format(
             "given: {{W: {4} N, a: {2} rad, mu: 0.3, P: 300 N, h: {3} m}}\n"
             "points: {{A: [0, h{0}], B: [1 m, 'h - (1 m)*tan(a)'{0}], D: [1 m, 1 m{0}], E: [0, 1 m{0}], F: [0, 0{0}], "
             "K: [1 m, 0{0}]}}\n"
             "directions: {{n: [sin(a), cos(a){0}]}}\n"
             "bodies:\n  block: {{polygon: [A, B, D, E], mass: 1 kg}}\n"
             "  wedge: {{polygon: [A, F, K, B], mass: 1 kg}}\n"
             "contacts:\n  upper: {{of: block, corner: D, normal: -x, friction: mu}}\n"
             "  left: {{of: block, corner: A, {1}normal: n, friction: mu}}\n"
             "  right: {{of: block, corner: B, against: wedge, normal: n, friction: mu}}\n"
             "  heel: {{of: wedge, corner: F, normal: y, friction: mu}}\n"
             "  toe: {{of: wedge, corner: K, normal: y, friction: mu}}\n"
             "loads:\n  weight: {{force: [0, -W{0}], at: [0.5 m, 0.7 m{0}], body: block}}\n"
             "  push: {{force: [P, 0{0}], at: [0, h/2{0}], body: wedge}}\ngravity: none\n"
             "ask:\n  lifts:\n    largest: P\n    while: [sticking(left), sticking(right), sticking(heel), "
             "sticking(toe), sticking(upper)]\n",
             z, under_the_left, a, h, W) +
         (in_space ? "joints: {of_block: {planar: z, at: A, to: block}, of_wedge: {planar: z, at: A, to: wedge}}\n"
                   : "");
}

TEST(SharedLimits, of_a_wedge_are_the_same_in_space) {
  // The ground under the left corner: by scipy's linear program (HiGHS, tolerances 1e-10).
  constexpr double by_program = 509.99987814605714, degree = 3.141592653589793 / 180;
  for (const bool in_space : {false, true})
    EXPECT_NEAR(limit(wedge(in_space, "", 6.472 * degree, 0.302, 2147)), by_program, 1e-9 * by_program) << in_space;
  // The wedge under both corners: by the polygons of forces, with f = atan mu.
  const double a = 8 * degree, f = std::atan(0.3),
               closed = 2000 * (std::tan(a + f) + std::tan(f)) / (1 - std::tan(f) * std::tan(a + f));
  for (const bool in_space : {false, true})
    EXPECT_NEAR(limit(wedge(in_space, "against: wedge, ", a, 0.4, 2000)), closed, 1e-10 * closed) << in_space;
}

std::string stool(const double (&feet)[3][2], double x, double y, double d, const char* ask) {
  return fmt::format(
      "given: {{m: 10 kg, mu: 0.3, P: 5 N}}\n"
      "points: {{A: ['{} m', '{} m', 0], B: ['{} m', '{} m', 0], C: ['{} m', '{} m', 0], G: ['{} m', '{} m', 0.4 m], "
      "Q: [0, '{} m', 0]}}\n"
      "bodies:\n  stool: {{mass: m, center: G, inertia: {{axis: z, axial: 1 kg*m^2, transverse: 1 kg*m^2}}}}\n"
      "contacts:\n  a: {{of: stool, corner: A, normal: z, friction: mu}}\n"
      "  b: {{of: stool, corner: B, normal: z, friction: mu}}\n"
      "  c: {{of: stool, corner: C, normal: z, friction: mu}}\n"
      "loads: {{push: {{force: [P, 0, 0], at: Q, body: stool}}}}\ngravity: -z\ninstants: {{now: rest}}\n"
      "ask: {{limit: {{{}, while: [sticking(a), sticking(b), sticking(c)]}}}}\n",
      feet[0][0], feet[0][1], feet[1][0], feet[1][1], feet[2][0], feet[2][1], x, y, d, ask);
}

// A stool on three feet that is pushed at the height of the floor turns about some point as it begins to slide. By the
// theorem of upper bounds the limit is the least power of friction over all velocities in which the push has the power
// one per newton: with the turning w and the velocity u across the push it is convex.
double by_velocities(const double (&feet)[3][2], double x, double y, double d, double mu, double weight) {
  // The pushes carry the weight.
  const auto turned = [&](int i, int j) {
    return (feet[i][0] - x) * (feet[j][1] - y) - (feet[i][1] - y) * (feet[j][0] - x);
  };
  const double whole = turned(0, 1) + turned(1, 2) + turned(2, 0);
  const double push[3] = {weight * turned(1, 2) / whole, weight * turned(2, 0) / whole, weight * turned(0, 1) / whole};
  const auto power = [&](double w, double u) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += mu * push[i] * std::hypot(1 + w * (d - feet[i][1]), u + w * feet[i][0]);
    return sum;
  };
  const auto least = [](double low, double high, const auto& of) {
    for (int i = 0; i < 200; ++i) {
      const double left = low + (high - low) / 3, right = high - (high - low) / 3;
      (of(left) < of(right) ? high : low) = of(left) < of(right) ? right : left;
    }
    return of((low + high) / 2);
  };
  return least(-50, 50, [&](double w) { return least(-50, 50, [&](double u) { return power(w, u); }); });
}

TEST(SharedLimits, of_a_stool_are_those_of_the_velocities_in_which_it_could_slide) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  for (int n = 0; n < 6; ++n) {
    const double feet[3][2] = {{0.5 + uniform(random), uniform(random)},
                               {-0.3 + uniform(random), 0.4 + uniform(random)},
                               {-0.2 + uniform(random), -0.5 + uniform(random)}};
    const double x = uniform(random), y = uniform(random), d = 3 * uniform(random);
    const double expected = by_velocities(feet, x, y, d, 0.3, 10 * g);
    EXPECT_NEAR(limit(stool(feet, x, y, d, "largest: P")), expected, 1e-9 * expected) << n;
    // The least friction that holds a push of 5 N is as much less as the push.
    const double least = 0.3 * 5 / expected;
    EXPECT_NEAR(limit(stool(feet, x, y, d, "smallest: mu")), least, 1e-9 * least) << n;
  }
}

// On a slope all feet slide down alike, however they share the weight.
TEST(SharedLimits, of_a_table_on_a_slope_are_those_of_a_block) {
  for (const double b : {0.1, 0.3}) {
    const std::string text = fmt::format(
        "given: {{m: 10 kg, mu: 0.9, b: {} rad}}\n"
        "points: {{A: [0.5 m, 0.3 m, 0], B: [-0.5 m, 0.3 m, 0], C: [-0.5 m, -0.4 m, 0], D: [0.5 m, -0.3 m, 0], "
        "G: [0.05 m, 0.02 m, 0.2 m]}}\n"
        "directions: {{down: [sin(b), 0, -cos(b)]}}\n"
        "bodies:\n  table: {{mass: m, center: G, inertia: {{axis: z, axial: 1 kg*m^2, transverse: 1 kg*m^2}}}}\n"
        "contacts:\n  a: {{of: table, corner: A, normal: z, friction: mu}}\n"
        "  b: {{of: table, corner: B, normal: z, friction: mu}}\n  c: {{of: table, corner: C, normal: z, friction: "
        "mu}}\n"
        "  d: {{of: table, corner: D, normal: z, friction: mu}}\n"
        "gravity: down\ninstants: {{now: rest}}\n"
        "ask: {{least: {{smallest: mu, while: [sticking(a), sticking(b), sticking(c), sticking(d)]}}}}\n",
        b);
    EXPECT_NEAR(limit(text), std::tan(b), 1e-10 * std::tan(b));
  }
}

}  // namespace shared_limits_test
}  // namespace poinsot::problem
