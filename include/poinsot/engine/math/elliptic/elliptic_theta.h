// Theta functions along lines parallel to the real axis, as series prepared once and summed in a few nanoseconds.
//
// With the half periods K (real) and i K' (imaginary) in the argument u, z = pi u / (2 K), tau = i K'/K and the nome
// q = exp(-pi K'/K), the values wanted are theta_j(z - i sigma nu | tau), nu = pi y / (2 K), for a shift y between 0
// and K', sigma = 1, -1 or 0 (C. G. J. Jacobi, Gesammelte Werke 1, 497; DLMF 20.2):
//
//   theta_1, theta_2   q^(n (n+1)) times sines, cosines of (2n + 1)(z - i sigma nu)
//   theta_4            q^(n^2) times cosines of 2n (z - i sigma nu)
//
// Where K' < K, Jacobi's imaginary transformation (DLMF 20.7.30-33) gives series in p = exp(-pi K/K'), of hyperbolic
// functions of X = pi u / (2 K') and circular ones of Y = pi y / (2 K'). Then p, or q before, is at most exp(-pi) =
// 0.043, and four terms reach the last place of a double, five that of a long double, for all |u| <= K and any ratio
// K/K' from zero to infinity.
//
// All functions on one lattice share the factors that are left out: the real factor exp(-z^2/(pi |tau|)) of the
// transformation, and exp(-|X|), which keeps sums from overflowing. Beyond the middle cell, |u| > K, the caller takes
// u to u - 2 K n: theta_1 and theta_2 change their sign n times, and in hyperbolic form the left-out linear phase turns
// the value by `turn_per_cell` n. Each function is given up to a constant factor, for which see `scale`; that of
// theta_1 is such that the value at u = 0 is real.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "poinsot/engine/math/algebra/sine_cosine.h"

namespace poinsot {

struct ThetaLattice {
  long double real_half_period = 1;       // K; infinite where the modulus is one
  long double imaginary_half_period = 1;  // K'; infinite where the modulus is zero

  bool trigonometric() const { return imaginary_half_period >= real_half_period; }
  // z or X at u = 1.
  long double argument_rate() const;
  // q or p.
  long double nome() const;
};

// The functions of u that the series are made of.
template <class Real>
struct TrigonometricPoint {
  Real cosine, sine;  // of z
};
template <class Real>
struct HyperbolicPoint {
  Real decay;         // exp(-|X|)
  Real decay_square;  // exp(-2 |X|)
  Real growth;        // p exp(2 |X|), at most one in the middle cell
  Real sign;          // of X
};
// X up to 350 in size, beyond which exp(-2 |X|) would lose digits.
template <class Real>
HyperbolicPoint<Real> hyperbolic_point(Real X, Real p) {
  const Real size = std::fabs(X) < Real(350) ? std::fabs(X) : Real(350);
  const Real decay = std::exp(-size);
  const Real square = decay * decay;
  return {decay, square, p / square, std::copysign(Real(1), X)};
}

template <class Real>
struct ComplexValue {
  Real re, im;
};

// Takes u to the point that the series on a lattice are summed at.
template <class Real>
class ThetaArgument {
 public:
  ThetaArgument() = default;
  explicit ThetaArgument(const ThetaLattice& lattice)
      : trigonometric_(lattice.trigonometric()),
        rate_(static_cast<Real>(lattice.argument_rate())),
        nome_(static_cast<Real>(lattice.nome())) {}

  // z or X at u = 1.
  Real rate() const { return rate_; }
  // f of the point of either kind.
  template <class Function>
  auto apply(Real u, Function f) const {
    if (trigonometric_) {
      const auto [s, c] = sine_cosine(rate_ * u);
      return f(TrigonometricPoint<Real>{c, s});
    }
    return f(hyperbolic_point(rate_ * u, nome_));
  }

 private:
  bool trigonometric_ = true;
  Real rate_ = 1, nome_ = 0;
};

enum class Theta { first, second, fourth };

template <class Real, int terms>
class ShiftedTheta {
 public:
  ShiftedTheta() = default;
  // The same series in another precision, cut to fewer terms.
  template <class Other, int other_terms>
  explicit ShiftedTheta(const ShiftedTheta<Other, other_terms>& other) : even_(other.even_) {
    static_assert(terms <= other_terms);
    for (std::size_t n = 0; n < terms; ++n) {
      re_[n] = static_cast<Real>(other.re_[n]);
      im_[n] = static_cast<Real>(other.im_[n]);
      re_small_[n] = static_cast<Real>(other.re_small_[n]);
      im_small_[n] = static_cast<Real>(other.im_small_[n]);
    }
  }

