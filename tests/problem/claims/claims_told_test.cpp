// What worked solutions show of claims, and how claims end that hold nearly, or nowhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/answers/solve_statement.h"
#include "problem/language/failure.h"

namespace poinsot::problem {
namespace claims_told_test {

Solution solution_of(const std::string& text, bool tell = true) {
  return solve_statement(read_statement(text, "claims_told.yaml"), {}, tell).solutions.at(0);
}

const std::string pendulum = R"(
letters: {m: kg, L: m}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, angle: turn}
gravity: -y
define: {T: kinetic_energy(bar), V: potential_energy(bar), E: T + V}
)";

TEST(ClaimsTold, DecimalsThatDifferFarBehindThePointAreToldApart) {
  const Solution solution = solution_of(pendulum + R"(claim:
  near: moment_of_inertia(bar about z at O) == 0.33333333333*m*L^2
  nearer: moment_of_inertia(bar about z at O) == 0.3333333333333333333333*m*L^2
  root: radius_of_gyration(bar about z at O) == 0.57735026919*L
  exact: moment_of_inertia(bar about z at O) == m*L^2/3
  tenth: moment_of_inertia(bar about z at O) == 0.25*m*L^2 + m*L^2/12
)");
  for (const std::size_t k : {0U, 1U, 2U}) {
    const SolvedClaim& claim = solution.claims.at(k);
    EXPECT_EQ(claim.state, AskState::found) << claim.reason;
    EXPECT_FALSE(claim.holds) << k;
    ASSERT_TRUE(claim.difference && claim.sides) << k;
    EXPECT_LT(std::abs(*claim.difference), 1e-10 * claim.sides->first) << k;
    EXPECT_NE(*claim.difference, 0) << k;
  }
  EXPECT_GT(*solution.claims[0].difference, 0);
  EXPECT_LT(*solution.claims[2].difference, 0);
  for (const std::size_t k : {3U, 4U}) EXPECT_TRUE(solution.claims.at(k).holds && solution.claims[k].proved) << k;
}

TEST(ClaimsTold, ThoseThatNoPointSatisfiesNameTheMostFrequentFault) {
  const std::string top = R"(
letters: {l: m}
points: {O: [0, 0, 0], T: [0, 0, l]}
bodies:
  top: {mass: 50 kg, center: T, inertia: {about: O, axis: z, axial: 1 kg*m^2, transverse: 0.1 kg*m^2}}
joints:
  tip: {ball: O, to: top}
gravity: -z
claim:
  a: kinetic_energy(top) > 0 J
)";
  try {
    solution_of(top, false);
    FAIL() << "no such body";
  } catch (const StatementError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("no rigid body has these moments: I_x >= 0 is broken"), std::string::npos) << message;
    EXPECT_NE(message.find(", as at l = "), std::string::npos) << message;
  }
}

TEST(ClaimsTold, SidesAndTheirDifference) {
  const Solution solution = solution_of(pendulum + "claim: {a: \"T == m*L^2*turn'^2/6\", b: T <= E + m*g*L}\n");
  const SolvedClaim& equal = solution.claims.at(0);
  ASSERT_EQ(equal.comparisons.size(), 1U);
  EXPECT_EQ(text(equal.comparisons[0].left), "m*L^2*turn'^2/6");
  EXPECT_EQ(equal.comparisons[0].relation, "==");
  ASSERT_TRUE(equal.comparisons[0].reduced);
  EXPECT_TRUE(equal.comparisons[0].reduced->is_zero());
  // g stands as a letter.
  const SolvedClaim& larger = solution.claims.at(1);
  ASSERT_EQ(larger.comparisons.size(), 1U);
  const std::vector<std::string> letters = larger.comparisons[0].right.letters();
  EXPECT_NE(std::find(letters.begin(), letters.end(), "g"), letters.end());
  // Without being asked nothing is told.
  EXPECT_TRUE(solution_of(pendulum + "claim: {a: \"E' == 0\"}\n", false).claims.at(0).comparisons.empty());
}

TEST(ClaimsTold, ConservationByTheRatesOfItsTerms) {
  const SolvedClaim claim = solution_of(pendulum + "claim: {a: \"E' == 0\"}\n").claims.at(0);
  ASSERT_TRUE(claim.holds && claim.proved);
  ASSERT_EQ(claim.comparisons.size(), 1U);
  const auto& parts = claim.comparisons[0].parts;
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].of, "T");
  EXPECT_EQ(parts[1].of, "V");
  EXPECT_EQ(text(parts[1].value), "m*g*L*turn'*sin(turn)/2");
  EXPECT_TRUE((parts[0].value + parts[1].value).is_zero());
}

