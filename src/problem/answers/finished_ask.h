// The value of an ask with what a reader needs: the unit in which it is shown, a description, the names of
// components.
#pragma once

#include <string>

#include "problem/answers/ask_values.h"
#include "problem/answers/rounded_values.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {

struct FinishedAsk {
  SolvedAsk solved;
  double natural_size = 0;  // asked_size() of the value, in SI units; far smaller values are noise
  std::string note{};       // what is to be said of it, or empty
};

// asked: the values of all asks at `sample`; `rounded` tells which numbers are rounding. index: of the ask in the
// statement. Throws StatementError if the ask is not about the model or its unit does not fit.
FinishedAsk finished_ask(const Statement& statement, std::size_t index, const AskValues& asked, Sample& sample,
                         RoundedValues& rounded);

}  // namespace poinsot::problem
