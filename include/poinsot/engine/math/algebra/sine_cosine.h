// Sine and cosine of one argument together.
//
// double and the packs (pack.h) share one branch-free kernel: reduction by multiples of pi/2 with the constants of
// FreeBSD's msun (e_rem_pio2.c, second iteration: 85 bits of pi/2, exact products below 2^20 quadrants), then its
// kernels k_sin.c and k_cos.c, whose error is below one unit in the last place.
#pragma once

#include <cmath>

namespace poinsot {

template <class Scalar>
struct SineCosine {
  Scalar sine;
  Scalar cosine;
};

// Arguments beyond this many radians go to the standard library.
inline constexpr double sine_cosine_kernel_range = 1.0e6;

// The kernel for |x| <= sine_cosine_kernel_range. Real: double or a vector of doubles. select(mask, a, b) takes a where
// the mask holds.
template <class Real, class Select>
constexpr SineCosine<Real> sine_cosine_kernel(const Real& x, Select select) {
  // Nearest multiple of pi/2; adding and taking away 1.5 * 2^52 rounds to an integer.
  const Real round_to_integer(0x1.8p52);
  const Real quadrants = (x * Real(6.36619772367581382433e-01) + round_to_integer) - round_to_integer;
  const Real t = x - quadrants * Real(1.57079632673412561417e+00);
  const Real w2 = quadrants * Real(6.07710050630396597660e-11);
  const Real r = t - w2;
  const Real w = quadrants * Real(2.02226624879595063154e-21) - ((t - r) - w2);
  const Real y = r - w;           // head of the reduced argument, |y| <= pi/4
  const Real tail = (r - y) - w;  // and what rounding took from it

  const Real z = y * y;
  const Real s = Real(8.33333333332248946124e-03) +
                 z * (Real(-1.98412698298579493134e-04) +
                      z * (Real(2.75573137070700676789e-06) +
                           z * (Real(-2.50507602534068634195e-08) + z * Real(1.58969099521155010221e-10))));
  const Real v = z * y;
  const Real sine = y - ((z * (Real(0.5) * tail - v * s) - tail) - v * Real(-1.66666666666666324348e-01));
  const Real c = z * (Real(4.16666666666666019037e-02) +
                      z * (Real(-1.38888888888741095749e-03) +
                           z * (Real(2.48015872894767294178e-05) +
                                z * (Real(-2.75573143513906633035e-07) +
                                     z * (Real(2.08757232129817482790e-09) + z * Real(-1.13596475577881948265e-11))))));
  const Real half_z = Real(0.5) * z;
  const Real head = Real(1.0) - half_z;
  const Real cosine = head + (((Real(1.0) - head) - half_z) + (z * c - y * tail));

  // quadrant = quadrants mod 4: 0 1 2 3.
  const Real quarter = Real(0.25) * quadrants - Real(0.375);
  const Real quadrant = quadrants - Real(4.0) * ((quarter + round_to_integer) - round_to_integer);
  const auto odd = (quadrant == Real(1.0)) || (quadrant == Real(3.0));
  const auto sine_negative = quadrant > Real(1.5);
  const auto cosine_negative = (quadrant == Real(1.0)) || (quadrant == Real(2.0));
  const Real sine_size = select(odd, cosine, sine);
  const Real cosine_size = select(odd, sine, cosine);
  return {select(sine_negative, -sine_size, sine_size), select(cosine_negative, -cosine_size, cosine_size)};
}

inline SineCosine<double> sine_cosine(double x) {
  if (!(std::fabs(x) <= sine_cosine_kernel_range)) return {std::sin(x), std::cos(x)};
  return sine_cosine_kernel(x, [](bool mask, double a, double b) { return mask ? a : b; });
}
inline SineCosine<float> sine_cosine(float x) { return {std::sin(x), std::cos(x)}; }
inline SineCosine<long double> sine_cosine(long double x) { return {std::sin(x), std::cos(x)}; }

// Sine and cosine of count numbers, written to sines and cosines. One loop without branches, which compilers turn into
// vector instructions. The three lists must not overlap.
inline void sine_cosine_list(const double* x, int count, double* __restrict sines, double* __restrict cosines) {
  double largest = 0.0;
  for (int i = 0; i < count; ++i) {
    const double size = std::fabs(x[i]);
    largest = size <= largest ? largest : size;  // what is not a number stays last and fails the test below
  }
  if (!(largest <= sine_cosine_kernel_range)) {
    for (int i = 0; i < count; ++i) {
      const auto [s, c] = sine_cosine(x[i]);
      sines[i] = s;
      cosines[i] = c;
    }
    return;
  }
  for (int i = 0; i < count; ++i) {
    const auto [s, c] = sine_cosine_kernel(x[i], [](bool mask, double a, double b) { return mask ? a : b; });
    sines[i] = s;
    cosines[i] = c;
  }
}

// sin(angle) and 1 - cos(angle), the latter formed as 2 sin^2(angle/2), so that small angles keep their digits. Exact
// scalars bring their own.
template <class Scalar>
struct SineVersine {
  Scalar sine;
  Scalar versine;
};
template <class Scalar>
SineVersine<Scalar> sine_versine(const Scalar& angle) {
  const auto [half_sine, half_cosine] = sine_cosine(Scalar(Scalar(0.5) * angle));
  return {Scalar(2) * half_sine * half_cosine, Scalar(2) * half_sine * half_sine};
}

}  // namespace poinsot
