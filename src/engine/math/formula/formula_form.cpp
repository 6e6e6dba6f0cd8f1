// Forms put together, and their lengths.
#include "engine/math/formula/formula_form.h"

#include <flint/fmpz.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

namespace poinsot::symbolic {
namespace {

std::string shortest_digits(double number) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
  return {buffer, end};
}

double nearest_double(const Integer& numerator, const Integer& denominator) {
  slong n = 0;
  slong d = 0;
  // Each with 53 bits and more, so that the quotient has one rounding too many at most.
  const double above = fmpz_get_d_2exp(&n, numerator.get());
  const double below = fmpz_get_d_2exp(&d, denominator.get());
  return std::ldexp(above / below, static_cast<int>(n - d));
}

// Numbers of many digits as decimals: a decimal of up to 17 digits exactly; what was a double by the digits that tell
// it from other doubles; what has more than 40 digits by those of a double.
std::optional<std::string> decimal_digits(const Integer& numerator, const Integer& denominator) {
  constexpr int short_denominator = 1000;  // three digits are read as a fraction: 7/960, not 0.00729166...
  if (fmpz_cmp_si(denominator.get(), short_denominator) <= 0) return std::nullopt;
  Integer rest(denominator);
  Integer prime(2);
  const slong twos = fmpz_remove(rest.get(), rest.get(), prime.get());
  fmpz_set_si(prime.get(), 5);
  const slong fives = fmpz_remove(rest.get(), rest.get(), prime.get());
  const bool decimal = fmpz_is_one(rest.get()) != 0;
  if (decimal && fives == 0 && fmpz_bits(numerator.get()) <= 53 && fmpz_bits(numerator.get()) > 20) {
    return shortest_digits(nearest_double(numerator, denominator));
  }
  const slong places = std::max(twos, fives);
  if (decimal && places <= 25) {
    Integer scale;
    fmpz_set_ui(scale.get(), 10);
    fmpz_pow_ui(scale.get(), scale.get(), static_cast<ulong>(places));
    fmpz_mul(scale.get(), scale.get(), numerator.get());
    fmpz_divexact(scale.get(), scale.get(), denominator.get());
    std::string digits = scale.text();
    if (digits.size() <= 17) {
      const auto after = static_cast<std::size_t>(places);
      if (digits.size() <= after) digits.insert(0, after + 1 - digits.size(), '0');
      digits.insert(digits.size() - after, ".");
      return digits;
    }
  }
  if (numerator.text().size() + denominator.text().size() > 40) {
    return shortest_digits(nearest_double(numerator, denominator));
  }
  return std::nullopt;
}

// Joins factors with their signs: x sqrt(x^2)/x is sqrt(x^2).
void unite_signs(std::vector<FormPower>& powers) {
  for (FormPower& sign : powers) {
    if (sign.base.kind != Form::Kind::quotient || sign.exponent != 1) continue;
    const Form size = sign.base.parts[0];
    const Form* sized = sized_part(size);
    if (sized == nullptr) continue;
    const std::string factor = text_of(*sized);
    if (text_of(sign.base.parts[1]) != factor) continue;
    const auto own = std::ranges::find_if(powers, [&](const FormPower& power) {
      return power.exponent > 0 && power.base.kind == sized->kind && text_of(power.base) == factor;
    });
    if (own == powers.end()) continue;
    if (own->exponent > 1) {
      --own->exponent;
      sign.base = size;
    } else {
      *own = {size, 1};
      sign.exponent = 0;
    }
  }
}

std::optional<std::int64_t> small_whole(const Form& form) {
  std::int64_t value = 0;
  const char* const end = form.text.data() + form.text.size();
  const auto read = std::from_chars(form.text.data(), end, value);
  constexpr std::int64_t largest = 1'000'000'000;
  if (form.kind != Form::Kind::number || read.ec != std::errc() || read.ptr != end || value > largest)
    return std::nullopt;
  return value;
}

Form whole_form(std::int64_t value) { return {Form::Kind::number, std::to_string(value)}; }

// A form times a positive whole number.
Form times(const Form& form, std::int64_t by) {
  if (by == 1) return form;
  if (form.kind == Form::Kind::negative) return negative_form(times(form.parts[0], by));
  if (const auto own = small_whole(form)) return whole_form(*own * by);
  if (form.kind == Form::Kind::quotient) {
    Form result = form;
    Form& below = result.parts[1];
    Form& divisor = below.kind == Form::Kind::product ? below.parts[0] : below;
    if (const auto own = small_whole(divisor)) {
      const std::int64_t common = std::gcd(*own, by);
      by /= common;
      if (*own > common || below.kind != Form::Kind::product) {
        divisor = whole_form(*own / common);
      } else {
        below.parts.erase(below.parts.begin());
        if (below.parts.size() == 1) below = Form(below.parts[0]);
      }
    }
    result.parts[0] = times(form.parts[0], by);
    const auto left = small_whole(result.parts[1]);
    return left && *left == 1 ? Form(result.parts[0]) : result;
  }
  if (form.kind == Form::Kind::product) {
    Form result = form;
    if (const auto own = small_whole(form.parts[0])) {
      result.parts[0] = whole_form(*own * by);
    } else {
      result.parts.insert(result.parts.begin(), whole_form(by));
    }
    return result;
  }
  return {Form::Kind::product, "", {whole_form(by), form}};
}

}  // namespace

