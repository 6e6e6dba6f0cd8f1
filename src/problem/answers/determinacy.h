// Finds out which answers are determined. Everything that the statement leaves open is varied, one thing at a time,
// and the answers are compared, so that what an answer depends on can be named.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "problem/answers/ask_values.h"
#include "problem/answers/rounded_values.h"
#include "problem/answers/solve_statement.h"
#include "problem/unknowns/unknown_search.h"

namespace poinsot::problem {

// The answers found, and what they were found from.
struct AnswersFound {
  const Statement& statement;
  UnknownSearch& search;
  const AllSettings& settings;  // with the unknowns that were found
  Sample& sample;
  const AskValues& asked;
  const std::vector<double>& natural_sizes;  // of the asks, as in FinishedAsk
  RoundedValues& rounded;                    // at these settings
};

// The difference up to which two values of an ask are the same.
double same_answer_tolerance(const AnswersFound& found, std::size_t index, const Value<double>& a,
                             const Value<double>& b);
// Whether the value of an ask is the same with another solution of the conditions, which leave unknowns open.
bool is_left_alone(const AnswersFound& found, std::size_t index, const std::vector<OpenUnknown>& open,
                   const Value<double>& value, const Value<double>& other);
// Whether another choice changes the value of an ask or the values that decide it. An ask without value there depends
// on the choice.
bool differs(const AnswersFound& found, std::size_t index, const std::optional<WatchedValue>& other);

// Marks answers as undetermined that depend on values given as `any`, on gravity of which nothing is said, or on open
// velocities or forces, with the reason and the components that are determined nevertheless. Returns the unknowns
// that depend on these.
std::set<std::string> mark_undetermined(const AnswersFound& found, Solution& result);

}  // namespace poinsot::problem
