// What is asked of a motion at some times, as columns of a table: what a recording and a caller who follows a motion
// share.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/language/diagnostic.h"
#include "problem/machine/data.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// What is asked is well stated, but has no answer; what() says why.
class UnansweredRecord : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What columns are asked for, in the words of messages: "what is to be recorded".
struct MotionColumns {
  const Record& record;
  std::string words;
};

using SettingTexts = std::vector<std::pair<std::string, std::string>>;

// Values for all that the statement leaves open, with the unknowns that it finds. Throws StatementError, and
// UnansweredRecord if letters remain or there is not one solution.
Settings settled(const Statement& statement, const SettingTexts& sets, const MotionColumns& columns);

// Solves for the columns at some times as if they were asked for: with every check of answers. Throws as above, and
// UnansweredRecord if a column is not determined.
SolvedStatement solve_columns(const Statement& statement, const SettingTexts& sets, const MotionColumns& columns,
                              const std::vector<double>& times);

// The statement with its contacts with friction in the states in which the motion begins. Throws as solve_columns.
Statement in_states_at_start(const Statement& statement, const SettingTexts& sets, const MotionColumns& columns);

// The text of a time.
std::string in_seconds(double time);

// What the function returns. A question that the motion does not answer is not an error of the file.
template <class Function>
auto answered(Function&& function) {
  try {
    return function();
  } catch (const UnansweredError& error) {
    throw UnansweredRecord(error.what());
  }
}

}  // namespace poinsot::problem
