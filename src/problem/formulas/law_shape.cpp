#include "problem/formulas/law_shape.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "engine/solve/linear/decompositions.h"
#include "problem/language/unit_table.h"

namespace poinsot::problem {
namespace {

constexpr std::array all_terms{Term::angle, Term::sine, Term::cosine, Term::cosine_squared};
constexpr std::array independent{Factor::letter, Factor::half_sine, Factor::half_cosine, Factor::cosine};

constexpr int largest_divisor = 60;        // of a number that counts as a fraction
constexpr double largest_numerator = 1e4;  // so that what is near a fraction by chance is rare
// Of what is under a root or beside pi: there are two hundred thousand such numbers, so that two in a million others
// are as near to one of them.
constexpr double largest_numerator_known = 200;
constexpr double closest_known = 1e-10;

std::optional<Formula> fraction_near(double number, double tolerance, double largest) {
  for (int below = 1; below <= largest_divisor; ++below) {
    const double above = std::round(number * below);
    if (above != 0 && std::abs(above) < largest && std::abs(above / below - number) <= tolerance * std::abs(number))
      return Formula(static_cast<std::int64_t>(above)) / Formula(below);
  }
  return std::nullopt;
}

// The whole number under the root in sqrt(105)/16, and the divisor.
std::optional<std::pair<int, int>> root_over_whole(double number, double tolerance) {
  for (int below = 1; below <= largest_divisor; ++below) {
    const double square = number * number * below * below, whole = std::round(square);
    if (whole > 0 && whole < largest_numerator_known && std::abs(square - whole) <= 2 * tolerance * square)
      return std::pair{static_cast<int>(whole), below};
  }
  return std::nullopt;
}

Formula decimal(double number, int places) {
  char text[64];
  const auto end =
      std::to_chars(text, text + sizeof text, number, std::chars_format::scientific, std::min(places, 17)).ptr;
  return Formula::number(std::string(text, end));
}

}  // namespace

double number_of(Term term, double angle) {
  switch (term) {
    case Term::angle:
      return angle;
    case Term::sine:
      return std::sin(angle);
    case Term::cosine:
      return std::cos(angle);
    case Term::cosine_squared:
      return std::cos(angle) * std::cos(angle);
    case Term::none:
      break;
  }
  return 0;
}
Formula formula_of(Term term, const Formula& angle) {
  switch (term) {
    case Term::angle:
      return angle;
    case Term::sine:
      return sin(angle);
    case Term::cosine:
      return cos(angle);
    case Term::cosine_squared:
      return pow(cos(angle), 2);
    case Term::none:
      break;
  }
  return 0;
}

double number_of(Factor factor, double value) {
  switch (factor) {
    case Factor::half_sine:
      return std::sin(0.5 * value);
    case Factor::half_cosine:
      return std::cos(0.5 * value);
    case Factor::cosine:
      return std::cos(value);
    case Factor::sine:
      return std::sin(value);
    case Factor::letter:
      break;
  }
  return value;
}
Formula formula_of(Factor factor, const Formula& letter) {
  switch (factor) {
    case Factor::half_sine:
      return sin(letter / 2);
    case Factor::half_cosine:
      return cos(letter / 2);
    case Factor::cosine:
      return cos(letter);
    case Factor::sine:
      return sin(letter);
    case Factor::letter:
      break;
  }
  return letter;
}

Formula power_of(const Formula& base, int halves) {
  Formula whole = pow(base, halves / 2);
  if (halves % 2 == 0) return whole;
  return halves > 0 ? whole * sqrt(base) : whole / sqrt(base);
}

double LawShape::product_at(const LetterValues& letters) const {
  double result = 1;
  for (const Part& part : product)
    result *= std::pow(number_of(part.factor, letters.at(part.letter)), 0.5 * part.halves);
  return result;
}

std::optional<std::vector<LawShape::Part>> product_of(const std::string& letter, const AngleSamples& samples,
                                                      double tolerance) {
  const auto& [angles, numbers] = samples;
  const auto rows = static_cast<Eigen::Index>(angles.size());
  Eigen::MatrixXd matrix(rows, 1 + static_cast<Eigen::Index>(independent.size()));
  Eigen::VectorXd right(rows);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto k = static_cast<std::size_t>(row);
    if (!(numbers[k] / numbers.back() > 0)) return std::nullopt;
    right(row) = std::log(numbers[k] / numbers.back());
    matrix(row, 0) = 1;
    for (std::size_t f = 0; f < independent.size(); ++f) {
      const double base = number_of(independent[f], angles[k]);
      if (!(base > 0)) return std::nullopt;
      matrix(row, static_cast<Eigen::Index>(f) + 1) = std::log(base);
    }
  }
  const Eigen::VectorXd found = matrix.colPivHouseholderQr().solve(right);
  std::map<Factor, int> halves;
  for (std::size_t f = 0; f < independent.size(); ++f)
    halves[independent[f]] = static_cast<int>(std::lround(2 * found(static_cast<Eigen::Index>(f) + 1)));
  // sin(a/2) cos(a/2) is written as sin(a)/2.
  int &sine = halves[Factor::half_sine], &cosine = halves[Factor::half_cosine];
  if ((sine > 0) == (cosine > 0)) {
    const int common = sine > 0 ? std::min(sine, cosine) : std::max(sine, cosine);
    halves[Factor::sine] = common;
    sine -= common;
    cosine -= common;
  }
  std::vector<LawShape::Part> parts;
  for (const auto& [factor, exponent] : halves)
    if (exponent != 0) parts.push_back({letter, factor, exponent});
  for (std::size_t k = 0; k < angles.size(); ++k) {
    double ratio = numbers[k] / numbers.back();
    for (const LawShape::Part& part : parts)
      ratio *= std::pow(number_of(part.factor, angles.back()) / number_of(part.factor, angles[k]), 0.5 * part.halves);
    if (!(std::abs(ratio - 1) <= tolerance)) return std::nullopt;
  }
  return parts;
}

