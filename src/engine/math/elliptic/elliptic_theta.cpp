#include "poinsot/engine/math/elliptic/elliptic_theta.h"

#include <numbers>

namespace poinsot {
namespace {

constexpr long double half_turn = std::numbers::pi_v<long double>;
constexpr int all_terms = 5;

// exp(-x), zero for an infinite x that stands for a vanished nome.
long double falling(long double x) { return std::isfinite(x) ? std::exp(-x) : 0; }

long double alternating(int n) { return n % 2 == 0 ? 1 : -1; }

}  // namespace

long double ThetaLattice::argument_rate() const {
  return half_turn / (2 * (trigonometric() ? real_half_period : imaginary_half_period));
}

long double ThetaLattice::nome() const {
  const long double ratio =
      trigonometric() ? imaginary_half_period / real_half_period : real_half_period / imaginary_half_period;
  return falling(half_turn * ratio);
}

ThetaSeries::ThetaSeries(Theta theta, const ThetaLattice& lattice, long double y, int sigma)
    : lattice_(lattice), nome_(lattice.nome()) {
  const long double K = lattice.real_half_period, K1 = lattice.imaginary_half_period;
  if (lattice.trigonometric()) {
    const bool even = theta == Theta::fourth;
    function_.even_ = even;
    const long double two_nu = half_turn * y / K;
    for (int n = 0; n < all_terms; ++n) {
      // The hyperbolic functions of the multiple of nu times the power of q, as exponentials of the whole exponent: q
      // may vanish and nu be infinite together. Odd multiples are divided by exp(nu).
      const int multiple = even ? 2 * n : 2 * n + 1;
      long double growing = n == 0 ? 1 : falling(half_turn / K * n * (even ? n * K1 - y : (n + 1) * K1 - y));
      if (even && n == 0) growing = 0.5L;
      // The decaying exponential over the growing one.
      const long double exponent = multiple == 0 ? 0 : multiple * two_nu, ratio = falling(exponent);
      const long double cosine_part = growing * (1 + ratio);
      const long double sine_part = sigma * growing * -std::expm1(-exponent);
      const long double sign = theta == Theta::second ? 1 : alternating(n);
      const auto i = static_cast<std::size_t>(n);
      if (theta == Theta::first) {
        function_.re_[i] = sign * sine_part;
        function_.im_[i] = sign * cosine_part;
      } else {
        function_.re_[i] = sign * cosine_part;
        function_.im_[i] = sign * sine_part;
      }
    }
  } else {
    const bool even = theta == Theta::second;
    function_.even_ = even;
    const long double Y = half_turn * y / (2 * K1);
    turn_per_cell_ = sigma * 2 * Y;
    // p^(n (n - 1)), p^(n^2), p^(n (n + 1)): each the one before times p^n.
    long double power = 1, low = 1;
    for (int n = 0; n < all_terms; ++n) {
      const int multiple = even ? 2 * n : 2 * n + 1;
      const long double c = std::cos(multiple * Y), s = sigma * std::sin(multiple * Y);
      const long double sign = theta == Theta::fourth ? 1 : alternating(n);
      // Of cosh and sinh of the multiple of X.
      long double a = sign * (theta == Theta::first ? s : c);
      long double b = sign * (theta == Theta::first ? c : -s);
      if (even && n == 0) a *= 0.5L;
      const auto i = static_cast<std::size_t>(n);
      const long double middle = low * power, high = middle * power;
      const long double large = even ? low : middle, small = even ? middle : high;
      low = high;
      power *= nome_;
      function_.re_[i] = large * a;
      function_.im_[i] = large * b;
      function_.re_small_[i] = small * a;
      function_.im_small_[i] = small * b;
    }
  }
}

ComplexValue<long double> ThetaSeries::at_zero() const {
  return ThetaArgument<long double>(lattice_).apply(0, [this](const auto& point) { return function_.at(point); });
}
ComplexValue<long double> ThetaSeries::at_end() const {
  if (lattice_.trigonometric()) return function_.at(TrigonometricPoint<long double>{0, 1});
  return function_.at(HyperbolicPoint<long double>{std::sqrt(nome_), nome_, 1, 1});
}

long double ThetaSeries::slope_at_zero() const { return slope(false); }
long double ThetaSeries::slope_at_end() const { return slope(true); }

long double ThetaSeries::slope(bool end) const {
  // Real and imaginary part and their derivatives by z or X, up to a common real factor.
  long double re = 0, im = 0, re_rate = 0, im_rate = 0;
  const ShiftedTheta<long double, 5>& f = function_;
  if (lattice_.trigonometric()) {
    for (int n = 0; n < all_terms; ++n) {
      const auto i = static_cast<std::size_t>(n);
      const int multiple = f.even_ ? 2 * n : 2 * n + 1;
      // At z = pi/2 the cosines of even multiples and the sines of odd ones alternate, the others vanish.
      const long double c = end ? (f.even_ ? alternating(n) : 0) : 1;
      const long double s = end ? (f.even_ ? 0 : alternating(n)) : 0;
      re += f.re_[i] * c;
      im += f.im_[i] * s;
      re_rate -= multiple * f.re_[i] * s;
      im_rate += multiple * f.im_[i] * c;
    }
  } else {
    // Growing powers go as exp(2 n X), decaying ones as exp(-2 n X), and a further exp(-2 X) where odd.
    const long double r = end ? 1 : nome_, D = end ? nome_ : 1;
    long double large = 1, small = f.even_ ? 1 : D;
    for (int n = 0; n < all_terms; ++n) {
      const auto i = static_cast<std::size_t>(n);
      const int small_multiple = f.even_ ? 2 * n : 2 * n + 2;
      re += f.re_[i] * large + f.re_small_[i] * small;
      im += f.im_[i] * large - f.im_small_[i] * small;
      re_rate += 2 * n * f.re_[i] * large - small_multiple * f.re_small_[i] * small;
      im_rate += 2 * n * f.im_[i] * large + small_multiple * f.im_small_[i] * small;
      large *= r;
      small *= D;
    }
  }
  return lattice_.argument_rate() * (re * im_rate - im * re_rate) / (re * re + im * im);
}

}  // namespace poinsot
