#include "poinsot/engine/math/formula/formula_sign.h"

#include <algorithm>
#include <memory>

#include "engine/math/formula/formula_fraction.h"

namespace poinsot {
namespace {

using namespace symbolic;

// Each squaring takes away a root and may square the number of terms; with more roots than these nothing is decided.
constexpr int most_squarings = 4;
constexpr int most_factored = 250;            // terms, in all
constexpr int most_splits = 3;                // by coefficients, one within the other
constexpr std::size_t most_split_terms = 60;  // of a polynomial that is split

SeenSign times(const SeenSign& a, const SeenSign& b) { return {a.sign * b.sign, a.strict && b.strict}; }

// How often a formula may still be squared and split.
struct Effort {
  int squarings = most_squarings;
  int splits = most_splits;
  int* terms = nullptr;  // that may still be factored, in all
  Effort after_squaring() const { return {squarings - 1, splits, terms}; }
  Effort after_split() const { return {squarings, splits - 1, terms}; }
};

SeenSign sign_of_sum(const Formula& x, const Effort& effort);

// A root is not negative; it vanishes with what stands under it.
bool may_vanish(const Generator& generator, const Effort& effort) {
  if (generator.kind != Kind::root) return !generator.positive;
  const SeenSign under = sign_of_sum(generator.argument, {0, 0, effort.terms});
  return under.sign <= 0 || !under.strict;
}

SeenSign sign_of_terms(const Generators& generators, const Polynomial& p, const Effort& effort) {
  SeenSign seen;
  for (std::size_t i = 0; i < p.length(); ++i) {
    const std::vector<int> powers = p.exponents(i);
    bool nonzero = true;
    for (std::size_t v = 0; v < generators.size(); ++v) {
      if (powers[v] == 0) continue;
      if (!generators[v]->positive && powers[v] % 2 != 0) return {};
      nonzero = nonzero && !seen.strict && !may_vanish(*generators[v], effort);
    }
    const int own = fmpz_sgn(p.coefficient(i).get());
    if (seen.sign != 0 && own != seen.sign) return {};
    seen.sign = own;
    seen.strict = seen.strict || nonzero;
  }
  return seen;
}

// a + b r with a root r of the radicand: of one sign where a and b are, else that of the larger square.
SeenSign sign_with_root(const Generators& generators, const Polynomial& p, std::size_t root, const Effort& effort) {
  if (p.length() > most_split_terms) return {};
  const std::vector<Polynomial> parts = p.coefficients_by(root);
  if (parts.size() != 2 || parts[0].is_zero()) return {};
  const Formula a = polynomial_formula(generators, parts[0]), b = polynomial_formula(generators, parts[1]);
  const SeenSign of_a = sign_of_sum(a, effort), of_b = sign_of_sum(b, effort);
  if (of_a.sign == 0 || of_b.sign == 0) return {};
  if (of_a.sign == of_b.sign) return {of_a.sign, of_a.strict};
  if (effort.squarings == 0) return {};
  const SeenSign order = sign_of_sum(a * a - b * b * generators[root]->argument, effort.after_squaring());
  return {order.sign * of_a.sign, order.strict};
}

// The sum of c_k x^k with x > 0, or with even powers alone: of one sign where all c_k have it.
SeenSign sign_by_coefficients(const Generators& generators, const std::vector<Polynomial>& c, bool positive,
                              const Effort& effort) {
  SeenSign seen;
  for (std::size_t k = 0; k < c.size(); ++k) {
    if (c[k].is_zero()) continue;
    if (!positive && k % 2 == 1) return {};
    const SeenSign own = sign_of_sum(polynomial_formula(generators, c[k]), effort);
    if (own.sign == 0 || (seen.sign != 0 && own.sign != seen.sign)) return {};
    seen.sign = own.sign;
    seen.strict = seen.strict || (own.strict && (positive || k == 0));
  }
  return seen;
}

// a x^2 + b x + c: the sign of a where 4 a c - b^2 is nowhere negative; by continuity also where a vanishes.
SeenSign sign_of_square(const Generators& generators, const std::vector<Polynomial>& c, const Effort& effort) {
  const Formula a = polynomial_formula(generators, c[2]);
  const SeenSign leading = sign_of_sum(a, effort);
  if (leading.sign == 0) return {};
  const Formula b = polynomial_formula(generators, c[1]);
  const Formula rest = 4 * a * polynomial_formula(generators, c[0]) - b * b;
  if (rest.is_zero()) return {leading.sign, false};
  const SeenSign definite = sign_of_sum(rest, effort);
  if (definite.sign <= 0) return {};
  return {leading.sign, leading.strict && definite.strict};
}

SeenSign sign_of_factor(const Generators& generators, const Polynomial& p, const Effort& effort) {
  if (const SeenSign seen = sign_of_terms(generators, p, effort); seen.sign != 0) return seen;
  const std::vector<bool> used = p.used();
  for (std::size_t v = 0; v < generators.size(); ++v)
    if (used[v] && generators[v]->kind == Kind::root && p.degree(v) == 1)
      if (const SeenSign seen = sign_with_root(generators, p, v, effort); seen.sign != 0) return seen;
  if (effort.splits > 0 && p.length() <= most_split_terms)
    for (std::size_t v = 0; v < generators.size(); ++v) {
      if (!used[v] || is_algebraic(*generators[v])) continue;
      const std::vector<Polynomial> c = p.coefficients_by(v);
      SeenSign seen;
      if (c.size() == 3) seen = sign_of_square(generators, c, effort.after_split());
      // The same in x^2, as 3 cos(b)^2 + 1 is in the tangent of b/2.
      if (c.size() == 5 && c[1].is_zero() && c[3].is_zero())
        seen = sign_of_square(generators, {c[0], c[2], c[4]}, effort.after_split());
      if (seen.sign == 0) seen = sign_by_coefficients(generators, c, generators[v]->positive, effort.after_split());
      if (seen.sign != 0) return seen;
    }
  // A number.
  for (std::size_t v = 0; v < generators.size(); ++v)
    if (used[v] && !generators[v]->constant) return {};
  const int sign = sign_of(generators, p);
  return {sign, sign != 0};
}

SeenSign sign_of_sum(const Formula& x, const Effort& effort) {
  if (x.is_zero()) return {};
  const Generators& generators = *x.fraction()->generators;
  *effort.terms -= static_cast<int>(x.terms());
  if (*effort.terms < 0) return {};
  SeenSign seen{1, true};
  for (const Polynomial* p : {&x.fraction()->numerator, &x.fraction()->denominator}) {
    if (p->is_constant()) {
      seen.sign *= p->leading_sign();
      continue;
    }
    const Factors factors = factored(*p);
    seen.sign *= fmpz_sgn(factors.constant.get());
    for (const auto& [base, exponent] : factors.powers) {
      const SeenSign own = sign_of_factor(generators, base, effort);
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

// x with 1 + s, s positive, in place of each power of e with a positive exponent.
static Formula with_growth(const Formula& x) {
  if (!x.fraction() || std::ranges::none_of(*x.fraction()->generators,
                                            [](const GeneratorPointer& g) { return g->kind == Kind::exponential; }))
    return x;
  return replaced(x, [](const GeneratorPointer& g) -> std::unique_ptr<Replacement> {
    if (g->kind != Kind::exponential) return nullptr;
    const SeenSign exponent = seen_sign(g->argument);
    if (exponent.sign <= 0 || !exponent.strict) return nullptr;
    return std::make_unique<Replacement>(Replacement{1 + Formula::letter(g->key, Sign::positive), 1});
  });
}

SeenSign seen_sign(const Formula& of) {
  const Formula x = with_growth(of);
  int terms = most_factored + static_cast<int>(x.terms());
  return sign_of_sum(x, {most_squarings, most_splits, &terms});
}

std::vector<Formula> vanishing_factors(const Formula& x) {
  std::vector<Formula> found;
  if (x.is_zero() || x.fraction()->numerator.is_constant()) return found;
  const Generators& generators = *x.fraction()->generators;
  for (const auto& [base, exponent] : factored(x.fraction()->numerator).powers) {
    int terms = most_factored;
    const SeenSign seen = sign_of_factor(generators, base, {most_squarings, most_splits, &terms});
    if (seen.sign == 0 || !seen.strict) found.push_back(polynomial_formula(generators, base));
  }
  return found;
}

// The u of a factor |u|/u; nothing if the factor is none.
static const Formula* argument_of_sign(const Generators& generators, const Polynomial& factor) {
  if (factor.length() != 1) return nullptr;
  for (std::size_t v = 0; v < generators.size(); ++v)
    if (factor.degree(v) == 1) return generators[v]->kind == Kind::sign ? &generators[v]->argument : nullptr;
  return nullptr;
}

Formula sign_part(const Formula& x, bool keep_zeros) {
  if (x.is_zero()) return x;
  const Generators& generators = *x.fraction()->generators;
  Formula part(1), of_signs(1);
  for (const Polynomial* p : {&x.fraction()->numerator, &x.fraction()->denominator}) {
    if (p->is_constant()) {
      part *= Formula(p->leading_sign());
      continue;
    }
    const Factors factors = factored(*p);
    part *= Formula(fmpz_sgn(factors.constant.get()));
    for (const auto& [base, exponent] : factors.powers) {
      // |u|/u has the sign of u.
      if (const Formula* signed_by = argument_of_sign(generators, base)) {
        if (exponent % 2 == 1) of_signs *= *signed_by;
        continue;
      }
      int terms = most_factored;
      const SeenSign own = sign_of_factor(generators, base, {most_squarings, most_splits, &terms});
      const bool kept = own.sign == 0 || (keep_zeros && !own.strict);
      if (kept)
        part *= pow(polynomial_formula(generators, base), exponent % 2 == 0 ? (keep_zeros ? 2 : 0) : 1);
      else if (exponent % 2 == 1)
        part *= Formula(own.sign);
    }
  }
  return of_signs == Formula(1) ? part : sign_part(part * of_signs, keep_zeros);
}

Formula sign_part_in_sines(const Formula& x, bool keep_zeros) {
  Formula part = sign_part(x, keep_zeros);
  if (part.is_zero()) return part;
  const Generators generators = *part.fraction()->generators;
  const Polynomial above = part.fraction()->numerator, below = part.fraction()->denominator;
  for (std::size_t v = 0; v < generators.size(); ++v) {
    if (generators[v]->kind != Kind::tangent && generators[v]->kind != Kind::constant_tangent) continue;
    const Formula t = generator_formula(generators[v]);
    part /= pow(1 + t * t, (above.degree(v) + 1) / 2 - (below.degree(v) + 1) / 2);
  }
  return part;
}

}  // namespace poinsot
