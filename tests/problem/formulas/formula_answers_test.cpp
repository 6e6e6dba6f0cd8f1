// Formulas of problems whose data are letters, against the same problems solved with numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "docs/fenced_blocks.h"
#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/answers/contact_states.h"
#include "problem/answers/read_settings.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace formula_answers_test {

namespace fs = std::filesystem;
using poinsot::fenced_blocks;

using Sets = std::vector<std::pair<std::string, std::string>>;

std::string read(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

// All data that are one literal with a unit become letters; their values.
Sets turn_data_into_letters(Statement& statement) {
  Sets values;
  for (std::size_t s = 0; s < statement.situations.size(); ++s) {
    Situation& situation = statement.situations[s];
    for (auto it = situation.given.begin(); it != situation.given.end();) {
      const Number* number = it->value.as<Number>();
      if (!number || !number->has_unit || number->value <= 0) {
        ++it;
        continue;
      }
      situation.letters.push_back({it->name, number->unit, it->mark});
      if (s == 0) values.emplace_back(it->name, number->text);
      it = situation.given.erase(it);
    }
  }
  return values;
}

// The values of a formula at values of the letters.
std::vector<double> numbers_of(const Value<poinsot::Formula>& formula, const LetterValues& letters) {
  if (formula.is_number()) return {value_at(formula.number, letters)};
  std::vector<double> all;
  if (formula.is_vector())
    for (std::size_t k = 0; k < 3; ++k) all.push_back(value_at(formula.vector[k], letters));
  for (const auto& item : formula.items)
    for (double number : numbers_of(item, letters)) all.push_back(number);
  return all;
}
std::vector<double> numbers_of(const Value<double>& value) {
  if (value.is_number()) return {value.number};
  std::vector<double> all;
  if (value.is_vector())
    for (std::size_t k = 0; k < 3; ++k) all.push_back(value.vector[k]);
  for (const auto& item : value.items)
    for (double number : numbers_of(item)) all.push_back(number);
  return all;
}

struct Tally {
  int formulas = 0, none = 0;
};

// Every formula of the statement with letters, at the values of the file, is the number that the file's own data give.
void expect_formulas_agree(const Statement& stated, const std::string& name, Tally& tally) {
  SolvedStatement numbers, formulas;
  Statement with_letters = stated;
  const Sets values = turn_data_into_letters(with_letters);
  if (values.empty()) return;
  LetterValues letters;
  try {
    numbers = solve_statement(stated, {});
    for (const auto& [letter, value] : read_settings(stated, values)) letters[letter] = value.number;
    for (const Letter& letter : stated.situations.front().letters) letters[letter.name] = 1;
    if (numbers.solutions.empty()) return;
    formulas = solve_statement(with_letters, {});
  } catch (const StatementError&) {
    return;  // it makes sense at its own data only
  }
  for (const Solution& solution : formulas.solutions)
    for (std::size_t i = 0; i < stated.asks.size(); ++i) {
      const SolvedAsk& ask = solution.asks[i];
      const std::string where = name + " " + stated.asks[i].name;
      if (!ask.formula) {
        ++tally.none;
        continue;
      }
      ++tally.formulas;
      if (numbers.solutions.front().asks[i].state != AskState::found || numbers.solutions.size() > 1) continue;
      const std::vector<double> expected = numbers_of(numbers.solutions.front().asks[i].value);
      double size = 1e-9;
      for (double number : expected) size = std::max(size, std::abs(number));
      const auto is_expected = [&](const Value<Formula>& formula) {
        const std::vector<double> found = numbers_of(formula, letters);
        return std::ranges::equal(found, expected, [&](double a, double b) { return std::abs(a - b) <= 1e-8 * size; });
      };
      // Of several formulas, each for its regime, one is for these letters.
      EXPECT_TRUE(ask.regimes.empty() ? is_expected(*ask.formula)
                                      : std::ranges::any_of(ask.regimes, is_expected, &RegimeFormula::formula))
          << where;
    }
}

// Nothing that is found by searching, by following a motion or by trying the states of contacts.
bool is_plain(const Statement& statement) {
  if (has_open_contact_states(statement)) return false;
  for (const Situation& situation : statement.situations)
    if (!situation.find.empty() || !situation.stages.empty()) return false;
  for (const Ask& ask : statement.asks) {
    if (ask.table || ask.when || ask.extremum) return false;
    if (ask.text.find("max(") != std::string::npos || ask.text.find("period(") != std::string::npos) return false;
  }
  return true;
}

TEST(FormulaAnswers, OfTheManualsExamplesAreTheirNumbers) {
  Tally tally;
  for (const FencedBlock& block : fenced_blocks("docs/language.md")) {
    // The mesh of one example is no file of this project.
    if (block.kind != "yaml" || block.text.find("mesh: ") != std::string::npos) continue;
    const std::string name = "docs/language.md:" + std::to_string(block.line);
    const Statement statement = read_statement(block.text, name);
    if (is_plain(statement)) expect_formulas_agree(statement, name, tally);
  }
  EXPECT_GT(tally.formulas, 100);
}

TEST(FormulaAnswers, OfTextbookProblemsAreTheirNumbers) {
  Tally tally;
  for (const auto& entry : fs::directory_iterator(fs::path(POINSOT_SOURCE_DIR) / "examples" / "textbook")) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string name = entry.path().filename().string();
    const Statement statement = read_statement(read(entry.path()), entry.path().string());
    if (is_plain(statement)) expect_formulas_agree(statement, name, tally);
  }
  EXPECT_GT(tally.formulas, 80);
}

