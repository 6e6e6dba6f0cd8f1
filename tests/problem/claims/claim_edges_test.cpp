// Claims that fail only where what is assumed is just met.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace claim_edges_test {

// A coin rolls on upright where s^2 > g/(3 r).
SolvedClaim rolling_claim(const std::string& assumed) {
  const Statement statement = read_statement(
      "title: t\nletters: {r: m, s: rad/s}\npoints: {G: [0, 0, r], C: [0, 0, 0]}\n"
      "bodies: {coin: {disk: {center: G, normal: x, radius: r}, mass: 10 g}}\n"
      "contacts: {floor: {of: coin, at: C, normal: z, no_slip: true}}\n"
      "instants: {now: {angular_velocity(coin): [s, 0, 0]}}\ngravity: [0, 0, -9.81 m/s^2]\n"
      "claim: {a: {claim: stable(coin), assume: [\"" +
          assumed + "\"]}}\n",
      "claims.yaml");
  return solve_statement(statement, {}).solutions.at(0).claims.at(0);
}

double value_of(const SolvedClaim& claim, const std::string& name) {
  const auto datum = std::find_if(claim.counterexample.begin(), claim.counterexample.end(),
                                  [&](const SolvedClaim::Datum& each) { return each.name == name; });
  return datum == claim.counterexample.end() ? 0 : datum->value;
}

// Where vectors are alike their difference vanishes, and so does its magnitude.
TEST(ClaimEdges, StrictClaimsFailWhereLettersAreEqual) {
  const Statement statement = read_statement(
      "title: t\nletters: {a: m/s, b: m/s, c: m/s, s: {signed: m/s}, m: kg}\n"
      "points: {O: [0, 0, 0], P: [1 m, 0, 0]}\nbodies: {p: {particle: O, mass: m}, q: {particle: P, mass: m}}\n"
      "facts: {velocity(p): [a, b, 0], velocity(q): [b, c, s]}\ngravity: none\nclaim:\n"
      "  norm: norm(velocity(p) - velocity(q)) > 0 m/s\n"
      "  squares: (velocity(p).x - b)^2 + (b - c)^2 > 0\n"
      "  energy: kinetic_energy(p) + kinetic_energy(q) > m*dot(velocity(p) with velocity(q))\n"
      "  twice: norm(velocity(p) - 2*velocity(q)) > 0 m/s\n"
      "  half: (b - 2*velocity(p).x)^2 + (c - 2*b)^2 > 0\n"
      "  weak: norm(velocity(p) - velocity(q)) >= 0 m/s\n",
      "claims.yaml");
  const std::vector<SolvedClaim> claims = solve_statement(statement, {}).solutions.at(0).claims;
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(claims.at(k).state, AskState::found) << k << claims.at(k).reason;
    EXPECT_FALSE(claims.at(k).holds) << k;
  }
  EXPECT_TRUE(claims.at(5).holds);
}

// With equal weights Atwood's machine rests; over a wheel it has no formulas, and numbers do not decide that.
TEST(ClaimEdges, NumbersDoNotDecideWhereLettersAreEqual) {
  const Statement statement = read_statement(
      "title: t\nletters: {m: kg, M: kg}\npoints: {O: [0, 0, 0], A: [-1 m, -3 m, 0], B: [1 m, -3 m, 0]}\n"
      "bodies: {light: {particle: A, mass: m}, heavy: {particle: B, mass: M}}\n"
      "joints: {one: {prismatic: y, at: A, to: light}, two: {prismatic: y, at: B, to: heavy}}\n"
      "cords: {rope: {from: light, at: A, over: [{ground: {at: O, radius: 1 m}}], to: heavy, end: B}}\ngravity: -y\n"
      "instants: {now: rest}\nclaim:\n  strict: tension(rope) < (m + M)*g/2\n  weak: tension(rope) <= (m + M)*g/2\n"
      "  rises: {claim: 'acceleration(light).y > 0 m/s^2', assume: [M >= m]}\n"
      "  heavier: {claim: 'acceleration(light).y > 0 m/s^2', assume: [M > m]}\n"
      "  pulls: {claim: tension(rope) > 0 N, assume: [M >= m]}\n",
      "claims.yaml");
  const std::vector<SolvedClaim> claims = solve_statement(statement, {}).solutions.at(0).claims;
  EXPECT_FALSE(claims.at(2).state == AskState::found && claims.at(2).holds) << claims.at(2).reason;
  for (const std::size_t k : {3u, 4u}) EXPECT_TRUE(claims.at(k).state == AskState::found && claims.at(k).holds) << k;
  // An assumption that just holds is no reason to say nothing where all letters have values.
  const SolvedClaim given = solve_statement(statement, {{"m", "2 kg"}, {"M", "2 kg"}}).solutions.at(0).claims.at(4);
  EXPECT_TRUE(given.state == AskState::found && given.holds) << given.reason;
  EXPECT_FALSE(claims.at(0).state == AskState::found && claims.at(0).holds) << claims.at(0).reason;
  EXPECT_TRUE(claims.at(1).state == AskState::found && claims.at(1).holds) << claims.at(1).reason;
}

