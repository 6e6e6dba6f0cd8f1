// Claims about what is found: unknowns as formulas, and squares of unknowns that are neglected.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace claims_of_unknowns_test {

SolvedStatement solved(const std::string& text) {
  return solve_statement(read_statement(text, "claims_of_unknowns.yaml"), {});
}

// A shell whose axis precesses slowly about its path: exact (J - I) cos(b) w^2 - I S w + D c = 0.
const std::string shell = R"(
points: {G: [0, 0, 0], P: [c*cos(b), 0, c*sin(b)]}
frames:
  figure: {rides_on: center(shell), turns: x, rate: w}
bodies:
  shell: {mass: m, center: G, inertia: {axis: G->P, axial: I, transverse: J}}
loads:
  drag: {force: [-D, 0, 0], at: P, body: shell}
steady: {frame: figure, spins: {shell: {about: G->P, rate: S}}}
gravity: none
find: {w: rad/s}
)";
const std::string shell_in_letters = "letters: {m: kg, b: rad, S: rad/s, D: N, c: m, I: kg*m^2, J: kg*m^2}\n" + shell;
const std::string shell_in_numbers =
    "given: {m: 5 kg, b: 4 deg, S: 300 rad/s, D: 60 N, c: 100 mm, I: 0.008 kg*m^2, J: 0.128 kg*m^2}\n" + shell;

TEST(ClaimsOfUnknowns, HoldToFirstOrderInWhatIsNeglected) {
  const std::string claims = R"(neglect: [w^2]
claim:
  rate: angular_velocity(figure).x == D*c/(I*S)
  momentum: angular_momentum(shell about G).x == I*S*cos(b) + (I*cos(b)^2 + J*sin(b)^2)*w
  square: angular_velocity(figure).x^2 == 0
  twice: angular_velocity(figure).x == 2*D*c/(I*S)
)";
  for (const std::string& statement : {shell_in_letters, shell_in_numbers}) {
    const SolvedStatement found = solved(statement + claims);
    ASSERT_EQ(found.solutions.size(), 1U);
    const auto& all = found.solutions.front().claims;
    for (const std::size_t k : {0U, 1U, 2U}) {
      EXPECT_EQ(all[k].state, AskState::found) << k << all[k].reason;
      EXPECT_TRUE(all[k].holds && all[k].proved) << k;
      EXPECT_NE(std::find(all[k].assumptions.begin(), all[k].assumptions.end(), "w^2 is neglected"),
                all[k].assumptions.end());
    }
    EXPECT_EQ(all[3].state, AskState::found) << all[3].reason;
    EXPECT_FALSE(all[3].holds);
    ASSERT_TRUE(all[3].sides);
    EXPECT_NEAR(2 * all[3].sides->first, all[3].sides->second, 1e-12 * all[3].sides->second);
  }
}

TEST(ClaimsOfUnknowns, ThoseOfStabilityHaveNoFirstOrder) {
  const SolvedStatement found = solved(shell_in_numbers + "neglect: [w^2]\nclaim: {c: stable(shell)}\n");
  EXPECT_EQ(found.solutions.at(0).claims.at(0).state, AskState::undetermined);
  EXPECT_NE(found.solutions.at(0).claims.at(0).reason.find("neglected"), std::string::npos);
}

TEST(ClaimsOfUnknowns, FormulasOfUnknownsLeaveOutTheSquares) {
  const SolvedStatement found = solved(shell_in_letters + "neglect: [w^2]\nask: {w: angular_velocity(figure).x}\n");
  ASSERT_EQ(found.solutions.size(), 1U);
  const Solution& solution = found.solutions.front();
  ASSERT_TRUE(solution.unknowns.at(0).formula);
  EXPECT_EQ(text(solution.unknowns.at(0).formula->number), "c*D/(I*S)");
  // Exactly, and by no law.
  EXPECT_TRUE(solution.notes.empty()) << solution.notes.front();
}

TEST(ClaimsOfUnknowns, TakeTheirFormulas) {
  const SolvedStatement found = solved(shell_in_letters + R"(ask: {w: angular_velocity(figure).x}
claim:
  wrong: (J - I)*cos(b)*angular_velocity(figure).x^2 + I*S*angular_velocity(figure).x + D*c == 0
  linear: I*S*angular_velocity(figure).x == D*c
  condition: (J - I)*cos(b)*angular_velocity(figure).x^2 - I*S*angular_velocity(figure).x + D*c == 0
)");
  ASSERT_EQ(found.solutions.size(), 2U);
  for (const Solution& solution : found.solutions) {
    EXPECT_FALSE(solution.claims.at(0).holds);
    EXPECT_EQ(solution.claims.at(1).state, AskState::found) << solution.claims[1].reason;
    EXPECT_FALSE(solution.claims.at(1).holds);
    EXPECT_EQ(solution.claims.at(2).state, AskState::found) << solution.claims[2].reason;
    EXPECT_TRUE(solution.claims.at(2).holds && solution.claims.at(2).proved);
  }
}

TEST(ClaimsOfUnknowns, AreNotDecidedWhereThereIsNoFormula) {
  const SolvedStatement found = solved(R"(
letters: {L: m}
find: {b: rad}
where: [1 deg < b < 170 deg]
points: {O: [0, 0, 0], P: [0, -L, 0]}
bodies:
  rod: {rod: [O, P], mass: 2 kg}
joints:
  pin: {revolute: z, at: O, to: rod, angle: b, rate: 0, spring: {stiffness: 20 N*m/rad, free_angle: 3 rad}}
gravity: -y
instants:
  now: {"b''": 0}
ask: {W: weight(rod)}
claim: {c: center(rod).x > 0 m}
)");
  ASSERT_GE(found.solutions.size(), 1U);
  const SolvedClaim& claim = found.solutions.front().claims.at(0);
  EXPECT_EQ(claim.state, AskState::undetermined);
  EXPECT_NE(claim.reason.find("the unknown 'b'"), std::string::npos) << claim.reason;
  EXPECT_NE(claim.reason.find("--set"), std::string::npos) << claim.reason;
  // The questions of the file are answered all the same.
  EXPECT_NE(found.solutions.front().asks.at(0).state, AskState::undetermined);
}

}  // namespace claims_of_unknowns_test
}  // namespace poinsot::problem
