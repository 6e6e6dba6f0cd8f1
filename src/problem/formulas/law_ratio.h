// Laws that are quotients of polynomials in one number without dimension, or roots of such: the inertias of two bodies
// in a ratio of masses, (1 + x)/(1 + 2*x/3).
//
// The coefficients follow from values at more points than there are coefficients, the fewest that meet them all. That a
// smooth function which is none comes so close is possible, so what is found must have coefficients that are fractions,
// or be told by two coefficients, and is held far off like every law.
//
// Laws that are powers of a number without dimension times a logarithm, an inverse tangent, a power of e or what is
// made of these: how high a stone rises against drag by the square of its speed, m/(2 k) ln(1 + k v^2/(m g)), and how
// fast it is after falling for a time, sqrt(m g/k) tanh(t sqrt(k g/m)).
//
// Each curve has two coefficients, one of what stands in the function and one before it. They follow from the first and
// the last of the numbers; what is found must have simple coefficients and meet the other twelve to ten digits, which
// no other smooth function does by chance, and is held far off like every law.
#pragma once

#include <optional>
#include <vector>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot::problem {

// x at some points, all positive, and the number there, which has one sign.
struct RatioSamples {
  std::vector<double> x, numbers;
};

// The number as a formula in x, with so many correct digits.
struct RatioLaw {
  Formula formula;
  int digits = 0;
};

// tolerance: how far, relatively, the numbers may be off. Nothing if there is no such law.
std::optional<RatioLaw> ratio_law(const Formula& x, const RatioSamples& samples, double tolerance);

// The number as such a curve in x or its root; tolerance as of ratio_law. Nothing if there is none.
std::optional<RatioLaw> curve_law(const Formula& x, const RatioSamples& samples, double tolerance);

}  // namespace poinsot::problem
