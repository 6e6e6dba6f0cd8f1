#include "poinsot/engine/motion/closed_form/symmetric_top.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/motion/closed_form/top_cubic.h"

namespace poinsot {
namespace {

using Real = long double;
using Complex = std::complex<Real>;
constexpr Real pi = std::numbers::pi_v<Real>;
constexpr double infinity = std::numeric_limits<double>::infinity();

void check(const TopParameters& parameters, const TopState& start) {
  const auto require = [](bool holds, const char* what, double value, const char* rule) {
    if (!holds) {
      throw std::invalid_argument(fmt::format("SymmetricTop: {} is {}; it must {}", what, value, rule));
    }
  };
  const auto finite = [&require](double value, const char* what) {
    require(std::isfinite(value), what, value, "be finite");
  };
  finite(parameters.gravity_moment, "the moment of the weight, m g c,");
  finite(start.nutation_rate, "the rate of nutation");
  finite(start.precession, "the angle of precession");
  finite(start.precession_rate, "the rate of precession");
  finite(start.spin, "the angle of spin");
  finite(start.axial_rate, "the angular velocity about the axis, w_z,");
  require(parameters.transverse_moment > 0 && std::isfinite(parameters.transverse_moment),
          "the transverse moment of inertia", parameters.transverse_moment, "be positive and finite");
  require(parameters.axial_moment >= 0 && std::isfinite(parameters.axial_moment), "the axial moment of inertia",
          parameters.axial_moment, "be finite and not negative");
  require(start.nutation >= 0 && start.nutation <= std::numbers::pi, "the angle of nutation", start.nutation,
          "lie between 0 and pi");
}

}  // namespace

SymmetricTop::SymmetricTop(const TopParameters& parameters, const TopState& start) : given_(start) {
  check(parameters, start);
  // The double nearest to pi means pi.
  const Real theta = start.nutation == std::numbers::pi ? pi : static_cast<Real>(start.nutation);
  const Real x = theta == pi ? -1 : std::cos(theta), sine = theta == pi ? 0 : std::sin(theta);
  const Real transverse = parameters.transverse_moment, axial = parameters.axial_moment;
  const Real weight = parameters.gravity_moment;
  const Real axial_rate = start.axial_rate, precession_rate = start.precession_rate;
  const Real nutation_rate = start.nutation_rate;
  vertical_momentum_ = static_cast<double>(transverse * precession_rate * sine * sine + axial * axial_rate * x);
  axial_momentum_ = static_cast<double>(axial * axial_rate);
  energy_ = static_cast<double>(
      (transverse * (nutation_rate * nutation_rate + precession_rate * precession_rate * sine * sine) +
       axial * axial_rate * axial_rate) /
          2 +
      weight * x);

  const Real spin_rate = axial_rate - precession_rate * x;
  inverted_ = weight < 0;
  if (inverted_) {
    start_ = {pi - theta,  -nutation_rate, start.precession + pi, precession_rate, -Real(start.spin) - pi,
              -axial_rate, -spin_rate};
  } else {
    start_ = {theta, nutation_rate, start.precession, precession_rate, start.spin, axial_rate, spin_rate};
  }
  const Real b = axial * start_.axial_rate / transverse;
  set_up({start_.nutation, start_.nutation_rate, start_.precession_rate, b, 2 * std::fabs(weight) / transverse});
}

void SymmetricTop::set_up(const TopCubicData& data) {
  const TopCubic cubic = solve_top_cubic(data);
  if (cubic.steady) {
    set_up_steady(cubic);
  } else {
    set_up_nutation(cubic, data);
  }
}

void SymmetricTop::set_up_steady(const TopCubic& cubic) {
  steady_ = true;
  curve_ = TopCurve::steady;
  nutation_range_ = {given_.nutation, given_.nutation};
  mean_precession_rate_ = static_cast<double>(start_.precession_rate);
  mean_spin_rate_ = static_cast<double>(inverted_ ? -start_.spin_rate : start_.spin_rate);
  period_ = cubic.stiffness > 0 ? static_cast<double>(2 * pi / std::sqrt(cubic.stiffness)) : infinity;

  const auto half = [](Half& h, Real size, Real angle, Real rate) {
    h.turns = Phase(rate / (2 * pi), angle / (2 * pi));
    h.rate = static_cast<double>(rate);
    h.start = {static_cast<double>(size), 0};
  };
  half(upper_, std::sqrt(cubic.below0 / 2), (start_.precession + start_.spin) / 2,
       (start_.precession_rate + start_.spin_rate) / 2);
  half(lower_, std::sqrt(cubic.above0 / 2), (start_.precession - start_.spin + pi) / 2,
       (start_.precession_rate - start_.spin_rate) / 2);
}

void SymmetricTop::set_up_nutation(const TopCubic& cubic, const TopCubicData& data) {
  const Real G = cubic.third, kappa = data.kappa;
  const Real above1 = cubic.above1, above2 = cubic.above2, below1 = cubic.below1, below2 = cubic.below2;
  const Real long_side = G + kappa * above1;   // kappa (x3 - x1)
  const Real short_side = G + kappa * above2;  // kappa (x3 - x2)
  parameter_ = {kappa * cubic.spread / long_side, short_side / long_side};
  jacobi_ = JacobiFunctions(parameter_);
  rate_ = std::sqrt(long_side) / 2;
  // a - b x at x1 and x2, and H_Z = H_z or -H_z where x reaches 1 or -1.
  const Real at_start = cubic.above0 * cubic.below0 * data.precession_rate;
  roots_ = {above1,
            above2,
            below1,
            below2,
            cubic.spread,
            data.b,
            at_start + data.b * cubic.to1,
            at_start - data.b * cubic.to2,
            cubic.difference == 0,
            cubic.sum == 0};
  const Real K = quarter_period_ = elliptic_complete_first(parameter_);
  const Real K1 = elliptic_complete_first(parameter_.complementary());
  endless_ = std::isinf(K);

  const Real sn2 = cubic.to1 / cubic.spread, cn2 = cubic.to2 / cubic.spread;
  initial_argument_ = std::sqrt(sn2) * carlson_rf(cn2, (G + kappa * cubic.above0) / long_side, Real(1));
  if (data.nutation_rate > 0) initial_argument_ = -initial_argument_;  // x is falling
  cells_ = CellPhase(rate_, initial_argument_, K);

  // The shifts.
  const Real sum = cubic.sum, difference = cubic.difference;
  const Real c2 = cubic.spread / below2, s2 = below1 / below2;
  const Real y1 = std::sqrt(s2) * carlson_rf(c2, c2 + parameter_.m * s2, Real(1));
  Real y2 = 0;
  if (short_side > 0) {
    const Real scale = above1 * short_side;
    y2 = std::sqrt(above2 * long_side / scale) * carlson_rf(G * cubic.spread / scale, cubic.spread / above1, Real(1));
  }
  const auto sense = [](Real momentum, Real shift) { return momentum > 0 ? 1 : momentum < 0 ? -1 : shift > 0 ? 1 : 0; };
  upper_.sense = sense(sum, y1);
  lower_.sense = sense(difference, y2);
  if (lower_.sense == 0) y2 = 0;
  upper_.side = upper_.sense;
  lower_.side = 1;
  const ThetaLattice lattice{K, K1};
  ThetaSeries upper(Theta::first, lattice, y1, upper_.sense);
  ThetaSeries lower(Theta::second, lattice, y2, lower_.sense);
  argument_ = ThetaArgument<double>(lattice);

  // Sizes: cos(theta/2) at u = K and sin(theta/2) at u = 0, on the common scale theta_4(z).
  const ThetaSeries scale(Theta::fourth, lattice, 0, 0);
  const auto size = [](const ComplexValue<Real>& v) { return std::hypot(v.re, v.im); };
  upper.scale(std::sqrt(below2 / 2) * size(scale.at_end()) / size(upper.at_end()));
  lower.scale(std::sqrt(above1 / 2) * size(scale.at_zero()) / size(lower.at_zero()));

  // Rates of (phi + psi)/2 at u = K and of (phi - psi)/2 at u = 0 less those of the theta functions' phases.
  const Real slip = start_.axial_rate - data.b;
  const Real upper_rate = (slip + sum / below2) / 2 - rate_ * upper.slope_at_end();
  const Real lower_rate = (-slip + difference / above1) / 2 - rate_ * lower.slope_at_zero();

  // The phases at the start: those that bring the halves and their rates to their values there.
  const auto value_and_slope = [&](const ThetaSeries& series, Real even_rate) {
    const auto with_slope = ThetaArgument<Real>(lattice).apply(
        initial_argument_, [&](const auto& point) { return series.function().with_slope(point); });
    const Complex value(with_slope.value.re, with_slope.value.im);
    const Complex slope = lattice.argument_rate() * rate_ * Complex(with_slope.slope.re, with_slope.slope.im) +
                          Complex(0, even_rate) * value;
    return std::pair(value, slope);
  };
  auto [upper_value, upper_slope] = value_and_slope(upper, upper_rate);
  auto [lower_value, lower_slope] = value_and_slope(lower, lower_rate);
  const Real scale_square = std::norm(upper_value) + std::norm(lower_value);
  const Real growth =
      (std::real(std::conj(upper_value) * upper_slope) + std::real(std::conj(lower_value) * lower_slope)) /
      scale_square;
  upper_slope -= growth * upper_value;
  lower_slope -= growth * lower_value;
  const Real half_cosine = std::sqrt(cubic.below0 / 2), half_sine = std::sqrt(cubic.above0 / 2);
  const Complex upper_start = std::polar(Real(1), (start_.precession + start_.spin) / 2);
  const Complex lower_start = std::polar(Real(1), (start_.precession - start_.spin + pi) / 2);
  const Complex upper_start_rate = upper_start * Complex(-half_sine * start_.nutation_rate / 2,
                                                         half_cosine * (start_.precession_rate + start_.spin_rate) / 2);
  const Complex lower_start_rate = lower_start * Complex(half_cosine * start_.nutation_rate / 2,
                                                         half_sine * (start_.precession_rate - start_.spin_rate) / 2);
  const auto complete = [&](Half& half, const ThetaSeries& series, Real even_rate, const Complex& fit,
                            const Complex& target) {
    half.turns = Phase(even_rate / (2 * pi), 0);
    half.rate = static_cast<double>(even_rate);
    half.cell_turns = Phase(series.turn_per_cell() / (2 * pi), 0);
    half.theta = ShiftedTheta<double, 4>(series.function());
    const Complex phase = fit / std::abs(fit);
    half.start = {static_cast<double>(phase.real()), static_cast<double>(phase.imag())};
    half.drift = endless_ ? 0 : static_cast<double>((half.sense * pi - series.turn_per_cell()) / (2 * K));
    // At a start on the vertical the theta function is at its jump: its angle is then that of the half as it goes on.
    half.offset =
        half.sense == 0 ? static_cast<double>(std::arg(target * std::conj(phase))) : angle(half, cells_.at(0));
  };
  const Real weight = 1 / (rate_ * rate_);
  complete(upper_, upper, upper_rate,
           std::conj(upper_value) * (half_cosine * upper_start) + weight * std::conj(upper_slope) * upper_start_rate,
           upper_start);
  complete(lower_, lower, lower_rate,
           std::conj(lower_value) * (half_sine * lower_start) + weight * std::conj(lower_slope) * lower_start_rate,
           lower_start);

  // Of the body as it is: turned over, the distances from top and bottom change places.
  const auto nutation = [this](Real above, Real below) {
    if (inverted_) std::swap(above, below);
    return static_cast<double>(2 * std::atan2(std::sqrt(above), std::sqrt(below)));
  };
  nutation_range_ = inverted_ ? Range{nutation(above1, below1), nutation(above2, below2)}
                              : Range{nutation(above2, below2), nutation(above1, below1)};
  Real upper_mean = upper_rate, lower_mean = lower_rate;
  period_ = infinity;
  if (!endless_) {
    const Real period = 2 * K / rate_;
    period_ = static_cast<double>(period);
    upper_mean += (upper_.sense * pi - upper.turn_per_cell()) / period;
    lower_mean += (lower_.sense * pi - lower.turn_per_cell()) / period;
  }
  mean_precession_rate_ = static_cast<double>(upper_mean + lower_mean);
  mean_spin_rate_ = static_cast<double>(inverted_ ? lower_mean - upper_mean : upper_mean - lower_mean);
  // A fast spin swallows the digits of that sum of two rates. Where its integrand is smooth, the mean rate of
  // precession is its mean at equal steps, right to exp(-samples).
  constexpr int samples = 64;  // which leave exp(-64)
  if (lattice.trigonometric() && pi * std::min(y1, y2) > K) {
    double total = 0;
    for (int i = 0; i < samples; ++i) {
      const double u = static_cast<double>(K) * (2.0 * i / samples - 1);
      total += axis_at({0, u}).precession_rate;
    }
    mean_precession_rate_ = total / samples;
  }
  curve_ = curve_of(cubic, data);
}

TopCurve SymmetricTop::curve_of(const TopCubic& cubic, const TopCubicData& data) const {
  constexpr Real rounding = 8 * std::numeric_limits<double>::epsilon();
  if (nutation_range_.maximum - nutation_range_.minimum <= rounding * nutation_range_.maximum) return TopCurve::steady;
  // The precession stops where a - b x = 0. On the vertical its rate tends to that of b/2 either way.
  const Real start = cubic.above0 * cubic.below0 * data.precession_rate;  // a - b x0
  const Real low = cubic.below1 > 0 ? roots_.low : -data.b;
  const Real high = cubic.above2 > 0 ? roots_.high : data.b;
  const Real low_size = std::fabs(start) + std::fabs(data.b) * cubic.to1;
  const Real high_size = std::fabs(start) + std::fabs(data.b) * cubic.to2;
  if (start == 0 && data.b == 0) return TopCurve::planar;
  if (std::fabs(low) <= rounding * low_size || std::fabs(high) <= rounding * high_size) return TopCurve::cusped;
  return (low < 0) == (high < 0) ? TopCurve::waved : TopCurve::looped;
}

}  // namespace poinsot
