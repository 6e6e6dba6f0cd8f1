// Shifted theta functions against their plain series with complex arguments, in either form.
#include "poinsot/engine/math/elliptic/elliptic_theta.h"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "poinsot/engine/math/elliptic/elliptic_integrals.h"

namespace poinsot {
namespace elliptic_theta_test {

using Real = long double;
using Complex = std::complex<Real>;
constexpr Real pi = std::numbers::pi_v<Real>;

// The series of DLMF 20.2 in the nome q, whatever its size below one.
Complex plain(Theta theta, const Complex& z, Real q) {
  Complex sum = 0;
  for (int n = 0; n < 60; ++n) {
    const Real sign = n % 2 == 0 ? 1 : -1, odd = static_cast<Real>(2 * n + 1);
    switch (theta) {
      case Theta::first:
        sum += 2 * sign * std::pow(q, (n + Real(0.5)) * (n + Real(0.5))) * std::sin(odd * z);
        break;
      case Theta::second:
        sum += 2 * std::pow(q, (n + Real(0.5)) * (n + Real(0.5))) * std::cos(odd * z);
        break;
      case Theta::fourth:
        sum += (n == 0 ? 1 : 2) * sign * std::pow(q, static_cast<Real>(n * n)) * std::cos(static_cast<Real>(2 * n) * z);
        break;
    }
  }
  return sum;
}

struct Case {
  Real m, shift;  // shift as a part of K'
  int sigma;
};

class ThetaForms : public ::testing::TestWithParam<Case> {};

// Ratios of values of one function, and of two functions at one point, do not depend on what is left out of all; with
// the left-out phase put back they are those of the plain series.
TEST_P(ThetaForms, agree_with_the_plain_series) {
  const auto [m, part, sigma] = GetParam();
  const auto p = EllipticParameter<Real>::of_m(m);
  const Real K = elliptic_complete_first(p), K1 = elliptic_complete_first(p.complementary());
  const ThetaLattice lattice{K, K1};
  const Real y = part * K1, nu = pi * y / (2 * K), q = std::exp(-pi * K1 / K);
  const ThetaArgument<Real> argument(lattice);
  for (const Theta theta : {Theta::first, Theta::second, Theta::fourth}) {
    const ThetaSeries series(theta, lattice, y, sigma);
    const ThetaSeries scale(Theta::fourth, lattice, 0, 0);
    const auto value = [&](Real u) {
      const auto at = [&](const ThetaSeries& s) {
        return argument.apply(u, [&](const auto& point) {
          const auto v = s.function().at(point);
          return Complex(v.re, v.im);
        });
      };
      const Complex left_out = std::polar(Real(1), series.turn_per_cell() * u / (2 * K));
      return at(series) / at(scale).real() * left_out;
    };
    const auto expected = [&](Real u) {
      const Real z = pi * u / (2 * K);
      return plain(theta, Complex(z, -sigma * nu), q) / plain(Theta::fourth, z, q).real();
    };
    const Complex factor = expected(K / 3) / value(K / 3);
    for (const Real u : {-K, -0.7L * K, -0.1L * K, 0.0L, 0.2L * K, 0.9L * K, K}) {
      const Complex difference = value(u) * factor - expected(u);
      EXPECT_LT(std::abs(difference), 1e-16L * (std::abs(expected(K / 3)) + std::abs(expected(u))))
          << "theta " << static_cast<int>(theta) << " at u/K = " << u / K;

      // The slope by central differences, up to a real multiple of the value that all functions share.
      const Real h = 1e-5L;
      const auto slopes = [&](const ThetaSeries& s) {
        return argument.apply(u, [&](const auto& point) { return s.function().with_slope(point); });
      };
      const auto own = slopes(series), common = slopes(scale);
      const Complex v(own.value.re, own.value.im);
      const Complex ratio_slope = argument.rate() * (Complex(own.slope.re, own.slope.im) / common.value.re -
                                                     v * common.slope.re / (common.value.re * common.value.re));
      const auto bare = [&](Real at) {
        return value(at) * std::polar(Real(1), -series.turn_per_cell() * at / (2 * K));
      };
      const Complex numerical = (bare(u + h) - bare(u - h)) / (2 * h);
      if (std::fabs(u) < K && u != 0) {
        EXPECT_LT(std::abs(ratio_slope - numerical), 1e-8L * (1 + std::abs(numerical)));
      }
    }
    // The same function as four terms of doubles.
    const ShiftedTheta<double, 4> narrow(series.function());
    const ThetaArgument<double> narrow_argument(lattice);
    for (const double part_of_K : {-0.9, 0.0, 0.6}) {
      const double u = part_of_K * static_cast<double>(K);
      const auto wide = argument.apply(u, [&](const auto& point) { return series.function().at(point); });
      const auto rounded = narrow_argument.apply(u, [&](const auto& point) { return narrow.at(point); });
      const double size = static_cast<double>(std::hypot(wide.re, wide.im));
      EXPECT_NEAR(rounded.re, static_cast<double>(wide.re), 1e-15 * size);
      EXPECT_NEAR(rounded.im, static_cast<double>(wide.im), 1e-15 * size);
    }
  }
}

TEST_P(ThetaForms, slopes_of_the_phase_are_those_of_the_values) {
  const auto [m, part, sigma] = GetParam();
  const auto p = EllipticParameter<Real>::of_m(m);
  const ThetaLattice lattice{elliptic_complete_first(p), elliptic_complete_first(p.complementary())};
  const Real K = lattice.real_half_period;
  const ThetaArgument<Real> argument(lattice);
  for (const Theta theta : {Theta::first, Theta::second, Theta::fourth}) {
    const ThetaSeries series(theta, lattice, part * lattice.imaginary_half_period, sigma);
    const auto at = [&](Real u) {
      const auto v = argument.apply(u, [&](const auto& point) { return series.function().at(point); });
      return Complex(v.re, v.im);
    };
    const Real h = 1e-6L;
    if (theta != Theta::first || sigma != 0) {
      const Real slope = std::arg(at(h) / at(-h)) / (2 * h);
      EXPECT_NEAR(static_cast<double>(series.slope_at_zero()), static_cast<double>(slope), 1e-8);
    }
    if (theta != Theta::second || sigma != 0) {
      const Real slope = std::arg(at(K) / at(K - h)) / h;
      EXPECT_NEAR(static_cast<double>(series.slope_at_end()), static_cast<double>(slope), 1e-4);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Lattices, ThetaForms,
                         ::testing::Values(Case{0.05L, 0.4L, 1}, Case{0.3L, 0.7L, -1}, Case{0.4999L, 0.95L, 1},
                                           Case{0.5001L, 0.5L, -1}, Case{0.8L, 0.2L, 1}, Case{0.99L, 0.9L, -1},
                                           Case{0.3L, 0.0L, 0}, Case{0.8L, 0.0L, 0}));

TEST(ThetaSeries, without_nome_are_elementary) {
  // m = 0: cos z cosh nu and the like; m = 1: sech and tanh of u.
  const ThetaLattice circle{pi / 2, std::numeric_limits<Real>::infinity()};
  const ThetaSeries second(Theta::second, circle, 0.3L, 1);
  const ThetaArgument<Real> argument(circle);
  const auto value = argument.apply(0.4L, [&](const auto& point) { return second.function().at(point); });
  EXPECT_NEAR(static_cast<double>(value.im / value.re), std::tan(0.4) * std::tanh(0.3), 1e-16);

  const ThetaLattice line{std::numeric_limits<Real>::infinity(), pi / 2};
  const ThetaSeries first(Theta::first, line, 0, 0), fourth(Theta::fourth, line, 0, 0);
  const ThetaArgument<Real> along(line);
  const auto ratio = [&](Real u) {
    const auto a = along.apply(u, [&](const auto& point) { return first.function().at(point); });
    const auto b = along.apply(u, [&](const auto& point) { return fourth.function().at(point); });
    return static_cast<double>(a.im / b.re);
  };
  EXPECT_NEAR(ratio(0.8L), std::tanh(0.8), 1e-16);
  EXPECT_NEAR(ratio(-1000), -1, 1e-16);
}

}  // namespace elliptic_theta_test
}  // namespace poinsot
