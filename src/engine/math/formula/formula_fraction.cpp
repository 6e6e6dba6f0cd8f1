#include "engine/math/formula/formula_fraction.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>

namespace poinsot::symbolic {
namespace {

// Where each of the generators stands in a larger list.
std::vector<int> places_in(const Generators& all, const Generators& some) {
  std::vector<int> places;
  places.reserve(some.size());
  std::size_t k = 0;
  for (const GeneratorPointer& g : some) {
    while (!same(all[k], g)) ++k;
    places.push_back(static_cast<int>(k));
  }
  return places;
}

Generators merged(const Generators& a, const Generators& b) {
  Generators all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all), before);
  return all;
}

Ratio common_divisor(const Ratio& a, const Ratio& b) {
  const std::int64_t denominator = std::lcm(a.denominator, b.denominator);
  return {std::gcd(a.numerator * (denominator / a.denominator), b.numerator * (denominator / b.denominator)),
          denominator};
}

// The list without what does not occur; the polynomials moved with it.
void prune(GeneratorList& generators, Polynomial& numerator, Polynomial& denominator) {
  std::vector<bool> used = numerator.used();
  const std::vector<bool> below = denominator.used();
  const std::size_t n = generators->size();
  for (std::size_t i = 0; i < n; ++i) used[i] = used[i] || below[i];
  // What roots and signs are made of stays with them.
  for (bool found = true; found;) {
    found = false;
    for (std::size_t i = 0; i < n; ++i) {
      if (!used[i]) continue;
      for (const GeneratorPointer& need : (*generators)[i]->needs) {
        for (std::size_t k = 0; k < n; ++k) {
          if (used[k] || !same((*generators)[k], need)) continue;
          used[k] = true;
          found = true;
        }
      }
    }
  }
  if (std::all_of(used.begin(), used.begin() + static_cast<std::ptrdiff_t>(n), [](bool u) { return u; })) return;

  auto kept = std::make_shared<Generators>();
  std::vector<int> place(n, -1);
  for (std::size_t i = 0; i < n; ++i) {
    if (!used[i]) continue;
    place[i] = static_cast<int>(kept->size());
    kept->push_back((*generators)[i]);
  }
  numerator = numerator.moved(place, kept->size());
  denominator = denominator.moved(place, kept->size());
  generators = std::move(kept);
}

// Brings a fraction with a denominator free of roots into the form that is kept; `coprime`: without common factor.
Formula finished(GeneratorList generators, Polynomial numerator, Polynomial denominator, Assumptions assumptions,
                 bool coprime) {
  if (numerator.is_zero()) return {};
  check_limits(std::max(numerator.length(), denominator.length()));
  count_formula_work(20 * static_cast<double>(numerator.length() + denominator.length()));
  if (!coprime && !denominator.is_one()) {
    const Polynomial common = common_divisor(numerator, denominator);
    numerator = divided_exactly(numerator, common);
    denominator = divided_exactly(denominator, common);
  }
  if (denominator.leading_sign() < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  prune(generators, numerator, denominator);
  const bool doubtful = std::any_of(generators->begin(), generators->end(), [](const auto& g) { return g->doubtful; });
  if (doubtful && is_zero_by_digits(*generators, numerator)) return {};
  return Formula(std::make_shared<const Fraction>(
      Fraction{std::move(generators), std::move(numerator), std::move(denominator), std::move(assumptions)}));
}

// Two fractions over one list of generators.
struct Aligned {
  GeneratorList generators;
  Polynomial a_numerator;
  Polynomial a_denominator;
  Polynomial b_numerator;
  Polynomial b_denominator;
};

// Tangents of different parts of one angle in two lists, such as those of a/2 and a/3 that sin(a) and sin(2a/3) hold:
// both are functions of the tangent of their greatest common part.
std::optional<std::pair<GeneratorPointer, GeneratorPointer>> clash(const Generators& a, const Generators& b) {
  for (const GeneratorPointer& g : a) {
    if (g->kind != Kind::tangent) continue;
    for (const GeneratorPointer& h : b) {
      if (h->kind == Kind::tangent && !(g->multiple == h->multiple) && key_of(g->argument) == key_of(h->argument)) {
        return std::pair{g, h};
      }
    }
  }
  return std::nullopt;
}

// x with the tangent of a multiple of the finer angle expanded.
Formula with_finer_angle(const Formula& x, const GeneratorPointer& coarse, const GeneratorPointer& fine) {
  if (same(coarse, fine)) return x;
  const std::int64_t n = coarse->multiple.numerator * fine->multiple.denominator /
                         (fine->multiple.numerator * coarse->multiple.denominator);
  const MultipleTangent tangent = multiple_tangent(n);
  const auto polynomial = [&fine](const std::vector<Integer>& coefficients) {
    Polynomial p(1);
    for (std::size_t k = 0; k < coefficients.size(); ++k) p.push(coefficients[k], {static_cast<int>(k)});
    p.tidy();
    return polynomial_formula({fine}, std::move(p));
  };
  return replaced(x, [&](const GeneratorPointer& g) {
    return same(g, coarse) ? std::make_unique<Replacement>(
                                 Replacement{polynomial(tangent.numerator), polynomial(tangent.denominator)})
                           : nullptr;
  });
}

}  // namespace