std::vector<std::string> texts_of(const Value<poinsot::Formula>& formula) {
  if (formula.is_number()) return {text(formula.number)};
  std::vector<std::string> all;
  if (formula.is_vector())
    for (std::size_t k = 0; k < 3; ++k) all.push_back(text(formula.vector[k]));
  for (const auto& item : formula.items)
    for (const std::string& one : texts_of(item)) all.push_back(one);
  return all;
}

// The formulas of all asks of a problem, as texts.
std::vector<std::string> formulas_of(const std::string& problem, const Sets& sets = {}) {
  const SolvedStatement solved = solve_statement(read_statement(problem, "test.yaml"), sets);
  std::vector<std::string> all;
  for (const SolvedAsk& ask : solved.solutions.at(0).asks) {
    if (!ask.formula) {
      all.push_back("none: " + ask.no_formula + ask.reason);
      continue;
    }
    for (const std::string& one : texts_of(*ask.formula)) all.push_back(one);
  }
  return all;
}

using Texts = std::vector<std::string>;

// A disk that rolls at the end of an axle; x along the axle, y up.
const std::string rolling_disk =
    "title: A disk that rolls at the end of an axle\n"
    "letters: {m: kg, r: m, L: m, w: rad/s}\n"
    "points: {O: [0, 0, 0], G: [L, 0, 0], C: [L, -r, 0]}\n"
    "bodies:\n  axle: massless\n  disk: {disk: {center: G, normal: x, radius: r}, mass: m}\n"
    "joints:\n  pivot: {ball: O, to: axle}\n  spin: {revolute: x, at: G, from: axle, to: disk}\n"
    "contacts: {floor: {of: disk, at: C, normal: y, no_slip: true}}\n"
    "instants: {now: {angular_velocity(disk): [w, any, any]}}\n"
    "ask: {T: kinetic_energy(disk), H: angular_momentum(disk about O)}\n";

TEST(FormulaAnswers, StandInTheFormThatPeopleKnow) {
  EXPECT_EQ(formulas_of(rolling_disk),
            (Texts{"m*r^2*w^2*(6 + r^2/L^2)/8", "m*r^2*w/2", "-m*r*w*(L + r^2/(4*L))", "0"}));
}

TEST(FormulaAnswers, DoNotDependOnTheFrameOrTheOrderOfTheStatement) {
  // The figure on other axes: x, y, z of the first are y, z, x here. And all in reverse order.
  const std::string turned =
      "letters: {w: rad/s, L: m, r: m, m: kg}\n"
      "points: {C: [0, L, -r], G: [0, L, 0], O: [0, 0, 0]}\n"
      "joints:\n  spin: {revolute: y, at: G, from: axle, to: disk}\n  pivot: {ball: O, to: axle}\n"
      "contacts: {floor: {of: disk, at: C, normal: z, no_slip: true}}\n"
      "bodies:\n  disk: {disk: {center: G, normal: y, radius: r}, mass: m}\n  axle: massless\n"
      "instants: {now: {angular_velocity(disk): [any, w, any]}}\n"
      "ask: {T: kinetic_energy(disk), H: {of: angular_momentum(disk about O), axes: [y, z, x]}}\n";
  EXPECT_EQ(formulas_of(turned), formulas_of(rolling_disk));
}

