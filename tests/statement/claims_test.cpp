// Claims: true ones are proved, false ones refuted by numbers that refute them in the solved statement too.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "poinsot/statement/solve_statement.h"
#include "statement/claim_proof.h"

namespace poinsot::statement {
namespace {

SolvedClaim claim_of(const std::string& text) {
  const Statement statement = read_statement(text, "claims.yaml");
  const SolvedStatement solved = solve_statement(statement, {});
  return solved.solutions.at(0).claims.at(0);
}

const std::string pendulum = R"(
letters: {m: kg, L: m}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, angle: turn}
gravity: -y
define: {E: kinetic_energy(bar) + potential_energy(bar), T: kinetic_energy(bar), H: angular_momentum(bar about O)}
)";

std::string pendulum_claim(const std::string& claim, const std::string& assume = "") {
  return pendulum + "claim:\n  a: {claim: [\"" + claim + "\"]" +
         (assume.empty() ? "" : ", assume: [\"" + assume + "\"]") + "}\n";
}

// The value of one side in the statement with the counterexample's numbers, where the claim's letters are all given.
double value_with(const std::string& statement, const std::string& ask, const SolvedClaim& claim) {
  std::string text = statement;
  std::vector<std::pair<std::string, std::string>> sets;
  std::string facts = "instants:\n  now: {";
  for (const SolvedClaim::Datum& datum : claim.counterexample) {
    std::string value = std::to_string(datum.value);
    if (datum.name == "turn")
      facts += "turn: " + value + " rad, ";
    else if (datum.name == "turn'")
      facts += "\"turn'\": " + value + " rad/s, ";
    else
      sets.emplace_back(datum.name, value + " " + datum.unit.text);
  }
  text += facts + "}\nask: {x: \"" + ask + "\"}\n";
  const Statement read = read_statement(text, "check.yaml");
  return solve_statement(read, sets).solutions.at(0).asks.at(0).value.number;
}

TEST(Claims, TrueIdentitiesAreProved) {
  for (const char* claim : {"T == m*L^2*turn'^2/6", "norm(H) == m*L^2/3*abs(turn')", "H.z == m*L^2*turn'/3", "E' == 0",
                            "m*L^2/3*turn'' + m*g*L/2*sin(turn) == 0", "rate(H) == [0, 0, -m*g*L/2*sin(turn)]"}) {
    const SolvedClaim solved = claim_of(pendulum_claim(claim));
    EXPECT_EQ(solved.state, AskState::found) << claim << ": " << solved.reason;
    EXPECT_TRUE(solved.holds) << claim;
    EXPECT_TRUE(solved.proved) << claim;
    EXPECT_TRUE(solved.counterexample.empty()) << claim;
  }
}

TEST(Claims, FalseOnesAreRefutedByNumbersThatRefute) {
  for (const auto& [left, right] : {std::pair{"T", "m*L^2*turn'^2/3"}, std::pair{"turn''", "-g*sin(turn)/L"},
                                    std::pair{"T'", "0"}, std::pair{"H.z", "m*L^2*turn'/6"}}) {
    const SolvedClaim solved = claim_of(pendulum_claim(std::string(left) + " == " + right));
    ASSERT_EQ(solved.state, AskState::found) << left << ": " << solved.reason;
    ASSERT_FALSE(solved.holds) << left;
    ASSERT_TRUE(solved.sides) << left;
    ASSERT_GE(solved.counterexample.size(), 2U) << left;
    const double l = value_with(pendulum, left, solved);
    EXPECT_NEAR(l, solved.sides->first * solved.unit.factor, 1e-6 * std::abs(l)) << left;
    EXPECT_GT(std::abs(solved.sides->first - solved.sides->second),
              1e-6 * (std::abs(solved.sides->first) + std::abs(solved.sides->second)))
        << left;
  }
}

