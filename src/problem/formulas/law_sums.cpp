#include "problem/formulas/law_sums.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/solve/linear/decompositions.h"
#include "poinsot/engine/work/work.h"
#include "problem/formulas/formula_answers.h"

namespace poinsot::problem {
namespace {

constexpr int most_whole = 2;                // of an exponent in a product
constexpr int most_degree = 6;               // of a product, all exponents together
constexpr std::size_t most_sum_letters = 6;  // with more there are too many products
constexpr std::size_t most_products = 160;
constexpr std::size_t most_products_of_three = 60;  // among which sums of three are sought
constexpr double parallel = 1e-5;                   // part of a product that others must leave of it
constexpr int sum_digits = 12, least_sum_digits = 6;
constexpr int told_simple = 9;  // digits in which a coefficient is a fraction, or is none

// A product of powers of letters and of functions of angles, times a power of the number itself.
struct Product {
  std::vector<LawShape::Part> parts;
  int of_number = 0;
  int cost = 0;
};

double product_value(const Product& product, const LetterValues& letters, double number) {
  return LawShape{product.parts, Term::none, ""}.product_at(letters) * std::pow(number, product.of_number);
}

// Products of powers of the letters that have a dimension in the units, simple ones first.
class Products {
 public:
  Products(const std::vector<Letter>& letters, const std::vector<Units>& units) : units_(units) {
    for (const Letter& letter : letters)
      (letter.unit.dimension == dimensions::angle ? angles_ : sizes_).push_back(letter);
  }

  std::vector<Product> of(const Dimension& dimension, int times, bool halves) {
    found_.clear();
    std::vector<double> rest;
    for (const Units units : units_) rest.push_back(times * exponent_of(dimension, units));
    step_ = halves ? 1 : 2;
    grow(0, {}, rest, 0);
    with_angles();
    std::ranges::stable_sort(found_, {}, &Product::cost);
    if (found_.size() > most_products) found_.resize(most_products);
    return found_;
  }

 private:
  void grow(std::size_t k, const Product& draft, const std::vector<double>& rest, int degree) {
    if (k == sizes_.size()) {
      if (std::ranges::all_of(rest, [](double x) { return std::abs(x) < 1e-9; })) found_.push_back(draft);
      return;
    }
    for (int half = -2 * most_whole; half <= 2 * most_whole; half += step_) {
      if (degree + std::abs(half) > 2 * most_degree) continue;
      Product longer = draft;
      std::vector<double> left = rest;
      if (half != 0) {
        longer.parts.push_back({sizes_[k].name, Factor::letter, half});
        longer.cost += 4 + std::abs(half) + (half % 2 == 0 ? 0 : 6);
        for (std::size_t u = 0; u < units_.size(); ++u)
          left[u] -= 0.5 * half * exponent_of(sizes_[k].unit.dimension, units_[u]);
      }
      grow(k + 1, longer, left, degree + std::abs(half));
    }
  }
  void with_angles() {
    for (const Letter& angle : angles_) {
      const std::vector<Product> without = found_;
      for (const Product& product : without)
        for (const auto& [factor, halves] :
             {std::pair(Factor::sine, 2), {Factor::cosine, 2}, {Factor::cosine, 4}, {Factor::sine, 4}}) {
          found_.push_back(product);
          found_.back().parts.push_back({angle.name, factor, halves});
          found_.back().cost += 6 + halves;
        }
    }
  }

  const std::vector<Units>& units_;
  std::vector<Letter> sizes_, angles_;
  std::vector<Product> found_;
  int step_ = 2;
};

// The first few products of which ones are a combination: sum of c_i P_i = 1, where P_i are over what they add up to.
class Combination {
 public:
  Combination(const std::vector<Product>& products, const SumSamples& samples, int power, double tolerance)
      : products_(products), tolerance_(tolerance) {
    const auto rows = static_cast<Eigen::Index>(samples.numbers.size());
    matrix_.resize(rows, static_cast<Eigen::Index>(products.size()));
    for (Eigen::Index row = 0; row < rows; ++row) {
      const auto n = static_cast<std::size_t>(row);
      for (std::size_t k = 0; k < products.size(); ++k)
        matrix_(row, static_cast<Eigen::Index>(k)) =
            product_value(products[k], samples.letters[n], samples.numbers[n]) / std::pow(samples.numbers[n], power);
    }
    unit_ = matrix_;
    for (Eigen::Index k = 0; k < unit_.cols(); ++k) unit_.col(k).normalize();
  }

  // Of up to `most` products, nothing if there is none.
  std::optional<std::vector<std::size_t>> find(int most) {
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(unit_.rows());
    for (int count = 1; count <= most; ++count) {
      chosen_.clear();
      if (search(unit_, ones, 0, count)) return chosen_;
    }
    return std::nullopt;
  }

