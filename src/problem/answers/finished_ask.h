// An ask's value with what its reader needs besides: the unit in which it is shown, words, names of components.
#pragma once

#include "problem/answers/ask_values.h"
#include "problem/answers/rounded_values.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {

struct FinishedAsk {
  SolvedAsk solved;
  double natural_size = 0;  // asked_size() of its value, SI: what is far below it is noise
};

// asked: the values at `sample`, of which `rounded` tells what is rounding. index: of the ask in the statement. Throws
// StatementError: what asks nothing of the model, units that do not fit.
FinishedAsk finished_ask(const Statement& statement, std::size_t index, const AskValues& asked, Sample& sample,
                         RoundedValues& rounded);

}  // namespace poinsot::problem
