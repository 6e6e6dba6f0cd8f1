// Every formula that is given holds wherever what is told of it holds: the statements below have other branches, which
// random letters over several decades meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "case_count.h"
#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/answers/solve_statement.h"
#include "problem/formulas/formula_answers.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/machine/data.h"
#include "problem/results/compare_values.h"

namespace poinsot::problem {
namespace formula_regimes_test {

// Whether "X > 0 for 'a' and 'b'", told of a solution, holds for an ask; true where it says nothing of it.
bool told_holds(const Solution& solution, std::string told, const std::string& ask, const Situation& situation,
                const Settings& settings) {
  const std::size_t names = told.find(" for '");
  if (names != std::string::npos) {
    if (told.find("'" + ask + "'", names) == std::string::npos) return true;
    told.resize(names);
  }
  for (const FormulaCondition& condition : solution.conditions)
    if (condition.words == told) told = text(condition.positive) + " > 0";
  if (told.find(" is not negative") != std::string::npos || told.find(" is such that") != std::string::npos)
    return true;
  DataScope<double> data(situation, settings);
  try {
    return data.value(parse_expression(told, "told.yaml")).truth;
  } catch (const StatementError& error) {
    // What has no value there does not hold: the root of what another condition says is not negative.
    EXPECT_NE(std::string(error.what()).find("sqrt of the negative number"), std::string::npos) << error.what();
    return false;
  }
}

struct Tally {
  int compared = 0, beyond = 0;  // points at which formulas were compared, and at which something told did not hold
  int of_several = 0;            // points compared with one of several formulas
};

// Solves in letters, then with numbers for them, and compares.
Tally compare(const std::string& file, int points, double decades, double tolerance) {
  const Statement statement = read_statement(file, "regimes.yaml");
  const SolvedStatement formulas = solve_statement(statement, {});
  std::mt19937_64 random(8100);
  const auto part = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  Tally tally;
  for (int n = 0; n < points; ++n) {
    Settings settings;
    LetterValues values;
    std::vector<std::pair<std::string, std::string>> sets;
    for (const Letter& letter : formulas.open_letters) {
      const bool angle = letter.unit.dimension == dimensions::angle;
      double value = angle ? 3.1 * part() : std::pow(10, decades * part());
      if (letter.either_sign && part() < 0) value = -value;
      std::ostringstream text;
      text.precision(17);
      text << value << (angle ? " rad" : letter.unit.text.empty() ? "" : " " + letter.unit.text);
      sets.emplace_back(letter.name, text.str());
      values[letter.name] = value * (angle ? 1 : letter.unit.factor);
      settings[letter.name] = Value<double>::of_number(values[letter.name], letter.unit.dimension);
    }
    SolvedStatement numbers;
    try {
      numbers = solve_statement(statement, sets);
    } catch (const StatementError&) {
      continue;
    }
    for (const Solution& solution : formulas.solutions)
      for (std::size_t i = 0; i < statement.asks.size(); ++i) {
        const std::optional<Value<Formula>>& formula = solution.asks[i].formula;
        if (!formula) continue;
        bool told = true;
        // Of several formulas the one is meant whose conditions hold, and each of them if several do.
        std::vector<Value<Formula>> meant;
        for (const RegimeFormula& one : solution.asks[i].regimes)
          if (std::ranges::all_of(one.where, [&](const std::string& words) {
                return told_holds(solution, words, statement.asks[i].name, statement.situations.front(), settings);
              }))
            meant.push_back(one.formula);
        if (solution.asks[i].regimes.empty()) meant.push_back(*formula);
        for (const std::string& one : solution.assumptions) {
          if (!solution.asks[i].regimes.empty() && one.find(" for '") != std::string::npos) continue;
          told = told && told_holds(solution, one, statement.asks[i].name, statement.situations.front(), settings);
        }
        if (!told || meant.empty()) {
          ++tally.beyond;
          continue;
        }
        if (solution.asks[i].regimes.size() > 1) ++tally.of_several;
        // Of several roots one is meant.
        bool found = false;
        std::string all;
        for (const Solution& other : numbers.solutions) {
          const SolvedAsk& ask = other.asks[i];
          all += ask.value.is_number() ? with_digits(ask.value.number, 8) + " " : ask.reason + " ";
          found = found || (ask.state == AskState::found && std::ranges::all_of(meant, [&](const Value<Formula>& one) {
                              return agrees(one, ask.value, values, tolerance, size_of(ask.value));
                            }));
        }
        ++tally.compared;
        std::string at;
        for (const auto& [name, value] : sets) at += name + " = " + value + ", ";
        EXPECT_TRUE(found) << file << statement.asks[i].name << " at " << at << all
                           << (meant.front().is_number() ? text(meant.front().number) : "");
      }
  }
  return tally;
}

const char* const branches[] = {
    R"(letters: {a: m, L: m, F: N}
points: {O: [0, 0, 0], P: [a, 0, 0], Q: [L, 0, 0]}
bodies: {beam: {rod: [O, Q], mass: 1 kg}}
joints: {s: {weld: O, to: beam, supports: {A: {at: O, force: [x, y]}, B: {at: Q, force: [y]}}}}
loads: {f: {force: [0, -F, 0], at: P, body: beam}}
gravity: none
ask: {big: max(reaction(A).y with reaction(B).y), both: reaction(A).y}
)",
    R"(letters: {m: kg, F: N, b: rad, g: m/s^2}
points: {O: [0, 0, 0]}
bodies: {p: {particle: O, mass: m}}
contacts: {t: {of: p, at: O, normal: y}}
loads: {f: {force: [F*cos(b), F*sin(b), 0], body: p}}
gravity: -y
facts: {velocity(p): [1 m/s, 0, 0]}
ask: {a: acceleration(p).x, N: force(t on p).y}
)",
    R"(letters: {m: kg, q: m/s^2, b: rad, g: m/s^2}
find: {F: N}
points: {O: [0, 0, 0]}
bodies: {p: {particle: O, mass: m}}
contacts: {t: {of: p, at: O, normal: y}}
loads: {f: {force: [F*cos(b), F*sin(b), 0], body: p}}
gravity: -y
instants: {now: {velocity(p): [1 m/s, 0, 0], acceleration(p).x: q}}
ask: {F: F, N: force(t on p).y}
)",
    R"(letters: {m: kg, L: m, v: {signed: m/s}}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bob: {particle: A, mass: m}}
