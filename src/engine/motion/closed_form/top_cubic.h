// The cubic of the heavy symmetric top (symmetric_top.h): its roots and their distances, each to its own last places.
#pragma once

namespace poinsot {

// What fixes the cubic, at one instant: cos theta = x0, kappa >= 0.
struct TopCubicData {
  long double nutation = 0;         // theta, rad
  long double nutation_rate = 0;    // rad/s
  long double precession_rate = 0;  // rad/s
  long double b = 0;                // H_z/I', rad/s
  long double kappa = 0;            // 2 m g c/I', 1/s^2
};

// With P(x) = (epsilon - kappa x)(1 - x^2) - (a - b x)^2 = kappa (x - x1)(x2 - x)(x3 - x).
struct TopCubic {
  bool steady = false;  // x1 = x2 = x0 exactly, or at rest in the upright position: what follows is void but
                        // for the distances of x0, momenta and the stiffness
  long double above0 = 0, below0 = 0;   // 1 - x0, 1 + x0
  long double sum = 0, difference = 0;  // a + b, a - b
  long double stiffness = 0;            // of vanishing nutations in steady precession: their frequency squared
  long double to1 = 0, to2 = 0;         // x0 - x1, x2 - x0
  long double above1 = 0, above2 = 0;   // 1 - x1, 1 - x2
  long double below1 = 0, below2 = 0;   // 1 + x1, 1 + x2
  long double spread = 0;               // x2 - x1
  long double third = 0;                // kappa (x3 - 1), finite also without weight
};

TopCubic solve_top_cubic(const TopCubicData& data);

}  // namespace poinsot