  // The coefficients, and the relative error of each.
  struct Coefficients {
    std::vector<double> value, error;
    double misfit = 0;
  };
  Coefficients coefficients(const std::vector<std::size_t>& chosen) const {
    Eigen::MatrixXd part(matrix_.rows(), static_cast<Eigen::Index>(chosen.size()));
    for (std::size_t k = 0; k < chosen.size(); ++k)
      part.col(static_cast<Eigen::Index>(k)) = matrix_.col(static_cast<Eigen::Index>(chosen[k]));
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(matrix_.rows());
    const Eigen::VectorXd solved = part.colPivHouseholderQr().solve(ones);
    const Eigen::MatrixXd spread = (part.transpose() * part).inverse();
    Coefficients result;
    result.misfit = (part * solved - ones).cwiseAbs().maxCoeff();
    for (Eigen::Index k = 0; k < solved.size(); ++k) {
      result.value.push_back(solved(k));
      result.error.push_back(std::sqrt(std::abs(spread(k, k))) / std::abs(solved(k)));
    }
    return result;
  }

 private:
  bool search(const Eigen::MatrixXd& columns, const Eigen::VectorXd& rest, std::size_t next, int count) {
    const double goal = tolerance_ * std::sqrt(static_cast<double>(rest.size()));
    const std::size_t end = count + static_cast<int>(chosen_.size()) >= 3
                                ? std::min(products_.size(), most_products_of_three)
                                : products_.size();
    for (std::size_t k = next; k < end; ++k) {
      const Eigen::VectorXd column = columns.col(static_cast<Eigen::Index>(k));
      const double norm = column.norm();
      if (norm < parallel) continue;
      const Eigen::VectorXd along = column / norm;
      const Eigen::VectorXd left = rest - along.dot(rest) * along;
      chosen_.push_back(k);
      if (count == 1) {
        if (left.norm() <= goal) return true;
      } else {
        count_work(static_cast<Work>(columns.size()) / 8);
        const Eigen::MatrixXd others = columns - along * (along.transpose() * columns);
        if (search(others, left, k + 1, count - 1)) return true;
      }
      chosen_.pop_back();
    }
    return false;
  }

  const std::vector<Product>& products_;
  const double tolerance_;
  Eigen::MatrixXd matrix_, unit_;
  std::vector<std::size_t> chosen_;
};

class SumSearch {
 public:
  SumSearch(const std::vector<Letter>& letters, const Dimension& dimension, const std::vector<Units>& units,
            const SumSamples& samples, double tolerance, double error)
      : letters_(letters),
        dimension_(dimension),
        samples_(samples),
        tolerance_(tolerance),
        error_(error),
        products_(letters, units) {}

  std::optional<SumLaw> run() {
    const std::vector<Product> of_it = products_.of(dimension_, 1, true),
                               of_square = products_.of(dimension_, 2, false);
    std::vector<Product> whole;
    for (const Product& product : of_it)
      if (std::ranges::all_of(product.parts, [](const LawShape::Part& part) { return part.halves % 2 == 0; }))
        whole.push_back(product);
    // The number may stand in its own equation: y^2 = a P y + b Q, and as y (1 + a R) = b P with R without dimension.
    const std::vector<Product> without = products_.of(dimensions::none, 1, false);
    const std::vector<Product> quadratic = together(of_square, whole, 1);
    const std::vector<Product> over_sum = together(whole, without, 1),
                               square_over_sum = together(of_square, without, 2);
    if (auto law = as(of_it, 1, 2)) return law;
    if (auto law = as(of_square, 2, 2)) return law;
    if (auto law = as(products_.of(dimension_, -2, false), -2, 2)) return law;
    if (auto law = as(whole, 1, 3)) return law;
    if (auto law = as(of_square, 2, 3)) return law;
    if (auto law = as(quadratic, 2, 3)) return law;
    if (auto law = as(over_sum, 1, 3)) return law;
    return as(square_over_sum, 2, 3);
  }

 private:
  static double within(int digits) { return 3 * std::pow(10.0, -digits); }
  // The products, and others times a power of the number itself; simple ones first.
  static std::vector<Product> together(std::vector<Product> all, const std::vector<Product>& others, int of_number) {
    for (Product product : others) {
      if (product.parts.empty()) continue;
      product.of_number = of_number;
      product.cost += 4;
      all.push_back(std::move(product));
    }
    std::ranges::stable_sort(all, {}, &Product::cost);
    if (all.size() > most_products_of_three) all.resize(most_products_of_three);
    return all;
  }

  static bool known(const std::optional<Formula>& one) { return one.has_value(); }

