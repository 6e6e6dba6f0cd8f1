// Limits on names that stand for expressions with further names.
#pragma once

#include "problem/entries/statement.h"

namespace poinsot::problem {

struct DefinitionLimits {
  static constexpr int depth = 200;       // names that stand behind each other
  static constexpr double size = 20'000;  // operations for one name under define:
};

// Throws StatementError if a name leads through more names, or a definition stands for a longer expression, than the
// limits allow. (d0: d1 + d1, d1: d2 + d2, ... doubles with each line.) Names that lead back to themselves are not
// reported here but by the evaluation.
void check_definition_limits(const Situation& situation);

}  // namespace poinsot::problem
