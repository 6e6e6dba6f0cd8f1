// Elliptic integrals: Carlson's symmetric forms, and Legendre's as combinations of them.
//
// Carlson's forms by duplication (B. C. Carlson, Numerical Algorithms 10, 13, 1995; series of DLMF 19.36). They lose no
// digits for arguments of one sign, whatever their ratios. Legendre's forms take the parameter m = k^2 together with
// its complement 1 - m, so that neither end of the range of m loses digits.
//
// Real: double or long double. Errors are a few units in the last place. Arguments out of range give what is not a
// number.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace poinsot {

// The parameter of an elliptic integral or function, m + complement = 1, each to its own last place.
template <class Real>
struct EllipticParameter {
  Real m{0};
  Real complement{1};

  static constexpr EllipticParameter of_m(Real m) { return {m, Real(1) - m}; }
  static constexpr EllipticParameter of_complement(Real m1) { return {Real(1) - m1, m1}; }
  // That of the integrals along the imaginary axis.
  constexpr EllipticParameter complementary() const { return {complement, m}; }
};

// R_F(x, y, z) = 1/2 int_0^inf dt / sqrt((t + x)(t + y)(t + z)), x, y, z >= 0 and at most one of them zero (two give
// infinity).
template <class Real>
Real carlson_rf(Real x, Real y, Real z) {
  if (!(std::min({x, y, z}) >= 0)) return std::numeric_limits<Real>::quiet_NaN();
  if (x + y == 0 || y + z == 0 || z + x == 0) return std::numeric_limits<Real>::infinity();
  const Real start = (x + y + z) / 3;
  const Real dx = start - x, dy = start - y;
  const Real spread = std::max({std::fabs(dx), std::fabs(dy), std::fabs(start - z)});
  // The series below is cut at the eighth order of the relative differences.
  const Real tolerance = std::pow(std::numeric_limits<Real>::epsilon(), Real(1) / 8) / Real(1.5);
  Real mean = start, shrink = 1;
  while (shrink * spread > tolerance * mean) {
    const Real a = std::sqrt(x), b = std::sqrt(y), c = std::sqrt(z);
    const Real lambda = a * b + b * c + c * a;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    mean = (mean + lambda) / 4;
    shrink /= 4;
  }
  const Real X = dx * shrink / mean, Y = dy * shrink / mean, Z = -(X + Y);
  const Real E2 = X * Y - Z * Z, E3 = X * Y * Z;
  const Real series = 1 - E2 / 10 + E3 / 14 + E2 * E2 / 24 - 3 * E2 * E3 / 44 - 5 * E2 * E2 * E2 / 208 +
                      3 * E3 * E3 / 104 + E2 * E2 * E3 / 16;
  return series / std::sqrt(mean);
}

// R_C(x, y) = R_F(x, y, y), x >= 0; for y < 0 Cauchy's principal value.
template <class Real>
Real carlson_rc(Real x, Real y) {
  if (!(x >= 0) || std::isnan(y)) return std::numeric_limits<Real>::quiet_NaN();
  if (y == 0) return std::numeric_limits<Real>::infinity();
  if (y < 0) return std::sqrt(x / (x - y)) * carlson_rc(x - y, -y);
  const Real start = (x + 2 * y) / 3;
  const Real difference = y - x;
  const Real tolerance = std::pow(std::numeric_limits<Real>::epsilon(), Real(1) / 8) / 2;
  Real mean = start, shrink = 1;
  while (shrink * std::fabs(difference) > tolerance * mean) {
    const Real lambda = 2 * std::sqrt(x) * std::sqrt(y) + y;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    mean = (mean + lambda) / 4;
    shrink /= 4;
  }
  const Real s = difference * shrink / (3 * mean);
  const Real series =
      1 + s * s *
              (Real(3) / 10 +
               s * (Real(1) / 7 + s * (Real(3) / 8 + s * (Real(9) / 22 + s * (Real(159) / 208 + s * Real(9) / 8)))));
  return series / std::sqrt(mean);
}

namespace detail {

// The series of R_J and R_D about equal arguments, of the elementary symmetric functions E2 to E5 (DLMF 19.36.2).
template <class Real>
Real carlson_rj_series(Real E2, Real E3, Real E4, Real E5) {
  return 1 - 3 * E2 / 14 + E3 / 6 + 9 * E2 * E2 / 88 - 3 * E4 / 22 - 9 * E2 * E3 / 52 + 3 * E5 / 26 -
         E2 * E2 * E2 / 16 + 3 * E3 * E3 / 40 + 3 * E2 * E4 / 20 + 45 * E2 * E2 * E3 / 272 -
         9 * (E3 * E4 + E2 * E5) / 68;
}

}  // namespace detail

