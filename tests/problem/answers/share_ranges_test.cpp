// Forces that contacts share are told with their range, held against all corners of what the shares can be.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace share_ranges_test {

struct Foot {
  double x = 0, y = 0;
};
struct Range {
  double least = 0, largest = 0;
};

// A plate that lies on feet under its weight and a force downwards at a point: the sum of the feet's forces and two
// moments are given. Each corner of what they can be has three that push, and all others carry nothing.
Range over_corners(const std::vector<Foot>& feet, std::size_t asked, double weight, double force, Foot at) {
  const double sum = weight + force, along_x = force * at.x, along_y = force * at.y;
  Range range{INFINITY, -INFINITY};
  const std::size_t n = feet.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) {
        const Foot &a = feet[i], &b = feet[j], &c = feet[k];
        const double whole = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if (std::abs(whole) < 1e-9) continue;
        // Barycentric coordinates of the point at which the load acts.
        const double px = along_x / sum, py = along_y / sum;
        const double of_b = ((px - a.x) * (c.y - a.y) - (c.x - a.x) * (py - a.y)) / whole,
                     of_c = ((b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y)) / whole, of_a = 1 - of_b - of_c;
        if (std::min({of_a, of_b, of_c}) < -1e-12) continue;
        const double carries = asked == i ? of_a : asked == j ? of_b : asked == k ? of_c : 0;
        range = {std::min(range.least, sum * carries), std::max(range.largest, sum * carries)};
      }
  return range;
}

std::string plate(const std::vector<Foot>& feet, double mass, double force, Foot at, const std::string& ask) {
  std::string text =
      "points: {G: [0, 0, 0.1 m], P: [" + std::to_string(at.x) + " m, " + std::to_string(at.y) + " m, 0.2 m]";
  for (std::size_t k = 0; k < feet.size(); ++k)
    text +=
        ", A" + std::to_string(k) + ": [" + std::to_string(feet[k].x) + " m, " + std::to_string(feet[k].y) + " m, 0]";
  text += "}\nbodies: {plate: {box: {center: G, sides: [2 m * x, 2 m * y, 0.2 m * z]}, mass: " + std::to_string(mass) +
          " kg}}\ncontacts:\n";
  for (std::size_t k = 0; k < feet.size(); ++k)
    text += "  c" + std::to_string(k) + ": {of: plate, against: ground, at: A" + std::to_string(k) +
            ", normal: z, carries: [z]}\n";
  text += "loads: {f: {force: '[0, 0, " + std::to_string(-force) + " N]', body: plate, at: P}}\n";
  return text + "gravity: -z\nfacts: rest\nask: {" + ask + "}\n";
}

SolvedAsk asked(const std::string& text) {
  return solve_statement(read_statement(text, "test.yaml"), {}).solutions.at(0).asks.at(0);
}

TEST(ShareRanges, are_those_of_all_corners) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1), load(0, 30);
  const std::regex between("it lies between ([-0-9.e+]+) and ([-0-9.e+]+) N");
  int told = 0;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<Foot> feet;
    const std::size_t count = 4 + static_cast<std::size_t>(trial % 3);
    const auto rounded = [&] { return std::round(1e3 * place(random)) / 1e3; };
    for (std::size_t k = 0; k < count; ++k) feet.push_back({rounded(), rounded()});
    const Foot at{rounded() / 2, rounded() / 2};
    const double force = std::round(load(random)), weight = 5 * 9.80665;
    const std::size_t which = static_cast<std::size_t>(trial) % count;
    const Range right = over_corners(feet, which, weight, force, at);
    if (!(right.largest - right.least > 1e-3)) continue;  // it falls over, or the force is one
    const SolvedAsk ask = asked(plate(feet, 5, force, at, "N: force(c" + std::to_string(which) + " on plate).z"));
    ASSERT_EQ(ask.state, AskState::undetermined) << ask.reason;
    std::smatch found;
    ASSERT_TRUE(std::regex_search(ask.reason, found, between)) << ask.reason;
    EXPECT_NEAR(std::stod(found[1]), right.least, 1e-5 * (weight + force)) << ask.reason;
    EXPECT_NEAR(std::stod(found[2]), right.largest, 1e-5 * (weight + force)) << ask.reason;
    ++told;
  }
  EXPECT_GE(told, 10);
}

const std::vector<Foot> corners{{1, 1}, {1, -1}, {-1, -1}, {-1, 1}};

TEST(ShareRanges, are_in_the_unit_of_the_answer_and_by_components) {
  const SolvedAsk in_unit = asked(plate(corners, 10, 0, {0, 0}, "N: {of: 'force(c0 on plate).z', unit: kN}"));
  EXPECT_EQ(in_unit.state, AskState::undetermined);
  EXPECT_NE(in_unit.reason.find("as none of them pulls, it lies between 0 and 0.0490333 kN"), std::string::npos)
      << in_unit.reason;
  const SolvedAsk vector = asked(plate(corners, 10, 0, {0, 0}, "N: force(c0 on plate)"));
  EXPECT_NE(vector.reason.find(".z lies between 0 and 49.0333 N"), std::string::npos) << vector.reason;
}

TEST(ShareRanges, of_sums_are_those_of_the_sum) {
  // Two corners on one side carry half of the weight together, which is determined; two across a diagonal do not.
  const SolvedAsk side = asked(plate(corners, 10, 0, {0, 0}, "N: 'force(c0 on plate).z + force(c1 on plate).z'"));
  EXPECT_EQ(side.state, AskState::found) << side.reason;
  const SolvedAsk diagonal = asked(plate(corners, 10, 0, {0, 0}, "N: 'force(c0 on plate).z + force(c2 on plate).z'"));
  EXPECT_NE(diagonal.reason.find("it lies between 0 and 98.0665 N"), std::string::npos) << diagonal.reason;
}

TEST(ShareRanges, begin_at_zero_where_nothing_presses) {
  // A bevel gear on a turning arm: the bearing of the arm can hold it down on the fixed gear as hard as it likes.
  const SolvedAsk mesh = asked(
      "points: {O: [0, 0, 0], G: [8 in, 0, 0], C: [8 in, -4 in, 0]}\n"
      "bodies: {arm: massless, gear: {disk: {center: G, normal: x, radius: 4 in}, weight: 6 lb}}\n"
      "joints:\n  column: {revolute: y, at: O, to: arm, rate: 90 rpm, accel: 0}\n"
      "  pin: {revolute: x, at: G, from: arm, to: gear}\n"
      "contacts: {mesh: {of: gear, at: C, normal: y, no_slip: true, carries: [push]}}\n"
      "gravity: -y\nask: {N: force(mesh on gear).y}\n");
  EXPECT_NE(mesh.reason.find("as none of them pulls, it is 0 lb or more"), std::string::npos) << mesh.reason;
}

TEST(ShareRanges, nothing_is_said_of_what_nothing_bounds) {
  // Squares of forces are not linear.
  const SolvedAsk square = asked(plate(corners, 10, 0, {0, 0}, "N: 'force(c0 on plate).z^2'"));
  EXPECT_EQ(square.state, AskState::undetermined);
  EXPECT_EQ(square.reason.find("none of them pulls"), std::string::npos) << square.reason;
}

}  // namespace share_ranges_test
}  // namespace poinsot::problem
