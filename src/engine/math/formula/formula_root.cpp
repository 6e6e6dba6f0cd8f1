// Square roots and absolute values: what is under a root is factored, and the root taken of each factor by itself.
//
// Roots of different irreducible factors are independent, so that sqrt(6) = sqrt(2) sqrt(3) and sqrt(12) = 2 sqrt(3)
// are told apart or equal by their polynomials. Factors whose sign is not known stay under one root.
#include <flint/fmpz.h>
#include <flint/fmpz_factor.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/math/formula/formula_digits.h"
#include "engine/math/formula/formula_fraction.h"
#include "poinsot/engine/math/formula/formula_decision.h"
#include "poinsot/engine/math/formula/formula_sizes.h"
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

thread_local bool sizes_are_decided = false;

Formula sign_formula(const Formula& polynomial) {
  if (sizes_are_decided) {
    note_sign(polynomial);
    return positive_sign(polynomial);
  }
  return generator_formula(sign_generator(polynomial));
}

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

// The powers that make up a positive integer: of primes, as far as these are found without a sieve. That of FLINT keeps
// its relations in a file in the folder in which the program is called, under a name that threads share: it fails where
// nothing may be written, and where two need it at once.
class IntegerPowers {
 public:
  explicit IntegerPowers(const Integer& number) {
    fmpz_factor_init(factors_);
    flint_randinit(state_);
    // What fits into a word is factored in it.
    if (fits_word(number)) {
      take_word(number, 1);
      return;
    }
    constexpr slong small_primes = 3000;
    fmpz_factor_trial_range(factors_, number.get(), 0, small_primes);
    Integer rest(number);
    for (slong i = 0; i < factors_->num; ++i) {
      Integer power;
      fmpz_pow_ui(power.get(), factors_->p + i, factors_->exp[i]);
      fmpz_divexact(rest.get(), rest.get(), power.get());
      add(copy_of(factors_->p + i), factors_->exp[i]);
    }
    split(rest, 1);
  }
  IntegerPowers(const IntegerPowers&) = delete;
  IntegerPowers& operator=(const IntegerPowers&) = delete;
  ~IntegerPowers() {
    fmpz_factor_clear(factors_);
    flint_randclear(state_);
  }

  const std::vector<std::pair<Integer, ulong>>& powers() const { return powers_; }

 private:
  static Integer copy_of(const fmpz* number) {
    Integer copy;
    fmpz_set(copy.get(), number);
    return copy;
  }
  static bool fits_word(const Integer& number) { return fmpz_bits(number.get()) <= FLINT_BITS - 2; }

  void add(const Integer& base, ulong exponent) {
    for (auto& [known, count] : powers_)
      if (fmpz_equal(known.get(), base.get()) != 0) {
        count += exponent;
        return;
      }
    powers_.emplace_back(base, exponent);
  }

  void take_word(const Integer& number, ulong exponent) {
    fmpz_factor_t own;
    fmpz_factor_init(own);
    fmpz_factor(own, number.get());
    for (slong i = 0; i < own->num; ++i) add(copy_of(own->p + i), exponent * own->exp[i]);
    fmpz_factor_clear(own);
  }

  // Splits by squares and by Pollard's method with Brent's cycles, which finds factors of some nine digits. What is
  // left counts as one.
  void split(const Integer& number, ulong exponent) {
    if (fmpz_is_one(number.get())) return;
    if (fits_word(number)) return take_word(number, exponent);
    if (fmpz_is_square(number.get()) != 0) {
      Integer root;
      fmpz_sqrt(root.get(), number.get());
      return split(root, 2 * exponent);
    }
    constexpr ulong tries = 3, steps = 1UL << 15;
    Integer factor, whole(number);
    if (fmpz_is_probabprime(number.get()) == 0 &&
        fmpz_factor_pollard_brent(factor.get(), state_, whole.get(), tries, steps) != 0 &&
        fmpz_cmp(factor.get(), number.get()) < 0 && fmpz_cmp_si(factor.get(), 1) > 0 &&
        fmpz_divisible(number.get(), factor.get()) != 0) {
      Integer other;
      fmpz_divexact(other.get(), number.get(), factor.get());
      split(factor, exponent);
      split(other, exponent);
      return;
    }
    add(number, exponent);
  }

  fmpz_factor_t factors_;
  flint_rand_t state_;
  std::vector<std::pair<Integer, ulong>> powers_;
};

// The root of a positive integer.
Formula root_of_integer(const Integer& number) {
  Formula root(1);
  const IntegerPowers found(number);
  for (const auto& [prime, exponent] : found.powers()) {
    const Formula base = integer_formula(prime);
    root *= pow(base, static_cast<int>(exponent / 2));
    if (exponent % 2 != 0) root *= root_of_irreducible(base);
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

DecidedSizesScope::DecidedSizesScope(bool decided) : outer_(symbolic::sizes_are_decided) {
  symbolic::sizes_are_decided = outer_ || decided;
}
DecidedSizesScope::~DecidedSizesScope() { symbolic::sizes_are_decided = outer_; }

Formula with_known_signs(const Formula& x, const std::function<int(const Formula& argument)>& sign_of) {
  return symbolic::replaced(x, [&](const symbolic::GeneratorPointer& g) -> std::unique_ptr<symbolic::Replacement> {
    const int sign = g->kind == symbolic::Kind::sign ? sign_of(g->argument) : 0;
    if (sign == 0) return nullptr;
    return std::make_unique<symbolic::Replacement>(symbolic::Replacement{Formula(sign), Formula(1)});
  });
}

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
