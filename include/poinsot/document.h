// The answer document: everything that one run on one problem file found. All output is a rendering of it
// (poinsot/rendering.h).
//
// It is plain data that owns all it holds: copies are independent, and one document may be read by several threads.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace poinsot::problem {
struct Explanation;
}

namespace poinsot {

// A number, truth value, text, list of data (vectors and matrices are lists), or nothing.
struct Datum {
  std::variant<std::monostate, double, bool, std::string, std::vector<Datum>> content;

  bool empty() const { return std::holds_alternative<std::monostate>(content); }
};

enum class AnswerState {
  found,
  needs_letters,  // the answer depends on letters that have no value yet
  undetermined,   // the statement does not fix it
  refused,        // found, but its independent check failed
};

// One column of a table: as many numbers as the table has rows.
struct Column {
  std::string name;
  std::string unit;
  std::vector<double> value;  // in `unit`
  std::vector<double> si;     // in SI base units, angles in radians
};

// What has become of a claim, where the answer is to one.
struct ClaimOutcome {
  bool holds = false;
  std::string how;  // "proved" or "sampled"; "" if it does not hold
  // Letters with values for which it does not hold, and the two sides there; numbers in `unit`.
  struct Value {
    std::string letter;
    double value = 0;
    std::string unit;
    double si = 0;
  };
  std::vector<Value> counterexample;
  std::vector<double> sides;           // left and right, in `unit`; empty where it compares no numbers
  std::optional<double> difference{};  // left less right, exactly, where rounding hides it
  std::string unit;
  std::vector<std::string> assumptions;
};

struct Answer {
  std::string name;   // the key under `ask:` or `claim:`
  std::string ask;    // the ask as written
  std::string words;  // what is given, in words: quantity, body, point, axes, sense of a reaction
  AnswerState state = AnswerState::found;
  Datum value;       // in `unit`
  std::string unit;  // "" for pure numbers, truth values and texts
  Datum si;          // in SI base units, angles in radians; may stay empty where `value` has no unit
  std::vector<std::string> component_names;  // of a vector answer: the names of the axes, in order
  std::string reason;                        // for every state but `found`: why, and what would help
  std::vector<std::string> letters;          // for needs_letters: the letters it depends on
  std::vector<Column> columns;               // of a table, in the order asked; then value, si and unit stay empty
  // Where letters were left open: the answer in SI as infix text (a list for vectors), or why it has none.
  Datum formula{};
  std::string no_formula{};
  std::optional<ClaimOutcome> claim{};
};

struct Unknown {
  std::string name;
  Datum value;
  std::string unit;
  Datum si;
  Datum formula{};  // where letters were left open; value and si are then empty if letters remain in it
};

// What must be positive so that formulas hold: a cord's pull, a contact's push.
struct Condition {
  std::string words;    // as among the assumptions
  std::string formula;  // "g*m - F > 0", in SI
};

struct Solution {
  std::vector<Unknown> unknowns;
  std::vector<Answer> answers;             // in the order of the file
  std::map<std::string, double> checks;    // relative residuals found on the independent road, by name
  std::vector<std::string> notes;          // what else was found: stability, what happened during a motion
  std::vector<std::string> assumptions{};  // that the formulas rest on: "m > 0"
  std::vector<Condition> conditions{};     // the formulas of those that are words
  // The worked solution, where it was asked for: to_markdown() writes it.
  std::shared_ptr<const problem::Explanation> explanation{};
};

// A datum without value.
struct Letter {
  std::string name;
  std::string unit;
};

struct Document {
  std::string file;  // the problem's name, as its reader was given it
  std::string title;
  std::vector<Letter> open_letters;
  std::vector<Solution> solutions;
  std::vector<std::string> warnings;
};

// True if there is a solution and every question has its answer in every solution.
bool fully_answered(const Document& document);

// Throws std::domain_error, naming the place, if an answer that counts as found or an unknown has no value or one that
// is not finite: a fault of the program, which no rendering passes on.
void require_values(const Document& document);

}  // namespace poinsot
