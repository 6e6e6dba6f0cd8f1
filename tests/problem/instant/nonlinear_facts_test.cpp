// Facts about energies, sizes, directions and impulses: conditions on data that are to be found.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace nonlinear_facts_test {

SolvedStatement solved(const std::string& text) { return solve_statement(read_statement(text, "test.yaml"), {}); }

std::string failure_of(const std::string& text) {
  try {
    solved(text);
  } catch (const StatementError& error) {
    return error.what();
  }
  return "no error";
}

double number(const SolvedStatement& solution, std::size_t ask = 0, std::size_t root = 0) {
  const SolvedAsk& one = solution.solutions.at(root).asks.at(ask);
  EXPECT_EQ(one.state, AskState::found) << one.reason;
  return one.value.number;
}

// A rod that turns about its end, with what is said of it.
std::string turning_rod(const std::string& find, const std::string& facts, const std::string& rate,
                        const std::string& asks) {
  return "title: a turning rod\ngravity: -y\npoints: {O: [0, 0, 0], A: [0.8 m, 0, 0]}\n"
         "bodies: {bar: {rod: [O, A], mass: m}}\n" +
         (find.empty() ? "given: {m: 3 kg}\n" : "find: {" + find + "}\n") +
         "joints: {pin: {revolute: z, at: O, to: bar" + rate + "}}\nfacts: {" + facts + "}\nask: {" + asks + "}\n";
}

// T = m L^2 w^2/6, H = m L^2 w/3: w = 2 T/H.
TEST(NonlinearFacts, MassAndRateFromEnergyAndMomentum) {
  const SolvedStatement solution =
      solved(turning_rod("m: kg, w: rad/s", "kinetic_energy(bar): 10 J, angular_momentum(bar about O).z: 5 kg*m^2/s",
                         ", rate: w", "m: m, w: w"));
  ASSERT_EQ(solution.solutions.size(), 1U);
  EXPECT_NEAR(number(solution, 0), 3 * 5 / (0.64 * 4), 1e-9);
  EXPECT_NEAR(number(solution, 1), 4, 1e-9);
}

TEST(NonlinearFacts, AnEnergyLeavesTheSenseOpen) {
  const SolvedStatement solution =
      solved(turning_rod("m: kg, w: rad/s", "kinetic_energy(bar): 10 J, mass(bar): 3 kg", ", rate: w", "w: w"));
  ASSERT_EQ(solution.solutions.size(), 2U);
  EXPECT_NEAR(number(solution, 0, 0), -std::sqrt(60 / (3 * 0.64)), 1e-9);
  EXPECT_NEAR(number(solution, 0, 1), std::sqrt(60 / (3 * 0.64)), 1e-9);
}

// Released level, the pin carries m g/4 upwards and m w^2 L/2 towards itself.
TEST(NonlinearFacts, ARateFromTheSizeOfAReaction) {
  const SolvedStatement solution =
      solved(turning_rod("m: kg, w: rad/s", "mass(bar): 3 kg, norm(force(pin on bar)): 100 N", ", rate: w", "w: w"));
  ASSERT_EQ(solution.solutions.size(), 2U);
  const double up = 3 * 9.80665 / 4, in = std::sqrt(100 * 100 - up * up);
  EXPECT_NEAR(number(solution, 0, 1), std::sqrt(in / (3 * 0.4)), 1e-9);
  EXPECT_NEAR(number(solution, 0, 0), -number(solution, 0, 1), 1e-12);
}

TEST(NonlinearFacts, ADirectionThatARestingThingHasNot) {
  const SolvedStatement solution = solved(R"(title: how far askew a disk is, from the angle of its angular momentum
given: {a: 10 deg}
find: {b: deg}
where: [0 deg < b < 40 deg]
gravity: none
points: {G: [0, 0, 0]}
directions: {across: '[cos(b), sin(b), 0]'}
bodies: {disk: {disk: {center: G, normal: across, radius: 150 mm}, mass: 8 kg}}
joints: {shaft: {revolute: x, at: G, to: disk, rate: 90 rad/s}}
facts: {angle(angular_momentum(disk about G) to x): a}
ask: {b: b}
)");
  // tan a = sin b cos b / (1 + cos^2 b) twice below the largest.
  ASSERT_EQ(solution.solutions.size(), 1U);
  const double b = number(solution);
  EXPECT_NEAR(std::sin(b) * std::cos(b) / (1 + std::cos(b) * std::cos(b)), std::tan(10 * 3.141592653589793 / 180),
              1e-9);
}

