// Sines, cosines and their inverses. An angle is a sum of rational multiples of products of letters, of pi and of 1
// rad; with t = tan(a/2) of each, sines and cosines are rational functions.
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "engine/math/formula/formula_digits.h"
#include "engine/math/formula/formula_fraction.h"
#include "poinsot/engine/math/formula/formula_decision.h"

namespace poinsot {
namespace symbolic {
namespace {

using Pair = SineCosine<Formula>;

Pair turned(const Pair& a, const Pair& b) {
  return {a.sine * b.cosine + a.cosine * b.sine, a.cosine * b.cosine - a.sine * b.sine};
}

Pair repeated(const Pair& a, std::int64_t times) {
  if (times < 0) return repeated({-a.sine, a.cosine}, -times);
  if (times > 100) throw FormulaTooLarge("a formula holds the sine of " + std::to_string(times) + " times an angle");
  Pair result{0, 1};
  for (std::int64_t k = 0; k < times; ++k) result = turned(result, a);
  return result;
}

Pair from_half_tangent(const Formula& t) {
  const Formula one_and_square = 1 + t * t;
  return {2 * t / one_and_square, (1 - t * t) / one_and_square};
}

Pair of_generator(Kind kind, const Formula& argument, Ratio multiple) {
  const bool negative = multiple.numerator < 0;
  if (negative) multiple.numerator = -multiple.numerator;
  const Pair pair = from_half_tangent(generator_formula(tangent_generator(kind, argument, multiple)));
  return negative ? Pair{-pair.sine, pair.cosine} : pair;
}

// Of an angle between 0 and pi/4.
Pair of_pi_in_octant(const Ratio& multiple) {
  if (multiple.numerator == 0) return {0, 1};
  if (multiple == Ratio{1, 4}) return {sqrt(Formula(2)) / 2, sqrt(Formula(2)) / 2};
  if (multiple == Ratio{1, 6}) return {Formula(1) / 2, sqrt(Formula(3)) / 2};
  if (multiple == Ratio{1, 12}) {
    const Formula a = sqrt(Formula(6)) / 4;
    const Formula b = sqrt(Formula(2)) / 4;
    return {a - b, a + b};
  }
  return of_generator(Kind::constant_tangent, Formula::pi(), multiple);
}

Ratio lowest(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t shared = std::gcd(numerator, denominator);
  return {numerator / shared, denominator / shared};
}

Pair of_pi(const Ratio& multiple) {
  const std::int64_t d = multiple.denominator;
  std::int64_t n = multiple.numerator % (2 * d);
  if (n < 0) n += 2 * d;
  const std::int64_t quarters = 2 * n / d;
  const std::int64_t rest = 2 * n - quarters * d;  // rest / (2 d) of pi, between 0 and 1/2
  Pair pair;
  if (2 * rest > d) {
    const Pair mirrored = of_pi_in_octant(lowest(d - rest, 2 * d));
    pair = {mirrored.cosine, mirrored.sine};
  } else {
    pair = of_pi_in_octant(lowest(rest, 2 * d));
  }
  for (std::int64_t k = 0; k < quarters; ++k) pair = {pair.cosine, -pair.sine};
  return pair;
}

// Of the value of an inverse function, between -pi and pi.
Pair of_inverse(const Generator& g) {
  const Formula& u = g.argument;
  if (g.name == "asin") return {u, sqrt(1 - u * u)};
  if (g.name == "acos") return {sqrt(1 - u * u), u};
  const Formula x = g.name == "atan" ? Formula(1) : g.second;
  const Formula size = sqrt(u * u + x * x);
  return {u / size, x / size};
}

Pair of_term(const Formula& unit, const Ratio& multiple) {
  if (unit == Formula(1)) return of_generator(Kind::constant_tangent, unit, multiple);
  const Generators& generators = *unit.fraction()->generators;
  if (generators.size() == 1 && unit == generator_formula(generators[0])) {
    const Generator& g = *generators[0];
    if (g.kind == Kind::pi) return of_pi(multiple);
    const bool is_angle = g.kind == Kind::inverse && g.name != "ln";
    if (is_angle && multiple.denominator == 1) return repeated(of_inverse(g), multiple.numerator);
    if (is_angle && multiple.denominator == 2) {
      const Pair whole = of_inverse(g);
      const Formula cosine = sqrt((1 + whole.cosine) / 2);
      return repeated({whole.sine / (2 * cosine), cosine}, multiple.numerator);
    }
  }
  return of_generator(Kind::tangent, unit, multiple);
}

// k pi/12 with -6 <= k <= 6 whose value of a function is x, for numbers x. Doubles that are far apart tell most of them
// from x, without the roots of which their values are made.
std::optional<Formula> known_angle(const Formula& x, const std::function<Formula(const Pair&)>& function,
                                   double (*in_doubles)(double)) {
  if (!x.is_number()) return std::nullopt;
  constexpr double far_apart = 1e-6;  // of 1 and of x: ten thousand million times the rounding of both
  const double number = plain(x);
  for (int k = -5; k <= 6; ++k) {
    const double apart = std::abs(in_doubles(k * std::numbers::pi / 12) - number);
    if (apart > far_apart * (1 + std::abs(number))) continue;
    const Pair pair = of_pi(lowest(k, 12));
    if (k == 6 && pair.cosine.is_zero() && !(x == Formula(1))) continue;
    if (function(pair) == x) return k * Formula::pi() / 12;
  }
  return std::nullopt;
}

Formula sine_of(const Pair& pair) { return pair.sine; }
Formula tangent_of(const Pair& pair) { return pair.cosine.is_zero() ? Formula() : pair.sine / pair.cosine; }

Formula of_inverse_function(const std::string& name, const Formula& x) {
  return assuming_alike(generator_formula(inverse_generator(name, x, Formula())), x);
}

// The sign of x times those of its factors whose sign is not known.
Formula of_open_sign(const Formula& x) {
  const Formula signs = abs(x) / x;
  Formula open(1);
  for (const GeneratorPointer& g : *signs.fraction()->generators)
    if (g->kind == Kind::sign) open *= g->argument;
  return open * replaced(signs, [](const GeneratorPointer& g) {
           return g->kind == Kind::sign ? std::make_unique<Replacement>(Replacement{1, 1}) : nullptr;
         });
}

bool leads_with_minus(const Formula& x) { return x.fraction() && x.fraction()->numerator.leading_sign() < 0; }

void require_sine(const Formula& x, const char* function) {
  if (x.is_number() && std::abs(plain(x)) > 1) {
    throw std::domain_error(std::string(function) + " of a number beyond 1");
  }
}

std::int64_t small(const Integer& number) {
  if (!fmpz_fits_si(number.get()) || fmpz_cmpabs(number.get(), Integer(1'000'000'000).get()) > 0) {
    throw FormulaTooLarge("an angle or exponent is a letter times " + number.text() +
                          ", a number with too many digits");
  }
  return fmpz_get_si(number.get());
}

}  // namespace

std::vector<MultipleOfUnit> multiples_in(const Formula& x) {
  std::vector<MultipleOfUnit> all;
  if (!x.fraction()) return all;
  const Fraction& f = *x.fraction();
  const Integer divisor = f.denominator.content();
  const Formula below = polynomial_formula(*f.generators, divided_exactly(f.denominator, divisor));
  for (std::size_t i = 0; i < f.numerator.length(); ++i) {
    const Integer coefficient = f.numerator.coefficient(i);
    Polynomial product(f.generators->size());
    product.push(Integer(1), f.numerator.exponents(i));
    Integer common;
    fmpz_gcd(common.get(), coefficient.get(), divisor.get());
    Integer n(coefficient);
    Integer d(divisor);
    fmpz_divexact(n.get(), n.get(), common.get());
    fmpz_divexact(d.get(), d.get(), common.get());
    const Formula unit = polynomial_formula(*f.generators, std::move(product)) / below;
    all.push_back({unit, {small(n), small(d)}});
  }
  return all;
}

Formula assuming_alike(Formula function, const Formula& x) {
  if (x.fraction() && x.fraction()->assumptions)
    for (const Assumption& assumption : *x.fraction()->assumptions) function = assuming(function, assumption);
  return function;
}

}  // namespace symbolic

SineCosine<Formula> sine_cosine(const Formula& x) {
  using namespace symbolic;
  Pair pair{0, 1};
  if (x.is_zero()) return pair;
  for (const MultipleOfUnit& term : multiples_in(x)) pair = turned(pair, of_term(term.unit, term.multiple));
  return {assuming_alike(pair.sine, x), assuming_alike(pair.cosine, x)};
}

SineVersine<Formula> sine_versine(const Formula& x) {
  const auto [s, c] = sine_cosine(x);
  return {s, 1 - c};
}
Formula sin(const Formula& x) { return sine_cosine(x).sine; }
Formula cos(const Formula& x) { return sine_cosine(x).cosine; }
Formula tan(const Formula& x) {
  const auto [s, c] = sine_cosine(x);
  return s / c;
}

Formula asin(const Formula& x) {
  if (x.is_zero()) return x;
  symbolic::require_sine(x, "asin");
  if (symbolic::leads_with_minus(x)) return -asin(-x);
  if (const auto angle = symbolic::known_angle(x, symbolic::sine_of, std::sin)) return *angle;
  return symbolic::of_inverse_function("asin", x);
}

Formula acos(const Formula& x) {
  symbolic::require_sine(x, "acos");
  if (const auto angle = symbolic::known_angle(x, symbolic::sine_of, std::sin)) {
    return Formula::pi() / 2 - *angle;
  }
  if (x == Formula(-1)) return Formula::pi();
  if (symbolic::leads_with_minus(x)) return Formula::pi() - acos(-x);
  return symbolic::of_inverse_function("acos", x);
}

Formula atan(const Formula& x) {
  if (x.is_zero()) return x;
  if (symbolic::leads_with_minus(x)) return -atan(-x);
  if (const auto angle = symbolic::known_angle(x, symbolic::tangent_of, std::tan)) return *angle;
  return symbolic::of_inverse_function("atan", x);
}

Formula atan2(const Formula& y, const Formula& x) {
  const int x_sign = symbolic::sign_of(x);
  const int y_sign = symbolic::sign_of(y);
  Formula pi = Formula::pi();
  if (y.is_zero() && x.is_zero()) return {};
  if (x.is_zero() && y_sign != 0) return y_sign * pi / 2;
  if (y.is_zero() && x_sign < 0) return pi;
  if (y.is_zero() && x_sign == 0 && notes_decisions()) return decided_negative(x) ? pi : Formula();
  if (x_sign > 0) return atan(y / x);
  if (x_sign < 0 && y_sign != 0) return atan(y / x) + y_sign * pi;
  // Without a common factor whose sign is known.
  Formula above = y;
  Formula right = x;
  if (!x.is_zero() && !y.is_zero()) {
    const Formula ratio = y / x;
    const Formula common = y / symbolic::numerator_of(ratio);
    // Factors of it that may have either sign stay.
    const Formula stays = symbolic::of_open_sign(common);
    above = stays * symbolic::numerator_of(ratio);
    right = stays * symbolic::denominator_of(ratio);
  }
  const Formula angle = symbolic::generator_formula(symbolic::inverse_generator("atan2", above, right));
  return symbolic::assuming_alike(symbolic::assuming_alike(angle, y), x);
}

Formula sinc_of_square(const Formula& x) {
  if (x.is_zero()) return 1;
  const Formula a = sqrt(x);
  return sin(a) / a;
}
Formula cosine_of_square(const Formula& x) { return cos(sqrt(x)); }
Formula cosine_rest_of_square(const Formula& x) {
  if (x.is_zero()) return Formula(1) / 2;
  return (1 - cos(sqrt(x))) / x;
}
Formula sine_rest_of_square(const Formula& x) {
  if (x.is_zero()) return Formula(1) / 6;
  const Formula a = sqrt(x);
  return (a - sin(a)) / (x * a);
}

}  // namespace poinsot
