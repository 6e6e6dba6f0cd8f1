// Values of letters at which a statement is tried: random, but the same wherever it is solved.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/language/value.h"

namespace poinsot::problem {

using Point = std::map<std::string, double>;  // in SI units

inline constexpr int simple_points = 60;  // the first points, which have small whole numbers

// The sizes of length, mass and time that letters are drawn at, in SI units.
struct DrawnSizes {
  double length = 1, mass = 1, time = 1;

  double of(const Dimension& dimension) const;
};
// Those beside which the data of a statement are about one: under a gravity of 1e-11 m/s^2 spins of 1 rad/s are
// nothing that its tops do. SI units, unless a datum is more than four decades from them, as whoever reads a
// counterexample expects numbers of the size of units.
DrawnSizes drawn_sizes(const std::vector<std::pair<double, Dimension>>& data);

// The point of an attempt. It is the same everywhere for the same letters.
Point draw_point(const std::vector<Letter>& letters, int attempt, const DrawnSizes& sizes = {});

// The seed of the first draw at which a statement with letters is tried; later draws follow by one.
constexpr std::uint64_t seed_of_draws = 1000;

// A value of about the size of the letter's unit; of an angle, between 0.2 and 1.2 rad. With a larger spread it lies
// farther from that size, for a statement that makes no sense near it, but never beyond four decades.
double drawn_letter(const Letter& letter, std::mt19937_64& random, int spread = 0);

// What an unknown is with a number in its place, or of a vector with these components. A planar problem has none across
// its plane. SI units.
Value<double> value_of_unknown(const Unknown& unknown, const Vector3<double>& components,
                               const std::optional<MotionPlane>& plane);

// A value near one at which a statement has an answer.
double drawn_near(double value, std::mt19937_64& random);

}  // namespace poinsot::problem
