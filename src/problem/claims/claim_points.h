// Points at which a claim is tried: values of the letters and of what the statement leaves open.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::problem {

using Point = std::map<std::string, double>;  // in SI units

inline constexpr int simple_points = 60;  // the first points, which have small whole numbers

// The point of an attempt. It is the same everywhere for the same letters.
Point draw_point(const std::vector<Letter>& letters, int attempt);

}  // namespace poinsot::problem
