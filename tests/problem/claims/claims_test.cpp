// Claims: true ones are proved, false ones refuted by numbers that refute them in the solved statement too.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/answers/solve_statement.h"
#include "problem/claims/claim_proof.h"

namespace poinsot::problem {
namespace claims_test {

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

// The rate is meant in any pose, and fails as drawn as well: the counterexample names no pose.
TEST(Claims, WhatFailsAsDrawnIsRefutedThere) {
  const SolvedClaim solved = claim_of(R"(
letters: {A: kg*m^2, B: kg*m^2, C: kg*m^2, u: rad/s, v: rad/s, w: rad/s}
assume: [A < B, B < C]
points: {G: [0, 0, 0]}
bodies: {b: {mass: 1 kg, center: G, inertia: {x: A, y: B, z: C}}}
facts: {angular_velocity(b): [u, v, w], velocity(b): 0}
gravity: none
define: {n: norm(angular_velocity(b))}
claim: {a: "n' == 0"}
)");
  EXPECT_EQ(solved.state, AskState::found);
  EXPECT_FALSE(solved.holds);
  std::string names;
  double w[3] = {}, I[3] = {};
  for (const SolvedClaim::Datum& datum : solved.counterexample) {
    names += datum.name;
    if (names.size() <= 3) I[names.size() - 1] = datum.value;
    if (names.size() > 3 && names.size() <= 6) w[names.size() - 4] = datum.value;
  }
  ASSERT_EQ(names, "ABCuvw");
  // By Euler's equations.
  const double rate = w[0] * w[1] * w[2] * ((I[1] - I[2]) / I[0] + (I[2] - I[0]) / I[1] + (I[0] - I[1]) / I[2]);
  ASSERT_TRUE(solved.sides.has_value());
  EXPECT_NEAR(solved.sides->first, rate / std::hypot(w[0], w[1], w[2]), 1e-9);
}

TEST(Claims, AnAssumptionThatGivenValuesBreakIsTold) {
  const SolvedClaim solved = claim_of(R"(
given: {m: 2 kg, L: 0.5 m, w: 3 rad/s}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bar: {rod: [O, A], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar, rate: w}}
gravity: -y
claim: {a: {claim: kinetic_energy(bar) > 2 J, assume: [L > 1 m]}}
)");
  EXPECT_EQ(solved.state, AskState::undetermined);
  EXPECT_EQ(solved.reason,
            "what it assumes does not hold at the values that all letters have (leave letters open, or change their "
            "values)");
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
  const auto stable = [](const std::string& axis, const std::string& flat = "") {
    return claim_of(R"(
letters: {m: kg, Ix: kg*m^2, Iy: kg*m^2, Iz: kg*m^2, n: rad/s}
gravity: none
points: {O: [0, 0, 0]}
bodies:
  body: {mass: m, center: O, inertia: {x: Ix, y: Iy, z: Iz}}
joints:
  pivot: {ball: O, to: body}
assume: [Ix > Iy > Iz)" +
                    flat + R"(]
steady: {frame: ground, spins: {body: {about: )" +
                    axis + R"(, rate: n}}}
claim: {a: stable(body)}
)");
  };
  EXPECT_TRUE(stable("x").holds);
  EXPECT_FALSE(stable("y").holds);
  EXPECT_FALSE(stable("y").counterexample.empty());
  EXPECT_TRUE(stable("z").holds);
  // A plate across x turns as fast as it wobbles: frequencies that coincide are not told from growth.
  EXPECT_FALSE(stable("x").proved);
  EXPECT_TRUE(stable("x", ", Ix < Iy + Iz").proved);
  EXPECT_TRUE(stable("z").proved);
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

// Letters of either sign, so that special values of them are among those that a claim is about.
SolvedClaim of_letters(const std::string& claim, const std::string& assume = "") {
  return claim_of(R"(
letters: {m: kg, L: m, a: kg, b: kg, u: {signed: m}, v: {signed: m}}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies:
  bar: {rod: [O, A], mass: m}
joints:
  pin: {revolute: z, at: O, to: bar, angle: turn}
gravity: -y
define: {nothing: 0*mass(bar)/(1 kg)}
claim:
  a: {claim: [")" +
                  claim + "\"]" + (assume.empty() ? "" : ", assume: [" + assume + "]") + "}\n");
}

TEST(Claims, WhatIsFalseSomewhereIsNotProved) {
  const std::pair<const char*, const char*> claims[] = {
      {"a*(1 + nothing) == b", "\"a*u == b*u\""},                   // u may vanish
      {"u*(1 + nothing) >= 0 m", "\"u*v^2 == L*v^2\""},             // v may
      {"u*(1 + nothing) <= 0 m", "\"u*v > 0 m^2\", \"u > -1 m\""},  // both may be positive
      {"u*(1 + nothing) >= v", "\"u^2*(u - v) >= 0 m^3\""},         // u may vanish
      {"a*(1 + nothing) > b", "\"a >= b\""},                        // they may be equal
      {"max(u with v)*(1 + nothing) == u", ""},                     // the larger is decided at a point
      {"min([u, v, L])*(1 + nothing) == u", ""},
      {"abs(u)*(1 + nothing) == u", ""},
      {"sqrt(u^2)*(1 + nothing) == u", ""},
      {"sqrt(u*v)*sqrt(u*v)*(1 + nothing) == u*v + 1 m^2", ""},
      {"acos(cos(turn))*(1 + nothing) == turn", ""},  // beyond half a turn
      {"asin(sin(turn))*(1 + nothing) == turn", ""},
      {"atan(tan(turn))*(1 + nothing) == turn", ""},
      {"atan2(sin(turn) to cos(turn))*(1 + nothing) == turn", ""},
      {"sqrt((1 + cos(turn))/2)*(1 + nothing) == cos(turn/2)", ""},
      {"sqrt(1 - cos(turn)^2)*(1 + nothing) == sin(turn)", ""},
      {"turn*(1 + nothing) > -7 rad", ""},
      {"kinetic_energy(bar) > 0 J", ""},                              // it may rest
      {"(u - 1.23456 m)^2*(1 + nothing) > 0 m^2", ""},                // at one point alone
      {"(u - 1.23456 m)*(u - 1.2346 m)*(1 + nothing) >= 0 m^2", ""},  // in a narrow gap
      {"u^3*(1 + nothing) < 1000000 m^3", ""},                        // far away
      // Only where what is assumed just holds.
      {"a*(1 + nothing) < b", "\"a <= b\""},
      {"L*(1 + nothing) < 1 m", "\"L <= 1 m\""},
      {"L*(1 + nothing) < 1 m", "\"L >= 0.5 m\", \"L <= 1 m\""},
      {"L*(1 + nothing) > 0.5 m", "\"L >= 0.5 m\", \"L <= 1 m\""},
      {"u*(1 + nothing) < 1 m", "\"-1 m <= u <= 1 m\""},
      {"u*(1 + nothing) > -1 m", "\"-1 m <= u <= 1 m\""},
      {"u*v*(1 + nothing) < 1 m^2", "\"0 m <= u <= 1 m\", \"0 m <= v <= 1 m\""},
  };
  for (const auto& [claim, assume] : claims) {
    const SolvedClaim solved = of_letters(claim, assume);
    ASSERT_EQ(solved.state, AskState::found) << claim << ": " << solved.reason;
    EXPECT_FALSE(solved.holds) << claim << " if " << assume << (solved.proved ? ": proved" : ": sampled");
  }
}

TEST(Claims, WhatIsTrueOfSuchLettersIsProved) {
  const std::pair<const char*, const char*> claims[] = {
      {"a*u*(1 + nothing) == b*u", "\"a*u == b*u\""},
      {"(a - b)*u*(1 + nothing) == 0", "\"a*u == b*u\""},
      {"a*(1 + nothing) == b", "\"a*u == b*u\", \"u > 0 m\""},
      {"a*(1 + nothing) > b", "\"a > b\", \"a > 2*b\""},
      {"a*(1 + nothing) > 2*b", "\"a > b\", \"a > 2*b\""},
      {"a*(1 + nothing) >= b", "\"a >= b\""},
      {"L*(1 + nothing) < 2 m", "\"L < 1 m\""},
      {"L*(1 + nothing) <= 1 m", "\"0.5 m <= L <= 1 m\""},
      {"u*(1 + nothing) <= 1 m", "\"-1 m <= u <= 1 m\""},
      {"u*v*(1 + nothing) <= 1 m^2", "\"0 m <= u <= 1 m\", \"0 m <= v <= 1 m\""},
      {"max(u with v)*(1 + nothing) == u", "\"u > v\""},
      {"abs(u)*(1 + nothing) == -u", "\"u < 0 m\""},
      {"(u^2 + u*v + v^2)*(1 + nothing) >= 0 m^2", ""},
      {"abs(u*v)*(1 + nothing) <= (u^2 + v^2)/2", ""},
  };
  for (const auto& [claim, assume] : claims) {
    const SolvedClaim solved = of_letters(claim, assume);
    ASSERT_EQ(solved.state, AskState::found) << claim << ": " << solved.reason;
    EXPECT_TRUE(solved.holds) << claim << " if " << assume;
    EXPECT_TRUE(solved.proved) << claim << " if " << assume;
  }
}

TEST(Claims, AssumptionsThatCannotHoldDecideNothing) {
  for (const char* assume : {"\"a > b\", \"b > a\"", "\"u^2 < 0 m^2\"", "\"a == -b\"", "\"u > 1 m\", \"u < 0 m\"",
                             "\"a == b\", \"a == 2*b\""}) {
    const SolvedClaim solved = of_letters("kinetic_energy(bar) < 0 J", assume);
    EXPECT_EQ(solved.state, AskState::undetermined) << assume << (solved.holds ? ": holds" : ": fails");
  }
}

// An inertia of which nothing is said is none that could be chosen well.
TEST(Claims, InertiaGivenAsAnyIsAnyInertia) {
  const auto body = [](const std::string& inertia, const std::string& claim) {
    return claim_of(R"(
letters: {m: kg, w: rad/s}
points: {O: [0, 0, 0]}
bodies:
  rotor: {mass: m, center: O, inertia: )" +
                    inertia + R"(}
joints:
  axle: {revolute: z, at: O, to: rotor, rate: w, accel: 0}
gravity: none
claim: {a: ')" + claim +
                    "'}\n");
  };
  const std::string turning = "kinetic_energy(rotor) == ", size = "1 kg*m^2";
  for (const char* inertia :
       {"{x: any, y: any, z: any, xy: 0, yz: 0, zx: 0}", "{rest: any}", "{axis: z, axial: any, transverse: any}",
        "{x: 1 kg*m^2, y: 1 kg*m^2, z: any, rest: any}"}) {
    const SolvedClaim known = body(inertia, turning + "moment_of_inertia(rotor about z at O)*w^2/2");
    EXPECT_TRUE(known.holds) << inertia << ": " << known.reason;
    for (const std::string& claim :
         {turning + "w^2/2 * 1 kg*m^2", std::string("moment_of_inertia(rotor about z at O) > 1 kg*m^2"),
          std::string("moment_of_inertia(rotor about z at O) >= moment_of_inertia(rotor about x at O)")}) {
      const SolvedClaim chosen = body(inertia, claim);
      EXPECT_FALSE(chosen.holds) << inertia << ": " << claim << (chosen.proved ? ": proved" : ": sampled");
    }
  }
  // Products that are left open bring forces on the axle.
  EXPECT_FALSE(body("{rest: any}", "couple(axle on rotor about O) == 0").holds);
  EXPECT_TRUE(body("{axis: z, axial: any, transverse: any}", "couple(axle on rotor about O) == 0").holds);
}

// At the edges of such claims angles are numbers of many digits, whose sines have no exact form.
TEST(Claims, AnglesWithManyDigits) {
  const std::string bar =
      "letters: {b: deg, L: m, m: kg}\npoints: {O: [0, 0, 0], B: [L*cos(b), L*sin(b), 0]}\n"
      "bodies: {bar: {rod: [O, B], mass: m}}\ngravity: none\nclaim: {a: ";
  EXPECT_TRUE(claim_of(bar + "angle(center(bar) to x) <= 180 deg}\n").holds);
  EXPECT_FALSE(claim_of(bar + "angle(center(bar) to x) <= 179 deg}\n").holds);
  EXPECT_FALSE(claim_of(bar + "angle(center(bar) to x) == b}\n").holds);
}

TEST(Claims, OnListsOfThreeNumbers) {
  const std::string body =
      "letters: {m: kg, I: kg*m^2, J: kg*m^2, K: kg*m^2}\npoints: {O: [0, 0, 0]}\n"
      "bodies: {body: {mass: m, center: O, inertia: {x: I, y: J, z: K, xy: 0, yz: 0, zx: 0}}}\nfacts: rest\n"
      "gravity: none\nclaim: {a: \"moments_of_inertia(body about O) == ";
  const SolvedClaim true_one = claim_of(body + "[I, J, K]\"}\n");
  EXPECT_TRUE(true_one.holds && true_one.proved) << true_one.reason;
  const SolvedClaim false_one = claim_of(body + "[I, K, J]\"}\n");
  EXPECT_EQ(false_one.state, AskState::found);
  EXPECT_FALSE(false_one.holds);
}

// A ball on a table, drawn up by less than its weight; only then the contact stays.
TEST(Claims, OnForcesTakeContactsToHold) {
  const std::string ball =
      "letters: {F: N, m: kg}\ngiven: {g: 9.81 m/s^2}\npoints: {C: [0, 0, 0], G: [0, 0.1 m, 0]}\n"
      "bodies: {ball: {sphere: {center: G, radius: 0.1 m}, mass: m}}\n"
      "contacts: {table: {of: ball, at: C, normal: y}}\nloads: {lift: {force: [0, F, 0], at: G, body: ball}}\n"
      "gravity: [0, -g, 0]\nfacts: rest\nclaim: {a: ";
  const std::vector<std::string> holds{"the contact 'table' presses"};
  EXPECT_EQ(claim_of(ball + "acceleration(ball).y == 0}\n").assumptions, holds);
  EXPECT_EQ(claim_of(ball + "force(table on ball).y == m*g - F}\n").assumptions, holds);
  EXPECT_TRUE(claim_of(ball + "velocity(ball).y == 0}\n").assumptions.empty());
  EXPECT_FALSE(claim_of(ball + "touching(table)}\n").holds);
}

TEST(Claims, BeforeAndAfterABlow) {
  const auto blow = [](const std::string& claim) {
    return claim_of(R"(
letters: {m: kg, L: m, v: m/s, e: 1}
points: {A: [0, 0, 0], B: [L, 0, 0]}
bodies:
  bar: {rod: [A, B], mass: m}
impacts:
  stop: {of: bar, at: A, pushes: y, restitution: e}
instants:
  before: {velocity(bar): [0, -v, 0], angular_velocity(bar): [0, 0, 0]}
gravity: none
assume: [e < 1]
claim: {a: ')" + claim +
                    "'}\n");
  };
  for (const char* claim :
       {"velocity(A of bar).y == -e*(velocity(A of bar).y @ before)", "kinetic_energy(bar) @ before == m*v^2/2",
        "kinetic_energy(bar) @ before - kinetic_energy(bar) @ after == m*v^2*(1 - e^2)/8",
        "kinetic_energy(bar) @ after < kinetic_energy(bar) @ before"}) {
    const SolvedClaim solved = blow(claim);
    ASSERT_EQ(solved.state, AskState::found) << claim << ": " << solved.reason;
    EXPECT_TRUE(solved.holds) << claim;
    EXPECT_TRUE(solved.proved) << claim;
  }
  EXPECT_FALSE(blow("kinetic_energy(bar) @ after == kinetic_energy(bar) @ before").holds);
  EXPECT_FALSE(blow("velocity(bar) @ before == velocity(bar)").holds);
}

// Velocities that nothing fixes before a blow are any, in the numbers as in the formulas.
TEST(Claims, WhatIsOpenBeforeABlowIsAny) {
  const auto blow = [](const std::string& claim) {
    return claim_of(R"(
letters: {m: kg, L: m, J: N*s}
points: {A: [0, 0, 0], B: [L, 0, 0]}
bodies:
  bar: {rod: [A, B], mass: m}
joints:
  pin: {revolute: z, at: A, to: bar, angle: turn}
impulses:
  push: {body: bar, at: B, value: J, along: y}
gravity: none
claim: {a: ")" + claim +
                    "\"}\n");
  };
  const SolvedClaim gained = blow("turn' - (turn' @ before) == 3*J*cos(turn)/(m*L)");
  EXPECT_TRUE(gained.holds && gained.proved) << gained.reason;
  const SolvedClaim from_rest = blow("turn' == 3*J*cos(turn)/(m*L)");
  ASSERT_EQ(from_rest.state, AskState::found) << from_rest.reason;
  EXPECT_FALSE(from_rest.holds);
}

// Whether a cord catches depends on how the body moves.
TEST(Claims, WhichCordActsInABlowIsNotTakenForGranted) {
  const auto blow = [](const std::string& claim, const std::string& assume) {
    return claim_of(R"(
letters: {m: kg, L: m, J: {signed: N*s}}
points: {O: [0, 0, 0], P: [L, 0, 0]}
bodies:
  bob: {particle: P, mass: m}
cords:
  cord: {from: ground, at: O, to: bob, end: P}
impulses:
  push: {body: bob, value: [J, 0, 0]}
instants:
  before: rest
gravity: none
claim: {a: {claim: ')" +
                    claim + "'" + (assume.empty() ? "" : ", assume: [\"" + assume + "\"]") + "}}\n");
  };
  EXPECT_FALSE(blow("velocity(bob).x == 0", "").holds);
  EXPECT_FALSE(blow("velocity(bob).x == J/m", "").holds);
  for (const auto& [claim, assume] :
       {std::pair{"velocity(bob).x == 0", "J > 0 N*s"}, {"velocity(bob).x == J/m", "J < 0 N*s"}}) {
    const SolvedClaim solved = blow(claim, assume);
    EXPECT_TRUE(solved.holds) << claim << " if " << assume << ": " << solved.reason;
  }
}

TEST(WorkedAssumptions, ProductsThatVanishAreSeveralCases) {
  const Formula a = Formula::letter("a", poinsot::Sign::positive), b = Formula::letter("b", poinsot::Sign::positive);
  const Formula x = Formula::letter("x", poinsot::Sign::real), y = Formula::letter("y", poinsot::Sign::real);
  const std::vector<std::string> positive{"a", "b"};
  const WorkedAssumptions either({{a * x, b * x, Relation::equal}}, positive);
  EXPECT_EQ(either.cases().size(), 2U);
  EXPECT_TRUE(either.complete());
  EXPECT_FALSE(either.proves({a, b, Relation::equal}));
  EXPECT_TRUE(either.proves({a * x * x, b * x * x, Relation::equal}));
  // x y^2 = 1: y cannot vanish, but this is not seen before the other case is.
  const WorkedAssumptions inverse({{x * y * y, Formula(1), Relation::equal}}, positive);
  EXPECT_TRUE(inverse.proves({x, Formula(0), Relation::greater_equal}));
  // x y^2 = a y: or y vanishes and x is anything.
  const WorkedAssumptions loose({{x * y * y, a * y * y, Relation::equal}}, positive);
  EXPECT_FALSE(loose.proves({x, Formula(0), Relation::greater}));
  const WorkedAssumptions impossible({{a + b, Formula(0), Relation::equal}}, positive);
  EXPECT_TRUE(impossible.cases().empty());
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

}  // namespace claims_test
}  // namespace poinsot::problem
