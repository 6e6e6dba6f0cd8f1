// Derivatives of the answers of many cases against closed forms, by every road.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "poinsot/cases.h"
#include "poinsot/problem.h"

namespace poinsot {
namespace case_sensitivities_test {

constexpr double g = 9.80665;

std::vector<std::string> names_of(const std::vector<CaseColumn>& columns) {
  std::vector<std::string> names;
  for (const CaseColumn& column : columns) names.push_back(column.name);
  return names;
}

Problem ball_on_cord() {
  return Problem::from_text(
      "title: Ball on a cord at the top of its circle\ngiven: {m: 2 kg, L: 1.2 m, v: 5 m/s}\n"
      "points: {O: [0, 0, 0], P: [0, L, 0]}\nbodies: {ball: {particle: P, mass: m}}\n"
      "cords: {c: {from: ground, at: O, to: ball, end: P}}\ngravity: -y\n"
      "instants: {top: {velocity(ball): [v, 0, 0]}}\nask: {S: tension(c), p: momentum(ball)}\n",
      "cord.yaml");
}

// S = m (v^2/L - g), by formulas and by the equations of the instant.
TEST(CaseSensitivities, OfFormulasAndOfInstants) {
  const Problem problem = ball_on_cord();
  for (const bool formulas : {true, false}) {
    const Cases cases = problem.cases({.over = {"v", "m", "L"},
                                       .asks = {},
                                       .first = {5.0, 2.0, 1.2},
                                       .formulas = formulas,
                                       .sensitivities = {"L", "v"}});
    EXPECT_EQ(names_of(cases.columns()),
              (std::vector<std::string>{"S", "p.x", "p.y", "p.z", "S by L", "p.x by L", "p.y by L", "p.z by L",
                                        "S by v", "p.x by v", "p.y by v", "p.z by v"}));
    EXPECT_EQ(cases.columns()[4].unit, "N/m");
    EXPECT_EQ(cases.columns()[8].unit, "kg/s");
    const std::vector<double> v{5, 6, 9}, m{2, 1, 4}, L{1.2, 0.7, 2};
    // Row 0 of a study is compared with differences of full solutions.
    const CaseRows found = cases.solve({v, m, L}, 0);
    EXPECT_EQ(found.checked, 1U);
    EXPECT_EQ(found.refuted, 0U);
    for (std::size_t row = 0; row < v.size(); ++row) {
      EXPECT_EQ(found.roads[row], formulas ? CaseRoad::by_formula : CaseRoad::by_instant);
      EXPECT_NEAR(found.columns[0][row], m[row] * (v[row] * v[row] / L[row] - g), 1e-11);
      EXPECT_NEAR(found.columns[4][row], -m[row] * v[row] * v[row] / (L[row] * L[row]), 1e-11);
      EXPECT_NEAR(found.columns[8][row], 2 * m[row] * v[row] / L[row], 1e-11);
      EXPECT_NEAR(found.columns[9][row], m[row], 1e-13);
      EXPECT_NEAR(found.columns[5][row], 0, 1e-13);
    }
  }
}

// A rod on a turning shaft held by a spring: k b + m g L/2 sin b = m L^2/3 n^2 sin b cos b has no closed form, but its
// derivatives have.
TEST(CaseSensitivities, OfUnknowns) {
  const Problem problem = Problem::from_text(
      "title: Rod on a turning shaft, held by a spring\n"
      "given: {m: 2 kg, L: 0.6 m, k: 3 N*m/rad, n: 90 rpm}\nfind: {b: deg}\nwhere: [5 deg < b < 85 deg]\n"
      "gravity: -y\npoints: {A: [0, 0, 0], G: \"L/2*[sin(b), -cos(b), 0]\", B: \"L*[sin(b), -cos(b), 0]\"}\n"
      "frames: {shaft: {origin: A, turns: y, rate: n}}\nbodies: {rod: {rod: [A, B], mass: m}}\n"
      "joints: {hinge: {revolute: z, at: A, from: shaft, to: rod, rate: 0, accel: 0}}\n"
      "loads: {spring: {body: rod, couple: [0, 0, -k*b]}}\n"
      "facts: {\"couple(hinge on rod about A).z\": 0 N*m}\n"
      "ask: {angle: b, S: \"force(hinge on rod)\"}\n",
      "governor.yaml");
  const Cases cases = problem.cases({.over = {"n", "k"}, .asks = {}, .first = {9.4, 3.0}, .sensitivities = {"n", "k"}});
  ASSERT_EQ(cases.no_program(), "");
  const std::vector<double> speeds{9.4, 9, 10.5}, springs{3, 2.5, 2};
  const CaseRows found = cases.solve({speeds, springs}, 0);
  EXPECT_EQ(found.checked, 1U);
  EXPECT_EQ(found.refuted, 0U);
  const double m = 2, L = 0.6;
  for (std::size_t row = 0; row < speeds.size(); ++row) {
    ASSERT_EQ(found.roads[row], CaseRoad::by_instant);
    const double n = speeds[row], k = springs[row], b = found.columns[0][row], I = m * L * L / 3;
    const double by_b = k + m * g * L / 2 * std::cos(b) - I * n * n * std::cos(2 * b);
    const double by_n = I * n * std::sin(2 * b) / by_b, by_k = -b / by_b;
    EXPECT_NEAR(found.columns[4][row], by_n, 1e-9 * std::abs(by_n));
    EXPECT_NEAR(found.columns[8][row], by_k, 1e-9 * std::abs(by_k));
    // The force across is m n^2 L/2 sin b towards the shaft.
    const double across_by_n = -m * L / 2 * (2 * n * std::sin(b) + n * n * std::cos(b) * by_n);
    const double across_by_k = -m * L / 2 * n * n * std::cos(b) * by_k;
    EXPECT_NEAR(found.columns[5][row], across_by_n, 1e-9 * std::abs(across_by_n));
    EXPECT_NEAR(found.columns[9][row], across_by_k, 1e-9 * std::abs(across_by_k));
  }
}

// A ball thrown up: what a motion leads to is differentiated by differences. Where it turns into another regime there
// are none, and the row says so.
TEST(CaseSensitivities, OfMotionsByDifferences) {
  const Problem problem = Problem::from_text(
      "title: Ball thrown up\ngiven: {m: 2 kg, v: 12 m/s}\npoints: {P: [0, 0, 0]}\n"
      "bodies: {ball: {particle: P, mass: m}}\ngravity: -y\ninstants: {start: {velocity(ball): [0, v, 0]}}\n"
      "ask: {y: position(ball).y @ 2 s, off: abs(position(ball).y @ 2 s)}\n",
      "thrown.yaml");
  const Cases cases = problem.cases(
      {.over = {"v", "m"}, .asks = {}, .first = {12.0, 2.0}, .formulas = false, .sensitivities = {"v", "m"}});
  const std::vector<double> speeds{12, 2, g}, masses{2, 1, 1};
  const CaseRows found = cases.solve({speeds, masses}, 1);
  for (const std::size_t row : {0U, 1U}) {
    EXPECT_EQ(found.roads[row], CaseRoad::in_full);
    EXPECT_NEAR(found.columns[0][row], 2 * speeds[row] - 2 * g, 1e-9);
    EXPECT_NEAR(found.columns[2][row], 2, 1e-6);
    EXPECT_NEAR(found.columns[3][row], row == 0 ? 2 : -2, 1e-6);
    EXPECT_NEAR(found.columns[4][row], 0, 1e-6);
  }
  // There the height is zero, and its size has a corner.
  ASSERT_EQ(found.reasons.size(), 1U);
  EXPECT_EQ(found.reasons.front().first, 2U);
  EXPECT_TRUE(found.reasons.front().second.find("by v: differences do not settle on how off changes") == 0)
      << found.reasons.front().second;
}

TEST(CaseSensitivities, Mistakes) {
  const Problem problem = ball_on_cord();
  EXPECT_THROW(problem.cases({.over = {"v"}, .asks = {}, .first = {5.0}, .sensitivities = {"m"}}),
               std::invalid_argument);
  const Problem drop = Problem::from_text(
      "title: Ball let go\ngiven: {v: 0 m/s}\npoints: {P: [0, 0, 0]}\nbodies: {ball: {particle: P, mass: 1 kg}}\n"
      "gravity: -y\ninstants: {start: {velocity(ball): [v, 0, 0]}}\nask: {x: position(ball).x @ 2 s}\n",
      "drop.yaml");
  const Cases cases =
      drop.cases({.over = {"v"}, .asks = {}, .first = {0.0}, .formulas = false, .sensitivities = {"v"}});
  const std::vector<double> still{0};
  const CaseRows found = cases.solve({still}, 1);
  ASSERT_EQ(found.reasons.size(), 1U);
  EXPECT_EQ(found.reasons.front().second,
            "by v: it is not known how large changes of 'v' are: it is zero here, and no other size of it is known");
  const Cases sized = drop.cases(
      {.over = {"v"}, .asks = {}, .first = {0.0}, .formulas = false, .sensitivities = {"v"}, .usual = {3.0}});
  const CaseRows differentiated = sized.solve({still}, 1);
  EXPECT_TRUE(differentiated.reasons.empty());
  EXPECT_NEAR(differentiated.columns[1][0], 2, 1e-6);
}

}  // namespace case_sensitivities_test
}  // namespace poinsot
