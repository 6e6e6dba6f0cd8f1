// The problems of examples/textbook with letters: every formula that is printed, at random letters, is what the problem
// solved with these numbers gives, and that is confirmed on particles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "example_files.h"
#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace textbook_formulas_test {

namespace fs = std::filesystem;

struct Draw {
  std::vector<std::pair<std::string, std::string>> sets;
  LetterValues values;
};

// Each letter within two octaves of its unit, angles from 0.2 to 1.2 rad, in four digits.
Draw draw(const std::vector<Letter>& letters, std::mt19937_64& random) {
  Draw result;
  for (const Letter& letter : letters) {
    const bool angle = letter.unit.dimension == dimensions::angle;
    const double drawn = std::uniform_real_distribution<double>(angle ? 0.2 / letter.unit.factor : 0.5,
                                                                angle ? 1.2 / letter.unit.factor : 2)(random);
    char text[40];
    std::snprintf(text, sizeof text, "%.4f", drawn);
    const std::string unit = letter.unit.text.empty() || letter.unit.text == "1" ? "" : " " + letter.unit.text;
    result.sets.emplace_back(letter.name, text + unit);
    result.values[letter.name] = std::stod(text) * letter.unit.factor;
  }
  return result;
}

std::vector<double> numbers_of(const Value<double>& value) {
  if (value.is_number()) return {value.number};
  if (value.is_vector()) return {value.vector.x, value.vector.y, value.vector.z};
  std::vector<double> all;
  for (const Value<double>& item : value.items)
    for (const double number : numbers_of(item)) all.push_back(number);
  return all;
}
std::vector<poinsot::Formula> numbers_of(const Value<poinsot::Formula>& value) {
  if (value.is_number()) return {value.number};
  if (value.is_vector()) return {value.vector.x, value.vector.y, value.vector.z};
  std::vector<poinsot::Formula> all;
  for (const auto& item : value.items)
    for (const poinsot::Formula& number : numbers_of(item)) all.push_back(number);
  return all;
}

// By how much the formulas of a solution differ from the numbers of another, relative to the size of each answer.
double difference(const Solution& formulas, const Solution& numbers, const LetterValues& letters, std::string& worst) {
  double largest = 0;
  for (std::size_t i = 0; i < formulas.asks.size(); ++i) {
    if (!formulas.asks[i].formula || numbers.asks[i].state != AskState::found) continue;
    const std::vector<poinsot::Formula> stated = numbers_of(*formulas.asks[i].formula);
    const std::vector<double> found = numbers_of(numbers.asks[i].value);
    if (stated.size() != found.size()) return INFINITY;
    double size = 1e-300;
    for (const double number : found) size = std::max(size, std::abs(number));
    for (std::size_t k = 0; k < found.size(); ++k) {
      const double apart = std::abs(value_at(stated[k], letters) - found[k]) / size;
      // Noise is shown as zero.
      if (size < 1e-12 || !(apart > largest)) continue;
      largest = apart;
      worst = text(stated[k]) + " is not " + std::to_string(found[k]);
    }
  }
  return largest;
}

TEST(TextbookFormulas, AreTheNumbersOfTheProblemSolvedWithSettings) {
  std::mt19937_64 random(99);
  int files = 0, formulas = 0, compared = 0;
  for (const fs::path& path : poinsot::testing::example_files("textbook")) {
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    Statement statement = read_statement(text.str(), path.string());
    statement.claims.clear();
    if (statement.asks.empty()) continue;
    const SolvedStatement open = solve_statement(statement, {});
    if (open.open_letters.empty() || open.solutions.empty()) continue;
    int here = 0;
    for (const SolvedAsk& ask : open.solutions.front().asks) here += ask.formula ? 1 : 0;
    if (here == 0) continue;
    ++files;
    formulas += here;
    int held = 0;
    for (int attempt = 0; attempt < 12 && held < 2; ++attempt) {
      const Draw drawn = draw(open.open_letters, random);
      SolvedStatement numbers;
      try {
        numbers = solve_statement(statement, drawn.sets);
      } catch (const StatementError&) {
        continue;  // not at these letters
      }
      // What is refused there, because a cord would have to push, was not held against anything.
      if (numbers.solutions.empty()) continue;
      for (const Solution& solution : open.solutions) {
        double least = INFINITY;
        std::string worst;
        for (const Solution& other : numbers.solutions) {
          std::string words;
          const double apart = difference(solution, other, drawn.values, words);
          if (apart >= least) continue;
          least = apart;
          worst = words;
        }
        if (open.solutions.size() > 1 && numbers.solutions.size() != open.solutions.size()) continue;
        EXPECT_LE(least, 1e-9) << path << ": " << worst;
      }
      for (const Solution& solution : numbers.solutions)
        for (const auto& [name, residual] : solution.checks)
          EXPECT_LE(residual, name == "motion_error" ? 1e-5 : 1e-8) << path << ": " << name;
      ++held;
    }
    compared += held;
    EXPECT_GT(held, 0) << path << ": at no letters";
  }
  // As many as there are, so that none is left out unseen.
  EXPECT_GE(files, poinsot::testing::at_least(32));
  EXPECT_GE(formulas, poinsot::testing::at_least(54));
  EXPECT_GE(compared, 2 * files - 10);
}

}  // namespace textbook_formulas_test
}  // namespace poinsot::problem