Formula with_half_angle(const Formula& x, const GeneratorPointer& tangent) {
  Ratio half = tangent->multiple;
  (half.numerator % 2 == 0) ? half.numerator /= 2 : half.denominator *= 2;
  return with_finer_angle(x, tangent, tangent_generator(tangent->kind, tangent->argument, half));
}

namespace {

Aligned align(Formula a, Formula b) {
  while (a.fraction()->generators != b.fraction()->generators) {
    const auto pair = clash(*a.fraction()->generators, *b.fraction()->generators);
    if (!pair) break;
    const auto& [g, h] = *pair;
    Ratio part = common_divisor(g->multiple, h->multiple);
    const std::int64_t shared = std::gcd(part.numerator, part.denominator);
    part = {part.numerator / shared, part.denominator / shared};
    const GeneratorPointer fine = tangent_generator(Kind::tangent, g->argument, part);
    a = with_finer_angle(a, g, fine);
    b = with_finer_angle(b, h, fine);
  }
  const Fraction& f = *a.fraction();
  const Fraction& g = *b.fraction();
  if (f.generators == g.generators) {
    return {f.generators, f.numerator, f.denominator, g.numerator, g.denominator};
  }
  const bool equal = std::equal(f.generators->begin(), f.generators->end(), g.generators->begin(), g.generators->end(),
                                [](const auto& x, const auto& y) { return same(x, y); });
  if (equal) return {f.generators, f.numerator, f.denominator, g.numerator, g.denominator};
  const auto all = std::make_shared<Generators>(merged(*f.generators, *g.generators));
  const std::vector<int> a_places = places_in(*all, *f.generators);
  const std::vector<int> b_places = places_in(*all, *g.generators);
  const std::size_t n = all->size();
  return {all, f.numerator.moved(a_places, n), f.denominator.moved(a_places, n), g.numerator.moved(b_places, n),
          g.denominator.moved(b_places, n)};
}

bool holds_algebraic(const Generators& generators) {
  return std::any_of(generators.begin(), generators.end(), [](const auto& g) { return is_algebraic(*g); });
}

}  // namespace

static Formula sum(const Formula& a, const Formula& b, bool subtract) {
  auto [generators, na, da, nb, db] = align(a, b);
  if (subtract) nb = -nb;
  const Assumptions assumptions = united(a.fraction()->assumptions, b.fraction()->assumptions);
  if (da == db) {
    return finished(std::move(generators), na + nb, std::move(da), assumptions, false);
  }
  // Knuth 4.5.1: common factors can only come from what the denominators share.
  const Polynomial shared = common_divisor(da, db);
  const Polynomial own_a = divided_exactly(da, shared);
  const Polynomial own_b = divided_exactly(db, shared);
  Polynomial numerator = na * own_b + nb * own_a;
  if (numerator.is_zero()) return {};
  const Polynomial left = common_divisor(numerator, shared);
  return finished(std::move(generators), divided_exactly(numerator, left), own_a * divided_exactly(db, left),
                  assumptions, true);
}

