// Forms in the language of TeX.
#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <optional>
#include <string>

#include "engine/math/formula/formula_form.h"

namespace poinsot::symbolic {
namespace {

// omega1 is \omega_{1}, Fdt is \mathit{Fdt}, theta' is \dot{\theta}; what is no name is text.
std::string tex_name(const std::string& whole) {
  const std::size_t end = whole.find_last_not_of('\'') + 1;
  const std::string name = whole.substr(0, end);
  if (!std::all_of(name.begin(), name.end(),
                   [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)); })) {
    std::string words;
    for (const char c : whole) words += c == '_' ? std::string("\\_") : std::string(1, c);
    return "\\text{" + words + "}";
  }
  static constexpr std::array<const char*, 35> greek{
      "alpha", "beta",  "gamma",  "delta", "epsilon", "zeta",  "eta",     "theta", "iota", "kappa", "lambda", "mu",
      "nu",    "xi",    "pi",     "rho",   "sigma",   "tau",   "upsilon", "phi",   "chi",  "psi",   "omega",  "Gamma",
      "Delta", "Theta", "Lambda", "Xi",    "Pi",      "Sigma", "Upsilon", "Phi",   "Psi",  "Omega", "varphi"};
  std::size_t stem = name.size();
  while (stem > 1 && std::isdigit(static_cast<unsigned char>(name[stem - 1]))) --stem;
  std::string base = name.substr(0, stem);
  std::string index = name.substr(stem);
  if (const auto low = base.find('_'); low != std::string::npos && low > 0) {
    index = base.substr(low + 1) + index;
    base.resize(low);
  }
  std::string escaped;
  for (const char c : index) escaped += c == '_' ? std::string("\\_") : std::string(1, c);
  std::string letter;
  for (const char c : base) letter += c == '_' ? std::string("\\_") : std::string(1, c);
  if (std::find(greek.begin(), greek.end(), base) != greek.end()) {
    letter = "\\" + base;
  } else if (base.size() > 1) {
    letter = "\\mathit{" + letter + "}";
  }
  static constexpr std::array<const char*, 4> dots{"", "\\dot", "\\ddot", "\\dddot"};
  const std::size_t primes = whole.size() - end;
  if (primes > 0 && primes < dots.size()) letter = std::string(dots[primes]) + "{" + letter + "}";
  return index.empty() ? letter : letter + "_{" + escaped + "}";
}

std::string bracketed(const Form& form, bool brackets) {
  return brackets ? "\\left(" + tex_of(form) + "\\right)" : tex_of(form);
}

std::string tex_function(const std::string& function) {
  if (function == "asin") return "\\arcsin";
  if (function == "acos") return "\\arccos";
  if (function == "atan") return "\\arctan";
  if (function == "atan2") return "\\operatorname{atan2}";
  return "\\" + function;
}

// Of an angle that is no common part of pi the degrees, as people write it: 2 pi/9 is 40 degrees.
std::optional<std::string> in_degrees(const Form& angle) {
  if (angle.kind != Form::Kind::quotient || angle.parts[1].kind != Form::Kind::number) return std::nullopt;
  const Form& above = angle.parts[0];
  const auto is_pi = [](const Form& form) { return form.kind == Form::Kind::name && form.text == "pi"; };
  const auto whole = [](const std::string& digits) -> std::optional<long> {
    constexpr std::size_t most_digits = 5;
    if (digits.empty() || digits.size() > most_digits ||
        !std::ranges::all_of(digits, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }))
      return std::nullopt;
    return std::stol(digits);
  };
  std::optional<long> times;
  if (is_pi(above)) times = 1;
  if (above.kind == Form::Kind::product && above.parts.size() == 2 && above.parts[0].kind == Form::Kind::number &&
      is_pi(above.parts[1]))
    times = whole(above.parts[0].text);
  const std::optional<long> below = whole(angle.parts[1].text);
  if (!times || !below || *below <= 6 || (1800 * *times) % *below != 0) return std::nullopt;
  const long tenths = 1800 * *times / *below;
  const std::string rest = tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10);
  return std::to_string(tenths / 10) + rest + "^{\\circ}";
}

// What decimals of the data leave of a coefficient, as they are read: 981/100 is 9.81, 2943/200 is 14.715. Shapes leave
// no such denominators: 3/80 and 83/320 have one factor of five. Squares of fifths, as in energies, are fractions.
std::optional<std::string> decimal(const Form& above, const Form& below) {
  constexpr std::size_t most_digits = 6;
  if (below.kind != Form::Kind::number || above.kind != Form::Kind::number || above.text.size() > most_digits ||
      below.text.size() > most_digits)
    return std::nullopt;
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  if (!std::ranges::all_of(above.text + below.text, is_digit)) return std::nullopt;
  long numerator = std::stol(above.text), denominator = std::stol(below.text);
  constexpr long fifths = 25;
  if (denominator % fifths != 0 || denominator == fifths) return std::nullopt;
  std::size_t places = 0;
  for (; denominator > 1 && places < most_digits; ++places) {
    numerator *= 10;
    const long common = std::gcd(numerator, denominator);
    numerator /= common;
    denominator /= common;
  }
  std::string digits = std::to_string(numerator);
  if (denominator > 1 || digits.size() > most_digits) return std::nullopt;
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  return digits.insert(digits.size() - places, ".");
}

