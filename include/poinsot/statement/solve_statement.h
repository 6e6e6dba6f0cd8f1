// All questions of a statement, answered.
//
// An answer is determined when no choice of what the statement leaves open changes it: letters without value, values
// given as `any`, gravity of which nothing is said, velocities and forces that no equation fixes. Each of these is
// varied by itself and the answers are compared, so that what an answer depends on can be named.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

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
};

struct SolvedUnknown {
  std::string name;
  Unit unit;
  Value<double> value;  // SI
};

struct Solution {
  std::vector<SolvedUnknown> unknowns;
  std::vector<SolvedAsk> asks;           // in the order of the statement
  std::map<std::string, double> checks;  // relative residuals on the road of particles, by name
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
