// What may stand under where:, how poses are told apart, and letters for which nothing is found.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "problem/answers/solve_statement.h"
#include "problem/language/failure.h"

namespace poinsot::problem {
namespace unknown_ranges_test {

SolvedStatement solved(const std::string& text) { return solve_statement(read_statement(text, "test.yaml"), {}); }

std::string whirled(const std::string& where, const std::string& facts) {
  return "find: {n: rad/s}\nwhere: [" + where +
         "]\npoints: {O: [0, 0, 0], A: [1 m, 0, 0]}\nbodies: {p: {particle: A, mass: 2 kg}}\n"
         "joints: {s: {revolute: z, at: O, to: p, rate: n, accel: 0}}\ngravity: none\n" +
         facts + "ask: {n: n}\n";
}

TEST(Where, equations_are_sent_to_the_facts) {
  const auto message = [](const std::string& where) { return failure_of([&] { solved(whirled(where, "")); }); };
  const std::string equation = message("n > 0, n^2 == 9 rad^2/s^2");
  EXPECT_TRUE(equation.starts_with("test.yaml:2:16: error: ")) << equation;
  EXPECT_NE(equation.find("fixes something"), std::string::npos) << equation;
  EXPECT_NE(message("norm(force(s on p)) == 50 N").find("facts: {\"norm(force(s on p))\": 50 N}"), std::string::npos);
}

TEST(Where, bounds_of_quantities_tell_solutions_apart) {
  const std::string facts = "facts: {norm(force(s on p)): 50 N}\n";
  EXPECT_EQ(solved(whirled("n < 100 rad/s", facts)).solutions.size(), 2U);
  const SolvedStatement one = solved(whirled("velocity(p).y < 0 m/s", facts));
  ASSERT_EQ(one.solutions.size(), 1U);
  EXPECT_NEAR(one.solutions[0].asks[0].value.number, -5, 1e-9);
}

std::vector<double> angles_of(const std::string& text) {
  std::vector<double> found;
  for (const Solution& solution : solved(text).solutions) found.push_back(solution.asks[0].value.number);
  return found;
}

TEST(Poses, equilibrium_at_zero_is_found) {
  const std::vector<double> found = angles_of(R"(
find: {b: deg}
where: [-20 deg < b < 20 deg]
points: {O: [0, 0, 0], A: [0, -1 m, 0]}
bodies: {p: {rod: [O, A], mass: 2 kg}}
joints: {q: {revolute: z, at: O, to: p, angle: b, rate: 0}}
gravity: -y
facts: {"b''": 0}
ask: {b: b}
)");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0], 0);
}

TEST(Poses, a_half_turn_is_one_pose) {
  const std::vector<double> found = angles_of(R"(
given: {n: 6 rad/s}
find: {b: deg}
points: {O: [0, 0, 0], A: [0, -1 m, 0]}
bodies: {sh: massless, p: {rod: [O, A], mass: 2 kg}}
joints:
  d: {revolute: y, at: O, to: sh, rate: n, accel: 0}
  q: {revolute: z, at: O, from: sh, to: p, angle: b, rate: 0}
gravity: -y
facts: {"b''": 0}
ask: {b: b}
)");
  // cos b = 3 g/(2 n^2 L) beside hanging and standing.
  ASSERT_EQ(found.size(), 4U);
  EXPECT_NEAR(found[0], -std::acos(1.5 * 9.80665 / 36), 1e-9);
  EXPECT_EQ(found[1], 0);
  EXPECT_NEAR(found[2], std::acos(1.5 * 9.80665 / 36), 1e-9);
  EXPECT_NEAR(found[3], 3.141592653589793, 1e-9);
}

TEST(Letters, where_nothing_is_found_the_drawn_values_are_told) {
  const SolvedStatement none = solved(R"(
letters: {m: kg}
find: {w: rad/s}
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {p: {particle: A, mass: m}}
joints: {s: {revolute: z, at: O, to: p, rate: w, accel: 0}}
gravity: none
facts: {kinetic_energy(p): -1 J}
ask: {w: w}
)");
  EXPECT_TRUE(none.solutions.empty());
  ASSERT_FALSE(none.warnings.empty());
  EXPECT_NE(none.warnings[0].find("the letters have no values: they were drawn"), std::string::npos)
      << none.warnings[0];
}

// A governor that turns too slowly to lift its weights: close to b = 0 its conditions hold up to rounding, which is no
// root below zero.
TEST(Where, a_root_at_the_end_of_a_range_is_none_below_zero) {
  const SolvedStatement none = solved(R"(
given: {m: 2.5 kg, M: 0.85 kg, L: 2.7 m, w: 1.1 rad/s}
find: {b: rad}
where: [0 < b < 90 deg]
points: {O: [0, 0, 0], A: [L*sin(b), -L*cos(b), 0], B: [-L*sin(b), -L*cos(b), 0], S: [0, -2*L*cos(b), 0]}
bodies:
  shaft: massless
  la: massless
  lb: massless
  ka: massless
  kb: massless
  pa: {particle: A, mass: m}
  pb: {particle: B, mass: m}
  sleeve: {particle: S, mass: M}
joints:
  j: {revolute: y, at: O, to: shaft, rate: w, accel: 0}
  g: {prismatic: y, at: S, from: shaft, to: sleeve}
  p1: {revolute: z, at: O, from: shaft, to: la}
  p2: {revolute: z, at: O, from: shaft, to: lb}
  w1: {weld: A, from: la, to: pa}
  w2: {weld: B, from: lb, to: pb}
  q1: {revolute: z, at: S, from: sleeve, to: ka}
  q2: {revolute: z, at: S, from: sleeve, to: kb}
  e1: {revolute: z, at: A, from: la, to: ka}
  e2: {revolute: z, at: B, from: lb, to: kb}
steady: {frame: shaft}
gravity: -y
ask: {b: b}
)");
  EXPECT_TRUE(none.solutions.empty());
  ASSERT_FALSE(none.warnings.empty());
  EXPECT_EQ(none.warnings[0].find("taken as not negative"), std::string::npos) << none.warnings[0];
}

// Two of three jets would have to burn for a negative time.
TEST(Where, a_root_below_zero_is_told_where_none_is_in_the_ranges) {
  const std::string text = R"(
find: {t: s, u: s, v: s}
points: {G: [0, 0, 0]}
bodies: {sat: {mass: 9 kg, center: G, inertia: {x: 2 kg*m^2, y: 3 kg*m^2, z: 4 kg*m^2}}}
impulses:
  roll: {body: sat, couple: [t*1 N*m, 0, 0]}
  pitch: {body: sat, couple: [0, u*1 N*m, 0]}
  yaw: {body: sat, couple: [0, 0, v*1 N*m]}
gravity: none
instants:
  before: {angular_velocity(sat): [2 rad/s, 3 rad/s, -1 rad/s]}
  after: {angular_velocity(sat): [0, 0, 0]}
ask: {t: t}
)";
  const SolvedStatement none = solved(text);
  EXPECT_TRUE(none.solutions.empty());
  ASSERT_FALSE(none.warnings.empty());
  EXPECT_NE(none.warnings[0].find("they hold with t = -4 s, u = -9 s, v = 4 s, but t and u are taken as not negative"),
            std::string::npos)
      << none.warnings[0];
  // What the file itself excludes is not told as if it had been taken so.
  const SolvedStatement excluded = solved("where: [t > 0 s]\n" + text);
  ASSERT_FALSE(excluded.warnings.empty());
  EXPECT_EQ(excluded.warnings[0].find("taken as not negative"), std::string::npos) << excluded.warnings[0];
  const SolvedStatement allowed = solved("where: [t > -10 s, u > -10 s]\n" + text);
  ASSERT_EQ(allowed.solutions.size(), 1U);
  EXPECT_NEAR(allowed.solutions[0].asks[0].value.number, -4, 1e-12);
  std::string of_either_sign = text;
  of_either_sign.replace(text.find("{t: s, u: s"), 11, "{t: {signed: s}, u: {signed: s}");
  const SolvedStatement either = solved(of_either_sign);
  ASSERT_EQ(either.solutions.size(), 1U);
  EXPECT_NEAR(either.solutions[0].asks[0].value.number, -4, 1e-12);
}

// A weight that is to be found is no less than zero, as a mass is; no sign turned round makes it negative.
TEST(Where, weights_and_densities_are_not_negative) {
  const auto hung = [](const std::string& unit, const std::string& amount, const std::string& pull) {
    return solved("find: {w: " + unit + R"(}
points: {O: [0, 0, 0], P: [1 m, 0, 0]}
bodies: {b: {rod: [O, P], )" +
                  amount + R"(}}
joints: {j: {weld: O, to: b}}
gravity: -y
facts: {reaction(j).y: )" +
                  pull + R"(}
ask: {w: w}
)");
  };
  const SolvedStatement right = hung("N", "weight: w", "20 N");
  ASSERT_EQ(right.solutions.size(), 1U);
  EXPECT_NEAR(right.solutions[0].asks[0].value.number, 20, 1e-12);
  EXPECT_EQ(hung("{signed: kg}", "mass: w", "20 N").solutions.size(), 1U);
  for (const auto& [unit, amount] : {std::pair{"N", "weight: w"},
                                     {"kg", "mass: w"},
                                     {"kg/m", "density: w"},
                                     {"{signed: kg}", "mass: w"},
                                     {"{signed: lb}", "weight: w"}}) {
    const SolvedStatement none = hung(unit, amount, "-20 N");
    EXPECT_TRUE(none.solutions.empty()) << amount;
    ASSERT_FALSE(none.warnings.empty()) << amount;
    EXPECT_NE(none.warnings[0].find("but w is taken as not negative (no body has a negative mass: what is cut out of "
                                    "one stands under added: with hole: true)"),
              std::string::npos)
        << none.warnings[0];
  }
}

// One ask that the statement does not answer leaves the others.
TEST(Motions, that_are_not_fixed_leave_the_other_asks) {
  const SolvedStatement all = solved(R"(
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {b: {rod: [O, A], mass: 3 kg}}
joints: {j: {revolute: z, at: O, to: b, accel: 3 rad/s^2}}
gravity: none
ask: {a: angular_acceleration(b).z, w: angular_velocity(b).z @ 2 s}
)");
  EXPECT_EQ(all.solutions.at(0).asks[0].state, AskState::found);
  EXPECT_EQ(all.solutions.at(0).asks[1].state, AskState::undetermined);
  EXPECT_NE(all.solutions.at(0).asks[1].reason.find("the rate of joint 'j' is unknown"), std::string::npos);
}

TEST(Extrema, of_signed_letters_are_sought_on_both_sides) {
  const SolvedStatement all = solved(R"(
letters: {c: {signed: m}}
points: {A: [c, 0, 0]}
bodies: {p: {particle: A, mass: 1 kg}}
ask:
  left: {smallest: c, while: center(p).x > -3 m}
  right: {largest: c, while: center(p).x < -3 m}
)");
  for (const SolvedAsk& ask : all.solutions.at(0).asks) {
    EXPECT_EQ(ask.state, AskState::found) << ask.reason;
    EXPECT_NEAR(ask.value.number, -3, 1e-9);
  }
}

}  // namespace unknown_ranges_test
}  // namespace poinsot::problem
