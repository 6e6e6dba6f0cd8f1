// Square roots and absolute values: what is under a root is factored, and the root taken of each factor by itself.
//
// Roots of different irreducible factors are independent, so that sqrt(6) = sqrt(2) sqrt(3) and sqrt(12) = 2 sqrt(3)
// are told apart or equal by their polynomials. Factors whose sign is not known stay under one root.
#include <flint/fmpz.h>
#include <flint/fmpz_factor.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "engine/math/formula/formula_digits.h"
#include "engine/math/formula/formula_fraction.h"
#include "poinsot/engine/math/formula/formula_text.h"

namespace poinsot {
namespace symbolic {
namespace {

// x = constant * product of powers * rest, the rest a polynomial without factors that are free of roots.
struct Parts {
  Integer numerator;  // of the constant
  Integer denominator;
  struct Power {
    Polynomial base;
    int exponent;
  };
  std::vector<Power> powers;
  std::optional<Polynomial> rest;
};

// The common factor of a polynomial's coefficients as one in roots and signs.
Polynomial part_without_roots(const Generators& generators, const Polynomial& polynomial) {
  const std::size_t n = generators.size();
  std::map<std::vector<int>, Polynomial> coefficients;
  for (std::size_t i = 0; i < polynomial.length(); ++i) {
    std::vector<int> powers = polynomial.exponents(i);
    std::vector<int> of_roots(n, 0);
    for (std::size_t v = 0; v < n; ++v) {
      if (is_algebraic(*generators[v])) of_roots[v] = std::exchange(powers[v], 0);
    }
    coefficients.try_emplace(std::move(of_roots), n).first->second.push(polynomial.coefficient(i), powers);
  }
  Polynomial common(n);
  for (auto& [powers, coefficient] : coefficients) {
    coefficient.tidy();
    common = common.is_zero() ? coefficient : common_divisor(common, coefficient);
  }
  return coefficients.size() == 1 || common.leading_sign() > 0 ? common : -common;
}

Parts parts_of(const Formula& x) {
  const Fraction& f = *x.fraction();
  Parts parts;
  Polynomial above = f.numerator;
  bool rooted = false;
  const std::vector<bool> used = above.used();
  for (std::size_t v = 0; v < f.generators->size(); ++v)
    rooted = rooted || (used[v] && is_algebraic(*(*f.generators)[v]));
  if (rooted) {
    above = part_without_roots(*f.generators, f.numerator);
    Polynomial rest = divided_exactly(f.numerator, above);
    // A product of roots alone has the sign of the rest and its size: each is a factor by itself.
    parts.rest = std::move(rest);
  }
  Factors numerator = factored(above);
  Factors denominator = factored(f.denominator);
  parts.numerator = numerator.constant;
  parts.denominator = denominator.constant;
  for (auto& [base, exponent] : numerator.powers) parts.powers.push_back({std::move(base), exponent});
  for (auto& [base, exponent] : denominator.powers) parts.powers.push_back({std::move(base), -exponent});
  return parts;
}

// With the positive letters that a sign was seen from.
Formula noting_letters(Formula x, const Generators& generators, const Polynomial& polynomial) {
  const std::vector<bool> used = polynomial.used();
  for (std::size_t v = 0; v < generators.size(); ++v) {
    const Generator& g = *generators[v];
    if (used[v] && g.kind == Kind::letter && g.positive) x = assuming(x, {g.name, {}});
  }
  return x;
}

Formula sign_formula(const Formula& polynomial) { return generator_formula(sign_generator(polynomial)); }

// |p|
Formula size_of(const Generators& generators, const Polynomial& p) {
  const Formula x = polynomial_formula(generators, p);
  const int sign = sign_of(generators, p);
  if (sign == 0) return sign_formula(x) * x;
  return noting_letters(sign < 0 ? -x : x, generators, p);
}

Formula root_of_irreducible(const Formula& radicand, bool dependent = false) {
  return generator_formula(root_generator(radicand, dependent));
}

class IntegerFactors {
 public:
  IntegerFactors() { fmpz_factor_init(factors_); }
  IntegerFactors(const IntegerFactors&) = delete;
  IntegerFactors& operator=(const IntegerFactors&) = delete;
  ~IntegerFactors() { fmpz_factor_clear(factors_); }

  fmpz_factor_struct* get() { return factors_; }