TEST(NonlinearFacts, WhereTheyContradictTheDataTheyAreNamed) {
  const std::string text = turning_rod("", "kinetic_energy(bar): 10 J", ", rate: 2 rad/s", "H: momentum(bar)");
  EXPECT_NE(failure_of(text).find("test.yaml:7:9: error: 'kinetic_energy(bar)' is not what is stated"),
            std::string::npos)
      << failure_of(text);
  // m L^2 w^2/6 = 1.28 J at 2 rad/s.
  EXPECT_EQ(failure_of(turning_rod("", "kinetic_energy(bar): 1.28 J", ", rate: 2 rad/s", "H: momentum(bar)")),
            "no error");
}

TEST(NonlinearFacts, TheyFixNoMotionThemselves) {
  const std::string velocities = failure_of(turning_rod("", "kinetic_energy(bar): 10 J", "", "H: momentum(bar)"));
  EXPECT_NE(velocities.find("test.yaml:7:9: error: 'kinetic_energy(bar)' is not linear in the velocities"),
            std::string::npos)
      << velocities;
  EXPECT_NE(velocities.find("make a rate an unknown under find:"), std::string::npos) << velocities;
  const std::string forces = failure_of(R"(title: a shaft held lengthwise twice
gravity: -y
points: {A: [0, 0, 0], B: [1 m, 0, 0]}
bodies: {bar: {rod: [A, B], mass: 10 kg}}
joints: {shaft: {revolute: x, at: A, to: bar, rate: 0, supports: {A: [x, y, z], B: [x, y, z]}}}
loads: {push: {force: [300 N, 0, 0], at: A, body: bar}}
facts: {norm(reaction(A)): 200 N}
ask: {B: reaction(B).x}
)");
  EXPECT_NE(forces.find("'norm(reaction(A))' is not linear in the accelerations and forces"), std::string::npos)
      << forces;
}

// A blow at the center of percussion, 2 L/3 from the pin.
TEST(NonlinearFacts, WhereABlowIsNotFeltAtThePin) {
  const SolvedStatement solution = solved(R"(title: where to hit a rod
find: {d: m}
gravity: none
points: {O: [0, 0, 0], A: [0, -1.2 m, 0]}
bodies: {bar: {rod: [O, A], mass: 4 kg}}
joints: {pin: {revolute: z, at: O, to: bar}}
impulses: {blow: {body: bar, at: '[0, -d, 0]', value: [5 N*s, 0, 0]}}
instants:
  before: rest
  after: {impulse(pin on bar): [0, 0, 0]}
ask: {d: d, w: angular_velocity(bar).z}
)");
  ASSERT_EQ(solution.solutions.size(), 1U);
  EXPECT_NEAR(number(solution, 0), 0.8, 1e-12);
  EXPECT_NEAR(number(solution, 1), 5 * 0.8 * 3 / (4 * 1.44), 1e-9);
}

// J from the size of what the pin feels, and from the energy it brings.
TEST(NonlinearFacts, ABlowFromItsImpulseAtThePinOrItsEnergy) {
  const auto text = [](const std::string& after) {
    return "title: a blow\nfind: {J: N*s}\nwhere: [J > 0]\ngravity: none\n"
           "points: {O: [0, 0, 0], A: [0, -1.2 m, 0]}\n"
           "bodies: {bar: {rod: [O, A], mass: 4 kg}}\njoints: {pin: {revolute: z, at: O, to: bar}}\n"
           "impulses: {blow: {body: bar, at: A, value: [J, 0, 0]}}\n"
           "instants:\n  before: rest\n  after: {" +
           after + "}\nask: {J: J}\n";
  };
  // The pin feels J/2; T = (J L)^2/(2 I) = 3 J^2/(2 m).
  EXPECT_NEAR(number(solved(text("impulse(pin on bar).x: 3 N*s"))), 6, 1e-9);
  EXPECT_NEAR(number(solved(text("norm(impulse(pin on bar)): 3 N*s"))), 6, 1e-9);
  EXPECT_NEAR(number(solved(text("kinetic_energy(bar): 6 J"))), 4, 1e-9);
  EXPECT_NEAR(number(solved(text("kinetic_energy(bar) - kinetic_energy(bar) @ before: 6 J"))), 4, 1e-9);
}

TEST(NonlinearFacts, AnImpulseIsKnownAfterTheBlowOnly) {
  const std::string said = failure_of(R"(title: a blow
find: {J: N*s}
gravity: none
points: {O: [0, 0, 0], A: [0, -1.2 m, 0]}
bodies: {bar: {rod: [O, A], mass: 4 kg}}
joints: {pin: {revolute: z, at: O, to: bar, rate: 0}}
impulses: {blow: {body: bar, at: A, value: [J, 0, 0]}}
instants:
  before: {impulse(pin on bar).x: 3 N*s}
ask: {J: J}
)");
  EXPECT_NE(said.find("impulse() is known after the blow, not before it"), std::string::npos) << said;
}

}  // namespace nonlinear_facts_test
}  // namespace poinsot::problem