cords: {c: {at: O, to: bob, end: A}}
impulses: {k: {body: bob, value: [0, -m*v, 0]}}
instants: {before: {velocity(bob): [0, 0, 0]}}
gravity: none
ask: {J: impulse(c).y, after: velocity(bob)}
)",
    R"(letters: {m: kg, a: {signed: m/s}, T: J}
find: {u: m/s}
points: {O: [0, 0, 0]}
bodies: {p: {particle: O, mass: m}}
instants: {now: {velocity(p): [u, a, 0], kinetic_energy(p): T}}
gravity: none
ask: {u: abs(u), size: 'max(abs(u) with abs(a))'}
)",
    R"(letters: {m: kg, L: m, v: {signed: m/s}, u: {signed: m/s}}
find: {J: N*s}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bob: {particle: A, mass: m}}
cords: {c: {at: O, to: bob, end: A}}
impulses: {k: {body: bob, value: [J, -m*v, 0]}}
instants: {before: {velocity(bob): [0, 0, 0]}, after: {velocity(bob).x: u}}
gravity: none
ask: {J: J, c: impulse(c).y}
)",
    R"(letters: {m: kg, a: m, h: m, F: N, g: m/s^2}
points: {A: [0, 0, 0], B: [a, 0, 0], P: [0, h, 0], G: [a/2, h/2, 0]}
bodies: {box: {rectangle: {corners: [A, B, B + h*y]}, mass: m}}
contacts: {l: {of: box, at: A, normal: y}, r: {of: box, at: B, normal: y}}
loads: {f: {force: [F, 0, 0], at: P, body: box}}
gravity: -y
instants: {now: rest}
ask: {l: force(l on box).y, r: force(r on box).y, big: 'max(force(l on box).y with force(r on box).y)'}
)",
    R"(letters: {v: {signed: m/s}, u: {signed: m/s}, m: kg}
points: {O: [0, 0, 0]}
bodies: {p: {particle: O, mass: m}}
facts: {velocity(p): [u, v, 0]}
ask: {q: 'atan2(velocity(p).y to velocity(p).x)', r: 'angle(velocity(p) to x)', s: 'acute_angle(velocity(p) to x)', n: 'abs(velocity(p).x)', k: 'max(abs(velocity(p).x) with abs(velocity(p).y))'}
)",
    R"(letters: {m: kg, a: m, b: m}
