// Which answers are determined: everything that the statement leaves open is varied, each by itself, and the answers
// are compared, so that what an answer depends on can be named.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "problem/answers/ask_values.h"
#include "problem/answers/rounded_values.h"
#include "problem/answers/solve_statement.h"
#include "problem/unknowns/unknown_search.h"

namespace poinsot::problem {

// Answers as found, and from what.
struct AnswersFound {
  const Statement& statement;
  UnknownSearch& search;
  const AllSettings& settings;  // with the unknowns that were found
  Sample& sample;
  const AskValues& asked;
  const std::vector<double>& natural_sizes;  // of the asks, as in FinishedAsk
  RoundedValues& rounded;                    // at the settings
};

// Up to which difference two values of an ask are the same.
double same_answer_tolerance(const AnswersFound& found, std::size_t index, const Value<double>& a,
                             const Value<double>& b);
// Whether an ask has another value for another choice, or what decides it has; one that has none there depends on it.
bool differs(const AnswersFound& found, std::size_t index, const std::optional<WatchedValue>& other);

// Marks the answers that values given as `any`, gravity of which nothing is said, open velocities or forces change as
// undetermined, with the reason and the components that are fixed nevertheless. Returns the unknowns that they move.
std::set<std::string> mark_undetermined(const AnswersFound& found, Solution& result);

}  // namespace poinsot::problem
