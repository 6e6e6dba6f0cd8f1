// Worked solutions of every textbook problem: what is displayed must be true, complete and readable.
//
// The two sides of each displayed equation come from different roads (forces of the solution; momenta of the bodies),
// and the forces are those that the check on particles has confirmed: so equations read back from the text that balance
// hold for the particles as well.
#include "problem/explanation/explanation.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "document/rounding.h"
#include "document/tex_sums.h"
#include "example_files.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"
#include "problem/entries/statement.h"

namespace poinsot::document {
namespace explanation_test {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Case {
  std::string name;
  Document document;
};

// Each file as it stands, and with the values that its first case of expected answers gives to the letters.
const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> list;
    for (const fs::path& file : testing::example_files("textbook")) {
      const problem::Statement stated = problem::read_statement(contents(file), file.string());
      list.push_back({file.stem().string(), Problem::from_file(file.string()).explain()});
      if (stated.expected.empty() || stated.expected.front().sets.empty()) continue;
      list.push_back({file.stem().string() + " with values",
                      Problem::from_file(file.string()).explain(stated.expected.front().sets)});
    }
    return list;
  }();
  return all;
}

template <class Visit>
void for_each_equation(const Visit& visit) {
  for (const Case& one : cases())
    for (const Solution& solution : one.document.solutions)
      for (const auto& section : solution.explanation->sections)
        for (const auto& step : section.steps)
          for (const auto& equation : step.equations) visit(one, equation);
}

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + piece.size())) ++count;
  return count;
}

// "0.00120" has three.
std::size_t significant_digits(std::string number) {
  std::erase(number, '.');
  return number.size() - std::min(number.find_first_not_of('0'), number.size());
}

void expect_none_empty() {
  EXPECT_GT(cases().size(), static_cast<std::size_t>(testing::at_least(150)));
  for (const Case& one : cases()) {
    for (const Solution& solution : one.document.solutions) {
      ASSERT_TRUE(solution.explanation) << one.name;
      EXPECT_GE(solution.explanation->sections.size(), 2u) << one.name;
      for (const auto& section : solution.explanation->sections) {
        EXPECT_FALSE(section.heading.empty()) << one.name;
        EXPECT_FALSE(section.steps.empty()) << one.name << ": " << section.heading;
        for (const auto& step : section.steps) EXPECT_FALSE(step.text.empty() && step.equations.empty()) << one.name;
      }
    }
  }
}

void expect_equal_sides() {
  std::size_t compared = 0;
  for_each_equation([&](const Case& one, const problem::ExplainedEquation& equation) {
    for (const double side : equation.sides) {
      EXPECT_NEAR(side, equation.sides.front(), 1e-5 * equation.size) << one.name << ": " << equation.tex;
      ++compared;
    }
  });
  EXPECT_GT(compared, static_cast<std::size_t>(testing::at_least(1000)));
}

void expect_displayed_numbers_to_balance() {
  std::size_t read = 0;
  for_each_equation([&](const Case& one, const problem::ExplainedEquation& equation) {
    const std::size_t sign = equation.tex.find(" = "), last = equation.tex.rfind(" = ");
    if (equation.symbols.empty() || sign == std::string::npos) return;
    std::vector<std::pair<std::string, double>> symbols;
    for (const auto& symbol : equation.symbols) symbols.emplace_back(symbol.tex, symbol.value);
    const auto left = testing::TexSumReader(equation.tex.substr(0, sign), symbols).read();
    const auto right = testing::TexSumReader(equation.tex.substr(last + 3), symbols).read();
    ASSERT_TRUE(left && right) << one.name << ": " << equation.tex;
    EXPECT_NEAR(left->value, right->value, 1e-5 * std::max(left->size, right->size))
        << one.name << ": " << equation.tex;
    ++read;
  });
  EXPECT_GT(read, static_cast<std::size_t>(testing::at_least(200)));
}