points: {O: [0, 0, 0]}
bodies: {p: {rectangle: {center: O, sides: [[a, 0, 0], [0, b, 0]]}, mass: m}}
ask: {I: principal_moments(p about O), A: 'principal_axes(p about O)'}
)",
    R"(letters: {m: kg, M: kg, v: m/s, e: 1}
points: {P: [0, 0, 0], Q: [1 m, 0, 0]}
bodies: {p: {particle: P, mass: m}, q: {particle: Q, mass: M}}
joints: {a: {prismatic: x, at: P, to: p}, b: {prismatic: x, at: Q, to: q}}
impacts: {c: {of: q, against: p, at: Q, pushes: x, restitution: e}}
instants: {before: {velocity(p).x: v, velocity(q).x: 0}}
gravity: none
ask: {p: velocity(p).x, q: velocity(q).x, s: 'max(abs(velocity(p).x) with velocity(q).x)'}
)",
    R"(letters: {m: kg, L: m, b: rad, g: m/s^2, w: rad/s}
points: {A: [0, L*cos(b), 0], B: [L*sin(b), 0, 0]}
bodies: {l: {rod: [A, B], mass: m}}
contacts: {wall: {of: l, at: A, normal: x}, floor: {of: l, at: B, normal: y}}
gravity: -y
facts: {angular_velocity(l): [0, 0, w]}
ask: {N: force(wall on l).x, F: force(floor on l).y, al: angular_acceleration(l).z}
)",
    R"(letters: {m: kg, L: m, J: N*s, b: rad}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bob: {particle: A, mass: m}}
cords: {c: {at: O, to: bob, end: A}}
impulses: {k: {body: bob, value: [J*cos(b), J*sin(b), 0]}}
instants: {before: rest}
gravity: none
ask: {J: norm(impulse(c)), after: velocity(bob), T: kinetic_energy(bob)}
)",
    R"(letters: {m: kg, T: J, v: m/s}
find: {M: kg}
points: {O: [0, 0, 0], P: [1 m, 0, 0]}
bodies: {p: {particle: O, mass: m}, q: {particle: P, mass: M}}
facts: {velocity(p): [v, 0, 0], velocity(q): [v, 0, 0], kinetic_energy(system): T}
gravity: none
ask: {M: M, H: momentum(q).x}
)",
    R"(letters: {m: kg, T: J, p0: N*s, p1: N*s}
find: {u: m/s, v: m/s}
where: [u > 0, v > 0]
points: {O: [0, 0, 0], P: [1 m, 0, 0]}
bodies: {p: {particle: O, mass: m}, q: {particle: P, mass: 2*m}}
facts: {velocity(p): [u, 0, 0], velocity(q): [v, 0, 0], 'max(momentum(p).x with momentum(q).x)': p0, 'min(momentum(p).x with momentum(q).x)': p1}
gravity: none
ask: {u: u, v: v, P: momentum(system).x}
)",
    R"(letters: {r: m, L: m, g: m/s^2, p: rad/s, s: rad/s}
find: {b: deg}
axes: [X, Y, Z]
gravity: -Z
points: {A: [0, 0, 0], B: 'L*[sin(b), 0, -cos(b)]', G: '(L + r)*[sin(b), 0, -cos(b)]'}
bodies: {sphere: {sphere: {center: G, radius: r}, mass: any}}
joints: {hanger: {ball: A, from: ground, to: sphere}}
frames: {figure: {origin: A, turns: Z, rate: p}}
steady: {frame: figure, spins: {sphere: {about: A->B, rate: s}}}
where: [0 deg < b < 90 deg]
ask: {b: b, c: cos(b)}
)",
    R"(letters: {m: kg, v: m/s, u: m/s}
find: {b: rad}
where: [30 deg < b < 85 deg]
points: {O: [0, 0, 0]}
bodies: {p: {particle: O, mass: m}}
facts: {velocity(p): ['v*sin(b)', 'v*cos(b)', 0], velocity(p).x: u}
gravity: none
ask: {b: b, y: velocity(p).y}
)",
    R"(letters: {m: kg, F: {signed: N}, g: m/s^2, a: m, h: m}