static Formula product(const Formula& a, const Formula& b) {
  auto [generators, na, da, nb, db] = align(a, b);
  const Assumptions assumptions = united(a.fraction()->assumptions, b.fraction()->assumptions);
  const auto cancel = [](Polynomial& above, Polynomial& below) {
    if (below.is_one()) return;
    const Polynomial common = common_divisor(above, below);
    above = divided_exactly(above, common);
    below = divided_exactly(below, common);
  };
  cancel(na, db);
  cancel(nb, da);
  Polynomial numerator = na * nb;
  const bool roots = holds_algebraic(*generators);
  if (roots) numerator = reduced(*generators, std::move(numerator));
  return finished(std::move(generators), std::move(numerator), da * db, assumptions, !roots);
}

static Formula inverse(const Formula& x) {
  if (x.is_zero()) throw std::domain_error("division by zero in a formula");
  const Fraction& f = *x.fraction();
  if (!holds_algebraic(*f.generators)) {
    return finished(f.generators, f.denominator, f.numerator, f.assumptions, true);
  }
  // Roots are moved from the denominator A + B r, r^2 = R, by (A + B r)(A - B r) = A^2 - B^2 R.
  Polynomial above = f.denominator;
  Polynomial below = f.numerator;
  for (std::size_t v = f.generators->size(); v-- > 0;) {
    if (!is_algebraic(*(*f.generators)[v]) || below.degree(v) < 1) continue;
    const std::vector<Polynomial> parts = below.coefficients_by(v);
    const Polynomial conjugate = parts[0] - parts[1] * Polynomial::variable(f.generators->size(), v);
    above = reduced(*f.generators, above * conjugate);
    below = reduced(*f.generators, below * conjugate);
  }
  if (below.is_zero()) throw std::domain_error("division by a formula that is zero for some signs of its letters");
  return finished(f.generators, std::move(above), std::move(below), f.assumptions, false);
}

Assumptions united(const Assumptions& a, const Assumptions& b) {
  if (!b || a == b) return a;
  if (!a) return b;
  auto all = std::make_shared<std::vector<Assumption>>();
  std::set_union(a->begin(), a->end(), b->begin(), b->end(), std::back_inserter(*all));
  return all;
}

Formula assuming(const Formula& x, const Assumption& assumption) {
  if (!x.fraction()) return x;
  Fraction f = *x.fraction();
  f.assumptions = united(f.assumptions, std::make_shared<std::vector<Assumption>>(1, assumption));
  return Formula(std::make_shared<const Fraction>(std::move(f)));
}

Polynomial reduced(const Generators& generators, Polynomial polynomial) {
  const std::size_t n = generators.size();
  for (std::size_t v = n; v-- > 0;) {
    const Generator& g = *generators[v];
    if (!is_algebraic(g) || polynomial.degree(v) < 2) continue;
    const Polynomial square = g.kind == Kind::sign ? Polynomial(n, Integer(1))
                                                   : g.argument.fraction()->numerator.moved(
                                                         places_in(generators, *g.argument.fraction()->generators), n);
    const Polynomial root = Polynomial::variable(n, v);
    Polynomial even(n);
    Polynomial odd(n);
    const std::vector<Polynomial> parts = polynomial.coefficients_by(v);
    Polynomial squares(n, Integer(1));
    for (std::size_t k = 0; k < parts.size(); ++k) {
      Polynomial& sum = k % 2 == 0 ? even : odd;
      sum = sum + parts[k] * squares;
      if (k % 2 != 0) squares = squares * square;
    }
    polynomial = even + odd * root;
    check_limits(polynomial.length());
  }
  return polynomial;
}

Formula quotient(const Generators& generators, Polynomial numerator, Polynomial denominator,
                 const Assumptions& assumptions) {
  const auto list = std::make_shared<const Generators>(generators);
  const Polynomial one(generators.size(), Integer(1));
  Formula above = finished(list, reduced(generators, std::move(numerator)), one, assumptions, true);
  if (denominator.is_one()) return above;
  return above / finished(list, reduced(generators, std::move(denominator)), one, assumptions, true);
}