void expect_equations_of_the_theory() {
  const std::string theory = contents(fs::path(POINSOT_SOURCE_DIR) / "docs" / "theory.md");
  std::set<std::string> known;
  // Rows of the tables: "| 18.14 - 18.17 |", "| 18.1, 18.2 |".
  const std::regex row("\\n\\| ([0-9., -]+) \\|"), range("(\\d+)\\.(\\d+)( - \\d+\\.(\\d+))?");
  for (std::sregex_iterator it(theory.begin(), theory.end(), row), end; it != end; ++it) {
    const std::string cell = (*it)[1];
    for (std::sregex_iterator n(cell.begin(), cell.end(), range); n != end; ++n) {
      const int first = std::stoi((*n)[2]), last = (*n)[4].matched ? std::stoi((*n)[4]) : first;
      for (int k = first; k <= last; ++k) known.insert((*n)[1].str() + "." + std::to_string(k));
    }
  }
  ASSERT_TRUE(known.contains("18.16")) << "the tables of docs/theory.md are not read";
  const std::regex cited("Eqs?\\. ([0-9., and]+[0-9])"), number("\\d+\\.\\d+");
  std::set<std::string> used;
  for (const Case& one : cases()) {
    for (std::size_t i = 0; i < one.document.solutions.size(); ++i) {
      const std::string text = to_markdown(one.document, i);
      for (std::sregex_iterator it(text.begin(), text.end(), cited), end; it != end; ++it) {
        const std::string list = (*it)[1];
        for (std::sregex_iterator n(list.begin(), list.end(), number); n != end; ++n) used.insert(n->str());
      }
    }
  }
  EXPECT_GT(used.size(), 8u);
  for (const std::string& equation : used) EXPECT_TRUE(known.contains(equation)) << "Eq. " << equation;
}

void expect_readable() {
  const std::regex number("[0-9]+(\\.[0-9]+)?");
  for (const Case& one : cases()) {
    for (const Solution& solution : one.document.solutions) {
      for (const auto& section : solution.explanation->sections)
        for (const auto& step : section.steps) {
          // Without the rules of tables.
          std::string all = std::regex_replace(step.text, std::regex("\\|-[-|]*"), "|");
          for (const auto& equation : step.equations) {
            EXPECT_EQ(count_of(equation.tex, "{"), count_of(equation.tex, "}")) << one.name << ": " << equation.tex;
            EXPECT_EQ(count_of(equation.tex, "\\left("), count_of(equation.tex, "\\right)"))
                << one.name << ": " << equation.tex;
            EXPECT_EQ(equation.tex.find('$'), std::string::npos) << one.name << ": " << equation.tex;
            // An underscore in an upright name would be an index.
            EXPECT_FALSE(std::regex_search(equation.tex, std::regex("\\\\mathrm\\{[^{}\\\\]*_")))
                << one.name << ": " << equation.tex;
            EXPECT_LT(equation.tex.size(), 6000u) << one.name;
            all += "\n" + equation.tex;
          }
          EXPECT_EQ(count_of(step.text, "$") % 2, 0u) << one.name << ": " << step.text;
          EXPECT_FALSE(std::regex_search(all, std::regex("\\b(nan|inf)\\b"))) << one.name << ": " << all;
          EXPECT_EQ(all.find("--"), std::string::npos) << one.name << ": " << all;
          EXPECT_EQ(all.find("+ -"), std::string::npos) << one.name << ": " << all;
        }
      for (const auto& section : solution.explanation->sections)
        for (const auto& step : section.steps)
          for (const auto& equation : step.equations) {
            if (equation.symbols.empty()) continue;
            for (std::sregex_iterator it(equation.tex.begin(), equation.tex.end(), number), end; it != end; ++it)
              EXPECT_LE(significant_digits(it->str()), 6u) << one.name << ": " << equation.tex;
          }
    }
  }
}

// The answers stand at the end, as in the document.
void expect_answers_at_the_end() {
  for (const Case& one : cases())
    for (std::size_t i = 0; i < one.document.solutions.size(); ++i) {
      const std::string text = to_markdown(one.document, i);
      const std::size_t begin = text.rfind("\n## Answers\n");
      ASSERT_NE(begin, std::string::npos) << one.name;
      const std::string answers = text.substr(begin);
      EXPECT_EQ(answers.find("\n## ", 1), std::string::npos) << one.name;
      for (const Answer& answer : one.document.solutions[i].answers) {
        EXPECT_NE(answers.find("* *" + answer.name + "*"), std::string::npos) << one.name << ": " << answer.name;
        const auto* number = std::get_if<double>(&answer.value.content);
        if (answer.state == AnswerState::found && number) {
          EXPECT_NE(answers.find(rounded(*number, 6)), std::string::npos) << one.name << ": " << answer.name;
        }
      }
    }
}

