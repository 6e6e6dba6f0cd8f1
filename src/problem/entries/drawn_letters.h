// Values of letters at which a statement is tried: random, but the same wherever it is solved.
#pragma once

#include <map>
#include <random>
#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::problem {

using Point = std::map<std::string, double>;  // in SI units

inline constexpr int simple_points = 60;  // the first points, which have small whole numbers

// The point of an attempt. It is the same everywhere for the same letters.
Point draw_point(const std::vector<Letter>& letters, int attempt);

// A value of about the size of the letter's unit; of an angle, between 0.2 and 1.2 rad. With a larger spread it lies
// farther from that size, for a statement that makes no sense near it, but never beyond four decades.
double drawn_letter(const Letter& letter, std::mt19937_64& random, int spread = 0);

// A value near one at which a statement has an answer.
double drawn_near(double value, std::mt19937_64& random);

}  // namespace poinsot::problem
