#include "poinsot/engine/math/elliptic/elliptic_functions.h"

#include <cmath>
#include <numbers>

#include "poinsot/engine/math/algebra/sine_cosine.h"

namespace poinsot {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

}  // namespace

JacobiFunctions::JacobiFunctions(const EllipticParameter<long double>& parameter)
    : K_(elliptic_complete_first(parameter)), K1_(elliptic_complete_first(parameter.complementary())) {
  trigonometric_ = K1_ >= K_;
  rate_ = static_cast<double>(pi / (2 * (trigonometric_ ? K_ : K1_)));
  const long double exponent = pi * (trigonometric_ ? K1_ / K_ : K_ / K1_);
  const long double p = std::isinf(exponent) ? 0 : std::exp(-exponent);
  const long double p2 = p * p, p4 = p2 * p2;
  p_ = static_cast<double>(p);
  p2_ = static_cast<double>(p2);
  p4_ = static_cast<double>(p4);
  p6_ = static_cast<double>(p4 * p2);
  p9_ = static_cast<double>(p4 * p4 * p);
  p12_ = static_cast<double>(p4 * p4 * p4);
  period_high_ = static_cast<double>(2 * K_);
  period_low_ = std::isfinite(period_high_) ? static_cast<double>(2 * K_ - static_cast<long double>(period_high_)) : 0;

  // theta_2, theta_3, theta_4 at zero, theta_2 without its factor 2 p^(1/4).
  const long double two = 1 + p2 + p4 * p2 + p4 * p4 * p4;
  const long double even = 1 + 2 * p4 + 2 * p4 * p4 * p4 * p4, odd = 2 * p + 2 * p4 * p4 * p;
  const long double three = even + odd, four = even - odd;
  if (trigonometric_) {
    // sn(K) = 1, cn(0) = 1, dn(0) = 1
    sn_factor_ = static_cast<double>(three / two);
    cn_factor_ = static_cast<double>(four / two);
    dn_factor_ = static_cast<double>(four / three);
  } else {
    // The transformation takes theta_3(0)/theta_2(0), the factor of sn, to theta_3(0)/theta_4(0) of the complementary
    // nome, and so on. The sums of hyperbolic functions below are doubled.
    sn_factor_ = static_cast<double>(three / four);
    cn_factor_ = static_cast<double>(2 * two / four);
    dn_factor_ = static_cast<double>(2 * two / three);
  }
}

JacobiFunctions::Values JacobiFunctions::in_middle_cell(double u) const {
  if (trigonometric_) {
    const auto [s, c] = sine_cosine(rate_ * u);
    // Multiples of z by recurrence: sin and cos of z, 2z, ... 7z.
    const double c2 = (c - s) * (c + s), twice = c2 + c2;
    const double c4 = twice * c2 - 1, c6 = twice * c4 - c2;
    const double s3 = (twice + 1) * s, s5 = twice * s3 - s, s7 = twice * s5 - s3;
    const double c3 = (twice - 1) * c, c5 = twice * c3 - c, c7 = twice * c5 - c3;
    const double even = 1 + 2 * p4_ * c4, odd = 2 * p_ * c2 + 2 * p9_ * c6;
    const double inverse = 1 / (even - odd);
    return {sn_factor_ * inverse * (s - p2_ * s3 + p6_ * s5 - p12_ * s7),
            cn_factor_ * inverse * (c + p2_ * c3 + p6_ * c5 + p12_ * c7), dn_factor_ * inverse * (even + odd)};
  }
  // Hyperbolic functions times 2 exp(-|X|), through D = exp(-2 |X|) and r = p exp(2 |X|) <= 1.
  const double X = rate_ * std::fabs(u);
  const double size = X < 350 ? X : 350;
  const double decay = std::exp(-size);
  const double D = decay * decay, r = p_ / D;
  const double rr = r * r;
  const double D2 = D * D, D3 = D2 * D;
  // All terms of the sines share the factor 1 - D, taken to its own last place.
  const double small = -std::expm1(-2 * size);
  const double sum3 = 1 + D + D2, sum5 = sum3 + D3 * (1 + D);
  const double sines = small * (1 - p_ * r * sum3 + p4_ * rr * sum5 - p9_ * rr * r * sum3);
  const double cosines = 1 + D + p_ * (r + p_ * D2) + p4_ * (rr + p2_ * D3) + p9_ * rr * r;
  const double even = 1 + p2_ * (rr + p2_ * D2) + p12_ * rr * rr, odd = r + p_ * D + p6_ * (rr * r + p_ * p2_ * D3);
  const double inverse = 1 / cosines;
  return {std::copysign(sn_factor_ * inverse * sines, u), cn_factor_ * inverse * decay * (even - odd),
          dn_factor_ * inverse * decay * (even + odd)};
}

JacobiFunctions::Reduced JacobiFunctions::reduced(double u) const {
  if (!(std::fabs(u) > 0.5 * period_high_)) return {u, 0};
  const double n = std::nearbyint(u / period_high_);
  return {std::fma(-n, period_high_, u) - n * period_low_, n};
}

JacobiFunctions::Values JacobiFunctions::at(double u) const {
  const auto [rest, n] = reduced(u);
  const Values values = in_middle_cell(rest);
  const bool odd = std::fmod(n, 2.0) != 0;
  return odd ? Values{-values.sn, -values.cn, values.dn} : values;
}

double JacobiFunctions::amplitude(double u) const {
  const auto [rest, n] = reduced(u);
  const Values values = in_middle_cell(rest);
  return std::atan2(values.sn, values.cn) + static_cast<double>(pi) * n;
}

}  // namespace poinsot
