// Where stability ends, from the motion on both sides of the end.
//
// Stability ends where two rates on the imaginary axis meet and leave it: i w and -i w at zero, or i w_1 and i w_2
// anywhere. Close to that end each of them is known badly, as nearly equal eigenvalues disturb each other, and neither
// is a smooth function of what the motion depends on. The square of their difference is: it is the discriminant of the
// quadratic whose roots they are, and its coefficients are analytic (T. Kato, Perturbation Theory for Linear
// Operators, chapter II, section 1). On the stable side it is -(2 w)^2 or -(w_2 - w_1)^2, on the other one (2 s)^2 with
// the rate of growth s. A polynomial through values at some distance from the end, where they are known well, thus
// gives the end itself.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace poinsot::problem {

// The motion near a steady one: the fastest growth, and the frequencies in ascending order.
struct NearMotion {
  double growth = 0;
  std::vector<double> frequencies;
};

struct StabilityEnd {
  double value = 0;      // of the datum, to about 1e-12 of itself
  double steady_at = 0;  // the nearest value tried on the stable side
};

// Between a value of the datum at which the motion is stable and one at which it grows; nothing if the motions near the
// end are not such that two rates meet there. near: nothing where there is no such motion.
std::optional<StabilityEnd> stability_end(const std::function<std::optional<NearMotion>(double)>& near, double stable,
                                          double growing);

}  // namespace poinsot::problem
