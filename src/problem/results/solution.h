// What was found of a statement: unknowns, answers, claims, in SI and with the words that say what each is.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/work/budget.h"
#include "problem/entries/statement.h"
#include "problem/language/value.h"

namespace poinsot::problem {

enum class AskState { found, needs_letters, undetermined, refused };

// One column of a table.
struct SolvedColumn {
  std::string name;
  Unit unit;
  std::vector<double> values;  // SI
};

struct SolvedAsk {
  AskState state = AskState::found;
  Value<double> value;                       // SI; vectors on the asked axes
  Unit unit;                                 // in which it should be shown
  std::vector<std::string> letters;          // for needs_letters
  std::string reason;                        // for undetermined and refused
  std::string words;                         // what is given, in words
  std::vector<std::string> component_names;  // of vectors
  std::vector<SolvedColumn> columns;         // of a table, which has no value
  // Where letters were left open: the answer as a formula, in SI; else why it has none.
  std::optional<Value<poinsot::Formula>> formula;
  std::string no_formula;
  std::string formula_road;  // how a formula was found that does not follow exactly: "by dimensional analysis"
  // Where the caller's budget ended before the answer was found or known to be determined: it is undetermined for that.
  std::optional<BudgetEnd> ended;
};

struct SolvedUnknown {
  std::string name;
  Unit unit;
  Value<double> value;                               // SI
  std::optional<Value<poinsot::Formula>> formula{};  // where letters were left open; then there is no value
  std::string formula_road{};                        // as of asks
};

// What has become of a claim. A refuted claim is an answer.
struct SolvedClaim {
  // Letters, and what the statement leaves open, with values for which the claim does not hold; in SI.
  struct Datum {
    std::string name;
    Unit unit;
    double value = 0;
  };
  AskState state = AskState::found;  // or undetermined
  std::string reason;                // for undetermined
  std::optional<BudgetEnd> ended;    // as of asks
  bool holds = false;
  bool proved = false;                // else found on samples
  std::vector<Datum> counterexample;  // if it does not hold
  // The two sides there, in `unit`, where the claim compares numbers.
  std::optional<std::pair<double, double>> sides;
  // Left less right, where it was decided exactly because rounding hides it.
  std::optional<double> difference;
  Unit unit;
  std::vector<std::string> assumptions;

  // The rest is for worked solutions. Where a claim has formulas: the sides of each number that it compares.
  struct Part {
    std::string of;  // X of a side that is rate(X + ...); or a letter, by which the rate is taken
    bool by_letter = false;
    poinsot::Formula value;
  };
  struct Comparison {
    poinsot::Formula left, right;
    std::string relation;
    Dimension dimension;
    // Left less right with what is assumed worked into the letters: why it vanishes or has its sign.
    std::optional<poinsot::Formula> reduced;
    std::vector<Part> parts;  // of the side that is a rate: they add up to it
  };
  std::vector<Comparison> comparisons;
  // What the assumptions make of letters, with positive letters p1, p2, ...; where there is one case of it.
  std::vector<std::pair<std::string, poinsot::Formula>> assumed;
  // Where a steady motion is claimed to be stable: the characteristic polynomial of the rates of growth, divided by its
  // first coefficient, from the lowest power on, without the roots that vanish because the motion displaced is as good;
  // and what of its coefficients must be positive, which was seen if the claim was proved.
  struct Stability {
    std::vector<poinsot::Formula> polynomial;
    std::size_t vanishing = 0;
    std::string criterion;
    std::vector<poinsot::Formula> positive;
  };
  std::optional<Stability> stability;
};

// Where formulas hold because a cord pulls or a contact pushes: what must be positive for that.
struct FormulaCondition {
  std::string words;  // as among the assumptions
  poinsot::Formula positive;
};

struct Solution {
  std::vector<SolvedUnknown> unknowns;
  std::vector<SolvedAsk> asks;           // in the order of the statement
  std::vector<SolvedClaim> claims{};     // the same
  std::map<std::string, double> checks;  // relative residuals on the road of particles, by name
  std::vector<std::string> assumptions;  // of the formulas: "m > 0"
  std::vector<FormulaCondition> conditions{};
  std::vector<std::string> notes;  // stability of steady motions, what happened on the way of a motion
};

struct SolvedStatement {
  std::vector<Solution> solutions;  // one for each root, ascending by the first unknown; none: warnings say why
  std::vector<Letter> open_letters;
  std::vector<std::string> warnings;
  // What ended the run before everything was done: what was found by then is kept.
  std::optional<BudgetEnd> ended;
};

}  // namespace poinsot::problem
