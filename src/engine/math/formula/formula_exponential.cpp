#include "poinsot/engine/math/formula/formula_exponential.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "engine/math/formula/formula_fraction.h"

namespace poinsot {
namespace symbolic {
namespace {

// e^(n unit/d) is the n-th power of e^(unit/d), so that it is told from e^(unit/d) itself. Higher powers have a letter
// of their own: no solution of linear equations could bear their degree.
constexpr std::int64_t most_of_a_power = 24;

Formula power_of_e(const MultipleOfUnit& term) {
  const auto [unit, multiple] = term;
  const std::int64_t n = std::abs(multiple.numerator);
  const bool high = n > most_of_a_power;
  // A number has no generators.
  const auto& generators = *unit.fraction()->generators;
  if (!high && multiple.denominator == 1 && generators.size() == 1 && generators.front()->kind == Kind::inverse &&
      generators.front()->name == "ln" && unit == generator_formula(generators.front()))
    return pow(generators.front()->argument, static_cast<int>(multiple.numerator));
  const Formula base = generator_formula(exponential_generator(unit, {high ? n : 1, multiple.denominator}));
  const int power = high ? 1 : static_cast<int>(n);
  return pow(base, multiple.numerator < 0 ? -power : power);
}

// The exponent of what is one product of powers of e, times its sign in a quotient.
std::optional<Formula> exponent_in(const Generators& generators, const Polynomial& polynomial) {
  if (polynomial.length() != 1 || fmpz_is_one(polynomial.coefficient(0).get()) == 0) return std::nullopt;
  const std::vector<int> powers = polynomial.exponents(0);
  Formula exponent;
  for (std::size_t v = 0; v < generators.size(); ++v) {
    if (powers[v] == 0) continue;
    if (generators[v]->kind != Kind::exponential) return std::nullopt;
    exponent += Formula(powers[v]) * ratio_formula(generators[v]->multiple) * generators[v]->argument;
  }
  return exponent;
}

}  // namespace
}  // namespace symbolic

Formula exp(const Formula& x) {
  using namespace symbolic;
  Formula product(1);
  if (x.is_zero()) return product;
  for (const MultipleOfUnit& term : multiples_in(x)) product *= power_of_e(term);
  return assuming_alike(product, x);
}

Formula ln(const Formula& x) {
  using namespace symbolic;
  if (sign_of(x) < 0 || x.is_zero()) throw std::domain_error("the logarithm of what is not positive");
  if (x == Formula(1)) return {};
  if (const std::optional<Formula> exponent = exponent_of(x)) return *exponent;
  return assuming_alike(generator_formula(inverse_generator("ln", x, {})), x);
}

std::optional<Formula> exponent_of(const Formula& x) {
  using namespace symbolic;
  if (!x.fraction()) return std::nullopt;
  const Fraction& f = *x.fraction();
  const std::optional<Formula> above = exponent_in(*f.generators, f.numerator);
  const std::optional<Formula> below = exponent_in(*f.generators, f.denominator);
  if (!above || !below) return std::nullopt;
  return *above - *below;
}

std::vector<Formula> exponents_of(const Formula& x) {
  using namespace symbolic;
  std::vector<Formula> all;
  if (!x.fraction()) return all;
  const Fraction& f = *x.fraction();
  for (std::size_t v = 0; v < f.generators->size(); ++v) {
    const Generator& g = *(*f.generators)[v];
    // The largest power that occurs has the largest exponent.
    if (g.kind == Kind::exponential)
      all.push_back(Formula(std::max(f.numerator.degree(v), f.denominator.degree(v))) * ratio_formula(g.multiple) *
                    g.argument);
    for (const Formula& part : {g.argument, g.second})
      for (Formula& one : exponents_of(part)) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace poinsot