TEST(ClaimsTold, ConservationByCoordinatesAndVelocities) {
  // A particle on a turning arm that slides out: its momentum about the axis is kept, term by term it is not.
  const SolvedClaim claim = solution_of(R"(
letters: {m: kg, r: m}
points: {O: [0, 0, 0], P: [r, 0, 0]}
bodies:
  arm: massless
  bead: {particle: P, mass: m}
joints:
  axle: {revolute: z, at: O, to: arm, angle: q}
  slot: {prismatic: x, at: P, from: arm, to: bead, displacement: s}
gravity: none
define: {H: angular_momentum(bead about O).z}
claim: {kept: "H' == 0"}
)")
                                .claims.at(0);
  ASSERT_TRUE(claim.holds && claim.proved);
  const auto& parts = claim.comparisons.at(0).parts;
  ASSERT_EQ(parts.size(), 2U);
  poinsot::Formula sum;
  for (const auto& part : parts) {
    EXPECT_TRUE(part.by_letter);
    EXPECT_FALSE(part.value.is_zero());
    sum += part.value;
  }
  EXPECT_TRUE(sum.is_zero());
}

TEST(ClaimsTold, StabilityByItsPolynomial) {
  // A sleeping top: J^2 l^4 + (I^2 S^2 - 2 J m g h) l^2 + (m g h)^2 is stable if I S > 2 sqrt(J m g h).
  const SolvedClaim claim = solution_of(R"(
letters: {m: kg, h: m, I: kg*m^2, J: kg*m^2, S: rad/s, g: m/s^2}
points: {O: [0, 0, 0], T: [0, 0, h]}
bodies:
  top: {mass: m, center: T, inertia: {axis: z, axial: I, transverse: J}}
joints:
  tip: {ball: O, to: top}
steady: {frame: ground, spins: {top: {about: O->T, rate: S}}}
gravity: -z
claim: {sleeps: {claim: stable(top), assume: ["I^2*S^2 > 4*(J + m*h^2)*m*g*h"]}}
)")
                                .claims.at(0);
  ASSERT_TRUE(claim.holds) << claim.reason;
  ASSERT_TRUE(claim.stability);
  const auto& polynomial = claim.stability->polynomial;
  ASSERT_EQ(polynomial.size(), 5U);
  EXPECT_TRUE(polynomial[1].is_zero() && polynomial[3].is_zero());
  const LetterValues at{{"m", 2}, {"h", 0.3}, {"I", 0.5}, {"J", 0.4}, {"S", 9}, {"g", 9.8}};
  const double A = 0.4 + 2 * 0.09, w = 2 * 9.8 * 0.3, scale = value_at(polynomial[4], at) / (A * A);
  EXPECT_NEAR(value_at(polynomial[2], at), scale * (0.25 * 81 - 2 * A * w), 1e-9 * std::abs(scale) * 20);
  EXPECT_NEAR(value_at(polynomial[0], at), scale * w * w, 1e-9 * std::abs(scale) * w * w);
  if (claim.proved) {
    EXPECT_FALSE(claim.stability->positive.empty());
    for (const auto& one : claim.stability->positive) EXPECT_GT(value_at(one, at), 0) << text(one);
  }
}

TEST(ClaimsTold, LawsThatAreWithdrawnLeaveNoNote) {
  const Solution solution = solution_of(R"(
letters: {a: m, c: m, w: rad/s}
points: {O: [0, 0, 0], A: [a, 0, 0], B: [3*a, 0, 0], P: [0, 0, c]}
bodies:
  crank: {rod: [O, A], mass: 1 kg}
  link: {rod: [A, B], mass: 1 kg}
  block: {particle: B, mass: 1 kg}
joints:
  o: {revolute: z, at: O, to: crank, angle: q, rate: w}
  j: {revolute: z, at: A, from: crank, to: link}
  k: {revolute: z, at: B, from: link, to: block}
  rail: {prismatic: x, at: B, to: block, displacement: s}
gravity: none
instants:
  now: {q: 40 deg}
ask:
  v: velocity(block).x
  r: min(norm(position(B of link)) with 100*c)
)");
  EXPECT_TRUE(solution.asks.at(0).formula);
  EXPECT_FALSE(solution.asks.at(1).formula);
  ASSERT_EQ(solution.notes.size(), 1U);
  EXPECT_EQ(solution.notes.front(), "v by dimensional analysis, with numbers of 12 digits");
}

// A cone that rolls so fast and is so large that none of the first draws is.
TEST(ClaimsTold, WhatIsAssumedIsMetFarFromTheSizesOfUnits) {
  const Solution solution = solution_of(R"(
letters: {m: kg, h: m, a: rad, p: rad/s}
points: {O: [0, 0, 0], B: 'h*[cos(a), sin(a), 0]', C: [h/cos(a), 0, 0]}
frames: {figure: {turns: y, rate: p}}
bodies: {cone: {cone: {apex: O, base: B, radius: h*tan(a)}, mass: m}}
joints: {tip: {ball: O, to: cone}}
contacts: {rim: {of: cone, at: C, normal: y, no_slip: true, carries: [push, z]}}
steady: {frame: figure, spins: {cone: {about: O->B, rate: -p/sin(a)}}}
gravity: -y
claim:
  moves: {claim: kinetic_energy(cone) > 0 J, assume: [0 < a < 40 deg, p > 30 rad/s, h > 1 m]}
  rests: {claim: kinetic_energy(cone) < 0 J, assume: [0 < a < 40 deg, p > 30 rad/s, h > 1 m]}
)");
  EXPECT_EQ(solution.claims.at(0).state, AskState::found) << solution.claims[0].reason;
  EXPECT_TRUE(solution.claims[0].holds);
  EXPECT_EQ(solution.claims.at(1).state, AskState::found) << solution.claims[1].reason;
  EXPECT_FALSE(solution.claims[1].holds);
}

