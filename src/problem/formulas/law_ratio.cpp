#include "problem/formulas/law_ratio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/solve/linear/decompositions.h"
#include "poinsot/engine/math/formula/formula_exponential.h"
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

constexpr int digits_of_curve = 12;
constexpr int most_halves = 4;              // of the power of x before the function, times two
constexpr double simple_before_fit = 1e-6;  // of a coefficient: it is only taken if the numbers are then met
constexpr double least_within = 1e-3, most_within = 60;  // of what stands in the function in the middle of the samples
constexpr int steps_within = 48;                         // between these, in which a coefficient is looked for

// A function with its formula. Each is positive for small positive numbers.
struct Curve {
  double (*number)(double);
  Formula (*formula)(const Formula&);
};

Formula cosh_of(const Formula& x) { return (exp(x) + exp(-x)) / 2; }

const std::array curves{
    Curve{[](double x) { return std::log1p(x); }, [](const Formula& x) { return ln(1 + x); }},
    Curve{[](double x) { return -std::log1p(-x); }, [](const Formula& x) { return -ln(1 - x); }},
    Curve{[](double x) { return std::exp(-x); }, [](const Formula& x) { return exp(-x); }},
    Curve{[](double x) { return -std::expm1(-x); }, [](const Formula& x) { return 1 - exp(-x); }},
    Curve{[](double x) { return std::expm1(x); }, [](const Formula& x) { return exp(x) - 1; }},
    Curve{[](double x) { return std::sqrt(-std::expm1(-x)); }, [](const Formula& x) { return sqrt(1 - exp(-x)); }},
    Curve{[](double x) { return std::atan(x); }, [](const Formula& x) { return atan(x); }},
    Curve{[](double x) { return std::tanh(x); }, [](const Formula& x) { return (exp(2 * x) - 1) / (exp(2 * x) + 1); }},
    Curve{[](double x) { return std::atanh(x); }, [](const Formula& x) { return ln((1 + x) / (1 - x)) / 2; }},
    Curve{[](double x) { return x + std::log1p(std::expm1(-2 * x) / 2); },
          [](const Formula& x) { return ln(cosh_of(x)); }},
    // The time in which a body falls through a height: acosh(e^x).
    Curve{[](double x) { return x + std::log1p(std::sqrt(-std::expm1(-2 * x))); },
          [](const Formula& x) { return ln(exp(x) + sqrt(exp(2 * x) - 1)); }},
    Curve{[](double x) { return x + std::expm1(-x); }, [](const Formula& x) { return x - 1 + exp(-x); }},
    Curve{[](double x) { return x - std::log1p(x); }, [](const Formula& x) { return x - ln(1 + x); }},
    Curve{[](double x) { return -std::log1p(-x) - x; }, [](const Formula& x) { return -ln(1 - x) - x; }},
};

// A fraction, or the root of one, that is as close.
std::optional<Formula> simple_or_root(double number) {
  if (auto simple = simple_coefficient(number, simple_before_fit)) return simple;
  const auto square = simple_coefficient(number * number, 2 * simple_before_fit);
  return square ? std::optional(number < 0 ? -sqrt(*square) : sqrt(*square)) : std::nullopt;
}

class CurveFit {
 public:
  CurveFit(const Curve& curve, const RatioSamples& samples, int halves_within, int halves_before, double tolerance)
      : curve_(curve), tolerance_(tolerance) {
    for (std::size_t n = 0; n < samples.x.size(); ++n) {
      within_.push_back(std::pow(samples.x[n], 0.5 * halves_within));
      rest_.push_back(samples.numbers[n] / std::pow(samples.x[n], 0.5 * halves_before));
    }
    const auto [low, high] = std::minmax_element(within_.begin(), within_.end());
    middle_ = std::sqrt(*low * *high);
  }

  struct Coefficients {
    double within = 0, before = 0;
  };
  // Those with which the numbers are met.
  std::optional<Coefficients> coefficients() const {
    const double wanted = std::log(rest_.back() / rest_.front());
    const auto miss = [&](double order) {
      const double a = std::exp(order);
      return std::log(curve_.number(a * within_.back()) / curve_.number(a * within_.front())) - wanted;
    };
    const double begin = std::log(least_within / middle_), end = std::log(most_within / middle_);
    double before = begin, miss_before = miss(begin);
    for (int k = 1; k <= steps_within; ++k) {
      const double here = begin + (end - begin) * k / steps_within, miss_here = miss(here);
      if (std::isfinite(miss_before) && std::isfinite(miss_here) && (miss_before > 0) != (miss_here > 0)) {
        const double a = std::exp(between(miss, before, here));
        const Coefficients found{a, rest_.front() / curve_.number(a * within_.front())};
        if (meets(found)) return found;
      }
      before = here;
      miss_before = miss_here;
    }
    return std::nullopt;
  }

  bool meets(const Coefficients& coefficients) const {
    for (std::size_t n = 0; n < rest_.size(); ++n) {
      const double value = coefficients.before * curve_.number(coefficients.within * within_[n]);
      if (!(std::abs(value - rest_[n]) <= tolerance_ * std::abs(rest_[n]))) return false;
    }
    return true;
  }

 private:
  // Where what has two signs at the ends is zero.
  template <typename Function>
  static double between(const Function& f, double low, double high) {
    const bool rises = f(high) > 0;
    constexpr int halvings = 60;  // to the last place
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (low + high);
      ((f(middle) > 0) == rises ? high : low) = middle;
    }
    return 0.5 * (low + high);
  }

  const Curve& curve_;
  const double tolerance_;
  double middle_ = 1;  // of what the first coefficient is multiplied with
  std::vector<double> within_, rest_;
};

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

std::optional<RatioLaw> curve_law(const Formula& x, const RatioSamples& samples, double tolerance) {
  if (samples.x.empty()) return std::nullopt;
  const bool negative = samples.numbers.front() < 0;
  if (std::ranges::any_of(samples.numbers, [&](double one) { return one == 0 || (one < 0) != negative; }))
    return std::nullopt;
  for (const int halves_within : {2, 1, -2, -1})
    for (const Curve& curve : curves)
      for (int halves_before = -most_halves; halves_before <= most_halves; ++halves_before) {
        const CurveFit fit(curve, samples, halves_within, halves_before, tolerance);
        const auto found = fit.coefficients();
        if (!found) continue;
        const auto within = simple_or_root(found->within), before = simple_or_root(found->before);
        if (!within || !before || !fit.meets({plain(*within), plain(*before)})) continue;
        const Formula law = *before * power_of(x, halves_before) * curve.formula(*within * power_of(x, halves_within));
        return RatioLaw{law, digits_of_curve};
      }
  return std::nullopt;
}

}  // namespace poinsot::problem
