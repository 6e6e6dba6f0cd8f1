// Derivatives, and other values in place of letters.
#include "engine/math/formula/formula_fraction.h"

namespace poinsot {
namespace symbolic {
namespace {

Formula derivative_of(const GeneratorPointer& generator, const std::string& letter) {
  const Generator& g = *generator;
  const Formula u = g.argument;
  const Formula x = generator_formula(generator);
  switch (g.kind) {
    case Kind::letter:
      return g.name == letter ? 1 : 0;
    case Kind::tangent:
      return ratio_formula(g.multiple) / 2 * (1 + x * x) * derivative(u, letter);
    case Kind::exponential:
      return ratio_formula(g.multiple) * x * derivative(u, letter);
    case Kind::root:
      return derivative(u, letter) / (2 * x);
    case Kind::inverse:
      break;
    case Kind::pi:
    case Kind::constant_tangent:
    case Kind::sign:
      return {};
  }
  Formula slope = derivative(u, letter);
  if (g.name == "ln") return slope / u;
  if (g.name == "atan") return slope / (1 + u * u);
  if (g.name == "atan2") {
    return (g.second * slope - u * derivative(g.second, letter)) / (g.second * g.second + u * u);
  }
  if (slope.is_zero()) return slope;
  const Formula inverse_slope = slope / sqrt(1 - u * u);
  return g.name == "asin" ? inverse_slope : -inverse_slope;
}

// The derivative of a polynomial by one of its generators.
Formula partial(const Fraction& f, const Polynomial& polynomial, std::size_t variable) {
  Polynomial result(f.generators->size());
  fmpz_mpoly_derivative(result.get(), polynomial.get(), static_cast<slong>(variable), polynomial.ring());
  return polynomial_formula(*f.generators, std::move(result), f.assumptions);
}

}  // namespace
}  // namespace symbolic

Formula derivative(const Formula& x, const std::string& letter) {
  using namespace symbolic;
  if (!x.fraction()) return x;
  const Fraction& f = *x.fraction();
  Formula sum;
  for (std::size_t v = 0; v < f.generators->size(); ++v) {
    const Formula inner = derivative_of((*f.generators)[v], letter);
    if (inner.is_zero()) continue;
    sum += (partial(f, f.numerator, v) - x * partial(f, f.denominator, v)) * inner;
  }
  return sum / denominator_of(x);
}

Formula substituted(const Formula& x, const std::map<std::string, Formula>& values) {
  using namespace symbolic;
  return replaced(x, [&values](const GeneratorPointer& g) -> std::unique_ptr<Replacement> {
    if (g->kind == Kind::letter) {
      const auto found = values.find(g->name);
      if (found == values.end()) return nullptr;
      return std::make_unique<Replacement>(Replacement{numerator_of(found->second), denominator_of(found->second)});
    }
    if (g->kind != Kind::tangent) return nullptr;
    const Formula argument = substituted(g->argument, values);
    if (argument.fraction() == g->argument.fraction()) return nullptr;
    const auto [sine, cosine] = sine_cosine(ratio_formula(g->multiple) * argument);
    const Formula below = 1 + cosine;
    if (below.is_zero()) return std::make_unique<Replacement>(Replacement{1, 0});
    const Formula tangent = sine / below;
    return std::make_unique<Replacement>(Replacement{numerator_of(tangent), denominator_of(tangent)});
  });
}

Formula numerator(const Formula& x) { return symbolic::numerator_of(x); }

}  // namespace poinsot
