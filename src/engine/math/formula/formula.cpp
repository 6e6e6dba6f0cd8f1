// Numbers, letters and simple powers.
#include "poinsot/engine/math/formula/formula.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/math/formula/formula_form.h"
#include "engine/math/formula/formula_fraction.h"
#include "poinsot/engine/math/formula/formula_text.h"

namespace poinsot {
namespace {

using symbolic::Generator;
using symbolic::GeneratorPointer;
using symbolic::Integer;

// x divided by so many squares of 1 + tan(a/2)^2 that it is a polynomial in sines and cosines: it has the sign of x.
Formula in_whole_angles(const Formula& x) {
  const symbolic::Fraction& f = *x.fraction();
  const std::vector<int> halves = symbolic::half_degrees(*f.generators, f.numerator);
  Formula result = x;
  for (std::size_t v = 0; v < halves.size(); ++v) {
    if (halves[v] == 0) continue;
    const Formula tangent = symbolic::generator_formula((*f.generators)[v]);
    result /= pow(1 + tangent * tangent, halves[v]);
  }
  return result;
}

// x as text with its sign, divided by the positive number among its coefficients that makes it shortest.
std::string text_of_sign(const Formula& x) {
  const Formula whole = in_whole_angles(x);
  std::string shortest = text(whole, Notation::with_sizes);
  const auto has_long_number = [](const std::string& words) {
    constexpr std::ptrdiff_t many_digits = 5;
    for (auto at = words.begin(); at != words.end();) {
      const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
      const auto begin = std::find_if(at, words.end(), is_digit);
      at = std::find_if_not(begin, words.end(), is_digit);
      if (at - begin >= many_digits) return true;
    }
    return false;
  };
  if (!has_long_number(shortest)) return shortest;
  const symbolic::Polynomial& p = x.fraction()->numerator;
  for (std::size_t i = 0; i < p.length(); ++i) {
    Integer size = p.coefficient(i);
    fmpz_abs(size.get(), size.get());
    std::string words = text(whole / symbolic::integer_formula(size), Notation::with_sizes);
    if (words.size() < shortest.size()) shortest = std::move(words);
  }
  return shortest;
}

// The convergent p/q of the continued fraction of a number with q <= 10000 that is the same double, if there is one.
std::optional<symbolic::Ratio> small_fraction(double number) {
  // Two such fractions differ by 1e-8 at least: of the sixteen digits of a double eight tell that it is meant.
  constexpr double most = 10000;
  if (!(std::fabs(number) < 1e9)) return std::nullopt;
  double rest = number;
  double p = 1, q = 0, p_before = 0, q_before = 1;
  while (true) {
    const double whole = std::floor(rest);
    p_before = std::exchange(p, whole * p + p_before);
    q_before = std::exchange(q, whole * q + q_before);
    if (q > most) return std::nullopt;
    if (p / q == number) return symbolic::Ratio{static_cast<std::int64_t>(p), static_cast<std::int64_t>(q)};
    if (rest == whole) return std::nullopt;
    rest = 1 / (rest - whole);
  }
}

[[noreturn]] void refuse(std::string_view digits) {
  throw std::invalid_argument("\"" + std::string(digits) + "\" is no number such as 7, -3/8, 0.15 or 1.5e-3");
}

Formula whole_number(std::string_view digits, std::string_view all) {
  const std::string_view plain_digits = digits.starts_with('-') || digits.starts_with('+') ? digits.substr(1) : digits;
  if (plain_digits.empty() || plain_digits.find_first_not_of("0123456789") != std::string_view::npos) refuse(all);
  Integer number;
  fmpz_set_str(number.get(), std::string(plain_digits).c_str(), 10);
  const Formula size = symbolic::integer_formula(number);
  return digits.starts_with('-') ? -size : size;
}

void collect_letters(const Formula& x, std::set<std::string>& names) {
  if (!x.fraction()) return;
  for (const GeneratorPointer& g : *x.fraction()->generators) {
    if (g->kind == symbolic::Kind::letter) names.insert(g->name);
    collect_letters(g->argument, names);
    collect_letters(g->second, names);
  }
}

}  // namespace

Formula::Formula(double number) {
  if (!std::isfinite(number)) throw std::domain_error("a number that is not finite stands for no formula");
  if (number == 0) return;
  if (const auto fraction = small_fraction(number)) {
    *this = symbolic::ratio_formula(*fraction);
    return;
  }
  // As a fraction at once: products of formulas, one for each digit of the exponent, took a third of the time of claims
  // that are tried at numbers.
  int exponent = 0;
  Integer digits(static_cast<std::int64_t>(std::ldexp(std::frexp(number, &exponent), 53))), below(1);
  Integer& raised = exponent < 53 ? below : digits;
  fmpz_mul_2exp(raised.get(), raised.get(), static_cast<ulong>(std::abs(exponent - 53)));
  *this = symbolic::integer_formula(digits) / symbolic::integer_formula(below);
}

Formula Formula::number(std::string_view digits) {
  if (const auto slash = digits.find('/'); slash != std::string_view::npos) {
    const Formula below = whole_number(digits.substr(slash + 1), digits);
    if (below.is_zero()) refuse(digits);
    return whole_number(digits.substr(0, slash), digits) / below;
  }
  std::string_view mantissa = digits;
  int exponent = 0;
  if (const auto e = digits.find_first_of("eE"); e != std::string_view::npos) {
    const std::string power(digits.substr(e + 1));
    std::size_t read = 0;
    try {
      exponent = std::stoi(power, &read);
    } catch (const std::exception&) {
      refuse(digits);
    }
    if (read != power.size() || std::abs(exponent) > 1000) refuse(digits);
    mantissa = digits.substr(0, e);
  }
  std::string whole(mantissa);
  if (const auto point = whole.find('.'); point != std::string::npos) {
    exponent -= static_cast<int>(whole.size() - point - 1);
    whole.erase(point, 1);
  }
  return whole_number(whole, digits) * pow(Formula(10), exponent);
}

Formula Formula::letter(const std::string& name, Sign sign) {
  return symbolic::generator_formula(symbolic::letter_generator(name, sign));
}

Formula Formula::pi() { return symbolic::generator_formula(symbolic::pi_generator()); }

bool Formula::is_number() const {
  return !fraction_ || std::all_of(fraction_->generators->begin(), fraction_->generators->end(),
                                   [](const GeneratorPointer& g) { return g->constant; });
}

bool Formula::is_rational() const { return !fraction_ || fraction_->generators->empty(); }

std::size_t Formula::terms() const {
  return fraction_ ? fraction_->numerator.length() + fraction_->denominator.length() : 0;
}

std::vector<std::string> Formula::letters() const {
  std::set<std::string> names;
  collect_letters(*this, names);
  return {names.begin(), names.end()};
}

std::vector<std::string> Formula::assumptions() const {
  const std::vector<std::string> roots = root_assumptions();
  std::set<std::string> words(roots.begin(), roots.end());
  if (fraction_ && fraction_->assumptions)
    for (const symbolic::Assumption& assumption : *fraction_->assumptions)
      if (assumption.not_negative.is_zero()) words.insert(assumption.key + " > 0");
  return {words.begin(), words.end()};
}

std::vector<std::string> Formula::root_assumptions() const {
  std::set<std::string> words;
  if (fraction_ && fraction_->assumptions)
    for (const symbolic::Assumption& assumption : *fraction_->assumptions)
      if (!assumption.not_negative.is_zero()) words.insert(text_of_sign(assumption.not_negative) + " >= 0");
  return {words.begin(), words.end()};
}

Formula pow(const Formula& x, int power) {
  Formula base = power < 0 ? 1 / x : x;
  Formula result(1);
  for (unsigned rest = static_cast<unsigned>(std::abs(power)); rest != 0; rest /= 2) {
    if (rest % 2 != 0) result *= base;
    if (rest > 1) base *= base;
  }
  return result;
}

}  // namespace poinsot