const Form* sized_part(const Form& form) {
  if (form.kind != Form::Kind::call || form.text != "sqrt") return nullptr;
  const Form& square = form.parts[0];
  return square.kind == Form::Kind::power && square.exponent == 2 ? &square.parts[0] : nullptr;
}

Form number_form(const Integer& digits) { return {Form::Kind::number, digits.text()}; }
Form call_form(const std::string& function, Form argument) {
  return {Form::Kind::call, function, {std::move(argument)}};
}
Form power_form(Form base, int exponent) {
  if (exponent == 1) return base;
  // The power of e^x is written as one: exp(3*x).
  if (base.kind == Form::Kind::call && base.text == "exp") return call_form("exp", times(base.parts[0], exponent));
  return {Form::Kind::power, "", {std::move(base)}, exponent};
}
Form negative_form(Form positive) {
  if (positive.kind == Form::Kind::negative) return positive.parts[0];
  return {Form::Kind::negative, "", {std::move(positive)}};
}
Form sum_form(std::vector<Form> terms) {
  if (terms.size() == 1) return terms[0];
  return {Form::Kind::sum, "", std::move(terms)};
}

Form ordered_sum(std::vector<Form> terms) {
  const auto positive =
      std::find_if(terms.begin(), terms.end(), [](const Form& term) { return term.kind != Form::Kind::negative; });
  if (positive != terms.end()) std::rotate(terms.begin(), positive, positive + 1);
  return sum_form(std::move(terms));
}
Form negated_sum(const Form& sum) {
  std::vector<Form> terms;
  for (const Form& term : sum.parts) terms.push_back(negative_form(term));
  return ordered_sum(std::move(terms));
}

// Joins powers of e: exp(a) exp(b) is exp(a + b).
static void unite_exponentials(std::vector<FormPower>& powers) {
  const auto is_exponential = [](const FormPower& power) {
    return power.base.kind == Form::Kind::call && power.base.text == "exp" && power.exponent != 0;
  };
  if (std::ranges::count_if(powers, is_exponential) < 2) return;
  std::vector<Form> terms;
  for (const FormPower& power : powers) {
    if (!is_exponential(power)) continue;
    Form term = times(power.base.parts[0], std::abs(power.exponent));
    terms.push_back(power.exponent < 0 ? negative_form(std::move(term)) : std::move(term));
  }
  std::erase_if(powers, is_exponential);
  powers.push_back({call_form("exp", ordered_sum(std::move(terms))), 1});
}

Form product_form(const Integer& coefficient, const Integer& divisor, std::vector<FormPower> powers) {
  unite_signs(powers);
  unite_exponentials(powers);
  std::vector<Form> above;
  std::vector<Form> below;
  bool any_above = false;
  for (const FormPower& power : powers) any_above = any_above || power.exponent > 0;
  if (auto digits = decimal_digits(coefficient, divisor)) {
    above.push_back({Form::Kind::number, std::move(*digits)});
  } else {
    if (!fmpz_is_one(coefficient.get()) || !any_above) above.push_back(number_form(coefficient));
    if (!fmpz_is_one(divisor.get())) below.push_back(number_form(divisor));
  }
  for (const FormPower& power : powers) {
    if (power.exponent > 0) above.push_back(power_form(power.base, power.exponent));
    if (power.exponent < 0) below.push_back(power_form(power.base, -power.exponent));
  }
  const auto product = [](std::vector<Form> parts) {
    return parts.size() == 1 ? parts[0] : Form{Form::Kind::product, "", std::move(parts)};
  };
  Form top = product(std::move(above));
  if (below.empty()) return top;
  return {Form::Kind::quotient, "", {std::move(top), product(std::move(below))}};
}

int operators(const Form& form) {
  int count = 0;
  for (const Form& part : form.parts) count += operators(part);
  switch (form.kind) {
    case Form::Kind::number:
    case Form::Kind::name:
      return 0;
    case Form::Kind::sum: {
      // A minus counts once, as the sign of its term.
      const bool first_negative = form.parts[0].kind == Form::Kind::negative;
      const auto signs = std::count_if(form.parts.begin(), form.parts.end(),
                                       [](const Form& part) { return part.kind == Form::Kind::negative; });
      return count - static_cast<int>(signs) + static_cast<int>(form.parts.size()) - 1 + (first_negative ? 1 : 0);
    }
    case Form::Kind::product:
      return count + static_cast<int>(form.parts.size()) - 1;
    case Form::Kind::negative:
    case Form::Kind::quotient:
    case Form::Kind::power:
    case Form::Kind::call:
      break;
  }
  return count + 1;
}

double number_of_digits(const std::string& digits) {
  double number = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return read.ec == std::errc::result_out_of_range ? HUGE_VAL : number;
}

namespace {

double sum_of_numbers(const Form& form) {
  double sum = form.exponent;
  if (form.kind == Form::Kind::number) sum += number_of_digits(form.text);
  for (const Form& part : form.parts) sum += sum_of_numbers(part);
  return sum;
}

}  // namespace

bool is_shorter(const Form& a, const Form& b) {
  const int a_count = operators(a);
  const int b_count = operators(b);
  if (a_count != b_count) return a_count < b_count;
  const std::size_t a_size = text_of(a).size();
  const std::size_t b_size = text_of(b).size();
  return a_size != b_size ? a_size < b_size : sum_of_numbers(a) < sum_of_numbers(b);
}

}  // namespace poinsot::symbolic
