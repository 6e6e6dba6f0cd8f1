// Formulas hold for all values of their letters, or are none.
#include "problem/formulas/formula_reach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "problem/answers/solve_statement.h"
#include "problem/formulas/formula_conditions.h"

namespace poinsot::problem {
namespace formula_reach_test {

Solution solved(const std::string& text) {
  return solve_statement(read_statement(text, "test.yaml"), {}).solutions.at(0);
}

// Struck near its end, a rod on a table turns about its mass center so fast that the other end would go down: then the
// table pushes, else it does not.
TEST(FormulaReach, a_blow_depends_on_where_it_comes) {
  const Solution solution = solved(R"(
letters: {m: kg, L: m, J: N*s, a: mm}
points: {A: [0, 0, 0], B: [L, 0, 0], C: [a, 0, 0]}
bodies: {p: {rod: [A, B], mass: m}}
contacts: {f: {of: p, at: A, normal: y}}
impulses: {j: {body: p, at: C, value: [0, J, 0]}}
instants: {before: rest}
gravity: -y
ask: {f: impulse(f on p)}
)");
  ASSERT_TRUE(solution.asks[0].formula.has_value());
  ASSERT_EQ(solution.asks[0].regimes.size(), 2U);
  for (const RegimeFormula& one : solution.asks[0].regimes) {
    const bool pushes = !one.formula.vector.y.is_zero();
    EXPECT_EQ(one.where, std::vector<std::string>{pushes ? "3*a - 2*L > 0" : "2*L - 3*a > 0"});
  }
}

// A ladder whose foot is pulled along so fast that the floor would have to pull it down: at the forces that this takes
// numbers tell a contradiction, where the formula is only beyond its condition.
TEST(FormulaReach, does_not_hold_against_a_formula_where_a_contact_would_pull) {
  const Solution solution = solved(R"(
letters: {m: kg, L: m, b: rad, v: m/s}
points: {A: '[L*cos(b), 0, 0]', B: '[0, L*sin(b), 0]'}
bodies: {ladder: {rod: [A, B], mass: m}}
contacts:
  foot: {of: ladder, corner: A, normal: y}
  wall: {of: ladder, corner: B, normal: x}
loads: {pull: {force: [P, 0, 0], at: A, body: ladder}}
gravity: -y
find: {P: {signed: N}}
facts: {velocity(A of ladder): [v, 0, 0], acceleration(A of ladder).x: 0, angular_velocity(ladder).x: 0}
ask: {N: normal_force(foot), W: normal_force(wall)}
)");
  const double g = 9.80665, m = 10, L = 3, b = 1.1, v = 1;
  const LetterValues at{{"m", m}, {"L", L}, {"b", b}, {"v", v}};
  ASSERT_TRUE(solution.asks[0].formula && solution.asks[1].formula) << solution.asks[0].no_formula;
  const double square = v * v / (L * std::pow(std::sin(b), 3));
  EXPECT_NEAR(value_at(solution.asks[0].formula->number, at), m * (g - square / 2), 1e-9);
  EXPECT_NEAR(value_at(solution.asks[1].formula->number, at), m * (g / 2 - square / 3) / std::tan(b), 1e-9);
  EXPECT_EQ(std::ranges::count(solution.assumptions, "the contact 'foot' presses"), 1);
}

// The letters make no group, but the second that the motion lasts makes one of the speed.
TEST(FormulaReach, numbers_of_the_file_make_groups_of_a_letter) {
  const Solution solution = solved(R"t(
letters: {v: m/s, m: kg}
points: {O: [0, 0, 0]}
bodies: {b: {particle: O, mass: m}}
joints: {mast: {prismatic: y, at: O, to: b, displacement: h}}
gravity: -y
instants: {start: {h: 0, "h'": v}}
stages: {run: {lasts: 1 s}}
ask: {top: max(h)}
)t");
  const SolvedAsk& ask = solution.asks[0];
  const bool told = !ask.formula || !ask.regimes.empty() ||
                    std::ranges::any_of(solution.grounds, [](const auto& one) { return !one.inequality.empty(); });
  EXPECT_TRUE(told) << "v^2/(2 g) for all v";
}

// A pendulum in a lift that falls: the bound is the standard gravity, 9.80665 m/s^2, and no simple number beside it.
TEST(FormulaReach, a_bound_is_not_rounded_to_a_simple_number) {
  const Solution solution = solved(R"t(
given: {L: 0.6 m, b: 50 deg}
letters: {a: m/s^2}
points: {O: [0, 0, 0], P: [0, -L, 0]}
frames: {lift: {velocity: [0, 0, 0], acceleration: [0, -a, 0]}}
bodies: {bob: {particle: P, mass: 1 kg}}
joints: {pin: {revolute: z, at: O, from: lift, to: bob, angle: q}}
gravity: -y
instants: {start: {q: b, "q'": 0}}
ask: {fast: "max(abs(q'))"}
)t");
  const auto holds = [](const std::vector<std::string>& where, double a) {
    return std::ranges::all_of(where, [&](const std::string& one) {
      return holds_as_told(one, {{"a", parse_unit("m/s^2"), Mark{}}}, {{"a", a}}) == true;
    });
  };
  ASSERT_EQ(solution.asks[0].regimes.size(), 2U);
  for (const RegimeFormula& one : solution.asks[0].regimes) {
    const bool hangs = holds(one.where, 5);
    EXPECT_EQ(holds(one.where, 9.803), hangs) << one.where.front();
    EXPECT_EQ(holds(one.where, 9.81), !hangs) << one.where.front();
  }
}

// Whatever formula is given for an angle between lines agrees with numbers in every quadrant.
TEST(FormulaReach, angles_agree_in_every_quadrant) {
  const std::string text = R"(
letters: {b: deg, m: kg, L: m}
points: {O: [0, 0, 0], A: [L*cos(b), L*sin(b), 0]}
bodies: {p: {rod: [O, A], mass: m}}
joints: {s: {revolute: z, at: O, to: p, rate: 2 rad/s}}
gravity: -y
ask: {t: angle(center(p) to x), acute: acute_angle(center(p) to x), q: atan(center(p).y/center(p).x), a: angular_acceleration(p).z}
)";
  const Solution solution = solved(text);
  EXPECT_TRUE(solution.asks[3].formula.has_value());
  // An acute angle is told to be one where the angle is.
  const bool told = std::count(solution.assumptions.begin(), solution.assumptions.end(), "cos(b) > 0 for 'acute'") > 0;
  EXPECT_TRUE(told || !solution.asks[1].formula);
  constexpr double pi = 3.141592653589793;
  for (const double b : {0.4, 1.9, -2.3, -0.7}) {
    const LetterValues letters{{"b", b}, {"m", 2}, {"L", 1.5}};
    const double acute = std::min(std::abs(b), pi - std::abs(b));
    const double expected[] = {std::abs(b), acute, std::atan(std::tan(b))};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(solution.asks[i].state, AskState::needs_letters);
      if (solution.asks[i].formula && (i != 1 || std::cos(b) > 0)) {
        EXPECT_NEAR(value_at(solution.asks[i].formula->number, letters), expected[i], 1e-9) << i << " at " << b;
      }
    }
  }
}