points: {A: [-a, h, 0], B: [a, h, 0], O: [0, 0, 0]}
bodies: {w: {particle: O, mass: m}}
cords: {l: {at: A, to: w, end: O}, r: {at: B, to: w, end: O}}
loads: {f: {force: [F, 0, 0], body: w}}
gravity: -y
instants: {now: rest}
ask: {l: tension(l), r: tension(r), most: 'max(tension(l) with tension(r))', a: norm(acceleration(w))}
)",
    R"(letters: {m: kg, L: m, d: m, h: m, J: N*s}
points: {A: [0, 0, 0], B: [L, 0, 0], C: [d, 0, 0], P: [0, h, 0], Q: [L, h, 0]}
bodies: {bar: {rod: [A, B], mass: m}}
cords: {a: {at: P, to: bar, end: A}, b: {at: Q, to: bar, end: B}}
impulses: {hit: {body: bar, at: C, value: [0, J, 0]}}
instants: {before: rest}
gravity: none
ask: {a: impulse(a on bar).y, b: impulse(b on bar).y, both: 'impulse(a on bar).y + impulse(b on bar).y', n: norm(impulse(b on bar)), T: kinetic_energy(bar)}
)"};

// Followed over time, by laws that hold on one side of a bound.
const char* const motions[] = {
    R"(letters: {m: kg, k: N/m, d: m, s: m}
points: {O: [0, 0, 0]}
bodies: {cart: {particle: O, mass: m}}
joints: {rail: {prismatic: x, at: O, to: cart, displacement: u, spring: {stiffness: k, free_displacement: s}}}
gravity: none
instants: {start: {u: d, "u'": 0}}
ask: {top: max(u), low: min(u), T: period(u)}
)",
    R"(letters: {L: m, w: rad/s, g: m/s^2}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bob: {particle: A, mass: 1 kg}}
joints: {pin: {revolute: z, at: O, to: bob, angle: q}}
gravity: -y
instants: {start: {q: 0, "q'": w}}
ask: {top: max(center(bob).y), fast: max(q'), slow: min(q')}
)"};

TEST(FormulaRegimes, what_is_given_holds_wherever_what_is_told_of_it_does) {
  Tally all;
  for (const char* file : branches) {
    // Each point of a statement with unknowns is a search for its roots.
    const bool sought = std::string_view(file).find("find:") != std::string_view::npos;
    const Tally one = compare(file, testing::case_count(sought ? 5 : 40), 3, 1e-7);
    EXPECT_GT(one.compared + one.beyond, testing::case_count(5)) << file;
    all.compared += one.compared;
    all.beyond += one.beyond;
    all.of_several += one.of_several;
  }
  // The letters do meet the other branches.
  EXPECT_GT(all.beyond + all.of_several, all.compared / 10);
  EXPECT_GT(all.of_several, all.compared / 20);
}

TEST(FormulaRegimes, laws_of_motions_tell_the_bound_on_whose_side_they_hold) {
  for (const char* file : motions) {
    // As many under the sanitizers, or none would lie beyond the bounds.
    const Tally one = compare(file, 25, 0.8, 1e-6);
    EXPECT_GT(one.compared, 10) << file;
    EXPECT_GT(one.beyond + one.of_several, 2) << file;
  }
}

// A cart let go on a spring comes back to where it started, or swings farther out beyond the relaxed spring.
TEST(FormulaRegimes, the_bound_of_a_law_is_an_exact_one) {
  const Solution cart = solve_statement(read_statement(motions[0], "cart.yaml"), {}).solutions.at(0);
  EXPECT_NE(std::ranges::find(cart.assumptions, "d - s > 0 for 'top'"), cart.assumptions.end());
  const Solution pendulum = solve_statement(read_statement(motions[1], "pendulum.yaml"), {}).solutions.at(0);
  EXPECT_NE(std::ranges::find(pendulum.assumptions, "4*g - L*w^2 > 0 for 'slow'"), pendulum.assumptions.end());
}

// A rod on two cords that is struck from below: each cord is jerked on one side of a border, and carries nothing on the
// other, where two places of the blow are parted by nothing.
TEST(FormulaRegimes, zero_is_a_branch_like_any_other) {
  const Solution bar = solve_statement(read_statement(*std::rbegin(branches), "bar.yaml"), {}).solutions.at(0);
  const auto told = [&](std::size_t i) {
    std::string all;
    for (const RegimeFormula& one : bar.asks.at(i).regimes) {
      all += text(one.formula.number);
      for (const std::string& where : one.where) all += " where " + where;
      all += "; ";
    }
    return all;
  };
  EXPECT_EQ(told(0), "J*(3*d/(2*L) - 1) where 3*d - 2*L > 0; 0 where 2*L - 3*d > 0; ");
  EXPECT_EQ(told(1), "0 where 3*d - L > 0; J*(L - 3*d)/(2*L) where L - 3*d > 0; ");
  EXPECT_EQ(bar.asks.at(2).regimes.size(), 3U);
  EXPECT_EQ(bar.asks.at(4).regimes.size(), 3U);
}

