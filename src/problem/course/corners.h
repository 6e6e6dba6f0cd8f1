// Where numbers along a motion may have corners: their functions with a corner tell, abs, min and max, and those that
// turn sharply where a square is least, as norm does.
#pragma once

#include <vector>

#include "problem/entries/statement.h"
#include "problem/language/expression.h"

namespace poinsot::problem {

// A number that is smooth along the motion. The corner is in one of its zeros, or in one of the extremes of its square
// if it `turns`.
struct CornerOf {
  Expression number;
  bool turns = false;
};

// Of the functions in an expression, and in the names under define: and given: that it uses. Those that turn come
// first, and of each kind those within others.
std::vector<CornerOf> corners_of(const Situation& situation, const Expression& expression);

// Whether a number is one of places alone, which come to rest where bodies do: no rates, nothing divided by a place.
bool is_of_places(const Situation& situation, const Expression& expression);

}  // namespace poinsot::problem
