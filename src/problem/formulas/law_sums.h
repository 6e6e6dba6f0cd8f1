// Laws that are sums: a number, or its square, as a sum of products of powers of letters, or the root of a quadratic
// equation whose coefficients are such: v^2/(2*g) + h, sqrt(v^2 + 2*g*h), m*g/k + sqrt((m*g/k)^2 + m*v^2/k).
//
// Of all products of small powers that have the right dimension those few are sought that the number is a combination
// of, at points close together. A combination of three numbers that meets sixteen points to eight digits is no
// accident.
#pragma once

#include <optional>
#include <vector>

#include "problem/formulas/law_shape.h"
#include "problem/formulas/scaling_trials.h"

namespace poinsot::problem {

struct SumSamples {
  std::vector<LetterValues> letters;
  std::vector<double> numbers;
};

struct SumLaw {
  Formula formula;
  int digits = 0;  // correct digits of its numbers
};

// letters: all that it may depend on, of which none may have either sign. units: those that nothing in the problem
// fixes. error: the relative error of the numbers. Nothing if there is no such law.
std::optional<SumLaw> sum_law(const std::vector<Letter>& letters, const Dimension& dimension,
                              const std::vector<Units>& units, const SumSamples& samples, double tolerance,
                              double error);

}  // namespace poinsot::problem
