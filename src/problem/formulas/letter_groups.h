// Products of powers of letters that have no dimension, and where along such a group something changes.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

// A product of powers of letters without dimension, such as s/d or L*w^2/g.
class LetterGroup {
 public:
  explicit LetterGroup(std::vector<std::pair<Letter, int>> powers) : powers_(std::move(powers)) {}

  double at(const LetterValues& letters) const;
  // The letters with these values, but the first letter of the group such that the group has this value.
  LetterValues moved(LetterValues letters, double value) const;
  // What is positive where the group is below a bound, or above it: 4*g - L*w^2.
  Formula below(const Formula& bound) const;

 private:
  Formula part(bool above) const;

  std::vector<std::pair<Letter, int>> powers_;
};

// All groups of up to four of these letters with small whole exponents, those of fewer letters and smaller exponents
// first. Angles and letters of either sign have no part in them.
std::vector<LetterGroup> groups_of(const std::vector<Letter>& letters);

// The fraction with a small denominator that a number is up to so many digits; else the number with six digits.
Formula simple_number(double number, double tolerance);

// Where a law ends that another branch leaves flatly, as a power of the way beyond its bound, so that the misfit passes
// a tolerance far from the bound only: the place where a root of it vanishes that is straight beyond. passed: where the
// tolerance is passed; outwards: 1 or -1, the side of it on which the law fails. Nothing where this does not settle, or
// is far from where the tolerance is passed: a law that is left from nothing on only approximates.
constexpr double flat_edge_error = 1e-5;  // of the edge
std::optional<double> flat_edge(double passed, double outwards,
                                const std::function<std::optional<double>(double)>& misfit_at);

}  // namespace poinsot::problem
