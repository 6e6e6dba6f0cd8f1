// What is asked of a motion in a file with several situations.
#pragma once

#include "problem/entries/statement.h"

namespace poinsot::problem {

struct Situated {
  std::size_t situation = 0;
  Expression expression;  // without the `@ situation` behind its quantities
};

// The situation in which an expression is meant, which stands behind its quantities: `theta @ large == 0`. With only
// one situation it is that, and what stands behind an @ stays. Throws StatementError if none is named, if several are,
// or if a quantity stands without one.
Situated situated(const Statement& statement, const Expression& expression);

}  // namespace poinsot::problem
