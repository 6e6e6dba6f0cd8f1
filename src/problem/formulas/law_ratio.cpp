#include "problem/formulas/law_ratio.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/solve/linear/decompositions.h"
#include "problem/formulas/law_shape.h"

namespace poinsot::problem {
namespace {

constexpr int most_degree_of_ratio = 3;         // above and below
constexpr int most_degrees_of_ratio = 6;        // of both together, which leaves half as many points again to hold it
constexpr double vanishing_coefficient = 1e-6;  // of the largest, which decides on terms of which there are none
constexpr double fraction_before_fit = 1e-5;    // of a coefficient: it is only taken if the numbers are then met
constexpr int most_degrees_of_decimals = 2;     // with so many, coefficients need not be fractions
constexpr int digits_of_ratio = 12;

class RatioFit {
 public:
  RatioFit(const RatioSamples& samples, int power, double tolerance) : samples_(samples), tolerance_(tolerance) {
    for (const double x : samples.x) middle_ += std::log(x) / static_cast<double>(samples.x.size());
    middle_ = std::exp(middle_);
    for (const double number : samples.numbers) z_.push_back(std::pow(number, power));
  }

  // The coefficients of the polynomials above and below, in ascending powers of x.
  struct Quotient {
    std::vector<double> above, below;
  };

  // With these degrees; nothing if the numbers are not met.
  std::optional<Quotient> of_degrees(int above, int below) const {
    const auto rows = static_cast<Eigen::Index>(z_.size());
    Eigen::MatrixXd matrix(rows, above + below + 2);
    for (Eigen::Index row = 0; row < rows; ++row) {
      const auto n = static_cast<std::size_t>(row);
      const double t = samples_.x[n] / middle_, size = std::abs(z_[n]);
      for (int k = 0; k <= above; ++k) matrix(row, k) = std::pow(t, k) / size;
      for (int k = 0; k <= below; ++k) matrix(row, above + 1 + k) = -z_[n] * std::pow(t, k) / size;
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd solved = svd.matrixV().col(matrix.cols() - 1);
    const double largest = solved.cwiseAbs().maxCoeff();
    Quotient quotient;
    for (Eigen::Index k = 0; k < solved.size(); ++k) {
      const bool is_above = k <= above;
      const auto degree = static_cast<double>(is_above ? k : k - above - 1);
      const double coefficient =
          std::abs(solved(k)) < vanishing_coefficient * largest ? 0 : solved(k) / std::pow(middle_, degree);
      (is_above ? quotient.above : quotient.below).push_back(coefficient);
    }
    return meets(quotient) ? std::optional(quotient) : std::nullopt;
  }

  bool meets(const Quotient& quotient) const {
    for (std::size_t n = 0; n < z_.size(); ++n) {
      const double value = at(quotient.above, samples_.x[n]) / at(quotient.below, samples_.x[n]);
      if (!(std::abs(value - z_[n]) <= tolerance_ * std::abs(z_[n]))) return false;
    }
    return true;
  }

 private:
  static double at(const std::vector<double>& coefficients, double x) {
    double sum = 0;
    for (auto k = coefficients.rbegin(); k != coefficients.rend(); ++k) sum = sum * x + *k;
    return sum;
  }

  const RatioSamples& samples_;
  const double tolerance_;
  double middle_ = 0;  // of x
  std::vector<double> z_;
};

// The polynomial with coefficients over the given one.
struct Told {
  Formula polynomial;
  std::vector<double> coefficients;
  bool fractions = true;
};
Told told(const std::vector<double>& coefficients, double over, const Formula& x, int digits) {
  Told result;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    std::optional<Formula> one =
        coefficients[k] == 0 ? Formula() : simple_coefficient(coefficients[k] / over, fraction_before_fit);
    if (!one) {
      one = rounded(coefficients[k] / over, coefficients[k] / over, digits);
      result.fractions = false;
    }
    result.coefficients.push_back(plain(*one));
    result.polynomial += *one * pow(x, static_cast<int>(k));
  }
  return result;
}

}  // namespace

std::optional<RatioLaw> ratio_law(const Formula& x, const RatioSamples& samples, double tolerance) {
  if (samples.x.empty()) return std::nullopt;
  const bool negative = samples.numbers.front() < 0;
  for (const double number : samples.numbers)
    if (number == 0 || (number < 0) != negative) return std::nullopt;
  for (int degrees = 1; degrees <= most_degrees_of_ratio; ++degrees)
    for (const int power : {1, 2})
      for (int above = std::min(degrees, most_degree_of_ratio); above >= 0; --above) {
        const int below = degrees - above;
        if (below > most_degree_of_ratio) continue;
        const RatioFit fit(samples, power, tolerance);
        const auto quotient = fit.of_degrees(above, below);
        if (!quotient) continue;
        const int digits = std::min(digits_of_ratio, static_cast<int>(std::floor(-std::log10(tolerance))));
        // Over one of the coefficients the others may be fractions of smaller numbers than over another: of 81, 102 and
        // 32 over the last.
        std::vector<double> over;
        for (const std::vector<double>& side : {quotient->below, quotient->above})
          std::ranges::copy_if(side, std::back_inserter(over), [](double one) { return one != 0; });
        Told p = told(quotient->above, over.front(), x, digits + 1),
             q = told(quotient->below, over.front(), x, digits + 1);
        for (std::size_t k = 1; k < over.size() && !(p.fractions && q.fractions); ++k) {
          Told other_p = told(quotient->above, over[k], x, digits + 1),
               other_q = told(quotient->below, over[k], x, digits + 1);
          if (!(other_p.fractions && other_q.fractions && fit.meets({other_p.coefficients, other_q.coefficients})))
            continue;
          p = std::move(other_p);
          q = std::move(other_q);
        }
        if (!fit.meets({p.coefficients, q.coefficients})) continue;
        const bool fractions = p.fractions && q.fractions;
        if (!fractions && degrees > most_degrees_of_decimals) continue;
        RatioLaw law{p.polynomial / q.polynomial, fractions ? digits_of_ratio : digits};
        if (power == 2) law.formula = negative ? -sqrt(law.formula) : sqrt(law.formula);
        return law;
      }
  return std::nullopt;
}

}  // namespace poinsot::problem
