// Functions of the tangent of a small part of an angle that are functions of that of a larger part.
//
// With t = tan(h) and u = tan(n h), the powers 1, t, ..., t^(n-1) are independent over the functions of u. So a
// quotient is a function of u if its numerator and denominator, reduced to such powers, are multiples of each other.
#include <algorithm>

#include "engine/math/formula/formula_fraction.h"

namespace poinsot::symbolic {
namespace {

// Coefficients of 1, t, ..., t^(n-1).
using Remainder = std::vector<Formula>;

Remainder times_t(const Remainder& r, const Remainder& highest) {
  Remainder result(r.size());
  for (std::size_t k = 0; k < r.size(); ++k) {
    result[k] = r.back() * highest[k];
    if (k > 0) result[k] += r[k - 1];
  }
  return result;
}

// t^n over u: u (1 - ...) = n t - ..., solved for its highest power.
Remainder highest_power(std::size_t n, const Formula& u) {
  const MultipleTangent tangent = multiple_tangent(static_cast<std::int64_t>(n));
  Remainder equation(n + 1);  // zero is sum of equation[k] t^k
  for (std::size_t k = 0; k <= n; ++k) {
    equation[k] = integer_formula(tangent.numerator[k]) - u * integer_formula(tangent.denominator[k]);
  }
  Remainder result(n);
  for (std::size_t k = 0; k < n; ++k) result[k] = -equation[k] / equation[n];
  return result;
}

Remainder remainder(const Fraction& f, const Polynomial& polynomial, std::size_t variable, const Remainder& highest) {
  const std::size_t n = highest.size();
  Remainder power(n);
  power[0] = 1;
  Remainder sum(n);
  for (const Polynomial& part : polynomial.coefficients_by(variable)) {
    const Formula c = polynomial_formula(*f.generators, part, f.assumptions);
    for (std::size_t k = 0; k < n; ++k) sum[k] += c * power[k];
    power = times_t(power, highest);
  }
  return sum;
}

// x with tan of n times the angle in place of generator number v, if x is a function of it.
std::optional<Formula> coarser(const Formula& x, std::size_t v, int n) {
  const Fraction& f = *x.fraction();
  const GeneratorPointer& g = (*f.generators)[v];
  const int degree = std::max(f.numerator.degree(v), f.denominator.degree(v));
  if (degree == 0 || degree % n != 0) return std::nullopt;
  const bool inside = std::any_of(f.generators->begin(), f.generators->end(), [&g](const GeneratorPointer& h) {
    return is_algebraic(*h) && h->key.find(g->key) != std::string::npos;
  });
  if (inside) return std::nullopt;

  const std::int64_t shared = g->multiple.denominator % n == 0 ? n : 1;
  const Formula u = generator_formula(
      tangent_generator(g->kind, g->argument, {g->multiple.numerator * n / shared, g->multiple.denominator / shared}));
  const Remainder highest = highest_power(static_cast<std::size_t>(n), u);
  const Remainder above = remainder(f, f.numerator, v, highest);
  const Remainder below = remainder(f, f.denominator, v, highest);
  std::size_t pivot = 0;
  while (below[pivot].is_zero()) ++pivot;
  for (std::size_t k = 0; k < below.size(); ++k) {
    if (!(above[k] * below[pivot] == above[pivot] * below[k])) return std::nullopt;
  }
  return above[pivot] / below[pivot];
}

}  // namespace

Formula with_coarsest_angles(const Formula& x) {
  Formula result = x;
  bool found = true;
  while (found && result.fraction()) {
    found = false;
    for (std::size_t v = 0; v < result.fraction()->generators->size() && !found; ++v) {
      if ((*result.fraction()->generators)[v]->kind != Kind::tangent) continue;
      for (const int n : {2, 3, 5, 7}) {
        if (auto next = coarser(result, v, n)) {
          result = std::move(*next);
          found = true;
          break;
        }
      }
    }
  }
  return result;
}

}  // namespace poinsot::symbolic