// One test, so that the problems are solved once.
// What somebody wrote is text, whatever it means to Markdown, HTML or TeX.
TEST(Explanation, ATitleHasNoMarkup) {
  const Problem problem = Problem::from_text(
      "title: 'A *top* <b>of</b> [0.5](http://a.org) $m$ `x`'\nbodies: {b: {particle: [0, 0, 0], mass: 2 kg}}\nask: "
      "{a: mass(b)}\n",
      "t.yaml");
  const std::string markdown = to_markdown(problem.explain());
  EXPECT_TRUE(markdown.starts_with("# A \\*top\\* \\<b\\>of\\</b\\> \\[0.5\\](http\\://a.org) \\$m\\$ \\`x\\`\n"))
      << markdown.substr(0, 120);
}

TEST(Explanation, OfEveryTextbookProblem) {
  expect_none_empty();
  expect_equal_sides();
  expect_displayed_numbers_to_balance();
  expect_equations_of_the_theory();
  expect_readable();
  expect_answers_at_the_end();
}

// The excerpt in the manual is one of its first problem's solution.
TEST(Explanation, IsWhatTheManualShows) {
  const std::string page = contents(fs::path(POINSOT_SOURCE_DIR) / "docs" / "language.md");
  const auto block = [&](const std::string& kind) {
    const std::size_t begin = page.find("```" + kind + "\n") + kind.size() + 4;
    return page.substr(begin, page.find("```", begin) - begin);
  };
  const fs::path file = fs::path(::testing::TempDir()) / "explained.yaml";
  std::ofstream(file) << block("yaml");
  const Document document = Problem::from_file(file.string()).explain();
  fs::remove(file);
  const std::string text = "\n" + to_markdown(document);
  std::istringstream lines(block("markdown"));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    EXPECT_NE(text.find("\n" + line + "\n"), std::string::npos) << line;
  EXPECT_GT(count, 8u);
}

// What a reader of a known problem must find in it.
TEST(Explanation, ShowsTheStepsOfBearingReactions) {
  const fs::path file = fs::path(POINSOT_SOURCE_DIR) / "examples" / "textbook" / "18.105.yaml";
  const std::string text = to_markdown(Problem::from_file(file.string()).explain(), 0);
  for (const char* piece :
       {"\\Sigma F_{x}", "\\Sigma M_{y}", "D_{x}", "E_{y}", "\\boldsymbol{\\Omega}", "Eqs. 18.1, 18.2", "## Inertia",
        "## Kinetic side", "## Component equations", "## Unknowns"})
    EXPECT_NE(text.find(piece), std::string::npos) << piece << "\n" << text;
}

std::string explained(const std::string& statement) {
  const fs::path file = fs::path(::testing::TempDir()) / "explained_part.yaml";
  std::ofstream(file) << statement;
  const std::string text = to_markdown(Problem::from_file(file.string()).explain());
  fs::remove(file);
  return text;
}

// The cells of the table's rows, the dollars of formulas stripped.
std::vector<std::vector<std::string>> table_in(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| ")) continue;
    std::vector<std::string>& row = rows.emplace_back();
    std::istringstream cells(line.substr(2));
    for (std::string cell; std::getline(cells, cell, '|');)
      if (cell.size() > 2) row.push_back(cell.substr(0, cell.find_last_not_of(' ') + 1));
    for (std::string& cell : row) cell.erase(0, cell.find_first_not_of(' '));
  }
  return rows;
}

// A number of a table, as mathematics or zero.
double number_in(const std::string& cell) { return std::stod(cell.substr(cell.front() == '$' ? 1 : 0)); }

