// Other values in place of generators, also inside of roots, signs, inverse functions and powers of e.
#include <algorithm>
#include <map>

#include "engine/math/formula/formula_fraction.h"
#include "poinsot/engine/math/formula/formula_exponential.h"

namespace poinsot::symbolic {
namespace {

// A root, sign, inverse function or power of e with other values inside; null if nothing inside changes.
std::unique_ptr<Replacement> rebuilt(const Generator& g, const Replacements& replacements) {
  if (!has_arguments(g)) return nullptr;
  const Formula argument = replaced(g.argument, replacements);
  const Formula second = replaced(g.second, replacements);
  if (argument.fraction() == g.argument.fraction() && second.fraction() == g.second.fraction()) return nullptr;
  const Formula value = with_arguments(g, argument, second);
  return std::make_unique<Replacement>(Replacement{numerator_of(value), denominator_of(value)});
}

// x^0 to x^degree.
std::vector<Formula> powers_of(const Formula& x, int degree) {
  std::vector<Formula> powers{Formula(1)};
  for (int k = 0; k < degree; ++k) powers.push_back(powers.back() * x);
  return powers;
}

}  // namespace

Formula with_arguments(const Generator& g, const Formula& argument, const Formula& second) {
  if (g.kind == Kind::root) return sqrt(argument);
  if (g.kind == Kind::sign) return argument.is_zero() ? Formula() : abs(argument) / argument;
  if (g.kind == Kind::exponential) return exp(ratio_formula(g.multiple) * argument);
  if (g.name == "ln") return ln(argument);
  if (g.name == "atan2") return atan2(argument, second);
  return g.name == "asin" ? asin(argument) : g.name == "acos" ? acos(argument) : atan(argument);
}

Formula replaced(const Formula& x, const Replacements& replacements) {
  if (!x.fraction()) return x;
  const Fraction& f = *x.fraction();
  const std::size_t n = f.generators->size();

  // The powers that numerator and denominator are made of, both multiplied by the same powers of the denominators of
  // what comes in: a tangent without value then does no harm.
  std::vector<std::size_t> changed;
  std::vector<std::vector<Formula>> parts;  // for each that is changed: what its k-th power becomes
  for (std::size_t i = 0; i < n; ++i) {
    const GeneratorPointer& g = (*f.generators)[i];
    auto by = replacements(g);
    if (!by) by = rebuilt(*g, replacements);
    if (!by) continue;
    const int degree = std::max(f.numerator.degree(i), f.denominator.degree(i));
    const std::vector<Formula> above = powers_of(by->numerator, degree);
    const std::vector<Formula> below = powers_of(by->denominator, degree);
    std::vector<Formula> part;
    for (int k = 0; k <= degree; ++k) {
      part.push_back(above[static_cast<std::size_t>(k)] * below[static_cast<std::size_t>(degree - k)]);
    }
    changed.push_back(i);
    parts.push_back(std::move(part));
  }
  if (changed.empty()) return x;

  const auto with_new = [&](const Polynomial& polynomial) {
    std::map<std::vector<int>, Polynomial> by_powers;
    for (std::size_t i = 0; i < polynomial.length(); ++i) {
      std::vector<int> powers = polynomial.exponents(i);
      std::vector<int> of_changed;
      of_changed.reserve(changed.size());
      for (const std::size_t v : changed) of_changed.push_back(std::exchange(powers[v], 0));
      by_powers.try_emplace(std::move(of_changed), n).first->second.push(polynomial.coefficient(i), powers);
    }
    Formula sum;
    for (auto& [powers, coefficient] : by_powers) {
      coefficient.tidy();
      Formula term = polynomial_formula(*f.generators, std::move(coefficient), f.assumptions);
      for (std::size_t k = 0; k < powers.size(); ++k) term *= parts[k][static_cast<std::size_t>(powers[k])];
      sum += term;
    }
    return sum;
  };
  return with_new(f.numerator) / with_new(f.denominator);
}

}  // namespace poinsot::symbolic
