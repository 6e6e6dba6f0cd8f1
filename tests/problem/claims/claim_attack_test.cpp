// Claims that fail far from ordinary values only, or at the edges of what bodies can be, are refuted there.
#include "problem/claims/claim_attack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "case_count.h"
#include "poinsot/engine/work/work.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace claim_attack_test {

constexpr double degree = 3.141592653589793 / 180;

// A free body of three moments of inertia, with the letters in some order.
SolvedClaim of_free_body(const std::string& claim, const std::vector<int>& order = {0, 1, 2, 3, 4, 5}) {
  const std::vector<std::string> letters{"A: kg*m^2",          "B: kg*m^2",          "C: kg*m^2",
                                         "p: {signed: rad/s}", "q: {signed: rad/s}", "r: {signed: rad/s}"};
  std::string listed;
  for (const int k : order) listed += (listed.empty() ? "" : ", ") + letters[static_cast<std::size_t>(k)];
  const Statement statement = read_statement("letters: {" + listed +
                                                 "}\n"
                                                 "points: {G: [0, 0, 0]}\n"
                                                 "bodies: {b: {mass: 3 kg, center: G, inertia: {x: A, y: B, z: C, xy: "
                                                 "0, yz: 0, zx: 0}}}\n"
                                                 "gravity: none\nfacts: {angular_velocity(b): [p, q, r]}\n"
                                                 "define: {H: angular_momentum(b about G), w: angular_velocity(b)}\n"
                                                 "claim: {a: \"" +
                                                 claim + "\"}\n",
                                             "body.yaml");
  return solve_statement(statement, {}).solutions.at(0).claims.at(0);
}

std::map<std::string, double> numbers_of(const SolvedClaim& claim) {
  std::map<std::string, double> numbers;
  for (const SolvedClaim::Datum& datum : claim.counterexample) numbers[datum.name] = datum.value;
  return numbers;
}

// The angular momentum of a body comes as near to a right angle with its angular velocity as its axial moment is small
// beside two equal ones, and not beyond: the counterexample is that of a body that can be.
TEST(ClaimAttack, angles_of_momentum_are_found_up_to_a_right_angle) {
  std::mt19937_64 random(8300);
  for (int n = 0; n < testing::case_count(6); ++n) {
    const double most = std::uniform_real_distribution<double>(40, 88)(random);
    const SolvedClaim claim = of_free_body("angle(H to w) < " + std::to_string(most) + " deg");
    ASSERT_EQ(claim.state, AskState::found) << claim.reason;
    ASSERT_FALSE(claim.holds) << most;
    const std::map<std::string, double> at = numbers_of(claim);
    const double I[3] = {at.at("A"), at.at("B"), at.at("C")}, w[3] = {at.at("p"), at.at("q"), at.at("r")};
    double product = 0, momentum = 0, rate = 0;
    for (int k = 0; k < 3; ++k) {
      product += I[k] * w[k] * w[k];
      momentum += I[k] * w[k] * I[k] * w[k];
      rate += w[k] * w[k];
      EXPECT_LE(I[k], (I[(k + 1) % 3] + I[(k + 2) % 3]) * (1 + 1e-12));
    }
    EXPECT_GE(std::acos(product / std::sqrt(momentum * rate)), most * degree * (1 - 1e-9)) << most;
  }
}

TEST(ClaimAttack, what_is_true_still_holds) { EXPECT_TRUE(of_free_body("angle(H to w) < 90 deg").holds); }

TEST(ClaimAttack, the_order_of_letters_has_no_part_in_it) {
  std::vector<int> order{0, 1, 2, 3, 4, 5};
  std::mt19937_64 random(8400);
  const std::map<std::string, double> first = numbers_of(of_free_body("angle(H to w) < 72 deg"));
  ASSERT_FALSE(first.empty());
  for (int n = 0; n < testing::case_count(4); ++n) {
    std::shuffle(order.begin(), order.end(), random);
    EXPECT_EQ(numbers_of(of_free_body("angle(H to w) < 72 deg", order)), first);
  }
}

