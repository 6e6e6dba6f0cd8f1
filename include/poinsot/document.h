// The answer document: everything that one run on a problem file found. All output renders it (poinsot/rendering.h).
//
// It is plain data and owns what it holds. Copies are independent, and several threads may read one document.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "poinsot/engine/work/budget.h"
#include "poinsot/scene.h"

namespace poinsot::problem {
struct Explanation;
}

namespace poinsot {

// A number, truth value, text, list of data (as are vectors and matrices), or nothing.
struct Datum {
  std::variant<std::monostate, double, bool, std::string, std::vector<Datum>> content;

  bool empty() const { return std::holds_alternative<std::monostate>(content); }
};

enum class AnswerState {
  found,
  needs_letters,  // the answer depends on letters that have no value yet
  undetermined,   // nothing in the file determines it
  refused,        // it was found, but a check failed
};

// A column of a table, with one number for each row.
struct Column {
  std::string name;
  std::string unit;
  std::vector<double> value;  // in `unit`
  std::vector<double> si;     // in SI base units, angles in radians
};

// The verdict, if the answer is to a claim.
struct ClaimOutcome {
  bool holds = false;
  std::string how;  // "proved" or "sampled"; "" if it does not hold
  // Values of letters for which it does not hold, and both sides there; numbers are in `unit`.
  struct Value {
    std::string letter;
    double value = 0;
    std::string unit;
    double si = 0;
  };
  std::vector<Value> counterexample;
  std::vector<double> sides;           // left and right, in `unit`; empty if the claim compares no numbers
  std::optional<double> difference{};  // left less right, computed exactly if rounding hides it
  std::string unit;
  std::vector<std::string> assumptions;
};

// One of several formulas of an answer, and the inequalities between formulas under which it is this one.
struct FormulaWhere {
  Datum formula;
  std::vector<std::string> where;  // "L - 2*a > 0", in SI units; all of them hold
};

struct Answer {
  std::string name;   // the key under `ask:` or `claim:`
  std::string ask;    // the ask as written
  std::string words;  // a description of the answer: quantity, body, point, axes, sense of a reaction
  AnswerState state = AnswerState::found;
  Datum value;                               // in `unit`
  std::string unit;                          // "" for pure numbers, truth values and texts
  Datum si;                                  // in SI base units and radians; may be empty if `value` has no unit
  std::vector<std::string> component_names;  // of a vector answer: the names of the axes, in order
  std::string reason;                        // for every state but `found`: why, and what would help
  std::vector<std::string> letters;          // for needs_letters: the letters it depends on
  std::vector<Column> columns;               // of a table, in the order asked for; then value, si and unit are empty
  // If letters have no value: the answer in SI units as text (for vectors a list), or why it has none.
  Datum formula{};
  std::string no_formula{};
  std::vector<FormulaWhere> formulas{};  // where it has another one at other letters: all of them, `formula` first
  std::optional<Column> over{};          // what a table runs over, row by row, if none of its columns shows that
  std::optional<ClaimOutcome> claim{};
};

struct Unknown {
  std::string name;
  Datum value;
  std::string unit;
  Datum si;
  Datum formula{};  // if letters have no value; value and si are empty if it contains such letters
};

// A condition under which formulas hold: a cord pulls or a contact pushes if this is positive.
struct Condition {
  std::string words;    // as in the list of assumptions
  std::string formula;  // "g*m - F > 0", in SI units
};

struct Solution {
  std::vector<Unknown> unknowns;
  std::vector<Answer> answers;             // in the order of the file
  std::map<std::string, double> checks;    // relative misfits in the check with particles, by name
  std::vector<std::string> notes;          // on stability, and on events during a motion
  std::vector<std::string> assumptions{};  // under which formulas hold: "m > 0"
  std::vector<Condition> conditions{};     // the formulas of assumptions in words
  // The worked solution, if it was asked for. to_markdown() writes it.
  std::shared_ptr<const problem::Explanation> explanation{};
  // What a picture of it shows, if it was asked for.
  std::shared_ptr<const poinsot::scene::Scene> scene{};
  // The same of the statement's other situations, in the order of the file.
  std::vector<std::shared_ptr<const poinsot::scene::Scene>> other_scenes{};
};

// A datum without value.
struct Letter {
  std::string name;
  std::string unit;
};

// A number of nature in formulas, where it stands by its digits, and the name by which people know it: g.
struct Constant {
  std::string name;
  std::string digits;  // as in formulas: "9.80665"
  std::string unit;    // SI
};

struct Document {
  std::string file;  // the name of the problem, as given to Problem::from_text()
  std::string title;
  std::vector<Letter> open_letters;
  std::vector<Solution> solutions;
  std::vector<std::string> warnings;
  std::vector<Constant> constants{};  // that stand in formulas of the solutions
  // Where a budget ended the search: the document holds what was found until then.
  std::optional<BudgetEnd> ended{};
};

// True if there is a solution and every question has its answer in every solution.
bool fully_answered(const Document& document);

// Throws std::domain_error, which names the place, if an answer marked as found, or an unknown, has no finite value.
// That is an error in the program, which no rendering should hide.
void require_values(const Document& document);

}  // namespace poinsot