  ComplexValue<Real> at(const TrigonometricPoint<Real>& point) const {
    // cos and sin of even or odd multiples of z by their recurrence with 2 cos 2z.
    const Real& c = point.cosine;
    const Real& s = point.sine;
    const Real double_cosine = (c - s) * (c + s);
    const Real twice = double_cosine + double_cosine;
    Real c0 = even_ ? Real(1) : c, c1 = even_ ? double_cosine : c;  // this term's and the one before
    Real s0 = even_ ? Real(0) : s, s1 = even_ ? -2 * s * c : -s;
    ComplexValue<Real> sum{re_[0] * c0, im_[0] * s0};
    for (std::size_t n = 1; n < terms; ++n) {
      const Real c2 = twice * c0 - c1, s2 = twice * s0 - s1;
      c1 = c0, s1 = s0;
      c0 = c2, s0 = s2;
      sum.re += re_[n] * c0;
      sum.im += im_[n] * s0;
    }
    return sum;
  }
  ComplexValue<Real> at(const HyperbolicPoint<Real>& point) const {
    const Real r = point.growth, D = point.decay_square;
    Real re = re_[terms - 1], im = im_[terms - 1];
    Real re_small = re_small_[terms - 1], im_small = im_small_[terms - 1];
    for (std::size_t n = terms - 1; n-- > 0;) {
      re = re * r + re_[n];
      im = im * r + im_[n];
      re_small = re_small * D + re_small_[n];
      im_small = im_small * D + im_small_[n];
    }
    const Real factor = even_ ? point.decay : Real(1);
    const Real small_factor = even_ ? point.decay : D;
    return {factor * re + small_factor * re_small, point.sign * (factor * im - small_factor * im_small)};
  }

  // The value and its derivative by z, or by X with exp(-|X|) differentiated along: the same for all functions on the
  // lattice.
  struct WithSlope {
    ComplexValue<Real> value, slope;
  };
  WithSlope with_slope(const TrigonometricPoint<Real>& point) const {
    const Real c = point.cosine, s = point.sine;
    const Real double_cosine = (c - s) * (c + s);
    const Real twice = double_cosine + double_cosine;
    Real c0 = even_ ? Real(1) : c, c1 = even_ ? double_cosine : c;
    Real s0 = even_ ? Real(0) : s, s1 = even_ ? -2 * s * c : -s;
    WithSlope sum{};
    for (std::size_t n = 0; n < terms; ++n) {
      const Real multiple = static_cast<Real>(even_ ? 2 * n : 2 * n + 1);
      sum.value.re += re_[n] * c0;
      sum.value.im += im_[n] * s0;
      sum.slope.re -= multiple * re_[n] * s0;
      sum.slope.im += multiple * im_[n] * c0;
      const Real c2 = twice * c0 - c1, s2 = twice * s0 - s1;
      c1 = c0, s1 = s0;
      c0 = c2, s0 = s2;
    }
    return sum;
  }
  WithSlope with_slope(const HyperbolicPoint<Real>& point) const {
    // exp(-|X|) times powers of exp(2 |X|): the n-th grows as exp((2 n - 1)|X|) if even, exp(2 n |X|) if odd.
    Real large = even_ ? point.decay : Real(1), small = even_ ? point.decay : point.decay_square;
    WithSlope sum{};
    for (std::size_t n = 0; n < terms; ++n) {
      const Real twice = static_cast<Real>(2 * n);
      const Real growth = even_ ? twice - 1 : twice, decay = even_ ? twice + 1 : twice + 2;
      sum.value.re += re_[n] * large + re_small_[n] * small;
      sum.value.im += point.sign * (im_[n] * large - im_small_[n] * small);
      sum.slope.re += point.sign * (growth * re_[n] * large - decay * re_small_[n] * small);
      sum.slope.im += growth * im_[n] * large + decay * im_small_[n] * small;
      large *= point.growth;
      small *= point.decay_square;
    }
    return sum;
  }

  // Multiplies the function by a number.
  void scale(Real factor) {
    for (std::size_t n = 0; n < terms; ++n) {
      re_[n] *= factor;
      im_[n] *= factor;
      re_small_[n] *= factor;
      im_small_[n] *= factor;
    }
  }

 private:
  template <class Other, int other_terms>
  friend class ShiftedTheta;
  friend class ThetaSeries;

  bool even_ = false;
  // Trigonometric: coefficients of cosines and sines. Hyperbolic: of growing and decaying powers, real and imaginary.
  std::array<Real, terms> re_{}, im_{}, re_small_{}, im_small_{};
};

// A shifted theta function at full precision, to read off its constants and to make the double one from.
class ThetaSeries {
 public:
  // y: the shift, from 0 to K'. sigma: its sense, 1, -1, or 0 for no shift.
  ThetaSeries(Theta theta, const ThetaLattice& lattice, long double y, int sigma);

  const ShiftedTheta<long double, 5>& function() const { return function_; }
  void scale(long double factor) { function_.scale(factor); }

  ComplexValue<long double> at_zero() const;  // u = 0
  ComplexValue<long double> at_end() const;   // u = K
  // d(arg)/du, the left-out linear phase not counted.
  long double slope_at_zero() const;
  long double slope_at_end() const;
  // rad, in hyperbolic form, by which the left-out linear phase turns the value from one cell to the next; else zero.
  long double turn_per_cell() const { return turn_per_cell_; }

 private:
  long double slope(bool end) const;

  ThetaLattice lattice_;
  ShiftedTheta<long double, 5> function_;
  long double nome_ = 0;
  long double turn_per_cell_ = 0;
};

}  // namespace poinsot