// The same with the rest of the quotient.
std::optional<Form> with_decimal(const Form& quotient) {
  const auto first = [](const Form& form) { return form.kind == Form::Kind::product ? form.parts[0] : form; };
  const auto rest = [](const Form& form) {
    return form.kind == Form::Kind::product ? std::vector<Form>(form.parts.begin() + 1, form.parts.end())
                                            : std::vector<Form>{};
  };
  const auto product = [](std::vector<Form> parts) {
    return parts.size() == 1 ? parts[0] : Form{Form::Kind::product, "", std::move(parts)};
  };
  const Form& above = quotient.parts[0];
  const bool numbered = first(above).kind == Form::Kind::number;
  const std::optional<std::string> digits =
      decimal(numbered ? first(above) : Form{Form::Kind::number, "1", {}}, first(quotient.parts[1]));
  if (!digits) return std::nullopt;
  std::vector<Form> top{{Form::Kind::number, *digits, {}}};
  const std::vector<Form> others = numbered                            ? rest(above)
                                   : above.kind == Form::Kind::product ? above.parts
                                                                       : std::vector{above};
  top.insert(top.end(), others.begin(), others.end());
  const std::vector<Form> bottom = rest(quotient.parts[1]);
  if (bottom.empty()) return product(std::move(top));
  return Form{Form::Kind::quotient, "", {product(std::move(top)), product(bottom)}};
}

std::string tex_call(const Form& form, const std::string& exponent) {
  if (form.text == "exp") return "\\mathrm{e}^{" + tex_of(form.parts[0]) + "}";
  if (form.text == "sqrt") {
    if (const Form* sized = sized_part(form)) return "\\left|" + tex_of(*sized) + "\\right|" + exponent;
    const std::string root = "\\sqrt{" + tex_of(form.parts[0]) + "}";
    return exponent.empty() ? root : "\\left(" + root + "\\right)" + exponent;
  }
  const Form& argument = form.parts[0];
  if (form.text == "sin" || form.text == "cos" || form.text == "tan")
    if (const std::optional<std::string> degrees = in_degrees(argument))
      return tex_function(form.text) + exponent + " " + *degrees;
  const bool bare = argument.kind == Form::Kind::name && form.parts.size() == 1;
  std::string call = tex_function(form.text) + exponent + (bare ? " " : "\\left(") + tex_of(argument);
  for (std::size_t i = 1; i < form.parts.size(); ++i) call += ", " + tex_of(form.parts[i]);
  return call + (bare ? "" : "\\right)");
}

}  // namespace

std::string tex_of(const Form& form) {
  switch (form.kind) {
    case Form::Kind::number:
      return form.text;
    case Form::Kind::name:
      return tex_name(form.text);
    case Form::Kind::negative:
      return "-" + bracketed(form.parts[0], is_compound(form.parts[0]));
    case Form::Kind::sum: {
      std::string sum = tex_of(form.parts[0]);
      for (std::size_t i = 1; i < form.parts.size(); ++i) {
        const Form& part = form.parts[i];
        const bool negative = part.kind == Form::Kind::negative;
        sum += negative ? " - " + bracketed(part.parts[0], is_compound(part.parts[0])) : " + " + tex_of(part);
      }
      return sum;
    }
    case Form::Kind::product: {
      std::string product;
      for (std::size_t i = 0; i < form.parts.size(); ++i) {
        const bool digits =
            form.parts[i].kind == Form::Kind::number ||
            (form.parts[i].kind == Form::Kind::power && form.parts[i].parts[0].kind == Form::Kind::number);
        product += (i == 0 ? "" : digits ? " \\cdot " : " ") + bracketed(form.parts[i], is_compound(form.parts[i]));
      }
      return product;
    }
    case Form::Kind::quotient:
      if (const std::optional<Form> plain = with_decimal(form)) return tex_of(*plain);
      return "\\frac{" + tex_of(form.parts[0]) + "}{" + tex_of(form.parts[1]) + "}";
    case Form::Kind::power: {
      const Form& base = form.parts[0];
      const std::string exponent = "^{" + std::to_string(form.exponent) + "}";
      if (base.kind == Form::Kind::call) return tex_call(base, exponent);
      return bracketed(base, base.kind != Form::Kind::number && base.kind != Form::Kind::name) + exponent;
    }
    case Form::Kind::call:
      break;
  }
  return tex_call(form, "");
}

}  // namespace poinsot::symbolic