// What a cord or a contact must do is told as a formula where it may fail to, and only there.
TEST(FormulaReach, what_must_pull_or_push_is_told_as_a_formula) {
  const std::string bob = R"(
letters: {m: kg, L: m, v: m/s, b: rad, g: m/s^2}
points: {O: [0, 0, 0], B: [L*sin(b), -L*cos(b), 0]}
bodies: {bob: {particle: B, mass: m}}
cords: {cord: {at: O, to: bob, end: B}}
gravity: -y
facts: {velocity(bob): [v*cos(b), v*sin(b), 0]}
ask: {a: acceleration(bob)}
)";
  const Solution swings = solved(bob);
  ASSERT_EQ(swings.conditions.size(), 1U);
  EXPECT_EQ(swings.conditions.front().words, "the cord 'cord' stays taut");
  EXPECT_EQ(std::count(swings.assumptions.begin(), swings.assumptions.end(), swings.conditions.front().words), 1);
  for (const double b : {0.3, 1.7, 2.9})
    for (const double v : {0.5, 5.0}) {
      const LetterValues at{{"m", 2}, {"L", 1.5}, {"v", v}, {"b", b}, {"g", 9.8}};
      EXPECT_NEAR(value_at(swings.conditions.front().positive, at), 2 * (9.8 * std::cos(b) + v * v / 1.5), 1e-9);
    }
  // A plate let go on one cord pulls it whatever its sizes are.
  const Solution hangs = solved(R"(
letters: {m: kg, a: m, b: m, g: m/s^2}
points: {A: [0, 0, 0], B: [a, 0, 0], C: [a, -b, 0], U: [0, b, 0]}
bodies: {plate: {rectangle: {corners: [A, B, C]}, mass: m}}
cords: {c: {at: U, to: plate, end: A}}
gravity: -y
instants: {now: rest}
ask: {T: tension(c)}
)");
  EXPECT_TRUE(hangs.conditions.empty());
}

