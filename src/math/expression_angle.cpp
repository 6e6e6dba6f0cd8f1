// Sines, cosines and their inverses. An angle is a sum of rational multiples of products of letters, of pi and of 1
// rad; with t = tan(a/2) of each, sines and cosines are rational functions.
#include <numeric>
#include <stdexcept>

#include "math/expression_digits.h"
#include "math/expression_fraction.h"

namespace poinsot {
namespace symbolic {
namespace {

using Pair = SineCosine<Expression>;

Pair turned(const Pair& a, const Pair& b) {
  return {a.sine * b.cosine + a.cosine * b.sine, a.cosine * b.cosine - a.sine * b.sine};
}

Pair repeated(const Pair& a, std::int64_t times) {
  if (times < 0) return repeated({-a.sine, a.cosine}, -times);
  if (times > 100) throw ExpressionTooLarge("a formula holds the sine of " + std::to_string(times) + " times an angle");
  Pair result{0, 1};
  for (std::int64_t k = 0; k < times; ++k) result = turned(result, a);
  return result;
}

Pair from_half_tangent(const Expression& t) {
  const Expression one_and_square = 1 + t * t;
  return {2 * t / one_and_square, (1 - t * t) / one_and_square};
}

Pair of_generator(Kind kind, const Expression& argument, Ratio multiple) {
  const bool negative = multiple.numerator < 0;
  if (negative) multiple.numerator = -multiple.numerator;
  const Pair pair = from_half_tangent(generator_expression(tangent_generator(kind, argument, multiple)));
  return negative ? Pair{-pair.sine, pair.cosine} : pair;
}

// Of an angle between 0 and pi/4.
Pair of_pi_in_octant(const Ratio& multiple) {
  if (multiple.numerator == 0) return {0, 1};
  if (multiple == Ratio{1, 4}) return {sqrt(Expression(2)) / 2, sqrt(Expression(2)) / 2};
  if (multiple == Ratio{1, 6}) return {Expression(1) / 2, sqrt(Expression(3)) / 2};
  if (multiple == Ratio{1, 12}) {
    const Expression a = sqrt(Expression(6)) / 4;
    const Expression b = sqrt(Expression(2)) / 4;
    return {a - b, a + b};
  }
  return of_generator(Kind::constant_tangent, Expression::pi(), multiple);
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
  const Expression& u = g.argument;
  if (g.name == "asin") return {u, sqrt(1 - u * u)};
  if (g.name == "acos") return {sqrt(1 - u * u), u};
  const Expression x = g.name == "atan" ? Expression(1) : g.second;
  const Expression size = sqrt(u * u + x * x);
  return {u / size, x / size};
}

std::int64_t small(const Integer& number) {
  if (!fmpz_fits_si(number.get()) || fmpz_cmpabs(number.get(), Integer(1'000'000'000).get()) > 0) {
    throw ExpressionTooLarge("an angle is a letter times " + number.text() + ", a number with too many digits");
  }
  return fmpz_get_si(number.get());
}

Pair of_term(const Expression& unit, const Ratio& multiple) {
  if (unit == Expression(1)) return of_generator(Kind::constant_tangent, unit, multiple);
  const Generators& generators = *unit.fraction()->generators;
  if (generators.size() == 1 && unit == generator_expression(generators[0])) {
    const Generator& g = *generators[0];
    if (g.kind == Kind::pi) return of_pi(multiple);
    if (g.kind == Kind::inverse && multiple.denominator == 1) return repeated(of_inverse(g), multiple.numerator);
    if (g.kind == Kind::inverse && multiple.denominator == 2) {
      const Pair whole = of_inverse(g);
      const Expression cosine = sqrt((1 + whole.cosine) / 2);
      return repeated({whole.sine / (2 * cosine), cosine}, multiple.numerator);
    }
  }
  return of_generator(Kind::tangent, unit, multiple);
}

// k pi/12 with -6 <= k <= 6 whose value of a function is x, for numbers x.
std::optional<Expression> known_angle(const Expression& x, const std::function<Expression(const Pair&)>& function) {
  if (!x.is_number()) return std::nullopt;
  for (int k = -5; k <= 6; ++k) {
    const Pair pair = of_pi(lowest(k, 12));
    if (k == 6 && pair.cosine.is_zero() && !(x == Expression(1))) continue;
    if (function(pair) == x) return k * Expression::pi() / 12;
  }
  return std::nullopt;
}

Expression of_inverse_function(const std::string& name, const Expression& x) {
  return generator_expression(inverse_generator(name, x, Expression()));
}

bool leads_with_minus(const Expression& x) { return x.fraction() && x.fraction()->numerator.leading_sign() < 0; }

void require_sine(const Expression& x, const char* function) {
  if (x.is_number() && std::abs(plain(x)) > 1) {
    throw std::domain_error(std::string(function) + " of a number beyond 1");
  }
}

}  // namespace
}  // namespace symbolic

SineCosine<Expression> sine_cosine(const Expression& x) {
  using namespace symbolic;
  Pair pair{0, 1};
  if (x.is_zero()) return pair;
  const Fraction& f = *x.fraction();
  const Integer divisor = f.denominator.content();
  const Expression below = polynomial_expression(*f.generators, divided_exactly(f.denominator, divisor));
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
    const Expression unit = polynomial_expression(*f.generators, std::move(product)) / below;
    pair = turned(pair, of_term(unit, {small(n), small(d)}));
  }
  if (f.assumptions) {
    for (const Assumption& assumption : *f.assumptions) {
      pair = {assuming(pair.sine, assumption), assuming(pair.cosine, assumption)};
    }
  }
  return pair;
}

SineVersine<Expression> sine_versine(const Expression& x) {
  const auto [s, c] = sine_cosine(x);
  return {s, 1 - c};
}
Expression sin(const Expression& x) { return sine_cosine(x).sine; }
Expression cos(const Expression& x) { return sine_cosine(x).cosine; }
Expression tan(const Expression& x) {
  const auto [s, c] = sine_cosine(x);
  return s / c;
}

Expression asin(const Expression& x) {
  if (x.is_zero()) return x;
  symbolic::require_sine(x, "asin");
  if (symbolic::leads_with_minus(x)) return -asin(-x);
  if (const auto angle = symbolic::known_angle(x, [](const auto& pair) { return pair.sine; })) return *angle;
  return symbolic::of_inverse_function("asin", x);
}

Expression acos(const Expression& x) {
  symbolic::require_sine(x, "acos");
  if (const auto angle = symbolic::known_angle(x, [](const auto& pair) { return pair.sine; })) {
    return Expression::pi() / 2 - *angle;
  }
  if (x == Expression(-1)) return Expression::pi();
  if (symbolic::leads_with_minus(x)) return Expression::pi() - acos(-x);
  return symbolic::of_inverse_function("acos", x);
}

Expression atan(const Expression& x) {
  if (x.is_zero()) return x;
  if (symbolic::leads_with_minus(x)) return -atan(-x);
  const auto tangent = [](const auto& pair) { return pair.cosine.is_zero() ? Expression() : pair.sine / pair.cosine; };
  if (const auto angle = symbolic::known_angle(x, tangent)) return *angle;
  return symbolic::of_inverse_function("atan", x);
}

Expression atan2(const Expression& y, const Expression& x) {
  const int x_sign = symbolic::sign_of(x);
  const int y_sign = symbolic::sign_of(y);
  const Expression pi = Expression::pi();
  if (y.is_zero() && x.is_zero()) return {};
  if (x.is_zero() && y_sign != 0) return y_sign * pi / 2;
  if (y.is_zero() && x_sign < 0) return pi;
  if (x_sign > 0) return atan(y / x);
  if (x_sign < 0 && y_sign != 0) return atan(y / x) + y_sign * pi;
  // Without a common factor whose sign is known.
  Expression above = y;
  Expression right = x;
  if (!x.is_zero() && !y.is_zero()) {
    const Expression ratio = y / x;
    const Expression common = y / symbolic::numerator_of(ratio);
    if (const int sign = symbolic::sign_of(common); sign != 0) {
      above = sign * symbolic::numerator_of(ratio);
      right = sign * symbolic::denominator_of(ratio);
    }
  }
  return symbolic::generator_expression(symbolic::inverse_generator("atan2", above, right));
}

Expression sinc_of_square(const Expression& x) {
  if (x.is_zero()) return 1;
  const Expression a = sqrt(x);
  return sin(a) / a;
}
Expression cosine_of_square(const Expression& x) { return cos(sqrt(x)); }
Expression cosine_rest_of_square(const Expression& x) {
  if (x.is_zero()) return Expression(1) / 2;
  return (1 - cos(sqrt(x))) / x;
}
Expression sine_rest_of_square(const Expression& x) {
  if (x.is_zero()) return Expression(1) / 6;
  const Expression a = sqrt(x);
  return (a - sin(a)) / (x * a);
}

}  // namespace poinsot
