// Products in the order in which people write them, with what is below the line inside of sums where that is shorter.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <string_view>

#include "engine/math/formula/formula_form.h"

namespace poinsot::symbolic {
namespace {

// Numbers first, then letters, functions, sums, roots.
int rank(const Form& form) {
  switch (form.kind) {
    case Form::Kind::number:
      return 0;
    case Form::Kind::name:
      return form.text == "pi" ? 1 : 2;
    case Form::Kind::call:
      return form.text != "sqrt" ? 3 : form.parts[0].kind == Form::Kind::number ? 0 : 5;
    default:
      return 4;
  }
}

// The part of a name that says what kind of thing it is: m of m0, mA and m_disk, omega of omega1.
std::string_view stem(std::string_view name) {
  const std::size_t end =
      std::find_if(name.begin() + 1, name.end(), [](char c) { return c < 'a' || c > 'z'; }) - name.begin();
  return name.substr(0, end);
}

// As texts write m g L, F a, I w1, m r w^2: forces and what resists motion, gravity, sizes, rates. Only how a formula
// reads depends on this; a letter that means something else stands elsewhere in its product.
int letter_rank(std::string_view name) {
  static constexpr std::array<std::string_view, 11> forces_and_masses{"F", "I", "J", "M",  "P",  "Q",
                                                                      "W", "k", "m", "mu", "rho"};
  static constexpr std::array<std::string_view, 5> rates{"Omega", "n", "omega", "v", "w"};
  const std::string_view kind = stem(name);
  if (name.ends_with('\'') || kind.ends_with("dot") || std::ranges::find(rates, kind) != rates.end()) return 3;
  // A constant that stands by its digits is gravity, too (formula_constant.h).
  if (name == "g" || (name.front() >= '0' && name.front() <= '9')) return 1;
  return std::ranges::find(forces_and_masses, kind) != forces_and_masses.end() ? 0 : 2;
}

void reduce(Integer& a, Integer& b) {
  Integer common;
  fmpz_gcd(common.get(), a.get(), b.get());
  fmpz_divexact(a.get(), a.get(), common.get());
  fmpz_divexact(b.get(), b.get(), common.get());
  if (fmpz_sgn(b.get()) < 0) {
    fmpz_neg(a.get(), a.get());
    fmpz_neg(b.get(), b.get());
  }
}

bool is_sum(const Form& form) { return form.kind == Form::Kind::sum; }

// Whether some number in it has as many digits as decimals leave behind.
bool has_long_number(const Form& form) {
  constexpr std::size_t many_digits = 5;  // a product of data with two digits each has four
  return (form.kind == Form::Kind::number && form.text.size() >= many_digits) ||
         std::any_of(form.parts.begin(), form.parts.end(), has_long_number);
}

bool is_integer(const Form& form) {
  return form.kind == Form::Kind::number && form.text.find_first_not_of("0123456789") == std::string::npos;
}
Integer integer_of(const Form& form) {
  Integer digits;
  fmpz_set_str(digits.get(), form.text.c_str(), 10);
  return digits;
}
bool is_root(const FormPower& power) {
  return power.exponent == 1 && power.base.kind == Form::Kind::call && power.base.text == "sqrt";
}

Form divided_term(const Form& term, const Integer& factor, const Integer& divisor, const std::vector<FormPower>& below);

// above / under * powers with the number below the roots, where there decimals are shorter for it:
// sqrt(39.2266 x + y) for sqrt(2) sqrt(196133 x + 5000 y)/100.
void take_into_root(Integer& above, Integer& under, std::vector<FormPower>& powers) {
  const auto root = std::find_if(powers.begin(), powers.end(),
                                 [](const FormPower& power) { return is_root(power) && has_long_number(power.base); });
  if (root == powers.end()) return;
  const Form& radicand = root->base.parts[0];
  Integer number(1);
  std::vector<FormPower> others;
  const Form* sum = nullptr;
  const std::vector<Form> parts = radicand.kind == Form::Kind::product ? radicand.parts : std::vector<Form>{radicand};
  for (const Form& part : parts) {
    if (is_integer(part))
      fmpz_mul(number.get(), number.get(), integer_of(part).get());
    else if (is_sum(part) && sum == nullptr)
      sum = &part;
    else
      others.push_back({part, 1});
  }
  if (sum == nullptr) return;
  std::vector<FormPower> left;
  std::vector<FormPower> before{*root};
  for (const FormPower& power : powers) {
    if (&power == &*root) continue;
    if (is_root(power) && is_integer(power.base.parts[0])) {
      fmpz_mul(number.get(), number.get(), integer_of(power.base.parts[0]).get());
      before.push_back(power);
    } else {
      left.push_back(power);
    }
  }
  Integer square(under);
  fmpz_mul(number.get(), number.get(), above.get());
  fmpz_mul(number.get(), number.get(), above.get());
  fmpz_mul(square.get(), under.get(), under.get());
  reduce(number, square);
  std::vector<Form> terms;
  for (const Form& term : sum->parts) terms.push_back(divided_term(term, number, square, {}));
  others.push_back({sum_form(std::move(terms)), 1});
  FormPower whole{call_form("sqrt", product_form(Integer(1), Integer(1), others)), 1};
  if (text_of(whole.base).size() >= text_of(product_form(above, under, before)).size()) return;
  left.push_back(std::move(whole));
  powers = std::move(left);
  above = Integer(1);
  under = Integer(1);
}

// A term of a sum times factor / divisor and further powers.
Form divided_term(const Form& term, const Integer& factor, const Integer& divisor,
                  const std::vector<FormPower>& below) {
  if (term.kind == Form::Kind::negative) return negative_form(divided_term(term.parts[0], factor, divisor, below));
  Integer above(factor);
  Integer under(divisor);
  std::vector<FormPower> powers;
  const std::function<void(const Form&, int)> split = [&](const Form& form, int sign) {
    if (form.kind == Form::Kind::product) {
      for (const Form& part : form.parts) split(part, sign);
    } else if (form.kind == Form::Kind::quotient) {
      split(form.parts[0], sign);
      split(form.parts[1], -sign);
    } else if (is_integer(form)) {
      Integer& part = sign > 0 ? above : under;
      fmpz_mul(part.get(), part.get(), integer_of(form).get());
    } else if (form.kind == Form::Kind::power) {
      powers.push_back({form.parts[0], sign * form.exponent});
    } else {
      powers.push_back({form, sign});
    }
  };
  split(term, 1);
  for (const FormPower& b : below) {
    const auto own = std::find_if(powers.begin(), powers.end(), [&b](const FormPower& p) {
      return p.base.kind == b.base.kind && p.base.text == b.base.text && text_of(p.base) == text_of(b.base);
    });
    if (own != powers.end()) {
      own->exponent += b.exponent;
    } else {
      powers.push_back(b);
    }
  }
  reduce(above, under);
  take_into_root(above, under, powers);
  return product_form(above, under, powers);
}

}  // namespace

// Letters of one rank stand in the order of a dictionary.
bool stands_before(const FormPower& a, const FormPower& b) {
  if (rank(a.base) != rank(b.base)) return rank(a.base) < rank(b.base);
  if (rank(a.base) != 2) return false;
  const std::string &x = a.base.text, &y = b.base.text;
  // k alone is a stiffness or a coefficient of friction, squared a radius of gyration: k m g, but m k^2.
  const auto place = [](const FormPower& power) {
    constexpr int of_sizes = 2;
    return stem(power.base.text) == "k" && std::abs(power.exponent) > 1 ? of_sizes : letter_rank(power.base.text);
  };
  if (place(a) != place(b)) return place(a) < place(b);
  const auto folded = [](const std::string& name) {
    std::string low = name;
    for (char& c : low) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return low;
  };
  return folded(x) != folded(y) ? folded(x) < folded(y) : x < y;
}

Form assembled_product(bool negative, Integer coefficient, Integer divisor, std::vector<FormPower> powers) {
  reduce(coefficient, divisor);
  if (fmpz_sgn(coefficient.get()) < 0) {
    fmpz_neg(coefficient.get(), coefficient.get());
    negative = !negative;
  }
  // Minus goes into a difference.
  for (FormPower& power : powers) {
    if (!negative) break;
    if (!is_sum(power.base) || power.exponent % 2 == 0) continue;
    const Form turned = negated_sum(power.base);
    if (operators(turned) > operators(power.base)) continue;
    power.base = turned;
    negative = false;
  }
  std::stable_sort(powers.begin(), powers.end(), stands_before);
  Form best = product_form(coefficient, divisor, powers);

  // A sum above the line may take what is below into its terms: 6 + r^2/L^2 for (6 L^2 + r^2)/L^2.
  const auto sum =
      std::find_if(powers.begin(), powers.end(), [](const FormPower& p) { return is_sum(p.base) && p.exponent == 1; });
  if (sum == powers.end()) return negative ? negative_form(best) : best;
  std::vector<FormPower> below;
  std::vector<FormPower> others;
  for (const FormPower& power : powers) {
    if (&power != &*sum) (power.exponent < 0 && !is_sum(power.base) ? below : others).push_back(power);
  }
  // Letters alone below the terms leave fractions above the number, (x/a + y/b)/6: as long with the number in the
  // terms, that is read with less trouble.
  bool fractions_above_number = false;
  for (const bool with_number : {false, true}) {
    if (below.empty() && (!with_number || fmpz_is_one(divisor.get()))) continue;
    std::vector<Form> terms;
    for (const Form& term : sum->base.parts) {
      terms.push_back(divided_term(term, Integer(1), with_number ? divisor : Integer(1), below));
    }
    std::vector<FormPower> changed = others;
    changed.push_back({sum_form(std::move(terms)), 1});
    std::stable_sort(changed.begin(), changed.end(), stands_before);
    Form form = product_form(coefficient, with_number ? Integer(1) : divisor, changed);
    const int longer = operators(form) - operators(best);
    if (longer > 0 || (longer == 0 && !fractions_above_number)) continue;
    best = std::move(form);
    fractions_above_number = !with_number && !fmpz_is_one(divisor.get());
  }
  // Decimals stand in the terms themselves: 2 r w^2/5 + 14.709975 for (16000 r w^2 + 588399)/40000.
  if (has_long_number(sum->base) && !(fmpz_is_one(coefficient.get()) && fmpz_is_one(divisor.get()))) {
    for (int left = 1; left <= 10; ++left) {
      Integer factor(left);
      fmpz_mul(factor.get(), factor.get(), coefficient.get());
      std::vector<Form> terms;
      for (const Form& term : sum->base.parts) terms.push_back(divided_term(term, factor, divisor, {}));
      std::vector<FormPower> changed = powers;
      changed[static_cast<std::size_t>(sum - powers.begin())].base = sum_form(std::move(terms));
      Form form = product_form(Integer(1), Integer(left), changed);
      const auto length = [](const Form& one) { return std::pair(text_of(one).size(), operators(one)); };
      if (length(form) < length(best)) best = std::move(form);
    }
  }
  return negative ? negative_form(best) : best;
}

}  // namespace poinsot::symbolic