// Bodies that part strike nothing, which numbers refuse: that they approach is told, unless they always do.
TEST(FormulaReach, what_strikes_approaches) {
  const auto blow = [](const std::string& letter, const std::string& other) {
    return solved("letters: {m: kg, v: " + letter + ", u: " + letter + R"(, e: 1}
points: {A: [0, 0, 0]}
bodies: {p: {particle: A, mass: m}, q: {particle: A, mass: m}}
impacts: {hit: {of: q, against: p, at: A, pushes: x, restitution: e}}
gravity: none
instants: {before: {velocity(p): [v, 0, 0], velocity(q): [)" +
                  other + R"(, 0, 0]}}
ask: {J: impulse(hit on q).x, lost: kinetic_energy(system) @ before}
)");
  };
  const Solution meet = blow("{signed: m/s}", "u");
  EXPECT_EQ(std::ranges::count(meet.assumptions, "v - u > 0"), 1) << meet.assumptions.size();
  const Solution head_on = blow("m/s", "-u");
  EXPECT_TRUE(head_on.assumptions.empty());
}

// Where the leading coefficient of a quadratic vanishes there still is a root, but its formula is 0/0: the precessions
// of a top with J = I.
TEST(FormulaReach, what_must_not_vanish_is_told) {
  for (const bool assumes_larger : {false, true}) {
    const SolvedStatement top = solve_statement(read_statement(std::string(R"(
letters: {m: kg, c: m, I: kg*m^2, J: kg*m^2, b: rad, s: rad/s}
assume: [10 deg < b < 80 deg)") + (assumes_larger ? ", J > I" : "") +
                                                                   R"(]
find: {p: rad/s}
points: {O: [0, 0, 0], G: 'c*[sin(b), 0, cos(b)]'}
frames: {figure: {turns: z, rate: p}}
bodies: {top: {mass: m, center: G, inertia: {about: O, axis: O->G, axial: I, transverse: J}}}
joints: {tip: {ball: O, to: top}}
steady: {frame: figure, spins: {top: {about: O->G, rate: s}}}
gravity: -z
ask: {p: p}
)",
                                                               "test.yaml"),
                                                {});
    ASSERT_EQ(top.solutions.size(), 2U);
    for (const Solution& one : top.solutions) {
      ASSERT_TRUE(one.asks[0].formula);
      const auto told = [&](const char* words) { return std::ranges::count(one.assumptions, words); };
      EXPECT_EQ(told("cos(b) != 0"), 1);
      EXPECT_EQ(told("I - J != 0"), assumes_larger ? 0 : 1);
      EXPECT_EQ(
          std::ranges::count_if(one.assumptions, [](const std::string& words) { return words.ends_with("!= 0"); }),
          assumes_larger ? 1 : 2);
    }
  }
}

// A letter with a tiny factor matters where it is huge. A law without it only approximates, and where it passes the
// tolerance is no bound of anything.
TEST(FormulaReach, a_letter_with_a_tiny_factor_is_not_left_out) {
  const Solution falls = solved(R"t(
letters: {h: m, c: m, m: kg}
points: {O: [0, 0, 0], H: '[0, h + 1e-9*c, 0]'}
bodies: {b: {particle: H, mass: m}}
contacts: {floor: {of: b, at: H, surface: O, normal: y, open: true}}
gravity: -y
instants: {start: rest, lands: {first_time: touching(floor)}}
ask: {t: time @ lands}
)t");
  EXPECT_FALSE(falls.asks[0].formula);
  EXPECT_EQ(std::ranges::count(falls.asks[0].letters, "c"), 1);
  const Solution swings = solved(R"t(
letters: {m: kg, L: m, k: N*m/rad}
given: {b: 60 deg}
points: {O: [0, 0, 0], P: [0, -L, 0]}
bodies: {b: {particle: P, mass: m}}
joints: {pin: {revolute: z, at: O, to: b, angle: q, spring: {stiffness: 1e-10*k}}}
gravity: -y
instants: {start: {q: b, q': 0}}
ask: {v: max(q')}
)t");
  EXPECT_FALSE(swings.asks[0].formula);
  EXPECT_EQ(std::ranges::count(swings.asks[0].letters, "k"), 1);
}

// The couple on the hub of a propeller is largest with the blades across up to W = 2 s, and from there on elsewhere:
// its square is (W^2 - 2 s W)^2 larger there, which passes a millionth of it at 2.003 s.
TEST(FormulaReach, a_bound_where_a_law_is_left_flatly_is_exact) {
  const Solution solution = solved(R"t(
letters: {m: kg, L: m, s: rad/s, W: rad/s}
points: {G: [0, 0, 0], P: [0, 0, L/2], Q: [0, 0, -L/2]}
frames: {plane: {turns: z, rate: W}}
bodies: {prop: {rod: [Q, P], mass: m}}
joints: {hub: {revolute: x, at: G, from: plane, to: prop, rate: s, accel: 0}}
gravity: none
ask: {big: max(norm(couple(hub on prop about G)))}
)t");
  ASSERT_TRUE(solution.asks[0].formula) << solution.asks[0].no_formula;
  EXPECT_EQ(std::ranges::count(solution.assumptions, "2*s - W > 0 for 'big'"), 1)
      << (solution.assumptions.empty() ? "" : solution.assumptions.back());
}

}  // namespace formula_reach_test
}  // namespace poinsot::problem
