// Bounds on how far names stand for other names.
#pragma once

#include "problem/entries/statement.h"

namespace poinsot::problem {

struct DefinitionLimits {
  static constexpr int depth = 200;       // names behind names
  static constexpr double size = 20'000;  // operations behind one name under define:
};

// Throws StatementError if a name of the problem leads through more names, or a definition stands for a longer
// expression, than the limits allow: d0: d1 + d1, d1: d2 + d2, ... doubles with each line. Names that lead back to
// themselves are left to the evaluation, which says so.
void check_definition_limits(const Situation& situation);

}  // namespace poinsot::problem
