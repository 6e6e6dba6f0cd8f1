// All questions of a statement, answered.
//
// An answer is determined when no choice of what the statement leaves open changes it: letters without value, values
// given as `any`, gravity of which nothing is said, velocities and forces that no equation fixes. Each of these is
// varied by itself and the answers are compared, so that what an answer depends on can be named.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/math/expression.h"
#include "poinsot/statement/data.h"
#include "poinsot/statement/problem.h"

namespace poinsot::statement {

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
  std::optional<Value<poinsot::Expression>> formula;
  std::string no_formula;
};

struct SolvedUnknown {
  std::string name;
  Unit unit;
  Value<double> value;                                  // SI
  std::optional<Value<poinsot::Expression>> formula{};  // where letters were left open; then there is no value
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
  bool holds = false;
  bool proved = false;                // else found on samples
  std::vector<Datum> counterexample;  // if it does not hold
  // The two sides there, in `unit`, where the claim compares numbers.
  std::optional<std::pair<double, double>> sides;
  Unit unit;
  std::vector<std::string> assumptions;
};

struct Solution {
  std::vector<SolvedUnknown> unknowns;
  std::vector<SolvedAsk> asks;           // in the order of the statement
  std::vector<SolvedClaim> claims{};     // the same
  std::map<std::string, double> checks;  // relative residuals on the road of particles, by name
  std::vector<std::string> assumptions;  // of the formulas: "m > 0"
  std::vector<std::string> notes;        // stability of steady motions, what happened on the way of a motion
};

struct SolvedStatement {
  std::vector<Solution> solutions;  // one for each root, ascending by the first unknown; none: warnings say why
  std::vector<Letter> open_letters;
  std::vector<std::string> warnings;
};

// sets: names of letters and data with the texts of their values; a later one for a name counts.
// Throws StatementError: unknown names, wrong dimensions, contradictions, unphysical bodies.
SolvedStatement solve_statement(const Statement& statement,
                                const std::vector<std::pair<std::string, std::string>>& sets);

// The settings that the texts stand for. Throws StatementError.
Settings read_settings(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets);

}  // namespace poinsot::statement