// R_D(x, y, z) = R_J(x, y, z, z), x, y >= 0 not both zero, z > 0.
template <class Real>
Real carlson_rd(Real x, Real y, Real z) {
  if (!(std::min(x, y) >= 0) || !(z >= 0)) return std::numeric_limits<Real>::quiet_NaN();
  if (x + y == 0 || z == 0) return std::numeric_limits<Real>::infinity();
  const Real start = (x + y + 3 * z) / 5;
  const Real dx = start - x, dy = start - y;
  const Real spread = std::max({std::fabs(dx), std::fabs(dy), std::fabs(start - z)});
  const Real tolerance = std::pow(std::numeric_limits<Real>::epsilon() / 4, Real(1) / 8) / Real(1.5);
  Real mean = start, shrink = 1, sum = 0;
  while (shrink * spread > tolerance * mean) {
    const Real a = std::sqrt(x), b = std::sqrt(y), c = std::sqrt(z);
    const Real lambda = a * b + b * c + c * a;
    sum += shrink / (c * (z + lambda));
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    mean = (mean + lambda) / 4;
    shrink /= 4;
  }
  const Real X = dx * shrink / mean, Y = dy * shrink / mean, Z = -(X + Y) / 3;
  const Real XY = X * Y, ZZ = Z * Z;
  const Real E2 = XY - 6 * ZZ, E3 = (3 * XY - 8 * ZZ) * Z, E4 = 3 * (XY - ZZ) * ZZ, E5 = XY * ZZ * Z;
  return shrink / (mean * std::sqrt(mean)) * detail::carlson_rj_series(E2, E3, E4, E5) + 3 * sum;
}

// R_J(x, y, z, p) = 3/2 int_0^inf dt / ((t + p) sqrt((t + x)(t + y)(t + z))), x, y, z >= 0 and at most one of them
// zero; for p < 0 Cauchy's principal value (DLMF 19.20.14).
template <class Real>
Real carlson_rj(Real x, Real y, Real z, Real p) {
  if (!(std::min({x, y, z}) >= 0) || std::isnan(p)) return std::numeric_limits<Real>::quiet_NaN();
  if (p == 0 || x + y == 0 || y + z == 0 || z + x == 0) return std::numeric_limits<Real>::infinity();
  if (p < 0) {
    std::array<Real, 3> order{x, y, z};
    std::sort(order.begin(), order.end());
    const auto [a, b, c] = order;
    const Real q = -p;
    const Real r = b + (c - b) * (b - a) / (b + q);
    return ((r - b) * carlson_rj(a, b, c, r) - 3 * carlson_rf(a, b, c) +
            3 * std::sqrt(a * b * c / (a * c + r * q)) * carlson_rc(a * c + r * q, r * q)) /
           (b + q);
  }
  const Real start = (x + y + z + 2 * p) / 5;
  const Real dx = start - x, dy = start - y, dz = start - z;
  const Real spread = std::max({std::fabs(dx), std::fabs(dy), std::fabs(dz), std::fabs(start - p)});
  const Real tolerance = std::pow(std::numeric_limits<Real>::epsilon() / 4, Real(1) / 8) / Real(1.5);
  Real mean = start, shrink = 1, sum = 0;
  while (shrink * spread > tolerance * mean) {
    const Real a = std::sqrt(x), b = std::sqrt(y), c = std::sqrt(z), d = std::sqrt(p);
    const Real lambda = a * b + b * c + c * a;
    const Real D = (d + a) * (d + b) * (d + c);
    // 1 + (p - x)(p - y)(p - z)/D^2, as a sum of positive terms.
    sum += shrink / D * carlson_rc(Real(1), 2 * d * (p + lambda) / D);
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    p = (p + lambda) / 4;
    mean = (mean + lambda) / 4;
    shrink /= 4;
  }
  const Real X = dx * shrink / mean, Y = dy * shrink / mean, Z = dz * shrink / mean, P = -(X + Y + Z) / 2;
  const Real XYZ = X * Y * Z;
  const Real E2 = X * Y + Y * Z + Z * X - 3 * P * P, E3 = XYZ + 2 * E2 * P + 4 * P * P * P;
  const Real E4 = (2 * XYZ + E2 * P + 3 * P * P * P) * P, E5 = XYZ * P * P;
  return shrink / (mean * std::sqrt(mean)) * detail::carlson_rj_series(E2, E3, E4, E5) + 6 * sum;
}