TEST(Claims, InequalitiesAreProvedUnderAssumptions) {
  const SolvedClaim sure = claim_of(pendulum_claim("T >= 0"));
  EXPECT_TRUE(sure.holds && sure.proved);
  const SolvedClaim falls = claim_of(pendulum_claim("turn'' < 0", "0 < turn < 180 deg"));
  EXPECT_TRUE(falls.holds && falls.proved);
  const SolvedClaim everywhere = claim_of(pendulum_claim("turn'' < 0"));
  EXPECT_FALSE(everywhere.holds);
  const SolvedClaim longer = claim_of(pendulum_claim("moment_of_inertia(bar about z at O) > m*(1 m)^2/3", "L > 1 m"));
  EXPECT_TRUE(longer.holds && longer.proved);
  const SolvedClaim shorter = claim_of(pendulum_claim("moment_of_inertia(bar about z at O) > m*(1 m)^2/3", "L < 1 m"));
  EXPECT_FALSE(shorter.holds);
}

TEST(Claims, AssumptionsThatContradictEachOtherProveNothing) {
  const SolvedClaim solved = claim_of(pendulum_claim("T < 0", "L < L/2"));
  EXPECT_EQ(solved.state, AskState::undetermined);
  EXPECT_EQ(solved.reason, "no values of the letters were found that satisfy what is assumed");
}

TEST(Claims, WhatIsNotFixedIsNotDecided) {
  const SolvedClaim solved = claim_of(R"(
letters: {m: kg, L: m}
points: {A: [0, 0, 0], B: [L, 0, 0]}
bodies:
  bar: {rod: [A, B], mass: m}
joints:
  shaft: {revolute: x, at: A, to: bar, rate: 0, accel: 0, supports: {A: [x, y, z], B: [x, y, z]}}
gravity: -y
claim: {a: reaction(A).x == 0}
)");
  EXPECT_EQ(solved.state, AskState::undetermined);
  EXPECT_NE(solved.reason.find("which the statement does not fix"), std::string::npos) << solved.reason;
}

TEST(Claims, AnyMassIsALetter) {
  const std::string body = R"(
letters: {r: m, w: rad/s}
points: {O: [0, 0, 0]}
bodies:
  disk: {disk: {center: O, normal: z, radius: r}, mass: any}
joints:
  axle: {revolute: z, at: O, to: disk, rate: w}
gravity: none
)";
  const SolvedClaim general = claim_of(body + "claim: {a: kinetic_energy(disk) == mass(disk)*r^2*w^2/4}\n");
  EXPECT_TRUE(general.holds && general.proved);
  const SolvedClaim special = claim_of(body + "claim: {a: kinetic_energy(disk) == 1 kg * r^2*w^2/4}\n");
  EXPECT_FALSE(special.holds);
}