// A problem in pieces that may stand in any order, on axes of any name.
struct Pieces {
  std::vector<std::string> bodies, joints, points, letters;  // the items of the maps
  std::string rest;                                          // #x, #y, #z stand for the axes
};

const std::vector<Pieces> problems_in_pieces{
    {{"axle: massless", "disk: {disk: {center: G, normal: #x, radius: r}, mass: m}"},
     {"pivot: {ball: O, to: axle}", "spin: {revolute: #x, at: G, from: axle, to: disk}"},
     {"O: [0, 0, 0]", "G: [L, 0, 0]", "C: [L, -r, 0]"},
     {"m: kg", "r: m", "L: m", "w: rad/s"},
     "contacts: {floor: {of: disk, at: C, normal: #y, no_slip: true}}\n"
     "instants: {now: {angular_velocity(disk): [w, any, any]}}\ngravity: none\n"
     "ask: {T: kinetic_energy(disk), H: angular_momentum(disk about O)}\n"},
    {{"shaft: {rod: [A, B], mass: M}", "disk: {disk: {center: G, normal: n, radius: r}, mass: m}"},
     {"bearings: {revolute: #x, at: A, to: shaft, rate: w, accel: q, supports: {A: [#x, #y, #z], B: [#y, #z]}}",
      "weld: {weld: G, from: shaft, to: disk}"},
     {"A: [0, 0, 0]", "G: [L/3, 0, 0]", "B: [L, 0, 0]"},
     {"M: kg", "m: kg", "r: m", "L: m", "b: rad", "w: rad/s", "q: rad/s^2"},
     "directions: {n: [cos(b), sin(b), 0]}\ngravity: -#z\n"
     "ask: {A: reaction(A), B: reaction(B), M: drive(bearings).#x, H: angular_momentum(disk about A)}\n"},
    {{"bar: {rod: [O, P], mass: m}", "bob: {particle: Q, mass: M}",
      "plate: {rectangle: {center: S, sides: [[a, 0, 0], "
      "[0, b*cos(c), b*sin(c)]]}, mass: M}"},
     {"pin: {revolute: #z, at: O, to: bar, rate: w}", "tie: {weld: P, from: bar, to: bob}",
      "hold: {weld: P, from: bar, to: plate}"},
     {"O: [0, 0, 0]", "P: [a, b, 0]", "Q: [a, b, a]", "S: [a, b, -b]"},
     {"m: kg", "M: kg", "a: m", "b: m", "c: rad", "w: rad/s"},
     "gravity: none\nask: {H: angular_momentum(system about O), T: kinetic_energy(system), "
     "I: products_of_inertia(plate about O), F: force(pin on bar)}\n"},
};

std::string stated(const Pieces& pieces, std::mt19937_64& random, const std::array<std::string, 3>& axes) {
  const auto map = [&](const char* key, std::vector<std::string> items) {
    std::shuffle(items.begin(), items.end(), random);
    std::string all = std::string(key) + ":\n";
    for (const std::string& item : items) all += "  " + item + "\n";
    return all;
  };
  std::vector<std::string> parts{map("bodies", pieces.bodies),
                                 map("joints", pieces.joints),
                                 map("points", pieces.points),
                                 map("letters", pieces.letters),
                                 pieces.rest,
                                 "axes: [" + axes[0] + ", " + axes[1] + ", " + axes[2] + "]\n"};
  std::shuffle(parts.begin(), parts.end(), random);
  std::string all;
  for (const std::string& part : parts) all += part;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t at = all.find("#" + std::string(1, "xyz"[k])); at != std::string::npos;
         at = all.find("#" + std::string(1, "xyz"[k])))
      all.replace(at, 2, axes[k]);
  return all;
}