// Complete integrals, to the amplitude pi/2. K(m): infinite at m = 1. By the arithmetic-geometric mean.
template <class Real>
Real elliptic_complete_first(const EllipticParameter<Real>& p) {
  if (!(p.complement >= 0)) return std::numeric_limits<Real>::quiet_NaN();
  if (p.complement == 0) return std::numeric_limits<Real>::infinity();
  Real a = 1, g = std::sqrt(p.complement);
  while (std::fabs(a - g) > std::sqrt(std::numeric_limits<Real>::epsilon()) * a) {
    const Real mean = (a + g) / 2;
    g = std::sqrt(a * g);
    a = mean;
  }
  return std::numbers::pi_v<Real> / (a + g);  // the next mean is (a + g)/2 to the last place
}
// E(m)
template <class Real>
Real elliptic_complete_second(const EllipticParameter<Real>& p) {
  if (p.complement == 0) return Real(1);
  return p.complement * (carlson_rd(Real(0), p.complement, Real(1)) + carlson_rd(Real(0), Real(1), p.complement)) / 3;
}
// Pi(n; m) = int_0^(pi/2) dphi / ((1 - n sin^2 phi) sqrt(1 - m sin^2 phi)); for n > 1 Cauchy's principal value.
template <class Real>
Real elliptic_complete_third(Real n, const EllipticParameter<Real>& p) {
  return carlson_rf(Real(0), p.complement, Real(1)) + n * carlson_rj(Real(0), p.complement, Real(1), 1 - n) / 3;
}

namespace detail {

// phi = turns pi + rest, |rest| <= pi/2, with the sine and cosine of the rest.
template <class Real>
struct HalfTurns {
  Real turns, sine, cosine;
};
template <class Real>
HalfTurns<Real> half_turns(Real phi) {
  const Real sine = std::sin(phi), cosine = std::cos(phi);
  const Real turns = std::nearbyint(phi / std::numbers::pi_v<Real>);
  const bool odd = std::fmod(turns, Real(2)) != 0;
  return {turns, odd ? -sine : sine, std::fabs(cosine)};
}

}  // namespace detail

// Incomplete integrals, to the amplitude phi (rad, any). F(phi; m) = int_0^phi dphi / sqrt(1 - m sin^2 phi).
template <class Real>
Real elliptic_first(Real phi, const EllipticParameter<Real>& p) {
  const auto [turns, s, c] = detail::half_turns(phi);
  const Real part = s * carlson_rf(c * c, c * c + p.complement * s * s, Real(1));
  return turns == 0 ? part : part + 2 * turns * elliptic_complete_first(p);
}
// E(phi; m) = int_0^phi sqrt(1 - m sin^2 phi) dphi, as the sum of positive terms of DLMF 19.25.10.
template <class Real>
Real elliptic_second(Real phi, const EllipticParameter<Real>& p) {
  const auto [turns, s, c] = detail::half_turns(phi);
  const Real cc = c * c, ss = s * s, dd = cc + p.complement * ss;
  const Real part = p.complement * s * carlson_rf(cc, dd, Real(1)) +
                    p.m * p.complement * s * ss * carlson_rd(cc, Real(1), dd) / 3 + p.m * s * c / std::sqrt(dd);
  if (s == 0) return 2 * turns * elliptic_complete_second(p);
  return turns == 0 ? part : part + 2 * turns * elliptic_complete_second(p);
}
// Pi(n; phi; m) = int_0^phi dphi / ((1 - n sin^2 phi) sqrt(1 - m sin^2 phi)); where n sin^2 phi > 1 Cauchy's principal
// value.
template <class Real>
Real elliptic_third(Real n, Real phi, const EllipticParameter<Real>& p) {
  const auto [turns, s, c] = detail::half_turns(phi);
  const Real cc = c * c, ss = s * s, dd = cc + p.complement * ss;
  const Real part = s * carlson_rf(cc, dd, Real(1)) + n * s * ss * carlson_rj(cc, dd, Real(1), cc + (1 - n) * ss) / 3;
  return turns == 0 ? part : part + 2 * turns * elliptic_complete_third(n, p);
}

}  // namespace poinsot
