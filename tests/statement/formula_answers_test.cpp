// Formulas of problems whose data are letters, against the same problems solved with numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "docs/fenced_blocks.h"
#include "poinsot/math/expression_text.h"
#include "poinsot/statement/solve_statement.h"

namespace poinsot::statement {
namespace {

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
    Problem& problem = statement.situations[s].problem;
    for (auto it = problem.given.begin(); it != problem.given.end();) {
      const Number* number = it->value.as<Number>();
      if (!number || !number->has_unit || number->value <= 0) {
        ++it;
        continue;
      }
      problem.letters.push_back({it->name, number->unit, it->mark});
      if (s == 0) values.emplace_back(it->name, number->text);
      it = problem.given.erase(it);
    }
  }
  return values;
}

// The values of a formula at values of the letters.
std::vector<double> numbers_of(const Value<poinsot::Expression>& formula, const LetterValues& letters) {
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
    for (const Letter& letter : stated.situations.front().problem.letters) letters[letter.name] = 1;
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
      const std::vector<double> found = numbers_of(*ask.formula, letters);
      const std::vector<double> expected = numbers_of(numbers.solutions.front().asks[i].value);
      ASSERT_EQ(found.size(), expected.size()) << where;
      double size = 1e-9;
      for (double number : expected) size = std::max(size, std::abs(number));
      for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-8 * size) << where;
    }
}

// Nothing that is found by searching or by following a motion.
bool is_plain(const Statement& statement) {
  for (const Situation& situation : statement.situations)
    if (!situation.problem.find.empty() || !situation.problem.stages.empty()) return false;
  for (const Ask& ask : statement.asks) {
    if (ask.table || ask.when || ask.extremum) return false;
    if (ask.text.find("max(") != std::string::npos || ask.text.find("period(") != std::string::npos) return false;
  }
  return true;
}

TEST(FormulaAnswers, OfTheManualsExamplesAreTheirNumbers) {
  Tally tally;
  for (const FencedBlock& block : fenced_blocks("docs/language.md")) {
    if (block.kind != "yaml") continue;
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

std::vector<std::string> texts_of(const Value<poinsot::Expression>& formula) {
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

}  // namespace
}  // namespace poinsot::statement
