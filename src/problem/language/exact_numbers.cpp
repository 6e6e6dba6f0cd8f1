#include "problem/language/exact_numbers.h"

#include <cctype>
#include <cfenv>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "problem/language/unit_table.h"

namespace poinsot::problem {
namespace {

Formula decimal(double value) {
  char text[40];
  // The shortest digits that read back to the same double are those written in the table of units.
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return Formula::number(std::string_view(text, static_cast<std::size_t>(end - text)));
}

// The factor of a unit that is exact by definition (NIST SP 811).
Formula named_factor(const NamedUnit& unit) {
  const auto number = [](const char* digits) { return Formula::number(digits); };
  Formula foot = number("0.3048"), pound_mass = number("0.45359237"), pound = pound_mass * number("9.80665"),
          mile = number("1609.344");
  const std::string_view name = unit.name;
  if (name == "deg") return Formula::pi() / Formula(180);
  if (name == "rev" || name == "turn") return Formula(2) * Formula::pi();
  if (name == "rpm") return Formula::pi() / Formula(30);
  if (name == "knot") return number("1852") / Formula(3600);
  if (!unit.customary) return decimal(unit.factor);
  if (name == "ft") return foot;
  if (name == "in") return foot / Formula(12);
  if (name == "yd") return foot * Formula(3);
  if (name == "mi") return mile;
  if (name == "mph") return mile / Formula(3600);
  if (name == "lb") return pound;
  if (name == "oz") return pound / Formula(16);
  if (name == "kip") return pound * Formula(1000);
  if (name == "lbm") return pound_mass;
  if (name == "ozm") return pound_mass / Formula(16);
  if (name == "slug") return pound / foot;
  if (name == "slinch") return pound * Formula(12) / foot;
  if (name == "psi") return pound * Formula(144) / (foot * foot);
  if (name == "ksi") return pound * Formula(144000) / (foot * foot);
  if (name == "hp") return Formula(550) * foot * pound;
  return decimal(unit.factor);
}

// An exponent as units have it: a whole number, or a fraction in parentheses: 2, -1, (1/2).
struct Exponent {
  int numerator = 1, denominator = 1;
};
Exponent read_exponent(std::string_view text, std::size_t& at) {
  Exponent exponent;
  const bool bracket = text[at] == '(';
  if (bracket) ++at;
  const auto whole = [&] {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), value);
    at = static_cast<std::size_t>(end - text.data());
    return value;
  };
  exponent.numerator = whole();
  if (bracket && at < text.size() && text[at] == '/') {
    ++at;
    exponent.denominator = whole();
  }
  if (bracket) ++at;
  return exponent;
}

Formula power(const Formula& base, const Exponent& exponent) {
  if (exponent.denominator == 1) return pow(base, exponent.numerator);
  if (exponent.denominator == 2) return pow(sqrt(base), exponent.numerator);
  if (exponent.denominator == 4) return pow(sqrt(sqrt(base)), exponent.numerator);
  throw std::domain_error("a unit with such a root has no exact factor");
}

// The number of a literal, which stands before its blank: "5/8", "12.5", "1.5e-3".
Formula read_number(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return Formula::number(text);
  return Formula::number(text.substr(0, slash)) / Formula::number(text.substr(slash + 1));
}

}  // namespace

double rounded_datum(double value) {
  const int direction = std::fegetround();
  if (direction == FE_TONEAREST) return value;
  constexpr double binary_places = 1024;
  if (std::trunc(value * binary_places) == value * binary_places) return value;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return std::nextafter(value, direction == FE_UPWARD ? infinity : -infinity);
}

Formula exact_factor(const Unit& unit) {
  const std::string_view text = unit.text;
  Formula factor(1);
  bool inverse = false;
  // The text has been accepted as a unit before, so that no errors are looked for. Factors bind from left to right.
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '*' || text[at] == '/') {
      inverse = text[at++] == '/';
      continue;
    }
    if (text[at] == '1') {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && text[end] != '*' && text[end] != '/' && text[end] != '^') ++end;
    const NamedUnit* named = find_unit(text.substr(at, end - at));
    if (!named) throw std::domain_error("'" + unit.text + "' has no exact factor");
    Exponent exponent;
    at = end;
    if (at < text.size() && text[at] == '^') exponent = read_exponent(text, ++at);
    if (inverse) exponent.numerator = -exponent.numerator;
    factor *= power(named_factor(*named), exponent);
  }
  return factor;
}

Formula exact_value(const Number& number) {
  if (number.text.empty()) return Formula(number.value);
  const std::string_view text = number.text;
  const Formula value = read_number(text.substr(0, text.find(' ')));
  return number.has_unit ? value * exact_factor(number.unit) : value;
}

}  // namespace poinsot::problem