Formula polynomial_formula(const Generators& generators, Polynomial numerator, const Assumptions& assumptions) {
  return quotient(generators, std::move(numerator), Polynomial(generators.size(), Integer(1)), assumptions);
}

Formula generator_formula(const GeneratorPointer& generator) {
  Generators all = generator->needs;
  all.insert(std::upper_bound(all.begin(), all.end(), generator, before), generator);
  const auto place = static_cast<std::size_t>(std::find(all.begin(), all.end(), generator) - all.begin());
  Polynomial x = Polynomial::variable(all.size(), place);
  return polynomial_formula(all, std::move(x));
}

Formula integer_formula(const Integer& number) { return polynomial_formula({}, Polynomial(0, number)); }

Formula ratio_formula(const Ratio& ratio) {
  return integer_formula(Integer(ratio.numerator)) / integer_formula(Integer(ratio.denominator));
}

Formula numerator_of(const Formula& x) {
  if (!x.fraction()) return {};
  const Fraction& f = *x.fraction();
  return polynomial_formula(*f.generators, f.numerator, f.assumptions);
}
Formula denominator_of(const Formula& x) {
  if (!x.fraction()) return 1;
  const Fraction& f = *x.fraction();
  return polynomial_formula(*f.generators, f.denominator, f.assumptions);
}

Rational rational_of(const Formula& x) {
  if (!x.fraction()) return {Integer(0), Integer(1)};
  return {x.fraction()->numerator.coefficient(0), x.fraction()->denominator.coefficient(0)};
}

MultipleTangent multiple_tangent(std::int64_t n) {
  if (n > 100) throw FormulaTooLarge("a formula mixes an angle with its multiple by " + std::to_string(n));
  // (1 + i t)^n = denominator + i numerator.
  MultipleTangent tangent;
  tangent.numerator.resize(static_cast<std::size_t>(n) + 1);
  tangent.denominator.resize(static_cast<std::size_t>(n) + 1);
  for (std::int64_t k = 0; k <= n; ++k) {
    Integer binomial;
    fmpz_bin_uiui(binomial.get(), static_cast<ulong>(n), static_cast<ulong>(k));
    if (k % 4 >= 2) fmpz_neg(binomial.get(), binomial.get());
    (k % 2 == 0 ? tangent.denominator : tangent.numerator)[static_cast<std::size_t>(k)] = binomial;
  }
  return tangent;
}

}  // namespace poinsot::symbolic

namespace poinsot {

using symbolic::Polynomial;

Formula Formula::of_integer(std::int64_t number) { return symbolic::integer_formula(symbolic::Integer(number)); }

bool Formula::is_zero() const { return fraction_ == nullptr; }

Formula operator-(const Formula& a) {
  if (a.is_zero()) return a;
  symbolic::Fraction f = *a.fraction();
  f.numerator = -f.numerator;
  return Formula(std::make_shared<const symbolic::Fraction>(std::move(f)));
}
Formula operator+(const Formula& a, const Formula& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  return symbolic::sum(a, b, false);
}
Formula operator-(const Formula& a, const Formula& b) {
  if (a.is_zero()) return -b;
  if (b.is_zero()) return a;
  return symbolic::sum(a, b, true);
}
Formula operator*(const Formula& a, const Formula& b) {
  if (a.is_zero() || b.is_zero()) return {};
  return symbolic::product(a, b);
}
Formula operator/(const Formula& a, const Formula& b) {
  const Formula factor = symbolic::inverse(b);
  return a.is_zero() ? a : a * factor;
}
bool operator==(const Formula& a, const Formula& b) { return a.fraction() == b.fraction() || (a - b).is_zero(); }

Formula& Formula::operator+=(const Formula& b) { return *this = *this + b; }
Formula& Formula::operator-=(const Formula& b) { return *this = *this - b; }
Formula& Formula::operator*=(const Formula& b) { return *this = *this * b; }
Formula& Formula::operator/=(const Formula& b) { return *this = *this / b; }

}  // namespace poinsot
