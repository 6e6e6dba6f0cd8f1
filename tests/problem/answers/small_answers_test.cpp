// Answers that are small beside the rest of the problem: they are no zeros, and letters that matter little matter.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace {

Solution solution_of(const std::string& text) {
  return solve_statement(read_statement(text, "small.yaml"), {}).solutions.front();
}

// A letter decides an answer however small its part is beside the other masses.
TEST(SmallAnswers, HangOnLettersThatMatterLittle) {
  const Solution found = solution_of(
      "title: a disk\nletters: {m: kg}\ngravity: none\npoints: {O: [0, 0, 0]}\n"
      "bodies: {b: {disk: {center: O, normal: z, radius: 2 m}, mass: m}}\n"
      "joints: {pin: {revolute: z, at: O, to: b, rate: 3 rad/s}}\n"
      "ask: {a: mass(b)*1e-14, b: mass(b)*1e-16, c: kinetic_energy(b)*1e-15, d: angular_velocity(b)}\n");
  for (const std::size_t i : {0, 1, 2}) {
    EXPECT_EQ(found.asks[i].state, AskState::needs_letters) << i;
    EXPECT_EQ(found.asks[i].letters, std::vector<std::string>{"m"}) << i;
  }
  EXPECT_EQ(text(found.asks[2].formula->number), "0.000000000000009*m");
  // What does not hang on the letter has its value.
  EXPECT_EQ(found.asks[3].state, AskState::found);
  EXPECT_DOUBLE_EQ(found.asks[3].value.vector.z, 3);
}

// An energy divided by the square of the speed of light is small, and has no zero: by letters and by numbers.
TEST(SmallAnswers, AreNotZeroForBeingDividedByALargeNumber) {
  const std::string text =
      "title: mass of an energy\nDATA\ngravity: none\npoints: {O: [0, 0, 0]}\n"
      "bodies: {b: {particle: O, mass: m}}\njoints: {g: {prismatic: x, to: b, rate: v}}\n"
      "ask: {a: kinetic_energy(b)/c^2, b: momentum(b).x*v/c^2, e: (mass(b)*v^2 - momentum(b).x*v)/c^2}\n";
  const auto with = [&](const std::string& data) {
    std::string own = text;
    return own.replace(own.find("DATA"), 4, data);
  };
  const Solution numbers = solution_of(with("given: {m: 2 kg, v: 3 m/s, c: 299792458 m/s}"));
  const double square = std::pow(299792458.0, 2);
  EXPECT_DOUBLE_EQ(numbers.asks[0].value.number, 9 / square);
  EXPECT_DOUBLE_EQ(numbers.asks[1].value.number, 18 / square);
  EXPECT_EQ(numbers.asks[2].value.number, 0);
  const Solution letters = solution_of(with("letters: {m: kg, v: m/s}\ngiven: {c: 299792458 m/s}"));
  EXPECT_EQ(letters.asks[0].letters, (std::vector<std::string>{"m", "v"}));
  EXPECT_EQ(letters.asks[1].letters, (std::vector<std::string>{"m", "v"}));
  EXPECT_EQ(letters.asks[2].state, AskState::found);
  EXPECT_EQ(letters.asks[2].value.number, 0);
}

// A couple on a station of millions of tons, beside which it is below all rounding of the station's own moments.
TEST(SmallAnswers, KnowTheCoupleOnALargeStation) {
  const Solution found = solution_of(
      "title: a station\nletters: {M: N*m}\ngravity: none\npoints: {O: [0, 0, 0]}\n"
      "bodies: {station: {disk: {center: O, normal: z, radius: 5000 m}, mass: 4e12 kg}}\n"
      "joints: {pin: {revolute: z, at: O, to: station, angle: turn, rate: 10 rad/s}}\n"
      "loads: {drive: {couple: [0, 0, M], body: station}}\n"
      "ask: {a: angular_acceleration(station).z, b: load(drive).z, c: kinetic_energy(station)}\n");
  EXPECT_EQ(found.asks[0].letters, std::vector<std::string>{"M"});
  EXPECT_EQ(found.asks[1].letters, std::vector<std::string>{"M"});
  EXPECT_EQ(text(found.asks[1].formula->number), "M");
  EXPECT_EQ(found.asks[2].state, AskState::found);
}

// A shaft in a thrust bearing and a journal, which share what acts along it: the rest is determined, however small or
// large the loads.
TEST(SmallAnswers, KnowForcesBesideSharedOnesAtAnyLoad) {
  for (int power = -20; power <= 20; power += 4) {
    const std::string g = "1e" + std::to_string(power) + " m/s^2";
    const Solution found =
        solution_of("title: a shaft\ngiven: {m: 10 kg, L: 1.2 m, g: " + g +
                    "}\npoints: {A: [0, 0, 0], B: [L, 0, 0]}\n"
                    "bodies: {bar: {cylinder: {center: (A + B)/2, axis: x, radius: 20 mm, length: L}, mass: m}}\n"
                    "joints: {shaft: {revolute: x, at: A, to: bar, rate: 0, supports: {A: thrust, B: [x, y, z]}}}\n"
                    "gravity: -y\nask: {all: force(shaft on bar), half: reaction(A).y, shared: reaction(A).x}\n");
    EXPECT_NEAR(found.asks[0].value.vector.y, 10 * std::pow(10, power), 1e-9 * std::pow(10, power)) << g;
    EXPECT_NEAR(found.asks[1].value.number, 5 * std::pow(10, power), 1e-9 * std::pow(10, power)) << g;
    EXPECT_EQ(found.asks[2].state, AskState::undetermined) << g;
  }
}

// Whatever a document says of an answer, its value and its formula say the same: for factors down to 1e-40.
TEST(SmallAnswers, HaveNoValueBesideAFormulaInLetters) {
  int tried = 0;
  for (int power = 0; power <= 40; ++power) {
    const std::string factor = "1e-" + std::to_string(power);
    const Solution found = solution_of(
        "title: a rod\nletters: {m: kg, w: rad/s}\ngravity: none\npoints: {A: [0, 0, 0], B: [2 m, 0, 0]}\n"
        "bodies: {b: {rod: [A, B], mass: m}, other: {particle: B, mass: 3 kg}}\n"
        "joints: {pin: {revolute: z, at: A, to: b, rate: w}, end: {weld: B, from: b, to: other}}\n"
        "ask: {a: kinetic_energy(b)*" +
        factor + ", b: kinetic_energy(system)*" + factor + ", c: mass(other)*" + factor +
        ", d: mass(other) + mass(b)*" + factor + "}\n");
    EXPECT_EQ(found.asks[0].letters, (std::vector<std::string>{"m", "w"})) << factor;
    EXPECT_EQ(found.asks[1].letters, (std::vector<std::string>{"m", "w"})) << factor;
    EXPECT_EQ(found.asks[2].state, AskState::found) << factor;
    EXPECT_NEAR(found.asks[2].value.number, 3 * std::pow(10, -power), 1e-15 * std::pow(10, -power)) << factor;
    EXPECT_EQ(found.asks[3].letters, std::vector<std::string>{"m"}) << factor;
    ++tried;
  }
  EXPECT_EQ(tried, 41);
}

}  // namespace
}  // namespace poinsot::problem
