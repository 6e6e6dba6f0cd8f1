// Points at which a claim is tried: values of letters, and of what the statement leaves open.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::problem {

using Point = std::map<std::string, double>;  // in SI

inline constexpr int simple_points = 60;  // the first ones, of small whole numbers

// The same for the same attempt everywhere.
Point draw_point(const std::vector<Letter>& letters, int attempt);

}  // namespace poinsot::problem