TEST(Claims, StabilityAboutThePrincipalAxes) {
  const auto stable = [](const std::string& axis) {
    return claim_of(R"(
letters: {m: kg, Ix: kg*m^2, Iy: kg*m^2, Iz: kg*m^2, n: rad/s}
gravity: none
points: {O: [0, 0, 0]}
bodies:
  body: {mass: m, center: O, inertia: {x: Ix, y: Iy, z: Iz}}
joints:
  pivot: {ball: O, to: body}
assume: [Ix > Iy > Iz]
steady: {frame: ground, spins: {body: {about: )" +
                    axis + R"(, rate: n}}}
claim: {a: stable(body)}
)");
  };
  EXPECT_TRUE(stable("x").holds);
  EXPECT_FALSE(stable("y").holds);
  EXPECT_FALSE(stable("y").counterexample.empty());
  EXPECT_TRUE(stable("z").holds);
  EXPECT_FALSE(stable("z").proved);
}

TEST(Claims, WhatIsStatedOfASteadyMotionIsAssumed) {
  const auto top = [](const std::string& claim) {
    return claim_of(R"(
letters: {I: kg*m^2, J: kg*m^2, m: kg, d: m, b: rad, p: {signed: rad/s}, s: {signed: rad/s}}
gravity: -z
assume: [0 < b < 180 deg]
points: {O: [0, 0, 0], G: [d*sin(b), 0, d*cos(b)]}
frames:
  figure: {turns: z, rate: p}
bodies:
  top: {mass: m, center: G, inertia: {about: O, axis: O->G, axial: I, transverse: J}}
joints:
  tip: {ball: O, to: top}
steady: {frame: figure, spins: {top: {about: O->G, rate: s}}}
define: {w: component(angular_velocity(top) along O->G)}
claim: {a: ')" + claim +
                    "'}\n");
  };
  const SolvedClaim condition = top("(I*w - J*p*cos(b))*p == weight(top)*d");
  EXPECT_TRUE(condition.holds && condition.proved) << condition.reason;
  EXPECT_FALSE(top("(I*w + J*p*cos(b))*p == weight(top)*d").holds);
}

TEST(Claims, MistakesAreFoundWhereTheyStand) {
  const auto message = [](const std::string& claim) -> std::string {
    try {
      claim_of(pendulum + "claim: {a: " + claim + "}\n");
    } catch (const StatementError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message("kinetic_energy(bar) == m*L").find("cannot be compared with"), std::string::npos)
      << message("kinetic_energy(bar) == m*L");
  EXPECT_NE(message("kinetic_energy(bra) == 0").find("there is no body 'bra'"), std::string::npos);
  EXPECT_NE(message("m*L == L*m").find("claims nothing of the model"), std::string::npos);
  EXPECT_NE(message("kinetic_energy(bar) + T").find("claims nothing"), std::string::npos);
  EXPECT_NE(message("{claim: T > 0, assume: [m]}").find("an assumption is a comparison"), std::string::npos);
  EXPECT_NE(message("{claim: T > 0, assume: [L > R]}").find("'R' is not defined"), std::string::npos)
      << message("{claim: T > 0, assume: [L > R]}");
  EXPECT_NE(message("{claim: T > 0, situation: other}").find("there is no situation 'other'"), std::string::npos);
}

TEST(WorkedAssumptions, AreWorkedIntoLetters) {
  const auto letter = [](const char* name) { return Formula::letter(name, poinsot::Sign::positive); };
  const Formula a = letter("a"), b = letter("b"), c = letter("c");
  const std::vector<std::string> positive{"a", "b", "c"};
  const WorkedAssumptions ordered({{a, b, Relation::greater}, {b, c, Relation::greater}}, positive);
  EXPECT_TRUE(ordered.proves({a * b, c * c, Relation::greater}));
  EXPECT_TRUE(ordered.proves({a + b, Formula(2) * c, Relation::greater}));
  EXPECT_FALSE(ordered.proves({a, Formula(2) * c, Relation::greater}));
  EXPECT_TRUE(ordered.proves({sqrt(a), sqrt(b), Relation::greater}));
  const WorkedAssumptions equal({{a, b * c, Relation::equal}}, positive);
  EXPECT_TRUE(equal.proves({a * a / c, a * b, Relation::equal}));
  EXPECT_FALSE(equal.proves({a, b, Relation::equal}));
  const WorkedAssumptions weak({{a, b, Relation::greater_equal}}, positive);
  EXPECT_TRUE(weak.proves({a, b, Relation::greater_equal}));
  EXPECT_FALSE(weak.proves({a, b, Relation::greater}));
  const Formula t = Formula::letter("t", poinsot::Sign::real);
  const WorkedAssumptions angle({{t, Formula(0), Relation::greater}, {t, Formula::pi(), Relation::less}}, positive);
  EXPECT_TRUE(angle.proves({sin(t), Formula(0), Relation::greater}));
  EXPECT_FALSE(angle.proves({cos(t), Formula(0), Relation::greater}));
}

}  // namespace
}  // namespace poinsot::statement
