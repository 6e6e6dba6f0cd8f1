#include "document/rounding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poinsot::document {
namespace {

// The power of ten of the first digit, after rounding to so many significant digits.
int leading_power(double number, int digits) {
  const std::string text = fmt::format("{:.{}e}", number, digits - 1);
  return std::stoi(text.substr(text.find('e') + 1));
}

// The text without zeros at the end of the decimals, and without the sign of a zero.
std::string trimmed(std::string text) {
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string with_exponent(double number, int decimals) {
  const std::string text = fmt::format("{:.{}e}", number, decimals);
  const std::size_t mark = text.find('e');
  return fmt::format("{}e{}", trimmed(text.substr(0, mark)), std::stoi(text.substr(mark + 1)));
}

// The number rounded to a multiple of 10^last, with an exponent.
std::string with_exponent_to_place(double number, int last, int digits) {
  const int decimals = leading_power(number, digits) - last;
  if (decimals >= 0) return with_exponent(number, decimals);
  if (std::abs(number) < 0.5 * std::pow(10.0, last)) return "0";
  return fmt::format("{}1e{}", number < 0 ? "-" : "", last);
}

// Whether numbers with this first digit are written without exponent.
bool plain(int power, int digits) { return power >= -4 && power < digits; }

// The place to which a set of numbers is rounded together.
struct CommonPlace {
  bool all_zero;
  bool finite;
  int leading;  // power of ten of the largest number's first digit
  int last;     // power of ten of its last digit
};

CommonPlace common_place(const std::vector<double>& numbers, int digits) {
  double largest = 0;
  bool finite = true;
  for (double number : numbers) {
    finite = finite && std::isfinite(number);
    largest = std::max(largest, std::abs(number));
  }
  if (!finite || largest == 0) return {largest == 0, finite, 0, 0};
  const int leading = leading_power(largest, digits);
  return {false, true, leading, leading - digits + 1};
}

}  // namespace

std::string rounded(double number, int digits) {
  if (number == 0) return "0";
  if (!std::isfinite(number)) return fmt::format("{}", number);
  const int power = leading_power(number, digits);
  if (plain(power, digits)) return trimmed(fmt::format("{:.{}f}", number, digits - 1 - power));
  return with_exponent(number, digits - 1);
}

std::vector<std::string> rounded_together(const std::vector<double>& components, int digits) {
  const CommonPlace place = common_place(components, digits);
  std::vector<std::string> texts;
  for (double component : components) {
    if (place.all_zero || component == 0) {
      texts.emplace_back("0");
    } else if (!place.finite) {
      texts.push_back(rounded(component, digits));
    } else if (plain(place.leading, digits)) {
      texts.push_back(trimmed(fmt::format("{:.{}f}", component, -place.last)));
    } else {
      texts.push_back(with_exponent_to_place(component, place.last, digits));
    }
  }
  return texts;
}

std::vector<std::string> rounded_column(const std::vector<double>& numbers, int digits) {
  const CommonPlace place = common_place(numbers, digits);
  // Rows differ as data do: a row that is small, and no rounding beside the others, has digits of its own.
  const double noise = std::pow(10.0, place.leading - 12);
  const auto is_noise = [&](double number) { return std::abs(number) < noise; };
  constexpr int fewest = 3;  // digits of the smallest, for which the rows still have the same decimals
  if (place.finite && !place.all_zero && std::ranges::any_of(numbers, [&](double number) {
        return !is_noise(number) && leading_power(number, digits) < place.last + fewest - 1;
      })) {
    std::vector<std::string> own;
    for (const double number : numbers) own.push_back(is_noise(number) ? "0" : rounded(number, digits));
    return own;
  }
  std::vector<std::string> texts = rounded_together(numbers, digits);
  if (!place.finite || place.all_zero || !plain(place.leading, digits)) return texts;
  std::size_t decimals = 0;
  for (const std::string& text : texts) {
    const std::size_t point = text.find('.');
    if (point != std::string::npos) decimals = std::max(decimals, text.size() - point - 1);
  }
  for (std::string& text : texts) {
    std::size_t point = text.find('.');
    if (point == std::string::npos && decimals > 0) {
      point = text.size();
      text += '.';
    }
    if (decimals > 0) text.append(decimals - (text.size() - point - 1), '0');
  }
  return texts;
}

std::string rounded_residual(double residual) {
  if (!std::isfinite(residual)) return "not formed";
  return residual == 0 ? "0" : with_exponent(residual, 0);
}

}  // namespace poinsot::document
