// Finds out which of several situations an expression is about.
#pragma once

#include <string>

#include "problem/entries/statement.h"

namespace poinsot::problem {

struct Situated {
  std::size_t situation = 0;
  Expression expression;  // without the `@ situation` behind its quantities
};

// The situation that is named after the quantities of an expression: `theta @ large == 0`. If there is only one
// situation it is that one, and the expression is left as it is. Throws StatementError if no situation or several are
// named, or if a quantity stands without one.
Situated situated(const Statement& statement, const Expression& expression);

// Whether an ask names the situation after an @.
bool names_situation(const Ask& ask, const std::string& situation);

// The statement without situations that only claims are about: their letters are not data of the questions.
Statement for_questions(const Statement& statement);

}  // namespace poinsot::problem