TEST(FormulaAnswers, AreTheSameInAnyOrderAndByAnyNamesOfTheAxes) {
  std::mt19937_64 random(3);
  for (const Pieces& pieces : problems_in_pieces) {
    const Texts first = formulas_of(stated(pieces, random, {"x", "y", "z"}));
    for (const std::string& one : first) EXPECT_FALSE(one.starts_with("none")) << one;
    for (int run = 0; run < 3; ++run) {
      EXPECT_EQ(formulas_of(stated(pieces, random, {"x", "y", "z"})), first);
      EXPECT_EQ(formulas_of(stated(pieces, random, {"X", "Y", "Z"})), first);
      EXPECT_EQ(formulas_of(stated(pieces, random, {"east", "north", "up"})), first);
    }
  }
}

TEST(FormulaAnswers, AreTheSameInAnyUnits) {
  std::mt19937_64 random(4);
  for (const Pieces& pieces : problems_in_pieces) {
    const Texts first = formulas_of(stated(pieces, random, {"x", "y", "z"}));
    Pieces other = pieces;
    for (std::string& letter : other.letters) {
      const std::string unit = letter.substr(letter.find(' ') + 1);
      letter = letter.substr(0, letter.find(' ') + 1) + (unit == "kg"      ? "slug"
                                                         : unit == "m"     ? "in"
                                                         : unit == "rad"   ? "deg"
                                                         : unit == "rad/s" ? "rpm"
                                                                           : "deg/s^2");
    }
    EXPECT_EQ(formulas_of(stated(other, random, {"x", "y", "z"})), first);
  }
}

TEST(FormulaAnswers, FoldProductsOfSumsIntoDoubleAngles) {
  const Texts found = formulas_of(
      "letters: {m: kg, L: m, b: rad}\npoints: {O: [0, 0, 0], A: [L*cos(b), L*sin(b), 0]}\n"
      "bodies: {bar: {rod: [O, A], mass: m}}\njoints: {pin: {revolute: z, at: O, to: bar, rate: 0}}\n"
      "define: {d: moment_of_inertia(bar about y at O) - moment_of_inertia(bar about x at O)}\n"
      "ask: {d: d, s: d*sin(b), q: d*d, r: d/cos(b)}\n");
  EXPECT_EQ(found, (Texts{"m*L^2*cos(2*b)/3", "m*L^2*sin(b)*cos(2*b)/3", "m^2*L^4*cos(2*b)^2/9",
                          "m*L^2*cos(2*b)/(3*cos(b))"}));
}