// Branches of letters that are not as is assumed are none, and nothing is said of them.
TEST(FormulaRegimes, none_is_told_of_letters_that_are_excluded) {
  std::string assumed = *std::rbegin(branches);
  assumed.insert(assumed.find("ask:"), "assume: [L < 3*d]\n");
  const Solution bar = solve_statement(read_statement(assumed, "bar.yaml"), {}).solutions.at(0);
  EXPECT_TRUE(bar.asks.at(1).regimes.empty());
  ASSERT_TRUE(bar.asks.at(1).formula);
  EXPECT_TRUE(bar.asks.at(1).formula->number.is_zero());
  for (const std::string& note : bar.notes) EXPECT_EQ(note.find("no formula"), std::string::npos) << note;
}

// What one choice of letters finds to be zero is told to be so for the letters for which it is.
TEST(FormulaRegimes, what_is_chosen_is_not_the_same_for_all_letters) {
  const Solution jets = solve_statement(read_statement(R"(
letters: {I: kg*m^2, d: m, F: N, w: {signed: rad/s}}
find: {tA: s, tB: s, tC: s}
points: {G: [0, 0, 0], P: [d, 0, 0]}
bodies: {probe: {mass: 200 kg, center: G, inertia: {axis: z, axial: I, transverse: 2*I}}}
impulses:
  A: {body: probe, at: P, force: [0, F, 0], lasts: tA}
  B: {body: probe, at: P, force: [0, -F, 0], lasts: tB}
  C: {body: probe, at: P, force: [F, 0, 0], lasts: tC}
choose: {fired: {of: [A, B, C], exactly: 1}}
instants: {before: {angular_velocity(probe): [0, 0, w], velocity(probe): 0}, after: {angular_velocity(probe): 0}}
ask: {jet: fired, t: tB}
)",
                                                       "jets.yaml"),
                                        {})
                            .solutions.at(0);
  EXPECT_EQ(jets.asks[0].state, AskState::needs_letters);
  for (const SolvedUnknown& unknown : jets.unknowns)
    if (unknown.name == "tA") {
      EXPECT_NE(std::ranges::find(jets.assumptions, "w > 0 for 'tA'"), jets.assumptions.end());
    }
}

// A disk of a millimetre on a cord of twenty metres swings as a particle does, to nine digits: it hangs on its radius
// all the same.
TEST(FormulaRegimes, a_letter_that_matters_little_nearby_is_not_left_out) {
  const Solution disk = solve_statement(read_statement(R"(
letters: {r: mm}
given: {L: 20 m}
points: {A: [0, 0, 0], G: [0, -L, 0]}
bodies: {disk: {disk: {center: G, normal: z, radius: r}, mass: 1 kg}}
joints: {pin: {revolute: z, at: A, to: disk, angle: q}}
gravity: -y
instants: {start: {q: 60 deg, "q'": 0}}
ask: {fast: max(q'), weight: max(weight(disk)*q)}
)",
                                                       "disk.yaml"),
                                        {})
                            .solutions.at(0);
  for (const SolvedAsk& ask : {disk.asks[0]})
    if (ask.formula) {
      EXPECT_EQ(ask.formula->number.letters(), std::vector<std::string>{"r"});
    } else {
      EXPECT_EQ(ask.state, AskState::needs_letters);
    }
  // What does not hang on it is a number for all radii.
  EXPECT_EQ(disk.asks[1].state, AskState::found) << disk.asks[1].no_formula;
}

// A formula that numbers hold up is a check by name.
TEST(FormulaRegimes, the_check_is_named) {
  const Solution beam = solve_statement(read_statement(branches[0], "beam.yaml"), {}).solutions.at(0);
  ASSERT_TRUE(beam.checks.contains("formulas"));
  EXPECT_LT(beam.checks.at("formulas"), 1e-12);
}

}  // namespace formula_regimes_test
}  // namespace poinsot::problem
