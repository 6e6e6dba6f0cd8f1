#include "engine/math/formula/formula_digits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/math/formula/formula_nearest.h"
#include "poinsot/engine/math/formula/certain_value.h"
#include "poinsot/engine/math/formula/formula_decision.h"

namespace poinsot {
namespace symbolic {
namespace {

constexpr double of_a_word = 10;  // of 64 bits, in a product

// sqrt where the argument may be a ball around zero.
Ball root_of(const Ball& x, slong precision) {
  Ball result;
  if (arb_contains_zero(x.get())) {
    arb_sqrtpos(result.get(), x.get(), precision);
  } else {
    arb_sqrt(result.get(), x.get(), precision);
  }
  return result;
}

Ball ball_of(const Generator& g, const BallOfLetter& letters, slong precision) {
  Ball x;
  switch (g.kind) {
    case Kind::letter:
      return letters(g);
    case Kind::pi:
      arb_const_pi(x.get(), precision);
      return x;
    case Kind::tangent:
    case Kind::constant_tangent:
      x = ball_of(g.argument, letters, precision);
      arb_mul_si(x.get(), x.get(), g.multiple.numerator, precision);
      arb_div_si(x.get(), x.get(), 2 * g.multiple.denominator, precision);
      arb_tan(x.get(), x.get(), precision);
      return x;
    case Kind::exponential:
      x = ball_of(g.argument, letters, precision);
      arb_mul_si(x.get(), x.get(), g.multiple.numerator, precision);
      arb_div_si(x.get(), x.get(), g.multiple.denominator, precision);
      arb_exp(x.get(), x.get(), precision);
      return x;
    case Kind::root:
      return root_of(ball_of(g.argument, letters, precision), precision);
    case Kind::sign:
      x = ball_of(g.argument, letters, precision);
      arb_sgn(x.get(), x.get());
      return x;
    case Kind::inverse:
      break;
  }
  x = ball_of(g.argument, letters, precision);
  if (g.name == "asin") {
    arb_asin(x.get(), x.get(), precision);
  } else if (g.name == "acos") {
    arb_acos(x.get(), x.get(), precision);
  } else if (g.name == "ln") {
    arb_log(x.get(), x.get(), precision);
  } else if (g.name == "atan") {
    arb_atan(x.get(), x.get(), precision);
  } else {
    const Ball second = ball_of(g.second, letters, precision);
    arb_atan2(x.get(), x.get(), second.get(), precision);
  }
  return x;
}

// x to a relative accuracy of so many bits, with as many bits in between as that takes; indeterminate if 16 times 64 do
// not suffice.
Ball accurate(const Formula& x, const BallOfLetter& letters, slong bits) {
  Ball value;
  for (slong precision = 2 * bits; precision <= 64 * bits; precision *= 2) {
    value = ball_of(x, letters, precision);
    if (arb_rel_accuracy_bits(value.get()) >= bits || arb_is_zero(value.get())) break;
  }
  return value;
}

BallOfLetter at_values(const LetterValues& values) {
  return [&values](const Generator& letter) {
    const auto found = values.find(letter.name);
    if (found == values.end()) throw std::invalid_argument("the letter " + letter.name + " has no value");
    Ball value;
    arb_set_d(value.get(), found->second);
    return value;
  };
}

}  // namespace

void count_digits_of(std::size_t terms, std::size_t generators, slong precision) {
  count_formula_work(of_a_word *
                     static_cast<double>(terms * (1 + generators) * static_cast<std::size_t>(1 + precision / 64)));
}

Ball ball_of(const Generators& generators, const Polynomial& polynomial, const BallOfLetter& letters, slong precision) {
  count_digits_of(polynomial.length(), generators.size(), precision);
  std::vector<std::vector<Ball>> powers(generators.size());
  const std::vector<bool> used = polynomial.used();
  for (std::size_t v = 0; v < generators.size(); ++v) {
    if (!used[v]) continue;
    powers[v].emplace_back(1);
    powers[v].push_back(ball_of(*generators[v], letters, precision));
    for (int k = 2; k <= polynomial.degree(v); ++k) {
      Ball next;
      arb_mul(next.get(), powers[v].back().get(), powers[v][1].get(), precision);
      powers[v].push_back(std::move(next));
    }
  }
  Ball sum;
  for (std::size_t i = 0; i < polynomial.length(); ++i) {
    Ball term;
    arb_set_fmpz(term.get(), polynomial.coefficient(i).get());
    const std::vector<int> exponents = polynomial.exponents(i);
    for (std::size_t v = 0; v < generators.size(); ++v) {
      if (exponents[v] == 0) continue;
      arb_mul(term.get(), term.get(), powers[v][static_cast<std::size_t>(exponents[v])].get(), precision);
    }
    arb_add(sum.get(), sum.get(), term.get(), precision);
  }
  return sum;
}

Ball ball_of(const Formula& x, const BallOfLetter& letters, slong precision) {
  if (!x.fraction()) return Ball();
  const Fraction& f = *x.fraction();
  Ball value = ball_of(*f.generators, f.numerator, letters, precision);
  if (!f.denominator.is_one()) {
    const Ball below = ball_of(*f.generators, f.denominator, letters, precision);
    arb_div(value.get(), value.get(), below.get(), precision);
  }
  return value;
}

BallOfLetter sample_point(int attempt) {
  return [attempt](const Generator& letter) {
    // FNV-1a of the name: the same value everywhere.
    std::uint64_t hash = 14695981039346656037ULL + static_cast<std::uint64_t>(attempt);
    for (const char c : letter.name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    hash ^= hash >> 29;
    hash *= 0xbf58476d1ce4e5b9ULL;
    hash ^= hash >> 32;
    Ball value;
    arb_set_ui(value.get(), (hash & 0xfffff) + 0xa0001);  // between 0.6 and 1.7
    arb_mul_2exp_si(value.get(), value.get(), -20);
    // Later attempts reach farther: some roots exist only where one letter is much larger than another.
    if (attempt > 0) arb_mul_2exp_si(value.get(), value.get(), static_cast<slong>((hash >> 40) % 9) - 4);
    return value;
  };
}

namespace {

// Far and near points, with letters of any sign on either side of zero.
BallOfLetter spread_point(int attempt) {
  return [point = sample_point(attempt), attempt](const Generator& letter) {
    Ball value = point(letter);
    int sum = attempt;
    for (const char c : letter.name) sum += static_cast<unsigned char>(c) * (1 + attempt / 2 % 3);
    if (letter.sign == Sign::real && sum % 2 == 1) arb_neg(value.get(), value.get());
    return value;
  };
}

// Whether what is zero at one point is so at others, where inverse functions and roots are on other branches.
bool is_zero_elsewhere(const Generators& generators, const Polynomial& polynomial) {
  constexpr int points = 24;  // with both signs and several sizes of each letter
  for (int attempt = 1; attempt <= points; ++attempt) {
    const Ball value = ball_of(generators, polynomial, spread_point(attempt), 256);
    if (arb_is_finite(value.get()) && !arb_contains_zero(value.get())) return false;
  }
  return true;
}

}  // namespace

bool is_zero_by_digits(const Generators& generators, const Polynomial& polynomial) {
  for (int attempt = 0; attempt < 64; ++attempt) {
    const BallOfLetter point = sample_point(attempt);
    const Ball rough = ball_of(generators, polynomial, point, 128);
    if (!arb_is_finite(rough.get())) continue;
    if (!arb_contains_zero(rough.get())) return false;
    const Ball fine = ball_of(generators, polynomial, point, 1200);
    Ball limit(1);
    arb_mul_2exp_si(limit.get(), limit.get(), -1000);
    Ball size;
    arb_abs(size.get(), fine.get());
    const bool zero = arb_contains_zero(fine.get()) && arb_lt(size.get(), limit.get());
    const bool number = std::all_of(generators.begin(), generators.end(), [](const auto& g) { return g->constant; });
    if (!zero || number || !notes_decisions()) return zero;
    note_zero_by_digits();
    return is_zero_elsewhere(generators, polynomial);
  }
  return false;
}

}  // namespace symbolic

double value_at(const Formula& x, const LetterValues& values) {
  if (const std::optional<double> nearest = symbolic::nearest_by_rounding(x, values)) return *nearest;
  const symbolic::Ball value = symbolic::accurate(x, symbolic::at_values(values), symbolic::digits_of_nearest / 2);
  if (!arb_is_finite(value.get())) return std::numeric_limits<double>::quiet_NaN();
  return arf_get_d(arb_midref(value.get()), ARF_RND_NEAR);
}

std::optional<double> certain_value_at(const Formula& x, const LetterValues& values) {
  if (const std::optional<double> nearest = symbolic::nearest_by_rounding(x, values)) return nearest;
  constexpr slong bits = symbolic::digits_of_nearest / 2;
  const symbolic::Ball value = symbolic::accurate(x, symbolic::at_values(values), bits);
  if (arb_is_zero(value.get())) return 0;
  if (!arb_is_finite(value.get()) || arb_rel_accuracy_bits(value.get()) < bits) return std::nullopt;
  return arf_get_d(arb_midref(value.get()), ARF_RND_NEAR);
}

double near_value_at(const Formula& x, const LetterValues& values) {
  constexpr long double near = 1e-13L;
  if (!x.is_zero()) {
    const Rounded found = symbolic::value_by_rounding(x, values);
    if (std::isfinite(found.error) && found.error <= near * found.size()) return static_cast<double>(found.value);
  }
  return value_at(x, values);
}

long double long_value_at(const Formula& x, const LetterValues& values) {
  const symbolic::Ball value = symbolic::accurate(x, symbolic::at_values(values), 72);
  if (!arb_is_finite(value.get())) return std::numeric_limits<long double>::quiet_NaN();
  const double head = arf_get_d(arb_midref(value.get()), ARF_RND_NEAR);
  symbolic::Ball rest;
  arb_set_d(rest.get(), head);
  arb_sub(rest.get(), value.get(), rest.get(), 256);
  return static_cast<long double>(head) + static_cast<long double>(arf_get_d(arb_midref(rest.get()), ARF_RND_NEAR));
}

std::string digits_at(const Formula& x, const LetterValues& values, int digits) {
  const symbolic::Ball value =
      symbolic::accurate(x, symbolic::at_values(values), static_cast<slong>(std::ceil(digits * 3.33)) + 16);
  const std::unique_ptr<char, void (*)(void*)> text(arb_get_str(value.get(), digits, ARB_STR_NO_RADIUS), flint_free);
  return text.get();
}

namespace {
thread_local LetterValues plain_point;
}  // namespace

PlainPointScope::PlainPointScope(LetterValues values) : outer_(std::exchange(plain_point, std::move(values))) {}
PlainPointScope::~PlainPointScope() { plain_point = std::move(outer_); }

double plain(const Formula& x) {
  if (x.is_zero()) return 0;
  if (!plain_point.empty()) {
    const symbolic::BallOfLetter elsewhere = symbolic::sample_point(0);
    const symbolic::BallOfLetter point = [&](const symbolic::Generator& letter) {
      const auto known = plain_point.find(letter.name);
      if (known == plain_point.end()) return elsewhere(letter);
      symbolic::Ball value;
      arb_set_d(value.get(), known->second);
      return value;
    };
    const symbolic::Ball ball = symbolic::accurate(x, point, 60);
    const double value = arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR);
    if (arb_is_finite(ball.get()) && value != 0) return value;
  }
  double value = std::numeric_limits<double>::quiet_NaN();
  for (int attempt = 0; attempt < 64; ++attempt) {
    const symbolic::Ball ball = symbolic::accurate(x, symbolic::sample_point(attempt), 60);
    if (!arb_is_finite(ball.get())) continue;
    value = arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR);
    if (value != 0) break;
  }
  return value;
}

}  // namespace poinsot