// What would not end is given up; what can be had is given.
TEST(FormulaAnswers, AreGivenUpWhereTheyWouldNotEnd) {
  const int links = 6;
  std::string letters, points = "P0: [0, 0, 0]", bodies, joints, end = "0";
  for (int i = 0; i < links; ++i) {
    const std::string n = std::to_string(i), next = std::to_string(i + 1);
    letters += (i > 0 ? ", m" : "m") + n + ": kg, L" + n + ": m, b" + n + ": rad, w" + n + ": rad/s";
    end += " - L" + n;
    points += ", P" + next + ": [0, 0, " + end + "]";
    bodies += "  bar" + n + ": {rod: [P" + n + ", P" + next + "], mass: m" + n + "}\n";
    joints += "  j" + n + ": {revolute: " + (i % 2 == 0 ? "x" : "y") + ", at: P" + n +
              (i > 0 ? ", from: bar" + std::to_string(i - 1) : "") + ", to: bar" + n + ", angle: b" + n + ", rate: w" +
              n + "}\n";
  }
  const Texts found =
      formulas_of("letters: {" + letters + "}\npoints: {" + points + "}\nbodies:\n" + bodies + "joints:\n" + joints +
                  "gravity: -z\nask: {a: angular_acceleration(bar0).x, F: force(j0 on bar0).z, "
                  "again: force(j1 on bar1).z, H: angular_momentum(bar0 about P0).x}\n");
  ASSERT_EQ(found.size(), 4U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(found[k].starts_with("none: ")) << found[k];
  EXPECT_EQ(found[3], "m0*L0^2*w0/3");
}

TEST(FormulaAnswers, ALetterHasOneDimension) {
  const auto message = [](const std::string& letters, const std::string& place, const std::string& mass,
                          const std::string& ask) -> std::string {
    try {
      formulas_of("letters: {" + letters + "}\npoints: {O: [0, 0, 0], A: [" + place +
                  ", 0, 0]}\nbodies:\n  bar: {rod: [O, A], mass: " + mass + "}\nask: {a: " + ask + "}\n");
    } catch (const StatementError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message("m: kg, L: m", "L", "L", "mass(bar)"), "test.yaml:4:28: error: expected a mass, not a length");
  EXPECT_EQ(message("m: kg", "m", "m", "mass(bar)").substr(0, 17), "test.yaml:2:27: e");
  EXPECT_EQ(message("m: kg, L: m", "L", "m", "mass(bar) + distance(O to A)"),
            "test.yaml:5:20: error: a length cannot be added to a mass");
  EXPECT_EQ(message("m: kg, L: m", "L + m", "m", "mass(bar)"),
            "test.yaml:2:30: error: a mass cannot be added to a length");
  EXPECT_EQ(message("m: kg, L: m", "L", "m", "'mass(bar) > L'"),
            "test.yaml:5:21: error: a length cannot be compared with a mass");
}

TEST(FormulaAnswers, KeepExactNumbersWhateverTheUnit) {
  const auto bar = [](const std::string& given) {
    return formulas_of(
        "letters: {m: kg}\n" + given +
        "points: {O: [0, 0, 0], A: [L*cos(b), L*sin(b), 0]}\nbodies: {bar: {rod: [O, A], mass: m}}\n"
        "joints: {pin: {revolute: z, at: O, to: bar, rate: n}}\n"
        "ask: {T: kinetic_energy(bar), I: moment_of_inertia(bar about x at O), v: velocity(A of bar).x}\n");
  };
  EXPECT_EQ(bar("given: {L: 0.3 m, n: 2 rad/s, b: 60 deg}\n"), (Texts{"3*m/50", "9*m/400", "-3*sqrt(3)/10"}));
  EXPECT_EQ(bar("given: {L: 30 cm, n: 2 rad/s, b: 1/6 rev}\n"), bar("given: {L: 0.3 m, n: 2 rad/s, b: 60 deg}\n"));
  EXPECT_EQ(bar("given: {L: 1 ft, n: 60 rpm, b: 45 deg}\n"), bar("given: {L: 12 in, n: 2*pi/(1 s), b: pi/4}\n"));
}

TEST(FormulaAnswers, TakeValuesFromOutsideExactly) {
  EXPECT_EQ(formulas_of(rolling_disk, {{"r", "0.1 m"}, {"m", "3 kg"}}).front(),
            formulas_of(rolling_disk, {{"r", "100 mm"}, {"m", "3000 g"}}).front());
}

TEST(FormulaAnswers, AreNotGivenForWhatIsNotDetermined) {
  const std::string free =
      "letters: {m: kg, L: m, w: rad/s}\npoints: {O: [0, 0, 0], A: [L, 0, 0]}\n"
      "bodies: {bar: {rod: [O, A], mass: m}}\njoints: {pin: {ball: O, to: bar}}\ngravity: none\n"
      "instants: {now: {angular_velocity(bar): [any, w, any]}}\n"
      "ask: {v: velocity(A of bar).z, H: norm(angular_momentum(bar about O))}\n";
  const Texts found = formulas_of(free);
  EXPECT_EQ(found[0], "-L*w");
  EXPECT_TRUE(found[1].starts_with("none: ")) << found[1];
}

TEST(FormulaAnswers, SayWhatTheyAssume) {
  const SolvedStatement solved =
      solve_statement(read_statement("letters: {m: kg, w: rad/s, L: m}\npoints: {O: [0, 0, 0], A: [L, 0, 0]}\n"
                                     "bodies: {bar: {rod: [O, A], mass: m}}\n"
                                     "joints: {pin: {revolute: z, at: O, to: bar, rate: w}}\n"
                                     "ask: {v: norm(velocity(A of bar))}\n",
                                     "test.yaml"),
                      {});
  EXPECT_EQ(solved.solutions.at(0).assumptions, (Texts{"L > 0", "w > 0"}));
}

}  // namespace formula_answers_test
}  // namespace poinsot::problem
