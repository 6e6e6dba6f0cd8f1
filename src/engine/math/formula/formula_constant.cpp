// The constant stands as a letter whose name are its digits. Which numbers hold it is told by its largest prime factor:
// 9.80665 = 7 * 28019 / 20000, so that 28019 = 20000/7 * 9.80665, in coefficients and under roots alike.
#include "poinsot/engine/math/formula/formula_constant.h"

#include <flint/fmpz.h>
#include <flint/fmpz_factor.h>

#include <algorithm>

#include "engine/math/formula/formula_fraction.h"
#include "poinsot/engine/math/formula/formula_text.h"

namespace poinsot {
namespace symbolic {
namespace {

// Data and the numbers of inertia have no prime factors of this size but by chance, and g as stated in a problem, 9.81
// or 32.2, has none either.
constexpr int least_prime = 10000;

// The largest prime factor of a number.
Integer largest_prime(const Integer& number) {
  fmpz_factor_t factors;
  fmpz_factor_init(factors);
  fmpz_factor(factors, number.get());
  Integer largest(1);
  for (slong i = 0; i < factors->num; ++i)
    if (fmpz_cmp(factors->p + i, largest.get()) > 0) fmpz_set(largest.get(), factors->p + i);
  fmpz_factor_clear(factors);
  return largest;
}

class ConstantWriter {
 public:
  explicit ConstantWriter(std::string_view digits) {
    const Formula number = Formula::number(digits);
    prime_ = largest_prime(rational_of(number).numerator);
    stands_for_prime_ = Formula::letter(std::string(digits), Sign::positive) * integer_formula(prime_) / number;
  }

  bool can_tell() const { return fmpz_cmp_si(prime_.get(), least_prime) > 0; }

  bool is_in(const Formula& x) const {
    if (!x.fraction()) return false;
    const Fraction& f = *x.fraction();
    return is_in(f.numerator) || is_in(f.denominator) ||
           std::ranges::any_of(*f.generators, [this](const GeneratorPointer& g) {
             return has_arguments(*g) && (is_in(g->argument) || is_in(g->second));
           });
  }

  Formula with_constant(const Formula& x) const {
    if (!is_in(x)) return x;
    // First inside of roots and functions; then the numbers themselves.
    const Formula y = replaced(x, [this](const GeneratorPointer& g) -> std::unique_ptr<Replacement> {
      if (!has_arguments(*g)) return nullptr;
      const Formula value = with_arguments(*g, with_constant(g->argument), with_constant(g->second));
      return std::make_unique<Replacement>(Replacement{numerator_of(value), denominator_of(value)});
    });
    const Fraction& f = *y.fraction();
    return with_constant(*f.generators, f.numerator) / with_constant(*f.generators, f.denominator);
  }

 private:
  bool is_in(const Polynomial& polynomial) const {
    for (std::size_t i = 0; i < polynomial.length(); ++i)
      if (fmpz_divisible(polynomial.coefficient(i).get(), prime_.get()) != 0) return true;
    return false;
  }

  Formula with_constant(const Generators& generators, const Polynomial& polynomial) const {
    std::vector<Polynomial> by_power;
    for (std::size_t i = 0; i < polynomial.length(); ++i) {
      Integer rest;
      const auto power =
          static_cast<std::size_t>(fmpz_remove(rest.get(), polynomial.coefficient(i).get(), prime_.get()));
      while (by_power.size() <= power) by_power.emplace_back(generators.size());
      by_power[power].push(rest, polynomial.exponents(i));
    }
    Formula sum;
    for (std::size_t power = 0; power < by_power.size(); ++power) {
      by_power[power].tidy();
      sum +=
          polynomial_formula(generators, std::move(by_power[power])) * pow(stands_for_prime_, static_cast<int>(power));
    }
    return sum;
  }

  Integer prime_;
  Formula stands_for_prime_;
};

std::ptrdiff_t digits_beside(std::string_view text, std::string_view constant) {
  std::ptrdiff_t count = std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; });
  for (std::size_t at = text.find(constant); at != std::string_view::npos; at = text.find(constant, at + 1))
    count -= static_cast<std::ptrdiff_t>(constant.size()) - 1;  // all but the point
  return count;
}

}  // namespace
}  // namespace symbolic

std::string text_with_constant(const Formula& x, std::string_view digits) {
  const symbolic::ConstantWriter writer(digits);
  std::string without = text(x, Notation::with_sizes);
  if (!writer.can_tell() || !writer.is_in(x)) return without;
  std::string with = text(writer.with_constant(x), Notation::with_sizes);
  return symbolic::digits_beside(with, digits) < symbolic::digits_beside(without, digits) ? with : without;
}

Formula with_plain_numbers(const Formula& x, std::string_view digits) {
  if (!x.fraction()) return x;
  const symbolic::ConstantWriter writer(digits);
  const Formula y = writer.can_tell() ? writer.with_constant(x) : x;
  symbolic::Integer above = y.fraction()->numerator.content();  // of either sign
  fmpz_abs(above.get(), above.get());
  return x * symbolic::integer_formula(y.fraction()->denominator.content()) / symbolic::integer_formula(above);
}

}  // namespace poinsot