std::optional<Term> term_of(const AngleSamples& samples, double tolerance) {
  const auto& [angles, numbers] = samples;
  double size = 0;
  for (const double number : numbers) size = std::max(size, std::abs(number));
  for (const Term term : all_terms) {
    const double begin = number_of(term, angles.front());
    const double slope = (numbers.back() - numbers.front()) / (number_of(term, angles.back()) - begin);
    bool same = true;
    for (std::size_t k = 0; k < angles.size() && same; ++k)
      same = std::abs(numbers.front() + slope * (number_of(term, angles[k]) - begin) - numbers[k]) <= tolerance * size;
    if (same) return term;
  }
  return std::nullopt;
}

std::optional<Formula> simple_coefficient(double number, double tolerance) {
  const Formula gravity = Formula::number(std::string(standard_gravity_digits));
  for (const int power : {0, 1, 2, -1}) {
    const Formula factor = pow(gravity, power);
    if (const auto fraction = fraction_near(number / plain(factor), tolerance, largest_numerator))
      return factor * *fraction;
  }
  return std::nullopt;
}

std::optional<Formula> known_coefficient(double number, double tolerance) {
  if (auto simple = simple_coefficient(number, tolerance)) return simple;
  if (!(tolerance <= closest_known)) return std::nullopt;
  const Formula gravity = Formula::number(std::string(standard_gravity_digits));
  const Formula sign(number < 0 ? -1 : 1);
  for (const int of_pi : {0, 1, -1}) {
    const Formula beside = pow(Formula::pi(), of_pi);
    const double rest = std::abs(number) / plain(beside);
    for (const int of_gravity : {0, 1, -1}) {
      const Formula factor = pow(gravity, of_gravity);
      if (of_pi != 0)
        if (const auto fraction = fraction_near(rest / plain(factor), tolerance, largest_numerator_known))
          return sign * beside * factor * *fraction;
      if (const auto square = fraction_near(rest * rest / plain(factor), 2 * tolerance, largest_numerator_known))
        return sign * beside * sqrt(factor * *square);
      if (const auto root = root_over_whole(rest / std::sqrt(plain(factor)), tolerance))
        return sign * beside * sqrt(factor * Formula(root->first)) / Formula(root->second);
    }
  }
  return std::nullopt;
}

Formula rounded(double number, double largest, int digits) {
  if (number == 0) return {};
  const auto order = [](double x) { return static_cast<int>(std::floor(std::log10(std::abs(x)))); };
  const int places = digits - 1 - order(largest) + order(number);
  return places < 0 ? Formula() : decimal(number, places);
}

}  // namespace poinsot::problem