// A heavy puck throws a light one at up to twice its speed.
TEST(ClaimAttack, ratios_far_from_one_are_met) {
  for (const char* most : {"1.9", "1.999", "1.9999"}) {
    const Statement statement =
        read_statement(std::string("letters: {m: kg, M: kg, v: m/s}\npoints: {P: [0, 0, 0], Q: [1 m, 0, 0]}\n"
                                   "bodies: {p: {particle: P, mass: m}, q: {particle: Q, mass: M}}\n"
                                   "joints: {a: {prismatic: x, at: P, to: p}, b: {prismatic: x, at: Q, to: q}}\n"
                                   "impacts: {c: {of: q, against: p, at: Q, pushes: x, restitution: 1}}\n"
                                   "instants: {before: {velocity(p).x: v, velocity(q).x: 0}}\ngravity: none\n"
                                   "claim: {a: velocity(q).x < ") +
                           most + "*v}\n",
                       "pucks.yaml");
    const SolvedClaim claim = solve_statement(statement, {}).solutions.at(0).claims.at(0);
    ASSERT_EQ(claim.state, AskState::found) << claim.reason;
    EXPECT_FALSE(claim.holds) << most;
    const std::map<std::string, double> at = numbers_of(claim);
    EXPECT_GE(2 * at.at("m") / (at.at("m") + at.at("M")), std::stod(most) * (1 - 1e-12));
  }
}

// A valley that runs along the difference of two letters, as the inequality of the triangle makes them.
TEST(ClaimAttack, narrow_valleys_are_followed) {
  const Unit unit = si_unit(dimensions::moment_of_inertia);
  const std::vector<Letter> letters{{"A", unit, {}, false}, {"B", unit, {}, false}, {"C", unit, {}, false}};
  const auto can_be = [](const Point& at) {
    return std::abs(at.at("A") - at.at("B")) <= at.at("C") && at.at("C") <= at.at("A") + at.at("B");
  };
  for (const double least : {0.3, 1e-2, 1e-4}) {
    ClaimAttack attack(
        letters, [&](const Point& at) { return at.at("C") / at.at("A") - least; }, can_be, 100'000'000);
    const std::optional<Point> found = attack.from({{{"A", 3}, {"B", 4}, {"C", 5}}});
    ASSERT_TRUE(found) << least;
    EXPECT_TRUE(can_be(*found));
    EXPECT_LE(found->at("C") / found->at("A"), least);
    EXPECT_GT(attack.tried(), 0U);
  }
}

// Edges that make a margin less by a part in ten million, one after the other, are not followed through all rounds, and
// a letter that has no part in the margin is not moved.
TEST(ClaimAttack, what_leads_nowhere_takes_little) {
  const Statement statement = read_statement(
      "letters: {m: kg, X: {signed: m}, Y: {signed: m}, Z: {signed: m}, A: kg*m^2, B: kg*m^2, C: kg*m^2, P: {signed: "
      "kg*m^2}, Q: {signed: kg*m^2}, R: {signed: kg*m^2}}\ngravity: none\npoints: {O: [0, 0, 0], G: [X, Y, Z]}\n"
      "bodies: {b: {mass: m, center: G, inertia: {about: O, x: A, y: B, z: C, xy: P, yz: Q, zx: R}}}\n"
      "joints: {pivot: {ball: O, to: b}}\n"
      "define: {H: angular_momentum(b about O), w: angular_velocity(b)}\n"
      "claim: {a: {claim: angle(H to w) < 90 deg, assume: [norm(w) > 0]}}\n",
      "body.yaml");
  const Work begin = work_done();
  const SolvedClaim claim = solve_statement(statement, {}).solutions.at(0).claims.at(0);
  EXPECT_TRUE(claim.holds);
  EXPECT_LT(work_done() - begin, 350'000'000);
}

// What fails only near one ratio of two letters is told where it fails clearly, and not where it begins to, which is no
// number that could be shown.
TEST(ClaimAttack, what_fails_narrowly_is_told_where_it_fails_clearly) {
  const Statement statement = read_statement(R"(letters: {a: m, b: m, m: kg}
points: {O: [0, 0, 0], A: [a, 0, 0]}
bodies: {p: {particle: A, mass: m}}
gravity: none
claim: {narrow: (center(p).x - 12345*b)^2 > 1e-6*b^2}
)",
                                             "narrow.yaml");
  const SolvedClaim claim = solve_statement(statement, {}).solutions.at(0).claims.at(0);
  ASSERT_EQ(claim.state, AskState::found) << claim.reason;
  EXPECT_FALSE(claim.holds);
  ASSERT_TRUE(claim.sides);
  EXPECT_LT(claim.sides->first, claim.sides->second);
  const std::map<std::string, double> at = numbers_of(claim);
  EXPECT_LT(std::pow(at.at("a") - 12345 * at.at("b"), 2), 0.5e-6 * at.at("b") * at.at("b"));
}

}  // namespace claim_attack_test
}  // namespace poinsot::problem