  // Where the coefficients are no fractions of small numbers, they may be so over one of them, as 1, 34/27 and 32/81
  // are over the second: 27/34, 1 and 16/51.
  static void take_over_another(const std::vector<double>& coefficients, const std::vector<int>& digits,
                                std::vector<std::optional<Formula>>& exact) {
    const double tolerance = 2 * within(std::ranges::min(digits));
    for (const double over : coefficients) {
      const std::optional<Formula> one = simple_coefficient(1 / over, tolerance);
      if (!one) continue;
      std::vector<std::optional<Formula>> all;
      for (const double coefficient : coefficients) {
        all.push_back(simple_coefficient(coefficient / over, tolerance));
        if (all.back()) *all.back() /= *one;
      }
      if (!std::ranges::all_of(all, known)) continue;
      exact = std::move(all);
      return;
    }
  }

  std::optional<SumLaw> as(const std::vector<Product>& products, int power, int most) const {
    if (products.empty()) return std::nullopt;
    Combination combination(products, samples_, power, tolerance_);
    const auto chosen = combination.find(most);
    if (!chosen) return std::nullopt;
    const Combination::Coefficients found = combination.coefficients(*chosen);
    // Numbers such as (2 pi)^2 are left before a root; what is in it has then often fractions.
    double outside = 1;
    const bool root =
        power != 1 && std::ranges::none_of(*chosen, [&](std::size_t k) { return products[k].of_number == 1; });
    for (std::size_t k = 0; root && outside == 1 && k < chosen->size(); ++k)
      if (products[(*chosen)[k]].of_number == 0 && !simple_coefficient(found.value[k], within(told_simple)))
        outside = std::abs(found.value[k]);
    SumLaw law;
    law.digits = sum_digits;
    std::vector<double> coefficients;
    std::vector<int> digits;
    std::vector<std::optional<Formula>> exact;
    for (std::size_t k = 0; k < chosen->size(); ++k) {
      const double error = std::max({found.misfit, error_, 1e-15}) * std::max(1.0, found.error[k]);
      digits.push_back(std::min(sum_digits, static_cast<int>(std::floor(-std::log10(error)))));
      if (digits.back() < least_sum_digits) return std::nullopt;
      coefficients.push_back(found.value[k] / (products[(*chosen)[k]].of_number == 0 ? outside : 1));
      exact.push_back(known_coefficient(coefficients.back(), within(digits.back())));
    }
    if (outside == 1 && !std::ranges::all_of(exact, known)) take_over_another(coefficients, digits, exact);
    Formula sum, linear, below(1);
    for (std::size_t k = 0; k < chosen->size(); ++k) {
      const Product& product = products[(*chosen)[k]];
      if (!exact[k] || outside != 1) law.digits = std::min(law.digits, digits[k]);
      Formula term = exact[k].value_or(rounded(coefficients[k], coefficients[k], digits[k]));
      for (const LawShape::Part& part : product.parts)
        term *= power_of(formula_of(part.factor, letter(part.letter)), part.halves);
      if (product.of_number == 0)
        sum += term;
      else if (product.of_number == power)
        below -= term;
      else
        linear += term;
    }
    sum /= below;
    linear /= below;
    if (!linear.is_zero()) {
      // The root of the quadratic equation on whose side the number is.
      const Formula difference = sqrt(linear * linear + Formula(4) * sum), half = Formula(1) / Formula(2);
      const double above = value_at((linear + difference) * half, samples_.letters.front());
      const bool upper = std::abs(above / samples_.numbers.front() - 1) < 1e-3;
      law.formula = (upper ? linear + difference : linear - difference) * half;
      return law;
    }
    law.formula = power == 1 ? sum : power == 2 ? sqrt(sum) : Formula(1) / sqrt(sum);
    if (outside != 1) {
      const double before = std::pow(outside, 1.0 / power);
      law.formula *= known_coefficient(before, within(law.digits)).value_or(rounded(before, before, law.digits));
    }
    if (power != 1 && samples_.numbers.front() < 0) law.formula = -law.formula;
    return law;
  }
  Formula letter(const std::string& name) const {
    return formula_of(*std::ranges::find(letters_, name, &Letter::name)).number;
  }

  const std::vector<Letter>& letters_;
  const Dimension dimension_;
  const SumSamples& samples_;
  const double tolerance_, error_;
  Products products_;
};

}  // namespace

std::optional<SumLaw> sum_law(const std::vector<Letter>& letters, const Dimension& dimension,
                              const std::vector<Units>& units, const SumSamples& samples, double tolerance,
                              double error) {
  if (letters.size() > most_sum_letters || samples.numbers.empty()) return std::nullopt;
  try {
    return SumSearch(letters, dimension, units, samples, tolerance, error).run();
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

}  // namespace poinsot::problem
