// A solved statement as a worked solution: what is given, the principle, the two sides of its equations in components,
// the unknowns. Every line is computed from the model; the last step, the answers, is left to whoever shows them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "problem/answers/solve_statement.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {

// What a symbol in an equation stands for, as number in the unit in which it is shown.
struct ExplainedSymbol {
  std::string tex;
  double value = 0;
};

// One displayed equation.
struct ExplainedEquation {
  std::string name;           // TeX of what is balanced, as \Sigma M_x; "" where there is nothing to say
  std::string tex;            // TeX, without delimiters, with `=` between its sides
  std::vector<double> sides;  // what each side amounts to, SI: from the terms that are shown, rounded as shown or exact
  double size = 0;            // of the largest term in them
  std::vector<ExplainedSymbol> symbols{};  // in an equation between numbers and unknowns: what solves it
};

// A paragraph of Markdown, with TeX between dollar signs, and the equations below it. "Eq. 18.25" in it is a row of
// docs/theory.md.
struct ExplainedStep {
  std::string text;
  std::vector<ExplainedEquation> equations;
};

struct ExplainedSection {
  std::string heading;
  std::vector<ExplainedStep> steps;
};

struct Explanation {
  std::vector<ExplainedSection> sections;
};

// One solution of a solved statement explained. sets: as they were for solve_statement. What cannot be shown (letters
// without value where there is no formula) is left out, and the text says so. Throws StatementError as
// solve_statement does.
Explanation explain(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets,
                    const SolvedStatement& solved, std::size_t solution);

}  // namespace poinsot::problem
