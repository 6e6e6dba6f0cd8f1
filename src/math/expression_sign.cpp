#include "poinsot/math/expression_sign.h"

#include "math/expression_fraction.h"

namespace poinsot {
namespace {

using namespace symbolic;

constexpr int most_squarings = 4;

SeenSign times(const SeenSign& a, const SeenSign& b) { return {a.sign * b.sign, a.strict && b.strict}; }

SeenSign sign_of_terms(const Generators& generators, const Polynomial& p) {
  SeenSign seen;
  for (std::size_t i = 0; i < p.length(); ++i) {
    const std::vector<int> powers = p.exponents(i);
    bool nonzero = true;
    for (std::size_t v = 0; v < generators.size(); ++v) {
      if (powers[v] == 0 || generators[v]->positive) continue;
      if (powers[v] % 2 != 0) return {};
      nonzero = false;
    }
    const int own = fmpz_sgn(p.coefficient(i).get());
    if (seen.sign != 0 && own != seen.sign) return {};
    seen.sign = own;
    seen.strict = seen.strict || nonzero;
  }
  return seen;
}

SeenSign sign_of_sum(const Expression& x, int squarings);

// a + b r with a root r of the radicand: of one sign where a and b are, else that of the larger square.
SeenSign sign_with_root(const Generators& generators, const Polynomial& p, std::size_t root, int squarings) {
  const std::vector<Polynomial> parts = p.coefficients_by(root);
  if (parts.size() != 2 || parts[0].is_zero()) return {};
  const Expression a = polynomial_expression(generators, parts[0]), b = polynomial_expression(generators, parts[1]);
  const SeenSign of_a = sign_of_sum(a, squarings), of_b = sign_of_sum(b, squarings);
  if (of_a.sign == 0 || of_b.sign == 0) return {};
  if (of_a.sign == of_b.sign) return {of_a.sign, of_a.strict};
  if (squarings == 0) return {};
  const SeenSign order = sign_of_sum(a * a - b * b * generators[root]->argument, squarings - 1);
  return {order.sign * of_a.sign, order.strict};
}

SeenSign sign_of_factor(const Generators& generators, const Polynomial& p, int squarings) {
  if (const SeenSign seen = sign_of_terms(generators, p); seen.sign != 0) return seen;
  const std::vector<bool> used = p.used();
  for (std::size_t v = 0; v < generators.size(); ++v)
    if (used[v] && generators[v]->kind == Kind::root && p.degree(v) == 1)
      if (const SeenSign seen = sign_with_root(generators, p, v, squarings); seen.sign != 0) return seen;
  return {sign_of(generators, p), false};
}

SeenSign sign_of_sum(const Expression& x, int squarings) {
  if (x.is_zero()) return {};
  const Generators& generators = *x.fraction()->generators;
  SeenSign seen{1, true};
  for (const Polynomial* p : {&x.fraction()->numerator, &x.fraction()->denominator}) {
    if (p->is_constant()) {
      seen.sign *= p->leading_sign();
      continue;
    }
    const Factors factors = factored(*p);
    seen.sign *= fmpz_sgn(factors.constant.get());
    for (const auto& [base, exponent] : factors.powers) {
      const SeenSign own = sign_of_factor(generators, base, squarings);
      if (exponent % 2 == 0)
        seen.strict = seen.strict && own.sign != 0 && own.strict;
      else
        seen = times(seen, own);
      if (seen.sign == 0) return {};
    }
  }
  return seen;
}

}  // namespace

SeenSign seen_sign(const Expression& x) { return sign_of_sum(x, most_squarings); }

}  // namespace poinsot
