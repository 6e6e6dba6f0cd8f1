#include "poinsot/engine/motion/closed_form/steady_precession.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace poinsot {
namespace {

using Real = long double;

// Cosine of a double that stands for an angle: zero at the double nearest to pi/2.
Real cosine(double angle) { return angle == std::numbers::pi / 2 ? 0 : std::cos(static_cast<Real>(angle)); }

// Real roots of a p^2 - b p + c = 0, ascending, without cancellation.
std::vector<double> roots(Real a, Real b, Real c) {
  if (a == 0) return b == 0 ? std::vector<double>{} : std::vector<double>{static_cast<double>(c / b)};
  const Real discriminant = b * b - 4 * a * c;
  // A double root is found as one although the data are rounded to doubles.
  const Real rounding = 4 * std::numeric_limits<double>::epsilon() * b * b;
  if (discriminant < -rounding) return {};
  if (discriminant <= rounding) return {static_cast<double>(b / (2 * a))};
  const Real q = (b + std::copysign(std::sqrt(discriminant), b)) / 2;
  const double first = static_cast<double>(q / a), second = static_cast<double>(c / q);
  return first < second ? std::vector<double>{first, second} : std::vector<double>{second, first};
}

}  // namespace

std::vector<double> steady_precession_rates(const TopParameters& parameters, double nutation, double axial_rate) {
  return roots(parameters.transverse_moment * cosine(nutation), static_cast<Real>(parameters.axial_moment) * axial_rate,
               parameters.gravity_moment);
}

std::vector<double> steady_precession_rates_of_spin(const TopParameters& parameters, double nutation,
                                                    double spin_rate) {
  const Real difference = static_cast<Real>(parameters.transverse_moment) - parameters.axial_moment;
  return roots(difference * cosine(nutation), static_cast<Real>(parameters.axial_moment) * spin_rate,
               parameters.gravity_moment);
}

double least_sleeping_rate(const TopParameters& parameters) {
  if (!(parameters.gravity_moment > 0)) return 0;
  return 2 * std::sqrt(parameters.transverse_moment * parameters.gravity_moment) / parameters.axial_moment;
}

}  // namespace poinsot