TEST(ClaimEdges, ACounterexampleStandsCloseToTheEdgeOfWhatIsAssumed) {
  for (const double part : {0.25, 0.3, 0.32}) {
    const SolvedClaim claim = rolling_claim("s^2 > " + std::to_string(part) + "*9.81 m/s^2 / r");
    ASSERT_EQ(claim.state, AskState::found) << part << claim.reason;
    EXPECT_FALSE(claim.holds) << part;
    const double s = value_of(claim, "s"), group = s * s * value_of(claim, "r") / 9.81;
    EXPECT_GT(group, part);
    EXPECT_LT(group, 1.0 / 3);
  }
}

// A plate on a clevis that turns hangs in a stable way up to w^2 = 3 g/(2 h). There its linearised equations say
// nothing.
TEST(ClaimEdges, StabilityIsNotClaimedWhereWhatIsAssumedJustHolds) {
  const auto claimed = [](const std::string& assumed) {
    return solve_statement(
               read_statement("title: t\nletters: {g: m/s^2, h: m, w: rad/s}\npoints: {O: [0, 0, 0], P: [0, -h/2, 0]}\n"
                              "bodies: {clevis: massless, plate: {rectangle: {center: P, sides: [0.3 m*z, h*y]}, mass: "
                              "1 kg}}\njoints:\n  shaft: {revolute: y, at: O, to: clevis, rate: w, accel: 0}\n"
                              "  hinge: {revolute: z, at: O, from: clevis, to: plate, angle: b}\ngravity: -y\n"
                              "instants: {now: {b: 0 deg}}\nsteady: {frame: clevis}\n"
                              "claim: {a: {claim: stable(plate), assume: [" +
                                  assumed + "]}}\n",
                              "claims.yaml"),
               {})
        .solutions.at(0)
        .claims.at(0);
  };
  const SolvedClaim closed = claimed("w^2*h <= 3/2*g");
  EXPECT_EQ(closed.state, AskState::undetermined);
  EXPECT_TRUE(closed.reason.starts_with("where what it assumes just holds, as at g = ")) << closed.reason;
  EXPECT_TRUE(closed.reason.ends_with(", the linearised equations do not decide it")) << closed.reason;
  EXPECT_TRUE(claimed("w^2*h < 3/2*g").holds);
}

TEST(ClaimEdges, WhatHoldsUpToTheEdgeHolds) {
  const SolvedClaim claim = rolling_claim("3*s^2 > 9.81 m/s^2 / r");
  ASSERT_EQ(claim.state, AskState::found) << claim.reason;
  EXPECT_TRUE(claim.holds);
}

// Of a body of revolution with I = J all sides are equal.
TEST(ClaimEdges, SidesThatAreEqualUnderWhatIsAssumedAreNotLess) {
  const auto claimed = [](const std::string& claim) {
    return solve_statement(
               read_statement("title: t\nletters: {I: kg*m^2, J: kg*m^2, p: {signed: rad/s}, q: {signed: rad/s}}\n"
                              "points: {G: [0, 0, 0]}\n"
                              "bodies: {b: {mass: 1 kg, center: G, inertia: {axis: z, axial: I, transverse: J}}}\n"
                              "gravity: none\nfacts: {angular_velocity(b): [p, 0, q], velocity(b): [0, 0, 0]}\n"
                              "define: {H: angular_momentum(b about G)}\nclaim: {a: {claim: '" +
                                  claim + "', assume: [I == J]}}\n",
                              "claims.yaml"),
               {})
        .solutions.at(0)
        .claims.at(0);
  };
  for (const char* claim : {"kinetic_energy(b) >= norm(H)^2/(2*J)", "kinetic_energy(b) <= norm(H)^2/(2*J)"}) {
    const SolvedClaim equal = claimed(claim);
    ASSERT_EQ(equal.state, AskState::found) << claim << equal.reason;
    EXPECT_TRUE(equal.holds) << claim;
  }
  const SolvedClaim less = claimed("kinetic_energy(b) < norm(H)^2/(2*J)");
  ASSERT_EQ(less.state, AskState::found) << less.reason;
  EXPECT_FALSE(less.holds);
}