TEST(Explanation, TellsTheWholeOfABodyByItsParts) {
  const auto rows = table_in(explained(R"(
given: {q: 2 kg/m, a: 0.3 m}
points: {O: [0, 0, 0], A: [a, 0, 0], B: [a, a, 0], C: [a, a, a]}
bodies:
  wire: {wire: [O, A, B, C], density: q, added: {bob: {particle: C, mass: 0.5 kg}}}
gravity: none
ask: {I: inertia_matrix(wire about O)}
)"));
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[1][0], "OA");
  EXPECT_EQ(rows[3][0], "BC");
  EXPECT_EQ(rows[4][0], "bob");
  EXPECT_EQ(rows[5][0], "**sum**");
  // All but the centers add up.
  for (std::size_t c = 1; c < rows[0].size(); ++c) {
    ASSERT_EQ(rows[5].size(), rows[0].size());
    if (rows[0][c].find("\\bar") != std::string::npos) continue;
    double sum = 0;
    for (std::size_t r = 1; r < 5; ++r) sum += number_in(rows[r][c]);
    EXPECT_NEAR(sum, number_in(rows[5][c]), 2e-5) << rows[0][c];
  }
  EXPECT_NEAR(number_in(rows[1][1]), 0.6, 1e-12);
  // A body of one part has no table.
  EXPECT_TRUE(table_in(explained(R"(
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {bar: {rod: [O, A], mass: 2 kg}}
gravity: none
ask: {I: inertia_matrix(bar about O)}
)"))
                  .empty());
}

// An arm without mass turns out of the plane of its axes, and carries what the gear exerts across it: its motor drives
// it with M = -L G_z + M_{G,y}.
TEST(Explanation, WhatHasNoMassDoesNotStayInAPlaneForThat) {
  const std::string text = explained(R"yaml(
letters: {m: kg, r: m, L: m, w: rad/s, q: rad/s^2}
points: {O: [0, 0, 0], G: [L, 0, 0], P: [L, -r, 0]}
bodies: {arm: massless, gear: {disk: {center: G, normal: x, radius: r}, mass: m}}
joints:
  post: {revolute: y, at: O, to: arm, rate: w, accel: q}
  axle: {revolute: x, at: G, from: arm, to: gear}
contacts: {mesh: {of: gear, at: P, normal: y, no_slip: true, carries: [z]}}
gravity: none
instants: {now: {}}
ask: {D: drive(post).y, M: couple(axle on gear about G)}
)yaml");
  EXPECT_EQ(text.find("*arm* moves in the"), std::string::npos) << text;
  EXPECT_NE(text.find("L\\,G_{z} - M_{G,y} + M_{\\mathrm{post}} &= 0"), std::string::npos) << text;
}

TEST(Explanation, AnUnknownThatIsAskedForByItsNameIsToldOnce) {
  const std::string text = explained(R"yaml(
given: {m: 2 kg}
find: {F: N}
points: {O: [0, 0, 0]}
bodies: {block: {particle: O, mass: m}}
loads: {push: {force: [F, 0, 0], body: block}}
gravity: none
instants: {now: {velocity(block): [0, 0, 0], acceleration(block).x: 3 m/s^2}}
ask: {F: F, twice: 2*F}
)yaml");
  EXPECT_NE(text.find("* *F*"), std::string::npos) << text;
  EXPECT_EQ(text.find("* *F*"), text.rfind("* *F*")) << text;
}

TEST(Explanation, TellsOfAParticleItsMassAlone) {
  const Document document = Problem::from_file(POINSOT_SOURCE_DIR "/examples/published/crane.yaml").explain();
  const std::string text = to_markdown(document);
  EXPECT_NE(text.find("*load*: mass $M"), std::string::npos);
  EXPECT_EQ(text.find("about $G_{\\mathrm{load}}$ on axes"), std::string::npos);
  EXPECT_EQ(text.find("principal axes"), std::string::npos);
  // In a table powers of ten are mathematics, too.
  EXPECT_NE(text.find("| $3\\cdot 10^{6}$ |"), std::string::npos);
}

TEST(Explanation, TellsWhatDecidedAClaim) {
  const std::string text = explained(R"(
letters: {m: kg, L: m}
points: {O: [0, 0, 0], A: [0, -L, 0]}
bodies: {bar: {rod: [O, A], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar, angle: theta}}
gravity: -y
define: {T: kinetic_energy(bar), V: potential_energy(bar), E: T + V}
claim:
  energy: "T == m*L^2*theta'^2/6"
  kept: "E' == 0"
  falls: {claim: "theta'' < 0", assume: [0 < theta < 180 deg]}
  wrong: "theta'' == -g*sin(theta)/L"
)");
  for (const char* piece :
       {"\\text{left} &= \\frac{m L^{2} \\dot{\\theta}^{2}}{6}", "\\text{left} - \\text{right} &= 0",
        "\\frac{\\mathrm{d}}{\\mathrm{d}t}\\,V &= \\frac{m g L \\dot{\\theta} \\sin \\theta}{2}", "\\text{sum} &= 0",
        "$\\theta = 2 \\arctan p_{1}$", "< 0", "the left side is $"})
    EXPECT_NE(text.find(piece), std::string::npos) << piece << "\n" << text;
}

}  // namespace explanation_test
}  // namespace poinsot::document
