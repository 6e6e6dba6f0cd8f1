// Answers that jump are determined only where what decides them is.
#include "problem/answers/watched_values.h"

#include <gtest/gtest.h>

#include <string>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace watched_values_test {

Solution solved(const std::string& text) {
  return solve_statement(read_statement(text, "test.yaml"), {}).solutions.at(0);
}

TEST(WatchedValues, truths_and_extremes_depend_on_their_letters) {
  const Solution solution = solved(R"(
letters: {n: rad/s, m: kg, c: {signed: m}}
points: {O: [0, 0, 0], A: [1 m, 0, 0], C: [c, 0, 0]}
bodies: {p: {rod: [O, A], mass: m}, q: {particle: C, mass: m}}
joints: {s: {revolute: z, at: O, to: p, rate: n}}
gravity: none
ask:
  fast: angular_velocity(p).z > 100 rad/s
  energy: kinetic_energy(p) > 0.01 J
  least: min(norm(velocity(A of p)) with 5 m/s)
  most: max(mass(p) with 100 kg)
  beside: angle(center(q) to x)
  short: distance(O to A) < 2 m
  same: mass(p) == mass(q)
)");
  using Letters = std::vector<std::string>;
  for (const std::size_t i : {0, 1, 2, 4}) EXPECT_EQ(solution.asks[i].state, AskState::needs_letters) << i;
  EXPECT_EQ(solution.asks[0].letters, Letters{"n"});
  EXPECT_EQ(solution.asks[1].letters, (Letters{"n", "m"}));
  EXPECT_EQ(solution.asks[4].letters, Letters{"c"});
  for (const std::size_t i : {0, 1}) EXPECT_FALSE(solution.asks[i].formula.has_value()) << i;
  // The larger and the smaller have formulas, each with the condition under which it is that one.
  const auto told = [&](const std::string& condition) {
    return std::ranges::find(solution.assumptions, condition) != solution.assumptions.end();
  };
  EXPECT_TRUE(told("5 - n > 0 for 'least'"));
  EXPECT_TRUE(told("100 - m > 0 for 'most'"));
  EXPECT_EQ(solution.asks[5].state, AskState::found);
  EXPECT_EQ(solution.asks[6].state, AskState::found);
  EXPECT_TRUE(solution.asks[6].value.truth);
}

TEST(WatchedValues, truths_depend_on_what_is_any) {
  const Solution solution = solved(R"(
bodies: {p: {mass: any, center: [0, 0, 0], inertia: {axis: z, axial: 1 kg*m^2, transverse: 1 kg*m^2}}}
gravity: none
facts: {angular_velocity(p): 0, velocity(p): [2 m/s, 0, 0]}
ask: {T: kinetic_energy(p) < 1000 J, m: mass(p) < 10 kg, least: min(mass(p) with 0.1 kg), v: velocity(p).x > 1 m/s}
)");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(solution.asks[i].state, AskState::undetermined) << i;
  EXPECT_EQ(solution.asks[3].state, AskState::found);
}

TEST(WatchedValues, truths_depend_on_open_velocities) {
  const Solution solution = solved(R"(
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {p: {particle: A, mass: 2 kg}}
joints: {s: {revolute: z, at: O, to: p, accel: 2 rad/s^2}}
gravity: -y
ask: {v: norm(velocity(p)) < 1000 m/s, least: min(norm(velocity(p)) with 0 m/s), a: angular_acceleration(p).z > 1 rad/s^2}
)");
  EXPECT_EQ(solution.asks[0].state, AskState::undetermined);
  EXPECT_EQ(solution.asks[1].state, AskState::undetermined);
  EXPECT_EQ(solution.asks[2].state, AskState::found);
}

TEST(WatchedValues, a_top_is_not_unstable_whatever_its_spin) {
  const Solution solution = solved(R"(
letters: {S: rad/s}
given: {m: 0.5 kg, h: 120 mm, r: 40 mm}
points: {O: [0, 0, 0], T: [0, 0, h]}
bodies: {top: {cone: {apex: O, base: T, radius: r}, mass: m}}
joints: {tip: {ball: O, to: top}}
steady: {frame: ground, spins: {top: {about: O->T, rate: S}}}
gravity: -z
ask: {stable: stable(top), word: stability(top)}
)");
  EXPECT_EQ(solution.asks[0].state, AskState::needs_letters);
  EXPECT_EQ(solution.asks[1].state, AskState::needs_letters);
}

TEST(WatchedValues, a_sense_depends_on_the_moments_of_inertia) {
  const Solution solution = solved(R"(
letters: {I: kg*m^2, J: kg*m^2, p: rad/s, q: rad/s}
points: {G: [0, 0, 0]}
bodies: {s: {mass: 9 kg, center: G, inertia: {axis: z, axial: I, transverse: J}}}
facts: {angular_velocity(s): [p, 0, q]}
gravity: none
ask: {sense: precession_sense(s), course: polhode(s)}
)");
  EXPECT_EQ(solution.asks[0].state, AskState::needs_letters);
  EXPECT_EQ(solution.asks[1].state, AskState::needs_letters);
}

TEST(WatchedValues, contacts_hold_for_some_values_of_the_letters) {
  const Solution solution = solved(R"(
letters: {F: N}
gravity: -y
points: {G: [0, 0, 0], C: [0, -30 mm, 0]}
bodies: {ball: {sphere: {center: G, radius: 30 mm}, mass: 2 kg}}
contacts: {table: {of: ball, against: ground, at: C, normal: y}}
loads: {pull: {force: '[F*cos(20 deg), F*sin(20 deg), 0]', body: ball}}
instants: {now: rest}
ask: {touching: touching(table), N: force(table on ball).y}
)");
  EXPECT_EQ(solution.asks[0].state, AskState::needs_letters);
  // The formula holds where the contact presses, and says so.
  ASSERT_TRUE(solution.asks[1].formula.has_value());
  ASSERT_EQ(solution.assumptions.size(), 1U);
  EXPECT_EQ(solution.assumptions.front(), "the contact 'table' presses");
}

}  // namespace watched_values_test
}  // namespace poinsot::problem
