// The results of a statement: unknowns, answers and claims, in SI units, with words that describe each.
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

// A formula of an answer that has another one at other letters, and the inequalities under which it is this one.
struct RegimeFormula {
  Value<poinsot::Formula> formula;
  std::vector<std::string> where;  // "L - 2*a > 0"; all of them hold
};

struct SolvedAsk {
  AskState state = AskState::found;
  Value<double> value;                       // in SI units; vectors are on the axes that were asked for
  Unit unit;                                 // the unit in which it is shown
  std::vector<std::string> letters;          // the letters that it depends on, if state is needs_letters
  std::string reason;                        // if state is undetermined or refused
  std::string words;                         // a description of the answer
  std::vector<std::string> component_names;  // names of the components of a vector
  std::vector<SolvedColumn> columns;         // the columns of a table, which has no value
  std::optional<SolvedColumn> over{};        // what the table runs over, if no column shows that
  // If letters have no value: the answer as a formula, in SI units, or else why it has none.
  std::optional<Value<poinsot::Formula>> formula;
  std::string no_formula;
  // Where the answer has several formulas, each on its side of a branch: all of them, `formula` first.
  std::vector<RegimeFormula> regimes;
  std::string formula_road;  // how a formula was found that was not derived exactly: "by dimensional analysis"
  // Where the caller's budget ended before the answer was found or known to be determined: it is undetermined for that.
  std::optional<BudgetEnd> ended;
};

struct SolvedUnknown {
  std::string name;
  Unit unit;
  Value<double> value;                               // SI
  std::optional<Value<poinsot::Formula>> formula{};  // if it depends on letters without value; then `value` is not set
  std::string formula_road{};                        // as for asks
  // The name that the file gives it, and the place of the situation whose own it is; none if it is common to all. It is
  // shown by `name`: "x @ second".
  std::string own_name = name;
  std::optional<std::size_t> situation{};

  // Whether it is an unknown of the situation at this place in the statement.
  bool is_of(std::size_t place) const { return !situation || *situation == place; }
};

// The verdict on a claim. A refuted claim is an answer too.
struct SolvedClaim {
  // A value of a letter, or of what the statement leaves open, in SI units, in an example where the claim fails.
  struct Datum {
    std::string name;
    Unit unit;
    double value = 0;
  };
  AskState state = AskState::found;  // may also be undetermined
  std::string reason;                // if it is undetermined
  std::optional<BudgetEnd> ended;    // as for asks
  bool holds = false;
  bool proved = false;                // otherwise it only held at all points tried
  std::vector<Datum> counterexample;  // if it does not hold
  // The two sides at the counterexample, in `unit`, if the claim compares numbers.
  std::optional<std::pair<double, double>> sides;
  // The left side less the right one, if this was computed exactly because rounding hides it.
  std::optional<double> difference;
  Unit unit;
  std::vector<std::string> assumptions;

  // What follows is for worked solutions. If the claim has formulas, each comparison of numbers has its two sides.
  struct Part {
    std::string of;  // an addend X of a side rate(X + ...), or a letter by which the rate is taken
    bool by_letter = false;
    poinsot::Formula value;
  };
  struct Comparison {
    poinsot::Formula left, right;
    std::string relation;
    Dimension dimension;
    // The left side less the right one with the assumptions worked into the letters. It shows why the difference
    // vanishes or has its sign.
    std::optional<poinsot::Formula> reduced;
    std::vector<Part> parts;  // the parts of the side that is a rate; they add up to it
    std::string of;           // what is compared, as `a < b`
    int component = -1;       // of vectors, from 0
  };
  std::vector<Comparison> comparisons;
  // What the assumptions make of the letters, in terms of positive letters p1, p2, ..., if there is a single case.
  std::vector<std::pair<std::string, poinsot::Formula>> assumed;
  std::vector<std::string> positive_parts;  // the names p1, p2, ... of these letters
  // For a claim that a steady motion is stable: the characteristic polynomial of the rates of growth in ascending
  // powers, divided by its first coefficient, without the roots that vanish because the displaced motion is the same;
  // and the expressions that must be positive. They are known to be so if the claim was proved.
  struct Stability {
    std::vector<poinsot::Formula> polynomial;
    std::size_t vanishing = 0;
    std::string criterion;
    std::vector<poinsot::Formula> positive;
  };
  std::optional<Stability> stability;
};

// A condition under which formulas hold: a cord pulls, or a contact pushes, if this is positive.
struct FormulaCondition {
  std::string words;  // as in the list of assumptions
  poinsot::Formula positive;
  std::string inequality{};         // of it in the words, "M - Q > 0"; "" if there is none
  std::vector<std::size_t> asks{};  // whose formulas it is told of; none: of all
};

// In which state a contact with friction was found.
struct ContactState {
  std::string contact;
  std::size_t situation = 0;
  Grip grip = Grip::unknown;
  std::optional<Expression> slip{};  // if it slides: the direction
  bool from_rest = false;            // whether it begins to
  bool in_joint = false;             // whether it is the friction in the joint of this name, or of a cord
  bool idle = false;                 // whether it takes no part in a blow, which does not press it
  bool sought = false;  // whether the slip of its joint, in several ways together, was sought as of contacts

  // Whether it slides along a direction that is no axis of its joint and no way of its cord.
  bool has_direction() const { return slip && (!in_joint || sought); }
};

struct Solution {
  std::vector<ContactState> contact_states{};  // of all contacts with friction
  std::vector<SolvedUnknown> unknowns;
  std::vector<SolvedAsk> asks;           // in the order of the statement
  std::vector<SolvedClaim> claims{};     // in the order of the statement
  std::map<std::string, double> checks;  // relative misfits in the check with particles, by name
  bool refused = false;                  // whether a check refuses what was found, the unknowns too
  std::vector<std::string> assumptions;  // under which the formulas hold: "m > 0"
  std::vector<FormulaCondition> conditions{};
  std::vector<FormulaCondition> grounds{};  // other assumptions that are known as formulas
  std::vector<std::string> notes;           // on the stability of steady motions, and on events during a motion
};

struct SolvedStatement {
  // One for each root, in ascending order of the first unknown; if there is none, the warnings say why.
  std::vector<Solution> solutions;
  std::vector<Letter> open_letters;
  std::vector<std::string> warnings;
  // What ended the run early, if anything. The results found by then are kept.
  std::optional<BudgetEnd> ended;
};

}  // namespace poinsot::problem