// A product of inertia reaches the geometric mean of two moments in a thin rod alone, whose third moment is their sum.
TEST(ClaimEdges, AThinRodIsAnEdgeOfBodies) {
  const auto claimed = [](const std::string& claim) {
    return solve_statement(
               read_statement("title: t\nletters: {m: kg, I: kg*m^2, J: kg*m^2, K: kg*m^2, P: {signed: kg*m^2}, w: "
                              "rad/s}\npoints: {G: [0, 0, 0]}\nbodies: {b: {mass: m, center: G, inertia: {x: I, y: J, "
                              "z: K, xy: P, yz: 0, zx: 0}}}\ngravity: none\nfacts: {angular_velocity(b): [0, w, 0]}\n"
                              "define: {A: moment_of_inertia(b about x at G), B: moment_of_inertia(b about y at G), k: "
                              "moment_of_inertia(b about z at G), p: angular_momentum(b about G).x/w}\nclaim: {a: '" +
                                  claim + "'}\n",
                              "claims.yaml"),
               {})
        .solutions.at(0)
        .claims.at(0);
  };
  for (const char* claim : {"p^2 < A*B", "k < A + B", "2*abs(p) < k"}) {
    const SolvedClaim found = claimed(claim);
    ASSERT_EQ(found.state, AskState::found) << claim << found.reason;
    EXPECT_FALSE(found.holds) << claim;
  }
  const SolvedClaim rod = claimed("p^2 < A*B");
  const double I = value_of(rod, "I"), J = value_of(rod, "J"), P = value_of(rod, "P");
  EXPECT_DOUBLE_EQ(P * P, I * J);
  EXPECT_DOUBLE_EQ(value_of(rod, "K"), I + J);
  for (const char* claim : {"p^2 <= A*B", "k <= A + B", "2*abs(p) <= k"}) {
    const SolvedClaim found = claimed(claim);
    ASSERT_EQ(found.state, AskState::found) << claim << found.reason;
    EXPECT_TRUE(found.holds) << claim;
  }
}

// Along the motion a free body leaves the place in which it is drawn, where the spring happens to be relaxed and the
// weight to have no moment.
TEST(ClaimEdges, RatesAreThoseWhereverAFreeBodyMayBe) {
  const auto claim = [](const std::string& text) {
    const Statement statement = read_statement(
        "title: t\nletters: {m: kg, k: N/m, L: m}\npoints: {O: [0, 0, 0], P: [L, 0, 0]}\n"
        "bodies: {b: {particle: P, mass: m}, c: {particle: O, mass: m}}\n"
        "springs: {s: {from: ground, at: O, to: b, end: P, stiffness: k, free_length: L}}\ngravity: -y\n"
        "define: {E: kinetic_energy(b) + potential_energy(b) + potential_energy(s)}\nclaim: {a: \"" +
            text + "\"}\n",
        "claims.yaml");
    return solve_statement(statement, {}).solutions.at(0).claims.at(0);
  };
  EXPECT_FALSE(claim("rate(momentum(b)).x == 0").holds);
  EXPECT_FALSE(claim("rate(angular_momentum(c about O)) == 0").holds);
  EXPECT_TRUE(claim("rate(momentum(c)).x == 0").proved);
  EXPECT_TRUE(claim("E' == 0").holds);
}

// A coin that rolls upright just as fast as it must: that it falls over is lost among the rates that vanish since it
// may roll faster or in a circle. It is not stable by the linearised equations, and not by a little less either.
TEST(ClaimEdges, AtItsLeastSpeedARollingCoinIsNotStable) {
  const auto stability_at = [](double part) {
    const Statement statement =
        read_statement("title: t\ngiven: {r: 1.09 m, s: " + fmt::format("{:.17g}", part) +
                           " * sqrt(9.81 m/s^2/(3*r))}\npoints: {G: [0, 0, r], C: [0, 0, 0]}\n"
                           "bodies: {coin: {disk: {center: G, normal: x, radius: r}, mass: 10 g}}\n"
                           "contacts: {floor: {of: coin, at: C, normal: z, no_slip: true}}\n"
                           "instants: {now: {angular_velocity(coin): [s, 0, 0]}}\ngravity: [0, 0, -9.81 m/s^2]\n"
                           "ask: {s: stable(coin), w: stability(coin)}\n",
                       "coin.yaml");
    return solve_statement(statement, {}).solutions.at(0).asks.at(1).value.text;
  };
  EXPECT_EQ(stability_at(1.001), "stable");
  EXPECT_EQ(stability_at(0.999), "unstable");
  EXPECT_EQ(stability_at(1), "undecided by the linearised equations");
  EXPECT_NE(stability_at(1 - 5e-10), "stable");
}

}  // namespace claim_edges_test
}  // namespace poinsot::problem
