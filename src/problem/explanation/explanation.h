// A solved statement as a worked solution: what is given, the principle, both sides of its equations in components,
// and the unknowns. Every line is computed from the model. The last step, the answers, is left to the caller.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "problem/answers/solve_statement.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {

// A symbol in an equation, and its value in the unit in which it is shown.
struct ExplainedSymbol {
  std::string tex;
  double value = 0;
};

// One displayed equation.
struct ExplainedEquation {
  std::string name;           // TeX for what is balanced, as \Sigma M_x; "" if there is nothing to say
  std::string tex;            // TeX without delimiters, with `=` between the sides
  std::vector<double> sides;  // the value of each side in SI units, from the terms as they are shown, rounded or exact
  double size = 0;            // the size of the largest term in the sides
  std::vector<ExplainedSymbol> symbols{};  // if it is an equation in numbers and unknowns, the solution
};

// A paragraph of Markdown with TeX between dollar signs, and the equations below it. A reference such as "Eq. 18.25"
// is to a row of docs/theory.md.
struct ExplainedStep {
  std::string text;
  std::vector<ExplainedEquation> equations;
};

struct ExplainedSection {
  std::string heading;
  std::vector<ExplainedStep> steps;
  bool of_inertia = false;  // which is said once
  bool of_sides = false;    // what acts and how bodies move, of which the equations have the numbers
};

struct Explanation {
  std::vector<ExplainedSection> sections;
};

// Explains one solution of a solved statement. sets: those given to solve_statement. What cannot be shown, because a
// letter has no value and there is no formula, is left out, and the text says so. Throws StatementError as
// solve_statement does.
Explanation explain(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets,
                    const SolvedStatement& solved, std::size_t solution);

}  // namespace poinsot::problem