// A chimney of length L that falls breaks at L/3, where what bends it is largest: m g sin(b) s (L - s)^2/(4 L^2).
TEST(ClaimsTold, DerivativesByALetterAreToldAtItsValuesIfTheyHoldForAll) {
  const Statement statement = read_statement(
      "title: t\nletters: {m: kg, L: m, s: m, b: rad}\nassume: [s < L, 0 < b < 90 deg]\n"
      "points: {O: [0, 0, 0], P: 's*[sin(b), cos(b), 0]', T: 'L*[sin(b), cos(b), 0]'}\n"
      "bodies: {low: {rod: [O, P], mass: m*s/L}, up: {rod: [P, T], mass: m*(L - s)/L}}\n"
      "joints: {foot: {revolute: z, at: O, to: low}, joint: {weld: P, from: low, to: up}}\ngravity: -y\n"
      "instants: {now: rest}\ndefine: {M: couple(joint on up about P).z}\nclaim:\n"
      "  slope: derivative(M by s) == -m*g*sin(b)*(L - s)*(L - 3*s)/(4*L^2)\n  falls: derivative(M by s) < 0\n",
      "claims.yaml");
  const auto claims = [&](const std::vector<std::pair<std::string, std::string>>& sets) {
    return solve_statement(statement, sets).solutions.at(0).claims;
  };
  for (const SolvedClaim& claim : claims({})) EXPECT_EQ(claim.state, AskState::found) << claim.reason;
  const std::vector<SolvedClaim> set = claims({{"m", "100 kg"}, {"L", "10 m"}, {"s", "4 m"}, {"b", "30 deg"}});
  EXPECT_TRUE(set.at(0).state == AskState::found && set.at(0).holds) << set.at(0).reason;
  // It fails for some letters, which says nothing of these.
  EXPECT_NE(set.at(1).state, AskState::found);
  EXPECT_NE(set.at(1).reason.find("leave them open"), std::string::npos) << set.at(1).reason;
}

// A square plate on a shaft along its diagonal is balanced, which another's sides do not change.
TEST(ClaimsTold, WhatIsAssumedNeedNotHoldAtTheValuesOfTheLetters) {
  const Statement statement = read_statement(
      "title: t\nletters: {m: kg, a: m, b: m, w: rad/s}\npoints: {O: [0, 0, 0], A: [a, b, 0]}\n"
      "bodies: {plate: {rectangle: {corners: [O, '[a, 0, 0]', A]}, mass: m}}\n"
      "joints: {shaft: {revolute: O->A, to: plate, rate: w, accel: 0}}\ngravity: none\n"
      "define: {M: norm(reaction_couple(shaft))}\n"
      "claim: {square: {claim: M == 0, assume: [a == b]}, long: {claim: M == 0, assume: [a > 2*b]}}\n",
      "claims.yaml");
  const auto claims = [&](const std::vector<std::pair<std::string, std::string>>& sets) {
    return solve_statement(statement, sets).solutions.at(0).claims;
  };
  const std::vector<SolvedClaim> set = claims({{"m", "3 kg"}, {"a", "0.4 m"}, {"b", "0.3 m"}, {"w", "20 rad/s"}});
  EXPECT_TRUE(set.at(0).state == AskState::found && set.at(0).holds) << set.at(0).reason;
  // What fails for some letters that satisfy it says nothing of these.
  EXPECT_NE(set.at(1).state, AskState::found);
}

// Most letters that are drawn are moments of no body. What is wrong with the claim is said all the same.
TEST(ClaimsTold, WhatIsWrongWithAClaimStandsBeforeValuesOfNoBody) {
  const Statement statement = read_statement(
      "title: t\nletters: {A: kg*m^2, B: kg*m^2, C: kg*m^2, P: {signed: kg*m^2}}\npoints: {G: [0, 0, 0]}\n"
      "bodies: {b: {mass: 1 kg, center: G, inertia: {x: A, y: B, z: C, xy: P, yz: 0, zx: 0}}}\ngravity: none\n"
      "claim: {c: 'products_of_inertia(b about G).x <= A + B'}\n",
      "claims.yaml");
  const std::string said = failure_of([&] { solve_statement(statement, {}); });
  EXPECT_EQ(said.find("no rigid body"), std::string::npos) << said;
  EXPECT_NE(said.find("claims.yaml:6"), std::string::npos) << said;
}

}  // namespace claims_told_test
}  // namespace poinsot::problem
