#include "engine/motion/closed_form/top_cubic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace poinsot {
namespace {

using Real = long double;

// The root in 0 < t <= end of c0 + c1 t + c2 t^2 + c3 t^3, positive just above t = 0 and changing its sign once; `end`
// if it does not change it, as by rounding. Newton's iteration, bisecting where that leaves the bracket or is slow.
Real root_after_zero(Real c0, Real c1, Real c2, Real c3, Real end) {
  const auto f = [&](Real t) { return c0 + t * (c1 + t * (c2 + t * c3)); };
  if (!(f(end) < 0)) return end;
  Real low = 0, high = end;
  Real t = c1 < 0 && -c0 > c1 * end ? -c0 / c1 : end / 2;
  if (!(t > 0)) t = end / 2;
  Real last_step = end;
  for (int i = 0; i < 20000; ++i) {
    const Real value = f(t);
    if (value == 0) return t;
    (value > 0 ? low : high) = t;
    const Real next = t - value / (c1 + t * (2 * c2 + t * 3 * c3));
    const Real before = t;
    t = next > low && next < high && 2 * std::fabs(next - t) < last_step ? next : (low + high) / 2;
    last_step = std::fabs(t - before);
    if (last_step <= std::numeric_limits<Real>::epsilon() * t || t == low || t == high) break;
  }
  return t;
}

}  // namespace

TopCubic solve_top_cubic(const TopCubicData& data) {
  TopCubic r;
  // The number nearest to pi means pi.
  const bool hanging = data.nutation == std::numbers::pi_v<Real>;
  const Real half_sine = std::sin(data.nutation / 2), half_cosine = hanging ? 0 : std::cos(data.nutation / 2);
  const Real h0 = r.above0 = 2 * half_sine * half_sine;
  const Real k0 = r.below0 = 2 * half_cosine * half_cosine;
  const Real x0 = hanging ? -1 : std::cos(data.nutation), sine_square = h0 * k0;
  const Real kappa = data.kappa, b = data.b, precession = data.precession_rate;
  const Real rate_square = data.nutation_rate * data.nutation_rate;
  const Real speed_square = rate_square + sine_square * precession * precession;  // epsilon - kappa x0
  r.sum = k0 * (h0 * precession + b);
  r.difference = h0 * (k0 * precession - b);

  // About the start, y = x - x0: P = p0 + p1 y + p2 y^2 + kappa y^3. p1 is the moment missing to steady precession.
  const Real p0 = sine_square * rate_square;
  const Real p1 = sine_square * (2 * precession * (b - x0 * precession) - kappa) - 2 * x0 * rate_square;
  const Real p2 = 2 * kappa * x0 - speed_square - b * b;
  r.stiffness = -p2;
  if (p0 == 0 && p1 == 0) {
    r.steady = true;
    return r;
  }
  const auto P = [&](Real y) { return p0 + y * (p1 + y * (p2 + y * kappa)); };

  // About the upright position, h = 1 - x: -P = d^2 - h1 h - h2 h^2 + kappa h^3. x2 is looked for from there if it is
  // nearer to it than to the start, as P in the middle tells.
  const Real d = r.difference;
  const Real e1 = speed_square - kappa * h0;  // epsilon - kappa
  const Real h1 = 2 * (e1 - d * b), h2 = 2 * kappa - e1 - b * b;
  if (P(h0 / 2) < 0) {
    r.to2 = p0 > 0   ? root_after_zero(p0, p1, p2, kappa, h0 / 2)
            : p1 > 0 ? root_after_zero(p1, p2, kappa, 0, h0 / 2)
                     : 0;
    r.above2 = h0 - r.to2;
  } else {
    r.above2 = d != 0   ? root_after_zero(d * d, -h1, -h2, kappa, h0 / 2)
               : h1 < 0 ? root_after_zero(-h1, -h2, kappa, 0, h0 / 2)
                        : 0;
    r.to2 = h0 - r.above2;
  }
  // About the hanging position, k = 1 + x: -P = s^2 - k1 k - k2 k^2 - kappa k^3; and x1.
  const Real s = r.sum;
  const Real e2 = speed_square + kappa * k0;  // epsilon + kappa
  if (P(-k0 / 2) < 0) {
    r.to1 = p0 > 0   ? root_after_zero(p0, -p1, p2, -kappa, k0 / 2)
            : p1 < 0 ? root_after_zero(-p1, p2, -kappa, 0, k0 / 2)
                     : 0;
    r.below1 = k0 - r.to1;
  } else {
    r.below1 = s != 0 ? root_after_zero(s * s, -2 * (e2 + s * b), e2 + 2 * kappa + b * b, -kappa, k0 / 2) : 0;
    r.to1 = k0 - r.below1;
  }
  r.above1 = h0 + r.to1;
  r.below2 = k0 + r.to2;
  r.spread = r.to1 + r.to2;

  // The third root, G = kappa (x3 - 1) >= 0: G^3 + h2 G^2 - h1 kappa G - d^2 kappa^2 = 0.
  const Real c1 = h1 * kappa, c0 = d * d * kappa * kappa;
  const Real bound = 4 * std::max({std::fabs(h2), std::sqrt(std::fabs(c1)), std::cbrt(c0)});
  if (c0 > 0) {
    r.third = root_after_zero(c0, c1, -h2, -1, bound);
  } else if (c1 > 0) {
    r.third = root_after_zero(c1, -h2, -1, 0, bound);
  } else {
    r.third = c1 == 0 ? std::max(Real(0), -h2) : 0;
  }
  return r;
}

}  // namespace poinsot