 private:
  fmpz_factor_t factors_;
};

// The root of a positive integer.
Formula root_of_integer(const Integer& number) {
  Formula root(1);
  IntegerFactors held;
  fmpz_factor_struct* const factors = held.get();
  // Large numbers are only freed of small factors: beyond this size finding all may take long.
  constexpr int certain_bits = 128;
  if (fmpz_bits(number.get()) <= certain_bits) {
    fmpz_factor(factors, number.get());
  } else {
    fmpz_factor_trial_range(factors, number.get(), 0, 3000);
    Integer rest(number);
    for (slong i = 0; i < factors->num; ++i) {
      Integer power;
      fmpz_pow_ui(power.get(), factors->p + i, factors->exp[i]);
      fmpz_divexact(rest.get(), rest.get(), power.get());
    }
    if (!fmpz_is_one(rest.get())) {
      const bool square = fmpz_is_square(rest.get()) != 0;
      if (square) fmpz_sqrt(rest.get(), rest.get());
      _fmpz_factor_append(factors, rest.get(), square ? 2 : 1);
    }
  }
  for (slong i = 0; i < factors->num; ++i) {
    Integer prime;
    fmpz_set(prime.get(), factors->p + i);
    const Formula base = integer_formula(prime);
    root *= pow(base, static_cast<int>(factors->exp[i] / 2));
    if (factors->exp[i] % 2 != 0) root *= root_of_irreducible(base);
  }
  return root;
}

bool holds_roots_in_roots(const Formula& x) {
  if (!x.fraction()) return false;
  for (const GeneratorPointer& g : *x.fraction()->generators) {
    if (g->kind == Kind::root && g->doubtful) return true;
  }
  return false;
}

// The positive or negative root of x if it is a polynomial in the generators of x, and signs.
std::optional<Formula> root_without_signs(const Formula& x) {
  Formula root;
  try {
    root = sqrt(x);
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
  const Generators& own = *x.fraction()->generators;
  for (const GeneratorPointer& g : *root.fraction()->generators) {
    if (g->kind == Kind::root && std::none_of(own.begin(), own.end(), [&g](const auto& h) { return same(g, h); })) {
      return std::nullopt;
    }
  }
  return replaced(root, [](const GeneratorPointer& g) {
    return g->kind == Kind::sign ? std::make_unique<Replacement>(Replacement{1, 1}) : nullptr;
  });
}

// sqrt(A + B r) as sqrt(a) + sqrt(b) or their difference, with a + b = A, 4 a b = B^2 r^2, where no root in a root is
// left.
std::optional<Formula> without_nesting(const Formula& x) {
  const Fraction& f = *x.fraction();
  for (std::size_t v = f.generators->size(); v-- > 0;) {
    const GeneratorPointer& g = (*f.generators)[v];
    if (g->kind != Kind::root || f.numerator.degree(v) != 1 || g->doubtful) continue;
    const std::vector<Polynomial> by_root = f.numerator.coefficients_by(v);
    const Formula A = polynomial_formula(*f.generators, by_root[0]);
    const Formula B = polynomial_formula(*f.generators, by_root[1]);
    if (A.is_zero()) continue;
    const Formula norm = A * A - B * B * g->argument;
    if (norm.is_zero()) continue;
    const auto n = root_without_signs(norm);
    if (!n) continue;
    const Formula a = (A + *n) / 2;
    const Formula b = (A - *n) / 2;
    if (sign_of(a) <= 0 || sign_of(b) <= 0) continue;
    const Formula root_a = sqrt(a);
    const Formula root_b = sqrt(b);
    if (holds_roots_in_roots(root_a) || holds_roots_in_roots(root_b)) continue;
    if ((root_a + root_b) * (root_a + root_b) == x) return root_a + root_b;
    const int order = sign_of(*n);
    if (order != 0 && (root_a - root_b) * (root_a - root_b) == x) return order * (root_a - root_b);
  }
  return std::nullopt;
}

}  // namespace

int sign_of(const Generators& generators, const Polynomial& polynomial) {
  if (polynomial.is_zero()) return 0;
  const std::size_t n = generators.size();
  const std::vector<bool> used = polynomial.used();

  // All terms of one sign.
  int sign = 0;
  bool mixed = false;
  for (std::size_t i = 0; i < polynomial.length() && !mixed; ++i) {
    const std::vector<int> powers = polynomial.exponents(i);
    for (std::size_t v = 0; v < n; ++v) mixed = mixed || (powers[v] % 2 != 0 && !generators[v]->positive);
    const int own = fmpz_sgn(polynomial.coefficient(i).get());
    mixed = mixed || (sign != 0 && own != sign);
    sign = own;
  }
  if (!mixed) return sign;

  // A number.
  bool number = true;
  for (std::size_t v = 0; v < n; ++v) number = number && (!used[v] || generators[v]->constant);
  if (number) {
    const Ball value = ball_of(generators, polynomial, sample_point(0), 1200);
    return arb_is_positive(value.get()) ? 1 : arb_is_negative(value.get()) ? -1 : 0;
  }

  // a y^2 + b y + c with b^2 < 4 a c.
  for (std::size_t v = 0; v < n; ++v) {
    if (!used[v] || is_algebraic(*generators[v]) || polynomial.degree(v) != 2) continue;
    const std::vector<Polynomial> c = polynomial.coefficients_by(v);
    const int leading = sign_of(generators, c[2]);
    if (leading == 0) continue;
    const Polynomial discriminant = scaled(c[2] * c[0], Integer(4)) - c[1] * c[1];
    if (sign_of(generators, reduced(generators, discriminant)) > 0) return leading;
  }
  return 0;
}

int sign_of(const Formula& x) {
  if (!x.fraction()) return 0;
  const Fraction& f = *x.fraction();
  return sign_of(*f.generators, f.numerator) * sign_of(*f.generators, f.denominator);
}

}  // namespace symbolic

Formula sqrt(const Formula& x) {
  using namespace symbolic;
  if (x.is_zero()) return x;
  const Fraction& f = *x.fraction();
  const Parts parts = parts_of(x);
  const std::size_t n = f.generators->size();

  int sign = fmpz_sgn(parts.numerator.get());
  Integer size;
  fmpz_abs(size.get(), parts.numerator.get());
  Formula root = root_of_integer(size) / root_of_integer(parts.denominator);
  Polynomial open(n, Integer(1));  // what has no sign that is known
  int open_factors = 0;
  for (const auto& [base, exponent] : parts.powers) {
    const bool odd = exponent % 2 != 0;
    const int whole = (exponent - (odd ? 1 : 0)) / 2;
    if (whole % 2 != 0) {
      root *= pow(size_of(*f.generators, base), whole);
    } else {
      root *= pow(polynomial_formula(*f.generators, base), whole);
    }
    if (!odd) continue;
    const int own = sign_of(*f.generators, base);
    if (own == 0) {
      open = open * base;
      ++open_factors;
    } else {
      sign *= own;
      root *= root_of_irreducible(polynomial_formula(*f.generators, own < 0 ? -base : base));
    }
  }
  if (parts.rest) {
    const int own = sign_of(*f.generators, *parts.rest);
    const Formula rest = polynomial_formula(*f.generators, own < 0 ? -*parts.rest : *parts.rest);
    if (own != 0) {
      sign *= own;
      const auto simple = without_nesting(rest);
      root *= simple ? *simple : root_of_irreducible(rest);
    } else {
      open = open * *parts.rest;
      ++open_factors;
    }
  }
  if (f.assumptions) {
    for (const Assumption& assumption : *f.assumptions) root = assuming(root, assumption);
  }
  if (open.is_one()) {
    if (sign < 0) throw std::domain_error("the square root of " + text(x) + ", which is negative");
    return root;
  }
  const Formula radicand = polynomial_formula(*f.generators, sign < 0 ? -open : open);
  return assuming(root * root_of_irreducible(radicand, open_factors > 1), {key_of(radicand), radicand});
}

Formula abs(const Formula& x) {
  using namespace symbolic;
  if (x.is_zero()) return x;
  const Fraction& f = *x.fraction();
  const Parts parts = parts_of(x);
  Formula sign(fmpz_sgn(parts.numerator.get()));
  const auto turn = [&](const Polynomial& p) {
    const int own = sign_of(*f.generators, p);
    const Formula y = polynomial_formula(*f.generators, p);
    sign *= own == 0 ? sign_formula(y) : noting_letters(Formula(own), *f.generators, p);
  };
  for (const auto& [base, exponent] : parts.powers) {
    if (exponent % 2 != 0) turn(base);
  }
  if (parts.rest) turn(*parts.rest);
  return sign * x;
}

}  // namespace poinsot
